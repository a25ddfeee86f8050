"""Backlash taken up by the motor: how much so far, and the axis's last direction."""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.planners import Profile

# Seconds after a reversal at which the axis moves back, or rests.
_MOMENT = 1e-9


class Takeup:
    """The backlash of one axis, counts, taken up in `ramp` seconds.

    With a positive `size` the motor rests at the negative end: forward motion must take up the complete size,
    reverse motion nothing. A negative size means the opposite. Backlash is taken up only while the axis moves.
    """

    __slots__ = ("_axis", "_time", "heading", "ramp", "size", "taken")

    def __init__(self, axis: Axis, now: float) -> None:
        self._axis, self._time = axis, now
        self.size = self.ramp = self.taken = 0.0
        self.heading = 0

    def advance(self, now: float, on: bool) -> float:
        """Advance to a time and return the backlash taken up by then, counts."""
        while self._time < now:
            end, heading = self._stretch(now)
            if heading:
                self.heading = heading
                if on:
                    self._take(heading, end - self._time)
            self._time = end
        return self.taken

    def rate(self) -> float:
        """Return the rate, counts/s, of taking up backlash after the last `advance`."""
        left = self._goal(self.heading) - self.taken
        if not left or not self.ramp or not self._axis.velocity(self._time):
            return 0.0
        return (1.0 if left > 0.0 else -1.0) * abs(self.size) / self.ramp

    def _goal(self, heading: int) -> float:
        return self.size if heading * self.size > 0.0 else 0.0

    def _take(self, heading: int, time: float) -> None:
        left = self._goal(heading) - self.taken
        most = abs(self.size) * time / self.ramp if self.ramp else abs(left)
        self.taken += max(-most, min(most, left))

    def _stretch(self, now: float) -> tuple[float, int]:
        """Return the time until which the axis keeps its direction, and the direction."""
        begin = self._time
        start, profile = self._axis.in_force(begin)
        end = min(now, self._axis.next_start(begin))
        if start > begin:  # a long session has dropped the profile that was in force
            return min(start, end), 0
        reversal, after = None, begin - start + _MOMENT
        if profile.peak_speed:
            is_at_rest = not profile.velocity(after)
            reversal = _next_knot(profile, after) if is_at_rest else profile.velocity_crossing(0.0, after)
        if reversal is not None and begin < start + reversal < end:
            end = start + reversal
        velocity = profile.velocity(0.5 * (begin + end) - start)
        return end, (velocity > 0.0) - (velocity < 0.0)


def _next_knot(profile: Profile, after: float) -> float | None:
    return next((knot for knot in profile.knots if knot > after), None)
