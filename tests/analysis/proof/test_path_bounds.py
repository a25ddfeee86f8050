"""Bounds of paths, each computed by hand from orders and segments of motion.

Unless stated otherwise a path is a line of one axis over 100 counts at 10 counts/s and 10 counts/s², which stops
over 5 counts.
"""

from __future__ import annotations

from math import inf, sqrt
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.analysis.proof.blends import _causes, _check_sum, _left, _tail_in_force, suspended_by
from motionlang.analysis.proof.checker import Proof, Uses
from motionlang.analysis.proof.path_bounds import (
    _check_axes,
    _check_end,
    _check_joins,
    _hardest,
    _profile_at,
    cannot_stop,
    check_along,
    check_path_time,
    enters_too_fast,
    gentlest_stop,
    least_bounds,
    until_rest,
)
from motionlang.analysis.proof.path_layout import PathLayout
from motionlang.analysis.proof.paths import (
    _beyond,
    _check_path,
    _follows_stop,
    _gentlest_before,
    _plan_before,
    _speeds_up,
    check_path_end,
    plan_in_force,
    same_law,
    stops_within,
)
from motionlang.analysis.proof.segments import Span
from motionlang.analysis.proof.slowing import Slowing
from motionlang.log.order import Order, PathOrder
from motionlang.planners import Profile, hold, plan_jerk, plan_trapezoid
from motionlang.planners.sequence import chained

FREE = (inf, inf)
PATH = PathOrder(
    (0,), (1.0,), 0.0, 0, True, (100.0,), (0.0, 0.0), 0.0, (), (0, 1), None, (inf,), (inf,), (inf,), 0.0
)
ORDER = Order("path", 3, speed=10.0, rates=(10.0, 10.0), shape="trapezoid", path=PATH)
SMOOTH = ORDER._replace(shape="scurve", jerks=(20.0, 20.0))
TWO = PATH._replace(
    members=(0, 1), scales=(2.0, -4.0), line=(12.0, -32.0),
    most=(12.0, 100.0), most_accel=(60.0, 1e9), most_decel=(inf, 160.0),
)  # fmt: skip
ARC = TWO._replace(
    scales=(1.0, 1.0), relative=False, line=(), angle=90.0, most=(inf, inf),
    most_accel=(40.0, 90.0), most_decel=(50.0, 80.0),
)  # fmt: skip
LAYOUT = PathLayout(PATH, [0.0])
WHOLE = plan_trapezoid(0.0, 100.0, 10.0, 10.0, 10.0)


def span(begin: float, length: float, *coefficients: float) -> Span:
    """Return a segment c0 + c1 x + c2 x² + c3 x³."""
    c0, c1, c2, c3 = (*coefficients, 0.0, 0.0, 0.0, 0.0)[:4]
    return Span(begin, length, (c0, c1, c2, c3, 0.0, 0.0, 0.0))


def then(order: Order, *ahead: Order, **fields: Any) -> Order:
    """Return the order of a path with the paths that follow it."""
    assert order.path is not None
    return order._replace(path=order.path._replace(ahead=ahead, **fields))


def slower(length: float, speed: float = 10.0, rate: float = 10.0) -> Order:
    """Return the order of a line over `length` with its own speed and deceleration."""
    return ORDER._replace(path=PATH._replace(line=(length,), most=(speed,), most_decel=(rate,)))


# -- what the axes allow


def test_the_axes_of_a_line_limit_its_speed_and_rates() -> None:
    """Along (6, 8) units the axes have 0.6 and 0.8 of the speed: 1.2 and 3.2 counts/s."""
    order = ORDER._replace(speed=50.0, rates=(1000.0, 900.0), path=TWO)
    layout = PathLayout(TWO, [0.0, 0.0])
    speed, by = least_bounds(order, layout)
    assert (speed, *by.rates) == pytest.approx((12.0 / 1.2, 60.0 / 1.2, 160.0 / 3.2))
    assert least_bounds(order._replace(speed=4.0, rates=(20.0, 30.0)), layout) == (
        4.0,
        by._replace(rates=(20.0, 30.0)),
    )
    assert _hardest(TWO, layout) == pytest.approx(160.0 / 3.2)


def test_an_axis_that_a_path_does_not_move_does_not_limit_it() -> None:
    path = TWO._replace(line=(12.0, 0.0), most=(12.0, 1e-9), most_accel=(60.0, 1e-9), most_decel=(30.0, 1e-9))
    layout = PathLayout(path, [0.0, 0.0])
    speed, by = least_bounds(ORDER._replace(path=path, speed=50.0, rates=(99.0, 99.0)), layout)
    assert (speed, by.rates) == (6.0, (30.0, 15.0))
    assert _hardest(path, layout) == 15.0
    still = path._replace(line=(0.0, 0.0))
    assert _hardest(still, PathLayout(still, [0.0, 0.0])) == inf


def test_the_axes_of_an_arc_share_their_limits_between_turning_and_braking() -> None:
    """On a quarter of 10 units each axis has 1 / sqrt 2 of its limit for v² / 10."""
    order = ORDER._replace(speed=50.0, rates=(1000.0, 900.0), path=ARC)
    speed, by = least_bounds(order, PathLayout(ARC, [10.0, 0.0]))
    assert speed == pytest.approx(sqrt(40.0 / sqrt(2.0) * 10.0))
    assert by.rates == pytest.approx((40.0 / sqrt(2.0), 50.0 / sqrt(2.0)))


