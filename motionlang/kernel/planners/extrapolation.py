"""Extrapolation of a profile at its velocity, to compensate for a known delay."""

from __future__ import annotations

from math import inf

from motionlang.kernel.planners.curve import MotionState, Profile
from motionlang.kernel.planners.formula import FormulaProfile


class Extrapolated(FormulaProfile):
    """Position plus `lead` seconds of velocity: p(t) + lead v(t).

    A switch with that delay acts on time when it is driven by this position. At constant velocity it is the position
    `lead` seconds later. A jump of the velocity makes this position jump.
    """

    __slots__ = ("lead", "profile")

    def __init__(self, profile: Profile, lead: float) -> None:
        self.profile, self.lead = profile, lead
        last = profile.end_velocity
        super().__init__(
            profile.shape,
            profile.start + lead * profile.start_velocity,
            profile.end if abs(profile.end) == inf else profile.end + lead * last,
            profile.duration,
            profile.start_velocity,
            last,
        )

    def state(self, time: float) -> MotionState:
        """Return the state, each derivative plus `lead` times the next higher one."""
        now, lead = self.profile.at(time), self.lead
        return MotionState(
            now.position + lead * now.velocity,
            now.velocity + lead * now.acceleration,
            now.acceleration + lead * now.jerk,
            0.0,
        )

    @property
    def knots(self) -> tuple[float, ...]:
        """The knots of the extrapolated profile."""
        return self.profile.knots
