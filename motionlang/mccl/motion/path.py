"""A contour path while the commands of a line describe it: CP opens it, the first other command closes it."""

from __future__ import annotations

from math import radians

from motionlang.mccl import codes
from motionlang.mccl.axis.axis import CONTOUR
from motionlang.mccl.codes import Fault
from motionlang.mccl.motion.segment import (
    Segment,
    VectorMotion,
    arc_by_angle,
    arc_to,
    center_by_radius,
    line,
    sweep_to_angle,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.motion.contour import Contour
    from motionlang.mccl.runtime.task import CommandTask

USER, LINE, CLOCKWISE, ANTICLOCKWISE = range(4)
# The verbs that describe a path rather than end its description.
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
    """What is known so far: user units and degrees, by axis number."""

    __slots__ = (
        "_axis",
        "_contour",
        "_kind",
        "_line",
        "center",
        "distance",
        "end_angle",
        "radius",
        "sweep",
        "targets",
    )

    def __init__(self, axis: AxisState, contour: Contour, kind: int, line: int) -> None:
        self._axis, self._contour, self._kind, self._line = axis, contour, kind, line
        self.targets: dict[int, float] = {}
        self.center: dict[int, float] = {}
        self.end_angle: float | None = None
        self.sweep: float | None = None
        self.radius: float | None = None
        self.distance: float | None = None

    def end_of(self, axis: AxisState) -> float:
        """Where the axis is before this path, counts."""
        return axis.scale.position_to_counts(self._contour.end(axis))

    def member(self, axis: AxisState) -> None:
        """Fault unless the axis is in contour mode under the controlling axis."""
        if axis.mode != CONTOUR or axis.controlling != self._axis.number:
            raise Fault(
                codes.NOT_ASSIGNED,
                f"axis {axis.number} is not in contour mode under axis {self._axis.number}",
                f"{axis.number}CM{self._axis.number} puts it there",
                "axis",
            )

    def move(self, task: CommandTask, targets: list[tuple[AxisState, float]]) -> None:
        """MA and MR say where the axes end, counts."""
        for axis, target in targets:
            self.member(axis)
            if axis.number in self.targets:
                raise Fault(
                    codes.ASSIGNED_TWICE,
                    f"axis {axis.number} has an end point in this path already",
                    "each path has a CP of its own",
                    "axis",
                )
            if not task.board.controller.is_enabled(axis.number):
                raise Fault(
                    codes.INVALID,
                    f"axis {axis.number} is off",
                    f"{axis.number}MN switches it on",
                    "disabled-axis",
                )
            self.targets[axis.number] = axis.scale.position_to_user(target)

    def close(self, task: CommandTask) -> None:
        """The path is described: queue it. Fault where it makes no sense."""
        board = task.board
        axes = [board.axes[number] for number in sorted({*self.targets, *self.center})]
        if not axes:
            raise Fault(
                codes.PARAMETER, "the contour path goes nowhere", "MA or MR after CP say where", "values"
            )
        for axis in axes:
            self.member(axis)
            if not board.controller.is_enabled(axis.number):
                raise Fault(
                    codes.INVALID,
                    f"axis {axis.number} is off",
                    f"{axis.number}MN switches it on",
                    "disabled-axis",
                )
        start = {axis.number: self._contour.end(axis) for axis in axes}
        end = {**start, **self.targets}
        try:
            segment = self._segment(start, end, self._motion(task))
            segment.fix({axis.number: axis.scale for axis in axes})
            self._contour.add(segment, self._line)
        except ValueError as problem:
            raise Fault(codes.PARAMETER, f"the contour path cannot be run: {problem}", kind="range") from None

    def _motion(self, task: CommandTask) -> VectorMotion:
        """The vector settings of the controlling axis, in its user units."""
        axis, controller = self._axis, task.board.controller
        counts, vector = abs(axis.scale.counts), axis.vector
        for name, value in (
            ("VV", vector.velocity),
            ("VA", vector.accel),
            ("VD", vector.decel),
            ("VO", vector.override),
        ):
            if value <= 0.0:
                code = "zero-speed" if name in ("VV", "VO") else "zero-acceleration"
                raise Fault(codes.PARAMETER, f"a contour path cannot be run: {name} is {value:g}", kind=code)
        shape = str(controller.setting(axis.number, "shape"))
        ramp = float(controller.setting(axis.number, "ramp") or 0.0)
        return VectorMotion(
            shape, ramp, vector.velocity / counts, vector.accel / counts, vector.decel / counts
        )

    def _segment(self, start: dict[int, float], end: dict[int, float], motion: VectorMotion) -> Segment:
        if self._kind == LINE:
            return line(start, end, motion)
        if self._kind == USER:
            return line(start, end, motion, self.distance)
        turn = -1 if self._kind == CLOCKWISE else 1
        plane = self._plane(end)
        center = self._center(start, end, plane, turn)
        if self.sweep is not None:
            return arc_by_angle(start, end, motion, plane, center, turn * radians(abs(self.sweep)))
        if self.end_angle is not None:
            sweep = sweep_to_angle(start, plane, center, self.end_angle, turn)
            return arc_by_angle(start, end, motion, plane, center, sweep)
        return arc_to(start, end, motion, plane, center, turn)

    def _plane(self, end: dict[int, float]) -> tuple[int, int]:
        """The two axes that go round: those with a centre, else the first two of the path."""
        axes = sorted(self.center or end)
        if len(axes) < 2:
            raise ValueError("an arc needs two axes")
        if len(axes) > 2:
            raise ValueError("an arc lies in the plane of two axes")
        return axes[0], axes[1]

    def _center(
        self, start: dict[int, float], end: dict[int, float], plane: tuple[int, int], turn: int
    ) -> tuple[float, float]:
        if self.center:
            return self.center[plane[0]], self.center[plane[1]]
        if self.radius is not None:
            return center_by_radius(start, end, plane, self.radius, turn)
        raise ValueError("an arc needs a centre (CA or CR) or a radius (RR)")