def test_a_stop_has_the_lowest_deceleration_of_the_paths_that_it_may_reach() -> None:
    order = then(ORDER, slower(9.0, rate=8.0), slower(9.0, rate=6.0), slower(9.0, rate=7.0))
    assert [gentlest_stop(order, LAYOUT, rate) for rate in (10.0, 5.0)] == [6.0, 5.0]
    assert gentlest_stop(ORDER, LAYOUT, 10.0) == 10.0


# -- room for a stop

# The position and velocity, how far the next paths lead, and whether it is too late to stop within them.
STOPS: dict[str, tuple[float, float, float, bool]] = {
    "enough": (94.0, 10.0, 0.0, False),
    "just enough": (95.0, 10.0, 0.0, False),
    "just too little": (95.001, 10.0, 0.0, True),
    "on the next path": (96.0, 10.0, 1.0, False),
    "beyond the next path": (96.5, 10.0, 1.0, True),
    "at half of the speed": (98.75, 5.0, 0.0, False),
}  # fmt: skip


@pytest.mark.parametrize("name", STOPS)
def test_a_path_stops_before_its_end_if_it_has_room(name: str) -> None:
    position, velocity, beyond, too_late = STOPS[name]
    along = [span(0.0, 0.1, position, velocity)]
    assert cannot_stop(ORDER, LAYOUT, along, beyond) is too_late
    assert not cannot_stop(ORDER._replace(rates=(10.0, 0.0)), LAYOUT, along, beyond)


@pytest.mark.parametrize(("velocity", "too_late"), [(0.9, True), (1.0, True), (1.1, False)])
def test_a_path_runs_back_if_its_deceleration_lasts_beyond_its_rest(velocity: float, too_late: bool) -> None:
    """A deceleration of sqrt 40, at a jerk of 20, takes 40 / (2 * 20) = 1 more."""
    along = [span(0.0, 0.1, 0.0, velocity, -0.5 * sqrt(40.0))]
    assert cannot_stop(SMOOTH, LAYOUT, along, 0.0) is too_late


# The paths ahead, the position, and whether a stop enters one of them too fast. It brakes from 10 to 6 over 3.2.
ENTRIES: dict[str, tuple[tuple[Order, ...], float, bool]] = {
    "none ahead": ((), 99.9, False),
    "as fast": ((slower(9.0),), 99.9, False),
    "slower, with room": ((slower(9.0, 6.0),), 96.7, False),
    "slower, without": ((slower(9.0, 6.0),), 96.9, True),
    "slower, just with room": ((slower(9.0, 6.0),), 96.8, True),  # rounding counts against it
    "the second one is slower, with room": ((slower(2.0), slower(9.0, 6.0)), 98.7, False),
    "the second one is slower, without": ((slower(2.0), slower(9.0, 6.0)), 98.9, True),
    "the first one brakes at 5: over 6.4": ((slower(9.0, 6.0, 5.0),), 94.0, True),
    "the first one brakes at 5, with room": ((slower(9.0, 6.0, 5.0),), 93.5, False),
}  # fmt: skip


@pytest.mark.parametrize("name", ENTRIES)
def test_a_stop_may_enter_the_next_path_too_fast(name: str) -> None:
    ahead, position, too_fast = ENTRIES[name]
    assert enters_too_fast(then(ORDER, *ahead), LAYOUT, [span(0.0, 0.1, position, 10.0)]) is too_fast


@pytest.mark.parametrize(("a0", "too_fast"), [(0.0, False), (3.0, False), (10.0, True)])
def test_an_acceleration_makes_a_path_faster_before_it_stops(a0: float, too_fast: bool) -> None:
    """At a jerk of 20, 3 add 0.225 to 5, and 10 add 2.5: only the latter is above 6."""
    order = then(SMOOTH, slower(9.0, 6.0))
    assert enters_too_fast(order, LAYOUT, [span(0.0, 0.1, 99.99, 5.0, 0.5 * a0)]) is too_fast


def running(profile: Profile, **fields: Any) -> Any:
    """Return a run with one path, whose axis has the profile from the path's start on."""
    entry = SimpleNamespace(profile=profile)
    return SimpleNamespace(members=lambda path: [entry], origins=lambda path: [profile.start], **fields)


