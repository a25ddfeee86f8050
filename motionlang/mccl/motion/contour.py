"""Contour motion: the queue of paths of one controlling axis, and the run through those that join smoothly.

Paths that go on in the same direction with the same vector settings are run through without slowing down; where the
direction changes the axes come to rest in the corner.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.controller.move import Action
from motionlang.mccl import codes
from motionlang.mccl.codes import Fault
from motionlang.mccl.motion.course import Course
from motionlang.mccl.motion.segment import Segment, join_smoothly
from motionlang.profile import hold
from motionlang.profile.lookahead import Pace, plan_course
from motionlang.profile.relief import onset, stop_under_way

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.controller.clock import Event
    from motionlang.controller.core import Core
    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.runtime.board import Board
    from motionlang.profile import Profile


class OnContour(Action):
    """The part of one axis in a contour: a stop of it is one of the whole, along the paths."""

    __slots__ = ("_contour",)

    def __init__(self, contour: Contour) -> None:
        self._contour = contour

    def stop(self, controller: Core, a: Axis, ended: str, hard: bool) -> bool:
        return self._contour.stop(ended)


# Paths that may wait in the queue.
LONGEST_QUEUE = 1000

# What a stop may end short of the paths by, as a part of their length, and still be the rest at their end.
_SLACK = 1e-9


class Contour:
    """The paths that one axis controls. `end` is the point where the last of them ends, by axis, in user units."""

    __slots__ = ("_axis", "_board", "_course", "_events", "_line", "_path", "_queue", "_start", "_stopping")

    def __init__(self, board: Board, axis: AxisState) -> None:
        self._board, self._axis = board, axis
        self._queue: list[tuple[Segment, int]] = []
        self._course: Course | None = None
        self._path: Profile | None = None
        self._start = 0.0
        self._stopping = False
        self._line = 0
        self._events: list[Event] = []

    @property
    def stopping(self) -> bool:
        """Whether it comes to rest before its end."""
        return self._course is not None and self._stopping

    @property
    def members(self) -> tuple[int, ...]:
        """The axes of the paths under way."""
        return tuple(self._course.segments[0].end) if self._course is not None else ()

    def end(self, axis: AxisState) -> float:
        """Where the axis will be after all paths so far, user units."""
        last = self._queue[-1][0] if self._queue else self._course.segments[-1] if self._course else None
        if last is not None and axis.number in last.end:
            return axis.scale.position_to_user(last.end_counts(axis.number))
        return axis.scale.position_to_user(self._board.controller.target(axis.number))

    def add(self, segment: Segment, line: int) -> None:
        """Put a path into the queue; without synchronisation it starts as soon as it can."""
        if len(self._queue) >= LONGEST_QUEUE:
            raise Fault(
                codes.PARAMETER,
                f"{LONGEST_QUEUE} contour paths are waiting already",
                "wait with WS",
                "buffer-full",
            )
        if not self._axis.synchronised and not self._queue and self._extend(segment):
            return
        self._queue.append((segment, line))
        if not self._axis.synchronised:
            self.go()

    def go(self) -> None:
        """Start what waits, if nothing is under way."""
        if self._course is None and self._queue:
            segments = [self._queue.pop(0)]
            while self._queue and join_smoothly(segments[-1][0], self._queue[0][0]):
                segments.append(self._queue.pop(0))
            self._line = segments[0][1]
            self._run(Course([segment for segment, _ in segments]))

    def stop(self, ended: str = "stop") -> bool:
        """Come to rest at its deceleration, or at the end of the paths where that is nearer; forget what waits.

        False where there is nothing to stop.
        """
        self._queue.clear()
        if self._course is None or self._path is None:
            return False
        motion, time = self._course.segments[0].motion, self._board.controller.clock.now - self._start
        if self._path.velocity(time) == 0.0:
            self.abort("cancel" if ended == "stop" else ended)
            return True
        path = stop_under_way(self._path, time, motion.shape, motion.decel, motion.ramp)
        if path.end >= self._course.length * (1.0 - _SLACK):
            path = self._path.after(time)
        self._stopping = True
        self._redirect(path, ended)
        return True

    def abort(self, ended: str = "cancel") -> None:
        """Stand still at once; what waits is forgotten."""
        self._queue.clear()
        members = self.members
        self._finish()
        for number in members:
            self._board.controller.abort(number, ended)

    def set_speed(self) -> None:
        """The override has changed: go on at the new vector velocity, where the shape allows it in motion."""
        if self._course is None or self._path is None or self._stopping:
            return
        motion = self._course.segments[0].motion
        if motion.shape == "trapezoid":
            self._redirect(self._planned_from_here(), "")

    def shift(self, number: int, by: float) -> None:
        """An axis counts from another zero: the paths stay where they are, `by` counts higher."""
        for segment in (*(self._course.segments if self._course else ()), *(each for each, _ in self._queue)):
            segment.shift(number, by)

    def forget(self, number: int) -> None:
        """An axis leaves: paths that wait, if it has a part in one of them, have lost their start."""
        if any(number in segment.end for segment, _ in self._queue):
            self._queue.clear()

    def rested(self, number: int) -> None:
        """An axis has come to rest: when all have, the next paths may start."""
        if number not in self.members:
            return
        controller = self._board.controller
        if all(controller.is_idle(each) for each in self.members):
            self._finish()
            self.go()

    # ------------------------------------------------------------------------------------------------- inside

    def _run(self, course: Course) -> None:
        if course.length == 0.0:
            self._axis.segments += len(course.segments)
            self.go()
            return
        controller = self._board.controller
        path = self._plan(course, hold(0.0), 0.0)
        assert path is not None
        self._course, self._path, self._start = course, path, controller.clock.now
        self._stopping = False
        with controller.together():
            for number, profile in [(each, self._of(each)) for each in self.members]:
                if self._course is course:  # unless the start of an axis before it has ended the path
                    controller.play(number, profile, "CP", self._line, action=OnContour(self))
        if self._course is course:
            self._announce()

    def _extend(self, segment: Segment) -> bool:
        """Let the path under way grow by one that joins it smoothly; False where that cannot be."""
        course = self._course
        if course is None or self._path is None or not join_smoothly(course.segments[-1], segment):
            return False
        if segment.motion.shape != "trapezoid" or self._stopping or segment.length == 0.0:
            return False
        course.extend(segment)
        self._redirect(self._planned_from_here(), "")
        return True

    def _planned_from_here(self) -> Profile:
        """To the end of the course, or on as it is where there is no room to stop there."""
        assert self._course is not None
        assert self._path is not None
        time = self._board.controller.clock.now - self._start
        return self._plan(self._course, self._path, time) or self._path.after(time)

    def _plan(self, course: Course, path: Profile, time: float) -> Profile | None:
        """To the end of the course from what `path` does at `time`; None where there is no room to stop there."""
        motion = course.segments[0].motion
        speed = motion.speed * self._axis.vector.override
        pace = Pace(motion.shape, speed, motion.accel, motion.decel, motion.ramp)
        eased, place, velocity, _ = onset(path, time, motion.shape, INFINITY)
        made = plan_course([(course.length, pace)], place, velocity)
        return made if eased is None or made is None else eased.then(made)

    def _redirect(self, path: Profile, ended: str) -> None:
        controller = self._board.controller
        self._path, self._start = path, controller.clock.now
        with controller.together():
            for number in self.members:
                controller.redirect(number, self._of(number), ended)
            self._announce()

    def _of(self, number: int) -> Profile:
        assert self._course is not None
        assert self._path is not None
        return self._course.profile(self._path, number)

    def _announce(self) -> None:
        """Count every path at the moment it has been carried out."""
        assert self._course is not None
        assert self._path is not None
        for event in self._events:
            event.cancel()
        self._events.clear()
        course, path, clock = self._course, self._path, self._board.controller.clock
        self._show(course.index(path.start))
        for k, mark in enumerate(course.marks[1:], 1):
            if mark > path.start and (time := path.crossing(mark)) is not None:
                self._events.append(clock.at(self._start + time, lambda k=k: self._passed(k)))  # type: ignore[misc]

    def _passed(self, index: int) -> None:
        self._axis.segments += 1
        if self._course is not None and index < len(self._course.segments):
            self._show(index)

    def _show(self, index: int) -> None:
        assert self._course is not None
        arc = self._course.segments[index].is_arc
        self._axis.on_arc, self._axis.on_line = arc, not arc

    def _finish(self) -> None:
        now = self._board.controller.clock.now
        for event in self._events:
            # A path that ends with the motion has its event at this same moment.
            if event.time > now:
                event.cancel()
        self._events.clear()
        self._course = self._path = None
        self._axis.on_arc = self._axis.on_line = False
