"""The four profiles of TN1069 as the command of a servo."""

from __future__ import annotations

from math import inf, pi

import pytest

from motionlang.kernel.planners import plan
from motionlang.kernel.servo import Loop, Motor
from motionlang.lab.servo.tn1069 import SHAPES, accel_for, compare, peak_jerk

LOOP, MOTOR = Loop(0.014, 9e-5, 0.6), Motor(load_inertia=4e-5)
EXAMPLE = (40_000.0, 40_000.0, 100_000.0)


def test_equal_acceleration_is_the_notes_example() -> None:
    rows = {row.shape: row for row in compare(LOOP, MOTOR, *EXAMPLE)}
    cycles = {shape: row.time * 1000.0 for shape, row in rows.items()}
    assert cycles == pytest.approx(
        {"trapezoid": 1400.0, "sinusoidal": 1628.318531, "scurve": 1444.444444, "parabolic": 1549.193338}
    )


def test_equal_time_gives_every_shape_what_it_needs() -> None:
    rows = {row.shape: row for row in compare(LOOP, MOTOR, *EXAMPLE, "time")}
    assert {shape: row.time for shape, row in rows.items()} == pytest.approx(dict.fromkeys(SHAPES, 1.4))
    accelerations = {shape: row.accel / 100_000.0 for shape, row in rows.items()}
    # At equal V and equal time T - D/V is V/A times 1, pi/2, 1/(1 - n) and 4/3.
    assert accelerations == pytest.approx(
        {"trapezoid": 1.0, "sinusoidal": pi / 2.0, "scurve": 1.0 / 0.9, "parabolic": 4.0 / 3.0}
    )


def test_the_trapezoid_takes_longest_to_settle_and_the_sine_is_smoothest() -> None:
    """According to TN1069 the trapezoid is the fastest to reach its speed.

    The note adds "but can result in somewhat longer settling times".
    """
    for basis in ("acceleration", "time"):
        rows = {row.shape: row for row in compare(LOOP, MOTOR, *EXAMPLE, basis)}
        assert rows["sinusoidal"].settle < rows["scurve"].settle < rows["trapezoid"].settle
        assert rows["sinusoidal"].motor_jerk < rows["scurve"].motor_jerk < rows["trapezoid"].motor_jerk


def test_torque_is_that_of_the_moves_acceleration() -> None:
    row = compare(LOOP, MOTOR, *EXAMPLE)[0]
    needed = MOTOR.total_inertia * 100_000.0 / MOTOR.counts_per_radian
    assert row.peak_torque == pytest.approx(needed, rel=0.25)
    # Accelerating for 0.4 s and braking for 0.4 s of 1.4 s.
    assert row.rms_torque == pytest.approx(needed * (0.8 / 1.4) ** 0.5, rel=0.05)


def test_demanded_jerk() -> None:
    made = {shape: peak_jerk(plan(shape, 0.0, *EXAMPLE, EXAMPLE[2], ramp=0.1)) for shape in SHAPES}
    assert made["trapezoid"] == made["parabolic"] == inf
    assert made["sinusoidal"] == pytest.approx(pi * 1e5 / 0.6283185307)
    assert made["scurve"] == pytest.approx(1e5 / (0.1 * 0.4444444444))


def test_short_moves_compare_too() -> None:
    time = plan("trapezoid", 0.0, 100.0, 40_000.0, 1e5, 1e5).duration
    for shape in SHAPES:
        accel = accel_for(shape, 100.0, 40_000.0, time, 0.1)
        assert plan(shape, 0.0, 100.0, 40_000.0, accel, accel, ramp=0.1).duration == pytest.approx(
            time, rel=1e-9
        )


def test_a_long_move_needs_little_acceleration() -> None:
    """At T = 110, D = 100 and V = 1, T - D/V is 10: V/A times 1, π/2, 1/0.9 and 4/3."""
    found = [accel_for(shape, 100.0, 1.0, 110.0, 0.1) for shape in SHAPES]
    assert found == pytest.approx([0.1, 0.05 * pi, 0.1 / 0.9, 0.4 / 3.0])


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: compare(LOOP, MOTOR, *EXAMPLE, "jerk"), "equal acceleration or time, not 'jerk'"),
        (lambda: accel_for("trapezoid", 100.0, 10.0, 5.0, 0.1), "take longer than 5 s in every shape"),
        (lambda: accel_for("trapezoid", 100.0, 10.0, 10.0, 0.1), "take longer than 10 s in every shape"),
    ],
)
def test_refusals(call: object, message: str) -> None:
    assert callable(call)
    with pytest.raises(ValueError, match=message):
        call()
