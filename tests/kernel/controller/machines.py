"""Controllers for tests, with round numbers."""

from __future__ import annotations

from motionlang.kernel import INFINITY, Controller
from motionlang.kernel.controller.motion.follow import FollowMove, check_chain
from motionlang.kernel.controller.motion.offset import offset as begin_offset
from motionlang.kernel.controller.moves.cam import Cam
from motionlang.kernel.controller.moves.path import run_of
from motionlang.kernel.planners.table_motion import table_curve
from tests.kernel.planners.splines import cubic_table


def machine(axes: int = 2, **settings: float | str) -> Controller:
    """Return a controller whose axes have 10 counts/s and 100 counts/s².

    `settings` change the settings of every axis.
    """
    controller = Controller(axes)
    for axis in controller.axes:
        for name, value in {"speed": 10.0, "accel": 100.0, "decel": 100.0, **settings}.items():
            controller.configure(axis, name, value)
    return controller


def until(controller: Controller, time: float) -> Controller:
    """Advance the controller to `time`, s, and return it."""
    controller.clock.advance(time)
    return controller


def remaining(controller: Controller, axis: int) -> float:
    """Return the remaining distance along the present path of an axis, user units."""
    run = run_of(controller.axes[axis])
    assert run is not None
    return run.present.remaining


def cam(
    controller: Controller,
    axis: int,
    master: int,
    positions: list[float],
    values: list[float],
    *,
    smooth: bool = False,
    cyclic: bool = False,
) -> None:
    """Let an axis follow a table over the positions of its master from here, counts."""
    a, tied = controller.movable(axis), controller.axes[master]
    check_chain(a, tied)
    here = a.position(controller.clock.now)
    curve = cubic_table(positions, values, cyclic) if smooth else table_curve(positions, values)
    move = FollowMove(axis, "CAM", 0, "cam", INFINITY if cyclic else here + curve.end)
    controller.end_move(a, "retarget")
    made = Cam(controller, a, tied, move, curve, cyclic, 0)
    made.lift, made.ordered = here, (tuple(positions), tuple(values), "smooth" if smooth else "linear")
    made.engage()


def offset(
    controller: Controller,
    axis: int,
    distance: float,
    mode: int = 0,
    over: float = 0.0,
    command: str = "",
    line: int = 0,
) -> None:
    """Superpose a distance on following, in a mode of OFFSETMODE; at rest move by it."""
    begin_offset(controller, controller.movable(axis), distance, mode, over, command, line)
