"""Running along paths: one speed for several axes, and one run through paths that join smoothly.

The run knows the path it is on and those ahead that it may enter without coming to rest. It plans the speed over all
of them, hands each axis its curve travelled at that speed, and has one event, for the end of the path it is on.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.controller.faults import Refusal
from motionlang.controller.moves.buffer import motions, reach
from motionlang.controller.moves.geometry import corner
from motionlang.controller.triggers.conditions import release
from motionlang.profile import Profile, hold
from motionlang.profile.composed import travelled
from motionlang.profile.halted import halted
from motionlang.profile.lookahead import plan_course
from motionlang.profile.relief import onset, stop_under_way
from motionlang.profile.summed import added
from motionlang.profile.total import total

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.controller.axis import Axis
    from motionlang.controller.clock import Event
    from motionlang.controller.core import Core
    from motionlang.controller.moves.geometry import Segment
    from motionlang.controller.moves.path import PathMove
    from motionlang.profile.lookahead import Pace

# What a path may overshoot its end by, as a part of its length, before it counts as overshooting.
_SLACK = 1e-9


class PathRun:
    """A run along `here`, a path laid out as `segment`, and the paths `ahead`.

    `profile` is the distance along `segment` over the time since `began`; distances beyond its length are those of
    the paths ahead. It was planned to the end of the path `goal` (None: to rest wherever that is); times and distances
    are rounded on the way there, and tell neither which path has ended nor whether it was the last one. `tails` is what
    the axes still have to do of a path that this one was blended into.
    """

    __slots__ = (
        "_blend_event",
        "_controller",
        "_event",
        "_over",
        "ahead",
        "axes",
        "began",
        "ended",
        "goal",
        "hard",
        "here",
        "profile",
        "segment",
        "tail_began",
        "tails",
    )

    def __init__(self, controller: Core, here: PathMove, starts: Sequence[float]) -> None:
        self._controller, self.here, self.axes = controller, here, here.axes
        self.segment = here.lay(starts)
        self.ahead: list[tuple[PathMove, Segment]] = []
        self.profile: Profile = hold(0.0)
        self.goal: PathMove | None = here
        self.began = 0.0
        self.ended = ""
        self.hard = False
        self._event: Event | None = None
        self._blend_event: Event | None = None
        self._over = False
        self.tails: list[Profile] = []
        self.tail_began = 0.0

    # -------------------------------------------------------------------------------------------- from outside

    def plan(self) -> None:
        """Make ready to begin, at rest on the path."""
        if self.here.guide is not None:
            self.here.guide.starts()
        try:
            self._look_ahead()
            self._adopt(0.0)
        except Refusal as refusal:
            refusal.line = self.here.moves[0].line
            raise

    def start(self) -> None:
        """Begin."""
        self._enter()

    def replan(self) -> None:
        """Go on with the settings as they are now; a change that would overshoot comes too late."""
        if self._over or self.ended:
            return
        planned = self._planned(self._elapsed())
        if planned is not None:
            self._change(*planned)

    def more(self) -> None:
        """Something further was released: it may prolong the run, or be blended into."""
        if self._over or self.ended or self._suspended():
            return
        known = len(self.ahead)
        self._look_ahead()
        if len(self.ahead) > known:
            self.replan()
        self._plan_blend()

    def stop(self, a: Axis, ended: str, hard: bool) -> None:
        """Come to rest on the path; the buffer of `a` is emptied.

        Whichever axis is stopped, the rates are the first one's: DECEL as the path has it, ERRORDECEL for a hard stop.
        """
        controller = self._controller
        for each in self.axes:
            release(each)
        controller.empty(a, ended)
        if self.here.guide is not None:
            self.here.guide.stops()
        if self.ended and not (hard and (ended == "fault" or not self.hard)):
            return
        decel = None
        if hard:
            decel = self.axes[0].error_decel / abs(self.here.scales[0])
        self.ended, self.hard = ended, hard
        self._cancel_blend()
        profile = self._braking(self._elapsed(), decel)
        if profile is None:
            rest = self.profile.after(self._elapsed())
            # What was to stand at the end until it is resumed ends there.
            self._change(rest if rest.duration < INFINITY else rest.cut(rest.knots[-2]), self.goal)
        else:
            self._change(profile, None)
        self._aim()

    def suspend(self) -> None:
        """Come to rest on the path, and keep it."""
        if self.ended:
            return
        self._cancel_blend()
        profile = self._braking(self._elapsed())
        if profile is not None:
            self._change(halted(profile, "suspend"), None)

    def resume(self) -> None:
        """Go on."""
        self.replan()
        self.more()

    def abandon(self, leaving: Axis, ended: str) -> None:
        """One axis is held where it is, so all are."""
        if self._over:
            return
        self._over = True
        self._cancel()
        self._left(False)
        for a in self.axes:
            if a is not leaving:
                self._controller.freeze(a, ended)

    def shift(self, a: Axis, by: float) -> None:
        """An axis counts from another zero, `by` counts higher: the paths stay where they are."""
        k = self.axes.index(a)
        for segment in (self.segment, *(each for _, each in self.ahead)):
            segment.shift(k, by)
        for move in motions(a):
            move.action.geometry.shift(k, by)  # type: ignore[union-attr]
            move.target += by

    def blend(self) -> None:
        """Begin the next path now, on top of what remains of this one."""
        following = self._following()
        if self._over or self.ended or following is None or self._suspended():
            return
        controller, now = self._controller, self._controller.clock.now
        successor = PathRun(controller, following, self.segment.ends)
        successor.plan()
        self._cancel()
        self._over = True
        for a, move, end in zip(self.axes, following.moves, self.segment.ends, strict=True):
            rest = a.profiles[-1].after(now - a.starts[-1])
            successor.tails.append(rest.shifted(-end))
            a.move = None
            reach(controller, a, move)
        successor.tail_began = now
        successor.start()

    @property
    def speed(self) -> float:
        """The speed along the path now, user units/s."""
        return self.profile.velocity(self._elapsed())

    @property
    def remaining(self) -> float:
        """The distance along the present path still to go, user units."""
        return max(0.0, self.segment.length - self.profile.position(self._elapsed()))

    # ------------------------------------------------------------------------------------------------ planning

    def _elapsed(self) -> float:
        """The time since the present profile began."""
        return self._controller.clock.now - self.began

    def _suspended(self) -> bool:
        return any(a.suspended for a in self.axes)

    def _look_ahead(self) -> None:
        """Lay out the paths of the buffers that can be entered without coming to rest."""
        if not self.here.may_join or self.ended:
            return
        before = self.ahead[-1] if self.ahead else (self.here, self.segment)
        entries = motions(self.axes[0])
        while len(entries) > len(self.ahead):
            action = entries[len(self.ahead)].action
            if not _continues(action, self.axes, len(self.ahead)):
                return
            segment = action.lay(before[1].ends)  # type: ignore[union-attr]
            if not before[0].joins(before[1], action, segment):  # type: ignore[arg-type]
                return
            before = (action, segment)  # type: ignore[assignment]
            self.ahead.append(before)

    @property
    def stops_at_corner(self) -> bool:
        """Whether it comes to rest at the end of this path only because of the angle to the next."""
        following, master = self._following(), self.axes[0]
        if following is None or not master.contour_mode or self.ended or self.ahead:
            return False
        segment = following.lay(self.segment.ends)
        return bool(segment.length) and corner(self.segment, segment) > master.contour_angle

    def _adopt(self, time: float) -> None:
        """Plan afresh from what the present profile does at `time`; without room for that it goes on as it is."""
        rest = self.profile.after(time)
        self.profile = rest.shifted(-rest.start)
        planned = self._planned(0.0)
        if planned is not None:
            self.profile, self.goal = planned

    def _planned(self, time: float) -> tuple[Profile, PathMove | None] | None:
        """From what the present profile does at `time` to rest at the end of the paths, and the last of them.

        None where there is no room left to come to rest there. What is coming to rest already, with an acceleration
        that can only be taken back at rest, goes on from there.
        """
        pace = self.here.pace(self._controller, self.segment)
        if self._suspended() or not pace.speed:
            stop = self._braking(time)
            return None if stop is None else (halted(stop, "suspend"), None)
        if not self.segment.length:
            return hold(0.0).cut(0.0), self.here
        stretches, goal = self._stretches(pace)
        eased, place, speed, bent = onset(self.profile, time, pace.shape, pace.accel_jerk)
        try:
            profile = plan_course(stretches, place, max(speed, 0.0), bent)
        except ValueError as problem:
            raise Refusal("range", f"axis {self.axes[0].index} cannot move: {problem}") from None
        if profile is None:
            return self._from_rest(time, stretches, goal)
        return profile if eased is None else eased.then(profile), goal

    def _from_rest(
        self, time: float, stretches: list[tuple[float, Pace]], goal: PathMove
    ) -> tuple[Profile, PathMove | None] | None:
        """The same after the rest that a stop leads to within the paths; None where none does."""
        still = self.profile.velocity_crossing(0.0, time)
        if self.goal is not None or still is None or still == INFINITY:
            return None
        profile = plan_course(stretches, self.profile.position(still), 0.0)
        return None if profile is None else (self.profile.cut(still).after(time).then(profile), goal)

    def _stretches(self, pace: Pace) -> tuple[list[tuple[float, Pace]], PathMove]:
        """Length and pace of what is run as one, up to a path that may not move now; and the last path of it."""
        stretches, goal = [(self.segment.length, pace)], self.here
        for action, segment in self.ahead:
            following = action.pace(self._controller, segment)
            if not following.speed:
                break
            length, before = stretches[-1]
            if before.key() == following.key():
                stretches[-1] = (length + segment.length, before)
            else:
                stretches.append((segment.length, following))
            goal = action
        return stretches, goal

    def _braking(self, time: float, decel: float | None = None, first: int = 0) -> Profile | None:
        """To rest from what the present profile does at `time`, at `decel` or as hard as the paths it takes allow.

        The profile is on path number `first` then. A stop that would come into a path ahead faster than that allows
        begins there, since the present plan brakes harder before it. None where the paths end before, which the run
        brakes for by itself.
        """
        if self.profile.velocity(time) <= 0.0:
            return hold(self.profile.position(time)).cut(0.0)
        paths = [(self.here, self.segment), *self.ahead]
        room, most = total(segment.length for _, segment in paths[:first]), INFINITY
        for k, (action, segment) in enumerate(paths[first:], first):
            pace = action.pace(self._controller, segment)
            place, room, most = room, room + segment.length, min(most, pace.decel)
            rates = decel or most, pace.ramp, pace.accel_jerk, pace.decel_jerk
            try:
                stop = stop_under_way(self.profile, time, pace.shape, *rates)
            except ValueError as problem:
                raise Refusal("range", f"axis {self.axes[0].index} cannot stop: {problem}") from None
            if k > first and _speed_at(stop, place) > pace.speed * (1.0 + _SLACK):
                due = self.profile.crossing(place, time)
                if due is not None and _speed_at(stop, place) > self.profile.velocity(due) * (1.0 + _SLACK):
                    later = self._braking(due, decel, k)
                    return None if later is None else self.profile.cut(due).after(time).then(later)
            if stop.extrema()[1] <= room:
                return stop
        return None

    # ----------------------------------------------------------------------------------------------- following

    def _enter(self) -> None:
        """Let every axis follow its curve of the path just reached."""
        controller = self._controller
        self.here.run = self
        self.began = controller.clock.now
        if self.here.guide is not None:
            self.here.guide.begins()
        part = self._part()
        with controller.together():
            for k, (a, move) in enumerate(zip(self.axes, self.here.moves, strict=True)):
                move.target = self.segment.ends[k]
                move.ended = self.ended
                controller.log_move(a, move, self._of(k, part))
                controller.extend_track(a, self._total(k, part))
            self._await(part)
        if self.ended:
            self._aim()

    def _aim(self) -> None:
        """What stops on a guided path is on its way to where it will rest: what is described next counts from there."""
        if self.here.guide is None or self._over:
            return
        place = self.profile.end
        for segment in (self.segment, *(each for _, each in self.ahead)):
            if place <= segment.length * (1.0 + _SLACK):
                break
            place -= segment.length
        for a, curve in zip(self.axes, segment.curves, strict=True):
            a.target = curve.position(min(place, segment.length))

    def _change(self, profile: Profile, goal: PathMove | None) -> None:
        """Follow another profile along the path from now on."""
        controller = self._controller
        self.profile, self.goal, self.began = profile, goal, controller.clock.now
        part = self._part()
        with controller.together():
            for k, a in enumerate(self.axes):
                controller.amend_log(a, self._of(k, part), self.ended)
                controller.extend_track(a, self._total(k, part))
            self._await(part)

    def _leads_on(self) -> bool:
        """Whether the profile goes beyond the end of this path."""
        if self.goal is not None:
            return self.here is not self.goal
        return bool(self.ahead) and self.profile.end > self.segment.length * (1.0 + _SLACK)

    def _part(self) -> Profile:
        """The profile up to the end of this path."""
        if not self._leads_on():
            return self.profile
        time = self.profile.crossing(self.segment.length)
        return self.profile if time is None else self.profile.cut(time)

    def _of(self, k: int, part: Profile) -> Profile:
        """The motion of axis number k on its curve."""
        if not self.segment.length:
            return hold(self.segment.ends[k]).cut(0.0)
        made = travelled(part, self.segment.curves[k])
        if self.segment.starts is not None and part.start == 0.0:
            made.start = self.segment.starts[k]
        arrives = self.goal is not None or part.end >= self.segment.length * (1.0 - 1e-12)
        if arrives and part.duration < INFINITY:
            made.end = self.segment.ends[k]
        return made

    def _total(self, k: int, part: Profile) -> Profile:
        """The same with what the axis still has to do of the path before."""
        made, elapsed = self._of(k, part), self._controller.clock.now - self.tail_began
        if not self.tails or elapsed >= self.tails[k].duration:
            return made
        both = added(made, self.tails[k].after(elapsed), "blend")
        if not made.end_velocity:
            both.end = made.end
        return both

    def _await(self, part: Profile) -> None:
        if self._event is not None:
            self._event.cancel()
        end = self.began + part.duration
        if self.tails and not self.ahead:
            end = max(end, self.tail_began + max(tail.duration for tail in self.tails))
        self._event = self._controller.clock.at(end, self._reached) if end < INFINITY else None
        self._plan_blend()

    def _reached(self) -> None:
        """The end of this path, or of the run."""
        self._event = None
        if self._leads_on():
            self._go_on(self.profile.after(self._elapsed()))
        else:
            self._finish()

    def _left(self, whole: bool) -> None:
        """The path is under way no more."""
        if self.here.guide is not None:
            self.here.guide.ends(whole)

    def _go_on(self, rest: Profile) -> None:
        """Enter the next path without coming to rest, on the rest of the profile."""
        controller = self._controller
        self._left(True)
        for a in self.axes:
            a.move = None
        self.here.run = None
        self.here, self.segment = self.ahead.pop(0)
        for a, move in zip(self.axes, self.here.moves, strict=True):
            if move in a.buffer:
                reach(controller, a, move)
        known = len(self.ahead)
        self._look_ahead()
        self.profile = rest.shifted(-rest.start)
        if len(self.ahead) > known:
            self._adopt(0.0)
        self._enter()

    def _finish(self) -> None:
        """All axes are at rest at their ends, or where they were stopped."""
        controller = self._controller
        self._over = True
        self._cancel()
        self._left(self.profile.end >= self.segment.length * (1.0 - _SLACK))
        for a, move in zip(self.axes, self.here.moves, strict=True):
            end = a.profiles[-1].end
            a.move = None
            a.target = move.target = end
            controller.extend_track(a, hold(end))
        for a in self.axes:
            controller.start_next(a)
        for a in self.axes:
            if a.move is None:
                controller.tell("idle", a.index)

    def _cancel(self) -> None:
        if self._event is not None:
            self._event.cancel()
        self._cancel_blend()

    # ------------------------------------------------------------------------------------------------ blending

    def _following(self) -> PathMove | None:
        """The path that this one can be blended into."""
        entries = motions(self.axes[0])
        action = entries[0].action if entries else None
        return action if _continues(action, self.axes, 0) else None  # type: ignore[return-value]

    def _plan_blend(self) -> None:
        """Set the event of the blend, at its distance before the end, or now where that is past."""
        self._cancel_blend()
        master, clock = self.axes[0], self._controller.clock
        if (
            not master.blend_mode
            or self.ended
            or self._over
            or self._suspended()
            or self._following() is None
        ):
            return
        place = max(self.segment.length - master.blend_distance, self.profile.start)
        elapsed = self._elapsed()
        time = elapsed if self.profile.position(elapsed) >= place else self.profile.crossing(place, elapsed)
        if time is not None:
            self._blend_event = clock.at(self.began + time, self.blend)

    def _cancel_blend(self) -> None:
        if self._blend_event is not None:
            self._blend_event.cancel()
            self._blend_event = None


def _speed_at(profile: Profile, place: float) -> float:
    """The speed with which a profile passes a place; 0 where it does not come to it."""
    time = profile.crossing(place)
    return 0.0 if time is None else profile.velocity(time)


def _continues(action: object, axes: tuple[Axis, ...], place: int) -> bool:
    """Whether an entry of the buffer is a path of the same axes, released, and next on all of them."""
    return getattr(action, "axes", None) == axes and action.stands_at(place)  # type: ignore[attr-defined]
