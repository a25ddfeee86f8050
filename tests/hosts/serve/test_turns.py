"""Iterations of the server, one by one in this thread."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Limits, LockStep, Server
from motionlang.kernel import Machine


@pytest.fixture
def complaints() -> list[str]:
    return []


@pytest.fixture
def server(complaints: list[str]) -> Iterator[Server]:
    console = Console(Machine(first_axis=1))
    with Server(console, LockStep(console), complain=complaints.append) as server:
        yield server


def test_each_internal_error_is_reported_once_and_a_hundred_at_most(
    server: Server, complaints: list[str]
) -> None:
    errors: list[Exception] = [KeyError(0), KeyError(0)]
    errors += map(KeyError, range(1, 105))

    def fail() -> None:
        raise errors.pop(0)

    server.in_turn.append(fail)
    server.turn()
    server.turn()
    assert len(complaints) == 1
    assert complaints[0].startswith("internal error, please report it: KeyError: 0 (")
    while errors:
        server.turn()
    assert len(complaints) == 100


def test_limits_of_a_host_and_of_a_server() -> None:
    """64 hosts, 4 KiB a read, 64 KiB each way, 10 s to end, and 60 s of silence."""
    assert Limits() == Limits(hosts=64, chunk=4096, inbox=65536, outbox=65536, linger=10.0, idle=60.0)
    console = Console(Machine(first_axis=1))
    given = Limits(hosts=1)
    with Server(console, limits=given) as server:
        assert server.limits is given
    with Server(console) as server:
        assert server.limits == Limits()


def test_a_server_may_be_woken_any_number_of_times(server: Server) -> None:
    """The signals that it has not read do not make the caller wait."""
    assert [each.getblocking() for each in (server._wake, server._alarm)] == [False, False]
    for _ in range(1000):
        server.wake()
    server.turn(None)


def test_a_serving_thread_does_not_keep_the_process_alive(server: Server) -> None:
    others = set(threading.enumerate())
    with server.in_thread():
        (serving_thread,) = set(threading.enumerate()) - others
        assert serving_thread.daemon
    assert not serving_thread.is_alive()


@pytest.mark.parametrize(
    ("last_received", "dropped"),
    [
        ({1: 41.0, 2: 40.5}, None),  # neither has been silent for 60 s
        ({1: 41.0, 2: 40.0}, 2),
        ({1: 39.0, 2: 40.0}, 1),  # the longest-silent one
        ({2: 40.0}, 2),
        ({}, None),
    ],
)
def test_the_host_that_has_been_silent_longest_makes_room_after_a_minute(
    last_received: dict[int, float], dropped: int | None
) -> None:
    silent = [(time, host) for host, time in last_received.items()]
    assert Limits().to_drop(silent, now=100.0) == dropped
