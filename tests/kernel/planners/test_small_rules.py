"""Small rules of the motion mathematics, each covered by this test alone."""

from __future__ import annotations

from math import inf, nextafter, pi, sqrt, tanh
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest

from motionlang.commands.plan.reach import remedies
from motionlang.commands.plan.solve import solve_move
from motionlang.kernel.planners import Profile, plan, plan_trapezoid, plan_velocity
from motionlang.kernel.planners.arc import arc_over, line_over
from motionlang.kernel.planners.cubics import _fitted, cubics
from motionlang.kernel.planners.limits import LARGEST, SMALLEST
from motionlang.kernel.planners.lookahead import PathPace, plan_course
from motionlang.kernel.planners.ramps import MOMENT
from motionlang.kernel.planners.segment_speed import _farthest, between, entry_speed, exit_speed
from motionlang.kernel.planners.shapes import peak_from_rest, ramps_of
from motionlang.kernel.planners.superposition import added
from motionlang.kernel.planners.table_motion import spline_slopes
from motionlang.kernel.planners.transition import REST, joined
from tests.kernel.planners.cases import plan_jerk

if TYPE_CHECKING:
    from collections.abc import Callable


LIMITS = (200.0, 400.0, 400.0)
MOVE = plan_trapezoid(0.0, 100.0, *LIMITS)


@pytest.mark.parametrize("given", [{"time": 1.0}, {"time": 1.0, "distance": 200.0}, {"distance": 200.0}])
def test_equal_ramps_need_the_speed_too(given: dict[str, float]) -> None:
    with pytest.raises(ValueError, match="equal ramps need distance, speed and time"):
        solve_move("equal", **given)


def test_a_speed_that_even_a_triangle_exceeds_has_the_two_ends_of_its_range() -> None:
    assert remedies(None, {"distance": 100.0, "time": 1.0, "speed": 300.0}) == [
        "speed above 100 and up to 200",
        "time above 0.333333 and up to 0.666667",
        "distance from 150 to below 300",
    ]


def test_what_is_too_fast_brakes_to_the_speed_and_holds_it() -> None:
    ramps = ramps_of("trapezoid", 10.0, 10.0, 0.0, inf, inf)
    _, rows = between(ramps, 100.0, 10.0, 20.0, 0.0, 5.0)
    assert [row[1] for row in rows] == pytest.approx([1.0, (100.0 - 15.0 - 3.75) / 10.0, 0.5])
    assert [row[0] for row in rows] == [20.0, 10.0, 10.0]


def test_a_course_that_is_over_already_stands() -> None:
    made = plan_course([(10.0, PathPace("trapezoid", *LIMITS))], 10.0, 0.0)
    assert made is not None
    assert (made.duration, made.position(5.0), made.end_velocity) == (0.0, 10.0, 0.0)


@pytest.mark.parametrize("v0", [1e-3, -1e-3])
def test_an_axis_that_stops_within_rounding_of_its_target_does_not_return(v0: float) -> None:
    """The stop takes v/A = 10 µs and v²/2A = 5e-9; doubles at 1e9 are 1e-7 apart."""
    assert plan_trapezoid(1e9, 1e9, 100.0, 100.0, 100.0, v0).duration == pytest.approx(1e-5)


def test_a_scaled_profile_makes_its_pieces_when_the_first_one_has_them() -> None:
    fresh = plan_trapezoid(0.0, 100.0, *LIMITS)
    assert not hasattr(fresh.scaled(5.0, 2.0), "_curve")
    knots = fresh.knots
    assert fresh.scaled(5.0, 2.0).knots is knots


def test_a_profile_of_ramps_too_short_to_count_stands_still() -> None:
    time = 0.5 * MOMENT
    made = Profile("trapezoid", 3.0, 3.0, time, (0.0, time, 0.0, 0.0))
    assert made.knots == (0.0, time)
    assert made.pieces == ((3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),)
    assert made.curve[2] == (("slew", 0),)


def test_a_ramp_that_never_ends_is_a_move_too_large() -> None:
    with pytest.raises(ValueError, match="the move is too large"):
        joined("trapezoid", 0.0, 1.0, REST, (0.0, inf, 0.0, 1.0))


def test_a_wave_is_added_to_one_without_height() -> None:
    wave = plan("sinusoidal", 0.0, 100.0, *LIMITS)
    assert wave.drawn[1][0][4]
    both = added(wave.scaled(0.0, 0.0), wave, "sum")
    time = 0.3 * wave.knots[1]
    assert both.position(time) == pytest.approx(wave.position(time), rel=1e-12)
    assert both.position(time) != pytest.approx(wave.drawn[1][0][1] * time)


