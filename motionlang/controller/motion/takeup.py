"""Play that the motor takes up on top of its axis's motion: how much of it, and which way the axis went last."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.planners import Profile

# Seconds behind a turn at which the axis goes the other way, or rests.
_MOMENT = 1e-9


class Takeup:
    """The play of one axis, counts: it is on the side that `size` has as its sign, and taken up in `ramp` seconds.

    With a `size` above zero the motor stands at the negative end: going forward it needs the whole size, going in
    reverse nothing; below zero the other way round. Play is taken up only while the axis moves.
    """

    __slots__ = ("_axis", "_time", "heading", "ramp", "size", "taken")

    def __init__(self, axis: Axis, now: float) -> None:
        self._axis, self._time = axis, now
        self.size = self.ramp = self.taken = 0.0
        self.heading = 0

    def advance(self, now: float, on: bool) -> float:
        """What is taken up by now, counts."""
        while self._time < now:
            end, heading = self._stretch(now)
            if heading:
                self.heading = heading
                if on:
                    self._take(heading, end - self._time)
            self._time = end
        return self.taken

    def rate(self) -> float:
        """How fast it is being taken up, counts/s, as far as `advance` has come."""
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
        """Up to when the axis goes one way, and which."""
        begin = self._time
        start, profile = self._axis.in_force(begin)
        end = min(now, self._axis.next_start(begin))
        if start > begin:  # a session that has run for long has forgotten what was in force
            return min(start, end), 0
        turn, after = None, begin - start + _MOMENT
        if profile.peak_speed:
            rests = not profile.velocity(after)
            turn = _next_knot(profile, after) if rests else profile.velocity_crossing(0.0, after)
        if turn is not None and begin < start + turn < end:
            end = start + turn
        velocity = profile.velocity(0.5 * (begin + end) - start)
        return end, (velocity > 0.0) - (velocity < 0.0)


def _next_knot(profile: Profile, after: float) -> float | None:
    """When the next piece of a profile begins, before which one that rests does not move."""
    return next((knot for knot in profile.knots if knot > after), None)
