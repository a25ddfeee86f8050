"""One host: its channel, its port at the board, and what waits between the two."""

from __future__ import annotations

from time import monotonic
from typing import TYPE_CHECKING

from motionlang.mccl.hosts.port import CR, CTRL_B, ESC, LF

if TYPE_CHECKING:
    from motionlang.lang.task import Wait
    from motionlang.mccl.hosts.port import Port
    from motionlang.serve.channel import Channel
    from motionlang.serve.limits import Limits
    from motionlang.serve.pace import Pace
    from motionlang.serve.spy import Spy

INFINITY = float("inf")
# Characters that a port hears while it is carrying out a line, besides ESC: Ctrl-B, XON, XOFF and the blank.
AT_ONCE = (CTRL_B, 17, 19, 32)


class Host:
    """`number` counts the hosts of a server from 1.

    Nothing here grows without end: a host that sends faster than the board takes is read no further, and one that
    does not read holds up its own line.
    """

    def __init__(self, number: int, channel: Channel, port: Port, limits: Limits, spy: Spy | None) -> None:
        self.number, self.channel, self.port = number, channel, port
        self._limits, self._spy = limits, spy
        self._inbox = bytearray()
        self._outbox = bytearray()
        self._after_cr = False
        # When the host has said its last, on the wall clock.
        self.ended: float | None = None
        # When it was last heard.
        self.heard = monotonic()
        # The wait of which the person who serves was told that nothing ends it.
        self.told: Wait | None = None
        # What the server's selector looks for.
        self.watched = 0

    # -------------------------------------------------------------------------------------------- for the server

    @property
    def listens(self) -> bool:
        """Whether there is room for more from this host."""
        return self.ended is None and len(self._inbox) < self._limits.inbox

    @property
    def unsent(self) -> bool:
        """Whether something waits for the channel to take it."""
        return bool(self._outbox)

    @property
    def waits(self) -> bool:
        """Whether something that the host sent could be given to the board."""
        return bool(self._inbox)

    @property
    def is_silent(self) -> bool:
        """Whether nothing of this host is under way, in either direction or on the board."""
        return not (self._inbox or self._outbox or self.port.busy)

    def may_go_on(self, pace: Pace) -> bool:
        """Whether the board would take more of what the host has sent."""
        if not self._inbox:
            return False
        return not self.port.busy or ESC in self._inbox or (pace.by_line and bool(self._heard_at_once()))

    @property
    def done(self) -> bool:
        """Whether a host that has said its last has been answered."""
        return self.ended is not None and self.is_silent

    def waits_in_vain(self) -> str:
        """What its line waits for that nothing under way brings about, where that has not been told; else nothing."""
        wait = self.port.waiting
        if wait is None or wait is self.told or wait.ready() or wait.due() < INFINITY:
            return ""
        self.told = wait
        return wait.why

    def receive(self, now: float) -> None:
        """Read what the host has sent."""
        data = self.channel.receive(self._limits.chunk)
        if data is None:
            self.ended = now
            return
        self.heard = now
        if self._spy is not None:
            self._spy.sent(self.number, data)
        self._inbox += data

    def feed(self, pace: Pace) -> None:
        """Give the board what it takes: all of it, or in lock step a line.

        What has come before an ESC, and was not taken because the board is busy, is void.
        """
        if self.port.busy and ESC in self._inbox:
            del self._inbox[: self._inbox.rindex(ESC)]
        if pace.by_line and self.port.busy:
            piece = self._heard_at_once()
        elif pace.by_line:
            piece = self._line()
            if piece[-1] == CR or (piece[-1] == LF and not (self._after_cr and len(piece) == 1)):
                pace.entered()
            self._after_cr = piece[-1] == CR
        else:
            piece = bytes(self._inbox)
        del self._inbox[: self.port.feed(piece)]

    def forget(self) -> None:
        """Drop what the host has sent, as its own ESC would."""
        self._inbox.clear()
        self.port.feed(bytes([ESC]))

    def flush(self) -> None:
        """Send what the board has to say, as far as the channel takes it."""
        if len(self._outbox) < self._limits.outbox:
            said = self.port.take()
            if said:
                self._outbox += said
                if self._spy is not None:
                    self._spy.answered(self.number, said)
        if self._outbox:
            del self._outbox[: self.channel.send(bytes(self._outbox[: self._limits.outbox]))]

    # ---------------------------------------------------------------------------------------------------- inside

    def _line(self) -> bytes:
        """The first line that has come, or as much of it as there is."""
        for k, code in enumerate(self._inbox):
            if code in (CR, LF):
                return bytes(self._inbox[: k + 1])
        return bytes(self._inbox)

    def _heard_at_once(self) -> bytes:
        """What a port hears while it is busy: a key if it steps, otherwise control characters and the blank."""
        if self.port.task.stepping or self._inbox[0] == ESC:
            return bytes(self._inbox[:1])
        count = 0
        while count < len(self._inbox) and self._inbox[count] in AT_ONCE:
            count += 1
        return bytes(self._inbox[:count])
