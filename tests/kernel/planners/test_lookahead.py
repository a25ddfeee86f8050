"""The speed over joined paths: against a linear program, and within its limits."""

from __future__ import annotations

from itertools import pairwise
from math import hypot, inf, sqrt
from random import Random

import pytest

from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.lookahead import PathPace, plan_course

# Length, speed, acceleration, deceleration.
Segment = tuple[float, float, float, float]

EASY = (90.0, 60.0)


def course(segments: list[Segment], v0: float = 0.0, joins: tuple[float, ...] = ()) -> Profile:
    made = plan_course(
        [(length, PathPace("trapezoid", *limits)) for length, *limits in segments], 0.0, v0, joins=joins
    )
    assert made is not None
    return made


def least_time(segments: list[Segment], v0: float, joins: tuple[float, ...]) -> float:
    """Return the least time by a linear program over the squared speeds at joins.

    The squared peak speeds between joins are variables, too. The solution with the largest sum has every square at
    its own maximum, because a larger square never forces another one to be smaller.
    """
    from scipy.optimize import linprog  # type: ignore[import-untyped]  # 0.3 s

    n = len(segments)
    rows, bounds = [], []
    for i, (length, _, accel, decel) in enumerate(segments):
        for signs, most in (
            ({i + 1: 1.0, i: -1.0}, 2.0 * accel * length),
            ({i: 1.0, i + 1: -1.0}, 2.0 * decel * length),
            ({n + 1 + i: 1.0, i: -decel / (accel + decel), i + 1: -accel / (accel + decel)}, None),
        ):
            row = [0.0] * (2 * n + 1)
            for k, sign in signs.items():
                row[k] = sign
            rows.append(row)
            bounds.append(2.0 * length * accel * decel / (accel + decel) if most is None else most)
    speeds = [segment[1] for segment in segments]
    limits = [joins[i] if joins else inf for i in range(n - 1)]
    caps = [min(a, b, c) ** 2 for a, b, c in zip(speeds, speeds[1:], limits, strict=False)]
    ranges = [(v0 * v0, v0 * v0), *((0.0, cap) for cap in caps), (0.0, 0.0), *((0.0, v * v) for v in speeds)]
    found = linprog([-1.0] * (2 * n + 1), A_ub=rows, b_ub=bounds, bounds=ranges, method="highs-ds")
    assert found.status == 0, found.message
    v = [sqrt(max(0.0, square)) for square in found.x]
    time = 0.0
    for i, (length, _, accel, decel) in enumerate(segments):
        first, last, top = v[i], v[i + 1], v[n + 1 + i]
        ramps = (top * top - first * first) / (2.0 * accel) + (top * top - last * last) / (2.0 * decel)
        time += (top - first) / accel + (top - last) / decel + max(0.0, length - ramps) / top
    return time


def random_segments(random: Random) -> list[Segment]:
    return [
        (
            random.choice([10.0, 80.0, random.uniform(0.05, 100), random.uniform(0.01, 1.0)]),
            random.choice([5.0, 20.0, 45.0, random.uniform(1, 60)]),
            random.choice([90.0, random.uniform(20, 400)]),
            random.choice([60.0, random.uniform(20, 400)]),
        )
        for _ in range(random.randint(1, 12))
    ]


def keeps_its_limits(segments: list[Segment], made: Profile) -> None:
    """Check that each piece observes the limits of its segment."""
    begins = [0.0]
    for length, *_ in segments:
        begins.append(begins[-1] + length)
    times = sorted({*made.knots, *(made.crossing(s) or 0.0 for s in begins[1:-1])})
    for t0, t1 in pairwise(times):
        if t1 - t0 < 1e-12:
            continue
        middle = made.at(0.5 * (t0 + t1))
        here = next(i for i, s in enumerate([*begins[1:-1], inf]) if middle.position < s)
        _, speed, accel, decel = segments[here]
        assert max(made.velocity(t0), made.velocity(t1)) <= speed * (1.0 + 1e-9)
        assert -decel * (1.0 + 1e-9) <= middle.acceleration <= accel * (1.0 + 1e-9)


