"""A contour path while the commands of a line describe it.

CP opens it, and the first command that is not part of the description closes it.
"""

from __future__ import annotations

from math import hypot, radians
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.moves.geometry import Arc, StraightLine
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.axis import CONTOUR, AxisState
from motionlang.kernel.mccl.axis.motor import check_on
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords import table
from motionlang.kernel.mccl.motion.arcs import (
    angle_to,
    angle_until,
    centre_between,
    centre_by_radius,
    end_of,
    radius_of,
)
from motionlang.kernel.mccl.motion.contour import Contour, Vector
from motionlang.kernel.planners.lookahead import PathPace

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.task import CommandTask

USER, LINE, CLOCKWISE, ANTICLOCKWISE = range(4)
# The functions that describe a path instead of ending its description.
DESCRIBES = frozenset(
    {
        "move_to",
        "move_by",
        "go_home",
        "arc_center",
        "arc_center_by",
        "arc_end",
        "arc_end_by",
        "arc_radius",
        "path_distance",
    }
)


class Path:
    """The description so far, by axis number.

    `targets` are in counts; all other values are in user units and degrees.
    """

    def __init__(self, axis: AxisState, contour: Contour, kind: int, word: str, line: int) -> None:
        self._axis, self._contour, self._kind, self._word, self._line = axis, contour, kind, word, line
        self.targets: dict[int, float] = {}
        self.center: dict[int, float] = {}
        self.end_angle: float | None = None
        self.sweep: float | None = None
        self.radius: float | None = None
        self.distance: float | None = None
        # True once a command of the description was rejected.
        self.is_refused = False

    def end_of(self, axis: AxisState) -> float:
        """Return the position of the axis before this path, counts."""
        return self._contour.end(axis)

    def member(self, axis: AxisState) -> None:
        """Raise Fault unless the axis is in contour mode under the controlling axis."""
        if axis.mode != CONTOUR or axis.controlling != self._axis.number:
            raise Fault(
                codes.NOT_ASSIGNED,
                f"axis {axis.number} is not in contour mode under axis {self._axis.number}",
                f"{axis.number}{table().doing('contour_mode')}{self._axis.number} puts it there",
                "axis",
            )

    def move(self, task: CommandTask, targets: list[tuple[AxisState, float]]) -> None:
        """Set the end positions of the axes, counts, from MA and MR."""
        for axis, target in targets:
            self.member(axis)
            if axis.number in self.targets:
                raise Fault(
                    codes.ASSIGNED_TWICE,
                    f"axis {axis.number} already has an end point in this path",
                    "start each path with its own CP",
                    "axis",
                )
            check_on(task.board, axis)
            self.targets[axis.number] = target

    def close(self, task: CommandTask) -> None:
        """Queue the complete path; raise Fault if it is invalid."""
        board = task.board
        axes = [board.axes[number] for number in sorted({*self.targets, *self.center})]
        if not axes and self.is_refused:
            return
        if not axes:
            raise Fault(
                codes.PARAMETER,
                "the contour path has no end point",
                "give the end point with MA or MR after CP",
                "values",
            )
        for axis in axes:
            self.member(axis)
            check_on(board, axis)
        start = [self._contour.end(axis) for axis in axes]
        for axis, here in zip(axes, start, strict=True):
            if abs(here) == INFINITY:
                words = f"axis {axis.number} is jogging: no contour path can start from there"
                raise Fault(codes.INVALID, words, f"{axis.number}ST stops it", "moving")
        ends = [self.targets.get(axis.number, here) for axis, here in zip(axes, start, strict=True)]
        try:
            geometry, length = self._laid(axes, start, ends)
        except ValueError as problem:
            raise Fault(codes.PARAMETER, f"the contour path cannot be run: {problem}", kind="range") from None
        scales, is_arc = [axis.scale.counts for axis in axes], isinstance(geometry, Arc)
        vector = Vector(self._contour, scales, self._pace(task), length, is_arc)
        numbers = tuple(axis.number for axis in axes)
        where = dict(zip(numbers, geometry.ends(start, scales), strict=True))
        self._contour.add((numbers, geometry, vector, self._word, self._line), where)

    def _pace(self, task: CommandTask) -> PathPace:
        """Return the vector settings of the controlling axis, in its user units."""
        axis, controller = self._axis, task.board.controller
        counts, vector = abs(axis.scale.counts), axis.vector
        for function, value, code in (
            ("vector_velocity", vector.velocity, "zero-speed"),
            ("vector_accel", vector.accel, "zero-acceleration"),
            ("vector_decel", vector.decel, "zero-acceleration"),
            ("override", vector.override, "zero-speed"),
        ):
            if value <= 0.0:
                words = f"a contour path cannot be run: {table().doing(function)} is {value:.10g}"
                raise Fault(codes.PARAMETER, words, kind=code)
        shape = str(controller.setting(axis.number, "shape"))
        ramp = float(controller.setting(axis.number, "ramp") or 0.0)
        return PathPace(shape, vector.velocity / counts, vector.accel / counts, vector.decel / counts, ramp)

    def _laid(
        self, axes: list[AxisState], start: list[float], ends: list[float]
    ) -> tuple[StraightLine | Arc, float]:
        """Return the path, counts, and its length, user units.

        Raises ValueError if it is invalid.
        """
        here, there = (
            [axis.scale.position_to_user(at) for axis, at in zip(axes, each, strict=True)]
            for each in (start, ends)
        )
        if self._kind in (LINE, USER):
            length = hypot(*(b - a for a, b in zip(here, there, strict=True)))
            if self._kind == USER and self.distance is not None:
                if length and not self.distance:
                    raise ValueError("it has a distance, but a length of 0")
                length = self.distance
            return StraightLine(ends, length), length
        sense = -1 if self._kind == CLOCKWISE else 1
        i, j = plane = self._plane([axis.number for axis in axes])
        first, last = (here[i], here[j]), (there[i], there[j])
        if self.center:
            centre = self.center[axes[i].number], self.center[axes[j].number]
        elif self.radius is not None:
            centre = centre_by_radius(first, last, self.radius, sense)
        else:
            raise ValueError("an arc needs a centre (CA or CR) or a radius (RR)")
        if self.sweep is not None:
            angle = sense * abs(self.sweep)
            last = end_of(first, centre, angle)
        elif self.end_angle is not None:
            angle = angle_until(first, centre, self.end_angle, sense)
            last = end_of(first, centre, angle)
        else:
            centre = centre_between(first, last, centre, sense)
            angle = angle_to(first, last, centre, sense)
        length = radius_of(first, centre) * radians(abs(angle))
        x, y = (axes[k].scale.position_to_counts for k in plane)
        rest = [end for k, end in enumerate(ends) if k not in plane]
        return Arc((x(centre[0]), y(centre[1])), angle, rest, length, plane, (x(last[0]), y(last[1]))), length

    def _plane(self, numbers: list[int]) -> tuple[int, int]:
        """Return the indexes of the two axes of an arc.

        They are the axes with a centre, or the first two of the path if none has one.
        """
        axes = sorted(self.center or numbers)
        if len(axes) < 2:
            raise ValueError("an arc needs two axes")
        if len(axes) > 2:
            raise ValueError("an arc lies in the plane of two axes")
        return numbers.index(axes[0]), numbers.index(axes[1])
