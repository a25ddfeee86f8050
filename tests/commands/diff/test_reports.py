"""The differences of two runs: time, lines, prints, and divergence of motion."""

from __future__ import annotations

import re

import pytest

from motionlang.commands.diff.motion import divergence
from motionlang.commands.diff.reports import Difference, checked, difference
from motionlang.commands.diff.tolerance import Tolerance
from motionlang.commands.diff.view import diff_lines
from motionlang.kernel import Run, Source, run
from motionlang.kernel.report import build

CYCLE = """\
Dim n
SPEED(0, 1) = 200;
ACCEL(0, 1) = 1000;
DECEL(0, 1) = 1000;
For n = 1 To 3
  MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)
  WAIT(100)
  MOVEA(1) = 50 : GO(1) : PAUSE IDLE(1)
  MOVEA(0, 1) = 0; : GO(0, 1) : PAUSE IDLE(0) And IDLE(1)
  PRINT "turn ", n, " after ", TIME
Next
"""


def ran(text: str) -> Run:
    return run(Source("cycle.mnt", text))


def changed(
    *replaced: tuple[str, str], tolerance: Tolerance | None = None
) -> tuple[Difference, list[str], Run, Run]:
    text = CYCLE
    for old, new in replaced:
        assert old in text
        text = text.replace(old, new)
    old_run, new_run = ran(CYCLE), ran(text)
    found = difference(build(old_run), build(new_run), tolerance or Tolerance())
    return found, diff_lines(found), old_run, new_run


def test_a_line_that_is_put_in_somewhere_is_no_difference() -> None:
    found, lines, old, new = changed(("For n", "' a remark\n\nFor n"))
    assert found.same
    assert lines == []
    assert found.moved == {6: 8, 8: 10, 9: 11}
    assert divergence(old, new) is None


def test_a_changed_rate_is_reported_once_a_line_with_all_its_moves() -> None:
    found, lines, old, new = changed(("ACCEL(0, 1) = 1000;", "ACCEL(0, 1) = 1000, 2000"))
    # By hand: axis 1 is up to 200 in 0.1 s instead of 0.2 s; its distance of 50 is 10 + 0.15 s * 200 + 20
    # then … shorter.
    (change,) = (each for each in found.lines if each.old == 8)
    assert (change.count, change.axis, change.command) == (3, 1, "MOVEA")
    assert change.figures["accel"][0] == pytest.approx(0.2)
    assert change.figures["accel"][1] == pytest.approx(0.1)
    assert change.wait == 0.0
    assert found.removed == found.new == []
    assert found.time is not None
    assert found.time[1] - found.time[0] == pytest.approx(change.duration, abs=1e-6)
    assert lines[0].startswith("time: ")
    assert re.match(r"line 8: MOVEA of axis 1, 3 moves: duration 0.45 → 0.4 s, accel 0.2 → 0.1 s, ", lines[1])
    diverged = divergence(old, new)
    assert diverged is not None
    assert diverged.axis == 1
    assert diverged.time == pytest.approx(old.controller.log.moves[1].start_time, abs=1e-4)


def test_a_path_segment_is_reported_once_with_its_axes_and_the_difference_of_one() -> None:
    path = "SPEED(0) = 50 : ACCEL(0) = {} : DECEL(0) = 500\nVECTORR(0, 1) = 30, 40 : VECTORR(0, 1) = 0, 10\nGO(0)\n"
    found = difference(build(ran(path.format(500))), build(ran(path.format(400))))
    # By hand: 50/500 = 0.1 s becomes 50/400 = 0.125 s: half of that is added to each segment. Axis 0 holds on the last.
    assert [line for line in diff_lines(found) if line.startswith("line")] == [
        "line 2: VECTORR of axes 0, 1, 2 moves each: duration 1.1 → 1.1125 s, accel 0.1 → 0.125 s, "
        "slew 0.9 → 0.8875 s, axis 0 hold 0.3 → 0.3125 s, +0.025000 s in motion together"
    ]
    one = "SPEED(0, 1) = 50; : ACCEL(0, 1) = {}, 500 : DECEL(0, 1) = 500; : MOVER(0, 1) = 50; : GO(0, 1)\n"
    found = difference(build(ran(one.format(500))), build(ran(one.format(400))))
    assert [line for line in diff_lines(found) if line.startswith("line")] == [
        "line 1: MOVER of axis 0, 1 move: duration 1.1 → 1.1125 s, accel 0.1 → 0.125 s, slew 0.9 → 0.8875 s, "
        "+0.012500 s in motion"
    ]


def test_a_changed_wait_is_reported_only_at_the_line_that_comes_later() -> None:
    found, lines, _, _ = changed(("WAIT(100)", "WAIT(130)"))
    assert [(each.old, each.count, each.figures) for each in found.lines] == [(8, 3, {})]
    assert found.lines[0].wait == pytest.approx(0.09)
    assert "line 8: MOVEA of axis 1, 3 moves: +0.090000 s before it together" in lines


def test_one_more_iteration_is_new_moves_and_prints() -> None:
    found, lines, _, _ = changed(("To 3", "To 4"))
    assert (found.lines, found.removed, len(found.new)) == ([], [], 4)
    assert found.prints == [(None, 4, "", found.prints[0][3])]
    assert any(
        line.startswith("new: printed line 4, 'turn 4.0000 after ") or "turn 4" in line for line in lines
    )


