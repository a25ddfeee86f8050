"""A velocity as a profile of its own, so that its crossings can be found."""

from __future__ import annotations

from motionlang.kernel.planners.curve import MotionState, Profile
from motionlang.kernel.planners.formula import FormulaProfile


class Rate(FormulaProfile):
    """A profile whose position is the velocity of another profile.

    Its velocity is the acceleration of that profile, and so on.
    """

    __slots__ = ("profile",)

    def __init__(self, profile: Profile) -> None:
        self.profile = profile
        first = profile.at(0.0).acceleration if profile.duration else 0.0
        super().__init__(
            profile.shape, profile.start_velocity, profile.end_velocity, profile.duration, first, 0.0
        )

    def state(self, time: float) -> MotionState:
        now = self.profile.at(time)
        return MotionState(now.velocity, now.acceleration, now.jerk, 0.0)

    @property
    def knots(self) -> tuple[float, ...]:
        """The knots of the other profile."""
        return self.profile.knots
