"""A profile that begins with an acceleration: sections of constant jerk, then ramps."""

from __future__ import annotations

from motionlang.kernel.planners.curve import Profile, relabelled
from motionlang.kernel.planners.ramps import Curve, Recipe
from motionlang.kernel.planners.transition import Steps, profile_of_steps
from motionlang.kernel.tools import total

# Velocity and acceleration in the direction of the motion, the sections, and that direction.
Head = tuple[float, float, Steps, float]


class JerkLimited(Profile):
    """Sections of constant jerk from v0 and a0, then the ramps of a recipe to `end`.

    The pieces are computed on first use, like those of a recipe, because most plans are only read for their end.
    `name` makes the sections one phase of that name if they are not part of a ramp.
    """

    __slots__ = ("_head", "_name", "_tail")

    def __init__(
        self, start: float, end: float, duration: float, head: Head, tail: Recipe, name: str = ""
    ) -> None:
        # What `Profile.__init__` assigns, since a running program plans in motion.
        self.shape = "scurve"
        self.start = start
        self.end = end
        self.duration = duration
        self._recipe = (head[0] * head[3], tail[-1])
        self._head = head
        self._tail = tail
        self._name = name

    @property
    def curve(self) -> Curve:
        """Knots, pieces and phase marks."""
        try:
            return self._curve
        except AttributeError:
            v0, a0, steps, sign = self._head
            head = profile_of_steps(self.start, v0, a0, steps, sign * self._tail[0], sign)
            if self._name:
                head = relabelled(head, "scurve", self._name)
            time = total(self._tail[1::3])
            rest = Profile("scurve", head.end, self.end, time, self._tail) if time else None
            knots, pieces, marks = (head if rest is None else head.then(rest)).curve
            if len(knots) > 1 and self.duration > knots[-2]:
                knots = (*knots[:-1], self.duration)
            self._curve = knots, pieces, marks
            return self._curve