def test_a_deletion_is_reported_at_its_line() -> None:
    """Two equal loops on two lines: the first loses an iteration, one gets slower."""
    loop = "For n = 1 To 3\n  MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)\n  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\nNext\n"
    head = "Dim n\nSPEED(0) = 200 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
    less = loop.replace("To 3", "To 2")
    was, is_ = (build(ran(head + first + "WAIT(100)\n" + loop)) for first in (loop, less))
    found = difference(was, is_)
    assert [(each["line"], each["start_time"] < 5.0) for each in found.removed] == [(4, True), (5, True)]
    assert (found.lines, found.new) == ([], [])
    slow = "SPEED(0) = 50\nMOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)\nMOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\n"
    old = head + less + slow + "SPEED(0) = 200\n" + less
    was, is_ = (build(ran(text)) for text in (old, old.replace(slow, "")))
    found = difference(was, is_)
    assert [each["peak_speed"] for each in found.removed] == [50.0, 50.0]
    assert all(not each.figures for each in found.lines)


def test_events_are_aligned_by_what_happened() -> None:
    """An additional stop, a stop at another speed, and one shifted by earlier motion."""
    text = (
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVEA(0) = 20 : GO(0) : PAUSE IDLE(0)\n"
        "JOG(0) = 50 : WAIT(500) : STOP(0) : PAUSE IDLE(0)\n"
    )
    stop = "JOG(0) = 80 : WAIT(500) : STOP(0) : PAUSE IDLE(0)\n"
    found = difference(build(ran(text)), build(ran(text + stop)))
    ((was, is_, _),) = found.events
    assert (was, is_ and is_["kind"]) == (None, "stop")
    found = difference(build(ran(text)), build(ran(text.replace("= 50 :", "= 60 :"))))
    ((was, is_, later),) = found.events
    assert (was and was["value"], is_ and is_["value"], later) == (50.0, 60.0, 0.0)
    found = difference(build(ran(text)), build(ran(text.replace("MOVEA(0) = 20", "MOVEA(0) = 30"))))
    assert (len(found.lines) > 0, found.events) == (True, [])
    found = difference(build(ran(text)), build(ran(text.replace("WAIT(500)", "WAIT(600)"))))
    ((_, _, later),) = found.events
    assert later == pytest.approx(0.1)
    assert "event stop of axis 0, line 3, at 0.8" in "\n".join(diff_lines(found))


def test_another_distance_and_another_text() -> None:
    found, lines, _, _ = changed(("MOVEA(1) = 50", "MOVEA(1) = 60"), ('"turn "', '"part "'))
    assert {(each.old, each.axis) for each in found.lines} == {(8, 1), (9, 1)}
    assert len(found.prints) == 6 or len(found.prints) == 3
    assert found.removed == found.new == []
    assert any("distance 50 → 60 uu" in line for line in lines)


def test_tubes_with_units() -> None:
    change = ("SPEED(0, 1) = 200;", "SPEED(0, 1) = 200.1;")
    assert not changed(change)[0].same
    found = changed(change, tolerance=Tolerance("time=5ms", "position=0.1uu", "speed=0.1%"))[0]
    assert (found.time, found.lines) == (None, [])
    for wrong in ("time", "time=1h", "tide=1s", "time=-1s", "speed=x%", "position=1", "time=e s"):
        with pytest.raises(ValueError, match=r"tolerance|number"):
            Tolerance(wrong)


def test_a_program_that_no_longer_runs() -> None:
    found, lines, _, _ = changed(("SPEED(0, 1) = 200;", "SPED(0, 1) = 200;"))
    assert found.status == ("ended", "fault")
    assert len(found.removed) == 12
    assert lines[0] == "the run: ended → fault"
    assert any(line.startswith("new: error[unknown-word]: ") for line in lines)


# A move of 4.9 with 1000 peaks at sqrt(1000 * 4.9) = 70.
SHORT = "SPEED(0) = 90\nACCEL(0) = 1000\nDECEL(0) = 1000\nMOVER(0) = 4.9 : GO(0)\nPAUSE IDLE(0)\n"
ONLY_COMMANDED = [
    "line 4: MOVER of axis 0, 1 move: commanded speed 90 → 99 uu/s",
    "only the commanded speed differs, the motion does not",
]


def test_a_speed_that_no_move_reaches_is_commanded_and_no_motion() -> None:
    old, new = ran(SHORT), ran(SHORT.replace("90", "99"))
    found = difference(build(old), build(new))
    assert divergence(old, new) is None
    assert found.first is None
    assert diff_lines(found, divergence(old, new)) == ONLY_COMMANDED
    assert diff_lines(found) == ONLY_COMMANDED  # two reports without their runs


def test_motion_that_differs_elsewhere_is_first_there() -> None:
    """The second move begins at 0.5 s and ends 1 uu further.

    The first move differs only in its command.
    """
    text = SHORT + "PAUSE TIME >= 500\nMOVER(0) = 1 : GO(0)\nPAUSE IDLE(0)\n"
    found = difference(build(ran(text)), build(ran(text.replace("90", "99").replace("= 1 :", "= 2 :"))))
    assert found.first is not None
    assert found.first[0] == pytest.approx(0.5, abs=1e-4)
    assert not found.is_commanded


@pytest.mark.parametrize("event", [{"time": 1.0}, {"kind": "stop"}, {}, None])
def test_an_event_without_kind_or_time_is_no_event_of_a_report(event: object) -> None:
    report = {"schema": "motionlang.report/2", "events": [{"kind": "stop", "time": 0.5}, event]}
    with pytest.raises(ValueError, match="its event 1 has no kind or time"):
        checked(report)
