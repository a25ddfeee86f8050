"""Contour motion: the queue of paths of one controlling axis, and what the controller's path planner asks about them.

Paths that go on in the same direction with the same vector settings are run through without slowing down; where the
direction changes the axes come to rest in the corner.
"""

from __future__ import annotations

from motionlang.controller.moves.guide import Guide
from motionlang.mccl import codes
from motionlang.mccl.codes import Fault
from motionlang.planners.lookahead import Pace

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from motionlang.controller.moves.geometry import Arc, Line, Segment
    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.runtime.board import Board

    # The axes of a path, where it leads, what it goes by, its command and the number of its line.
    Described = tuple[tuple[int, ...], "Line | Arc", "Vector", str, int]

# Paths that may wait in the queue.
LONGEST_QUEUE = 1000
# What the directions of two paths may differ by, in user units per unit of length, and be the same, as ends are whole.
_SAME = 1e-3


class Vector(Guide):
    """What a path of a contour goes by: the vector settings as they were when it was described, the override of now.

    `length` is what the vector velocity counts, in user units.
    """

    def __init__(
        self, contour: Contour, scales: Sequence[float], pace: Pace, length: float, is_arc: bool
    ) -> None:
        super().__init__(scales)
        self.contour, self.length, self.is_arc = contour, length, is_arc
        self.shape, self.ramp, self.speed = pace.shape, pace.ramp, pace.speed
        self.accel, self.decel = pace.accel, pace.decel

    def pace(self) -> Pace:
        return Pace(self.shape, self.speed * self.contour.override, self.accel, self.decel, self.ramp)

    def joins(self, own: Segment, following: Guide, its: Segment) -> bool:
        if not isinstance(following, Vector) or following.contour is not self.contour:
            return False
        alike = following.scales == self.scales and following.pace().key() == self.pace().key()
        return alike and all(abs(a - b) <= _SAME for a, b in zip(own.leaving, its.entry, strict=True))

    def starts(self) -> None:
        self.contour.take_override()

    def begins(self) -> None:
        self.contour.begun(self)

    def stops(self) -> None:
        self.contour.stopped()

    def ends(self, whole: bool) -> None:
        self.contour.ended(whole)


class Contour:
    """The paths that one axis controls: those that wait, in the order in which they were described.

    What can be run as one is handed to the controller, whose buffers hold it; the rest waits here until that is done.
    """

    def __init__(self, board: Board, axis: AxisState) -> None:
        self._board, self._axis = board, axis
        self._queue: list[Described] = []
        # Where the paths so far lead, counts, by axis.
        self._ends: dict[int, float] = {}
        # The axes of the paths that the controller has, how many of them wait in its buffers, the one that it runs.
        self._members: tuple[int, ...] = ()
        self._handed = 0
        self._under_way: Vector | None = None
        self._stopping = False
        # What multiplies the vector velocity of what is under way.
        self.override = 1.0

    @property
    def stopping(self) -> bool:
        """Whether it comes to rest before its end."""
        return self._stopping

    @property
    def members(self) -> tuple[int, ...]:
        """The axes of the paths under way."""
        return self._members

    def end(self, axis: AxisState) -> float:
        """Where the axis will be after all paths so far, counts."""
        end = self._ends.get(axis.number)
        return self._board.controller.target(axis.number) if end is None else end

    def add(self, path: Described, ends: Mapping[int, float]) -> None:
        """Put a path into the queue; without synchronisation it starts as soon as it can."""
        if len(self._queue) + self._handed >= LONGEST_QUEUE:
            raise Fault(
                codes.PARAMETER,
                f"{LONGEST_QUEUE} contour paths are waiting already",
                "wait with WS",
                "buffer-full",
            )
        self._queue.append(path)
        self._ends.update(ends)
        if not self._axis.synchronised:
            self.go()

    def go(self) -> None:
        """Hand the controller what waits, as far as it can be run behind what is under way."""
        controller, handed = self._board.controller, False
        while self._queue:
            axes, geometry, vector, word, line = self._queue[0]
            if self._members and not self._may_follow(axes, vector):
                break
            del self._queue[0]
            if vector.length == 0.0:
                self._axis.segments += 1
                continue
            controller.load_guided(axes, geometry, vector, word, line)
            self._members, handed = axes, True
            self._handed += 1
        if handed:
            controller.go([self._members[0]])

    def _may_follow(self, axes: tuple[int, ...], vector: Vector) -> bool:
        """Whether a path may stand behind those that the controller has; one with an S-curve is not prolonged."""
        if self._stopping or axes != self._members or vector.length == 0.0:
            return False
        return self._under_way is None or vector.shape == "trapezoid"

    def stop(self) -> None:
        """Come to rest along the paths; forget what waits."""
        self._forget("stop")
        if self._members:
            self._board.controller.stop(self._members[0])

    def abort(self, ended: str = "cancel") -> None:
        """Stand still at once; what waits is forgotten."""
        self._forget(ended)
        if self._members:
            self._board.controller.abort(self._members[0], ended)

    def set_speed(self) -> None:
        """The override has changed: go on at the new vector velocity, where the shape allows it in motion."""
        if self._under_way is not None and not self._stopping and self._under_way.shape == "trapezoid":
            self.take_override()
            self._board.controller.replan_path(self._members[0])

    def shift(self, number: int, by: float) -> None:
        """An axis counts from another zero: the paths that wait stay where they are, `by` counts higher."""
        if number in self._ends:
            self._ends[number] += by
        for axes, geometry, *_ in self._queue:
            if number in axes:
                geometry.shift(axes.index(number), by)

    def forget(self, number: int) -> None:
        """An axis leaves: paths that wait, if it has a part in one of them, have lost their start."""
        if any(number in axes for axes, *_ in self._queue):
            self._forget("cancel")

    def rested(self, number: int) -> None:
        """An axis has come to rest: when all have, the next paths may start."""
        if number not in self._members or self._under_way is not None:
            return
        if all(self._board.controller.is_idle(each) for each in self._members):
            self._members, self._handed, self._stopping = (), 0, False
            if not self._queue:
                self._ends.clear()
            self.go()

    # ------------------------------------------------------------------------------------- told by the planner

    def take_override(self) -> None:
        """The override of now holds for what is planned now."""
        self.override = self._axis.vector.override

    def begun(self, vector: Vector) -> None:
        """A path is under way."""
        self._handed -= 1
        self._under_way, self._stopping = vector, False
        self._axis.on_arc, self._axis.on_line = vector.is_arc, not vector.is_arc

    def stopped(self) -> None:
        """The paths under way come to rest; what waits is forgotten."""
        self._stopping = True
        self._forget("stop")

    def ended(self, whole: bool) -> None:
        """A path is under way no more."""
        self._under_way = None
        self._axis.segments += whole
        self._axis.on_arc = self._axis.on_line = False

    def _forget(self, ended: str) -> None:
        for axes, _, _, word, line in self._queue:
            self._board.controller.drop(axes, word, line, ended)
        self._queue.clear()
        self._ends.clear()