@pytest.mark.parametrize("time", [0.1, 0.2, 0.4, 0.75])
def test_the_rest_of_a_sum_begins_where_the_sum_is(time: float) -> None:
    """Two waves overlap: a sum without pieces, which ends after 0.2 s at 10."""
    first = plan_velocity("sinusoidal", 0.0, 0.0, 10.0, 100.0, 100.0).cut(0.2)
    both = added(first, plan("sinusoidal", 0.0, 1.0, *LIMITS), "sum")
    assert (both.pieced, both.end_velocity, both.duration) == (False, 10.0, 0.2)
    total = added(both, plan("sinusoidal", 0.0, 100.0, *LIMITS), "sum")
    assert total.duration > 1.0
    rest = total.after(time)
    for later in (0.0, 0.05, 0.2):
        assert rest.position(later) == pytest.approx(total.position(time + later), rel=1e-12)
        assert rest.velocity(later) == pytest.approx(total.velocity(time + later), rel=1e-9)


def test_a_move_from_rest_takes_numbers_that_add_up_to_the_largest() -> None:
    """100 at rates of 100 takes a second up and a second down, at any higher speed."""
    assert plan_trapezoid(0.0, 100.0, LARGEST, 100.0, 100.0).duration == 2.0
    with pytest.raises(ValueError, match="speed must lie between 1e-60 and 1e"):
        plan_trapezoid(0.0, 100.0, nextafter(LARGEST, inf), 100.0, 100.0)


@pytest.mark.parametrize("most", [1000.0, 110.0])
def test_a_segment_limits_its_speeds_by_the_squares(most: float) -> None:
    """Over 20 units, squared speeds differ from 100² by 2·200·20 up or 2·400·20 down."""
    ramps = ramps_of("trapezoid", 200.0, 400.0, 0.0, inf, inf)
    assert exit_speed(ramps, 20.0, 100.0, 0.0, most) == pytest.approx(min(most, sqrt(18_000.0)))
    assert entry_speed(ramps, 20.0, 100.0, most) == pytest.approx(min(most, sqrt(26_000.0)))


@pytest.mark.parametrize("shape", ["trapezoid", "sinusoidal", "parabolic", "scurve"])
@pytest.mark.parametrize("index", range(3))
def test_the_smallest_speed_and_rates_are_allowed_and_smaller_ones_are_not(shape: str, index: int) -> None:
    def planned(figure: float) -> Profile:
        figures = [1.0, 1.0, 1.0]
        figures[index] = figure
        speed, accel, decel = figures
        return plan(shape, 0.0, 1.0, speed, accel, decel, ramp=0.5)

    assert planned(SMALLEST).end == 1.0
    with pytest.raises(ValueError, match=r"."):
        planned(nextafter(SMALLEST, 0.0))


@pytest.mark.parametrize(("low", "high"), [(0.0, 10.0), (10.0, 0.0), (1.0, 1e3), (3.0, 2.0)])
@pytest.mark.parametrize(
    ("curve", "most"),
    [
        (lambda x: x - 2.5, 9),
        (lambda x: x**3 - 15.625, 33),
        (lambda x: sqrt(x) - sqrt(2.5), 20),
        (lambda x: tanh(x - 2.5), 21),
        (lambda x: (x > 2.5) - 0.5, 90),  # a jump leaves only bisection
    ],
)
def test_the_farthest_number_that_fits_is_found_to_the_last_bit(
    low: float, high: float, curve: Callable[[float], float], most: int
) -> None:
    """Numbers on the side of 2.5 that `low` is on fit; bisection takes over 50 values."""
    sign = 1.0 if high > low else -1.0
    calls = []

    def beyond(x: float) -> float:
        calls.append(x)
        return sign * curve(x)

    found = _farthest(low, high, beyond)
    assert len(calls) <= most
    assert beyond(found) <= 0.0
    assert beyond(nextafter(found, high)) > 0.0
    assert found == pytest.approx(2.5, rel=1e-15)