@pytest.mark.parametrize(
    ("segments", "time"),
    [
        # 1/3 s to 30, 88.5 uu at 30, 1/2 s from it
        ([(1.0, 29.0, *EASY), (100.0, 30.0, *EASY)], 1 / 3 + 88.5 / 30 + 0.5),
        (
            [(2.0, 20.0, *EASY), (3.0, 25.0, *EASY), (4.0, 28.0, *EASY), (60.0, 30.0, *EASY)],
            2.7342724867724866,
        ),
    ],
)
def test_courses_by_their_figures(segments: list[Segment], time: float) -> None:
    made = course(segments)
    assert made.duration == pytest.approx(time, abs=1e-12)
    keeps_its_limits(segments, made)


def test_a_short_stretch_with_low_limits_keeps_them() -> None:
    segments = [(5.0, 100.0, 60.0, 60.0), (hypot(40.0, 0.001), 100.0, 300.0, 500.0)]
    made = course(segments)
    keeps_its_limits(segments, made)
    assert made.duration == pytest.approx(least_time(segments, 0.0, ()), rel=1e-9)


def judge(first: int, count: int) -> None:
    for seed in range(first, first + count):
        random = Random(seed)
        segments = random_segments(random)
        joins = tuple(random.choice([inf, random.uniform(0.1, 60.0)]) for _ in segments[1:])
        v0 = 0.0
        if random.random() < 0.4:
            length, speed, _, decel = segments[0]
            v0 = random.random() * min(speed, joins[0] if joins else inf, sqrt(2.0 * decel * length))
            v0 = min(v0, *(w[1] for w in segments), *joins, sqrt(2.0 * min(w[3] for w in segments) * length))
        made = course(segments, v0, joins)
        assert made.duration == pytest.approx(least_time(segments, v0, joins), rel=1e-9), seed
        keeps_its_limits(segments, made)
        assert made.end == pytest.approx(sum(segment[0] for segment in segments), rel=1e-12)
        assert made.extrema()[1] <= made.end * (1.0 + 1e-12)


@pytest.mark.parametrize("first", range(0, 200, 50))
def test_no_course_is_faster(first: int) -> None:
    judge(first, 50)


@pytest.mark.long
def test_no_course_is_faster_of_many() -> None:
    judge(10_000, 10_000)


def test_a_run_that_slowed_down_for_one_stretch_speeds_up_on_the_next() -> None:
    """At 30 it enters a stretch with a limit of 10 and brakes with a jerk of 1000.

    The stretch takes 0.04 s. Then the speed is 30 - 500 * 0.04² = 29.2, and the deceleration is 40. The deceleration
    falls to zero in another 0.04 s, and after 2 * 0.04 s more the speed is 30 again. The last 6 units are those of
    the stop, which takes 30 / 100 + 100 / 1000 s.
    """
    first = 30.0 * 0.04 - 1000.0 * 0.04**3 / 6.0
    limits = {"accel": 100.0, "decel": 100.0, "accel_jerk": 1000.0, "decel_jerk": 1000.0}
    stretches = [(first, PathPace("scurve", 10.0, **limits)), (100.0, PathPace("scurve", 30.0, **limits))]
    made = plan_course(stretches, 0.0, 30.0)
    assert made is not None
    fading = 29.2 * 0.04 - 20.0 * 0.04**2 + 1000.0 * 0.04**3 / 6.0
    slew = (100.0 - fading - 29.2 * 0.08 - 6.0) / 30.0
    assert made.end == first + 100.0
    assert made.velocity(0.08) == pytest.approx(28.4)
    assert made.duration == pytest.approx(0.16 + slew + 0.4)


