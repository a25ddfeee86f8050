"""The lines to which a time difference is charged."""

from __future__ import annotations

from math import fsum

import pytest

from motionlang.commands.diff.charged import Charge, charged
from motionlang.commands.diff.reports import difference
from motionlang.commands.diff.view import diff_lines
from motionlang.kernel import Run, Source, run
from motionlang.kernel.report import build

# X takes 1.1 s, Z 0.5 s; then 0.1 s of nothing.
PROGRAM = """\
SPEED(0, 1) = 100;
ACCEL(0, 1) = 1000;
DECEL(0, 1) = 1000;
MOVER(0, 1) = 100, 40 : GO(0, 1)
PAUSE IDLE(0) And IDLE(1)
WAIT(100)
"""


def ran(text: str) -> Run:
    return run(Source("press.mnt", text))


def charges(text: str) -> list[tuple[int | None, int | None, float]]:
    return [(each.old, each.new, round(each.seconds, 3)) for each in charged(ran(PROGRAM), ran(text))]


@pytest.mark.parametrize(
    ("was", "is_", "expected"),
    [
        ("100, 40", "100, 50", []),  # no task waits for Z
        ("100, 40", "90, 40", [(4, 4, -0.1)]),
        ("WAIT(100)", "WAIT(150)", [(6, 6, 0.05)]),
        ("SPEED", "' a remark\nSPEED", []),
        ("WAIT(100)", "' a remark\nWAIT(150)", [(6, 7, 0.05)]),
        ("WAIT(100)\n", "", [(6, None, -0.1)]),
        ("WAIT(100)\n", "WAIT(100)\nWAIT(20)\n", [(None, 7, 0.02)]),
        ("100, 40", "200, 40", [(4, 4, 1.0)]),
    ],
)
def test_it_is_the_line_that_the_run_waited_for(
    was: str, is_: str, expected: list[tuple[int | None, int | None, float]]
) -> None:
    assert was in PROGRAM
    found = charges(PROGRAM.replace(was, is_))
    assert [each for each in found if abs(each[2]) > 1e-3] == expected


def test_a_line_of_one_program_has_no_time_in_the_other() -> None:
    """The first line waits 30 ms in both programs, which is no time of the last line."""
    old, new = ran("WAIT(30)\nWAIT(100)\n"), ran("WAIT(30)\n")
    for pair, line, seconds in (((old, new), (2, None), -0.1), ((new, old), (None, 2), 0.1)):
        (found,) = [each for each in charged(*pair) if abs(each.seconds) > 1e-3]
        assert (found.old, found.new) == line
        assert found.seconds == pytest.approx(seconds, abs=1e-3)


def test_motion_after_the_end_of_the_program_is_time_of_its_line() -> None:
    """At 100 uu/s, 100 uu more take 1 s more."""
    old, new = (ran(f"SPEED = 100 : ACCEL = 1000\nMOVER(0) = {way} : GO(0)\n") for way in (100, 200))
    for pair, seconds in (((old, new), 1.0), ((new, old), -1.0)):
        assert [(each.old, each.new, round(each.seconds, 6)) for each in charged(*pair)] == [(2, 2, seconds)]


def test_together_they_are_the_whole_difference() -> None:
    old, new = ran(PROGRAM), ran(PROGRAM.replace("100, 40", "90, 140").replace("WAIT(100)", "WAIT(150)"))
    found = charged(old, new)
    assert fsum(each.seconds for each in found) == pytest.approx(new.time - old.time, abs=1e-12)
    assert found[0].old == 4
    assert found[0].seconds == pytest.approx(0.4, abs=1e-4)


def test_new_and_deleted_lines_are_reported_as_such_and_many_together() -> None:
    old, new = ran(PROGRAM), ran(PROGRAM.replace("WAIT(100)\n", ""))
    found = difference(build(old), build(new))
    charges = [Charge(6, None, -0.1), Charge(None, 7, 0.02), Charge(4, 5, 0.01), Charge(0, 0, 0.003),
               Charge(1, 1, 0.002), Charge(2, 2, 0.001)]  # fmt: skip
    assert diff_lines(found, None, charges)[1] == (
        "by line: line 6 (missing) -0.100000 s, line 7 (new) +0.020000 s, line 4 (now 5) +0.010000 s, "
        "no line +0.003000 s, 2 more +0.003000 s"
    )
