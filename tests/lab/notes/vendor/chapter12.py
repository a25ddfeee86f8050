"""The C listing at the end of chapter 12, as one interrupt routine.

It combines the trajectory, PID and direct DAC override. The text of the scan is damaged. This is the program that
its comments describe, with corrected physics where a condition was lost (`NOTES`). All values are integers:
counts, counts per update, DAC steps.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import exp

from tests.lab.notes.vendor.dissect import divided

NOTES = (
    "The deceleration test lost its second half; here it is: past the middle while still accelerating, or no further "
    "from the end than the acceleration was long.",
    "Integ_Scale is Ki * Integ_Err_Sum / 16 in the scan and (Ki/256) in the text; the text is followed.",
    "The five branches for Error_Diff come to Error_Cnt - Last_Error and are written so.",
    "The seven branches of the clamp come to: no further than MxDAC_Stps from ActVel.",
    "The program would stop short where the steps of the deceleration do not add up; the rest is crept.",
)


@dataclass(frozen=True, slots=True)
class Settings:
    """The constants of the listing, named after its comments.

    `hold` is RegCnt, `max_steps` MxDAC_Stps (0 for no override), `speed` MxVel and `derivative_every`
    Differ_Smple_Tme. `accel` is the change of velocity every `hold` updates.
    """

    distance: int
    speed: int
    accel: int
    kp: int
    ki: int = 0
    kd: int = 0
    integral_limit: int = 32767
    derivative_every: int = 1
    hold: int = 1
    max_steps: int = 0
    bits: int = 12


# A move that accelerates by 1 count per update every fourth update, with an override of 32 steps.
EXAMPLE = Settings(20_000, 50, 1, 40, kd=80, hold=4, max_steps=32)


class Listing:
    """The interrupt routine with its static variables; `update` is one interrupt.

    >>> routine = Listing(Settings(distance=100, speed=10, accel=2, kp=40))
    >>> [routine.update(0, 0) for _ in range(3)], routine.velocity, routine.position
    ([5, 15, 30], 6, 12)
    """

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.updates = 0
        self.velocity = self.position = 0
        self.ramp_distance = 0
        self.decelerating = False
        self.error_sum = self.last_error = 0
        self.derivative_value = 0
        self.derivative_wait = 0
        self.dac = 0

    def update(self, actual_position: int, actual_velocity: int) -> int:
        """Execute one interrupt and return the output value of the DAC.

        The position is in counts from the encoder, the velocity in DAC steps from the tachometer.
        """
        self.updates += 1
        if self.updates < self.settings.hold:
            if not self._begins_to_stop():
                self._go_on()
                return self.dac
            self._slower()
        elif self.decelerating or self._begins_to_stop():
            self._slower()
        else:
            self._faster()
        self._go_on()
        self.dac = self._overridden(self._pid(self.position - actual_position), actual_velocity)
        self.updates = 0
        return self.dac

    # -- the trajectory

    def _begins_to_stop(self) -> bool:
        """Set the deceleration flag at its time; return True only for that update."""
        if self.decelerating:
            return False
        s, ahead = self.settings, self.position + self.velocity
        if self.velocity < s.speed:
            self.decelerating = 2 * ahead > s.distance
        else:
            self.decelerating = ahead > s.distance - self.ramp_distance
        return self.decelerating

    def _faster(self) -> None:
        self.velocity = min(self.velocity + self.settings.accel, self.settings.speed)
        if self.velocity < self.settings.speed:
            self.ramp_distance = self.position + self.velocity * self.settings.hold

    def _slower(self) -> None:
        self.velocity = max(self.velocity - self.settings.accel, 1)

    def _go_on(self) -> None:
        self.velocity = min(self.velocity, self.settings.distance - self.position)
        self.position += self.velocity

    # -- the DAC

    def _pid(self, error: int) -> int:
        s = self.settings
        self.error_sum += error
        integral = divided(s.ki * self.error_sum, 256)
        integral = max(-s.integral_limit, min(s.integral_limit, integral))
        self.derivative_wait += 1
        if self.derivative_wait >= s.derivative_every:
            self.derivative_value = s.kd * (error - self.last_error)
            self.derivative_wait, self.last_error = 0, error
        return divided(s.kp * error + integral + self.derivative_value, 1 << (16 - s.bits))

    def _overridden(self, dac: int, actual: int) -> int:
        s = self.settings
        if s.max_steps:
            dac = max(actual - s.max_steps, min(actual + s.max_steps, dac))
        top = 1 << (s.bits - 1)
        return max(-top, min(top - 1, dac))


@dataclass(frozen=True, slots=True)
class ListingRun:
    """A run of the listing in columns, with one row per update.

    Velocity is in counts per update, `dac` in steps.
    """

    period: float
    demand: Sequence[int]
    position: Sequence[float]
    velocity: Sequence[float]
    dac: Sequence[int]
    # Acceleration just after a change of the DAC, counts per update².
    onset: Sequence[float]

    @property
    def peak_onset(self) -> float:
        """The largest acceleration just after a DAC change."""
        return max(map(abs, self.onset), default=0.0)

    @property
    def peak_mean(self) -> float:
        """The largest acceleration over a whole update."""
        pairs = zip(self.velocity, self.velocity[1:], strict=False)
        return max((abs(after - before) for before, after in pairs), default=0.0)


def run_listing(
    settings: Settings = EXAMPLE,
    full_speed: float = 100.0,
    time_constant: float = 2.0,
    updates: int = 1000,
    period: float = 1.0,
) -> ListingRun:
    """Run the listing on chapter 12's drive.

    The motor's velocity follows the DAC's with a first-order lag. `full_speed` is in counts per update at full
    scale, `time_constant` in updates, `period` in seconds per update.

    >>> made = run_listing()
    >>> made.demand[-1], made.dac[200], round(made.peak_mean, 7)
    (20000, 1000, 0.6183412)
    """
    routine = Listing(settings)
    top = 1 << (settings.bits - 1)
    keep = exp(-1.0 / time_constant)
    position = velocity = 0.0
    rows: list[tuple[int, float, float, int, float]] = []
    for _ in range(updates):
        dac = routine.update(round(position), round(velocity / full_speed * top))
        wanted = dac * full_speed / top
        rows.append((routine.position, position, velocity, dac, (wanted - velocity) / time_constant))
        gap = wanted - velocity
        position += wanted - gap * time_constant * (1.0 - keep)
        velocity = wanted - gap * keep
    demand, positions, velocities, dacs, onsets = zip(*rows, strict=True)
    return ListingRun(period, demand, positions, velocities, dacs, onsets)
