"""Figures by hand of pieces, sums, screws, scales and the formulas of chapter 12."""

from __future__ import annotations

from math import inf, nan, pi

import pytest

from motionlang.commands.plan.reach import needed_distance, remedies, triangle
from motionlang.commands.plan.scale import linear_scale, rotary_scale
from motionlang.commands.plan.solve import solve_move
from motionlang.kernel.planners import (
    Profile,
    acceleration_in,
    crest_points,
    even_points,
    from_curve,
    hold,
    jerk_in,
    plan,
    plan_trapezoid,
    still_points,
    velocity_in,
)
from motionlang.kernel.planners.leadscrew import Leadscrew
from motionlang.kernel.planners.pieces import position_in, recentred, transformed
from motionlang.kernel.planners.sequence import ProfileSequence
from motionlang.kernel.planners.superposition import added
from motionlang.kernel.planners.table_motion import table_curve
from motionlang.lab.pvt.fit import motion_error, track_error
from motionlang.lab.pvt.points import Point, plan_points

Piece = tuple[float, float, float, float, float, float, float]
# x³ - 6x² + 9x + 2, with extrema at 1 and 3 and an inflection at 2.
CUBIC: Piece = (2.0, 9.0, -6.0, 1.0, 0.0, 0.0, 0.0)
# 1 + 4x - x², with a maximum at 2.
PARABOLA: Piece = (1.0, 4.0, -1.0, 0.0, 0.0, 0.0, 0.0)
LINE: Piece = (1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0)
# 5 + 3x + 2 sin(x/2 + pi/6): its rate is 3 + cos(x/2 + pi/6).
WAVE: Piece = (5.0, 3.0, 0.0, 0.0, 2.0, 0.5, pi / 6)


@pytest.mark.parametrize(
    ("piece", "x", "position", "velocity", "acceleration", "jerk"),
    [
        (CUBIC, 0.0, 2.0, 9.0, -12.0, 6.0),
        (CUBIC, 1.0, 6.0, 0.0, -6.0, 6.0),
        (CUBIC, 3.0, 2.0, 0.0, 6.0, 6.0),
        (PARABOLA, 3.0, 4.0, -2.0, -2.0, 0.0),
        (LINE, 3.0, 7.0, 2.0, 0.0, 0.0),
        # sin and cos of pi/2 are 1 and 0, of pi/6 0.5 and sqrt(3)/2.
        (WAVE, 2 * pi / 3, 7.0 + 2 * pi, 3.0, -0.5, 0.0),
        (WAVE, 0.0, 6.0, 3.0 + 0.75**0.5, -0.25, -0.25 * 0.75**0.5),
    ],
)
def test_a_piece_and_its_derivatives(
    piece: Piece, x: float, position: float, velocity: float, acceleration: float, jerk: float
) -> None:
    found = [each(piece, x) for each in (position_in, velocity_in, acceleration_in, jerk_in)]
    assert found == pytest.approx([position, velocity, acceleration, jerk], abs=1e-12)


@pytest.mark.parametrize("piece", [CUBIC, PARABOLA, LINE, WAVE])
@pytest.mark.parametrize("x", [0.0, 0.75, 2.5])
def test_a_piece_from_a_later_origin_is_the_same_curve(piece: Piece, x: float) -> None:
    later = recentred(piece, x)
    for each in (position_in, velocity_in, acceleration_in, jerk_in):
        assert each(later, 0.5) == pytest.approx(each(piece, x + 0.5), abs=1e-12)


@pytest.mark.parametrize(
    ("piece", "duration", "still", "even", "crests"),
    [
        (CUBIC, 4.0, [1.0, 3.0], [2.0], []),
        (CUBIC, 3.0, [1.0], [2.0], []),
        (CUBIC, 2.0, [1.0], [], []),
        (CUBIC, 1.0, [], [], []),
        (PARABOLA, 3.0, [2.0], [], []),
        (PARABOLA, 2.0, [], [], []),
        (LINE, 9.0, [], [], []),
        # (x + 1)³ - 1 turns nowhere in positive time; x³ + x has no turning point.
        ((0.0, 3.0, 3.0, 1.0, 0.0, 0.0, 0.0), 9.0, [], [], []),
        ((0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0), 9.0, [], [], []),
        # The rate 1 + 2 cos(x/2 + pi/6) is 0 at x/2 + pi/6 = 2 pi/3; the crest of the wave is at pi/2.
        ((5.0, 1.0, 0.0, 0.0, 4.0, 0.5, pi / 6), 4.0, [pi], [], [2 * pi / 3]),
        ((5.0, 1.0, 0.0, 0.0, 4.0, 0.5, pi / 6), 2.0, [], [], []),
        (WAVE, 4.0, [], [], [2 * pi / 3]),
    ],
)
def test_the_extrema_of_a_piece(
    piece: Piece, duration: float, still: list[float], even: list[float], crests: list[float]
) -> None:
    """A turning point at the end of a piece is not inside it."""
    assert list(still_points(piece, duration)) == pytest.approx(still)
    assert list(even_points(piece, duration)) == pytest.approx(even)
    assert list(crest_points(piece, duration)) == pytest.approx(crests)


