"""A course: the path in progress and the paths that it enters without a stop.

A course plans the distance along its paths over time and derives the motion of each axis. It schedules no
event and moves no axis: `path_run.PathRun` does that.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import too_late
from motionlang.kernel.controller.moves.geometry import PathSegment, corner
from motionlang.kernel.controller.queue.buffer import motion_at
from motionlang.kernel.errors import Rejected
from motionlang.kernel.planners import MotionState, Profile, hold
from motionlang.kernel.planners.curve import relabelled
from motionlang.kernel.planners.dwell import with_rest
from motionlang.kernel.planners.lookahead import PathPace, plan_course
from motionlang.kernel.planners.ramp_down import onset, stop_in_motion
from motionlang.kernel.planners.reparametrised import travelled
from motionlang.kernel.tools import total

if TYPE_CHECKING:
    from motionlang.kernel.controller.moves.path import PathMove

# How far a path may overshoot its end, as a fraction of its length, before it counts as overshooting.
SLACK = 1e-9


class Course:
    """The path in progress, `here`, laid out as `segment`, and the paths `ahead`.

    `profile` is the distance along `segment` over the time since `began`; distances beyond its length are on the
    paths ahead. It was planned to the end of the path `goal` (None: to rest anywhere). Times and distances are
    rounded in between, so they cannot decide which path has ended or whether it was the last one. `present` is the
    profile up to the end of `here`, which comes at the time `end_time`.

    `planned_at` is when its profile was last planned: settings that do not act at once have no effect until the next
    plan. `is_stopping` is set once it only has to come to rest.
    """

    def __init__(self, here: PathMove, starts: Sequence[float]) -> None:
        self.here, self.axes, self._clock = here, here.axes, here.axes[0].clock
        self.segment = here.lay(starts)
        self.ahead: list[tuple[PathMove, PathSegment]] = []
        self.profile: Profile = hold(0.0)
        self.present = self.profile
        self.goal: PathMove | None = here
        self.began = self.planned_at = 0.0
        self.is_stopping = False
        self.rates = (0.0, 0.0)  # those of its last plan, user units

    # ----------------------------------------------------------------------------------------------- reading

    @property
    def elapsed(self) -> float:
        """The time since the present profile began."""
        return self._clock.now - self.began

    @property
    def end_time(self) -> float:
        """The end time of the present path if nothing changes; infinite while suspended."""
        return self.began + self.present.duration

    @property
    def speed(self) -> float:
        """The speed along the path now, user units/s."""
        return self.profile.velocity(self.elapsed)

    @property
    def remaining(self) -> float:
        """The remaining distance along the present path, user units."""
        return max(0.0, self.segment.length - self.profile.position(self.elapsed))

    @property
    def is_suspended(self) -> bool:
        """True while any of its axes is suspended."""
        return any(a.suspended for a in self.axes)

    @property
    def leads_on(self) -> bool:
        """True if the profile continues beyond the end of this path."""
        if self.goal is not None:
            return self.here is not self.goal
        return bool(self.ahead) and self.profile.end > self.segment.length * (1.0 + SLACK)

    def following(self) -> PathMove | None:
        """The next path, if it has the same axes, is released and is next on all of them."""
        entry = motion_at(self.axes[0], 0)
        action = None if entry is None else entry.action
        return action if _continues(action, self.axes, 0) else None  # type: ignore[return-value]

    @property
    def stops_at_corner(self) -> bool:
        """True if only the angle to the next path makes it stop at the end of this one."""
        following, master = self.following(), self.axes[0]
        if following is None or not master.contour_mode or self.ahead:
            return False
        segment = following.lay(self.segment.ends)
        return bool(segment.length) and corner(self.segment, segment) > master.contour_angle

    def of(self, k: int) -> Profile:
        """Return the motion of axis index k on this path, from the time `began`."""
        end = self.segment.ends[k]
        present = self.present
        if not self.segment.length:  # it takes no time, unless it is suspended
            return relabelled(hold(end).cut(present.duration), present.shape)
        made = travelled(present, self.segment.curves[k])
        if self.segment.starts is not None and present.start == 0.0:
            made.start = self.segment.starts[k]
        arrives = self.goal is not None or present.end >= self.segment.length * (1.0 - 1e-12)
        if arrives and present.duration < INFINITY:
            made.end = end
        return made

    def positions_at_rest(self) -> list[float]:
        """Return the positions of its axes once it is at rest."""
        count, distance = self._rest(self.profile)
        segment = self.ahead[count - 1][1] if count else self.segment
        if not segment.length or distance >= segment.length * (1.0 - 1e-12):
            return list(segment.ends)
        return [curve.position(distance) for curve in segment.curves]

    def reached(self, stop: Profile | None) -> int:
        """Return how many of the paths ahead a stop enters; None is the present plan."""
        return self._rest(stop or self.profile)[0]

    def _rest(self, profile: Profile) -> tuple[int, float]:
        """Return how many of the paths ahead a profile enters, and the distance on the last path to rest."""
        distance = profile.end
        segments = [self.segment, *(each for _, each in self.ahead)]
        for count, segment in enumerate(segments[:-1]):
            if distance <= segment.length * (1.0 + SLACK):
                return count, distance
            distance -= segment.length
        return len(self.ahead), distance

    # -------------------------------------------------------------------------------------------- execution

    def change(self, profile: Profile, goal: PathMove | None) -> None:
        """Adopt a profile that has just been planned."""
        self.planned_at = self._clock.now
        self.follow(profile, goal)

    def follow(self, profile: Profile, goal: PathMove | None) -> None:
        """Adopt another profile, or the rest of the present one, from now on."""
        self.profile, self.goal, self.began = profile, goal, self._clock.now
        self.present = self.profile
        if self.leads_on:
            time = profile.crossing(self.segment.length)
            self.present = profile if time is None else profile.cut(time)

    def leave(self, whole: bool) -> None:
        """Leave the path; `whole` is true if its end has been reached."""
        if self.here.policy is not None:
            self.here.policy.ends(whole)

    def cut_log(self) -> None:
        """Close the log entries of the present path now."""
        now = self._clock.now
        for move in self.here.moves:
            move.profile = move.until(now)

    def begin_next(self) -> None:
        """Enter the next path."""
        self.here, self.segment = self.ahead.pop(0)

    def go_on(self, rest: Profile) -> None:
        """Run the path just reached on `rest`, the rest of the profile.

        Paths released since the last plan cause a new one.
        """
        known = len(self.ahead)
        self.look_ahead()
        self.profile = rest.shifted(-rest.start)
        if len(self.ahead) > known:
            self.plan_afresh()

    def shift(self, k: int, by: float) -> None:
        """Shift positions of axis index k by `by` counts for a new zero, without motion."""
        for segment in (self.segment, *(each for _, each in self.ahead)):
            segment.shift(k, by)

    # ------------------------------------------------------------------------------------------------ planning

    def look_ahead(self) -> None:
        """Lay out the paths of the buffers that can be entered without a stop."""
        if not self.here.may_join or self.is_stopping:
            return
        before = self.ahead[-1] if self.ahead else (self.here, self.segment)
        while (entry := motion_at(self.axes[0], index := len(self.ahead))) is not None:
            action = entry.action
            if not _continues(action, self.axes, index):
                return
            segment = action.lay(before[1].ends)  # type: ignore[union-attr]
            if not before[0].joins(before[1], action, segment):  # type: ignore[arg-type]
                return
            before = (action, segment)  # type: ignore[assignment]
            self.ahead.append(before)

    def plan_afresh(self) -> None:
        """Plan again from the start of the profile; a no-op if the distance is too short."""
        planned = self.planned(0.0)
        if planned is not None:
            self.profile, self.goal = planned
            self.planned_at = self._clock.now

    def planned(self, time: float) -> tuple[Profile, PathMove | None] | None:
        """Return a profile from the state at `time` to rest, and the last path it reaches.

        None if the distance does not suffice to stop there. If a ramp to rest can reduce its acceleration to zero only
        at rest, the profile completes that ramp and continues from rest.
        """
        pace = self.here.pace(self.segment)
        if self.is_suspended or not pace.speed:
            stop = self.with_standstill(time)
            return None if stop is None else (stop, None)
        if not self.segment.length:
            return relabelled(hold(0.0).cut(0.0), pace.shape), self.here
        stretches, goal = self._stretches(pace)
        eased, distance, speed, acceleration = onset(self.profile, time, pace.shape, pace.accel_jerk)
        try:
            profile = plan_course(stretches, distance, max(speed, 0.0), acceleration)
        except ValueError as problem:
            raise Rejected("range", f"axis {self.axes[0].index} cannot move: {problem}") from None
        if profile is None:
            return self._from_rest(time, stretches, goal)
        self.rates = pace.accel, pace.decel
        return profile if eased is None else eased.then(profile), goal

    def report_late_rates(self) -> None:
        """Log rates of the settings with which the course could not stop at its end."""
        pace, k, leader = (
            self.here.pace(self.segment),
            abs(self.here.scales[0]),
            self.here.moves[0],
        )
        if pace.speed and (pace.accel, pace.decel) != self.rates:
            written, in_force = (pace.accel * k, pace.decel * k), (self.rates[0] * k, self.rates[1] * k)
            too_late(self.axes[0], leader, int(written[1] != in_force[1]), written, in_force)

    def _from_rest(
        self, time: float, stretches: list[tuple[float, PathPace]], goal: PathMove
    ) -> tuple[Profile, PathMove | None] | None:
        """Complete the present ramp to rest, and plan from there.

        None if it does not come to rest within the paths, or leads to a path's end.
        """
        still = self.profile.velocity_crossing(0.0, time)
        if self.goal is not None or still is None or still == INFINITY:
            return None
        profile = plan_course(stretches, self.profile.position(still), 0.0)
        return None if profile is None else (self.profile.cut(still).after(time).then(profile), goal)

    def _stretches(self, pace: PathPace) -> tuple[list[tuple[float, PathPace]], PathMove]:
        """Return the (length, pace) of each run of paths of equal pace, and the last path.

        They end before a path that may not move now.
        """
        stretches, goal = [(self.segment.length, pace)], self.here
        for action, segment in self.ahead:
            following = action.pace(segment)
            if not following.speed:
                break
            length, before = stretches[-1]
            if before.key() == following.key():
                stretches[-1] = (length + segment.length, before)
            else:
                stretches.append((segment.length, following))
            goal = action
        return stretches, goal

    def stopped(self, decel: float | None, beyond: bool = False) -> Profile | None:
        """Return the earliest possible stop, by `braking`; None to keep the present plan."""
        profile = self.braking(self.elapsed, decel, beyond)
        if profile is None and self.profile.duration == INFINITY:
            # A profile that rested at its end until it is resumed ends there.
            rest = self.profile.after(self.elapsed)
            profile = rest.cut(rest.knots[-2])
        return profile

    def with_standstill(self, time: float) -> Profile | None:
        """Return a stop from the state at `time`, then rest; None if the paths end first."""
        profile = self.braking(time)
        return None if profile is None else with_rest(profile)

    def braking(
        self, time: float, decel: float | None = None, beyond: bool = False, first: int = 0
    ) -> Profile | None:
        """Return a stop from the state at `time`, at `decel` or at the rates of its paths.

        The limits of the axes apply to both, unless it goes `beyond` them, as in a fault. At `time` the course is on
        path number `first`. A stop that would enter a path ahead faster than allowed is delayed to the start of that
        path, since the present plan brakes harder before it. None if the paths end before rest: the course then
        comes to rest at their end as planned.
        """
        if self.profile.velocity(time) <= 0.0:
            return hold(self.profile.position(time)).cut(0.0)
        paths = [(self.here, self.segment), *self.ahead]
        room, most = total(segment.length for _, segment in paths[:first]), INFINITY
        for k, (action, segment) in enumerate(paths[first:], first):
            pace = action.pace(segment)
            limit = pace.decel if decel is None else INFINITY if beyond else action.max_decel(segment)
            distance, room, most = room, room + segment.length, min(most, limit)
            jerk = max(pace.decel_jerk, _least_jerk(self.profile.at(time)))
            rates = min(decel or most, most), pace.ramp, pace.accel_jerk, jerk
            try:
                stop = stop_in_motion(self.profile, time, pace.shape, *rates)
            except ValueError as problem:
                raise Rejected("range", f"axis {self.axes[0].index} cannot stop: {problem}") from None
            if k > first and _speed_at(stop, distance) > pace.speed * (1.0 + SLACK):
                time_at = self.profile.crossing(distance, time)
                if time_at is not None and _speed_at(stop, distance) > self.profile.velocity(time_at) * (
                    1.0 + SLACK
                ):
                    later = self.braking(time_at, decel, beyond, k)
                    return None if later is None else self.profile.cut(time_at).after(time).then(later)
            if stop.extrema()[1] <= room:
                return stop
        return None


def _least_jerk(state: MotionState) -> float:
    """Return the least jerk that ends a deceleration before the velocity is zero.

    With a lower one, as set during the stop, the axis would run back along the path: J = A²/(2 V).
    """
    if state.acceleration >= 0.0:
        return 0.0
    return 0.5 * state.acceleration * state.acceleration / state.velocity


def _speed_at(profile: Profile, distance: float) -> float:
    """Return a profile's speed at a position; 0 if it does not reach it."""
    time = profile.crossing(distance)
    return 0.0 if time is None else profile.velocity(time)


def _continues(action: object, axes: tuple[Axis, ...], index: int) -> bool:
    """True if a buffer entry is a released path of the same axes, next on all of them."""
    return getattr(action, "axes", None) == axes and action.is_next_at(index)  # type: ignore[attr-defined]
