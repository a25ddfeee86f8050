"""A controller that hosts talk to: a console, and a port per host. A server feeds the ports and lets time pass."""

from __future__ import annotations

from typing import Generic, Protocol, TypeVar

from motionlang.kernel import INFINITY, Machine, Scheduler, Task, Wait

# The number of moves, profiles and changes that a served controller stores, because it may run for days.
MEMORY = 1000
# History is trimmed once in this many requests, because the search costs as much as a request.
SELDOM = 50


class HostPort(Protocol):
    """One host's connection to a controller.

    `busy` is True while a line of the host is carried out, and `waiting` is the wait of that line. `feed` accepts
    characters and returns their number, `take` returns the output. `accepts` is True if `feed` would accept any.
    `next_piece` selects what the server feeds next, in lock step one entry, and says whether it is a whole one; it
    removes characters that a later character abandons. `abandon` ends the line.
    """

    @property
    def busy(self) -> bool: ...
    @property
    def waiting(self) -> Wait | None: ...
    def feed(self, data: bytes) -> int: ...
    def take(self) -> bytes: ...
    def accepts(self, data: bytes | bytearray, by_line: bool) -> bool: ...
    def next_piece(self, data: bytearray, by_line: bool) -> tuple[bytes, bool]: ...
    def abandon(self) -> None: ...
    def close(self) -> None: ...


AnyPort = TypeVar("AnyPort", bound=HostPort)


class HostConsole(Generic[AnyPort]):
    """A controller with its ports.

    `run` advances machine time to a given time, `settle` until no line is carried out. `working` is True while a line
    is carried out that does not wait for its host. `drop_broken` ends the lines that an internal error has broken.
    `break_key` ends a line, and `no_room` is sent to a host that cannot connect. `resting` is the parent task that
    `scheduler` has while nothing runs.
    """

    break_key: str
    no_room: bytes

    def __init__(self, machine: Machine, scheduler: Scheduler, resting: Task) -> None:
        self.machine = machine
        self.ports: list[AnyPort] = []
        self._scheduler = machine.scheduler = scheduler
        self._resting = resting
        self._passes = 0

    @property
    def now(self) -> float:
        """Machine time, seconds."""
        return self.machine.clock.now

    @property
    def working(self) -> bool:
        raise NotImplementedError

    def open(self, echo: bool | None = None) -> HostPort:
        """Open a port for another host."""
        raise NotImplementedError

    def close(self, port: AnyPort) -> None:
        """Close the port of a host that has disconnected."""
        raise NotImplementedError

    def run(self, until: float) -> None:
        raise NotImplementedError

    def settle(self, limit: float = INFINITY) -> bool:
        raise NotImplementedError

    def drop_broken(self, error: Exception) -> None:
        raise NotImplementedError

    def next_time(self) -> float:
        """Return when something will next happen without input; 0 means at once.

        A server need not poll the controller before that.
        """
        time = self.machine.clock.next_time()
        for task in (*self._scheduler.tasks, *self._scheduler.interrupts):
            if task is not self._resting:
                if task.wait is None or task.wait.ready():
                    return 0.0
                time = min(time, task.wait.due())
        return time

    def _forget(self) -> bool:
        """Trim unused history at intervals, because a served controller may run for days; True if it was."""
        self._passes += 1
        if self._passes % SELDOM:
            return False
        self.machine.controller.forget_history(MEMORY)
        return True
