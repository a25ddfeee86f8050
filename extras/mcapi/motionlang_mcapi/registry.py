"""The registry of implementations in `calls/`, by MCAPI function name."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from motionlang.kernel.mccl import Command

F = TypeVar("F", bound=Callable[..., Any])

# They get the interface and the arguments by name, and return the commands of the call.
COMMANDS: dict[str, Callable[..., list[Command]]] = {}
# They get the interface and the arguments by name, at the machine time of the call, and return the results.
QUERIES: dict[str, Callable[..., Any]] = {}
# They get session, call and arguments. None means that the call is done, True that its line is to run, False
# that it goes on by itself.
AT_ONCE: dict[str, Callable[..., bool | None]] = {}
# They get session, call and arguments, and return `ready`, `due`, the time-out and what to do at the end.
POLLS: dict[str, Callable[..., Any]] = {}


def _register(found: dict[str, Any], names: tuple[str, ...]) -> Callable[[F], F]:
    def add(function: F) -> F:
        for name in names:
            found[name] = function
        return function

    return add


def commands(*names: str) -> Callable[[F], F]:
    return _register(COMMANDS, names)


def query(*names: str) -> Callable[[F], F]:
    return _register(QUERIES, names)


def at_once(*names: str) -> Callable[[F], F]:
    return _register(AT_ONCE, names)


def poll(*names: str) -> Callable[[F], F]:
    return _register(POLLS, names)
