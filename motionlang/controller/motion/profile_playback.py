"""Following a ready-made profile: what suspends it is its own time, which runs slower and slower until it stands.

So an axis stays on its profile, and axes that play together stay together, however often they are suspended. A
spline goes on with the rest of its segment in a time of its own.
"""

from __future__ import annotations

from bisect import bisect_right

from motionlang.controller.faults import Refusal
from motionlang.controller.motion.halt import Stopping
from motionlang.controller.move import Action
from motionlang.planners import hold, plan_stop, plan_velocity
from motionlang.planners.curve import relabelled
from motionlang.planners.dwell import halted
from motionlang.planners.pvt.motion import pvt_segment
from motionlang.planners.reparametrised import Composed
from motionlang.planners.stop import running

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.controller.core import Core
    from motionlang.controller.moves.entries import Timed
    from motionlang.planners import Profile


class Played(Action):
    """A profile that is played; with `on_path` stop too comes to rest on it, in the axis's `suspend_time`.

    `ordered` are the points, velocities and times that it was made of, where it was made of such; `step` is the
    velocity at which a stepper starts and stops at once, 0.0 where there is no such step.
    """

    __slots__ = ("_is_paced", "on_path", "ordered", "step")
    keeps_rates = False

    def __init__(self, on_path: bool = False, step: float = 0.0) -> None:
        self.on_path, self.step = on_path, step
        # Whether the profile of the axis is one that is travelled at a pace, both of which it knows.
        self._is_paced = False
        self.ordered: Timed | None = None

    def suspend(self, controller: Core, a: Axis) -> bool:
        """Slow the profile's own time to a standstill within the axis's `suspend_time`."""
        path, pace = self._on_the_way(controller, a)
        if pace.end_velocity == 0.0:
            pace = halted(pace, "suspend")
        self._follow(controller, a, path, pace, "suspend", "")
        self._aim(a, path)
        return True

    def waiting(self, controller: Core, profile: Profile) -> Profile:
        """Begun while the axis is suspended: the profile, its time standing at its start."""
        return self._made(controller, profile, halted(hold(0.0).cut(0.0), "suspend"), "suspend")

    def plan(self, controller: Core, a: Axis) -> Profile:
        """The way on at full pace; on a path the rest of the segment first, in the axis's `suspend_time`."""
        path, place, rate = self.state(controller, a)
        if self.on_path and a.suspend_time > 0.0 and rate < 1.0 and place < path.knots[-1]:
            self._aim(a, path)
            return self._segment_in_time(controller, a, path, place)
        if a.suspend_time > 0.0 and rate < 1.0:
            change = 1.0 / a.suspend_time
            pace = plan_velocity("trapezoid", place, rate, 1.0, change, change)
            path = self._long_enough(a, path, pace.position(pace.knots[-2]))
            self._aim(a, path)
        else:
            pace = running(place, 1.0)
        return self._made(controller, path, _to_the_end(path, pace), path.shape)

    def stop(self, controller: Core, a: Axis, ended: str, hard: bool) -> bool:
        """Come to rest on the profile, the buffer emptied; False for a fault, and where it is no path."""
        if not self.on_path or ended == "fault":
            return False
        path, pace = self._on_the_way(controller, a)
        controller.empty(a, ended)
        self.ordered = None  # it will not come to its last point
        self._follow(controller, a, path, pace, path.shape, ended)
        move = a.move
        assert move is not None
        a.target = move.target = a.profiles[-1].end
        move.action = Stopping()
        return True

    def state(self, controller: Core, a: Axis) -> tuple[Profile, float, float]:
        """The profile, how far its time has come, and how fast that runs."""
        elapsed, last = controller.clock.now - a.starts[-1], a.profiles[-1]
        if self._is_paced and isinstance(last, Composed):
            return last.path, last.along.position(elapsed), last.along.velocity(elapsed)
        if not last.pieced:
            raise Refusal("moving", f"axis {a.index} follows a profile that cannot be suspended")
        return last.after(elapsed), 0.0, 1.0

    def shift(self, controller: Core, a: Axis, shift: float) -> None:
        """The same points have positions `shift` counts higher, and those that are past count no more."""
        last, elapsed = a.profiles[-1], controller.clock.now - a.starts[-1]
        if not self._is_paced and elapsed < last.duration:
            self._count_from_here(controller, a, last, elapsed)
        if self.ordered is not None:
            points, velocities, times = self.ordered
            self.ordered = [point + shift for point in points], velocities, times

    # -- inside

    def _segment_in_time(self, controller: Core, a: Axis, path: Profile, place: float) -> Profile:
        """The rest of the segment that holds `place` as one cubic of `suspend_time`, then the path as it was."""
        state = a.at(controller.clock.now)
        self._count_from_here(controller, a, path, place, a.suspend_time)
        end = path.knots[bisect_right(path.knots, place)]
        goal = path.at(end)
        first = pvt_segment(state.position, state.velocity, goal.position, goal.velocity, a.suspend_time)
        self._is_paced = False
        return relabelled(first, path.shape, "segment").then(path.after(end))

    def _count_from_here(
        self, controller: Core, a: Axis, path: Profile, place: float, time: float = 0.0
    ) -> None:
        """From now on its points are where the axis is, and those of the path after `place`, the next one in `time`.

        Without a time that is the one at which the path has it.
        """
        if self.ordered is None:
            return
        points, velocities, times = self.ordered
        state, following = a.at(controller.clock.now), bisect_right(path.knots, place)
        left = len(path.knots) - following
        self.ordered = (
            [state.position, *points[-left:]],
            [state.velocity, *velocities[-left:]],
            [time or path.knots[following] - place, *times[len(times) - left + 1 :]],
        )

    def _on_the_way(self, controller: Core, a: Axis) -> tuple[Profile, Profile]:
        """The profile, with what goes on behind it, and its time coming to rest, or to the end where nothing does."""
        path, place, rate = self.state(controller, a)
        pace = self._slowing(a, place, rate)
        path = self._long_enough(a, path, pace.end)
        return path, _to_the_end(path, pace) if pace.end > path.duration else pace

    def _long_enough(self, a: Axis, path: Profile, duration: float) -> Profile:
        """The profile, and behind it what the next entry of the buffer goes on with, as far as one does."""
        head = a.buffer[0] if a.buffer else None
        while path.duration < duration and head is not None and head.released and head.action is not None:
            more = head.action.prolong(path.end)
            if more is None:
                break
            path = path.then(more)
            self.ordered = None  # it goes on beyond its last point
        return path

    def _aim(self, a: Axis, path: Profile) -> None:
        if a.move is not None:
            a.target = a.move.target = path.end

    def _slowing(self, a: Axis, place: float, rate: float) -> Profile:
        """The time of the profile coming to rest."""
        if a.suspend_time <= 0.0 or rate <= 0.0:
            return hold(place).cut(0.0)
        return plan_stop("trapezoid", place, rate, 1.0 / a.suspend_time)

    def _follow(
        self, controller: Core, a: Axis, path: Profile, pace: Profile, shape: str, ended: str
    ) -> None:
        controller.continue_with(a, self._made(controller, path, pace, shape), ended)

    def _made(self, controller: Core, path: Profile, pace: Profile, shape: str) -> Profile:
        self._is_paced = True
        return Composed(pace, path, shape)


def _to_the_end(path: Profile, pace: Profile) -> Profile:
    """A time of the profile that passes its end, up to there: to the last bit, so that it ends where it should."""
    end = pace.crossing(path.duration)
    assert end is not None, "a pace above zero comes to every end"
    made = pace.cut(end)
    made.end = path.duration
    return made
