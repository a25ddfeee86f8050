"""The server: one thread, one board and many hosts, in bounded iterations.

An iteration reads from every host that has sent data, lets the board work for a bounded time, and sends every host
its output. No input from a host stops the server. If the interpreter fails on a line, the answer is `?3` (MCCL) or
an error line (Mint), and the error is logged.
"""

from __future__ import annotations

import select
import selectors
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from traceback import walk_tb
from types import TracebackType
from typing import TYPE_CHECKING, Any, TypeAlias

from motionlang.hosts import address
from motionlang.hosts.channel import DeviceChannel, HostChannel, TcpChannel
from motionlang.hosts.errors import ConnectionLost
from motionlang.hosts.serve.host import Host
from motionlang.hosts.serve.limits import Limits
from motionlang.hosts.serve.pace import RealTime
from motionlang.hosts.serve.refusals import Refusals
from motionlang.kernel import INFINITY

if TYPE_CHECKING:
    from motionlang.hosts.console import HostConsole
    from motionlang.hosts.serve.pace import ServerPace
    from motionlang.hosts.serve.spy import Spy

# Makes a host of its number and its channel.
MakeHost: TypeAlias = Callable[[int, HostChannel], Host]

READ, WRITE = selectors.EVENT_READ, selectors.EVENT_WRITE
# Seconds of real time that hosts have at the end to read their output.
FAREWELL = 0.5
# The number of different internal errors that are reported.
MAX_KNOWN = 100


