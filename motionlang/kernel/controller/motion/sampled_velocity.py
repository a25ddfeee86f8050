"""A velocity recomputed at every profiler tick, as for an analogue input.

Between two ticks the velocity changes linearly, within the rates of the axis. There are no ticks while the axis
is at standstill and is to stay there; the cause of the next motion calls `wake`.
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.io.samples import PERIOD
from motionlang.kernel.controller.io.sensor import next_tick
from motionlang.kernel.controller.motion.follow import FollowMove
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.controller.queue.life import append_profile, require_idle
from motionlang.kernel.controller.queue.plan import rates
from motionlang.kernel.controller.queue.stop import give_up
from motionlang.kernel.controller.queue.track import end_move, log_move
from motionlang.kernel.errors import Rejected
from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.curve import far_end
from motionlang.kernel.planners.dwell import rest


class SampledVelocity(Action):
    """The motion of an axis with a velocity function.

    `decide` returns the desired velocity, counts/s, and true if it may still change.
    """

    __slots__ = ("a", "awake", "decide", "move")

    exclusive = True
    keeps_rates = False

    def __init__(self, a: Axis, move: FollowMove, decide: Callable[[], tuple[float, bool]]) -> None:
        self.move = move
        move.action = self
        self.a, self.decide = a, decide
        self.awake = False

    def engage(self, a: Axis, profile: Profile) -> None:
        """Begin with a profile, or continue with it."""
        if a.move is not self.move:
            end_move(a, "retarget")
            log_move(a, self.move, profile)
            self.move.segments.clear()
        self.move.begin_new_entry(a.controller.log, a.clock.now)
        self.move.add(a.clock.now, profile)
        a.target = self.move.target = profile.end
        append_profile(a, profile, BY_DESIGN)

    def replan(self, a: Axis) -> None:
        self.engage(a, self.plan(a))

    @property
    def resting(self) -> bool:
        return not self.awake

    @property
    def holds(self) -> bool:
        """True while this motion controls the axis."""
        return self.a.move is self.move and self.move.action is self

    def wake(self) -> None:
        """Resume the ticks."""
        if self.holds and not self.awake:
            self.awake = True
            self._await()

    def suspend(self, a: Axis) -> bool:
        self.wake()
        return True

    def resume(self, a: Axis) -> None:
        self.wake()

    def _await(self) -> None:
        clock = self.a.clock
        clock.at(next_tick(clock.now), self._tick)

    def _tick(self) -> None:
        if not self.holds:
            return
        a = self.a
        wanted, lively = (0.0, False) if a.suspended else self.decide()
        velocity = a.velocity(self.a.clock.now)
        try:
            following = self._within(velocity, max(-a.max_speed, min(wanted, a.max_speed)))
        except Rejected as rejected:
            give_up(a, rejected)
            return
        if following != velocity or a.profiles[-1].end_velocity != following:
            here = a.position(self.a.clock.now)
            recipe = (velocity, PERIOD, 0.0, following, INFINITY, 0.0, following)
            end = far_end(here + 0.5 * (velocity + following) * PERIOD, following)
            self.engage(a, Profile(self.move.shape, here, end, INFINITY, recipe))
        self.awake = bool(following or wanted or velocity or lively)
        if self.awake:
            self._await()

    def _within(self, velocity: float, wanted: float) -> float:
        """Return the velocity one period later: the desired one, limited by the rates."""
        accel, decel = rates(self.a, self.a.speed)
        change = wanted - velocity
        rises = change * velocity >= 0.0
        most = (min(accel, self.a.max_accel) if rises else min(decel, self.a.max_decel)) * PERIOD
        return wanted if abs(change) <= most else velocity + (most if change > 0.0 else -most)


def track(
    a: Axis, decide: Callable[[], tuple[float, bool]], command: str = "", line: int = 0
) -> SampledVelocity:
    """Let a function set the velocity of an axis, counts/s, at every profiler tick."""
    require_idle(a, command)
    rates(a, a.speed)
    move = FollowMove(a.index, command, line, "track")
    made = SampledVelocity(a, move, decide)
    made.engage(a, rest("track", a.position(a.clock.now), INFINITY))
    made.wake()
    return made