# The segments, and the phases with their durations. All rates are 100 unless the segment has another one: a ramp to
# 10 covers 0.5 in 0.1 s, one from 10 to 20 covers 1.5.
PHASES: dict[str, tuple[list[Segment], list[tuple[str, float]]]] = {
    "two segments in one ramp up": (
        [(0.5, 10.0, 100.0, 100.0), (23.5, 20.0, 100.0, 100.0)], [("accel", 0.2), ("slew", 1.0), ("decel", 0.2)],
    ),
    "two segments in two ramps up": (
        [(0.5, 10.0, 100.0, 100.0), (25.0, 20.0, 50.0, 100.0)],
        [("accel", 0.1), ("accel", 0.2), ("slew", 1.0), ("decel", 0.2)],
    ),
    "two segments in one ramp down": (
        [(3.5, 20.0, 100.0, 100.0), (0.5, 10.0, 100.0, 100.0)], [("accel", 0.2), ("decel", 0.2)],
    ),
    "two segments in two ramps down": (
        [(5.0, 20.0, 100.0, 50.0), (0.5, 10.0, 100.0, 100.0)], [("accel", 0.2), ("decel", 0.2), ("decel", 0.1)],
    ),
    "one speed": (
        [(10.5, 10.0, 100.0, 100.0), (10.5, 10.0, 100.0, 100.0)], [("accel", 0.1), ("slew", 2.0), ("decel", 0.1)],
    ),
    "one speed, and one ramp after the other": (
        [(0.5, 10.0, 100.0, 100.0), (0.5, 10.0, 100.0, 100.0)], [("accel", 0.1), ("decel", 0.1)],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", PHASES)
def test_the_phases_of_a_course(name: str) -> None:
    """Ramps that go on at one rate are one phase."""
    segments, phases = PHASES[name]
    made = course(segments)
    assert [phase.name for phase in made.phases] == [name for name, _ in phases]
    assert [phase.duration for phase in made.phases] == pytest.approx([time for _, time in phases])
    assert made.end == made.position(made.duration) == sum(length for length, *_ in segments)


@pytest.mark.parametrize(
    ("start", "v0", "time"),
    [
        (0.0, 10.0, 0.1),  # a stop from 10 covers exactly 0.5
        (0.2e-9, 10.0, 0.1),  # rounding
        (2e-9, 10.0, None),
        (0.5, 0.0, 0.0),
        (0.5 + 0.4e-9, 0.0, 0.0),
        (0.5 + 2e-9, 0.0, None),
        (0.75, 0.0, None),
    ],
)
def test_a_course_that_cannot_stop_at_its_end(start: float, v0: float, time: float | None) -> None:
    """An end 1e-9 of the length of 0.5 farther is rounding."""
    made = plan_course([(0.25, PathPace("trapezoid", 20.0, 100.0, 100.0))] * 2, start, v0)
    assert (None if made is None else made.duration) == (None if time is None else pytest.approx(time))


def test_a_limit_that_comes_too_late_for_the_next_path_brakes_all_the_way() -> None:
    """From 50, the limit of 10 is not reached before the next path, with 9, begins.

    The speed only decreases.
    """
    pace = PathPace("trapezoid", 10.0, 100.0, 200.0)
    other = PathPace("trapezoid", 9.0, 100.0, 200.0)
    for k in range(1, 60):
        made = plan_course([(0.1 * k, pace), (20.0, other)], 0.0, 50.0)
        assert made is not None
        speeds = [made.velocity(knot) for knot in made.knots]
        assert speeds == sorted(speeds, reverse=True), k


@pytest.mark.parametrize("shape", ["trapezoid", "scurve", "parabolic", "sinusoidal"])
def test_a_path_of_no_length_is_none(shape: str) -> None:
    """Its limit is higher than the speed that is reached before it."""
    slow, none, fast = (PathPace(shape, speed, 100.0, 100.0) for speed in (20.0, 30.0, 40.0))
    made = plan_course([(1.0, slow), (0.0, none), (30.0, fast)], 0.0, 0.0)
    without = plan_course([(1.0, slow), (30.0, fast)], 0.0, 0.0)
    assert made is not None
    assert without is not None
    assert made.duration == pytest.approx(without.duration)
