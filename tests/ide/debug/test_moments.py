"""Moments in the log of a run, each time computed by hand.

A statement takes 1 ms. Axis 0 goes 10 uu at 20 uu/s with rates of 100 uu/s²: ramps of 0.2 s and 2 uu, and 6 uu in
0.3 s. Axis 1 follows it.
"""

from __future__ import annotations

from math import inf

import pytest

from motionlang import run
from motionlang.ide.debug.moments import (
    FILTERS,
    MAX_TEXTS,
    Occurrence,
    complaints,
    filtered,
    search,
    together,
)
from motionlang.kernel import Diagnostic, Run, Source
from tests.ide.debug.test_debugger import mint

PROGRAM = """\
SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100
FOLLOW(1) = 1
OUTX(2) = 1
MOVER(0) = 10 : GO(0) : PAUSE IDLE(0)
MOVEA(0) = 10 : GO(0) : PAUSE IDLE(0)
OUTX(2) = 0
WAIT = 200
MOVER(0) = -10 : GO(0)
WAIT = 300
CANCEL(0)
"""
# The statements before the first GO are 1 ms each: three settings, FOLLOW, OUTX and MOVER.
FOLLOWS, RISES, GOES = 0.003, 0.004, 0.006
# The move, PAUSE, MOVEA, GO and PAUSE; then OUTX, WAIT and MOVER.
FALLS = GOES + 0.7 + 0.004
BACK = FALLS + 0.001 + 0.2 + 0.002
# GO and WAIT take 1 ms each, and WAIT waits.
CANCELLED = BACK + 0.3 + 0.002


def made(until: float = inf) -> Run:
    settings = {"controller.instruction_time": 1e-3, "input": [{"channel": 5, "at": 0.25, "for": 0.5}]}
    result = run(Source("moves.mnt", PROGRAM), machine=settings, until=min(until, 5.0))
    assert result.diagnostics == []
    return result


def found(text: str, after: float = 0.0, until: float = 9.0, result: Run | None = None) -> list[Occurrence]:
    return list(search(text, range(8))((result or made()).machine, after, until))


@pytest.mark.parametrize(
    ("text", "after", "until", "times"),
    [
        # A move of nothing does not start.
        ("axis 0 starts", 0.0, 9.0, [GOES, BACK]),
        ("axis 0 starts", GOES, 9.0, [BACK]),
        ("axis 0 starts", 0.0, BACK, [GOES, BACK]),
        ("axis 0 starts", 0.0, BACK - 1e-6, [GOES]),
        ("axis 1 starts", 0.0, 9.0, [FOLLOWS]),
        ("axis 2 starts", 0.0, 9.0, []),
        ("axis 0 stops", 0.0, 9.0, [GOES + 0.7, CANCELLED]),
        ("axis 0 stops", GOES + 0.7 + 1e-6, 9.0, [CANCELLED]),
        ("axis 0 stops", 0.0, GOES + 0.7 - 1e-6, []),
        ("output 2 changes", 0.0, 9.0, [RISES, FALLS]),
        ("output 2 rises", 0.0, 9.0, [RISES]),
        ("output 2 rises", RISES, 9.0, []),
        ("output 2 falls", 0.0, 9.0, [FALLS]),
        ("output 2 falls", 0.0, FALLS - 1e-6, []),
        ("output 3 changes", 0.0, 9.0, []),
        ("input 5 changes", 0.0, 9.0, [0.25, 0.75]),
        ("input 5 changes", 0.0, 0.25, [0.25]),
        ("input 5 falls", 0.25, 9.0, [0.75]),
        # 8 uu are passed after 2 and 6 uu, at the end of 0.5 s; in reverse at the end of the first ramp.
        ("position(0) > 8", 0.0, 9.0, [GOES + 0.5]),
        ("position(0) < 8", GOES + 0.6, 9.0, [BACK + 0.2]),
        ("velocity(0) < -10", 0.0, 9.0, [BACK + 0.1]),
        ("input(5) = 0 And position(1) > 5", 0.0, 9.0, [0.75]),
        ("output(2) = 0", 0.0, 9.0, [FALLS]),
        ("idle(0) And time > 0.1", 0.0, 9.0, [GOES + 0.7, CANCELLED]),
        ("input(5)", 0.0, 0.25, [0.25]),
        # From 4.8 to 5.2 uu takes 20 ms, in a move of 0.7 s that is sampled every 11 ms.
        ("position(0) > 4.8 And position(0) < 5.2", 0.0, BACK, [GOES + 0.34]),
        # From 1.5 to 0.5 uu/s takes 10 ms, 15 ms before the end.
        ("velocity(0) < 1.5 And velocity(0) > 0.5", 0.1, BACK, [GOES + 0.685]),
    ],
)
def test_moments_are_after_one_time_up_to_another(
    text: str, after: float, until: float, times: list[float]
) -> None:
    moments = found(text, after, until)
    assert [each.time for each in moments] == pytest.approx(times, abs=2e-9)
    assert {each.reason for each in moments} <= {"moment"}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("axis 1 starts", "axis 1 starts FOLLOW"),
        ("axis 0 stops", "axis 0 stops"),
        ("Output 2 RISES", "output 2 rises"),
        ("output 2 falls", "output 2 falls"),
        (" position(0) > 8 ", "position(0) > 8 holds"),
    ],
)
def test_a_moment_says_what_occurs(text: str, words: str) -> None:
    assert found(text)[0].text == words


