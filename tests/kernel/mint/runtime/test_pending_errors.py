"""A pending error raises ONERROR once; endless handlers end the run with `never`."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Run, Source
from motionlang.kernel.mint.runtime import events

COUNT = "\nEnd\nEvent ONERROR\n  n = n + 1\n{}End Event"
JOG = "SPEED(0) = 10 : ACCEL(0) = 100 : DECEL(0) = 100\nSOFTLIMITFORWARD(0) = 5\nSOFTLIMITMODE(0) = {}\n"


def ended(text: str, machine: dict[str, object] | None = None) -> Run:
    """Return the run of a program, which must end within 20 s."""
    return run(Source("a.mnt", "Dim n As Integer\n" + text), machine=machine, until=20.0)


def test_abort_in_the_handler_of_an_abort_lets_the_program_go_on() -> None:
    result = ended("ABORT\nPRINT n" + COUNT.format("  ABORT\n"))
    assert (result.output, result.status) == (["1"], "ended")
    kinds = [event.kind for event in result.machine.log.events]
    assert (kinds.count("handler"), kinds.count("abort")) == (1, 16)  # 8 axes, twice


def test_the_mode_of_the_end_switches_does_not_concern_the_soft_limits() -> None:
    """LIMITMODE 0 ignores an end switch; the soft limit still aborts with error 16."""
    move = "LIMITMODE(0) = 0\nMOVER(0) = 9 : GO(0) : PAUSE IDLE(0)\nPRINT POS(0);\nPRINT AXISERROR(0)\n"
    assert ended(JOG.format(1) + move).output == ["5.000016"]


@pytest.mark.parametrize(
    ("between", "calls"),
    [
        ("", 1),
        ("CANCEL(0)\n", 2),
        ("RESET(0)\n", 2),
        ("AXISERROR(0) = 0\n", 2),
        ("ERRORCLEAR(_egALL, 0)\n", 2),
        ("DRIVEENABLE(0) = 1\n", 2),
        ("While ERRORREADNEXT(_egALL, 0)\nEnd While\n", 1),  # read, and still pending
    ],
)
def test_an_error_is_pending_until_it_is_cleared(between: str, calls: int) -> None:
    assert ended(f"ABORT\n{between}ABORT\nPRINT n{COUNT.format('')}").output == [str(calls)]


def test_limit_that_only_reports_is_passed_twice_and_reported_once() -> None:
    """Mode 5 lets the axis continue; the log has both times at which it passes."""
    moves = "MOVEBUFFERSIZE(0) = 5\nMOVEA(0) = 10 : MOVEA(0) = 0 : MOVEA(0) = 10 : GO(0)\nPAUSE IDLE(0)\n"
    result = ended(JOG.format(5) + moves + "PRINT n" + COUNT.format(""))
    assert result.output == ["1"]
    assert [event.kind for event in result.machine.log.events].count("soft limit") == 2


def test_another_error_of_the_same_axis_is_a_new_one() -> None:
    text = JOG.format(5) + "JOG(0) = 10\nWAIT = 1000\nABORT\nPRINT n" + COUNT.format("")
    assert ended(text).output == ["2"]


def test_an_error_of_the_controller_is_pending_too() -> None:
    """The error occurs at 10, 20 and 40 ms; MISCERROR = 0 clears it at 30 ms."""
    machine: dict[str, object] = {
        "fault": [{"kind": "controller", "value": 4, "at": at} for at in (0.01, 0.02, 0.04)]
    }
    text = "WAIT = 30\nPRINT n\nMISCERROR = 0\nWAIT = 20\nPRINT n" + COUNT.format("")
    assert ended(text, machine).output == ["1", "2"]


FOREVER: dict[str, tuple[str, dict[str, object], int, str]] = {
    "an error that is cleared": ("ABORT" + COUNT.format("  CANCEL(0)\n  ABORT\n"), {}, 7, "ONERROR"),
    "an event that is pended": (
        "EVENTPEND(2, 0, 0)\nWAIT = 1\nEnd\nEvent STOP\n  EVENTPEND(2, 0, 0)\nEnd Event",
        {},
        6,
        "STOP",
    ),
    "two that pend each other": (
        "EVENTPEND(2, 0, 0)\nWAIT = 1\nEnd\nEvent STOP\n  EVENTPEND(10, 0, 0)\nEnd Event\n"
        "Event AXISIDLE\n  EVENTPEND(2, 0, 0)\nEnd Event",
        {},
        6,
        "AXISIDLE",
    ),
    "an output wired to the input": (
        "INPUTACTIVELEVEL = 0xFFFF\nINPUTPOSTRIGGER(0) = 2\nOUTX(1) = 1\nWAIT = 1\nEnd\n"
        "Event IN1\n  OUTX(1) = 0\n  OUTX(1) = 1\nEnd Event",
        {"input": [{"channel": 1, "output": 1}]},
        9,
        "IN1",
    ),
    "though ONERROR takes what fails": (
        "EVENTPEND(2, 0, 0)\nWAIT = 1\nEnd\nEvent STOP\n  EVENTPEND(2, 0, 0)\nEnd Event\nEvent ONERROR\nEnd Event",
        {},
        6,
        "STOP",
    ),
}


@pytest.mark.parametrize("case", FOREVER)
def test_a_handler_that_raises_itself_forever_is_reported(case: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert events.MAX_ROUNDS == 10_000
    monkeypatch.setattr(events, "MAX_ROUNDS", 1_000)
    text, machine, line, event = FOREVER[case]
    result = ended(text, machine)
    (found,) = result.diagnostics
    assert (found.code, found.line, result.status) == ("never", line, "fault")
    assert (
        found.message
        == f"handlers have raised 1000 events in a row, the last one {event}, and no task runs anymore"
    )


def test_a_handler_may_raise_itself_often() -> None:
    text = "EVENTPEND(2, 0, 0)\nPRINT n\nEnd\nEvent STOP\n  n = n + 1\n  If n < 9000 Then EVENTPEND(2, 0, 0)\nEnd Event"
    assert ended(text).output == ["9000"]


def test_a_task_that_runs_in_between_begins_the_count_again() -> None:
    """Each iteration causes STOP twice; 12 000 of them are no endless chain."""
    text = (
        "For i = 1 To 12000\n  n = 0\n  EVENTPEND(2, 0, 0)\nNext\nPRINT n\nEnd\n"
        "Event STOP\n  n = n + 1\n  If n < 2 Then EVENTPEND(2, 0, 0)\nEnd Event"
    )
    assert ended(text).output == ["2"]


def test_a_handler_that_takes_longer_than_the_period_of_its_timer_is_none_of_them() -> None:
    """The timer raises the event, not the handler, so this is no endless chain.

    The program continues until the time limit of the run.
    """
    result = ended("TIMEREVENT = 1\nWAIT = 10\nEnd\nEvent TIMER\n  WAIT = 1.2\nEnd Event")
    assert result.status == "until"
    assert not result.diagnostics


@pytest.mark.parametrize(
    ("quick", "slow", "since"),
    [(0, 2, None), (0, 3, "0.006"), (1, 2, None), (1, 3, "0.007"), (2, 3, "0.008")],
)
def test_handlers_that_leave_no_time_for_tasks_are_noted(
    quick: int, slow: int, since: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A handler of 5 ms at ticks of 1 ms is followed by another one at once.

    After three slow ones in a row this happens three times. The first tick is at 1.01 ms, after the statement of
    TIMEREVENT; a slow handler of it ends at 6.03 ms. Each quick one before it delays that by a tick.
    """
    assert events.CROWDED == 100
    monkeypatch.setattr(events, "CROWDED", 3)
    body = f"n = n + 1\n  If n > {quick} And n <= {quick + slow} Then WAIT(5)"
    text = f"TIMEREVENT = 1\nWAIT = 100\nEnd\nEvent TIMER\n  {body}\nEnd Event"
    note = (
        f"3 handlers in a row, from {since} s on, left no time for any task (the last one was for TIMER): a handler"
        " must end before its event comes again"
    )
    assert ended(text).notes == ([note] if since else [])
