"""Contour motion: the queue of paths of one controlling axis.

It also answers the queries of the controller's path planner. Consecutive paths in the same direction with the
same vector settings are run without slowing down. At a change of direction the axes come to rest in the
corner.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.controller.moves.geometry import Arc, PathSegment, StraightLine
from motionlang.kernel.controller.moves.path_policy import PathPolicy
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.axis import AxisState
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.planners.lookahead import PathPace

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.board import Board

# The axes of a path, its geometry, its policy, its command and its line number.
Described = tuple[tuple[int, ...], "StraightLine | Arc", "Vector", str, int]

# The largest number of paths in the queue.
MAX_QUEUE = 1000
# The largest difference between equal directions, in user units per unit of length, because ends are integer
# counts.
_SAME = 1e-3


class Vector(PathPolicy):
    """Path policy of a contour.

    It has the vector settings at the time when the path was described, and the current override. `length` is
    the length to which the vector velocity refers, in user units.
    """

    def __init__(
        self, contour: Contour, scales: Sequence[float], pace: PathPace, length: float, is_arc: bool
    ) -> None:
        super().__init__(scales)
        self.contour, self.length, self.is_arc = contour, length, is_arc
        self.shape, self.ramp, self.speed = pace.shape, pace.ramp, pace.speed
        self.accel, self.decel = pace.accel, pace.decel

    def pace(self) -> PathPace:
        return PathPace(self.shape, self.speed * self.contour.override, self.accel, self.decel, self.ramp)

    def joins(self, own: PathSegment, following: PathPolicy, its: PathSegment) -> bool:
        if not isinstance(following, Vector) or following.contour is not self.contour:
            return False
        is_equal = following.scales == self.scales and following.pace().key() == self.pace().key()
        return is_equal and all(abs(a - b) <= _SAME for a, b in zip(own.leaving, its.entry, strict=True))

    def starts(self) -> None:
        self.contour.take_override()

    def begins(self) -> None:
        self.contour.begun(self)

    def stops(self) -> None:
        self.contour.stopped()

    def ends(self, whole: bool) -> None:
        self.contour.ended(whole)


class Contour:
    """The paths that one axis controls, queued in the order of their description.

    Paths that can be run as one are passed to the controller's buffers. The others wait here until those have
    ended.
    """

    def __init__(self, board: Board, axis: AxisState) -> None:
        self._board, self._axis = board, axis
        self._queue: list[Described] = []
        # The number of paths at the head of the queue that do not wait for GO.
        self._released = 0
        # The end of all paths so far, and of those that do not wait for GO, counts, by axis.
        self._ends: dict[int, float] = {}
        self._aims: dict[int, float] = {}
        # The axes of the controller's paths, the number of paths that wait in its buffers, and the current
        # path.
        self._members: tuple[int, ...] = ()
        self._handed = 0
        self._in_progress: Vector | None = None
        self._stopping = False
        # The factor on the vector velocity of the current path.
        self.override = 1.0

    @property
    def stopping(self) -> bool:
        """True if the current path comes to rest before its end."""
        return self._stopping

    @property
    def members(self) -> tuple[int, ...]:
        """The axes of the current paths."""
        return self._members

    def end(self, axis: AxisState) -> float:
        """Return the position of the axis after all paths queued so far, counts."""
        end = self._ends.get(axis.number)
        return self._board.controller.target(axis.number) if end is None else end

    def aim(self, number: int) -> float | None:
        """Return the target of the axis, counts, or None if no path of it runs or waits.

        Paths that wait for GO do not count.
        """
        return self._aims.get(number) if self._members else None

    def waits_for(self, number: int) -> bool:
        """True if a waiting path will move the axis when the current ones have ended."""
        return bool(self._members) and any(number in axes for axes, *_ in self._queue[: self._released])

    def continues(self, number: int) -> bool:
        """True if the axis is on a path before the last one, or waits for one."""
        return (self._handed > 0 and number in self._members) or self.waits_for(number)

    def includes(self, number: int) -> bool:
        """True while paths run that the axis is on, waits for or controls."""
        if number in self._members:
            return True
        return bool(self._members) and (number == self._axis.number or self.waits_for(number))

    def add(self, path: Described, ends: Mapping[int, float]) -> None:
        """Queue a path; without synchronization it starts as soon as possible."""
        if len(self._queue) + self._handed >= MAX_QUEUE:
            raise Fault(
                codes.PARAMETER,
                f"{MAX_QUEUE} contour paths are waiting already",
                "wait with WS",
                "buffer-full",
            )
        self._queue.append(path)
        self._ends.update(ends)
        if not self._axis.synchronised:
            self.go()

    def go(self) -> None:
        """Let all queued paths start, each as soon as possible."""
        self._released = len(self._queue)
        self._aims.update(self._ends)
        self._start()

    def _start(self) -> None:
        """Pass the released paths to the controller that may follow the current ones."""
        controller, handed = self._board.controller, False
        while self._released:
            axes, geometry, vector, word, line = self._queue[0]
            if self._members and not self._may_follow(axes, vector):
                break
            del self._queue[0]
            self._released -= 1
            if vector.length == 0.0:
                self._axis.segments += 1
                continue
            controller.load_guided(axes, geometry, vector, word, line)
            self._members, handed = axes, True
            self._handed += 1
        if handed:
            controller.go([self._members[0]])
        elif not self._members:
            # The ends of axes without a path are no longer known: they may leave the contour.
            waiting = {axis for axes, *_ in self._queue for axis in axes}
            self._ends = {axis: end for axis, end in self._ends.items() if axis in waiting}
            self._aims.clear()

    def _may_follow(self, axes: tuple[int, ...], vector: Vector) -> bool:
        """True if a path may follow the paths that the controller has.

        A path with an S-curve is never extended.
        """
        if self._stopping or axes != self._members or vector.length == 0.0:
            return False
        return self._in_progress is None or vector.shape == "trapezoid"

    def stop(self) -> None:
        """Come to rest along the paths and clear the queue."""
        self._forget("stop")
        if self._members:
            self._board.controller.stop(self._members[0])

    def abort(self, ended: str = "cancel") -> None:
        """Stop instantly and clear the queue."""
        self._forget(ended)
        if self._members:
            self._board.controller.abort(self._members[0], ended)

    def set_speed(self) -> None:
        """Apply a changed override, if the profile's shape allows a change in motion."""
        if self._in_progress is not None and not self._stopping and self._in_progress.shape == "trapezoid":
            self.take_override()
            self._board.controller.replan_path(self._members[0])

    def shift(self, number: int, by: float) -> None:
        """Shift the queued paths by `by` counts when the zero of an axis changes.

        Their physical positions stay the same.
        """
        for ends in (self._ends, self._aims):
            if number in ends:
                ends[number] += by
        for axes, geometry, *_ in self._queue:
            if number in axes:
                geometry.shift(axes.index(number), by)

    def forget(self, number: int) -> None:
        """Clear the queue if it contains the leaving axis, because its start is unknown."""
        if any(number in axes for axes, *_ in self._queue):
            self._forget("cancel")

    def rested(self, number: int) -> None:
        """Start the next paths when all axes have come to rest."""
        if number not in self._members or self._in_progress is not None:
            return
        if all(self._board.controller.is_idle(each) for each in self._members):
            self._members, self._handed, self._stopping = (), 0, False
            self._start()

    # ----------------------------------------------------------------------------------- called by the planner

    def take_override(self) -> None:
        """Apply the current override to the next plan."""
        self.override = self._axis.vector.override

    def begun(self, vector: Vector) -> None:
        """Handle the start of a path."""
        self._handed -= 1
        self._in_progress, self._stopping = vector, False
        self._axis.on_arc, self._axis.on_line = vector.is_arc, not vector.is_arc

    def stopped(self) -> None:
        """Clear the queue because the current paths come to rest."""
        self._stopping = True
        self._forget("stop")

    def ended(self, whole: bool) -> None:
        """Handle the end of a path; `whole` is true if it was completed."""
        self._in_progress = None
        self._axis.segments += whole
        self._axis.on_arc = self._axis.on_line = False

    def _forget(self, ended: str) -> None:
        for axes, _, _, word, line in self._queue:
            self._board.controller.drop(axes, word, line, ended)
        self._queue.clear()
        self._released = 0
        self._ends.clear()
        self._aims.clear()
