"""Iterations of the server, one by one in this thread."""

from __future__ import annotations

from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.lang.machine.machine import Machine
from motionlang.mccl.hosts.console import Console
from motionlang.serve import LockStep, Server
from motionlang.serve.server import MAX_KNOWN


@pytest.fixture
def complaints() -> list[str]:
    return []


@pytest.fixture
def server(complaints: list[str]) -> Iterator[Server]:
    console = Console(Machine(first_axis=1))
    with Server(console, LockStep(console), complain=complaints.append) as server:
        yield server
        server.hosts.clear()


def test_another_host_is_answered_first_each_time(server: Server) -> None:
    order: list[int] = []

    def host(number: int) -> Any:
        port = SimpleNamespace(waiting=None, busy=False)
        return SimpleNamespace(
            number=number, port=port, waits=False, done=False, ended=None, listens=False, unsent=False, watched=0,
            flush=lambda: order.append(number),
        )  # fmt: skip

    server.hosts += [host(number) for number in range(3)]
    for _ in range(4):
        server.turn()
    assert order == [1, 2, 0, 2, 0, 1, 0, 1, 2, 1, 2, 0]


def test_each_internal_error_is_reported_once_and_a_hundred_at_most(
    server: Server, complaints: list[str]
) -> None:
    errors: list[Exception] = [KeyError(0), KeyError(0)]
    errors += map(KeyError, range(1, MAX_KNOWN + 5))

    def fail() -> None:
        raise errors.pop(0)

    server.in_turn.append(fail)
    server.turn()
    server.turn()
    assert len(complaints) == 1
    assert complaints[0].startswith("internal error, please report it: KeyError: 0 (")
    while errors:
        server.turn()
    assert len(complaints) == MAX_KNOWN == 100
