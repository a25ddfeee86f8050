"""Accepting changes one by one: the report then differs only by the others."""

from __future__ import annotations

import json
from itertools import chain, combinations

import pytest

from motionlang.commands.diff.accept import Change, changes, merged
from motionlang.commands.diff.reports import difference
from motionlang.commands.diff.timeline import Timeline
from motionlang.commands.diff.view import change_lines
from motionlang.kernel import Source, run
from motionlang.kernel.report import rendered, text
from tests.commands.diff.test_reports import CYCLE as REPORTS_CYCLE

# The iterations of the other tests, printed without the time, then a move that is stopped.
CYCLE = REPORTS_CYCLE.replace(', " after ", TIME', "") + (
    "MOVEA(0) = 400 : GO(0) : WAIT(300) : STOP(0) : PAUSE IDLE(0)\nWAIT(50)\n"
)
EDITS = {
    "rate": [("ACCEL(0, 1) = 1000;", "ACCEL(0, 1) = 1000, 2000")],
    "wait": [("WAIT(100)", "WAIT(130)")],
    "end": [("WAIT(50)", "WAIT(80)"), ("ACCEL(0, 1) = 1000;", "ACCEL(0, 1) = 1000, 2000")],
    "turn": [("To 3", "To 4")],
    "fewer": [("To 3", "To 2"), ("WAIT(50)", "WAIT(40)")],
    "way": [("MOVEA(1) = 50", "MOVEA(1) = 60"), ('"turn "', '"part "')],
    "stop": [("WAIT(300)", "WAIT(320)")],
    "word": [('PRINT "turn ", n', "PRINT n"), ("WAIT(100)", "WAIT(90)")],
}


def report(program: str) -> dict[str, object]:
    found: dict[str, object] = json.loads(text(run(Source("c.mnt", program)), whole=False))
    return found


@pytest.mark.parametrize("edit", EDITS)
def test_a_rejected_change_is_the_only_difference_left(edit: str) -> None:
    program = CYCLE
    for was, is_ in EDITS[edit]:
        assert was in program
        program = program.replace(was, is_)
    old, new = report(CYCLE), report(program)
    found = difference(old, new)
    every = changes(found)
    assert every
    for some in chain.from_iterable(combinations(every, n) for n in range(min(len(every), 7) + 1)):
        made = json.loads(rendered(merged(old, new, found, some)))
        left, done = difference(made, new), difference(old, made)
        assert kinds(changes(left)) == kinds([each for each in every if each not in some]), (
            edit,
            kinds(some),
        )
        assert kinds(changes(done)) == kinds(some), (edit, kinds(some))
        again = merged(made, new, left, changes(left))
        assert difference(again, new).same
    assert difference(merged(old, new, found, every), new).same
    assert difference(old, merged(old, new, found, [])).same


RATES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
# Both runs of a pair take equally long: the wait after the motion makes up for its duration.
AS_LONG = {
    "another distance": ("MOVER(0) = 1 : GO(0)\nWAIT = 500", "MOVER(0) = 2 : GO(0)\nWAIT = 500"),
    "a later stop": (
        "MOVEA(0) = 50 : GO(0)\nWAIT = 10\nSTOP(0)\nWAIT = 100\nABORT",
        "MOVEA(0) = 50 : GO(0)\nWAIT = 60\nSTOP(0)\nWAIT = 50\nABORT",
    ),
    "a timer that goes on": (
        "TIMEREVENT = 100\nWAIT = 1\nMOVER(0) = 1 : GO(0)\nWAIT = 499\nEnd\nEvent TIMER\nEnd Event",
        "TIMEREVENT = 100\nWAIT = 2\nMOVER(0) = 1 : GO(0)\nWAIT = 498\nEnd\nEvent TIMER\nEnd Event",
    ),
}


@pytest.mark.parametrize("back", [False, True])
@pytest.mark.parametrize("pair", AS_LONG)
def test_all_changes_make_the_new_report_and_none_the_old(pair: str, back: bool) -> None:
    old, new = (report(RATES + each + "\n") for each in AS_LONG[pair][:: -1 if back else 1])
    found = difference(old, new)
    assert found.time is None
    assert difference(merged(old, new, found, changes(found)), new).same
    assert difference(old, merged(old, new, found, [])).same


def kinds(found: object) -> list[str]:
    return sorted(change.kind for change in found)  # type: ignore[attr-defined]


def test_a_report_that_is_there_as_data_is_written_in_the_same_form() -> None:
    ran = run(Source("c.mnt", CYCLE))
    for whole in (True, False):
        assert rendered(json.loads(text(ran, whole=whole))) == text(ran, whole=whole)


def test_each_change_is_reported_by_itself() -> None:
    old, new = report(CYCLE), report(CYCLE.replace("To 3", "To 4"))
    found = difference(old, new)
    every: list[Change] = changes(found)
    assert [each.kind for each in every] == ["moves", "print", "field"][: len(every)]
    assert change_lines(found, every[0])[0].startswith("new: line 6: MOVEA of axis 0 by 100 uu at ")
    assert len(change_lines(found, every[0])) == 4


@pytest.mark.parametrize(("accepted", "begin"), [(True, 0.25), (False, 0.5)])
def test_a_merged_run_without_moves_begins_at_0(accepted: bool, begin: float) -> None:
    """It waits as long as one of the runs after its last move, which it does not have.

    The old move ends at 2 s, 0.5 s before the end; the new one at 3 s, 0.25 s before the end.
    """
    line = Timeline()
    line.alone({"start_time": 0.0, "duration": 2.0}, 0, False)
    line.alone({"start_time": 0.0, "duration": 3.0}, 1, False)
    ends = [{"start_time": time, "duration": 0.0} for time in (2.5, 3.25)]
    assert line.pair(ends[0], ends[1], accepted=accepted) == (-0.25, begin)
