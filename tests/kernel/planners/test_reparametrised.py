"""Motion along curves, in sequence and superposed, equals plain arithmetic."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel.planners import (
    PieceTable,
    Profile,
    from_curve,
    hold,
    plan,
    plan_trapezoid,
    plan_velocity,
)
from motionlang.kernel.planners.arc import arc_over, line_over, rotated
from motionlang.kernel.planners.dwell import with_rest
from motionlang.kernel.planners.evaluate import evaluate
from motionlang.kernel.planners.pieces import position_in
from motionlang.kernel.planners.reparametrised import Reparametrised, travelled
from motionlang.kernel.planners.sequence import ProfileSequence
from motionlang.kernel.planners.superposition import added
from motionlang.kernel.planners.table_motion import table_curve
from tests.kernel.planners.cases import Move, moves, quick

CIRCLE = 2.0 * math.pi * 10.0
# A rise by 10 over 4 with no slope at its ends: 3 * 10/4² x² - 2 * 10/4³ x³.
CUBIC = (0.0, 0.0, 30.0 / 16.0, -20.0 / 64.0, 0.0, 0.0, 0.0)


# 1 + x + x² + x³ over 0 to 2, from 1 to 15; beyond its ends straight, with the slopes 1 and 17.
LIFTED = from_curve(
    "fly", 1.0, 15.0, ((0.0, 2.0), ((1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0),), (("fly", 0),)), 1.0, 17.0
)
# At 2 along the curve, from 4 before it.
UNIFORM = from_curve(
    "jog", -4.0, 16.0, ((0.0, 10.0), ((-4.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0),), (("slew", 0),)), 2.0, 2.0
)


def circle(cosine: bool = True, sweep: float = 2.0 * math.pi, shape: str = "trapezoid") -> Profile:
    """Return one axis of an arc of radius 10 around 0, run at a path speed of 20.

    It begins at angle 0; the rates along the path are 50.
    """
    length = 10.0 * abs(sweep)
    along = plan(shape, 0.0, length, 20.0, 50.0, 50.0, ramp=0.2)
    end = 10.0 * (math.cos(sweep) if cosine else math.sin(sweep))
    return Reparametrised(along, arc_over(length, 0.0, 10.0, 0.0, sweep, end, cosine))


def test_the_peaks_of_a_curve_at_a_uniform_speed_are_found_in_closed_form(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A cubic that rises by 10 over 4 has a largest slope of 1.5 * 10/4.

    Its second derivative is 6 * 10/4² at its ends. A cam with a master at 20 therefore has peaks of 75 and 1500.
    From its start to 1 it reaches a slope of 45/16. Beyond its end the curve continues straight.
    """
    monkeypatch.setattr(Reparametrised, "state", None)
    curve = from_curve("cam", 0.0, 10.0, ((0.0, 4.0), (CUBIC,), (("cam", 0),)), 0.0, 0.0)
    whole = Reparametrised(plan_velocity("trapezoid", -5.0, 20.0, 20.0, 50.0, 50.0), curve)
    assert (whole.peak_speed, whole.peak_acceleration) == pytest.approx((75.0, 1500.0))
    back = Reparametrised(plan_velocity("trapezoid", 1.0, -20.0, -20.0, 50.0, 50.0), curve)
    assert (back.peak_speed, back.peak_acceleration) == pytest.approx((20.0 * 45.0 / 16.0, 1500.0))
    beside = Reparametrised(plan_velocity("trapezoid", 5.0, 20.0, 20.0, 50.0, 50.0), curve)
    assert (beside.peak_speed, beside.peak_acceleration) == (0.0, 0.0)


