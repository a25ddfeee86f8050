"""Protocols of a controller for the server: a console, and a port for each host."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, TypeVar

if TYPE_CHECKING:
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.task import Wait


class Port(Protocol):
    """One host's connection to a controller.

    `busy` is true while a line of the host is carried out, `waiting` is the wait of that line. `feed` takes
    characters and returns how many, `take` returns the output. `accepts` is true if `feed` would take some.
    `drop_abandoned` removes what a later character abandons. In lock step the server gives a busy port what
    `at_once` selects, and another one the entry that `next_entry` selects. `abandon` ends the line.
    """

    @property
    def busy(self) -> bool: ...
    @property
    def waiting(self) -> Wait | None: ...
    def feed(self, data: bytes) -> int: ...
    def take(self) -> bytes: ...
    def accepts(self, data: bytes | bytearray) -> bool: ...
    def drop_abandoned(self, data: bytearray) -> None: ...
    def at_once(self, data: bytes | bytearray) -> bytes: ...
    def next_entry(self, data: bytes | bytearray) -> tuple[bytes, bool]: ...
    def abandon(self) -> None: ...


AnyPort = TypeVar("AnyPort", bound=Port)


class Console(Protocol[AnyPort]):
    """A controller with its ports.

    `run` lets machine time pass to a time, `settle` until no line is carried out. `next_time` is when
    something happens without input, 0 at once. `working` is true while a line is carried out without need of
    its host. `drop_broken` ends what an internal error has broken. `break_key` ends a line, and `no_room` is
    sent to a host that cannot connect.
    """

    machine: Machine
    break_key: str
    no_room: bytes

    @property
    def now(self) -> float: ...
    @property
    def working(self) -> bool: ...
    def open(self, echo: bool | None = None) -> AnyPort: ...
    def close(self, port: AnyPort) -> None: ...
    def run(self, until: float) -> None: ...
    def settle(self, limit: float = ...) -> bool: ...
    def next_time(self) -> float: ...
    def drop_broken(self, error: Exception) -> None: ...
