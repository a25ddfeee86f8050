"""Every formula, listing and figure of "Dissecting a Move Profile" (chapter 12).

They are compared with the figures that the text prints.
"""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel.planners import plan
from motionlang.kernel.servo import Loop, Track, VelocityDrive, simulate
from tests.cases import examples
from tests.lab.notes.vendor import dissect
from tests.lab.notes.vendor.chapter12 import Listing, Settings, run_listing
from tests.lab.notes.vendor.dac_override import demonstrate
from tests.lab.notes.vendor.slip import check_profile, check_trace

LIMIT = dissect.slip_acceleration(0.1, 32.2)
SPEED = 100.0 / 60.0


# ------------------------------------------------------------------------------------------------------ the cube


def test_slip_example() -> None:
    assert pytest.approx(3.22) == LIMIT
    assert dissect.friction_force(5.0, 0.1) == pytest.approx(0.5)
    assert dissect.fastest_time(SPEED, LIMIT) == pytest.approx(0.5175983, abs=5e-8)


def test_one_dac_step() -> None:
    timing = dissect.dac_timing(SPEED, LIMIT)
    assert timing.steps == 2048
    assert timing.step_speed * 60.0 == 0.048828125
    assert timing.step_time == pytest.approx(252.7336e-6, abs=5e-11)
    assert timing.electrical_time_constant == pytest.approx(168.489e-6, abs=5e-10)
    assert timing.hold_time == pytest.approx(842.4e-6, abs=5e-8)


def test_a_finer_dac_has_finer_steps() -> None:
    coarse, fine = dissect.dac_timing(SPEED, LIMIT, 12), dissect.dac_timing(SPEED, LIMIT, 16)
    assert coarse.step_time / fine.step_time == pytest.approx(16.0)


def test_buildup_is_63_percent_in_a_time_constant() -> None:
    assert dissect.buildup(1.0, 1.0) == pytest.approx(0.6321, abs=1e-4)


# -------------------------------------------------------------------------------------------------- figures 12.6, 9


def test_figure_12_6() -> None:
    """C exceeds the limit at its onset, D observes it on average over the update.

    F, which has two steps, exceeds it.
    """
    c = dissect.step_segments((1,), 1.0 / 5.0)[0]
    d, f = dissect.step_segments((1, 2), 2.0 / 3.0)
    assert c.onset == pytest.approx(5.0)
    assert d.mean == pytest.approx(0.7769, abs=1e-4)
    assert d.onset == pytest.approx(1.5)
    assert f.mean > 1.0
    assert dissect.step_segments((1,), 1.0)[0].onset == 1.0


def test_move_times_of_both_profiles() -> None:
    quick, smooth = dissect.trapezoid_times(2.0, SPEED, LIMIT), dissect.s_curve_times(2.0, SPEED, LIMIT)
    for times, shape, ramp in ((quick, "trapezoid", 0.1), (smooth, "scurve", 0.5)):
        profile = plan(shape, 0.0, 2.0, SPEED, LIMIT, LIMIT, ramp=ramp)
        assert times.move_time == pytest.approx(profile.duration, rel=1e-12)
        assert times.accel_time == pytest.approx(profile.phases[0].duration, rel=1e-12)
        assert times.accel_distance == pytest.approx(profile.phases[0].distance, rel=1e-12)
        assert times.slew_time == pytest.approx(profile.phases[1].duration, rel=1e-12)
    assert smooth.accel_time == pytest.approx(2.0 * quick.accel_time)


def test_equal_time_needs_twice_the_acceleration() -> None:
    equal = dissect.s_curve_times(2.0, SPEED, dissect.equal_time_accel(LIMIT))
    assert equal.move_time == pytest.approx(dissect.trapezoid_times(2.0, SPEED, LIMIT).move_time)


# ---------------------------------------------------------------------------------------------------- progressions