class Server:
    """Serves `console`; `complain` is called with lines for the person who started it.

    `listen` and `device` open lines for hosts. `run` serves until `stop`, which may be called from a signal handler or
    another thread; `in_thread` does both. `close` disconnects everything.
    """

    def __init__(
        self,
        console: HostConsole[Any],
        pace: ServerPace | None = None,
        *,
        limits: Limits | None = None,
        spy: Spy | None = None,
        complain: Callable[[str], None] = lambda text: None,
    ) -> None:
        self.console = console
        self.pace = pace or RealTime(console)
        self.hosts: list[Host] = []
        self.served = 0
        self.limits = limits or Limits()
        self.spy, self._complain = spy, complain
        self._refusals = Refusals(complain)
        self._listeners: dict[socket.socket, Callable[[], None]] = {}
        self._refusing = False
        # The index of the host that is answered first.
        self._first = 0
        self._known: set[str] = set()
        self._selector = selectors.DefaultSelector()
        # Called in every iteration after the hosts are read, for other servers of the same board.
        self.in_turn: list[Callable[[], None]] = []
        self._over = False
        self._wake, self._alarm = socket.socketpair()
        self._wake.setblocking(False)
        self._alarm.setblocking(False)
        self._selector.register(self._wake, READ, self._woken)

    def __enter__(self) -> Server:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()

    # ------------------------------------------------------------------------------------------- listening

    def listen(
        self, host: str, port: int, echo: bool | None = False, make: MakeHost | None = None
    ) -> tuple[str, int]:
        """Let hosts connect over TCP; return the address to connect to.

        `make` creates the host of a connection; without it, the host speaks ASCII MCCL. Raises OSError if the address
        cannot be used.
        """
        listener = address.listen(host, port)
        made = make or self._maker(echo)
        self._listeners[listener] = lambda: self._accept(listener, made)
        self._selector.register(listener, READ, self._listeners[listener])
        found: tuple[str, int] = listener.getsockname()[:2]
        return found

    def device(self, echo: bool | None = None) -> str:
        """Let a host open a serial device; return its path.

        Raises ImportError or OSError if there are no pseudo-terminals.
        """
        channel = DeviceChannel()
        self._join(channel, self._maker(echo))
        return channel.name

    # --------------------------------------------------------------------------------------------- serving

    def run(self) -> None:
        """Serve until `stop`."""
        while not self._over:
            self.turn(self._timeout())

    @contextmanager
    def in_thread(self) -> Iterator[None]:
        """Serve in a thread of its own while the block of `with` runs, as in a test bench."""
        thread = threading.Thread(target=self.run, daemon=True)
        thread.start()
        try:
            yield
        finally:
            self.stop()
            thread.join()

    def stop(self) -> None:
        """End `run` after its current iteration."""
        self._over = True
        self.wake()

    def wake(self) -> None:
        """Start an iteration now; may be called from any thread."""
        try:
            self._alarm.send(b".")
        except OSError:
            pass

    def turn(self, timeout: float | None = 0.0) -> None:
        """Run one iteration, after waiting at most `timeout` seconds for work."""
        for key, _ in self._selector.select(timeout):
            key.data()
        self._refusals.report()
        self._guard(self.pace.before)
        for host in self.hosts:
            if host.waits:
                self._feed(host)
        for call in self.in_turn:
            self._guard(call)
        self._guard(self.pace.work)
        # A host that is answered first asks again first, so another one is first each time.
        self._first = (self._first + 1) % max(1, len(self.hosts))
        for host in self.hosts[self._first :] + self.hosts[: self._first]:
            self._serve(host)
        self._report_waits()

    def close(self) -> None:
        """Disconnect every host, after a short time in which it can read its output."""
        self._refusals.flush()
        end = time.monotonic() + FAREWELL
        for host in list(self.hosts):
            self._send_rest(host, end)
            self._leave(host, "is disconnected: the server ends")
        for listener in self._listeners:
            listener.close()
        self._listeners.clear()
        self._selector.close()
        self._wake.close()
        self._alarm.close()

    # ----------------------------------------------------------------------------------------- connections

    def _accept(self, listener: socket.socket, make: MakeHost) -> None:
        try:
            connection, peer = listener.accept()
        except (BlockingIOError, ConnectionError):
            return
        except OSError as error:
            # Too many connections are open: listen again when one has been closed.
            self._refusals.add(f"no host can connect: {error.strerror or error}")
            self._refuse()
            return
        name = address.shown(*peer[:2])
        if len(self.hosts) >= self.limits.hosts and not self._make_room():
            self._reject(connection, name)
            return
        self._join(TcpChannel(connection, name), make)

    def _make_room(self) -> bool:
        """Disconnect the longest-silent host if it is idle; it may reconnect."""
        silent = [(host.last_received, host) for host in self.hosts if host.is_silent]
        host = self.limits.to_drop(silent, time.monotonic())
        if host is not None:
            self._leave(host, "was silent, and made room for another")
        return host is not None

    def _reject(self, connection: socket.socket, name: str) -> None:
        self._refusals.add(f"{name} was turned away: {self.limits.hosts} hosts are connected already")
        with connection:
            connection.setblocking(False)
            try:
                connection.send(self.console.no_room)
            except OSError:
                pass

    def _refuse(self) -> None:
        if not self._refusing:
            self._refusing = True
            for listener in self._listeners:
                self._selector.unregister(listener)

    def _maker(self, echo: bool | None) -> MakeHost:
        return lambda number, channel: Host(number, channel, self.console.open(echo), self.limits, self.spy)

    def _join(self, channel: HostChannel, make: MakeHost) -> None:
        self.served += 1
        host = make(self.served, channel)
        self.hosts.append(host)
        if self.spy is not None:
            self.spy.remark(host.number, f"connected from {channel.name}")
        self._serve(host)

    def _leave(self, host: Host, why: str) -> None:
        """Remove a host: drop its unfinished line and abandon its running line.

        Motion and background tasks continue.
        """
        self.hosts.remove(host)
        if host.watched:
            self._selector.unregister(host.channel)
        host.channel.close()
        self.console.close(host.port)
        if self.spy is not None:
            self.spy.remark(host.number, why)
        if self._refusing:
            self._refusing = False
            for listener, accept in self._listeners.items():
                self._selector.register(listener, READ, accept)

    # --------------------------------------------------------------------------------------- one iteration

    def _timeout(self) -> float | None:
        if any(host.can_continue(self.pace) for host in self.hosts):
            return 0.0
        times = [self.pace.timeout(), self._refusals.left]
        ends = [host.ended for host in self.hosts if host.ended is not None]
        if ends:
            times.append(max(0.0, min(ends) + self.limits.linger - time.monotonic()))
        return min((each for each in times if each is not None), default=None)

    def _woken(self) -> None:
        try:
            self._wake.recv(64)
        except OSError:
            pass

    def _receive(self, host: Host) -> None:
        if host.listens:
            try:
                host.receive(time.monotonic())
            except ConnectionLost:
                self._leave(host, "broke off")

    def _feed(self, host: Host) -> None:
        try:
            host.feed(self.pace)
        except Exception as error:
            self._report(error)
            host.forget()

    def _serve(self, host: Host) -> None:
        """Send the board's output to a host, and set the events to wait for."""
        try:
            host.flush()
        except ConnectionLost:
            self._leave(host, "broke off")
            return
        if host.done or (host.ended is not None and time.monotonic() >= host.ended + self.limits.linger):
            self._leave(host, "has left")
            return
        wanted = (READ if host.listens else 0) | (WRITE if host.unsent else 0)
        if wanted != host.watched:
            self._watch(host, wanted)

    def _watch(self, host: Host, wanted: int) -> None:
        if not wanted:
            self._selector.unregister(host.channel)
        elif host.watched:
            self._selector.modify(host.channel, wanted, lambda: self._receive(host))
        else:
            self._selector.register(host.channel, wanted, lambda: self._receive(host))
        host.watched = wanted

    def _send_rest(self, host: Host, end: float) -> None:
        """Wait until the host has read all output, at most until `end`."""
        try:
            host.flush()
            while host.unsent and (left := end - time.monotonic()) > 0:
                select.select([], [host.channel], [], left)
                host.flush()
        except (OSError, ValueError):
            pass

    def _report_waits(self) -> None:
        """Report hosts that wait for an event that nothing will cause, once each."""
        if any(host.port.waiting for host in self.hosts) and self.console.next_time() == INFINITY:
            for host in self.hosts:
                why = host.endless_wait()
                if why:
                    self._complain(
                        f"host {host.number} waits {why}, and nothing in progress ends that; "
                        f"{self.console.break_key} gives it up"
                    )

    # -------------------------------------------------------------------------------------- internal errors

    def _guard(self, work: Callable[[], None]) -> None:
        """Call `work`; an internal error loses only the line in which it happens."""
        try:
            work()
        except Exception as error:
            self.console.drop_broken(error)
            self._report(error)

    def _report(self, error: Exception) -> None:
        """Report each different internal error once."""
        frame = walk_tb(error.__traceback__)
        *_, (last, line) = frame
        location = f"{last.f_code.co_filename.rpartition('motionlang')[2].lstrip('/')}:{line}"
        text = f"internal error, please report it: {type(error).__name__}: {error} ({location})"
        if text not in self._known and len(self._known) < MAX_KNOWN:
            self._known.add(text)
            self._complain(text)
