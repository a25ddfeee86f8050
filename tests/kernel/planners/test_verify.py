"""The checker detects every kind of violation."""

from __future__ import annotations

import math

import pytest

from motionlang.kernel.planners import Profile, from_curve, plan, plan_trapezoid
from tests.kernel.planners.cases import plan_jerk
from tests.kernel.planners.verify import _Span, verify

LINE = (0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def two_lines(second: tuple[float, ...]) -> Profile:
    piece = (second[0], second[1], 0.0, 0.0, 0.0, 0.0, 0.0)
    curve = ((0.0, 1.0, 2.0), (LINE, piece), (("slew", 0),))
    return from_curve("pvt", 0.0, second[0] + second[1], curve, 1.0, second[1])


def test_a_sound_profile_has_no_complaint() -> None:
    assert verify(plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0), speed=8, accel=16, decel=16, end=12.0) == []


def test_jumps() -> None:
    assert verify(two_lines((1.0, 1.0))) == []
    assert verify(two_lines((1.5, 1.0))) == ["position jumps by 0.5 at 1 s"]
    assert verify(two_lines((1.0, 2.0))) == ["velocity jumps by 1 at 1 s"]


def test_a_trapezoid_is_not_an_s_curve() -> None:
    plain = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    posing = from_curve("scurve", 0.0, 12.0, plain.curve, 0.0, 0.0)
    assert verify(posing) == ["acceleration jumps by -16 at 0.5 s", "acceleration jumps by -16 at 1.5 s"]


def test_limits() -> None:
    move = plan_jerk(0.0, 100.0, 100.0, 500.0, 400.0, 5000.0, 4000.0)
    found = verify(move, speed=99.0, accel=499.0, decel=399.0, jerk=4999.0)
    words = [complaint.split(" reaches ")[0] for complaint in found]
    assert words == ["speed", "acceleration", "deceleration", "jerk"]
    assert len(verify(plan("sinusoidal", 0.0, 9.0, 9.0, 5.0, 5.0), jerk=1.0)) == 1


def test_the_end() -> None:
    move = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    assert verify(move, end=11.0) == ["the profile ends at 12.0, not at 11.0"]
    lying = from_curve("trapezoid", 0.0, 13.0, move.curve, 0.0, 1.0)
    assert [complaint[:14] for complaint in verify(lying)] == ["the curve ends", "the curve ends"]


def test_not_a_number_is_a_complaint() -> None:
    piece = (0.0, math.nan, 0.0, 0.0, 0.0, 0.0, 0.0)
    assert verify(from_curve("pvt", 0.0, 1.0, ((0.0, 1.0), (piece,), (("slew", 0),)), 1.0, 1.0))


def test_a_ramp_of_microseconds_late_in_a_long_move_is_judged_by_what_it_is() -> None:
    """After a day, the end of a ramp of 34 µs has a resolution of a millionth.

    The limits of the ramp are still checked.
    """
    speed, decel, end = 0.10057264266491435, 2980.9579870417283, 8103.083927575384
    made = plan_trapezoid(0.0, end, speed, 1.0, decel)
    again = made.cut(0.0).then(made.after(0.0))
    assert verify(again, speed=speed, accel=1.0, decel=decel, end=end) == []
    assert verify(again, speed=speed, accel=1.0, decel=decel * 0.99, end=end) != []
    assert verify(again, speed=speed, accel=0.99, decel=decel, end=end) != []


@pytest.mark.parametrize(
    ("jump", "bend", "expected"),
    [
        (1.9e-9, 0.0, []),
        (2.1e-9, 0.0, ["position jumps by 2.1e-09 at 1 s"]),
        (0.0, 0.9e-9, []),
        (0.0, 1.2e-9, ["velocity jumps by 1.2e-09 at 1 s"]),
    ],
)
def test_a_jump_of_a_billionth_of_the_motion_is_rounding(
    jump: float, bend: float, expected: list[str]
) -> None:
    """The motion is of 2 at a speed of 1."""
    assert verify(two_lines((1.0 + jump, 1.0 + bend))) == expected


def test_a_larger_tolerance() -> None:
    assert verify(two_lines((1.0, 1.009)), tolerance=0.01) == []
    assert verify(two_lines((1.0, 1.02)), tolerance=0.01) == ["velocity jumps by 0.02 at 1 s"]


@pytest.mark.parametrize(
    ("knots", "expected"),
    [
        ((0.0, 1.0, 2.0), []),
        ((0.0, 1.0, 1.0), ["the knots 1.0 and 1.0 are out of order", "the knots do not span the duration"]),
        ((0.5, 1.0, 2.0), ["the knots do not span the duration"]),
        ((0.0, 1.0, 2.5), ["the knots do not span the duration"]),
    ],
)
def test_the_knots_span_the_duration_in_order(knots: tuple[float, ...], expected: list[str]) -> None:
    made = two_lines((1.0, 1.0))
    posing = from_curve("pvt", 0.0, 2.0, (knots, made.pieces, (("slew", 0),)), 1.0, 1.0)
    posing.duration = 2.0
    assert [each for each in verify(posing, tolerance=1.0) if "knots" in each] == expected


