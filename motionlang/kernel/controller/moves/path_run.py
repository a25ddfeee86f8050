r"""Running along paths: several axes on one path after another, joined or blended.

Problem. The axes of a path stay on one line or arc, while the program sets the speed along it. Between two
paths the axes come to rest, run through the corner (contour mode), or blend: the next path begins while the
one before still has a distance to go. A stop, a suspension or another speed must change all axes at the same
time, and the log must record how far each path was run.

Idea. One profile is planned for the distance along the path; axis k is at curve[k](distance(t)). A `Course`
(`course.py`) is the path in progress, the paths ahead that it runs into without coming to rest, and that
profile. A run has one course. It has two while a path is blended into the next, and each axis then adds up
both.

    speed      course 1          course 2
             _____________     _____________
            /             \   /             \
           /               \ /               \       in between, each axis adds both
          /                 X                 \
         /                 / \                 \
        ──────────────────|───|────────────────── time
                      blend   end of course 1

Data. `courses` has the oldest first. Lengths and speeds along a path are in user units, positions of axes in
counts. A path has an entry in the log for each axis, which its course extends and closes. There are two
events: the next end of a course (`_event`) and the next blend (`_blend_event`).

Life of a run. `start` enters the first course. At the end of a path its course enters the next one on the
rest of the same profile (`_go_on`), or is over. When all courses are over, the axes are at rest and each
takes the next move of its buffer (`_finish`). Changes arrive through `replan`, `more`, `stop`, `suspend` and
`resume`. They plan new profiles for the courses in progress, and `_change` puts all of them in force. `blend`
begins the next path now.

Invariants.
- All axes of a run get their new profiles at the same time, and limits are checked when all have theirs
  (`together`).
- At most two courses overlap. A blend that is due earlier waits for the end of the one before.
- BLENDDISTANCE is limited to `MAX_SHARE` of a path; an explicit `blend` takes effect at any distance.
- A course that runs through corners rejects `blend`.
- A course begins where the one before it ends. If a stop cuts the first one short, the second is moved back
  by the missing distance (`_join`). So the last entry of the log ends where the axis comes to rest.
- If new settings leave too little distance to stop at the end, the course continues as planned.

Cost. A change plans each course again over all its paths ahead, linear in their number, and makes one profile
for each axis. Entering a path plans again only if further paths have been released. Nothing is sampled.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY, TimedCall
from motionlang.kernel.controller.events import BY_DESIGN, clamped_blend
from motionlang.kernel.controller.moves.course import SLACK, Course
from motionlang.kernel.controller.queue.buffer import motions, reach
from motionlang.kernel.controller.queue.life import empty, start_waiting
from motionlang.kernel.controller.queue.stop import freeze, release
from motionlang.kernel.controller.queue.track import amend_log, extend_track, log_dropped, log_move
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile, hold
from motionlang.kernel.planners.superposition import added

if TYPE_CHECKING:
    from motionlang.kernel.controller.moves.path import PathMove

    # A course, its new profile, and the path at whose end that comes to rest, if any.
    Plan = tuple[Course, Profile, PathMove | None]

# The largest share of a path that is blended into the next one. The rest is left for the path before it.
MAX_SHARE = 0.5


class PathRun:
    """A run of `axes` along paths, from rest to rest.

    `ended` is the cause of an early end; `hard` is true if a hard stop ended it.
    """

    def __init__(self, first: PathMove, starts: Sequence[float]) -> None:
        self.axes, self._controller = first.axes, first.axes[0].controller
        self.courses = [Course(first, starts)]
        self.ended = ""
        self.hard = False
        self._over = False
        self._event: TimedCall | None = None
        self._blend_event: TimedCall | None = None
        # The remaining distance of the path when `blend` was called, if the blend has to wait. For the next
        # blend: true if it begins later than its distance requires, and the commanded distance if it will be
        # shorter.
        self._wanted: float | None = None
        self._is_late = False
        self._commanded_blend: float | None = None

    # -------------------------------------------------------------------------------------------- commands

    def start(self) -> None:
        """Begin the run with its first course."""
        course = self.courses[0]
        _prepare(course)
        self._enter(course)

    def replan(self) -> None:
        """Apply the present settings, unless they would cause an overshoot."""
        if self._over or self.ended:
            return
        plans = [(course, course.planned(course.elapsed)) for course in self._live]
        for course, planned in plans:
            if planned is None:
                course.report_late_rates()
        self._change([(course, *planned) for course, planned in plans if planned is not None])

    def more(self) -> None:
        """Handle the release of a further path, which may prolong the run or be blended."""
        newest = self.courses[-1]
        if self._over or self.ended or newest.is_over or newest.is_suspended:
            return
        known = len(newest.ahead)
        newest.look_ahead()
        if len(newest.ahead) > known:
            self.replan()
        self._plan_blend()

    def stop(self, a: Axis, ended: str, hard: bool) -> None:
        """Come to rest on the paths and empty the buffer of `a`.

        The rates are those of the first axis, whichever axis is stopped: the DECEL of the path, or ERRORDECEL for
        a hard stop.
        """
        for each in self.axes:
            release(each)
        for course in self._live:
            course.is_stopping = True
            if course.here.policy is not None:
                course.here.policy.stops()
        if self.ended and not (hard and (ended == "fault" or not self.hard)):
            empty(a, ended)
            return
        decel = None
        if hard:
            decel = self.axes[0].error_decel / abs(self.courses[-1].here.scales[0])
        self._cancel_blend()
        plans: list[Plan] = []
        for course in self._live:
            profile = course.stopped(decel, beyond=ended == "fault")
            if profile is not None:
                plans.append((course, profile, None))
            self._keep(course, course.reached(profile), ended)
            if profile is None and not course.leads_on:
                for move in course.here.moves:
                    move.ended = ended
        self.ended, self.hard = ended, hard
        empty(a, ended)
        self._change(plans)
        self._aim()

    def _keep(self, course: Course, count: int, ended: str) -> None:
        """Keep `count` paths ahead, which a stop enters, and remove them from the buffers.

        A harder stop drops the others; before the first stop they are in the buffers.
        """
        for number, (path, _) in enumerate(course.ahead):
            for a, move in zip(self.axes, path.moves, strict=True):
                if number < count and move in a.buffer:
                    a.buffer.remove(move)
                elif number >= count and self.ended:
                    move.ended = ended
                    log_dropped(a, move)
        del course.ahead[count:]

    def suspend(self) -> None:
        """Come to rest on the paths and retain them."""
        if self.ended:
            return
        self._cancel_blend()
        plans = [(course, course.with_standstill(course.elapsed)) for course in self._live]
        self._change([(course, profile, None) for course, profile in plans if profile is not None])

    def resume(self) -> None:
        """Continue after `suspend`."""
        self.replan()
        self.more()

    def abandon(self, leaving: Axis, ended: str) -> None:
        """Halt all axes at once, because `leaving` has been halted."""
        if self._over:
            return
        self._over = True
        self._cancel()
        for course in self._live:
            self._keep(course, 0, ended)
            course.leave(False)
            course.cut_log()
            for move in course.here.moves:
                move.ended = ended
        self._join()
        for a in self.axes:
            if a is not leaving:
                freeze(a, ended)

    def shift(self, a: Axis, by: float) -> None:
        """Shift the positions of an axis by `by` counts for a new zero; the paths stay."""
        k = self.axes.index(a)
        for course in self.courses:
            course.shift(k, by)
        for move in motions(a):
            move.action.geometry.shift(k, by)  # type: ignore[union-attr]
            move.target += by

    def blend(self) -> None:
        """Begin the next path now, superposed on the rest of this one.

        At most two paths overlap: while the previous path is still blended with this one, the next one begins as
        soon as the previous one has ended.
        """
        newest = self.courses[-1]
        if self._over or self.ended or newest.is_over or newest.is_suspended or newest.following() is None:
            return
        if newest.ahead:
            raise Rejected(
                "contour-and-blend",
                f"axis {self.axes[0].index} contours past the end of this path",
                "set CONTOURMODE to 0 to blend paths",
            )
        if len(self.courses) > 1:
            self._wanted = newest.remaining
            self._plan_blend()
        else:
            self._blend()

    def entries(self, a: Axis) -> tuple[LoggedMove, ...]:
        """Return the log entries of an axis that may still change, oldest first."""
        k = self.axes.index(a)
        return tuple(path.moves[k] for course in self.courses for path in course.entered)

    @property
    def present(self) -> Course:
        """The course that began last, among those that are not over."""
        live = self._live
        return live[-1] if live else self.courses[-1]

    @property
    def stops_at_corner(self) -> bool:
        """True if only the angle to the next path makes it stop at the end of this one."""
        return not self.ended and self.present.stops_at_corner

    # --------------------------------------------------------------------------------------------- execution

    @property
    def _live(self) -> list[Course]:
        return [course for course in self.courses if not course.is_over]

    def _enter(self, course: Course) -> None:
        """Start every axis on its curve of the path that a course has just reached."""
        course.here.run = self
        if course.here.policy is not None:
            course.here.policy.begins()
        course.follow(course.profile, course.goal)
        with self._controller.together():
            for k, (a, move, end) in enumerate(zip(self.axes, course.here.moves, course.ends, strict=True)):
                move.target = end
                move.ended = "" if course.leads_on else self.ended
                made = course.of(k)
                log_move(a, move, made, is_stop=self.ended != "")
                extend_track(a, self._total(k, made), BY_DESIGN)
            self._await()
        if self.ended:
            self._aim()

    def _change(self, plans: Sequence[Plan]) -> None:
        """Put new profiles of courses in force from now on."""
        if not plans:
            return
        for course, profile, goal in plans:
            course.change(profile, goal)
            course.cut_log()
        self._join([course for course, _, _ in plans])
        with self._controller.together():
            for k, a in enumerate(self.axes):
                extend_track(a, self._total(k, self.courses[-1].of(k)), BY_DESIGN)
            self._await()

    def _join(self, changed: Sequence[Course] = ()) -> None:
        """Make each course begin where the one before it ends, and update the log."""
        before: Course | None = None
        for course in self.courses:
            if before is not None:
                course.begin_at([move.profile.end for move in before.here.moves if move.profile is not None])
            if course in changed:
                moves = course.here.moves
                made = [course.of(k) for k in range(len(moves))]
                ended = "" if course.leads_on else self.ended
                amend_log(self._controller.log, self._controller.clock.now, moves, made, ended)
            before = course

    def _aim(self) -> None:
        """Set the targets to the positions at rest, from which later moves count."""
        if self._over:
            return
        for a, position in zip(self.axes, self.courses[-1].positions_at_rest(), strict=True):
            a.target = position

    def _total(self, k: int, made: Profile) -> Profile:
        """Return the motion of axis index k.

        It is the sum of `made`, the motion of the newest course, and the rest of the course before.
        """
        now = self._controller.clock.now
        made = made.after(now - self.courses[-1].began)
        for course, following in pairwise(self.courses):
            rest = course.of(k).after(now - course.began)
            tail = rest.shifted(-following.begins[k])
            both = added(made, tail, "blend")
            if not made.end_velocity:
                both.end = made.end  # the tail vanishes
            made = both
        return made

    def _await(self) -> None:
        """Schedule the next end of a course and the next blend."""
        if self._event is not None:
            self._event.cancel()
        end = min(course.end_time for course in self._live)
        self._event = self._controller.clock.at(end, self._reached) if end < INFINITY else None
        self._plan_blend()

    def _reached(self) -> None:
        """Handle the end of a path of a course.

        If the newer of two courses is over first, the move of the older one is in progress again.
        """
        self._event = None
        now, newest = self._controller.clock.now, self.courses[-1]
        ended = [course for course in self._live if course.end_time <= now]
        onward = newest in ended and newest.leads_on
        for course in ended[: len(ended) - onward]:
            course.is_over = True
            course.leave(course.profile.end >= course.segment.length * (1.0 - SLACK))
        while len(self.courses) > 1 and self.courses[0].is_over:
            del self.courses[0]
            del self.courses[0].entered[:-1]
        if onward:
            self._go_on(newest)
            return
        if self.courses[0].is_over:
            self._finish()
            return
        for a, move in zip(self.axes, self.present.here.moves, strict=True):
            a.move = move
        if newest.is_over and self._commanded_blend is not None:
            self._limited(self._commanded_blend, 0.0)
        self._await()

    def _go_on(self, course: Course) -> None:
        """Enter the next path of a course without a stop, on the rest of the profile."""
        rest = course.profile.after(course.elapsed)
        course.leave(True)
        for a in self.axes:
            a.move = None
        course.begin_next()
        if len(self.courses) == 1:
            del course.entered[:-1]
        for a, move in zip(self.axes, course.here.moves, strict=True):
            if move in a.buffer:
                reach(a, move)
        course.go_on(rest)
        self._enter(course)

    def _finish(self) -> None:
        """End the run with all axes at rest, at their ends or where they were stopped."""
        self._over = True
        self._cancel()
        for a, move in zip(self.axes, self.courses[0].here.moves, strict=True):
            end = a.profiles[-1].end
            a.move = None
            a.target = move.target = end
            extend_track(a, hold(end), BY_DESIGN)
        for a in self.axes:
            start_waiting(a)
        for a in self.axes:
            if a.move is None:
                a.controller.notify("idle", a.index)

    def _cancel(self) -> None:
        if self._event is not None:
            self._event.cancel()
        self._cancel_blend()

    # ------------------------------------------------------------------------------------------------ blending

    def _plan_blend(self) -> None:
        """Schedule the next blend at its distance before the end of the path, or now.

        BLENDDISTANCE is limited to `MAX_SHARE` of a path. No blend begins before the previous one is over.
        """
        self._cancel_blend()
        newest, master, clock = self.courses[-1], self.axes[0], self._controller.clock
        if not master.blend_mode and self._wanted is None:
            return
        if self.ended or self._over or newest.is_over or newest.is_suspended or newest.ahead:
            return
        if newest.following() is None:
            return
        length, profile, elapsed = newest.segment.length, newest.profile, newest.elapsed
        wanted, most = master.blend_distance, MAX_SHARE * length
        if self._wanted is not None:
            wanted = most = self._wanted
        begins_at = max(length - min(wanted, most), profile.start)
        is_passed = profile.position(elapsed) >= begins_at
        time = elapsed if is_passed else profile.crossing(begins_at, elapsed)
        if time is None:
            return
        due = max(newest.began + time, clock.now)
        free = self.courses[0].end_time if len(self.courses) > 1 else due
        self._is_late = free > due + SLACK or (self._is_late and is_passed)
        self._commanded_blend = wanted if self._is_late or wanted > most * (1.0 + SLACK) else None
        if max(due, free) < INFINITY:
            self._blend_event = clock.at(max(due, free), self._blend)

    def _blend(self) -> None:
        """Begin the next path, superposed on the rest of the present one."""
        newest = self.courses[-1]
        following = newest.following()
        if following is None or len(self.courses) > 1:
            return
        if self._commanded_blend is not None:
            self._limited(self._commanded_blend, newest.remaining)
        self._cancel_blend()
        self._wanted, self._is_late = None, False
        course = Course(following, newest.segment.ends)
        try:
            _prepare(course, begins=True)
        except Rejected as rejected:  # the entry is skipped, and the one behind it may be blended into
            for a, move in zip(self.axes, following.moves, strict=True):
                reach(a, move)
            self._controller.run_time_fault(rejected)
            self._plan_blend()
            return
        for a, move in zip(self.axes, following.moves, strict=True):
            a.move = None
            reach(a, move)
        self.courses.append(course)
        self._join()
        self._enter(course)

    def _limited(self, commanded: float, got: float) -> None:
        """Report a blend over `got` user units, less than `commanded`."""
        if got < commanded * (1.0 - SLACK):
            line = self.courses[-1].here.moves[0].line
            clamped_blend(self.axes[0], line, commanded, got)

    def _cancel_blend(self) -> None:
        self._commanded_blend = None
        if self._blend_event is not None:
            self._blend_event.cancel()
            self._blend_event = None


def _prepare(course: Course, begins: bool = False) -> None:
    """Plan a course from rest on its first path.

    If it `begins` superposed on another one, its path is still in the buffers.
    """
    if course.here.policy is not None:
        course.here.policy.starts()
    try:
        course.look_ahead(begins)
        course.plan_afresh()
    except Rejected as rejected:
        rejected.line = course.here.moves[0].line
        raise