def test_a_motion_that_has_not_ended_has_started() -> None:
    """The profile of FOLLOW is not known before it ends."""
    debugger = mint(PROGRAM, {"controller.instruction_time": 1e-3})
    debugger.searches = [search("axis 1 starts", range(8))]
    stop = debugger.start(False)
    assert stop is not None
    assert stop.moment == pytest.approx(FOLLOWS)
    assert stop.text.startswith("axis 1 starts FOLLOW")


def test_a_motion_without_an_end_is_sampled_64_times_up_to_the_search() -> None:
    """A jog at 64 uu/s from 10 s on is sampled every 1 uu of its first second.

    The ramp takes 1 ms, which is 0.5 ms longer than that distance at speed.
    """
    program = "SPEED(0) = 64 : ACCEL(0) = 64000\nWAIT = 10000\nJOG(0) = 64\nWAIT = 5000\n"
    result = run(Source("jog.mnt", program), machine={}, until=12.0)
    start = 10.00003  # three statements before
    (moment,) = found("position(0) > 4.95 And position(0) < 4.99", 9.0, start + 1.0, result)
    assert moment.time == pytest.approx(start + 0.5e-3 + 4.95 / 64, abs=1e-8)


def test_errors_that_did_not_end_the_program() -> None:
    """A command reports its error after its 10 µs; warnings are left out."""
    machine = run(Source("a.mcl", "WA.001,99MR5\n99MR6\n"), machine={}).machine
    warned = Diagnostic("never-waits", "it never waits", 1, severity="warning")
    warned.first = 0.00102
    machine.diagnostics.append(warned)
    one, other = complaints(machine, -1.0, 9.0)
    text = "there is no axis 99 (?-15: axis not assigned), line"
    assert (one.text, one.reason) == (f"{text} 1", "exception")
    assert (other.text, other.reason) == (f"{text} 2", "exception")
    assert [one.time, other.time] == pytest.approx([0.00102, 0.00103])
    for after, until, times in (
        (0.0, one.time, [one.time]),
        (0.0, one.time - 1e-9, []),
        (one.time, 9.0, [other.time]),
        (other.time, 9.0, []),
    ):
        assert [each.time for each in complaints(machine, after, until)] == times


def test_a_run_without_motion_has_no_moments() -> None:
    result = run(Source("none.mnt", "a = 1\n"), machine={})
    for text in ("axis 0 stops", "axis 0 starts", "position(0) > 1"):
        assert found(text, result=result) == []


def test_moments_of_one_time_are_one() -> None:
    """At most two of their texts are shown, each once."""
    three = [Occurrence(1.0, text, 7, "exception") for text in ("a", "b", "a", "c")]
    assert together(three).text == "a; b; 1 more"
    first = together([*three[:3], Occurrence(1.5, "d")])
    assert (first.time, first.text, first.at, first.reason) == (1.0, "a; b", 7, "exception")
    assert MAX_TEXTS == 2


LIMITED = """\
SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100
SOFTLIMITFORWARD(0) = 5 : SOFTLIMITMODE(0) = 1
MOVER(0) = 10 : GO(0) : PAUSE IDLE(0)
"""


def test_limits_are_found_as_exceptions() -> None:
    """5 uu are 2 uu in 0.2 s, and 3 uu at 20 uu/s, after GO, the seventh statement."""
    result = run(Source("limit.mnt", LIMITED), machine={})
    limits, jumps = filtered(FILTERS["limit"][1]), filtered(["velocity jump"])
    (moment,) = limits(result.machine, 0.0, 9.0)
    assert moment.time == pytest.approx(6e-5 + 0.35)
    assert (moment.text, moment.reason) == ("soft limit of axis 0: forward soft limit, abort", "exception")
    assert moment.at is not None
    assert list(limits(result.machine, moment.time, 9.0)) == []
    assert [each.time for each in limits(result.machine, 0.0, moment.time)] == [moment.time]
    assert list(limits(result.machine, 0.0, moment.time - 1e-6)) == []
    assert [each.time for each in jumps(result.machine, 0.0, 9.0)] == [moment.time]
    assert list(filtered(FILTERS["clamp"][1])(result.machine, 0.0, 9.0)) == []
