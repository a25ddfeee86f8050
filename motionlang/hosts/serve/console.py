"""Protocols between the server and a controller: a console, and a port per host."""

from __future__ import annotations

from typing import Protocol, TypeVar

from motionlang.lang.machine.machine import Machine
from motionlang.lang.waits import Wait


class Port(Protocol):
    """One host's connection to a controller.

    `busy` is True while a line of the host is carried out, and `waiting` is the wait of that line. `feed` accepts
    characters and returns their number, `take` returns the output. `accepts` is True if `feed` would accept any.
    `drop_abandoned` removes characters that a later character abandons. In lock step the server gives a busy port
    the characters that `at_once` selects, and an idle port the entry that `next_entry` selects. `abandon` ends the
    line.
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

    `run` advances machine time to a given time, `settle` until no line is carried out. `next_time` is the time of
    the next event without input, 0 for at once. `working` is True while a line is carried out that does not wait for
    its host. `drop_broken` ends the lines that an internal error has broken. `break_key` ends a line, and `no_room` is
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