def test_a_piece_is_scaled_about_a_position() -> None:
    """Position 2 becomes 10, and distances triple."""
    made = transformed(CUBIC, 3.0, 2.0, 10.0)
    assert position_in(made, 1.0) == 10.0 + 3.0 * (6.0 - 2.0)
    assert velocity_in(made, 0.0) == 27.0
    wave = transformed(WAVE, 3.0, 5.0, 10.0)
    assert position_in(wave, 0.5) - 10.0 == pytest.approx(3.0 * (position_in(WAVE, 0.5) - 5.0))


# 100 at 100 per second and 1000 per second²: 0.1 s, 0.9 s and 0.1 s.
MOVE = plan_trapezoid(0.0, 100.0, 100.0, 1000.0, 1000.0)
# 20 at 50 per second and 500 per second²: 0.1 s, 0.3 s and 0.1 s.
SHORT = plan_trapezoid(10.0, 30.0, 50.0, 500.0, 500.0)


def test_a_sequence_runs_one_profile_after_the_other() -> None:
    """The second one begins at 1.1 s; at 1.3 s it is 7.5 further, at 50 per second."""
    second = SHORT.shifted(90.0)
    both = ProfileSequence("both", [MOVE, second])
    assert (both.start, both.end, both.duration) == pytest.approx((0.0, 120.0, 1.6))
    assert (both.position(1.3), both.velocity(1.3)) == pytest.approx((107.5, 50.0))
    assert both.knots == pytest.approx((0.0, 0.1, 1.0, 1.1, 1.2, 1.5, 1.6))
    assert both.after(1.1).duration == pytest.approx(0.5)
    assert both.after(1.3).position(0.0) == pytest.approx(107.5)
    assert both.cut(0.5).duration == 0.5
    assert both.cut(1.3).end == pytest.approx(107.5)
    assert both.cut(9.0) is both
    assert both.after(0.0) is both
    assert MOVE.then(second).position(1.3) == pytest.approx(107.5)
    assert MOVE.then(hold(100.0).cut(0.0)) is MOVE
    assert hold(0.0).cut(0.0).then(MOVE) is MOVE
    doubled = both.scaled(1000.0, 2.0)
    assert (doubled.start, doubled.end, doubled.position(1.3)) == pytest.approx((1000.0, 1240.0, 1215.0))


