"""Iterations of the server, one by one in this thread."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any
from unittest.mock import MagicMock

import pytest

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Limits, LockStep, Server
from motionlang.hosts.serve import server as serving
from motionlang.hosts.serve.host import Host
from motionlang.hosts.serve.server import MAX_KNOWN, READ, WRITE
from motionlang.kernel import INFINITY, Machine


@pytest.fixture
def complaints() -> list[str]:
    return []


@pytest.fixture
def server(complaints: list[str]) -> Iterator[Server]:
    console = Console(Machine(first_axis=1))
    with Server(console, LockStep(console), complain=complaints.append) as server:
        yield server
        server.hosts.clear()


def host(**given: Any) -> Any:
    """Return a host that neither sends nor receives; `given` are its other attributes."""
    idle = {
        "number": 1, "port": SimpleNamespace(waiting=None, busy=False), "waits": False, "unsent": False, "done": False,
        "channel": SimpleNamespace(name="a host", close=lambda: None), "is_silent": True, "listens": False,
        "ended": None, "watched": 0, "last_received": 0.0, "flush": lambda: None, "can_continue": lambda pace: False,
    }  # fmt: skip
    return SimpleNamespace(**{**idle, **given})


@pytest.fixture
def now(monkeypatch: pytest.MonkeyPatch) -> float:
    """Return the present real time of the server, which does not pass."""
    monkeypatch.setattr(serving, "time", SimpleNamespace(monotonic=lambda: 100.0))
    return 100.0


def test_another_host_is_answered_first_each_time(server: Server) -> None:
    order: list[int] = []
    server.hosts += [
        host(number=number, flush=lambda number=number: order.append(number)) for number in range(3)
    ]
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


@pytest.mark.parametrize(
    ("ended", "pace", "refusal", "timeout"),
    [
        ([], None, None, None),
        ([None], 3.0, None, 3.0),
        ([None], 3.0, 0.5, 0.5),
        ([97.0], None, None, 7.0),
        ([97.0, None, 92.0], None, None, 2.0),  # the first one that ends
        ([97.0], 3.0, None, 3.0),
        ([97.0], 8.0, None, 7.0),
        ([85.0], 3.0, None, 0.0),  # its time is over
        ([97.0], 3.0, 0.0, 0.0),
    ],
)
@pytest.mark.usefixtures("now")
def test_the_time_until_the_server_has_something_to_do(
    ended: list[float | None],
    pace: float | None,
    refusal: float | None,
    timeout: float | None,
    server: Server,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It is 100 s; a host that ended its side has 10 s for its last lines."""
    monkeypatch.setattr(server.pace, "timeout", lambda: pace)
    monkeypatch.setattr(server, "_refusals", SimpleNamespace(left=refusal, flush=lambda: None))
    server.hosts += [host(ended=time) for time in ended]
    assert server._timeout() == timeout
    server.hosts.append(host(can_continue=lambda pace: True))
    assert server._timeout() == 0.0