@pytest.mark.parametrize("ramp", [0.0, -0.1, nextafter(0.5, 1.0), 1.5])
def test_a_ramp_takes_at_most_half_of_the_time(ramp: float) -> None:
    assert plan("scurve", 0.0, 1.0, 1.0, 1.0, 1.0, ramp=0.5).end == 1.0
    with pytest.raises(ValueError, match=r"ramp must be greater than zero and at most 0\.5"):
        plan("scurve", 0.0, 1.0, 1.0, 1.0, 1.0, ramp=ramp)


@pytest.mark.parametrize("fits", [0.0, -1.0])
def test_the_farther_end_is_the_farthest_number_if_it_fits(fits: float) -> None:
    assert _farthest(1.0, 9.0, lambda x: fits if x == 9.0 else -2.0) == 9.0


# The distance, the accelerations and the jerks, and the peak speed. At 100 and a jerk of 500 a ramp to 45 takes
# 0.65 s; without the rate, a ramp to v takes 2 sqrt(v / 500) s.
PEAKS: dict[str, tuple[float, tuple[float, float, float, float], float]] = {
    "both rates": (0.65 * 45.0, (100.0, 100.0, 500.0, 500.0), 45.0),
    "both rates are just reached": (0.4 * 20.0, (100.0, 100.0, 500.0, 500.0), 20.0),
    "neither": (0.2 * 5.0, (100.0, 100.0, 500.0, 500.0), 5.0),
    "both rates, of which the second is lower": (
        0.5 * 45.0 * (0.65 + 1.0), (100.0, 50.0, 500.0, 500.0), 45.0,
    ),
    "neither, with other jerks": (0.5 * 5.0 * (0.2 + 0.1), (100.0, 200.0, 500.0, 2000.0), 5.0),
}  # fmt: skip


@pytest.mark.parametrize("name", PEAKS)
def test_the_peak_of_a_move_from_rest(name: str) -> None:
    """A lower rate of 50 is reached at 5; a ramp at it to v takes v / 50 + 0.1 s."""
    size, figures, peak = PEAKS[name]
    assert peak_from_rest(size, *figures) == pytest.approx(peak)
    accel, decel, accel_jerk, decel_jerk = figures
    assert peak_from_rest(size, decel, accel, decel_jerk, accel_jerk) == pytest.approx(peak)


