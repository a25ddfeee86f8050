"""One host: its channel, its port on the board, and the buffers between them."""

from __future__ import annotations

from time import monotonic
from typing import TYPE_CHECKING

from motionlang.kernel import INFINITY, Wait

if TYPE_CHECKING:
    from motionlang.hosts.channel import HostChannel
    from motionlang.hosts.console import HostPort
    from motionlang.hosts.serve.limits import Limits
    from motionlang.hosts.serve.pace import ServerPace
    from motionlang.hosts.serve.spy import Spy


class Host:
    """A connected host; `number` counts the hosts of a server from 1.

    No buffer grows without bound. The server stops reading from a host that sends faster than the board
    accepts. A host that does not read delays only its own line.
    """

    def __init__(
        self, number: int, channel: HostChannel, port: HostPort, limits: Limits, spy: Spy | None
    ) -> None:
        self.number, self.channel, self.port = number, channel, port
        self._limits, self._spy = limits, spy
        self._inbox = bytearray()
        self._outbox = bytearray()
        # When the host closed its sending side, in real time.
        self.ended: float | None = None
        # When the host last sent something.
        self.last_received = monotonic()
        # The wait that was last reported to the person who serves as one that nothing ends.
        self.reported: Wait | None = None
        # The events that the server's selector waits for.
        self.watched = 0

    # -------------------------------------------------------------------------------------------- for the server

    @property
    def listens(self) -> bool:
        """True if the buffers have room for more data from this host."""
        return self.ended is None and len(self._inbox) < self._limits.inbox

    @property
    def unsent(self) -> bool:
        """True if data is waiting to be sent through the channel."""
        return bool(self._outbox)

    @property
    def waits(self) -> bool:
        """True if data from the host is waiting to be passed to the board."""
        return bool(self._inbox)

    @property
    def is_silent(self) -> bool:
        """True if neither direction has data and the port on the board is not busy."""
        return not (self._inbox or self._outbox or self.port.busy)

    def can_continue(self, pace: ServerPace) -> bool:
        """True if the board would accept more of the host's data."""
        if not self._inbox:
            return False
        return self.port.accepts(self._inbox, pace.by_line)

    @property
    def done(self) -> bool:
        """True if a host has closed its sending side and received all its answers."""
        return self.ended is not None and self.is_silent

    def endless_wait(self) -> str:
        """Return the reason of a wait that no pending event will end.

        Returns an empty text if there is no such wait or it has been reported.
        """
        wait = self.port.waiting
        if wait is None or wait is self.reported or wait.ready() or wait.due() < INFINITY:
            return ""
        self.reported = wait
        return wait.why

    def receive(self, now: float) -> None:
        """Read data that the host has sent."""
        data = self.channel.receive(self._limits.chunk)
        if data is None:
            self.ended = now
            return
        self.last_received = now
        if self._spy is not None:
            self._spy.sent(self.number, data)
        self._inbox += data

    def feed(self, pace: ServerPace) -> None:
        """Pass the data that the board accepts: all of it, or one line in lock step."""
        piece, is_entry = self.port.next_piece(self._inbox, pace.by_line)
        if is_entry:
            pace.entered()
        del self._inbox[: self.port.feed(piece)]

    def forget(self) -> None:
        """Drop the data that the host has sent, and abandon its line."""
        self._inbox.clear()
        self.port.abandon()

    def flush(self) -> None:
        """Send the board's output as far as the channel accepts it."""
        if len(self._outbox) < self._limits.outbox:
            answer = self.port.take()
            if answer:
                self._outbox += answer
                if self._spy is not None:
                    self._spy.answered(self.number, answer)
        if self._outbox:
            del self._outbox[: self.channel.send(bytes(self._outbox[: self._limits.outbox]))]
