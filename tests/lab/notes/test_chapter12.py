"""What the planners and the loop share with "Dissecting a Move Profile" (chapter 12)."""

from __future__ import annotations

import pytest

from motionlang.kernel.planners import plan
from motionlang.kernel.servo import Loop, VelocityDrive, simulate
from tests.lab.notes.vendor import dissect
from tests.lab.notes.vendor.chapter12 import Settings, run_listing

LIMIT = dissect.slip_acceleration(0.1, 32.2)
SPEED = 100.0 / 60.0


# -------------------------------------------------------------------------------------------------- figures 12.6, 9


def test_move_times_of_both_profiles() -> None:
    quick, smooth = dissect.trapezoid_times(2.0, SPEED, LIMIT), dissect.s_curve_times(2.0, SPEED, LIMIT)
    for times, shape, ramp in ((quick, "trapezoid", 0.1), (smooth, "scurve", 0.5)):
        profile = plan(shape, 0.0, 2.0, SPEED, LIMIT, LIMIT, ramp=ramp)
        assert times.move_time == pytest.approx(profile.duration, rel=1e-12)
        assert times.accel_time == pytest.approx(profile.phases[0].duration, rel=1e-12)
        assert times.accel_distance == pytest.approx(profile.phases[0].distance, rel=1e-12)
        assert times.slew_time == pytest.approx(profile.phases[1].duration, rel=1e-12)
    assert smooth.accel_time == pytest.approx(2.0 * quick.accel_time)


# ------------------------------------------------------------------------------------------------------ the listing


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


# ------------------------------------------------------------------------------------------------------- slipping