@pytest.mark.parametrize(
    ("step", "actual", "message"),
    [
        (0.0, [0.0, 1.0], "must be above zero"),
        (-1.0, [0.0, 1.0], "must be above zero"),
        (1.0, [0.0], "two positions or more"),
        (1.0, [0.0, 0.0], "each above the one before"),
    ],
)
def test_a_table_of_a_leadscrew_that_cannot_be(step: float, actual: list[float], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Leadscrew(0.0, step, actual)


def test_counts_of_a_unit() -> None:
    """1000 lines are 4000 counts; a gear of 5 on a screw of 10 makes 2000 of a unit."""
    assert rotary_scale(1000.0, 10.0, 5.0) == 2000.0
    assert rotary_scale(1000.0, 10.0, quadrature=1) == 100.0
    assert linear_scale(0.005) == pytest.approx(200.0)
    for wrong in (0.0, -1.0, inf):
        with pytest.raises(ValueError, match="must be greater than zero"):
            linear_scale(wrong)
    with pytest.raises(ValueError, match="1, 2 or 4 counts, not 3"):
        rotary_scale(1000.0, 10.0, quadrature=3)


def test_the_distance_that_a_speed_needs() -> None:
    """100²/2 · (1/1000 + 1/500) is 15; a quarter of it has half of the speed."""
    assert needed_distance(100.0, 1000.0, 500.0) == pytest.approx(15.0)
    assert triangle(15.0, 100.0, 1000.0, 500.0) is None
    short = triangle(3.75, 100.0, 1000.0, 500.0)
    assert short is not None
    assert short["speed"] == pytest.approx(50.0)


@pytest.mark.parametrize(
    ("given", "texts"),
    [
        # At 100 per second² each way, 100 in 1 s needs 4 times the rates, 2 s, or 25.
        (
            {"distance": 100.0, "time": 1.0, "accel": 100.0, "decel": 100.0},
            ["accel 400 and decel 400 or more", "time 2 or more", "distance 25 or less"],
        ),
        (
            {"distance": 100.0, "time": 1.0, "accel": 100.0},
            ["accel 400 or more", "time 2 or more", "distance 25 or less"],
        ),
        (
            {"distance": 100.0, "time": 1.0, "decel": 100.0},
            ["decel 400 or more", "time 2 or more", "distance 25 or less"],
        ),
        # A triangle takes the root of 2 * 100 * (1/100 + 1/50) = 6 s²: 6 times the rates, or a sixth of 100.
        (
            {"distance": 100.0, "time": 1.0, "accel": 100.0, "decel": 50.0},
            ["accel 600 and decel 300 or more", "time 2.44949 or more", "distance 16.6667 or less"],
        ),
        # Two ramps of 2 s cover 200 in 4 s; the other 100 take 1 s longer.
        (
            {"distance": 300.0, "time": 4.0, "speed": 100.0, "accel": 50.0, "decel": 50.0},
            ["distance 200", "time 5"],
        ),
        # In 4 s the ramps have 2 * (4 - 300/100) = 2 s instead of 4 s; at 50 the move takes 1 s longer.
        (
            {"distance": 300.0, "time": 4.0, "speed": 100.0, "accel": 50.0},
            ["accel 100", "time 5"],
        ),
        # The ramps alone would go 100 * 2 = 200, so no longer time is possible.
        (
            {"distance": 100.0, "time": 2.0, "speed": 100.0, "accel": 50.0, "decel": 50.0},
            ["accel 100 and decel 100"],
        ),
        # A speed between 100 and twice that is possible.
        (
            {"distance": 100.0, "time": 1.0, "speed": 100.0},
            ["speed above 100 and up to 200", "time above 1 and up to 2", "distance from 50 to below 100"],
        ),
        ({"distance": 100.0, "time": 1.0, "speed": 200.0}, []),
        ({"distance": 100.0, "time": 2.0, "accel": 100.0, "decel": 100.0}, []),
        ({"distance": 100.0}, []),
        ({"time": 1.0, "speed": 5.0}, []),
    ],
)
def test_what_makes_a_move_possible(given: dict[str, float], texts: list[str]) -> None:
    assert remedies(None, given) == texts


def test_a_curve_from_pieces_has_their_positions() -> None:
    """x³ - 6x² + 9x + 2 over 0 to 4, then a line of slope 9 from 6."""
    line: Piece = (6.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    curve = ((0.0, 4.0, 5.0), (CUBIC, line), (("segment", 0),))
    made = from_curve("table", 2.0, 15.0, curve, 9.0, 9.0)
    assert [made.position(t) for t in (0.0, 1.0, 3.0, 4.0, 4.5, 5.0)] == [2.0, 6.0, 2.0, 6.0, 10.5, 15.0]
    assert made.duration == 5.0


@pytest.mark.parametrize(
    ("time", "phases"),
    [
        (0.05, [("accel", 0.05), ("slew", 0.9), ("decel", 0.1)]),
        (0.5, [("slew", 0.5), ("decel", 0.1)]),
        (1.05, [("decel", 0.05)]),
    ],
)
def test_the_rest_of_a_move_has_the_rest_of_its_phases(time: float, phases: list[tuple[str, float]]) -> None:
    rest = MOVE.after(time)
    assert [phase.name for phase in rest.phases] == [name for name, _ in phases]
    assert [phase.duration for phase in rest.phases] == pytest.approx([duration for _, duration in phases])
    assert rest.position(0.02) == pytest.approx(MOVE.position(time + 0.02))


@pytest.mark.parametrize(
    "given",
    [
        {"distance": 25.0, "time": 1.0, "accel": 100.0, "decel": 100.0},
        {"distance": 25.0, "speed": 50.0, "accel": 100.0, "decel": 100.0},
        {"distance": 25.0, "slew_time": 0.0, "accel": 100.0, "decel": 100.0},
        {"time": 1.0, "slew_time": 0.0, "accel": 100.0, "decel": 100.0},
        {"distance": 25.0, "time": 1.0, "accel": 100.0, "decel_time": 0.5},
        {"distance": 25.0, "time": 1.0, "accel_time": 0.5, "decel": 100.0},
        {"time": 1.0, "slew_time": 0.0, "accel": 100.0, "decel_time": 0.5},
        {"speed": 50.0, "accel_time": 0.5, "decel_time": 0.5, "slew_time": 0.0},
    ],
)
def test_the_figures_of_a_triangle(given: dict[str, float]) -> None:
    """25 at 100 per second² each way: 50 per second after half a second, and no slew."""
    known = solve_move(None, **given)
    assert known["speed"] == pytest.approx(50.0)
    assert [known[name] for name in ("distance", "time", "accel_time", "decel_time")] == pytest.approx(
        [25.0, 1.0, 0.5, 0.5]
    )
    assert known["slew_time"] == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("rule", "given", "expected"),
    [
        # Ramps of a third each: 30 at v takes 30 = v · T · 2/3; with 0.9 s v is 50 and the rate 50 / 0.3.
        ("third", {"distance": 30.0, "time": 0.9}, (50.0, 0.3, 50.0 / 0.3)),
        ("third", {"distance": 30.0, "speed": 50.0}, (50.0, 0.3, 50.0 / 0.3)),
        # A quarter each: 30 = v · T · 3/4.
        ("quarter", {"distance": 30.0, "time": 0.8}, (50.0, 0.2, 250.0)),
        # 30 at 50 in 0.9 s: 0.3 s of slew are left.
        ("equal", {"distance": 30.0, "speed": 50.0, "time": 0.9}, (50.0, 0.3, 50.0 / 0.3)),
    ],
)
def test_the_figures_by_a_rule(
    rule: str, given: dict[str, float], expected: tuple[float, float, float]
) -> None:
    known = solve_move(rule, **given)
    assert (known["speed"], known["accel_time"], known["decel"]) == pytest.approx(expected)


def test_the_largest_error_of_points_and_its_time() -> None:
    """The points go from 3 to 5 in 0.2 s, and a history at 3 is 2 behind at the end."""
    points = [Point(3.0, None, 0.1), Point(4.0, None, 0.1), Point(5.0, None, 0.0)]
    assert motion_error([0.0], [hold(3.0)], points) == pytest.approx((2.0, 0.2))
    made = plan_points(points)
    assert motion_error([0.0, 5.0], [hold(100.0), made], points, 5.0)[0] == pytest.approx(0.0, abs=1e-9)
    assert motion_error([0.0, 5.0], [hold(100.0), made], points, 4.0) == pytest.approx((97.0, 0.0))
    relative = [Point(3.0, None, 0.1, True), Point(1.0, None, 0.1, True), Point(1.0, None, 0.0, True)]
    assert motion_error([0.0], [hold(13.0)], relative, 0.0, 10.0) == pytest.approx((2.0, 0.2))
    assert track_error([0.0], [made], [0.0], [hold(3.0)], 0.0, 0.2) == pytest.approx(2.0)
    assert track_error([0.0], [made], [0.0], [hold(3.0)], 0.0, 0.1) == pytest.approx(1.0)
    assert track_error([0.0], [made], [1.0], [made], 1.0, 1.2) == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("rule", "given", "message"),
    [
        (None, {"foo": 1.0}, "a move has no figure called foo"),
        (None, {"distance": 0.0}, "distance must be greater than zero"),
        (None, {"slew_time": -1.0}, "slew time must be zero or more"),
        (None, {"distance": nan}, "distance is not a number"),
        (None, {"distance": 1e300}, r"distance must be less than 1e\+300"),
        ("half", {"distance": 1.0}, "there is no rule called half: third, quarter or equal"),
        ("third", {"distance": 1.0}, "give the time, or distance and speed"),
        ("third", {"speed": 1.0}, "give the time, or distance and speed"),
        # 25 is the most in 1 s at 100 per second² each way.
        (
            None,
            {"distance": 25.1, "time": 1.0, "accel": 100.0, "decel": 100.0},
            "cannot be covered in the time",
        ),
        # In 1 s at 100 more than 50 and less than 100 is covered.
        (None, {"distance": 49.0, "time": 1.0, "speed": 100.0}, "the distance does not fit the speed"),
        (None, {"distance": 100.0, "time": 1.0, "speed": 100.0}, "the distance does not fit the speed"),
        (None, {"time": 1.9, "slew_time": 0.0, "speed": 9.0, "accel": 9.0, "decel": 9.0}, "contradiction"),
        (
            None,
            {"speed": 10.0, "accel": 5.0, "accel_time": 1.0, "decel_time": 1.0, "time": 3.0},
            "accel 5 .given.",
        ),
        (None, {"distance": 50.0, "time": 1.0, "speed": 100.0}, "not enough is known"),
    ],
)
def test_figures_that_make_no_move(rule: str | None, given: dict[str, float], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        solve_move(rule, **given)


@pytest.mark.parametrize(
    ("positions", "values", "message"),
    [
        ([0.0], [0.0], "two points or more, and a value for each"),
        ([0.0, 1.0], [0.0], "two points or more, and a value for each"),
        ([0.0, 0.0], [0.0, 1.0], "must rise from 0"),
        ([1.0, 2.0], [0.0, 1.0], "must rise from 0"),
        ([0.0, inf], [0.0, 1.0], "must be finite"),
        ([0.0, 1.0], [0.0, 1e300], "must be finite"),
    ],
)
def test_a_table_that_makes_no_curve(positions: list[float], values: list[float], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        table_curve(positions, values)


@pytest.mark.parametrize(
    ("time", "state"),
    [
        (-1.0, (0.0, 0.0, 0.0, 0.0)),
        (0.0, (0.0, 0.0, 1000.0, 0.0)),
        (0.05, (1.25, 50.0, 1000.0, 0.0)),
        (0.5, (45.0, 100.0, 0.0, 0.0)),
        (1.05, (98.75, 50.0, -1000.0, 0.0)),
        (1.1, (100.0, 0.0, 0.0, 0.0)),
        (9.0, (100.0, 0.0, 0.0, 0.0)),
    ],
)
def test_the_state_before_in_and_behind_a_move(time: float, state: tuple[float, float, float, float]) -> None:
    """Position, velocity, acceleration and jerk of 100 at 100/s and 1000/s²."""
    found = MOVE.at(time)
    assert (found.position, found.velocity, found.acceleration, found.jerk) == pytest.approx(state, abs=1e-9)


def test_a_sum_of_formulas_adds_their_states() -> None:
    """Two waves have no common pieces; each derivative is the sum of both."""
    wave = plan("sinusoidal", 0.0, 100.0, 100.0, 1000.0, 1000.0)
    other_wave = plan("sinusoidal", 0.0, 30.0, 50.0, 400.0, 400.0)
    both = added(wave, other_wave, "sum")
    for time in (0.01, 0.05, 0.5, 1.0):
        one, other, found = wave.at(time), other_wave.at(time), both.at(time)
        for name in ("position", "velocity", "acceleration", "jerk"):
            assert getattr(found, name) == pytest.approx(getattr(one, name) + getattr(other, name))
    assert both.at(0.01).jerk > 0.0
    other_order = added(other_wave, wave, "sum")
    assert other_order.at(0.01).jerk == pytest.approx(both.at(0.01).jerk)


# Motor positions 10, 15 and 20, at which the nut is at 20, 24 and 30.
NUT = Leadscrew(10.0, 5.0, [20.0, 24.0, 30.0])


@pytest.mark.parametrize(
    ("nut", "motor", "slope"),
    [
        (15.0, 5.0, 1.0), (20.0, 10.0, 5 / 4), (22.0, 12.5, 5 / 4), (24.0, 15.0, 5 / 6), (27.0, 17.5, 5 / 6),
        (30.0, 20.0, 1.0), (33.0, 23.0, 1.0),
    ],
)  # fmt: skip
def test_the_motor_of_a_leadscrew_beyond_its_table_too(nut: float, motor: float, slope: float) -> None:
    assert (NUT.motor(nut), NUT.slope(nut)) == pytest.approx((motor, slope))


def test_the_beginning_of_a_sequence_is_its_first_profile_alone() -> None:
    first = plan_trapezoid(0.0, 10.0, 10.0, 100.0, 100.0)
    second = plan_trapezoid(10.0, 15.0, 10.0, 100.0, 100.0)
    both = ProfileSequence("trapezoid", [first, second])
    assert both.duration == pytest.approx(1.1 + 0.6)
    assert both.cut(0.5).knots == first.cut(0.5).knots
    assert type(both.after(1.2)) is Profile
    assert both.after(1.25).knots == pytest.approx(second.after(0.15).knots)
    assert len(both.cut(1.2).segments) == 2  # type: ignore[attr-defined]
    assert both.cut(99.0) is both
    assert both.after(-1.0) is both
    over = ProfileSequence("trapezoid", [second, first.shifted(15.0), second.shifted(15.0)]).after(99.0)
    assert (over.duration, over.start, over.end) == (0.0, 30.0, 30.0)
    over = both.after(99.0)
    assert (over.duration, over.start, over.end) == (0.0, 15.0, 15.0)
    named = ProfileSequence("gear", [first, second])
    assert [phase.name for phase in named.cut(0.5).phases] == ["gear"]
    assert named.scaled(5.0, -2.0).end == -25.0