# The sweep, the length of the path and which of both axes; then the ends, their slopes, the knots and the waves.
ARCS: dict[str, tuple[tuple[float, float, bool], tuple[float, ...], list[tuple[float, ...]]]] = {
    "half a circle, sine": (
        (pi, 4.0, False), (5.0, 5.0, pi / 2, -pi / 2, 0.0, 4.0), [(2.0, pi / 4, 0.0)],
    ),
    "half a circle back, sine": (
        (-pi, 4.0, False), (5.0, 5.0, -pi / 2, pi / 2, 0.0, 4.0), [(-2.0, pi / 4, 0.0)],
    ),
    "three quarters, cosine": (
        (1.5 * pi, 6.0, True), (7.0, 5.0, 0.0, pi / 2, 0.0, 2.0, 6.0), [(2.0, pi / 4, pi / 2), (-2.0, pi / 4, 0.0)],
    ),
    "three quarters back, cosine": (
        (-1.5 * pi, 6.0, True), (7.0, 5.0, 0.0, pi / 2, 0.0, 2.0, 6.0),
        [(2.0, pi / 4, pi / 2), (-2.0, pi / 4, 0.0)],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", ARCS)
def test_an_axis_of_an_arc_consists_of_half_waves(name: str) -> None:
    """Around 5 with a radius of 2, each unit of the path is an angle of pi / 4."""
    (sweep, length, cosine), (start, end, slope, last_slope, *knots), waves = ARCS[name]
    made = arc_over(length, 5.0, 2.0, 0.0, sweep, end, cosine)
    assert (made.start, made.end, made.duration) == pytest.approx((start, end, length))
    assert made.end == end
    assert (made.start_velocity, made.end_velocity) == pytest.approx((slope, last_slope), abs=1e-12)
    assert made.knots == pytest.approx(knots)
    assert [piece[:4] for piece in made.drawn[1]] == [(5.0, 0.0, 0.0, 0.0)] * len(waves)
    assert [piece[4:] for piece in made.drawn[1]] == [pytest.approx(wave, abs=1e-12) for wave in waves]


@pytest.mark.parametrize("angle", [pi, -pi, 2.0 * pi, 0.0])
def test_an_axis_of_an_arc_that_starts_level_with_the_centre_starts_there(angle: float) -> None:
    """The sine of pi is 1.2e-16 in floats, which the report showed as the start."""
    assert arc_over(50.0 * pi, 0.0, 50.0, angle, pi, 0.0, cosine=False).start == 0.0


def test_an_axis_of_a_line_rises_evenly() -> None:
    made = line_over(4.0, 3.0, 1.0)
    assert (made.start, made.end, made.start_velocity, made.end_velocity) == (3.0, 1.0, -0.5, -0.5)
    assert made.pieces == ((3.0, -0.5, 0.0, 0.0, 0.0, 0.0, 0.0),)
    assert made.knots == (0.0, 4.0)


@pytest.mark.parametrize(
    ("widths", "rises", "cyclic", "slopes"),
    [
        # x²(9 - x) has no slope at 0 and 6; at 0, 2, 3 and 6 it is 0, 28, 54 and 108, with slopes of 24 and 27.
        ([2.0, 1.0, 3.0], [14.0, 26.0, 18.0], False, [0.0, 24.0, 27.0, 0.0]),
        ([2.0, 1.0, 3.0, 5.0], [7.0] * 4, True, [7.0] * 5),
        # 4/3 a + 8/3 b = 3 (3/1 - 1/3), and the same for b and a.
        ([1.0, 3.0], [3.0, -1.0], True, [2.0, 2.0, 2.0]),
        ([2.0], [7.0], False, [0.0, 0.0]),
    ],
)
def test_the_slopes_of_a_spline(
    widths: list[float], rises: list[float], cyclic: bool, slopes: list[float]
) -> None:
    assert spline_slopes(widths, rises, cyclic) == pytest.approx(slopes, abs=1e-12)


def test_a_sum_of_cubics_is_drawn_as_their_sums() -> None:
    """Each piece fits at once, so there are no knots but those of both motions."""
    first = plan_jerk(0.0, 100.0, *LIMITS, 2000.0, 2000.0)
    second = plan_trapezoid(5.0, 45.0, 50.0, 100.0, 100.0)
    knots, pieces, marks = cubics(added(first, second, "sum"))
    wanted = sorted({*first.knots, *second.knots})
    assert list(knots) == pytest.approx(wanted)
    assert marks == (("sum", 0),)
    for knot, piece in zip(wanted, pieces, strict=False):
        a, b = first.at(knot + 1e-9), second.at(knot + 1e-9)
        assert piece[:4] == pytest.approx(
            (
                a.position + b.position,
                a.velocity + b.velocity,
                0.5 * (a.acceleration + b.acceleration),
                (a.jerk + b.jerk) / 6.0,
            ),
            rel=1e-4,
            abs=1e-2,
        )


def test_a_sum_without_an_end_is_drawn_with_its_last_velocity() -> None:
    """At 0.5 s the jog is at 100 * 0.5²/2 and 50 per second."""
    jog = plan_velocity("trapezoid", 0.0, 0.0, 50.0, 100.0, 100.0)
    knots, pieces, _ = cubics(added(jog, jog, "sum"))
    assert knots == (0.0, 0.5, inf)
    assert pieces[0][:4] == pytest.approx((0.0, 0.0, 100.0, 0.0), abs=1e-6)
    assert pieces[1] == pytest.approx((25.0, 100.0, 0.0, 0.0, 0.0, 0.0, 0.0))


def test_a_known_end_replaces_that_of_the_pieces() -> None:
    end = nextafter(MOVE.end, inf)
    made = MOVE.ending_at(end)
    assert (made.start, made.end, made.duration, made.shape) == (0.0, end, MOVE.duration, "trapezoid")
    assert made.curve == MOVE.curve
    assert MOVE.ending_at(MOVE.end) is MOVE
    both = added(MOVE, MOVE, "sum")
    assert both.ending_at(end).end == end


Phases = list[tuple[str, float, float]]
BEHIND: Phases = [("accel", 0.7, 7.0), ("slew", inf, inf), ("decel", 0.894427, 8.944272)]
# The velocity, the acceleration and the target of a move; then its phases.
STARTS: dict[str, tuple[tuple[float, float, float], Phases]] = {
    # The rest of a ramp from 4.75: 15.25/40 + 0.2 - 0.05 s.
    "it speeds up": ((5.0, 10.0, 100.0), [("accel", 0.53125, 6.951302), *BEHIND[1:]]),
    # In 0.1 s down to 4.5, and from there in 15.5/40 + 0.2 s up.
    "it slows down": ((5.0, -10.0, 100.0), [("decel", 0.1, 0.466667), ("accel", 0.5875, 7.196875), *BEHIND[1:]]),
    # In 0.05 s up to 5.25, and from there in 2 sqrt(0.0525) s to rest.
    "away, and faster": (
        (5.0, 10.0, -100.0), [("accel", 0.05, 0.258333), ("stop", 0.458258, 1.202926), *BEHIND],
    ),
    # The rest of a ramp from 5.5 to rest: 2 sqrt(0.055) - 0.1 s.
    "away, and slower": ((5.0, -10.0, -100.0), [("stop", 0.369042, 0.756531), *BEHIND]),
    # In 0.6 s to -8, in 2 sqrt(0.08) s to rest, and 4.462742 with a peak of 8.80556.
    "through rest": (
        (10.0, -60.0, 1.0),
        [
            ("decel", 0.6, -1.2), ("stop", 0.565685, -2.262742), ("accel", 0.420139, 1.849774),
            ("decel", 0.593483, 2.612968),
        ],
    ),
    # In 0.3 s to 19, in 2 sqrt(0.19) s to rest, and 12.081908 back with a peak of 16.7894.
    "beyond the target": (
        (10.0, 60.0, 1.0),
        [
            ("accel", 0.3, 4.8), ("stop", 0.87178, 8.281908), ("accel", 0.619735, -5.202482),
            ("decel", 0.819497, -6.879426),
        ],
    ),
    # From 30 to 20 in 2 sqrt(0.1) s.
    "too fast": ((30.0, 0.0, 100.0), [("decel", 0.632456, 15.811388), *BEHIND[1:]]),
    # In 0.5 s to -11.5, and in 2 sqrt(0.115) s to rest.
    "into the other direction": (
        (1.0, -50.0, 100.0), [("accel", 0.5, -3.666667), ("stop", 0.678233, -3.89984), *BEHIND],
    ),
}  # fmt: skip


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("name", STARTS)
def test_a_move_that_begins_with_an_acceleration(name: str, sign: float) -> None:
    """The speed is 20, the rates are 40 and 50, the jerks 200 and 100.

    From rest to 20 it takes 20/40 + 0.2 s, and back to rest 2 sqrt(20/100) s. The slew covers what the ramps leave.
    """
    (v0, a0, target), wanted = STARTS[name]
    made = plan_jerk(0.0, sign * target, 20.0, 40.0, 50.0, 200.0, 100.0, sign * v0, sign * a0)
    assert (made.start, made.end, made.start_velocity, made.end_velocity) == (
        0.0,
        sign * target,
        sign * v0,
        0.0,
    )
    phases = made.phases
    assert [phase.name for phase in phases] == [kind for kind, _, _ in wanted]
    total_distance = 0.0
    for phase, (_, duration, distance) in zip(phases, wanted, strict=True):
        total_distance += phase.distance
        if duration == inf:
            assert phase.distance == pytest.approx(
                20.0 * phase.duration * (1.0 if target > 0.0 else -1.0) * sign
            )
            continue
        assert phase.duration == pytest.approx(duration, rel=1e-5)
        assert abs(phase.distance) == pytest.approx(abs(distance), rel=1e-5)
    assert total_distance == pytest.approx(sign * target)
    assert made.duration == pytest.approx(sum(phase.duration for phase in phases))
    assert made.at(0.0).acceleration == pytest.approx(sign * a0)


def test_a_bend_that_no_cubic_has_is_halved_so_often() -> None:
    """The bend at 0.3 is in the first half, the second quarter, and the third eighth."""

    def state(t: float) -> tuple[float, float, float, float]:
        return abs(t - 0.3), 1.0 if t > 0.3 else -1.0, 0.0, 0.0

    bent: Any = SimpleNamespace(state=state)
    found = list(_fitted(bent, 0.0, 1.0, (state(0.0), state(1.0)), 1e-9, 3))
    assert [end for end, _ in found] == [0.25, 0.375, 0.5, 1.0]


@pytest.mark.parametrize("shape", ["trapezoid", "sinusoidal", "parabolic", "scurve"])
@pytest.mark.parametrize("v0", [0.0, 1e-200, 1.0])
def test_the_smallest_distance_is_a_move(shape: str, v0: float) -> None:
    """Its ramps are below the range of a float, so no peak fills it exactly."""
    made = plan(shape, 0.0, 5e-324, *LIMITS, v0, ramp=0.5)
    assert made.end == 5e-324
    assert made.duration < 1.0