# The order, the profile, when a stop is ordered, and whether it has room. WHOLE is at 95 after 10 s, and brakes
# from there.
TIMES: dict[str, tuple[Order, Profile, float, bool]] = {
    "early": (ORDER, WHOLE, 5.0, True),
    "just in time": (ORDER, WHOLE, 10.0, True),
    "as it brakes": (ORDER, WHOLE, 10.5, True),
    "after its end": (ORDER, WHOLE, 12.0, True),
    "by a lower rate, in time": (ORDER._replace(rates=(10.0, 5.0)), WHOLE, 9.5, True),
    "by a lower rate, too late": (ORDER._replace(rates=(10.0, 5.0)), WHOLE, 9.501, False),
    "by a lower rate, on the next path": (
        then(ORDER._replace(rates=(10.0, 5.0)), slower(2.0)), WHOLE, 9.7, True,
    ),
    "by a lower rate, beyond the next path": (
        then(ORDER._replace(rates=(10.0, 5.0)), slower(2.0)), WHOLE, 9.701, False,
    ),
    "the next path brakes at 5": (then(ORDER, slower(2.0, rate=5.0)), WHOLE, 9.701, False),
    "begun at 2 s": (ORDER._replace(rates=(10.0, 5.0), path=PATH._replace(begun=2.0)), WHOLE, 11.5, True),
    "begun at 2 s, too late": (
        ORDER._replace(rates=(10.0, 5.0), path=PATH._replace(begun=2.0)), WHOLE, 11.501, False,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", TIMES)
def test_a_path_could_stop_in_time(name: str) -> None:
    order, profile, time, stops = TIMES[name]
    assert stops_within(running(profile), order, time) is stops


@pytest.mark.parametrize(("rest", "stops"), [(True, True), (False, False)])
def test_a_path_that_stops_may_lower_its_jerk_until_it_rests(rest: bool, stops: bool) -> None:
    """It brakes at a jerk of 40; at one of 20 it would run back."""
    profile = plan_jerk(0.0, 100.0, 10.0, 10.0, 10.0, 40.0, 40.0)
    order = then(SMOOTH, comes_to_rest=rest)
    assert stops_within(running(profile), order, profile.duration - 0.1) is stops


# -- speed along a path


@pytest.mark.parametrize(
    ("first", "end", "count"),
    [(100.0, 5e-5, 1), (100.0, 2e-4, 2), (0.5, 5e-7, 1), (0.5, 2e-6, 2), (100.0, -5e-5, 1), (100.0, 50.0, 2)],
)
def test_a_standstill_divides_the_segments_of_a_path(first: float, end: float, count: int) -> None:
    """A millionth of the first speed, or of 1 if it is less, is rest."""
    along = [span(0.0, 1.0, 0.0, first, 0.5 * (end - first)), span(1.0, 1.0, 9.0, 3.0, 4.0)]
    assert until_rest(along) == (along[:count], along[count:])


@pytest.mark.parametrize(
    ("reached", "came", "found"),
    [
        (10.0, 0.0, False),
        (10.0 + 0.9e-6, 0.0, False),
        (10.0 + 1.2e-6, 0.0, True),
        (10.0 + 9e-5, 100.0, False),
        (10.0 + 1.2e-4, 100.0, True),
    ],
)
def test_a_path_has_slowed_down_by_its_end(reached: float, came: float, found: bool) -> None:
    proof = Proof()
    slow = Slowing(came, 10.0, came, 1.0, 0.0, ())
    _check_end(proof, ORDER, span(1.0, 1.0, 0.0, reached), slow, 0.0, "here")
    message = "here: it does not slow down: 10 after 2 s, expected 10"
    assert [each.message.replace("10.0001", "10") for each in proof.violations] == [message] * found


@pytest.mark.parametrize(
    ("order", "came", "jump", "bend", "names"),
    [
        (ORDER, 0.0, 0.9e-5, 0.0, []),
        (ORDER, 0.0, 1.2e-5, 0.0, ["speed"]),
        (ORDER, 0.0, 0.0, 1.0, []),  # the acceleration of a trapezoid jumps
        (SMOOTH, 0.0, 0.0, 1.0, ["acceleration"]),
        (SMOOTH, 0.0, 1.0, 1.0, ["speed", "acceleration"]),
        (ORDER, 100.0, 0.9e-4, 0.0, []),
        (ORDER, 100.0, 1.2e-4, 0.0, ["speed"]),
        (ORDER._replace(speed=inf, rates=(10.0, inf)), 0.0, 1.2e-5, 0.0, ["speed"]),
        (ORDER._replace(speed=0.1, rates=(0.1, 0.1)), 0.0, 0.9e-6, 0.0, []),
        (ORDER._replace(speed=0.1, rates=(0.1, 0.1)), 0.0, 1.2e-6, 0.0, ["speed"]),
    ],
)
def test_the_speed_along_a_path_is_continuous(
    order: Order, came: float, jump: float, bend: float, names: list[str]
) -> None:
    """A millionth of the largest bound is rounding, or of 1 if that is more."""
    proof = Proof()
    _check_joins(
        proof, order, [span(0.0, 1.0, 0.0, 5.0), span(1.0, 1.0, 5.0, 5.0 + jump, 0.5 * bend)], came, "x"
    )
    assert [each.message.split()[2] for each in proof.violations] == names


# The side, the speed and acceleration, those that it came with, and the names that are exceeded. Axis 0 has 1.2
# counts a unit and may do 12 counts/s and speed up at 60 counts/s²; axis 1 has 3.2, and may do 100 and brake at 160.
AXES: dict[str, tuple[int, tuple[float, float], tuple[float, float], list[str]]] = {
    "at the limits, speeding up": (0, (10.0, 50.0), (0.0, 0.0), []),
    "at the limits, braking": (1, (10.0, 50.0), (0.0, 0.0), []),
    "too fast": (0, (10.1, 50.0), (0.0, 0.0), ["speed on paths of axis 0"]),
    "too fast, as it came": (0, (10.1, 50.0), (10.1, 0.0), []),
    "speeding up too hard": (0, (10.0, 50.1), (0.0, 0.0), ["rate on paths of axis 0"]),
    "speeding up too hard, as it came": (0, (10.0, 50.1), (0.0, 50.1), []),
    "braking too hard": (1, (10.0, 50.1), (0.0, 0.0), ["rate on paths of axis 1"]),
    "far too fast": (1, (32.0, 50.0), (0.0, 0.0), ["speed on paths of axis 0", "speed on paths of axis 1"]),
}  # fmt: skip


@pytest.mark.parametrize("name", AXES)
def test_each_axis_of_a_path_has_its_limits(name: str) -> None:
    side, own, excused, names = AXES[name]
    proof = Proof()
    uses = Uses(proof)
    layout = PathLayout(TWO, [0.0, 0.0])
    _check_axes(uses, TWO, layout, [(0, 2.0), (1, 4.0)], (0.0, 10.0), side, own, excused)
    uses.report(3, "here", "")
    assert [each.message.partition(" reaches")[0] for each in proof.violations] == [
        f"here: the {each}" for each in names
    ]


def test_the_profile_of_a_sequence_in_force_at_a_time() -> None:
    """WHOLE takes 11 s, a second one from 100 on as long."""
    second = WHOLE.shifted(100.0)
    both = chained(WHOLE, second)
    found = {time: _profile_at(both, time) for time in (0.0, 10.0, 11.0, 12.0, 23.0)}
    assert {time: each[1:] for time, each in found.items()} == {
        0.0: (0.0, 11.0), 10.0: (10.0, 1.0), 11.0: (0.0, 11.0), 12.0: (1.0, 10.0), 23.0: (12.0, inf),
    }  # fmt: skip
    assert [each[0].start for each in found.values()] == [0.0, 0.0, 100.0, 100.0, 100.0]
    assert _profile_at(WHOLE, 10.0)[1:] == (10.0, 1.0)
    assert [_profile_at(WHOLE, time)[1:] for time in (11.0, 12.0)] == [(11.0, inf), (12.0, inf)]


# -- one path after another


def track(*entries: tuple[float, Profile]) -> Any:
    """Return the track of axis 0 with profiles and their starts."""
    starts = [start for start, _ in entries]
    return SimpleNamespace(
        index=0,
        starts=starts,
        profiles=[profile for _, profile in entries],
        index_at=lambda time: max(k for k, start in enumerate(starts) if start <= time),
    )


# When the path before was replaced, its order, and whether it was speeding up. It is at speed from 1 s to 10 s.
BEFORE: dict[str, tuple[float, Order, bool]] = {
    "while it sped up": (0.5, ORDER, True),
    "at its speed": (5.0, ORDER, True),
    "while it braked": (10.5, ORDER, False),
    "as it began": (0.0, ORDER, False),
    "it was another motion": (0.5, Order("move", 1), False),
    "it came to rest": (0.5, then(ORDER, comes_to_rest=True), False),
    "it was one of other axes": (0.5, ORDER._replace(path=TWO), False),
}  # fmt: skip


@pytest.mark.parametrize("name", BEFORE)
def test_a_path_that_sped_up_was_not_slowing_down_for_the_next(name: str) -> None:
    time, earlier, speeds_up = BEFORE[name]
    master = track((2.0, WHOLE), (2.0 + time, hold(0.0)))
    run: Any = SimpleNamespace(axes={0: master}, expected_motion=SimpleNamespace(of={0: [earlier, ORDER]}))
    # Only the profile before counts, whatever follows it.
    master.index_at = lambda at: 0
    assert _speeds_up(run, ORDER, PATH, master, 1) is speeds_up


@pytest.mark.parametrize(
    ("scales", "speeds_up"),
    [((1.0, 1.0), True), ((1.0, 10.0), True), ((1.0, 0.1), False), ((0.1, 1.0), True)],
)
def test_a_path_speeds_up_by_the_sum_of_its_axes(scales: tuple[float, float], speeds_up: bool) -> None:
    """Axis 0 speeds up from 0.2 to 0.7 counts/s, axis 1 slows down from 0.4 to 0.3.

    Their accelerations are 1 and -0.2. With 0.1 counts per unit, axis 1 slows down from 4 to 3.
    """
    up = plan_trapezoid(0.0, 100.0, 10.0, 1.0, 1.0, 0.2)
    down = plan_trapezoid(0.0, 100.0, 0.1, 0.2, 0.2, 0.4)
    tracks = {0: track((2.0, up), (2.5, hold(0.0))), 1: track((2.0, down), (2.5, hold(0.0)))}
    for each in tracks.values():
        each.index_at = lambda at: 0
    path = PATH._replace(members=(0, 1), scales=scales)
    earlier = ORDER._replace(path=path)
    run: Any = SimpleNamespace(axes=tracks, expected_motion=SimpleNamespace(of={0: [earlier, earlier]}))
    assert _speeds_up(run, earlier, path, tracks[0], 1) is speeds_up


# The order before a stop that begins at 97 counts at 10 counts/s, the paths ahead, and the order in force: the
# stop begins on the next path if it would enter that too fast.
@pytest.mark.parametrize(
    ("before", "ahead", "number"),
    [
        (ORDER._replace(rates=(10.0, 20.0)), (slower(9.0, 6.0),), 0),
        (ORDER._replace(rates=(10.0, 20.0)), (slower(9.0),), 1),
        (ORDER._replace(rates=(10.0, 20.0)), (), 1),
        (ORDER, (slower(9.0, 6.0),), 1),  # the rates have not changed
        (Order("move", 1), (slower(9.0, 6.0),), 1),
    ],
)
def test_the_plan_in_force_while_a_stop_waits_for_the_next_path(
    before: Order, ahead: tuple[Order, ...], number: int
) -> None:
    """From 97 counts it is 3 to the end, and it brakes from 10 to 6 over 3.2."""
    order = then(ORDER, *ahead, comes_to_rest=True)
    master = track((0.0, WHOLE), (10.2, WHOLE.after(10.2)))
    entry = SimpleNamespace(profile=plan_trapezoid(0.0, 100.0, 10.0, 10.0, 50.0))
    run: Any = SimpleNamespace(
        axes={0: master},
        expected_motion=SimpleNamespace(of={0: [before, order]}),
        members=lambda path: [entry],
        origins=lambda path: [0.0],
        span=lambda a, i: (a.starts[i], 10.4),
    )
    assert plan_in_force(run, master, 1, order) is (before, order)[number]
    assert plan_in_force(run, master, 1, ORDER) is ORDER
    run.members = lambda path: []
    assert plan_in_force(run, master, 1, order) is order


def test_the_length_of_the_paths_until_a_rest() -> None:
    """Three lines of 100, 20 and 30 are run through; one of 40 begins 1 s later."""
    profiles = [plan_trapezoid(0.0, each, 10.0, 10.0, 10.0, 10.0) for each in (100.0, 20.0, 30.0, 40.0)]
    moves: list[Any] = []
    begin = 0.0
    for number, profile in enumerate(profiles):
        begin += number == 3
        moves.append(SimpleNamespace(start_time=begin, profile=profile, number=number))
        begin += profile.duration
    paths = {id(move): PATH._replace(line=(move.profile.end,), begun=move.start_time) for move in moves}
    run: Any = SimpleNamespace(
        beyond={},
        path_after=lambda move: moves[move.number + 1] if move.number < 3 else None,
        rest_of=lambda move: None,
        order_of=lambda move: ORDER._replace(path=paths[id(move)]),
        origins=lambda path: [0.0],
    )
    assert _beyond(run, moves[1]) == 30.0
    assert [_beyond(run, move) for move in moves] == [50.0, 30.0, 0.0, 0.0]
    # An entry that continues another one is part of the same path.
    run.beyond, run.rest_of = {}, lambda move: moves[0] if move is moves[1] else None
    assert [_beyond(run, move) for move in moves] == [30.0, 30.0, 0.0, 0.0]
    # From a standstill nothing continues.
    moves[1].profile = plan_trapezoid(0.0, 20.0, 10.0, 10.0, 10.0)
    run.beyond, run.rest_of = {}, lambda move: None
    assert _beyond(run, moves[0]) == 0.0


def records(*orders: Order) -> Any:
    return SimpleNamespace(
        axes={}, expected_motion=SimpleNamespace(of={0: list(orders)}), origins=lambda path: [0.0]
    )


STOP = then(ORDER, comes_to_rest=True)


@pytest.mark.parametrize(
    ("earlier", "rate"),
    [
        ((), inf),
        ((ORDER._replace(rates=(10.0, 4.0)),), inf),
        ((STOP._replace(rates=(10.0, 4.0)),), 4.0),
        ((STOP._replace(rates=(10.0, 4.0)), STOP._replace(rates=(10.0, 6.0))), 4.0),
        ((STOP._replace(rates=(10.0, 6.0)), STOP._replace(rates=(10.0, 4.0))), 4.0),
        ((STOP._replace(rates=(10.0, 4.0)), ORDER, STOP._replace(rates=(10.0, 6.0))), 6.0),
        ((then(STOP._replace(rates=(10.0, 4.0)), members=(1,)),), inf),
    ],
)
def test_a_stop_that_began_earlier_may_brake_more_gently(earlier: tuple[Order, ...], rate: float) -> None:
    run = records(*earlier, STOP)
    assert _gentlest_before(run, track((0.0, WHOLE)), len(earlier), STOP) == rate
    assert _gentlest_before(run, track((0.0, WHOLE)), len(earlier), ORDER) == inf


HARD = STOP._replace(rates=(10.0, 20.0))


@pytest.mark.parametrize(
    ("earlier", "found"),
    [
        ((), None),
        ((ORDER,), 0),
        ((ORDER, HARD), 0),
        ((ORDER._replace(rates=(10.0, 20.0)),), None),  # the same rates
        ((then(ORDER, entry=7),), None),
        ((Order("move", 1),), None),
        ((ORDER, then(HARD, entry=7)), None),
    ],
)
def test_the_plan_of_a_path_before_its_stop(earlier: tuple[Order, ...], found: int | None) -> None:
    run = records(*earlier, HARD)
    plan = _plan_before(run, track((0.0, WHOLE)), len(earlier), HARD)
    assert plan is (None if found is None else earlier[found])
    assert _plan_before(run, track((0.0, WHOLE)), len(earlier), ORDER) is None


@pytest.mark.parametrize(
    ("other", "same"),
    [
        (ORDER, True),
        (ORDER._replace(speed=5.0), True),
        (then(ORDER, comes_to_rest=True), True),
        (ORDER._replace(rates=(10.0, 11.0)), False),
        (SMOOTH, False),
        (then(ORDER, most_accel=(5.0,)), False),
        (then(ORDER, most_decel=(5.0,)), False),
        (then(ORDER, most=(5.0,)), True),
    ],
)
def test_the_law_of_a_path_is_that_of_its_ramps(other: Order, same: bool) -> None:
    assert same_law(ORDER, other) is same


# The profile, its path, whether it is over, and the violations. The path ends at 100 counts.
ENDS: dict[str, tuple[Profile, PathOrder, bool, list[str]]] = {
    "at its end": (WHOLE, PATH, True, []),
    "beyond its end by a millionth": (plan_trapezoid(0.0, 100.00009, 10.0, 10.0, 10.0), PATH, True, []),
    "beyond its end": (
        plan_trapezoid(0.0, 100.001, 10.0, 10.0, 10.0), PATH, True, ["its path ends at 100.001, commanded 100"],
    ),
    "before its end": (
        plan_trapezoid(0.0, 99.999, 10.0, 10.0, 10.0), PATH, True, ["its path ends at 99.999, commanded 100"],
    ),
    "not over yet": (plan_trapezoid(0.0, 50.0, 10.0, 10.0, 10.0), PATH, False, []),
    "a short path, by a millionth": (
        plan_trapezoid(0.0, 0.1 + 9e-7, 10.0, 10.0, 10.0), PATH._replace(line=(0.1,)), True, [],
    ),
    "a short path, by more": (
        plan_trapezoid(0.0, 0.1 + 2e-6, 10.0, 10.0, 10.0), PATH._replace(line=(0.1,)), True,
        ["its path ends at 0.100002, commanded 0.1"],
    ),
    "in no time": (
        hold(0.0).cut(0.0), PATH._replace(line=(1e-5,)), True,
        ["its path ends at 0, commanded 1e-05", "a path in no time"],
    ),
    "nowhere in no time": (hold(0.0).cut(0.0), PATH._replace(line=(1e-7,)), True, []),
}  # fmt: skip


@pytest.mark.parametrize("name", ENDS)
def test_a_path_ends_at_its_commanded_position_and_takes_time(name: str) -> None:
    profile, path, over, messages = ENDS[name]
    move: Any = SimpleNamespace(axis=0, line=3, start_time=2.0, profile=profile, offset=0.0)
    order = ORDER._replace(path=path)
    run: Any = SimpleNamespace(
        order_of=lambda each: order, members=lambda each: [move], origins=lambda each: [profile.start]
    )
    proof = Proof()
    check_path_end(proof, run, move, over)
    where = "axis 0 from 2.000000 s: "
    assert [each.message for each in proof.violations] == [where + message for message in messages]
    move.offset = 5.0
    check_path_end(proof, run, move, over)
    assert len(proof.violations) == len(messages)


# -- motion along a path

# With jerks of 20 a stop from 10 takes 1.5 s over 7.5; by way of 5 it takes 7.5 + 2.5. Each row has the order, the
# segments, how far the next paths lead, whether the path has to begin within its bounds, and the violations.
HALF = SMOOTH._replace(speed=5.0)
STOPPING = then(SMOOTH, comes_to_rest=True)
ALONG: dict[str, tuple[Order, list[Span], float, bool, tuple[str, ...]]] = {
    "at the speed": (ORDER, [span(0.0, 1.0, 0.0, 10.0)], 0.0, False, ()),
    "speeding up at the rate": (ORDER, [span(0.0, 1.0, 0.0, 0.0, 5.0)], 0.0, False, ()),
    "speeding up too hard": (
        ORDER, [span(0.0, 0.9, 0.0, 0.0, 5.5)], 0.0, False, ("the path acceleration reaches 11, above 10",),
    ),
    "braking too hard": (
        ORDER._replace(rates=(20.0, 10.0)), [span(0.0, 0.9, 0.0, 10.0, -5.5)], 0.0, False,
        ("the path deceleration reaches 11, above 10",),
    ),
    "braking as it may speed up": (
        ORDER._replace(rates=(10.0, 20.0)), [span(0.0, 0.4, 0.0, 10.0, -10.0)], 0.0, False, (),
    ),
    "running back": (ORDER, [span(0.0, 1.0, 50.0, -1.0)], 0.0, False, ("it runs back along the path, at 1",)),
    "running back by rounding": (ORDER, [span(0.0, 1.0, 50.0, -9e-7)], 0.0, False, ()),
    "running back by more": (
        ORDER, [span(0.0, 1.0, 50.0, -2e-6)], 0.0, False, ("it runs back along the path, at 2e-06",),
    ),
    "too fast for its speed, with room for it": (
        HALF, [span(0.0, 0.5, 50.0, 10.0)], 0.0, False,
        ("it does not slow down: 10 after 0.5 s, expected 7.5",),
    ),
    "too fast for too long": (
        HALF, [span(0.0, 1.5, 50.0, 10.0)], 0.0, False,
        ("the path speed reaches 10, above 5", "it does not slow down: 10 after 1.5 s, expected 5"),
    ),
    "too fast, with room for a stop alone": (HALF, [span(0.0, 0.5, 92.5, 10.0)], 0.0, False, ()),
    "too fast, with room on the next path": (HALF, [span(0.0, 0.5, 97.5, 10.0)], 5.0, False, ()),
    "too fast, with room for both on the next path": (
        HALF, [span(0.0, 0.5, 97.5, 10.0)], 50.0, False,
        ("it does not slow down: 10 after 0.5 s, expected 7.5",),
    ),
    "too fast as it begins": (
        HALF, [span(0.0, 0.5, 92.5, 10.0)], 0.0, True,
        ("the path speed reaches 10, above 5", "it does not slow down: 10 after 0.5 s, expected 5"),
    ),
    "a stop": (STOPPING, [
        span(0.0, 0.5, 0.0, 10.0, 0.0, -20.0 / 6.0), span(0.5, 0.5, 4.6, 7.5, -5.0),
        span(1.0, 0.5, 7.1, 2.5, -5.0, 20.0 / 6.0), span(1.5, 1.0, 7.5, 0.0),
    ], 0.0, False, ()),
    "a stop that does not come to rest": (
        STOPPING, [span(0.0, 1.0, 0.0, 0.0), span(1.0, 1.0, 0.0, 2e-6)], 0.0, False,
        ("the path speed reaches 2e-06, above 0", "it does not slow down: 2e-06 after 2 s, expected 0"),
    ),
    "a stop that rests but for rounding": (
        STOPPING, [span(0.0, 1.0, 0.0, 0.0), span(1.0, 1.0, 0.0, 9e-7)], 0.0, False, (),
    ),
    "a stop from an acceleration that its jerk cannot end before rest": (
        STOPPING, [span(0.0, sqrt(40.0) / 40.0, 0.0, 0.5, -0.5 * sqrt(40.0), 40.0 / 6.0)], 0.0, False, (),
    ),
    "the same at a jerk that is too high": (
        STOPPING, [span(0.0, sqrt(40.0) / 44.0, 0.0, 0.5, -0.5 * sqrt(40.0), 44.0 / 6.0)], 0.0, False,
        ("the path jerk reaches 44, above 40",),
    ),
    "a jerk that is too high": (
        SMOOTH, [span(0.0, 0.1, 0.0, 5.0, 0.0, 21.0 / 6.0)], 0.0, False,
        ("the path jerk reaches 21, above 20",),
    ),
    "an acceleration that jumps": (
        SMOOTH, [span(0.0, 0.5, 0.0, 0.0, 0.0, 20.0 / 6.0), span(0.5, 0.5, 0.5, 2.5)], 0.0, False,
        ("the acceleration along it jumps by 10",),
    ),
    "a segment as short as the rounding of a time": (
        ORDER, [span(0.0, 1.0, 0.0, 10.0), span(1.0, 5e-13, 10.0, 10.0, 50.0)], 0.0, False, (),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", ALONG)
def test_the_motion_along_a_path_keeps_its_bounds(name: str) -> None:
    order, along, beyond, fresh, expected = ALONG[name]
    proof = Proof()
    check_along(proof, order, LAYOUT, along, "here", fresh, beyond)
    assert [each.message.removeprefix("here: ") for each in proof.violations] == list(expected)


# The order, the positions and velocities at the ends, the time, and the limit of that, 0.0 if it suffices.
DURATIONS: dict[str, tuple[Order, tuple[float, float], tuple[float, float], float, float]] = {
    "from rest to rest": (ORDER, (0.0, 0.0), (100.0, 0.0), 11.0, 0.0),
    "too slow": (ORDER, (0.0, 0.0), (100.0, 0.0), 11.1, 11.0),
    "the rest of it, from the speed": (ORDER, (50.0, 10.0), (100.0, 0.0), 5.5, 0.0),
    "the rest of it, too slow": (ORDER, (50.0, 10.0), (100.0, 0.0), 5.6, 5.5),
    "into another path: a stop and a move from rest": (ORDER, (50.0, 10.0), (100.0, 10.0), 6.5, 0.0),
    "into another path, too slow": (ORDER, (50.0, 10.0), (100.0, 10.0), 6.6, 6.5),
    "without a speed": (ORDER._replace(speed=0.0), (0.0, 0.0), (100.0, 0.0), 99.0, 0.0),
    "without a rate": (ORDER._replace(rates=(10.0, 0.0)), (0.0, 0.0), (100.0, 0.0), 99.0, 0.0),
    "at rates below 1": (ORDER._replace(rates=(0.5, 0.5)), (0.0, 0.0), (100.0, 0.0), 31.0, 20.0 * sqrt(2.0)),
}  # fmt: skip


@pytest.mark.parametrize("name", DURATIONS)
def test_a_path_takes_no_longer_than_a_stop_and_a_move_from_rest(name: str) -> None:
    """A stop takes 1 s over 5, and 45 from rest 5.5 s; at 0.5, 100 takes 2 sqrt 200 s."""
    order, (begin, v0), (end, v1), took, limit = DURATIONS[name]
    # A cubic with these positions and velocities at its ends.
    mean = (end - begin) / took
    along = [
        span(0.0, took, begin, v0, (3.0 * mean - 2.0 * v0 - v1) / took, (v0 + v1 - 2.0 * mean) / took**2)
    ]
    proof = Proof()
    check_path_time(proof, order, LAYOUT, along, "here")
    message = f"here: it takes {took:g} s, expected at most {limit:g} s"
    assert [each.message for each in proof.violations] == [message] * bool(limit)


@pytest.mark.parametrize(("took", "count"), [(11.5, 0), (11.6, 1)])
def test_a_path_with_a_jerk_has_the_time_of_its_ramps(took: float, count: int) -> None:
    """Two ramps of 1.5 s cover 15, and 85 take 8.5 s."""
    proof = Proof()
    check_path_time(proof, SMOOTH, LAYOUT, [span(0.0, took, 0.0, 0.0, 0.0, 100.0 / took**3)], "here")
    assert len(proof.violations) == count


@pytest.mark.parametrize(
    ("factor", "shift", "start", "off"),
    [
        (1.0, 0.0, 0.0, ""),
        (1.0 + 1e-6, 0.0, 0.0, ""),
        (1.0 + 3e-6, 0.0, 0.0, "1.152e-05"),
        (1.0, 8e-5, 0.0, ""),
        (1.0, 1e-4, 0.0, "1.2e-05"),
        (1.0, 1e-4, 400.0, ""),
    ],
)
def test_the_axes_of_a_line_are_on_it(factor: float, shift: float, start: float, off: str) -> None:
    """A millionth of its 10 units is rounding, or of the 100 units that it begins at.

    With s counts too many, axis 1 is s / 4 units off in y: 0.48 of these across the line in x, 0.36 in y.
    """
    base = plan_trapezoid(0.0, 10.0, 10.0, 10.0, 10.0)
    path = TWO._replace(relative=True)
    layout = PathLayout(path, [0.0, start])
    profiles = [base.scaled(0.0, 1.2), base.scaled(start + shift, -3.2 * factor)]
    proof = Proof()
    _check_path(proof, ORDER._replace(path=path), layout, profiles, [], (0.0, base.duration), "here")
    message = f"here: it is {off} off the commanded path"
    assert [each.message for each in proof.violations] == [message] * bool(off)


@pytest.mark.parametrize(
    ("before", "fields", "follows"),
    [
        ({"comes_to_rest": True}, {}, True),
        ({}, {}, False),
        ({"comes_to_rest": True, "entry": 7}, {}, False),
        ({"comes_to_rest": True}, {"comes_to_rest": True}, False),
    ],
)
def test_a_path_that_is_resumed_too_late_stops_first(
    before: dict[str, Any], fields: dict[str, Any], follows: bool
) -> None:
    order = then(ORDER, **fields)
    assert _follows_stop(then(ORDER, **before), order, LAYOUT, [span(0.0, 1.0, 96.0, 10.0)], 0.0) is follows
    assert not _follows_stop(then(ORDER, **before), order, LAYOUT, [span(0.0, 1.0, 96.0, 10.0)], 1.0)
    assert not _follows_stop(Order("move", 1), order, LAYOUT, [span(0.0, 1.0, 96.0, 10.0)], 0.0)


# -- blended paths


def blended(*orders: Order) -> Any:
    """Return a run whose axis 0 had these orders, and its track."""
    a = track(*((float(k), WHOLE) for k in range(len(orders))))
    run = running(WHOLE, axes={0: a}, expected_motion=SimpleNamespace(of={0: list(orders)}))
    return run, a


NINE, EIGHT = then(ORDER, entry=9), then(ORDER, entry=8)
NINE_STOPS = then(NINE._replace(rates=(10.0, 0.1)), comes_to_rest=True)


@pytest.mark.parametrize(
    ("orders", "tail", "found"),
    [
        ((NINE, EIGHT), NINE, NINE),  # it does not stop
        ((NINE, EIGHT), then(NINE, comes_to_rest=True), then(NINE, comes_to_rest=True)),  # it can
        ((NINE, EIGHT), NINE_STOPS, NINE),  # it cannot, by its lower rate
        ((EIGHT, EIGHT), NINE_STOPS, NINE_STOPS),  # it had no earlier order
        ((then(EIGHT, tails=(NINE,)), EIGHT), NINE_STOPS, NINE),
        ((NINE, then(EIGHT, begun=-1.0), EIGHT), NINE_STOPS, NINE_STOPS),  # an older path lies in between
    ],
)
def test_a_blended_path_that_cannot_stop_goes_on_by_its_earlier_order(
    orders: tuple[Order, ...], tail: Order, found: Order
) -> None:
    run, a = blended(*orders)
    assert _tail_in_force(run, a, len(orders) - 1, tail) == found


@pytest.mark.parametrize(
    ("before", "tail", "found"),
    [
        (then(NINE, comes_to_rest=True), NINE, True),
        (NINE, NINE, False),
        (then(NINE, comes_to_rest=True), then(NINE, comes_to_rest=True), False),
        (then(EIGHT, comes_to_rest=True), NINE, False),
        (then(EIGHT, tails=(then(NINE, comes_to_rest=True),)), NINE, True),
        (Order("move", 1), NINE, False),
    ],
)
def test_the_order_of_a_resumed_path_while_it_was_suspended(before: Order, tail: Order, found: bool) -> None:
    run, a = blended(ORDER, before, EIGHT)
    expected = then(NINE, comes_to_rest=True) if found else None
    assert suspended_by(run, a, 2, tail) == expected


@pytest.mark.parametrize(
    ("begin", "times"),
    [(0.5, [7.0, 2.0]), (1.5, [7.0, 2.0, 4.0]), (2.5, [7.0, 2.0, 4.0, 6.0])],
)
def test_a_path_may_begin_as_an_overlapping_one_ends(begin: float, times: list[float]) -> None:
    """Paths begin at 0, 1 and 2 s and take 2, 3 and 4 s; a prompt came at 7 s."""
    moves: list[Any] = [
        SimpleNamespace(start_time=float(k), axis=0, profile=hold(0.0).cut(k + 2.0)) for k in range(3)
    ]
    run: Any = SimpleNamespace(paths={0: moves})
    other: Any = SimpleNamespace(axis=0)
    assert list(_causes(run, other, [(7.0, "blend")], begin)) == times
    assert list(_causes(run, moves[0], [], begin)) == times[2:]


@pytest.mark.parametrize(
    ("shares", "found"),
    [((0.5, 0.5), False), ((0.5, 0.5000004), False), ((0.5, 0.51), True), ((1.0, 0.0), False)],
)
def test_the_axis_of_two_paths_has_the_sum_of_their_velocities(
    shares: tuple[float, float], found: bool
) -> None:
    """Each path has a share of the velocity of the track; a millionth is rounding."""
    a = track((0.0, WHOLE))
    entries: list[Any] = [
        [SimpleNamespace(profile=WHOLE.scaled(0.0, share), start_time=0.0)] for share in shares
    ]
    proof = Proof()
    run: Any = SimpleNamespace(axes={0: a})
    _check_sum(proof, run, ORDER, entries, (2.0, 8.0))
    messages = [each.message.partition(" at ")[2].partition(" at ")[2] for each in proof.violations]
    assert bool(messages) is found
    if found:
        assert messages[0].endswith("its paths add up to 10.1")


@pytest.mark.parametrize(("time", "left", "speed"), [(0.0, 100.0, 0.0), (5.0, 55.0, 10.0), (10.5, 1.25, 5.0)])
def test_the_distance_that_a_path_has_left(time: float, left: float, speed: float) -> None:
    assert _left(LAYOUT, [(WHOLE, time)]) == pytest.approx((left, speed))
    double = PathLayout(PATH._replace(length=50.0), [0.0])  # it counts as half as long
    assert _left(double, [(WHOLE, time)]) == pytest.approx((0.5 * left, speed))
