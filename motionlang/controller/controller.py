"""The virtual controller: everything a language may ask of it.

The verbs of single axes are `Core`'s, those that only tell something `Readings`'; here are those of several axes at
once and of what goes on beside motion. Each is a thin door to the module of its family, brought in when first needed.
"""

from __future__ import annotations

from motionlang.controller.core import MAX_MOVES, SETTINGS, Core

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.controller.trace import Trace


class Controller(Core):
    """`axes` axes numbered from `first`, a clock, and the log of every move that was started."""

    # --------------------------------------------------------------------------------------------- paths

    def load_line(
        self, axes: Sequence[int], targets: Sequence[float], command: str = "", line: int = 0
    ) -> None:
        """Put a straight line of several axes to `targets` into their buffers; the first axis is the master."""
        from motionlang.controller import path

        path.load_line(self, axes, targets, command, line)

    def load_line_by(
        self, axes: Sequence[int], distances: Sequence[float], command: str = "", line: int = 0
    ) -> None:
        """Put a straight line of several axes by `distances` into their buffers."""
        from motionlang.controller import path

        path.load_line_by(self, axes, distances, command, line)

    def load_arc(
        self,
        axes: Sequence[int],
        centre: Sequence[float],
        angle: float,
        rest: Sequence[float] = (),
        relative: bool = False,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Put an arc by `angle` degrees into the buffers of its axes, a helix where further axes go to `rest`."""
        from motionlang.controller import path

        path.load_arc(self, axes, centre, angle, rest, relative, command, line)

    def blend(self, axis: int) -> None:
        """Begin the next path of the axis now, on top of what remains of the present one."""
        from motionlang.controller.path import run_of

        run = run_of(self.axes[axis])
        if run is not None:
            run.blend()

    def path_speed(self, axis: int) -> float:
        """The speed along the path that the axis is on, user units/s."""
        from motionlang.controller.path import run_of

        run = run_of(self.axes[axis])
        return run.speed if run is not None else 0.0

    def path_remaining(self, axis: int) -> float:
        """The distance along the path that the axis is on still to go, user units."""
        from motionlang.controller.path import run_of

        run = run_of(self.axes[axis])
        return run.remaining if run is not None else 0.0

    @property
    def trace(self) -> Trace:
        """The motion so far, to be sampled; brings in numpy."""
        from motionlang.controller.trace import Trace

        return Trace(self)


__all__ = ["MAX_MOVES", "SETTINGS", "Controller"]
