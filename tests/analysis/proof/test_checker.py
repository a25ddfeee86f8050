"""The results of a proof and its lookups, by hand: bounds, offsets, entries."""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.analysis.proof.checker import (
    Offsets,
    Proof,
    Uses,
    _at_instant,
    _continued_by,
    _end,
    position,
    travelled,
)
from motionlang.planners import Profile, hold, plan_trapezoid, plan_velocity

# 10 counts in 1 s: a triangle of 40 counts/s². 40 counts in 4 s: a triangle of 10 counts/s².
SHORT = plan_trapezoid(0.0, 10.0, 50.0, 40.0, 40.0)
LONG = plan_trapezoid(0.0, 40.0, 50.0, 10.0, 10.0)
JOG = plan_velocity("trapezoid", 0.0, 0.0, 10.0, 40.0, 40.0)


def entry(start: float, profile: Profile | None, line: int = 1) -> Any:
    return SimpleNamespace(start_time=start, profile=profile, line=line)


@pytest.mark.parametrize(
    ("figure", "bound", "share"),
    [
        (5.0, 10.0, 0.5),
        (10.0, 10.0, 1.0),
        (10.000009, 10.0, 1.0000009),
        (10.00002, 10.0, None),
        (1e9, inf, 0.0),
        (0.0, 0.0, 0.0),
        (1e-6, 0.0, 0.0),
        (2e-6, 0.0, None),
    ],
)
def test_a_bound_may_be_used_up_to_a_millionth_more(figure: float, bound: float, share: float | None) -> None:
    proof = Proof()
    assert proof.uses("speed", figure, bound) is (share is not None)
    assert proof.worst == ({"speed": pytest.approx(share)} if share else {})


def test_the_totals_of_a_proof() -> None:
    """Each name has its largest share; what has no limit has none."""
    proof = Proof()
    assert proof.lines() == ["proof: moves 0, profiles 0, joins 0, paths 0; no violations"]
    for name, figure in (("speed", 5.0), ("speed", 7.5), ("speed", 2.5), ("jerk", 1.0)):
        assert proof.uses(name, figure, 10.0)
    proof.excuses("step")
    proof.excuses("step")
    assert proof.holds
    proof.breaks(3, "it is off")
    assert not proof.holds
    proof.counts["moves"] = 4
    assert proof.lines() == [
        "proof: moves 4, profiles 0, joins 0, paths 0; 1 violation",
        "  jerk: 0.100000000 of the limit",
        "  speed: 0.750000000 of the limit",
        "  ordered: step, 2 x",
    ]
    proof.breaks(3, "it is off")
    assert proof.lines()[0].endswith("; 2 violations")


def test_each_bound_that_is_exceeded_is_reported_once_at_its_worst() -> None:
    proof = Proof()
    uses = Uses(proof)
    for name, figure, bound in (
        ("speed of axis 0", 11.0, 10.0), ("speed of axis 0", 13.0, 10.0), ("speed of axis 0", 12.0, 10.0),
        ("speed of axis 1", 21.0, 20.0), ("speed of axis 1", 19.0, 20.0), ("rate", 8.0, 16.0),
    ):  # fmt: skip
        uses.compare(name, figure, bound)
    uses.report(7, "here", " counts")
    assert [(each.line, each.message) for each in proof.violations] == [
        (7, "here: the speed of axis 0 reaches 13 counts, above 10"),
        (7, "here: the speed of axis 1 reaches 21 counts, above 20"),
    ]
    assert proof.worst == {"speed": 0.95, "rate": 0.5}


