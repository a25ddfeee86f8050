"""Every formula, listing and figure of "Dissecting a Move Profile" (chapter 12).

They are compared with the figures that the text prints.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel.planners import plan
from motionlang.kernel.servo import Loop, Track, VelocityDrive, simulate
from tests.cases import examples
from tests.lab.notes.vendor import dissect
from tests.lab.notes.vendor.chapter12 import Listing, ListingRun, Settings, run_listing
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


def test_a_move_too_short_for_its_speed_is_refused() -> None:
    with pytest.raises(ValueError, match="too short to reach its speed"):
        dissect.s_curve_times(0.1, SPEED, LIMIT)


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


@pytest.mark.parametrize(
    ("listing", "velocities"),
    [
        # Up by 2 to 4. From 18 on, 4 more would exceed 20 less the ramp of 2: it slows down.
        (Settings(20, 4, 2, 40), [2, 4, 4, 4, 4, 2]),
        # It never reaches its speed: from 6 on, twice the next 10 exceeds the distance; the slowest is 1.
        (Settings(10, 100, 2, 40), [2, 4, 2, 1, 1]),
        # Each velocity lasts for two updates, the ramp covers 3 * 2: it slows down where 6 more exceeds 40 - 6.
        (Settings(40, 6, 3, 40, hold=2), [0, 3, 3, 6, 6, 6, 6, 3, 3, 1, 1, 1, 1]),
        (Settings(41, 6, 3, 40, hold=3), [0, 0, 3, 3, 3, 6, 6, 6, 3, 3, 3, 1, 1, 1, 1, 1]),
        # At 6, twice 6 + 3 exceeds 13.
        (Settings(13, 100, 3, 40, hold=2), [0, 3, 3, *7 * [1]]),
        # At 1, twice 1 + 1 exceeds 3, but not 4.
        (Settings(3, 100, 1, 40), [1, 1, 1]),
        (Settings(4, 100, 1, 40), [1, 2, 1]),
        # It has its speed from the first update on, so the ramp covers nothing.
        (Settings(6, 2, 2, 40), [2, 2, 2]),
    ],
)
def test_the_listing_steps_through_its_velocities(listing: Settings, velocities: list[int]) -> None:
    routine, position = Listing(listing), 0
    for velocity in velocities:
        assert routine.position < listing.distance
        routine.update(routine.position, 0)
        position += velocity
        assert (routine.velocity, routine.position) == (velocity, position)
    assert routine.position == listing.distance


def test_the_listings_derivative_is_that_of_the_last_updates() -> None:
    """Every second update, Kd times the difference: 10 * 16, then 10 * (48 - 16).

    The integral, twice the sum of the errors, is 0, 32, 96 and, limited, 150 of 192.
    """
    routine = Listing(
        Settings(10_000, 1, 1, 0, ki=512, kd=10, integral_limit=150, derivative_every=2, bits=16)
    )
    errors = [0, 16, 32, 48]
    outputs = [routine._pid(error) for error in errors]
    assert outputs == [0, 2 * 16 + 160, 2 * 48 + 160, 150 + 320]


def test_the_listing_is_proportional_without_other_gains() -> None:
    """Of an error of 16, a Kp of 40 makes 640 / 16 steps.

    A Ki of 256 adds the sum of the errors, 32 767 at most. The first of two updates
    has no output yet.
    """
    assert Listing(Settings(10, 1, 1, 40))._pid(16) == 40
    assert Listing(Settings(10, 1, 1, 0, ki=256, bits=16))._pid(40_000) == 32_767
    routine = Listing(Settings(40, 6, 3, 160, hold=2))
    assert [routine.update(0, 0) for _ in range(2)] == [0, 30]


@pytest.mark.parametrize(
    ("dac", "actual", "output"),
    [(500, 490, 497), (480, 490, 483), (492, 490, 492), (2050, 2047, 2047), (-2100, -2047, -2048)],
)
def test_the_override_limits_the_dac_around_the_actual_velocity(dac: int, actual: int, output: int) -> None:
    """At most 7 steps, and 12 bits: -2048 to 2047."""
    assert Listing(Settings(10, 1, 1, 0, max_steps=7))._overridden(dac, actual) == output


def test_the_drive_follows_the_first_step_of_the_dac() -> None:
    """An error of 4 at a Kp of 40 is 10 of 2048 steps; 204.8 at full is 1 at 10 steps.

    With a time constant of 2 updates, 1 - exp(-1/2) of it is reached after one.
    """
    made = run_listing(Settings(1000, 4, 4, 40), 204.8, 2.0, 2)
    reached = 1.0 - math.exp(-0.5)
    assert made.dac[0] == 10
    assert made.onset[0] == pytest.approx(0.5)
    assert (made.position[:1], made.velocity[:1]) == ((0.0,), (0.0,))
    assert made.velocity[1] == pytest.approx(reached)
    assert made.position[1] == pytest.approx(1.0 - 2.0 * reached)
    # Now 8 less a position of 0.2, rounded to 0, is 20 steps, or 2.
    assert made.dac[1] == 20
    assert made.onset[1] == pytest.approx((2.0 - reached) / 2.0)


def test_the_peaks_of_a_run_are_those_of_its_columns() -> None:
    made = ListingRun(1.0, [], [], [0.0, 3.0, 2.0, -4.0], [], [1.0, -5.0, 2.0])
    assert (made.peak_onset, made.peak_mean) == (5.0, 6.0)
    nothing = ListingRun(1.0, [], [], [2.0], [], [])
    assert (nothing.peak_onset, nothing.peak_mean) == (0.0, 0.0)


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


@pytest.mark.parametrize(
    ("speed", "limit", "updates"), [(SPEED, LIMIT, 4), (2.0, 3.22, 5), (0.5, 3.0, 2), (0.6144, 1.0, 4)]
)
def test_a_step_is_held_for_five_time_constants_of_the_motor(
    speed: float, limit: float, updates: int
) -> None:
    """A step of 12 bits takes speed / 2048 / limit; the time constant is 2/3 of that.

    With 0.814, 0.977, 0.244 and 0.3 mm/s that is 0.84, 1.01, 0.27 and 1 ms, in updates of 0.25 ms. A step of 16 bits
    takes a sixteenth: 10 of them fit into 10 2/3.
    """
    runs = demonstrate(speed, friction=1.0, gravity=limit)
    assert [(run.name, run.bits, run.steps, run.hold) for run in runs] == [
        ("12 bits, free", 12, 0, 1),
        ("12 bits, held", 12, 1, updates),
        ("16 bits, free", 16, 0, 1),
        ("16 bits, held", 16, 10, 1),
    ]
    assert {run.limit for run in runs} == {limit}


def test_the_move_of_the_override_has_a_tenth_of_a_second_at_its_speed() -> None:
    """At 0.95 of 2 and a quarter of 3.22, the ramps take 1.9²/0.805 and the slew 0.19."""
    for run in demonstrate(2.0):
        assert run.trace.commanded[-1] * 2.0 / 100_000.0 == pytest.approx(1.9**2 / 0.805 + 0.19, abs=2e-5)
        assert run.trace.commanded[0] == 0.0
        assert run.error == pytest.approx(run.trace.peak_error * 2.0 / 100_000.0)


@pytest.mark.parametrize("share", [1.0, 1.5])
def test_a_demand_at_the_limit_is_refused(share: float) -> None:
    with pytest.raises(ValueError, match="must be below 1, not"):
        demonstrate(share=share)


def test_the_override_is_shown_from_the_start_of_its_move_to_the_rest_behind_it() -> None:
    """In 0.2 s, a quarter of LIMIT covers 0.5 · 0.25 LIMIT · 0.2².

    SPEED corresponds to 100 000 counts/s.
    """
    for run in demonstrate():
        accelerated = 0.5 * 0.25 * LIMIT * 100_000.0 / SPEED * 0.2**2
        assert run.trace.commanded[round(0.2 / run.trace.loop.period)] == pytest.approx(accelerated, abs=1.0)
        moves = np.flatnonzero(np.diff(run.trace.commanded))
        end = (moves[-1] + 1) * run.trace.loop.period
        assert run.trace.time[-1] - end == pytest.approx(0.5, abs=2.0 * run.trace.loop.period)


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


def test_friction_must_be_a_friction() -> None:
    with pytest.raises(ValueError, match="friction must be greater than zero"):
        dissect.slip_acceleration(0.0, 9.81)
