"""Running along paths: several axes on one path after another.

Problem. The axes of a path stay on one line or arc, while the program sets the speed along it. Between two
paths the axes come to rest, or run through the corner (contour mode). A stop, a suspension or another speed must
change all axes at the same time, and the log must record how far each path was run.

Idea. One profile is planned for the distance along the path; axis k is at curve[k](distance(t)). A `Course`
(`course.py`) is the path in progress, the paths ahead that it runs into without coming to rest, and that profile.

Data. Lengths and speeds along a path are in user units, positions of axes in counts. A path has an entry in the
log for each axis, which the course extends and closes. There is one event: the next end of a path (`_event`).

Life of a run. `start` enters the first path. At the end of a path the course enters the next one on the rest of
the same profile (`_go_on`), or is over: the axes are at rest, and each takes the next move of its buffer
(`_finish`). Changes arrive through `replan`, `more`, `stop`, `suspend` and `resume`. They plan a new profile, and
`_change` puts it in force.

Invariants.
- All axes of a run get their new profiles at the same time, and limits are checked when all have theirs
  (`together`).
- If new settings leave too little distance to stop at the end, the course continues as planned.

Cost. A change plans the course again over all its paths ahead, linear in their number, and makes one profile
for each axis. Entering a path plans again only if further paths have been released. Nothing is sampled.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY, TimedCall
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.moves.course import SLACK, Course
from motionlang.kernel.controller.queue.buffer import motions, reach
from motionlang.kernel.controller.queue.life import empty, start_waiting
from motionlang.kernel.controller.queue.stop import freeze, release
from motionlang.kernel.controller.queue.track import amend_log, extend_track, log_dropped, log_move
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile, hold

if TYPE_CHECKING:
    from motionlang.kernel.controller.moves.path import PathMove


class PathRun:
    """A run of `axes` along paths, from rest to rest.

    `ended` is the cause of an early end; `hard` is true if a hard stop ended it.
    """

    def __init__(self, first: PathMove, starts: Sequence[float]) -> None:
        self.axes, self._controller = first.axes, first.axes[0].controller
        self.course = Course(first, starts)
        self.ended = ""
        self.hard = False
        self._over = False
        self._event: TimedCall | None = None

    # -------------------------------------------------------------------------------------------- commands

    def start(self) -> None:
        """Begin the run with its first path."""
        course = self.course
        if course.here.policy is not None:
            course.here.policy.starts()
        try:
            course.look_ahead()
            course.plan_afresh()
        except Rejected as rejected:
            rejected.line = course.here.moves[0].line
            raise
        self._enter()

    def replan(self) -> None:
        """Apply the present settings, unless they would cause an overshoot."""
        if self._over or self.ended:
            return
        planned = self.course.planned(self.course.elapsed)
        if planned is None:
            self.course.report_late_rates()
        else:
            self._change(*planned)

    def more(self) -> None:
        """Handle the release of a further path, which may prolong the run."""
        course = self.course
        if self._over or self.ended or course.is_suspended:
            return
        known = len(course.ahead)
        course.look_ahead()
        if len(course.ahead) > known:
            self.replan()

    def stop(self, a: Axis, ended: str, hard: bool) -> None:
        """Come to rest on the paths and empty the buffer of `a`.

        The rates are those of the first axis, whichever axis is stopped: the DECEL of the path, or ERRORDECEL for
        a hard stop.
        """
        for each in self.axes:
            release(each)
        course = self.course
        course.is_stopping = True
        if course.here.policy is not None:
            course.here.policy.stops()
        if self.ended and not (hard and (ended == "fault" or not self.hard)):
            empty(a, ended)
            return
        decel = None
        if hard:
            decel = self.axes[0].error_decel / abs(course.here.scales[0])
        profile = course.stopped(decel, beyond=ended == "fault")
        self._keep(course.reached(profile), ended)
        if profile is None and not course.leads_on:
            for move in course.here.moves:
                move.ended = ended
        self.ended, self.hard = ended, hard
        empty(a, ended)
        if profile is not None:
            self._change(profile, None)
        self._aim()

    def _keep(self, count: int, ended: str) -> None:
        """Keep `count` paths ahead, which a stop enters, and remove them from the buffers.

        A harder stop drops the others; before the first stop they are in the buffers.
        """
        for number, (path, _) in enumerate(self.course.ahead):
            for a, move in zip(self.axes, path.moves, strict=True):
                if number < count and move in a.buffer:
                    a.buffer.remove(move)
                elif number >= count and self.ended:
                    move.ended = ended
                    log_dropped(a, move)
        del self.course.ahead[count:]

    def suspend(self) -> None:
        """Come to rest on the paths and retain them."""
        if self.ended:
            return
        profile = self.course.with_standstill(self.course.elapsed)
        if profile is not None:
            self._change(profile, None)

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
        self._keep(0, ended)
        self.course.leave(False)
        self.course.cut_log()
        for move in self.course.here.moves:
            move.ended = ended
        for a in self.axes:
            if a is not leaving:
                freeze(a, ended)

    def shift(self, a: Axis, by: float) -> None:
        """Shift the positions of an axis by `by` counts for a new zero; the paths stay."""
        k = self.axes.index(a)
        self.course.shift(k, by)
        for move in motions(a):
            move.action.geometry.shift(k, by)  # type: ignore[union-attr]
            move.target += by

    def entries(self, a: Axis) -> tuple[LoggedMove, ...]:
        """Return the log entries of an axis that may still change, oldest first."""
        return (self.course.here.moves[self.axes.index(a)],)

    @property
    def stops_at_corner(self) -> bool:
        """True if only the angle to the next path makes it stop at the end of this one."""
        return not self.ended and self.course.stops_at_corner

    # --------------------------------------------------------------------------------------------- execution

    def _enter(self) -> None:
        """Start every axis on its curve of the path that the course has just reached."""
        course = self.course
        course.here.run = self
        if course.here.policy is not None:
            course.here.policy.begins()
        course.follow(course.profile, course.goal)
        with self._controller.together():
            for k, (a, move, end) in enumerate(
                zip(self.axes, course.here.moves, course.segment.ends, strict=True)
            ):
                move.target = end
                move.ended = "" if course.leads_on else self.ended
                made = course.of(k)
                log_move(a, move, made, is_stop=self.ended != "")
                extend_track(a, made, BY_DESIGN)
            self._await()
        if self.ended:
            self._aim()

    def _change(self, profile: Profile, goal: PathMove | None) -> None:
        """Put a new profile in force from now on."""
        course = self.course
        course.change(profile, goal)
        course.cut_log()
        made = [course.of(k) for k in range(len(self.axes))]
        ended = "" if course.leads_on else self.ended
        amend_log(self._controller.log, self._controller.clock.now, course.here.moves, made, ended)
        with self._controller.together():
            for a, each in zip(self.axes, made, strict=True):
                extend_track(a, each, BY_DESIGN)
            self._await()

    def _aim(self) -> None:
        """Set the targets to the positions at rest, from which later moves count."""
        if self._over:
            return
        for a, position in zip(self.axes, self.course.positions_at_rest(), strict=True):
            a.target = position

    def _await(self) -> None:
        """Schedule the next end of a path."""
        self._cancel()
        end = self.course.end_time
        self._event = self._controller.clock.at(end, self._reached) if end < INFINITY else None

    def _reached(self) -> None:
        """Handle the end of a path."""
        self._event = None
        course = self.course
        if course.leads_on:
            self._go_on()
            return
        course.leave(course.profile.end >= course.segment.length * (1.0 - SLACK))
        self._finish()

    def _go_on(self) -> None:
        """Enter the next path without a stop, on the rest of the profile."""
        course = self.course
        rest = course.profile.after(course.elapsed)
        course.leave(True)
        for a in self.axes:
            a.move = None
        course.begin_next()
        for a, move in zip(self.axes, course.here.moves, strict=True):
            if move in a.buffer:
                reach(a, move)
        course.go_on(rest)
        self._enter()

    def _finish(self) -> None:
        """End the run with all axes at rest, at their ends or where they were stopped."""
        self._over = True
        self._cancel()
        for a, move in zip(self.axes, self.course.here.moves, strict=True):
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