# What is wrong with the ends of a motion from 0 to 2 at a speed of 1.
ENDS: dict[str, tuple[tuple[float, float, float, float], list[str]]] = {
    "nothing": ((0.0, 2.0, 1.0, 1.0), []),
    "the start": ((0.5, 2.0, 1.0, 1.0), ["the curve starts at 0.0, not at 0.5"]),
    "the end": ((0.0, 2.5, 1.0, 1.0), ["the curve ends at 2.0, not at 2.5"]),
    "the first velocity": ((0.0, 2.0, 1.5, 1.0), ["the curve starts with velocity 1.0, not 1.5"]),
    "the last velocity": ((0.0, 2.0, 1.0, 0.5), ["the curve ends with velocity 1.0, not 0.5"]),
}


@pytest.mark.parametrize("name", ENDS)
def test_a_profile_begins_and_ends_as_it_states(name: str) -> None:
    (start, end, first, last), expected = ENDS[name]
    assert verify(from_curve("pvt", start, end, two_lines((1.0, 1.0)).curve, first, last)) == expected


# The bound, its value, and whether a move of 12 at 8, with 16 up and 32 down, keeps it.
BOUNDS = {
    "speed": 8.0,
    "accel": 16.0,
    "decel": 32.0,
}


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("name", BOUNDS)
def test_a_bound_may_be_used_completely(name: str, sign: float) -> None:
    move = plan_trapezoid(0.0, 12.0 * sign, 8.0, 16.0, 32.0)
    long = {"accel": "acceleration", "decel": "deceleration"}.get(name, name)
    assert verify(move, **{name: BOUNDS[name]}) == []
    assert verify(move, **{name: BOUNDS[name] * (1.0 - 1e-6)}) == [
        f"{long} reaches {BOUNDS[name]!r}, above the limit {BOUNDS[name] * (1.0 - 1e-6)!r}"
    ]


@pytest.mark.parametrize(("v0", "count"), [(8.0, 0), (9.0, 0), (-9.0, 0)])
def test_a_motion_that_begins_too_fast_may_brake(v0: float, count: int) -> None:
    move = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0, v0)
    assert len(verify(move, speed=8.0, accel=16.0, decel=16.0)) == count
    faster = plan_trapezoid(0.0, 12.0, 9.5, 16.0, 16.0, v0)
    assert len(verify(faster, speed=8.0)) == (abs(v0) < faster.peak_speed)


@pytest.mark.parametrize(
    ("piece", "order", "times"),
    [
        ((0.0, 3.0, -1.5, 0.0, 0.0, 0.0, 0.0), 1, [0.0, 1.0, 2.0]),
        ((0.0, 0.0, -3.0, 1.0, 0.0, 0.0, 0.0), 1, [0.0, 2.0]),  # 0 and 2 are its ends
        ((0.0, 0.0, -3.0, 1.0, 0.0, 0.0, 0.0), 2, [0.0, 1.0, 2.0]),
        ((0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0), 1, [0.0, 2.0]),
        ((0.0, 0.0, 0.0, 0.0, 1.0, math.pi, 0.0), 1, [0.0, 0.5, 1.5, 2.0]),
        ((0.0, 0.0, 0.0, 0.0, 1.0, math.pi, 0.0), 2, [0.0, 1.0, 2.0]),
        ((0.0, 0.5 * math.pi, 0.0, 0.0, 1.0, math.pi, 0.0), 1, [0.0, 2.0 / 3.0, 4.0 / 3.0, 2.0]),
        ((0.0, 4.0, 0.0, 0.0, 1.0, math.pi, 0.0), 1, [0.0, 2.0]),
        ((0.0, 0.0, 0.0, 0.0, 1.0, math.pi, 0.5 * math.pi), 1, [0.0, 1.0, 2.0]),
    ],
)
def test_the_extrema_of_a_piece_are_where_the_next_derivative_is_zero(
    piece: tuple[float, float, float, float, float, float, float], order: int, times: list[float]
) -> None:
    """The cosine of a wave on a slope of pi / 2 is -1/2 after 2/3 s and 4/3 s."""
    assert _Span(piece, 5.0, 7.0).extrema(order) == pytest.approx(times, abs=1e-9)


def test_the_derivatives_of_a_piece() -> None:
    span = _Span((1.0, 2.0, 3.0, 4.0, 3.0, 2.0, math.pi / 6.0), 5.0, math.inf)
    assert span.length == 1.0
    found = [span.value(order, 0.0) for order in range(5)]
    root = math.sqrt(3.0)
    assert found == pytest.approx([2.5, 2.0 + 3.0 * root, 0.0, 24.0 - 12.0 * root, 24.0], abs=1e-12)
