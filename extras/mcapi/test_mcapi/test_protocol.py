"""Lines of the port."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

import motionlang_mcapi as mc
from motionlang.hosts.serve import Limits, LockStep
from motionlang_mcapi import Mcapi
from motionlang_mcapi.host import McapiHost
from test_mcapi.conftest import ask, opened

MAX_LINE = 32_768


def test_missing_values_of_a_structure_are_0(host: Mcapi) -> None:
    """An older structure has fewer fields.

    Here the time unit is missing, and 0 is out of range.
    """
    assert ask(host, "MCSetScale 1 1 5 1.0 2.0 3.0 4.0 5.0") == "18"
    assert ask(host, "MCSetScale 1 1 6 1.0 2.0 3.0 4.0 5.0 6.0") == "0"
    assert ask(host, "MCEnableAxis 1 1 1") == "0"
    assert ask(host, "MCGetScale 1 1 +") == "0 1.0 2.0 3.0 4.0 5.0 6.0"
    assert ask(host, "MCSetContourConfig 1 1 3 10.0 20.0 30.0") == "18"


@pytest.mark.parametrize(
    ("line", "wanted"),
    [
        # A count of 16 bits is unsigned: 65537 is axis 1, -1 is axis 65535.
        ("MCGetPositionEx 1 65537 +", "0 0.0"),
        ("MCGetPositionEx 1 -1 +", "15"),
        # A register is a signed 32-bit number: 4294967295 is -1, 4294967296 is 0.
        ("MCGetRegister 1 4294967295 + 2", "18"),
        ("MCGetRegister 1 4294967296 + 2", "0 0"),
        # An id is a signed 16-bit number: 32768 is -32768, 65536 is 0.
        ("MCOpen 32768 2 -", "-1"),
        ("MCOpen 65536 2 -", "2"),
        ("MCOpen 65535 2 -", "-1"),
        ("MCOpen 65551 2 -", "2"),
    ],
)
def test_integers_wrap_as_in_c(host: Mcapi, line: str, wanted: str) -> None:
    assert ask(host, line) == wanted


def test_a_state_that_wraps_to_0_is_off(host: Mcapi) -> None:
    for state, level in ((1, "1"), (65536, "0"), (32768, "1"), (0, "0"), (-1, "1")):
        ask(host, f"MCEnableDigitalIO 1 33 {state}")
        assert ask(host, "MCGetDigitalIO 1 33") == level


def test_characters_wait_while_a_call_is_carried_out() -> None:
    """An ASCII interface stores 65,536 characters; they are read after the wait."""
    host = opened(mode=1)
    console, ours = host.board.console, host.board._session
    wait = ours.call("MCWait", 1, (1.0,))
    console.run(0.5)
    taken = [ours.call("pmcputs", 1, (text,)).value for text in ("AL5\r", "AR20\r" + " " * 65_600, "x")]
    assert taken == [4, 65_532, 0]
    assert not wait.done
    console.run(2.0)
    assert wait.done
    assert ask(host, "MCGetRegister 1 20 + 2") == "0 5"


def test_an_escape_discards_characters_that_wait() -> None:
    host = opened(mode=1)
    console, ours = host.board.console, host.board._session
    ours.call("MCWait", 1, (1.0,))
    console.run(0.5)
    ours.call("pmcputs", 1, ("AL5\r",))
    ours.call("pmcputs", 1, ("\x1b",))
    console.run(2.0)
    assert ask(host, "MCGetRegister 1 0 + 2") == "0 0"


def test_a_condition_that_holds_needs_no_time(host: Mcapi) -> None:
    """The call is answered at once."""
    ours, console = host.board._session, host.board.console
    assert ours.call("MCIsStopped", 1, (1, 60.0)).done
    host.EnableAxis(1, True)
    host.MoveAbsolute(1, 5000.0)
    console.run(0.1)
    now = ours.call("MCIsStopped", 1, (1, 0.0))
    assert (now.done, now.result) == (True, 0)
    later = ours.call("MCIsStopped", 1, (1, 60.0))
    assert not later.done
    console.run(1.0)
    assert (later.done, later.result) == (True, 1)
    # Twice the root of s/a: 2 · sqrt(5000/100,000) s, from the command on.
    assert later.end == pytest.approx(0.447, abs=5e-3)


def test_the_calls_of_a_host_that_is_gone_are_dropped(host: Mcapi) -> None:
    """A wait of an hour and a poll of an hour end, and neither is answered.

    Motion continues.
    """
    console, desk = host.board.console, host.board.desk
    answers: list[object] = []
    gone = desk.session()
    assert gone.call("MCOpen", 0, (0, 2, None)).result == 1
    host.EnableAxis(1, True)
    host.MoveAbsolute(1, 5000.0)
    gone.call("MCIsStopped", 1, (1, 3600.0), answers.append)
    gone.call("MCWait", 1, (3600.0,), answers.append)
    console.run(0.1)
    gone.leave()
    assert host.IsStopped(1, 10.0) == 1
    assert host.GetPositionEx(1) == 5000.0
    assert console.now < 1.0
    assert answers == []
    assert len(desk.handles) == 1


def test_a_host_process_ends_with_its_last_connection(host: Mcapi) -> None:
    """Processes are numbered from 1; that of the fixture is the first."""
    desk = host.board.desk
    first, other = desk.session("a"), desk.session()
    assert (first.number, other.number) == (2, 3)
    assert desk.session("a") is first
    first.open(mc.MC_OPEN_BINARY)
    first.leave()
    assert (list(first.handles), desk.session("a") is first) == ([1], True)
    for handles in ([1], []):
        first.leave()
        assert list(first.handles) == handles
    again = desk.session("a")
    assert (again is first, again.number) == (False, 4)


@pytest.mark.parametrize(
    ("data", "is_refused", "waits"),
    [
        (b" " * (MAX_LINE - 1) + b"\n", False, False),
        (b" " * MAX_LINE + b"\n", True, False),
        (b" " * MAX_LINE, False, True),
        (b" " * (MAX_LINE + 1), True, False),
    ],
)
def test_the_longest_line(data: bytes, is_refused: bool, waits: bool, host: Mcapi) -> None:
    """A line of blanks is ignored, and the beginning of a line waits for the rest."""
    channel: Any = SimpleNamespace(receive=lambda most: data)
    connection = McapiHost(1, channel, host.board.desk, Limits(), None)
    connection.receive(0.0)
    connection.feed(LockStep(host.board.console))
    assert (connection.port.refused, connection.waits) == (is_refused, waits)
    answer = f"! a line has at most {MAX_LINE} characters\n" if is_refused else ""
    assert connection.port.take() == answer.encode()