# Offsets by their begins and profiles, and by time their distance and whether one is in progress.
OFFSETS: dict[str, tuple[list[tuple[float, Profile | None]], dict[float, tuple[float, bool]]]] = {
    "none": ([], {0.0: (0.0, False)}),
    "one without a profile": ([(0.0, None)], {0.0: (0.0, False), 0.5: (0.0, False)}),
    "one": (
        [(1.0, SHORT)],
        {0.5: (0.0, False), 1.0: (0.0, True), 1.25: (1.25, True), 1.5: (5.0, True), 2.0: (10.0, False)},
    ),
    "two that overlap, and a later one": (
        [(0.0, SHORT), (0.5, SHORT), (3.0, SHORT)],
        {
            0.25: (1.25, True), 0.5: (5.0, True), 0.75: (10.0, True), 1.0: (15.0, True), 1.5: (20.0, False),
            3.0: (20.0, True), 3.5: (25.0, True), 9.0: (30.0, False),
        },
    ),
    "a short one within a long one": (
        [(0.0, LONG), (1.0, SHORT), (8.0, SHORT)],
        {1.0: (5.0, True), 2.0: (30.0, True), 3.0: (45.0, True), 4.0: (50.0, False), 8.5: (55.0, True)},
    ),
    "one without an end": ([(0.0, JOG), (1.0, SHORT)], {1.0: (8.75, True), 3.0: (38.75, True)}),
}  # fmt: skip


@pytest.mark.parametrize("name", OFFSETS)
def test_the_offsets_of_an_axis_add_up(name: str) -> None:
    """The jog speeds up in 0.25 s, over 1.25 counts, so it is 1.25 behind 10 counts/s."""
    entries, expected = OFFSETS[name]
    offsets = Offsets()
    for each in entries:
        offsets.add(entry(*each))
    for time, (distance, active) in expected.items():
        assert offsets.travelled(time) == pytest.approx(distance, abs=1e-9)
        assert offsets.is_active_at(time) is active
    begins = [start for start, profile in entries if profile is not None]
    assert all(offsets.begin_at(time) for time in begins)
    assert not any(offsets.begin_at(time) for time in (0.25, 99.0))


@pytest.mark.parametrize(
    ("time", "found"), [(2.0, (0.0, -10.0)), (2.25, (1.25, -8.75)), (3.0, (10.0, 0.0)), (9.0, (10.0, 0.0))]
)
def test_the_distance_of_an_entry_and_what_is_left(time: float, found: tuple[float, float]) -> None:
    assert travelled(entry(2.0, SHORT.shifted(7.0)), time) == pytest.approx(found)


def test_an_entry_ends_after_its_profile() -> None:
    assert [_end(entry(2.0, SHORT)), _end(entry(2.0, None))] == [3.0, 2.0]


@pytest.mark.parametrize(
    ("line", "start", "number"),
    [
        (1, 3.0, 0),
        (2, 3.0, 1),
        (3, 3.0, None),
        (1, 3.0 + 6e-15, 0),  # 16 roundings of 4 s are 6.4e-15 s
        (1, 3.0 - 6e-15, 0),
        (1, 3.0 + 8e-15, None),
        (1, 3.0 - 8e-15, None),
    ],
)
def test_an_entry_continues_the_one_of_its_line_that_ends_where_it_begins(
    line: int, start: float, number: int | None
) -> None:
    full = [entry(2.0, SHORT, 1), entry(2.0, SHORT, 2)]
    found = _continued_by(entry(start, SHORT, line), full)
    assert found is (None if number is None else full[number])


def test_several_profiles_may_begin_at_one_time() -> None:
    """At 1 s the axis is given the positions 20, 30 and 40; before, it was at 10."""
    track: Any = SimpleNamespace(
        starts=[0.0, 1.0, 1.0, 1.0],
        profiles=[SHORT, hold(20.0), hold(30.0), hold(40.0)],
        index_at=lambda time: 3 if time >= 1.0 else 0,
    )
    stated = [(21.0, 20.0), (31.0, 30.0), (99.0, 40.0), (24.9, 20.0), (25.1, 30.0), (0.0, 20.0)]
    assert [_at_instant(track, 1.0, each, 40.0) for each, _ in stated] == [found for _, found in stated]
    assert _at_instant(track, 0.5, 3.0, 5.0) == 5.0
    assert [position(track, time) for time in (0.5, 1.0, 2.0)] == [5.0, 40.0, 40.0]
    assert [position(track, time, ending=True) for time in (0.5, 1.0, 2.0)] == [5.0, 10.0, 40.0]
