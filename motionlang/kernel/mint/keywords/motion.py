"""Loading moves, starting them, and cancelling them."""

from __future__ import annotations

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.runtime.binding import Maker, Operation, no_axis, on_axes, on_every_axis, scale_of
from motionlang.kernel.mint.runtime.environment import Environment


def load_move(relative: bool) -> Maker:
    """Make an operation that loads a move; it returns True while the buffer is full.

    The value is a distance if `relative`, else a position.
    """

    def made(environment: Environment, row: Keyword) -> Operation:
        controller, name = environment.controller, row.name

        def load(axis: int, value: float, line: int) -> bool:
            scale = scale_of(environment, axis)
            finite(row, value)
            refuse_stopping(environment, axis)
            if controller.room(axis) <= 0:
                return True
            if relative:
                controller.load_by(axis, value * scale.counts, name, line)
            else:
                controller.load_to(axis, environment.absolute_counts(axis, value), name, line)
            if environment.loaded is not None:
                environment.loaded(axis)
            return False

        return load

    return made


def refuse_stopping(environment: Environment, axis: int) -> None:
    """Raise Rejected (Mint's error 236) if the axis is stopping."""
    move = environment.controller.axes[axis].move
    if move is not None and move.ended in ("stop", "fault"):
        raise Rejected(
            "stopping", f"axis {axis} is stopping", f"PAUSE IDLE({axis}) waits until it is at rest"
        )


def finite(row: Keyword, value: float) -> None:
    """Raise Rejected if a distance is infinite."""
    if not -1e300 < value < 1e300:
        raise Rejected("range", f"{row.word} cannot be {value:.10g}", "a move needs a finite distance")


def do_go(environment: Environment, row: Keyword) -> Operation:
    """GO: start the axes; if one does not exist or cannot be moved, none starts."""
    known, start = environment.controller.axes, environment.controller.go

    def go(axes: tuple[int, ...], line: int) -> None:
        for axis in axes:
            if axis not in known:
                raise no_axis(environment, axis)
        start(axes)

    return go


def cancel(environment: Environment, axis: int) -> None:
    """Cancel motion, empty the buffer and clear the errors."""
    environment.controller.abort(axis)
    environment.controller.clear_faults(axis)


# ------------------------------------------------------------------------------------------------- keywords


ROWS = (
    Keyword("MOVER", "MR", "move", "W", "axis", "uu", Actions(load=load_move(True)),
            "Load a move by a distance, counted from the end of the move before it; GO starts it.",
            "MOVER(0) = 12\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0)", group="motion", effect="move relative",
            meant="MOVE MOVEREL MOVEINC G0 G00 G1 G01"),
    Keyword("MOVEA", "MA", "move", "W", "axis", "uu", Actions(load=load_move(False)),
            "Load a move to a position; GO starts it.",
            "MOVEA(0) = 100\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0)", group="motion", effect="move",
            meant="MOVE MOVEABS MOVETO G0 G00 G1 G01"),
    Keyword("GO", "", "command", "C", "axes", "", Actions(do=do_go),
            "Start all moves in the buffers of the axes, together.",
            "MOVER(0, 1) = 10, 20\nGO(0, 1)\nPAUSE IDLE(0) And IDLE(1)\nPRINT POS(1)", group="motion", effect="go",
            meant="START BEGIN EXECUTE"),
    Keyword("CANCEL", "CN", "command", "C", "axes", "", Actions(do=on_axes(cancel)),
            "Stop the axes at once, empty their buffers and clear their errors.",
            "JOG(0) = 100\nWAIT = 500\nCANCEL(0)\nPRINT IDLE(0)", group="motion", effect="stop abrupt",
            meant="HALT"),
    Keyword("CANCELALL", "CNA", "command", "C", "none", "", Actions(do=on_every_axis(cancel)),
            "CANCEL for every axis.",
            "JOG(0) = 100\nWAIT = 500\nCANCELALL\nPRINT IDLE(0)", group="motion", effect="stop abrupt all"),
)  # fmt: skip