@pytest.mark.parametrize(
    ("ended", "is_done", "stays"),
    [
        (None, False, True),
        (None, True, False),
        (99.0, True, False),
        (90.1, False, True),
        (90.0, False, False),
    ],
)
@pytest.mark.usefixtures("now")
def test_a_host_leaves_when_it_is_done_or_after_ten_seconds(
    ended: float | None, is_done: bool, stays: bool, server: Server, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(server.console, "close", lambda port: None)
    each = host(ended=ended, done=is_done)
    server.hosts.append(each)
    server._serve(each)
    assert (each in server.hosts) is stays


@pytest.mark.parametrize(
    ("last_received", "is_silent", "left"),
    [
        ((41.0, 40.5), (True, True), []),  # neither has been silent for 60 s
        ((41.0, 40.0), (True, True), [2]),
        ((39.0, 40.0), (True, True), [1]),  # the longest-silent one
        ((39.0, 40.0), (False, True), [2]),
        ((39.0, 39.0), (False, False), []),
    ],
)
@pytest.mark.usefixtures("now")
def test_a_host_that_is_silent_for_a_minute_makes_room(
    last_received: tuple[float, float],
    is_silent: tuple[bool, bool],
    left: list[int],
    server: Server,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(server.console, "close", lambda port: None)
    each = zip((1, 2), last_received, is_silent, strict=True)
    server.hosts += [host(number=n, last_received=time, is_silent=silent) for n, time, silent in each]
    assert server._make_room() is bool(left)
    assert [n for n in (1, 2) if n not in [each.number for each in server.hosts]] == left


def test_the_address_of_a_server_is_host_and_port(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    """An address of IPv6 has two numbers more."""
    listener = MagicMock(getsockname=lambda: ("::1", 4000, 0, 0))
    monkeypatch.setattr("motionlang.hosts.address.listen", lambda host, port: listener)
    monkeypatch.setattr(server, "_selector", MagicMock())
    assert server.listen("::1", 0) == ("::1", 4000)


def test_the_selector_waits_for_what_a_host_can_do(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    """A host is registered, modified and removed only if the events change."""
    calls: list[tuple[object, ...]] = []
    selector = SimpleNamespace(
        register=lambda channel, events, call: calls.append(("register", events)),
        modify=lambda channel, events, call: calls.append(("modify", events)),
        unregister=lambda channel: calls.append(("unregister",)),
        close=server._selector.close,
    )
    monkeypatch.setattr(server, "_selector", selector)
    each = host()
    for listens, unsent in (
        (False, False),
        (True, False),
        (True, False),
        (True, True),
        (False, True),
        (False, False),
    ):
        each.listens, each.unsent = listens, unsent
        server._serve(each)
    assert calls == [("register", READ), ("modify", READ | WRITE), ("modify", WRITE), ("unregister",)]
    assert each.watched == 0


def test_limits_of_a_host_and_of_a_server() -> None:
    """64 hosts, 4 KiB a read, 64 KiB each way, 10 s to end, and 60 s of silence."""
    assert Limits() == Limits(hosts=64, chunk=4096, inbox=65536, outbox=65536, linger=10.0, idle=60.0)
    console = Console(Machine(first_axis=1))
    given = Limits(hosts=1)
    with Server(console, limits=given) as server:
        assert server.limits is given
    with Server(console) as server:
        assert server.limits == Limits()


def test_hosts_are_numbered_and_the_log_has_when_they_come_and_leave(
    server: Server, monkeypatch: pytest.MonkeyPatch
) -> None:
    remarks: list[tuple[int, str]] = []
    spy: Any = SimpleNamespace(remark=lambda *given: remarks.append(given))
    server.spy = spy
    monkeypatch.setattr(server.console, "close", lambda port: None)
    for name in ("first", "second"):
        channel: Any = SimpleNamespace(name=name, close=lambda: None)
        server._join(channel, lambda number, channel: host(number=number, channel=channel))
    assert [each.number for each in server.hosts] == [1, 2] == list(range(1, server.served + 1))
    server._leave(server.hosts[0], "has left")
    assert remarks == [(1, "connected from first"), (2, "connected from second"), (1, "has left")]


@pytest.mark.parametrize(("hosts", "is_rejected"), [(0, False), (1, True)])
def test_a_host_is_rejected_if_as_many_as_allowed_are_connected(
    hosts: int, is_rejected: bool, complaints: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """One is allowed, and the one that is connected is busy."""
    sent: list[bytes] = []
    console = Console(Machine(first_axis=1))
    connection = MagicMock(send=sent.append)
    listener: Any = SimpleNamespace(accept=lambda: (connection, ("::1", 4000, 0, 0)))
    monkeypatch.setattr(console, "close", lambda port: None)
    with Server(console, limits=Limits(hosts=1), complain=complaints.append) as server:
        server.hosts += [host(is_silent=False)] * hosts
        server._accept(listener, lambda number, channel: host(channel=channel))
        assert [each.channel.name for each in server.hosts] == ["a host" if is_rejected else "[::1]:4000"]
    assert sent == ([console.no_room] if is_rejected else [])
    connection.setblocking.assert_called_once_with(False)
    assert complaints == ["[::1]:4000 was turned away: 1 hosts are connected already"] * is_rejected


@pytest.mark.parametrize(("pieces", "waits"), [(1, []), (2, [0.5]), (9, [0.5, 0.25])])
def test_at_the_end_hosts_have_half_a_second_to_read_their_output(
    pieces: int, waits: list[float], server: Server, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each piece of the output takes a quarter of a second to read."""
    times, waited = iter([100.0, 100.0, 100.25, 100.5]), list[float]()
    monkeypatch.setattr(serving, "time", SimpleNamespace(monotonic=lambda: next(times)))
    monkeypatch.setattr(serving, "select", SimpleNamespace(select=lambda *given: waited.append(given[-1])))
    monkeypatch.setattr(server.console, "close", lambda port: None)
    each = host()

    def flush() -> None:
        nonlocal pieces
        pieces -= 1
        each.unsent = pieces > 0

    each.flush = flush
    server.hosts.append(each)
    server.close()
    assert waited == waits
    assert server.hosts == []


@pytest.mark.parametrize(("next_time", "is_reported"), [(INFINITY, True), (1e9, False)])
def test_a_wait_is_reported_once_if_the_controller_has_no_event(
    next_time: float,
    is_reported: bool,
    server: Server,
    complaints: list[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Of three waits nothing ends the third.

    The first is over, and the second ends at a known time.
    """
    waits = [
        SimpleNamespace(ready=lambda ready=ready: ready, due=lambda due=due: due, why="for axis 1")
        for ready, due in ((True, INFINITY), (False, 7.0), (False, INFINITY))
    ]
    monkeypatch.setattr(server.console, "next_time", lambda: next_time)
    monkeypatch.setattr(server.console, "close", lambda port: None)
    for number, wait in enumerate(waits, 1):
        port: Any = SimpleNamespace(waiting=wait, busy=True)
        server.hosts.append(Host(number, host().channel, port, Limits(), None))
    server.hosts.append(host(endless_wait=lambda: ""))
    for _ in range(2):
        server._report_waits()
    expected = "host 3 waits for axis 1, and nothing in progress ends that; ESC gives it up"
    assert complaints == [expected] * is_reported
    server.hosts.clear()


def test_a_server_without_free_connections_listens_again_when_a_host_has_left(
    server: Server, complaints: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A client that has gone before it is accepted is no reason to stop listening."""
    calls: list[str] = []
    errors: list[OSError] = [
        BlockingIOError(),
        ConnectionAbortedError(),
        OSError(24, "Too many open files"),
        OSError(),
    ]

    def accept() -> None:
        raise errors.pop(0)

    listener = MagicMock(accept=accept)
    selector = SimpleNamespace(
        register=lambda *given: calls.append("register"),
        unregister=lambda *given: calls.append("unregister"),
        close=server._selector.close,
    )
    monkeypatch.setattr(server, "_selector", selector)
    monkeypatch.setattr(server.console, "close", lambda port: None)
    server._listeners[listener] = lambda: None
    server.hosts += [host(), host()]
    for expected in ([], [], ["unregister"], ["unregister"]):
        server._accept(listener, lambda number, channel: host())
        assert calls == expected
    assert complaints == ["no host can connect: Too many open files"]
    for _ in range(2):
        server._leave(server.hosts[0], "has left")
        assert calls == ["unregister", "register"]


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
