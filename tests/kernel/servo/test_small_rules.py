"""Small rules of the simulated motors, each covered by this test alone."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel.planners import hold, plan_trapezoid
from motionlang.kernel.servo import Loop, Motor, Track, VelocityDrive, make_loop, simulate
from motionlang.kernel.servo.demand import Generator
from motionlang.kernel.servo.discrete import discretise
from motionlang.kernel.servo.response import DROP, _crossing, _first_fall
from motionlang.kernel.servo.samples import SampleBlock, SettlingWindow, next_other_side, next_side
from motionlang.kernel.servo.step import COLUMNS, LoopStep, at_rest


@pytest.mark.parametrize(
    ("error", "since"), [([9.0, 9.0, 0.0, 0.0, 0.0], 102.0), ([0.0, 0.0, 0.0], 100.0), ([0.0, 9.0], np.inf)]
)
def test_a_window_is_met_since_the_sample_after_the_last_one_outside(
    error: list[float], since: float
) -> None:
    rows = np.zeros((len(COLUMNS), len(error)))
    rows[COLUMNS.index("demand")] = error
    window = SettlingWindow(error=1.0)
    window.pass_by(SampleBlock(100, rows), 0.0, 100 + len(error))
    assert window.since == since


def test_the_first_sample_on_a_side_and_on_another_one() -> None:
    assert next_side(np.array([0.0, 0.0, 5.0, 6.0]), 0.0, 0) == (2, 1)
    assert next_side(np.array([0.0, -4.0]), 0.0, 0) == (1, -1)
    assert next_other_side(np.array([1.0, 2.0, -1.0]), 0.0) == 2
    assert next_other_side(np.array([1.0, 0.0, 1.0]), 0.0) == 1


def test_a_motor_within_a_millionth_of_a_count_is_at_the_level() -> None:
    """It came from above: it changes sides as it goes below, not as it returns."""
    assert next_side(np.array([0.0, 1e-6, -1.0]), 0.0, 1) == (2, -1)
    assert next_side(np.array([0.0, -1e-6, 1.0]), 0.0, 1) == (None, 1)


def test_the_current_of_a_motor_without_inductance() -> None:
    """I = (gain u - K w)/R, with w in radians per second."""
    motor = Motor(
        inductance=0.0, resistance=2.0, torque_constant=0.05, counts_per_rev=4000.0, amplifier_gain=2.4
    )
    row = discretise(motor, 1e-3).current
    assert row == pytest.approx((0.0, -0.05 / 2.0 * 2.0 * math.pi / 4000.0, 0.0, 0.0, 0.0, 1.2, 0.0))


@pytest.mark.parametrize(("encoder", "resonance", "apart"), [
    ("load", 20.0, True), ("load", 0.0, False), ("motor", 20.0, False), ("motor", 0.0, False)])  # fmt: skip
def test_an_encoder_on_the_load_of_a_rigid_coupling_is_one_on_the_motor(
    encoder: str, resonance: float, apart: bool
) -> None:
    """Without a resonance the two sides have one position, and the plant has no twist."""
    made = discretise(Motor(load_inertia=1e-5, encoder=encoder, resonance=resonance), 1e-3)
    assert made.load_encoder is apart
    assert made.has_twist is (resonance > 0.0)


@pytest.mark.parametrize("load", [0.0, 0.01])
@pytest.mark.parametrize("inductance", [0.0, 1e-3])
def test_the_onset_is_the_acceleration_by_the_torque_of_that_moment(inductance: float, load: float) -> None:
    """An inductance delays the effect of the output; a load accelerates in reverse."""
    motor = Motor(inductance=inductance, viscous=0.0, load_torque=load)
    moved = Track([0.01], [plan_trapezoid(0.0, 500.0, 8000.0, 90_000.0, 90_000.0)])
    trace = simulate(moved, Loop(0.04, 2e-5, 0.9, integral_limit=5.0), motor, until=0.1)
    assert trace.onset == pytest.approx((trace.torque - load) * motor.counts_per_radian / motor.inertia)
    assert trace.peak_output > 0.1


def test_the_sum_of_errors_of_an_lm628_has_24_bits() -> None:
    """With an upper limit one higher, the sum would exceed the last multiple of 256."""
    loop = Loop(0, 1, 0, integral_limit=32767, arithmetic="lm628", dac_bits=12)
    still = VelocityDrive(1e-6, 1.0)
    step, (motion, (_, *memory)) = LoopStep(loop, still), at_rest(0.0)
    state, (*_, first, _) = step((motion, (8_388_600.0, *memory)), 100.0, 0.0, True)  # type: ignore[arg-type]
    _, (*_, second, _) = step(state, -256.0, 0.0, True)
    assert second / first == 32766.0 / 32767.0


def test_an_override_holds_for_one_update_unless_it_says_so() -> None:
    for options in ({}, {"override_hold": 1}):
        made = make_loop({"override_steps": 5, "dac_bits": 12, **options}).override
        assert made is not None
        assert (made.steps, made.hold) == (5, 1)


def test_a_gain_that_falls_at_once_is_searched_in_the_first_interval() -> None:
    grid = np.array([1.0, 2.0, 3.0, 4.0])
    assert _first_fall(grid, 1.0 / grid, lambda f: 1.0 / f) == pytest.approx(1.0 / DROP)
    assert _first_fall(grid, 3.5 * DROP / grid, lambda f: 3.5 * DROP / f) == pytest.approx(3.5)


def test_another_zero_at_a_sample_moves_no_motor() -> None:
    """This holds for either rounding of a time."""
    for k in range(1, 200):
        for time in (math.nextafter(k * 1e-3, 0.0), k * 1e-3, math.nextafter(k * 1e-3, 1.0)):
            track = Track([0.0, time], [hold(0.0), hold(100.0)])
            assert not any(Generator(track, 1e-3).points(0, 200))


@given(
    starts=st.lists(st.integers(0, 60), min_size=1, max_size=40).map(sorted),
    times=st.lists(st.integers(-2, 62), min_size=1, max_size=12),
)
def test_the_profile_in_force_is_found_from_wherever_one_was_found_before(
    starts: list[int], times: list[int]
) -> None:
    generator = Generator(Track([float(start) for start in starts], [hold(0.0)] * len(starts)), 1e-3)
    for time in times:
        begun = sum(start <= time for start in starts)
        assert generator.in_force_at(float(time)) == max(begun - 1, 0)


def test_the_acceleration_of_a_drive_goes_by_its_time_constant() -> None:
    """It is (10 u - v) / 0.5; after a third of 0.5 s exp(-1/3) of a change is left."""
    regime = discretise(VelocityDrive(speed_per_volt=10.0, time_constant=0.5), 0.5 / 3.0).regimes[1, 1]
    position, velocity, *others = regime.rows
    assert regime.drive == (0.0, -2.0, 0.0, 0.0, 0.0, 20.0, 0.0)
    left = math.exp(-1.0 / 3.0)
    assert velocity == pytest.approx((0.0, left, 0.0, 0.0, 0.0, 10.0 * (1.0 - left), 0.0))
    lag = 0.5 * (1.0 - left)
    assert position == pytest.approx((1.0, lag, 0.0, 0.0, 0.0, 10.0 * (0.5 / 3.0 - lag), 0.0))
    assert [sum(row) for row in others] == [1.0] * 3  # states that it does not have


@pytest.mark.parametrize(
    ("level", "time"),
    [(0.0, 1.0), (0.2, 1.0), (0.4, 3.0), (0.6, 5.0), (0.65, 6.25), (0.8, 7.0), (0.9, math.inf)],
)
def test_a_response_reaches_a_level_between_two_samples(level: float, time: float) -> None:
    """It is at 0.2 and 0.6 at 1 and 5 s, at 0.5 at 5.5 s, and rises to 0.8 at 7 s."""
    share, times = np.array([0.2, 0.6, 0.5, 0.8]), np.array([1.0, 5.0, 5.5, 7.0])
    assert _crossing(share, times, level) == pytest.approx(time)
