"""Chapter 12's argument as a simulation: a move with and without a DAC override.

The gain is the same in all runs.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil
from typing import TYPE_CHECKING

from motionlang.kernel.planners import hold, plan
from motionlang.kernel.servo import FULL_SCALE, Loop, Override, Track, VelocityDrive, simulate
from tests.lab.notes.vendor.dissect import FRICTION, GRAVITY_FT, SPEED_FT_MIN, dac_timing, slip_acceleration
from tests.lab.notes.vendor.slip import check_trace

if TYPE_CHECKING:
    from motionlang.kernel.servo import ServoTrace

# Counts per second at full scale: the encoder of the example.
FULL_COUNTS = 100_000.0
UPDATE = 1.0 / 4000.0
REST = 0.5
_CRUISE = 0.95
_SLEW = 0.1


@dataclass(frozen=True, slots=True)
class OverrideRun:
    """One variant of the move.

    Accelerations are in the unit of the limit. `onset` is the largest acceleration just after a DAC change,
    `mean` the largest mean over an update, `error` the largest following error. `slid` is the distance that
    the load slipped, in the same unit of length.
    """

    name: str
    bits: int
    steps: int
    hold: int
    onset: float
    mean: float
    limit: float
    slid: float
    error: float
    trace: ServoTrace


def demonstrate(
    speed: float = SPEED_FT_MIN / 60.0,
    friction: float = FRICTION,
    gravity: float = GRAVITY_FT,
    share: float = 0.25,
    gain: int = 60,
) -> list[OverrideRun]:
    """Run a trapezoid at `share` of the slip limit to nearly `speed` in four variants.

    `speed`, in units per second, is the full scale of the DAC. The variants are 12 and 16 bits, each without and
    with the override. With 12 bits the override holds each step for five time constants, as in the chapter. With
    16 bits it allows as many steps per update as fit into the motor's time constant. The loop's proportional gain is
    `gain`.

    >>> [f"{run.name}: {run.onset / run.limit:.3f}" for run in demonstrate()]
    ['12 bits, free: 12.000', '12 bits, held: 1.504', '16 bits, free: 11.250', '16 bits, held: 0.984']
    """
    limit = slip_acceleration(friction, gravity)
    if not share < 1.0:
        raise ValueError(f"the demanded fraction of the limit must be below 1, not {share:.10g}")
    coarse = dac_timing(speed, limit, 12)
    fine_steps = int(coarse.electrical_time_constant / dac_timing(speed, limit, 16).step_time)
    hold_updates = ceil(coarse.hold_time / UPDATE * (1.0 - 1e-9))
    scale = FULL_COUNTS / speed
    variants = (
        ("12 bits, free", 12, 0, 1),
        ("12 bits, held", 12, 1, hold_updates),
        ("16 bits, free", 16, 0, 1),
        ("16 bits, held", 16, fine_steps, 1),
    )
    made = []
    for name, bits, steps, hold_count in variants:
        override = Override(steps, hold_count, FULL_COUNTS) if steps else None
        loop = Loop(
            gain,
            arithmetic="chapter12",
            dac_bits=bits,
            override=override,
            servo_rate=1.0 / UPDATE,
            trajectory_rate=1.0 / UPDATE,
        )
        drive = VelocityDrive(FULL_COUNTS / FULL_SCALE, coarse.electrical_time_constant)
        trace = _run(loop, drive, _CRUISE * speed * scale, share * limit * scale)
        found = check_trace(trace, friction, gravity, scale)
        onset = float(abs(trace.onset).max()) / scale
        error = trace.peak_error / scale
        made.append(
            OverrideRun(name, bits, steps, hold_count, onset, found.peak, limit, found.distance, error, trace)
        )
    return made


def _run(loop: Loop, drive: VelocityDrive, speed: float, accel: float) -> ServoTrace:
    distance = speed * speed / accel + speed * _SLEW
    profile = plan("trapezoid", 0.0, distance, speed, accel, accel)
    end = profile.duration
    return simulate(Track([0.0, end], [profile, hold(profile.end)]), loop, drive, until=end + REST)
