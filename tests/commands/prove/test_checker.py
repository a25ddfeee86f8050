"""The results of a proof and its lookups, by hand: bounds, offsets, entries."""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.prove.checker import (
    Offsets,
    Proof,
    Run,
    Uses,
    _at_instant,
    _continued_by,
    _end,
    position,
    travelled,
)
from motionlang.commands.prove.order import Order, PathOrder
from motionlang.kernel.log import CONTINUED
from motionlang.kernel.planners import Profile, hold, plan_trapezoid, plan_velocity

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


REST = Order("rest", 0)


def ordered(begun: float, number: int) -> Order:
    """Return the order of a path of one axis with the log entry of that number."""
    free = (inf,)
    path = PathOrder(
        (0,), (1.0,), begun, 0, True, (10.0,), (0.0, 0.0), 0.0, (), (0, 1), None, free, free, free, 0.0,
        entry=number,
    )  # fmt: skip
    return Order("path", number, path=path)


def logged(start: float, profile: Profile, line: int, **fields: object) -> Any:
    given = {"overlaid": False, "axis": 0, "ended": "", "offset": 0.0, **fields}
    return SimpleNamespace(start_time=start, profile=profile, line=line, **given)


def joined(starts: list[float], profiles: list[Profile]) -> Any:
    """Return the track of axis 0."""
    return SimpleNamespace(
        index=0,
        starts=starts,
        profiles=profiles,
        index_at=lambda time: max([k for k, start in enumerate(starts) if start <= time], default=0),
    )


# A move, a path and another one that begins 0.25 s before its end, a move, and a path in two entries. The zero has
# moved by 3 during the first of these, and an offset is on top of the second one.
FIRST = logged(0.0, SHORT, 1)
ONE, TWO = logged(1.0, SHORT, 2), logged(1.75, SHORT.shifted(10.0), 3)
BETWEEN = logged(4.0, SHORT, 4)
FULL = logged(6.0, SHORT.shifted(7.0), 5, ended=CONTINUED, offset=3.0)
REST_OF_IT = logged(7.0, SHORT.shifted(20.0), 5)
ON_TOP = logged(7.0, SHORT, 6, overlaid=True)
LOG = [FIRST, ONE, TWO, BETWEEN, FULL, REST_OF_IT, ON_TOP]
TRACK = joined(
    [0.0, 1.0, 1.75, 2.0, 4.0, 6.0, 7.0],
    [SHORT, SHORT, SHORT.shifted(8.75), SHORT.shifted(10.0), SHORT, SHORT.shifted(7.0), SHORT.shifted(20.0)],
)
ORDERS = [REST, ordered(1.0, 1), ordered(1.75, 2), ordered(1.75, 2), REST, ordered(6.0, 4), ordered(6.0, 4)]


@pytest.fixture
def run() -> Run:
    expected: Any = SimpleNamespace(
        of={0: ORDERS}, offsets={(0, 7.0): (6, 10.0), (1, 6.5): (6, 10.0)}, begun={0: {0.0, 1.0, 4.0, 6.0}}
    )
    return Run({0: TRACK}, LOG, expected, 7.5)


def test_the_entries_of_paths_in_a_log(run: Run) -> None:
    assert [run.rest_of(each) for each in LOG] == [None, None, None, None, None, FULL, None]
    assert [run.is_continued(each) for each in LOG] == [False, False, False, False, True, False, False]
    assert list(run.moves) == LOG
    assert run.offsets[0].travelled(7.5) == 5.0


def test_a_path_in_two_entries_began_with_the_first(run: Run) -> None:
    """It began at 7; its zero has moved by 3 since, so that is at 10."""
    order = run.order_of(REST_OF_IT)
    assert order.path is not None
    assert (order.path.begun, order.path.entry, order.line) == (7.0, 5, 4)
    assert run.members(order.path) == [REST_OF_IT]
    assert run.origins(order.path) == [10.0]
    first = run.order_of(FULL).path
    assert first is not None
    assert (run.members(first), run.origins(first)) == ([FULL], [7.0])
    assert run.members(first._replace(nth=1)) == []
    assert [run.order_of(each) for each in (FIRST, ONE, TWO, BETWEEN)] == [REST, ORDERS[1], ORDERS[2], REST]


def test_the_order_of_a_move_is_that_before_a_path_that_begins_at_the_same_time() -> None:
    expected: Any = SimpleNamespace(
        of={0: [REST, ordered(1.0, 1), ordered(1.0, 1)]}, offsets={}, begun={0: ()}
    )
    moves = [logged(1.0, SHORT, 1), logged(1.0, SHORT, 2)]
    made = Run({0: joined([0.0, 1.0, 1.0], [SHORT] * 3)}, moves, expected, 9.0)
    assert made.order_of(moves[0]) is REST


def test_a_profile_is_in_force_until_the_next_or_its_own_end(run: Run) -> None:
    spans = [run.span(TRACK, index) for index in (0, 1, 5, 6)]
    assert spans == [(0.0, 1.0), (1.0, 1.75), (6.0, 7.0), (7.0, 7.5)]
    run.until = 99.0
    assert run.span(TRACK, 6) == (7.0, 8.0)


@pytest.mark.parametrize(
    ("time", "begins"),
    [(-1.0, [0.0]), (0.0, [0.0]), (0.5, [0.0, 1.0]), (1.0, [0.0, 1.0]), (6.5, [6.0, 7.0]), (9.0, [7.0])],
)
def test_the_times_next_to_a_time_at_which_motion_began(run: Run, time: float, begins: list[float]) -> None:
    """The offset of axis 0 begins at 7 s, that of another axis at 6.5 s."""
    assert run.begins_near(0, time) == begins


def test_the_position_of_an_entry_leaves_out_the_other_paths(run: Run) -> None:
    """At 1.75 s the first path has 1.25 left, at 1.875 s 0.3125, and at 2 s none.

    The second one has travelled 0.3125 at 1.875 s, 1.25 at 2 s and 8.75 at 2.5 s.
    """
    expected = {
        1.5: (5.0, 10.0),
        1.75: (8.75, 10.0),
        1.875: (9.0625 - 0.3125, 9.0625 + 0.3125),
        2.0: (10.0 - 1.25, 10.0),
        2.5: (15.0 - 8.75, 15.0),
    }
    for time, (first, second) in expected.items():
        assert run.logged(TRACK, ONE, time, False) == pytest.approx(first)
        assert run.logged(TRACK, TWO, time, False) == pytest.approx(second)
    assert run.logged(TRACK, FIRST, 0.5, False) == 5.0
