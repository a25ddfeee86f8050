"""Playback of a ready-made profile; a suspension slows its time to a standstill.

So an axis stays on its profile, and axes that play together stay together, however often they are suspended.
A spline that is resumed covers the rest of its segment in the axis's `suspend_time`.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.controller.queue.life import continue_with, empty, run_profile
from motionlang.kernel.controller.queue.stop import Stopping
from motionlang.kernel.controller.queue.track import end_move
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile, hold, plan_stop, plan_velocity
from motionlang.kernel.planners.curve import relabelled
from motionlang.kernel.planners.dwell import with_rest
from motionlang.kernel.planners.pvt.motion import plan_pvt
from motionlang.kernel.planners.reparametrised import Reparametrised
from motionlang.kernel.planners.stop import running

# Positions, velocities there, and the times from each to the next one.
Timed = tuple[Sequence[float], Sequence[float], Sequence[float]]


class Playback(Action):
    """The playback of a profile.

    With `on_path` a stop also comes to rest on it, in the axis's `suspend_time`. `ordered` are the points,
    velocities and times that it was made from, if any. `step` is the velocity at which a stepper starts and
    stops abruptly, 0.0 for none.
    """

    __slots__ = ("on_path", "ordered", "paced", "step")
    keeps_rates = False

    def __init__(self, on_path: bool = False, step: float = 0.0) -> None:
        self.on_path, self.step = on_path, step
        # While the rate varies: the profile, and its playback time over machine time.
        self.paced: tuple[Profile, Profile] | None = None
        self.ordered: Timed | None = None

    def suspend(self, a: Axis) -> bool:
        """Slow the playback to a standstill within the axis's `suspend_time`."""
        path, pace = self._with_continuation(a)
        if pace.end_velocity == 0.0:
            pace = with_rest(pace)
        self._follow(a, path, pace, "suspend", "")
        self._aim(a, path)
        return True

    def waiting(self, profile: Profile) -> Profile:
        """Return the profile with its playback at a standstill, for a suspended axis."""
        return self._made(profile, with_rest(hold(0.0).cut(0.0)), "suspend")

    def plan(self, a: Axis) -> Profile:
        """Return the rest of the profile at full rate.

        With `on_path` the rest of the segment comes first, in the axis's `suspend_time`.
        """
        path, along, rate = self.state(a)
        if self.on_path and a.suspend_time > 0.0 and rate < 1.0 and along < path.knots[-1]:
            self._aim(a, path)
            return self._segment_in_time(a, path, along)
        if a.suspend_time > 0.0 and rate < 1.0:
            change = 1.0 / a.suspend_time
            pace = plan_velocity("trapezoid", along, rate, 1.0, change, change)
            path = self._long_enough(a, path, pace.position(pace.knots[-2]))
            self._aim(a, path)
        else:
            pace = running(along, 1.0)
        return self._made(path, _to_the_end(path, pace), path.shape)

    def stops_itself(self, ended: str, hard: bool) -> bool:
        return self.on_path

    def stop(self, a: Axis, ended: str, hard: bool) -> None:
        """Come to rest on the profile and empty the buffer."""
        path, pace = self._with_continuation(a)
        empty(a, ended)
        self.ordered = None  # it will not reach its last point
        self._follow(a, path, pace, path.shape, ended)
        move = a.move
        assert move is not None
        a.target = move.target = a.profiles[-1].end
        move.action = _StoppingOnPath()

    def state(self, a: Axis) -> tuple[Profile, float, float]:
        """Return the profile, its playback time, and its playback rate."""
        elapsed = a.clock.now - a.starts[-1]
        if self.paced is None:
            return a.profiles[-1].after(elapsed), 0.0, 1.0
        path, pace = self.paced
        return path, pace.position(elapsed), pace.velocity(elapsed)

    def segments_left(self, a: Axis) -> int:
        """Return the number of segments after the present one."""
        path, time, _ = self.state(a)
        return len(path.knots) - 1 - bisect_right(path.knots, time)

    def next_segment_time(self, a: Axis) -> float:
        """Return when the next segment begins; INFINITY if it never does."""
        path, pace = self.paced or (a.profiles[-1], running(0.0, 1.0))
        following = bisect_right(path.knots, pace.position(a.clock.now - a.starts[-1]))
        moment = pace.crossing(path.knots[following]) if following < len(path.knots) else None
        return INFINITY if moment is None else a.starts[-1] + moment

    def shift(self, a: Axis, shift: float) -> None:
        """Shift positions by `shift` counts and drop the points that are past."""
        last, elapsed = a.profiles[-1], a.clock.now - a.starts[-1]
        if self.paced is not None:
            path, pace = self.paced
            self.paced = path.shifted(shift), pace.after(elapsed)
        elif elapsed < last.duration:
            self._count_from_here(a, last, elapsed)
        if self.ordered is not None:
            points, velocities, times = self.ordered
            self.ordered = [point + shift for point in points], velocities, times

    # -- inside

    def _segment_in_time(self, a: Axis, path: Profile, along: float) -> Profile:
        """Return the rest of the present segment as one cubic, then the path unchanged.

        The segment is the one that contains `along`; the cubic takes `suspend_time`.
        """
        state = a.at(a.clock.now)
        self._count_from_here(a, path, along, a.suspend_time)
        end = path.knots[bisect_right(path.knots, along)]
        goal = path.at(end)
        first = plan_pvt((state.position, goal.position), (state.velocity, goal.velocity), (a.suspend_time,))
        self.paced = None
        return relabelled(first, path.shape, "segment").then(path.after(end))

    def _count_from_here(self, a: Axis, path: Profile, along: float, time: float = 0.0) -> None:
        """Let the points begin at the axis, followed by those of the path after `along`.

        The next point comes after `time`, or if that is 0 at its time on the path.
        """
        if self.ordered is None:
            return
        points, velocities, times = self.ordered
        state, following = a.at(a.clock.now), bisect_right(path.knots, along)
        left = len(path.knots) - following
        self.ordered = (
            [state.position, *points[-left:]],
            [state.velocity, *velocities[-left:]],
            [time or path.knots[following] - along, *times[len(times) - left + 1 :]],
        )

    def _with_continuation(self, a: Axis) -> tuple[Profile, Profile]:
        """Return the profile with its continuation, and playback time over machine time.

        The playback comes to rest, or runs to the end of the profile if that comes first.
        """
        path, along, rate = self.state(a)
        pace = self._slowing(a, along, rate)
        path = self._long_enough(a, path, pace.end)
        return path, _to_the_end(path, pace) if pace.end > path.duration else pace

    def _long_enough(self, a: Axis, path: Profile, duration: float) -> Profile:
        """The profile followed by the continuation from the buffer, if there is one."""
        head = a.buffer[0] if a.buffer else None
        while path.duration < duration and head is not None and head.released and head.action is not None:
            more = head.action.prolong(path.end)
            if more is None:
                break
            path = path.then(more)
            self.ordered = None  # it continues beyond its last point
        return path

    def _aim(self, a: Axis, path: Profile) -> None:
        if a.move is not None:
            a.target = a.move.target = path.end

    def _slowing(self, a: Axis, along: float, rate: float) -> Profile:
        """Return a playback time, over machine time, that slows down to a standstill."""
        if a.suspend_time <= 0.0 or rate <= 0.0:
            return hold(along).cut(0.0)
        return plan_stop("trapezoid", along, rate, 1.0 / a.suspend_time)

    def _follow(self, a: Axis, path: Profile, pace: Profile, shape: str, ended: str) -> None:
        continue_with(a, self._made(path, pace, shape), ended)

    def _made(self, path: Profile, pace: Profile, shape: str) -> Profile:
        self.paced = path, pace
        return Reparametrised(pace, path, shape)


class _StoppingOnPath(Stopping):
    """Coming to rest on a profile that may exceed the rates of the axis, whichever stop follows."""

    __slots__ = ()
    keeps_rates = False

    def stops_itself(self, ended: str, hard: bool) -> bool:
        return True


def _to_the_end(path: Profile, pace: Profile) -> Profile:
    """Return a playback time that ends exactly at the end of the profile.

    Rounding must not make it end before or after.
    """
    end = pace.crossing(path.duration)
    assert end is not None, "a playback rate above zero reaches every end"
    made = pace.cut(end)
    made.end = path.duration
    return made


def play(
    a: Axis,
    profile: Profile,
    command: str = "",
    line: int = 0,
    on_path: bool = False,
    step: float = 0.0,
) -> None:
    """Play a profile that begins at the axis's position.

    With `on_path`, a stop comes to rest on the profile. `step` is the velocity, counts/s, at which a stepper starts and
    stops abruptly; above it the rates of the axis apply.
    """
    move = LoggedMove(a.index, command, line, profile.end)
    move.action = playback = Playback(on_path, step)
    end_move(a, "retarget")
    profile = playback.waiting(profile) if a.suspended else profile
    run_profile(a, move, profile, BY_DESIGN if step else "")
