"""The motor of an axis: on or off; if simulated, its gains, limits, torque mode.

Only axes with a motor in the machine file have a simulated one.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.errors import Rejected
from motionlang.kernel.mccl.axis.axis import GAIN, TORQUE, AxisState
from motionlang.kernel.mccl.axis.flags import MOTOR_ERROR
from motionlang.kernel.mccl.keywords import tuning

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.board import Board

# The setting of the loop's rate, which three commands set.
_RATE = "kept_rate"
# The settings of an output stage without its loop.
_STAGE = ("proportional", "output_limit", "output_deadband", "output_offset", "reversed")
# The default of SE: counts of following error beyond which an axis trips.
ERROR_LIMIT = 1024.0
# A deadband below this, counts, is taken as the one count that an encoder resolves.
_COUNT = 0.5
FULL_OUTPUT = 10.0


def check_on(board: Board, axis: AxisState) -> None:
    """Raise Rejected if the axis is off, or has tripped without MN since."""
    if axis.flags & MOTOR_ERROR:
        raise Rejected("disabled-axis", f"axis {axis.number} has tripped and accepts no motion command")
    if not board.controller.is_enabled(axis.number):
        raise Rejected("disabled-axis", f"axis {axis.number} is off")


def power_up(board: Board, axis: AxisState) -> None:
    """Apply the settings at power-up."""
    number, controller = axis.number, board.controller
    if controller.axes[number].feedback is None:
        return
    controller.set_servo_model(number, "dcx" if board.model.whole_gains else "multiflex")
    tune(board, axis)
    limit_error(board, axis)
    settle(board, axis)


def tune(board: Board, axis: AxisState) -> None:
    """Apply the gains set by the program to the servo loop."""
    controller, number = board.controller, axis.number
    if controller.axes[number].feedback is None:
        return
    stored = {**axis.stored, "kept_torque": _largest_output(axis)}
    if axis.reversed_phase:
        stored["output_phase"] = 1.0
    gains = {row.tunes: (stored[row.function], row.name) for row in tuning() if row.function in stored}
    if axis.mode == GAIN:
        gains = {quantity: gain for quantity, gain in gains.items() if quantity in _STAGE}
    if _RATE in stored:
        gains["rate"] = stored[_RATE], "the rate"
    controller.set_gains(number, gains)
    if axis.mode == TORQUE:
        drive(board, axis)


def limit_error(board: Board, axis: AxisState) -> None:
    """Set the following error, counts, that switches the motor off; 0 for none (SE)."""
    limit = axis.stored.get("kept_error_limit", ERROR_LIMIT)
    board.controller.set_error_limit(axis.number, limit or INFINITY)


def settle(board: Board, axis: AxisState) -> None:
    """Set how near its target, and for how long, a motor has to be (DB, DT)."""
    error = max(axis.deadband, _COUNT)
    board.controller.settle_within(axis.number, error, INFINITY, axis.deadband_delay, True)


def drive(board: Board, axis: AxisState) -> None:
    """Set the output to SQ, in the direction of DI (torque mode)."""
    controller, number = board.controller, axis.number
    if controller.axes[number].feedback is not None and controller.is_enabled(number):
        controller.open_loop(number, axis.direction * _largest_output(axis))


def _largest_output(axis: AxisState) -> float:
    """Return SQ in volts, limited to the full output."""
    return min(axis.stored.get("kept_torque", FULL_OUTPUT), FULL_OUTPUT)


def torque(axis: AxisState) -> float:
    """Return SQ in the user units of torque (UK)."""
    return axis.stored.get("kept_torque", FULL_OUTPUT) / axis.constant


def changed_mode(board: Board, axis: AxisState, before: str) -> None:
    """Update the servo loop after a change of mode; `before` is the old mode."""
    if board.controller.axes[axis.number].feedback is None or axis.mode == before:
        return
    if before == TORQUE and board.controller.is_enabled(axis.number):
        board.controller.close_loop(axis.number)
    if GAIN in (axis.mode, before):
        tune(board, axis)
    if axis.mode == TORQUE:
        drive(board, axis)
