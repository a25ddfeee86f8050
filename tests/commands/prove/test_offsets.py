"""Entries of offsets, compared with what was commanded."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.prove.checker import Offsets, Proof
from motionlang.commands.prove.offsets import check_missing, check_offset
from motionlang.kernel.planners import plan_trapezoid

# An offset of 10 counts, commanded by line 5, from 2 s to 3 s: a triangle of 40 counts/s². The axis has 4 counts
# per unit. The offset before it was 6 counts, commanded at 1 s, and had travelled 4 of them by 2 s.
SHORT = plan_trapezoid(0.0, 10.0, 50.0, 40.0, 40.0)
CUT = plan_trapezoid(0.0, 4.0, 50.0, 16.0, 16.0)


def entry(profile: Any = SHORT, **fields: object) -> Any:
    given = {"start_time": 2.0, "axis": 1, "line": 5, "ended": "", "scale": 4.0, "zero": 0.0, **fields}
    return SimpleNamespace(profile=profile, **given)


BEFORE = entry(CUT, start_time=1.0, ended="retarget")
# The entry, what differs in the run, and the violations.
CASES: dict[str, tuple[Any, dict[str, Any], tuple[str, ...]]] = {
    "as commanded": (entry(), {}, ()),
    "from elsewhere": (
        entry(SHORT.shifted(3.0)), {},
        ("it is superposed on other motion but begins at 3", "it moves 13 counts, commanded 10"),
    ),
    "from elsewhere by rounding": (entry(SHORT.shifted(1e-6)), {}, ()),
    "another scale": (entry(scale=5.0), {}, ("it has 5 counts per unit, unlike its axis",)),
    "another scale at the same time": (entry(scale=5.0), {"scales": {(4.0, 0.0), (5.0, 0.0)}}, ()),
    "no scale is known": (entry(scale=5.0), {"scales": set()}, ()),
    "another zero": (entry(zero=1.0), {}, ("it has 4 counts per unit, unlike its axis",)),
    "another line": (entry(line=6), {}, ("it is commanded by line 5",)),
    "not commanded, as it was resumed": (entry(line=6), {"wanted": None}, ()),
    "too far": (entry(), {"wanted": 9.0}, ("it moves 10 counts, commanded 9",)),
    "too far by a millionth": (entry(), {"wanted": 10.0 - 9e-6}, ()),
    "too far by more": (entry(), {"wanted": 10.0 - 1.1e-5}, ("it moves 10 counts, commanded 9.99999",)),
    "still in progress": (entry(), {"wanted": 9.0, "until": 2.9}, ()),
    "over at the end of the run": (
        entry(), {"wanted": 9.0, "until": 3.0}, ("it moves 10 counts, commanded 9",),
    ),
    "with what was left of the one before": (entry(), {"wanted": 8.0, "before": BEFORE}, ()),
    "without what was left": (
        entry(), {"wanted": 10.0, "before": BEFORE}, ("it moves 10 counts, commanded 12",),
    ),
    "the one before was stopped": (
        entry(), {"wanted": 10.0, "before": entry(CUT, start_time=1.0, ended="stop")}, (),
    ),
    "the one before ended earlier": (
        entry(), {"wanted": 10.0, "before": entry(CUT, start_time=0.5, ended="retarget")}, (),
    ),
    "other following begins": (entry(), {"wanted": 10.0, "before": BEFORE, "begun": {2.0}}, ()),
    "stopped as commanded": (entry(ended="stop"), {"wanted": 12.0, "stops": [(3.0, "stop")]}, ()),
    "stopped by another keyword": (
        entry(ended="cancel"), {"wanted": 12.0, "stops": [(3.0, "stop")]},
        ("it is logged as ended by a cancel that was not commanded",),
    ),
    "stopped short by what it follows": (entry(ended="stop"), {"wanted": 12.0}, ()),
    "stopped at its end": (
        entry(ended="stop"), {}, ("it is logged as ended by a stop that was not commanded",),
    ),
    "stopped after the run": (entry(ended="stop"), {"until": 2.9}, ()),
    "replaced by another one": (entry(ended="retarget"), {"wanted": 12.0, "near": [3.0]}, ()),
    "replaced by none": (
        entry(ended="retarget"), {"wanted": 12.0, "near": [2.0]},
        ("it is logged as ended by a retarget that was not commanded",),
    ),
    "replaced at its end": (
        entry(ended="retarget"), {"near": [3.0]}, ("it is logged as ended by a retarget that was not commanded",),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_an_offset_moves_as_far_as_commanded_and_what_was_left(name: str) -> None:
    move, given, messages = CASES[name]
    wanted, before = given.get("wanted", 10.0), given.get("before")
    expected: Any = SimpleNamespace(
        scale=lambda axis, time: given.get("scales", {(4.0, 7.0)}),
        offsets={} if wanted is None else {(1, 2.0): (5, wanted)},
        begun={1: given.get("begun", set())},
        stopped=lambda axis, first, last: [
            stop for stop in given.get("stops", []) if first <= stop[0] <= last
        ],
    )
    run: Any = SimpleNamespace(
        expected_motion=expected,
        until=given.get("until", 9.0),
        offset_goals={} if before is None else {1: (before, 6.0)},
        begins_near=lambda axis, time: given.get("near", []),
    )
    proof = Proof()
    check_offset(proof, run, move, move.profile)
    where = "axis 1 from 2.000000 s: "
    assert [each.message for each in proof.violations] == [where + message for message in messages]


@pytest.mark.parametrize(
    ("distance", "start", "was_cut", "missing"),
    [
        (10.0, 2.0, False, False),
        (10.0, 2.5, False, True),
        (10.0, None, False, True),
        (10.0, None, True, False),
        (0.0, None, False, False),
    ],
)
def test_an_offset_without_an_entry_is_found(
    distance: float, start: float | None, was_cut: bool, missing: bool
) -> None:
    offsets = Offsets()
    if start is not None:
        offsets.add(entry(start_time=start))
    expected = SimpleNamespace(was_cut=was_cut, offsets={(1, 2.0): (5, distance)})
    run: Any = SimpleNamespace(expected_motion=expected, offsets={} if start is None else {1: offsets})
    proof = Proof()
    check_missing(proof, run)
    message = "axis 1 at 2.000000 s: its offset of 10 counts does not begin"
    assert [(each.line, each.message) for each in proof.violations] == [(5, message)] * missing