def test_the_discrete_trapezoid_is_the_chapters_progression() -> None:
    made = dissect.discrete_trapezoid(200, 20, 2)
    velocity = position = 0
    for new_velocity, new_position in made[:10]:
        velocity += 2
        position += velocity
        assert (new_velocity, new_position) == (velocity, position)
    assert made[-1][1] == 200


@given(st.integers(1, 50_000), st.integers(1, 300), st.integers(1, 50))
@settings(max_examples=examples(200))
def test_the_progression_ends_exactly(distance: int, speed: int, accel: int) -> None:
    made = dissect.discrete_trapezoid(distance, speed, accel)
    velocities = [0, *(v for v, _ in made)]
    assert made[-1][1] == distance
    assert max(velocities) <= speed
    assert all(b - a <= accel for a, b in pairwise(velocities))


# ------------------------------------------------------------------------------------------------------ the listing


@pytest.mark.parametrize(
    ("error", "total", "last", "steps"),
    [
        (16, 0, 0, 16 + 10),
        (-16, 0, 0, -26),
        (1, 2560, 1, 1 + 6),
        (0, 255, 0, 0),
        (30_000, 0, 0, 2047),
        (-30_000, 0, 0, -2048),
    ],
)
def test_pid_to_dac(error: int, total: int, last: int, steps: int) -> None:
    """(Kp E + (Ki/256) E_T + Kd (E - E_L))/16, truncated as in C.

    Kp is 16, Ki 10, Kd 10.
    """
    routine = Listing(Settings(10, 1, 1, 16, ki=10, kd=10, max_steps=0))
    routine.error_sum, routine.last_error = total - error, last
    assert routine._overridden(routine._pid(error), 0) == steps


def test_the_listing_arrives() -> None:
    made = run_listing(Settings(20_000, 50, 1, 40, kd=80, hold=4, max_steps=32), 100.0, 2.0, 1500)
    assert made.demand[-1] == 20_000
    assert made.position[-1] == pytest.approx(20_000, abs=1.5)


@given(
    st.integers(1, 30_000),
    st.integers(1, 100),
    st.integers(1, 10),
    st.integers(1, 5),
    st.sampled_from([0, 8, 64]),
)
@settings(max_examples=examples(100))
def test_the_listing_never_overshoots_its_trajectory(
    distance: int, speed: int, accel: int, hold_steps: int, steps: int
) -> None:
    routine = Listing(Settings(distance, speed, accel, 40, hold=hold_steps, max_steps=steps))
    last = 0
    for _ in range(5 * distance + 100):
        routine.update(routine.position, 0)
        assert last <= routine.position <= distance
        assert routine.velocity <= speed
        if last == distance:
            break
        last = routine.position
    assert routine.position == distance


def test_the_listing_holds_its_dac() -> None:
    """A new value comes at most every RegCnt updates.

    The update at which the deceleration begins is an exception.
    """
    made = run_listing(Settings(20_000, 50, 1, 40, kd=80, hold=5, max_steps=0), 100.0, 2.0, 900)
    changes = [i for i in range(1, 900) if made.dac[i] != made.dac[i - 1]]
    gaps = [b - a for a, b in pairwise(changes)]
    assert sum(gap < 5 for gap in gaps) <= 1


def test_the_listing_stays_near_the_actual_velocity() -> None:
    routine = Listing(Settings(20_000, 50, 10, 4000, hold=1, max_steps=7))
    for k in range(200):
        assert abs(routine.update(0, 3 * k) - 3 * k) <= 7