def test_the_peak_of_many_cycles_is_looked_for_where_the_master_is_fastest(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A master that accelerates from 0 to 20 at 2 passes 25 cycles of a cam.

    Only the last few cycles can have the highest speed.
    """
    curve = from_curve("cam", 0.0, 10.0, ((0.0, 4.0), (CUBIC,), (("cam", 0),)), 0.0, 0.0)
    ramp = plan_velocity("trapezoid", 0.0, 0.0, 20.0, 2.0, 2.0).cut(10.0)
    cycles = []
    for k in range(25):
        begin, end = math.sqrt(4.0 * k), math.sqrt(4.0 * k + 4.0)
        cycles.append(Reparametrised(ramp.cut(end).after(begin).shifted(-4.0 * k), curve.shifted(10.0 * k)))
    alone = [cycle.peak_speed for cycle in cycles]
    search, searched = Reparametrised._peak, []

    def noted(cycle: Reparametrised, *how: Any) -> float:
        searched.append(cycle)
        return search(cycle, *how)

    monkeypatch.setattr(Reparametrised, "_peak", noted)
    assert ProfileSequence("cam", cycles).peak_speed == max(alone) == alone[-1]
    assert 1 <= len(searched) <= 3


def test_the_peaks_of_arcs_on_s_ramps_are_those_of_a_dense_grid() -> None:
    choose = random.Random(5)
    for case in range(60):
        radius, sweep = choose.uniform(1.0, 50.0), choose.uniform(-6.0, 6.0)
        length = radius * abs(sweep)
        speed, accel, decel = (
            choose.uniform(5.0, 100.0),
            choose.uniform(20.0, 500.0),
            choose.uniform(20.0, 500.0),
        )
        jerk = 10.0 ** choose.uniform(2.0, 4.0)
        along = plan("scurve", 0.0, length, speed, accel, decel, accel_jerk=jerk)
        arc = arc_over(length, 0.0, radius, choose.uniform(-3.0, 3.0), sweep, 0.0, case % 2 == 0)
        made = travelled(along, arc)
        speeds = np.abs(evaluate(made, np.linspace(0.0, made.duration * (1.0 - 1e-12), 20_001), 1))
        # A grid of 1e-4 of the motion misses a peak by less than its curvature allows.
        assert speeds.max() * (1.0 - 1e-12) <= made.peak_speed <= speeds.max() * (1.0 + 2e-5), case


def test_a_full_circle_by_its_figures() -> None:
    x = circle()
    assert x.duration == pytest.approx(CIRCLE / 20.0 + 0.4)
    assert x.extrema() == (-10.0, 10.0)
    assert x.peak_speed == pytest.approx(20.0)
    assert x.crossing(-10.0) == pytest.approx(x.duration / 2.0)
    # a quarter of the circle: 4 while speeding up in 0.4 s, the rest at 20
    assert x.crossing(0.0) == pytest.approx(0.4 + (CIRCLE / 4.0 - 4.0) / 20.0)
    assert x.crossing(10.5) is None
    assert [phase.name for phase in x.phases] == ["accel", "slew", "decel"]


@quick
@given(
    st.floats(0.05, 12.0),
    st.booleans(),
    st.booleans(),
    st.sampled_from(["trapezoid", "sinusoidal", "scurve"]),
)
def test_an_arc_stays_on_its_circle(sweep: float, back: bool, cut: bool, shape: str) -> None:
    sweep = -sweep if back else sweep
    x, y = circle(True, sweep, shape), circle(False, sweep, shape)
    if cut:
        x, y = x.after(0.3 * x.duration), y.cut(0.6 * y.duration).after(0.3 * y.duration)
    times = np.linspace(0.0, min(x.duration, y.duration), 53)
    for t in times.tolist():
        assert math.hypot(x.position(t), y.position(t)) == pytest.approx(10.0, abs=1e-12)
        assert x.position(t) * x.velocity(t) + y.position(t) * y.velocity(t) == pytest.approx(0.0, abs=1e-9)


@quick
@given(moves(), st.floats(0.1, 3.0), st.floats(0.0, 1.0))
def test_velocity_and_acceleration_are_the_derivatives(move: Move, revolutions: float, share: float) -> None:
    along = move.planned()
    if along.duration == 0.0:
        return
    along = along.shifted(-along.extrema()[0])
    length = along.extrema()[1]
    if length == 0.0:
        return
    sweep = 2.0 * math.pi * revolutions
    made = Reparametrised(
        along, arc_over(length, 5.0, 3.0, 1.0, sweep, 5.0 + 3.0 * math.cos(1.0 + sweep), True)
    )
    t = share * along.duration
    h = 1e-5 * along.duration
    if any(abs(knot - t) < 2.0 * h for knot in along.knots) or not 2.0 * h < t < along.duration - 2.0 * h:
        return
    slope = (made.position(t + h) - made.position(t - h)) / (2.0 * h)
    bend = (made.velocity(t + h) - made.velocity(t - h)) / (2.0 * h)
    assert made.velocity(t) == pytest.approx(slope, abs=1e-4 * made.peak_speed + 1e-9)
    assert made.acceleration(t) == pytest.approx(bend, abs=1e-3 * made.peak_acceleration + 1e-9)


def test_a_curve_of_one_piece_is_not_searched_for_the_part_travelled(monkeypatch: pytest.MonkeyPatch) -> None:
    along = plan("trapezoid", 0.0, CIRCLE, 20.0, 50.0, 50.0)
    monkeypatch.setattr(Profile, "extrema", None)
    quarter = travelled(along, arc_over(CIRCLE, 0.0, 10.0, 0.0, 0.5 * math.pi, 0.0, True))
    assert quarter.position(along.duration) == pytest.approx(0.0, abs=1e-9)
    assert quarter.velocity(0.5 * along.duration) == pytest.approx(-5.0 * math.sin(0.25 * math.pi))


def all_kinds() -> list[Profile]:
    arc = circle()
    wave = plan("sinusoidal", 0.0, 7.0, 20.0, 50.0, 50.0)
    tail = plan("sinusoidal", arc.end, 3.0, 20.0, 50.0, 50.0)
    jog = plan_velocity("trapezoid", 0.0, 0.0, 5.0, 20.0, 20.0)
    return [
        arc,
        added(arc, wave, "sum"),
        arc.then(tail),
        tail.then(added(arc, wave, "sum").shifted(-7.0)),
        added(circle(False), jog, "sum"),
        added(wave, plan("sinusoidal", 0.0, 9.0, 10.0, 50.0, 50.0), "sum"),
    ]


@pytest.mark.parametrize("index", range(6))
def test_every_kind_answers_as_its_samples_say(index: int) -> None:
    made = all_kinds()[index]
    duration = min(made.duration, 6.0)
    n = 4001
    t = np.arange(n) * (duration / (n - 1))
    by_hand = [
        np.array([read(x) for x in t.tolist()])
        for read in (made.position, made.velocity, made.acceleration, lambda x: made.at(x).jerk)
    ]
    for order, column in enumerate(by_hand):
        found = PieceTable((0.0,), (made,)).sample(0.0, duration / (n - 1), n, order)
        assert np.abs(found - column)[:-1].max() <= 1e-9
    if made.duration < math.inf:
        low, high = made.extrema()
        assert low - 1e-9 <= by_hand[0].min() <= low + 1e-3
        assert high - 1e-3 <= by_hand[0].max() <= high + 1e-9
    assert np.abs(by_hand[1]).max() == pytest.approx(made.peak_speed, rel=1e-3)
    for wanted in (0.1, 0.5, 0.9):
        level = float(by_hand[0].min() + wanted * (by_hand[0].max() - by_hand[0].min()))
        first = made.crossing(level)
        assert first is not None
        assert made.position(first) == pytest.approx(level, abs=1e-9)
        signs = np.sign(by_hand[0] - level)
        assert first == pytest.approx(t[np.flatnonzero(signs != signs[0])[0]], abs=2.0 * duration / n)


@pytest.mark.parametrize("index", range(6))
@pytest.mark.parametrize("share", [0.13, 0.5, 0.77])
def test_cut_and_after_are_the_two_halves(index: int, share: float) -> None:
    made = all_kinds()[index]
    at = share * min(made.duration, 6.0)
    head, tail = made.cut(at), made.after(at)
    assert head.duration == pytest.approx(at)
    for t in np.linspace(0.0, 6.0, 41).tolist():
        half = head.position(t) if t <= at else tail.position(t - at)
        assert half == pytest.approx(made.position(t), abs=1e-9)
    whole = head.then(tail)
    assert whole.position(at * 1.1) == pytest.approx(made.position(at * 1.1), abs=1e-9)
    moved = made.scaled(100.0, -2.0)
    assert moved.position(at) == pytest.approx(100.0 - 2.0 * (made.position(at) - made.start), abs=1e-9)


@pytest.mark.parametrize("index", range(6))
def test_the_pieces_to_draw_by_are_close(index: int) -> None:
    made = all_kinds()[index]
    size = max(abs(x) for x in made.cut(6.0).extrema())
    knots, pieces, _ = made.drawn
    for piece, begin, finish in zip(pieces, knots, knots[1:], strict=False):
        x = 0.5 * (min(finish, begin + 1.0) - begin)
        assert position_in(piece, x) == pytest.approx(made.position(begin + x), abs=3e-9 * size)
    assert made.knots[-1] == knots[-1]


def test_a_track_mixes_formulas_and_pieces() -> None:
    arc = circle()
    starts = [0.0, 2.0, 7.0]
    profiles = [
        arc,
        plan_trapezoid(arc.position(2.0), 0.0, 10.0, 50.0, 50.0, arc.velocity(2.0)),
        circle().shifted(-10.0),
    ]
    found = PieceTable(starts, profiles).sample(0.0, 0.01, 1200)
    assert found[100] == arc.position(1.0)
    assert found[300] == pytest.approx(profiles[1].position(1.0), abs=1e-12)
    assert found[800] == pytest.approx(profiles[2].position(1.0), abs=1e-12)
    assert found[1199] == pytest.approx(0.0, abs=1e-12)


def test_what_is_straight_stays_in_pieces() -> None:
    along = plan_trapezoid(0.0, 50.0, 100.0, 1000.0, 1000.0)
    made = travelled(along, line_over(50.0, 10.0, 40.0))
    assert type(made) is Profile
    assert (made.start, made.end, made.peak_speed) == (10.0, 40.0, 60.0)
    assert isinstance(
        travelled(along, arc_over(50.0, 0.0, 50.0, 0.0, 1.0, 50.0 * math.cos(1.0), True)), Reparametrised
    )


def test_the_sum_of_pieces_is_pieces() -> None:
    first, second = (
        plan_trapezoid(5.0, 105.0, 50.0, 100.0, 100.0),
        plan_trapezoid(0.0, 20.0, 20.0, 100.0, 200.0),
    )
    made = added(first, second, "offset")
    assert type(made) is Profile
    assert (made.start, made.end, made.duration) == (5.0, 125.0, first.duration)
    assert made.peak_speed == pytest.approx(70.0)
    late = added(first.after(1.0), second.after(1.0), "offset")
    assert late.position(0.5) == pytest.approx(first.position(1.5) + second.position(1.5))
    moving = added(first.after(0.25), second.after(0.1), "offset")
    assert (moving.start_velocity, moving.end_velocity) == (25.0 + 10.0, 0.0)


def test_a_chain_keeps_its_phases_or_has_one_of_its_own() -> None:
    arc = circle()
    row = arc.then(plan_trapezoid(10.0, 0.0, 10.0, 50.0, 50.0))
    assert [phase.name for phase in row.phases] == ["accel", "slew", "decel"] * 2
    (whole,) = ProfileSequence("follow", [arc, arc]).phases
    assert (whole.name, whole.duration, whole.distance) == ("follow", 2.0 * arc.duration, 0.0)


def test_a_velocity_is_found_in_whichever_part_of_a_chain_runs_at_it_first() -> None:
    out, back = plan_trapezoid(0.0, 10.0, 10.0, 100.0, 100.0), plan_trapezoid(10.0, 0.0, 10.0, 100.0, 100.0)
    row = ProfileSequence("follow", [out, back])
    assert row.velocity_crossing(5.0) == pytest.approx(0.05)
    assert row.velocity_crossing(5.0, after=0.06) == pytest.approx(1.05)
    assert row.velocity_crossing(-5.0) == pytest.approx(1.1 + 0.05)
    assert row.velocity_crossing(11.0) is None
    assert row.crossing(5.0, after=0.6) == pytest.approx(1.1 + 0.55)
    assert row.velocity_crossing(0.0, after=9.0) == 9.0  # it is at rest after its end


def test_a_velocity_at_the_end_of_a_part_is_found_although_the_next_part_begins_otherwise() -> None:
    out = plan_trapezoid(0.0, 10.0, 10.0, 100.0, 100.0)
    row = ProfileSequence("pvt", [out.cut(0.1), out.cut(0.05).shifted(0.5)])
    assert row.velocity_crossing(10.0) == pytest.approx(0.1)


@pytest.mark.parametrize("degrees", [0, 90, 180, 270, 360, -90, 450])
def test_quarter_turns_are_exact(degrees: float) -> None:
    x, y = rotated(3.0, 4.0, degrees)
    assert sorted((abs(x), abs(y))) == [3.0, 4.0]
    assert rotated(*rotated(3.0, 4.0, degrees), -degrees) == (3.0, 4.0)


@pytest.mark.parametrize("datum", [0.0, 0.0108, 0.3, 1e-7])
def test_a_bend_in_the_curve_is_drawn_as_a_jump_of_the_velocity_and_nothing_else(datum: float) -> None:
    """A cam of straight lines, with a master that accelerates at 360.

    Rounding determines on which side of a kink a time is.
    """
    rises = [0.0, 10.0, 40.0, 80.0, 100.0, 80.0, 40.0, 10.0]
    distances = [45.0 * n for n in range(9)]
    cam = table_curve(distances, [datum + sum(rises[:n]) for n in range(9)])
    drawn = Reparametrised(plan_trapezoid(0.0, 360.0, 1000.0, 360.0, 360.0), cam)
    knots, pieces, _ = drawn.drawn
    for piece, begin, finish in zip(pieces, knots, knots[1:], strict=False):
        steepest = 360.0 * 100.0 / 45.0
        assert abs(2.0 * piece[2]) <= steepest * 1.000001
        assert abs(2.0 * piece[2] + 6.0 * piece[3] * (finish - begin)) <= steepest * 1.000001


@pytest.mark.parametrize("distance", [-1e-13, 0.0, 1.0, 2.0, 2.0 + 1e-13, 2.0 + 1e-9])
def test_a_rest_within_rounding_of_the_end_of_a_curve_is_a_rest(distance: float) -> None:
    made = Reparametrised(hold(distance), LIFTED)
    assert made.at(5.0).position == pytest.approx(made.start)
    assert (made.velocity(5.0), made.peak_speed, made.crossing(99.0), len(made.pieces)) == (0.0, 0.0, None, 1)


def test_a_place_at_the_end_of_a_curve_is_as_bent_as_before_it() -> None:
    """A slope that rises from 0 to 2 over 10; at its end the speed is 3, the rate 4.

    The acceleration there is 0.2 * 3² + 2 * 4 = 9.8.
    """
    piece = (0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0)
    curve = from_curve("fly", 0.0, 10.0, ((0.0, 10.0), (piece,), (("fly", 0),)), 0.0, 2.0)
    along = from_curve(
        "trapezoid",
        10.0 - 1e-13,
        15.0,
        ((0.0, 1.0), ((10.0 - 1e-13, 3.0, 2.0, 0.0, 0.0, 0.0, 0.0),), (("accel", 0),)),
        3.0,
        7.0,
    )
    made = Reparametrised(along, curve)
    assert made.at(0.0).acceleration == pytest.approx(9.8)
    assert made.at(0.0).velocity == pytest.approx(6.0)
    assert evaluate(made, np.array([0.0]), 2)[0] == pytest.approx(9.8)
    assert made.at(0.5).acceleration == pytest.approx(8.0)
    assert evaluate(made, np.array([0.5]), 2)[0] == pytest.approx(8.0)
    # The beginning: curved by 0.2 on either side of it, and straight, with a slope of 0, farther out.
    back = Reparametrised(along.shifted(-10.0), curve)
    assert back.at(0.0).acceleration == pytest.approx(1.8)
    assert evaluate(back, np.array([0.0]), 2)[0] == pytest.approx(1.8)


@pytest.mark.parametrize(
    ("position", "after", "expected"),
    [
        (3.0, 0.0, 0.5),  # 3 before the curve, on its straight continuation
        (6.0, 0.0, 2.0),  # where the curve begins
        (9.0, 0.0, 2.5),  # on the curve: 1 + 1 + 1 + 1 + 5
        (9.0, 2.6, None),  # it is there once: its continuations have 9 at distances on the curve
        (20.0, 0.0, 3.0),  # where the curve ends
        (54.0, 0.0, 4.0),  # 2 beyond: 15 + 17 * 2 + 5
        (54.0, 4.1, None),
        (1.0, 0.0, None),  # before the motion begins
    ],
)
def test_a_curve_and_its_straight_continuations_are_crossed_once(
    position: float, after: float, expected: float | None
) -> None:
    """The position is 6 + x before the curve, and 20 + 17 * (x - 2) beyond it.

    The distance x is -4 + 2t.
    """
    found = Reparametrised(UNIFORM, LIFTED, "cam", 5.0).crossing(position, after)
    assert found == (None if expected is None else pytest.approx(expected))


def test_a_curve_that_begins_and_ends_level_is_crossed_on_the_curve_alone() -> None:
    """The cubic rises by 10 over 4, and is at 5 in its middle."""
    level = from_curve("cam", 0.0, 10.0, ((0.0, 4.0), (CUBIC,), (("cam", 0),)), 0.0, 0.0)
    made = Reparametrised(UNIFORM, level)
    assert made.crossing(5.0) == pytest.approx(3.0)
    assert (made.crossing(-1.0), made.crossing(11.0)) == (None, None)
    assert made.extrema() == pytest.approx((0.0, 10.0))


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (-4.0, 16.0, (2.0, 258.0)),  # 6 - 4 and 20 + 17 * 14
        (-4.0, 1.0, (2.0, 9.0)),
        (1.0, 4.0, (9.0, 54.0)),
    ],
)
def test_the_figures_of_a_curve_at_uniform_speed(
    low: float, high: float, expected: tuple[float, float]
) -> None:
    """On 1 + x + x² + x³ the slope grows from 1 to 17, and f'' from 2 to 14.

    The speed along it is 2.
    The knots are those of the motion, and the times at which it is at the ends of the curve.
    """
    made = Reparametrised(UNIFORM.cut((high + 4.0) / 2.0).after((low + 4.0) / 2.0), LIFTED, "cam", 5.0)
    slope, bend = (17.0, 14.0) if high > 2.0 else (6.0, 8.0)
    assert made.extrema() == pytest.approx(expected)
    assert (made.peak_speed, made.peak_acceleration) == pytest.approx((2.0 * slope, 4.0 * bend))
    assert made.speed_bound == 34.0
    ends = [distance for distance in (0.0, 2.0) if low < distance < high]
    assert made.knots == pytest.approx([(distance - low) / 2.0 for distance in (low, *ends, high)])
    (phase,) = made.phases
    assert (phase.duration, phase.distance) == pytest.approx(((high - low) / 2.0, expected[1] - expected[0]))
    velocities = made.start_velocity, made.end_velocity
    assert (phase.start_velocity, phase.end_velocity) == pytest.approx(velocities)
    back = Reparametrised(UNIFORM.scaled(high, -1.0).cut((high - low) / 2.0), LIFTED, "cam", 5.0)
    assert back.extrema() == pytest.approx(expected)
    assert (back.peak_speed, back.crossing(expected[1])) == pytest.approx((2.0 * slope, 0.0))


@pytest.mark.parametrize(
    ("low", "high", "is_plain"),
    [
        (0.0, 3.0, True),
        (1.0, 3.0, True),
        (3.0, 5.0, False),
        (3.0, 4.0, False),
        (5.0, 9.0, True),
        (6.0, 9.0, True),
        (-2.0, 1.0, True),
        (2.0, 5.0, False),
        (4.0, 6.0, False),
    ],
)
@pytest.mark.parametrize("shape", ["", "cam"])
def test_a_straight_section_of_a_curve_makes_plain_pieces(
    low: float, high: float, is_plain: bool, shape: str
) -> None:
    """Straight up to 3 with slope 2, curved up to 5, straight from there with slope 4.

    It is raised by 7.
    2 * 3 = 6 at the first knot; 6 + 2 * 2 + 0.5 * 2² = 12 at the second.
    """
    curve = from_curve(
        "fly",
        0.0,
        24.0,
        (
            (0.0, 3.0, 5.0, 8.0),
            (
                (0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0),
                (6.0, 2.0, 0.5, 0.0, 0.0, 0.0, 0.0),
                (12.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0),
            ),
            (("fly", 0),),
        ),
        2.0,
        4.0,
    )
    made = travelled(plan_trapezoid(low, high, 10.0, 100.0, 100.0), curve, shape, 7.0)
    assert (type(made) is Profile) == is_plain
    assert made.shape == (shape or "trapezoid")

    def on(x: float) -> float:
        return 7.0 + (
            2.0 * x
            if x < 3.0
            else 12.0 + 4.0 * (x - 5.0)
            if x > 5.0
            else 6.0 + 2.0 * (x - 3.0) + 0.5 * (x - 3.0) ** 2
        )

    assert (made.start, made.end) == pytest.approx((on(low), on(high)))
    assert made.position(0.5 * made.duration) == pytest.approx(on(0.5 * (low + high)))


@pytest.mark.parametrize(
    ("distance", "slope", "bend"),
    [
        (-3.0, 1.0, 0.0),
        (-3e-11, 1.0, 0.0),
        (-1.5e-11, 1.0, 2.0),  # within rounding of the beginning
        (0.0, 1.0, 2.0),
        (0.5, 2.75, 5.0),
        (2.0, 17.0, 0.0),
        (2.0 + 1.5e-11, 17.0, 0.0),  # a motion that begins beyond the end
        (2.0 + 3e-11, 17.0, 0.0),
        (4.0, 17.0, 0.0),
    ],
)
def test_the_curvature_ends_with_the_curve(distance: float, slope: float, bend: float) -> None:
    """Velocity is 3 f', acceleration 9 f'' + 2 f', jerk 27 f''' + 18 f'' + 6 f'.

    Here s' = 3, s'' = 2 and s''' = 6.
    f' = 1 + 2x + 3x² and f'' = 2 + 6x on the curve. f''' = 6 belongs to the inside alone, where the position is
    f + 5; the straight continuations are 6 + x and 20 + 17 (x - 2).
    """
    piece = (distance, 3.0, 1.0, 1.0, 0.0, 0.0, 0.0)
    along = from_curve("cam", distance, distance + 5.0, ((0.0, 1.0), (piece,), (("accel", 0),)), 3.0, 8.0)
    state = Reparametrised(along, LIFTED, "cam", 5.0).at(0.0)
    third = 6.0 if -2e-11 <= distance < 2.0 else 0.0
    assert (state.velocity, state.acceleration) == pytest.approx((3.0 * slope, 9.0 * bend + 2.0 * slope))
    assert state.jerk == pytest.approx(27.0 * third + 18.0 * bend + 6.0 * slope)
    x = distance
    inside = 6.0 + x + x * x + x * x * x
    assert state.position == pytest.approx(
        6.0 + x if x < 0.0 else inside if x < 2.0 else 20.0 + 17.0 * (x - 2.0)
    )


def test_the_last_phase_of_an_endless_motion_ends_at_its_velocity() -> None:
    """From 2 to 4 at 2/s² in 1 s and over 3; the curve is left with a slope of 17."""
    made = Reparametrised(plan_velocity("trapezoid", -4.0, 2.0, 4.0, 2.0, 50.0), LIFTED, "cam", 5.0)
    accel, slew = made.phases
    assert (accel.name, accel.duration, accel.distance) == ("accel", 1.0, 3.0)
    assert (accel.start_velocity, accel.end_velocity) == (2.0, 4.0)
    assert (slew.name, slew.duration, slew.distance) == ("slew", math.inf, math.inf)
    assert (slew.start_velocity, slew.end_velocity) == (4.0, 68.0)


@pytest.mark.parametrize("factor", [1.0, 2.0, -3.0])
def test_a_scaled_curve_keeps_its_form(factor: float) -> None:
    """Every distance from the start, 9, is multiplied; the new start is 30."""
    made = Reparametrised(UNIFORM.after(2.5), LIFTED, "cam", 5.0)
    scaled = made.scaled(30.0, factor)
    assert (scaled.start, scaled.shape) == (30.0, "cam")
    for time in (0.0, 0.3, 1.0, 4.0):
        assert scaled.position(time) == pytest.approx(30.0 + factor * (made.position(time) - 9.0)), time
        assert scaled.velocity(time) == pytest.approx(factor * made.velocity(time)), time


def test_the_ends_of_a_motion_cut_nothing_off() -> None:
    made = Reparametrised(UNIFORM, LIFTED, "cam", 5.0)
    assert made.cut(made.duration) is made.after(0.0) is made
    assert made.after(0.5).start == 3.0


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (-3.0, 0.0, (2.0, 8.0)),  # up to the beginning, where the slope is 1 and f'' is 2
        (2.0, 4.0, (34.0, 0.0)),  # from the end on, where it is 17
        (0.0, 2.0, (34.0, 56.0)),
        (0.0, 0.5, (5.5, 20.0)),  # 1 + 1 + 0.75 and 2 + 3
        (0.5, 2.0, (34.0, 56.0)),
        (0.5, 0.75, (2.0 * 4.1875, 26.0)),  # 1 + 1.5 + 1.6875 and 2 + 4.5
    ],
)
def test_only_the_section_travelled_has_peaks(low: float, high: float, expected: tuple[float, float]) -> None:
    along = UNIFORM.cut((high + 4.0) / 2.0).after((low + 4.0) / 2.0)
    made = Reparametrised(along, LIFTED, "cam", 5.0)
    assert (made.peak_speed, made.peak_acceleration) == pytest.approx(expected)


def test_a_rest_without_an_end_is_a_phase_of_no_distance() -> None:
    """The motion stops at a distance of 1, where the curve is at 10 times as much."""
    line = line_over(5.0, 0.0, 50.0)
    made = Reparametrised(with_rest(plan_trapezoid(0.0, 1.0, 1.0, 2.0, 2.0)), line)
    assert [phase.distance for phase in made.phases] == pytest.approx([2.5, 5.0, 2.5, 0.0])
    assert made.phases[-1].duration == math.inf


def test_a_velocity_at_uniform_speed_is_checked_again_where_the_curve_has_its_slope() -> None:
    """At 20 on a circle of 10, x = 10 cos(2 t) has the velocity -20 sin(2 t).

    The ramp at 50 takes 0.4 s and covers 4, or 0.4 rad: t counts from 0.2 s.
    """
    made = circle()
    assert made.velocity_check(-10.0, 0.41) == pytest.approx(0.2 + 0.5 * math.pi / 6.0)
    assert made.velocity_check(-10.0, 0.5) == pytest.approx(0.2 + 0.5 * math.pi / 2.0)  # the crest at -20
    assert made.velocity_check(-10.0, 1.0) == pytest.approx(0.2 + 0.5 * (math.pi - math.pi / 6.0))
    # The next knot is where x turns.
    assert made.velocity_check(-20.5, 1.0) == pytest.approx(0.2 + 0.5 * math.pi)
    assert made.velocity_check(10.0, 1.8) == pytest.approx(0.2 + 0.5 * (math.pi + math.pi / 6.0))


def sampled_velocity(made: Profile, wanted: float, after: float, until: float) -> float:
    """Return when samples of the velocity, 2000 up to `until`, first change sides."""
    times = np.linspace(after, until, 2001)[:-1]
    found = evaluate(made, times, 1)
    for k in np.flatnonzero(np.abs(found - wanted) < 1e-9).tolist():  # the last bits decide
        found[k] = made.velocity(times[k])
    below = found < wanted
    changed = np.flatnonzero(below[1:] != below[:-1])
    return float(times[changed[0] + 1]) if len(changed) else until


@pytest.mark.parametrize("wanted", [-19.0, -3.0, 0.0, 7.5, 18.0])
@pytest.mark.parametrize("shape", ["trapezoid", "scurve"])
@pytest.mark.parametrize("form", ["circle", "reverse", "sequence", "sum"])
def test_a_velocity_is_checked_again_where_it_is_reached_and_at_each_knot(
    form: str, shape: str, wanted: float
) -> None:
    """Samples show that the velocity does not pass the level between two checks."""
    made = circle(sweep=5.0, shape=shape)
    if form == "reverse":
        made = circle(sweep=-5.0, shape=shape)
    elif form == "sequence":
        made = ProfileSequence("two", [made, circle(sweep=-2.0, shape=shape).scaled(made.end, 1.0)])
    elif form == "sum":
        made = added(made, circle(cosine=False, sweep=4.0, shape=shape), "sum")
    time, checks = 0.0, 0
    while time < made.duration:
        following = made.velocity_check(wanted, time)
        passed = sampled_velocity(made, wanted, time, following)
        assert passed >= following - 1e-3 * (following - time)
        knot = next(each for each in made.knots if each > time)
        assert time <= following <= knot
        time, checks = max(following, time + 1e-3), checks + 1
    assert checks < 10 * len(made.knots)


@pytest.mark.parametrize("sweep", [2.0 * math.pi, -0.7])
@pytest.mark.parametrize("shape", ["trapezoid", "sinusoidal", "scurve"])
@pytest.mark.parametrize("cosine", [True, False])
def test_the_figures_of_a_time_are_those_of_its_state(cosine: bool, shape: str, sweep: float) -> None:
    """They have the same bits inside the profile, at its knots, and outside."""
    made = circle(cosine, sweep, shape)
    made = made.scaled(made.start + 3.0, 1.0)
    duration = made.duration
    times = [-1.0, 0.0, duration, math.nextafter(duration, 0.0), duration + 1.0, 1e-300]
    times += [knot + by for knot in made.knots for by in (-1e-9, 0.0, 1e-9)]
    times += [duration * k / 997 for k in range(1, 997)]
    for time in times:
        if 0.0 < time < duration:
            state = made.state(time)
            assert made.position(time) == state.position
            assert made.velocity(time) == state.velocity
            assert made.acceleration(time) == state.acceleration
        else:
            assert made.position(time) == (made.end if time > 0.0 else made.start)
            assert made.velocity(time) == 0.0