def test_the_listings_pid_is_the_loops() -> None:
    """Without an override, the listing computes like the loop's integer form."""
    settings_ = Settings(5000, 40, 1, 60, 8, 120, integral_limit=900)
    made = run_listing(settings_, 100.0, 2.0, 400)
    loop = Loop(60, 8, 120, integral_limit=900, arithmetic="chapter12", dac_bits=12, servo_rate=1000.0)
    drive = VelocityDrive(10_000.0, 2e-3)

    class Points:
        starts = (0.0,)

        def position(self, time: float) -> float:
            k = round(time * 1000.0)
            return float(made.demand[min(max(k - 1, 0), 399)]) if k > 0 else 0.0

        def positions(self, times: list[float]) -> list[float]:
            return [self.position(time) for time in times]

        start = 0.0

    track = Points()
    track.profiles = (track,)  # type: ignore[attr-defined]
    trace = simulate(track, loop, drive, until=0.15)  # type: ignore[arg-type]
    steps = trace.dac_steps.astype(int).tolist()
    # The listing advances its trajectory before it measures; the loop measures at the beginning of a cycle.
    assert steps[1:] == list(made.dac[:150])


# --------------------------------------------------------------------------------------------------- the override


def test_the_override_keeps_the_load_where_it_is() -> None:
    free, overridden, fine, fine_overridden = demonstrate()
    for run in (free, fine):
        assert run.onset > 10.0 * LIMIT
        assert run.slid > 1e-3
    for run in (overridden, fine_overridden):
        assert run.mean < LIMIT
        assert run.slid == 0.0
    assert overridden.onset == pytest.approx(1.5 * LIMIT, rel=0.01)
    assert fine_overridden.onset < LIMIT


def test_more_gain_changes_nothing_under_the_override() -> None:
    for gain in (20, 200):
        _, overridden, _, fine_overridden = demonstrate(share=0.2, gain=gain)
        assert overridden.mean < LIMIT
        assert fine_overridden.onset < LIMIT


# ------------------------------------------------------------------------------------------------------- slipping


def test_a_trapezoid_slips_from_its_first_moment() -> None:
    found = check_profile(plan("trapezoid", 0.0, 2.0, SPEED, 4.0, 4.0), 0.1, 32.2)
    assert found.slips
    assert found.margin == pytest.approx(1.0 - 4.0 / 3.22)
    (first, until), (again, end) = found.spans
    assert (first, until) == pytest.approx((0.0, SPEED / 4.0))
    assert (again, end) == pytest.approx((2.0 / SPEED, 2.0 / SPEED + SPEED / 4.0))


def test_a_sine_slips_where_it_is_above_the_limit() -> None:
    from math import asin, pi

    found = check_profile(plan("sinusoidal", 0.0, 2.0, SPEED, 4.0, 4.0), 0.1, 32.2)
    ramp = pi / 2.0 * SPEED / 4.0
    first = ramp * asin(3.22 / 4.0) / pi
    assert found.spans[0] == pytest.approx((first, ramp - first))
    total = 2.0 / SPEED + ramp  # the distance at full speed, and half of each ramp
    assert found.spans[1] == pytest.approx((total - ramp + first, total - first))


def test_at_the_limit_nothing_slips() -> None:
    for shape in ("trapezoid", "sinusoidal", "scurve", "parabolic"):
        found = check_profile(plan(shape, 0.0, 2.0, 1.0, LIMIT, LIMIT, ramp=0.2), 0.1, 32.2)
        assert not found.slips, shape
        assert found.margin == pytest.approx(0.0, abs=1e-9)


def test_scale_is_counts_per_unit() -> None:
    found = check_profile(plan("trapezoid", 0.0, 2000.0, 1000.0 * SPEED, 4000.0, 4000.0), 0.1, 32.2, 1000.0)
    assert found.peak == pytest.approx(4.0)


def test_a_load_that_slips_arrives_late() -> None:
    """The carrier's speed steps to v; at mu g the load reaches it after v²/(2 mu g)."""
    loop = Loop(1.0, output_limit=10.0)
    drive = VelocityDrive(1000.0, 1e-6)
    profile = plan("trapezoid", 0.0, 100_000.0, 5000.0, 1e9, 1e9)
    trace = simulate(Track([0.0], [profile]), loop, drive, until=5.0)
    found = check_trace(trace, 0.1, 32.2, 1000.0)
    assert found.slips
    assert found.distance == pytest.approx(5.0**2 / (2.0 * 3.22), rel=0.02)
