"""The status words: the meaning of each bit and its computation.

Word 0 has the flags of MCAPI's MC_STAT list by their numbers, 0 to 30. The flags above 30 are in the
auxiliary, profile and mode words of a MultiFlex. Their bits there are our choice (docs/contributing/assumptions.md).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.axis import CONTOUR, GAIN, POSITION, TORQUE, VELOCITY, AxisState
from motionlang.kernel.mccl.axis.flags import (
    AMPLIFIER_ON,
    AT_TARGET,
    DIRECTION,
    INDEX_INPUT,
    INPUTS,
    MOTOR_ON,
    PHASE,
    REACHED,
    TRAJECTORY_COMPLETE,
    VELOCITY_MODE,
)
from motionlang.kernel.mccl.axis.inputs import active_bits, index_input
from motionlang.kernel.mccl.axis.motion_phase import at_target_time, is_backward, next_reversal, phase
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.models import elsewhere

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.board import Board


# The bits of the primary word that may change without an event or a command. An axis comes to rest by an event.
VOLATILE = AT_TARGET | DIRECTION | INDEX_INPUT
# Bits of the mode word.
MODES = {POSITION: 1, VELOCITY: 2, TORQUE: 4, GAIN: 8, CONTOUR: 16}
ARC, LINE, SLAVE = 32, 64, 128
# Bits of the profile word; the shapes have the numbers of MCAPI's constants.
SHAPES = {"trapezoid": 1, "sinusoidal": 2, "scurve": 2, "parabolic": 4}
ACCELERATING, STOPPING = 8, 16
# Bits of the auxiliary word.
FULL_STEP, HALF_STEP, JOGGING, PROGRAMMED_NEGATIVE = 1, 2, 4, 1 << 10
RECORDING, SYNCHRONISED = 1 << 12, 1 << 13
INDEX_FOUND, EDGE_FOUND = 1 << 15, 1 << 18
# Motion is recorded at the period of the trajectory: 1 kHz (TN1069).
RECORD_PERIOD = 1e-3


def word(board: Board, axis: AxisState, which: int) -> tuple[int, float]:
    """Return a status word, and the time until which it is valid.

    The time applies if no event and no command comes before.
    """
    if which == 0:
        return _primary(board, axis)
    if not board.model.words:
        message = f"the {board.model.title} has one status word"
        raise Fault(codes.PARAMETER, message, elsewhere(lambda each: each.words), "range")
    return (_auxiliary, _profile, _mode)[which - 1](board, axis)


def _primary(board: Board, axis: AxisState) -> tuple[int, float]:
    controller, number = board.controller, axis.number
    a = controller.axes[number]
    bits, until = axis.flags, INFINITY
    if a.enabled:
        bits |= MOTOR_ON | AMPLIFIER_ON
    if axis.reversed_phase:
        bits |= PHASE
    if axis.breakpoint_reached:
        bits |= REACHED
    if board.is_complete(axis):
        bits |= TRAJECTORY_COMPLETE
    else:
        until = next_reversal(controller, number)
    if is_backward(controller, number):
        bits |= DIRECTION
    if board.model.at_target:
        time = at_target_time(board, axis)
        if time <= controller.clock.now:
            bits |= AT_TARGET
        else:
            until = min(until, time)
    elif axis.mode == VELOCITY:
        bits |= VELOCITY_MODE
    bits |= active_bits(board, axis, INPUTS)
    if a.index_every:
        on, leaves = index_input(board, axis)
        until = min(until, leaves)
        if on:
            bits |= INDEX_INPUT
    return bits, until


def _auxiliary(board: Board, axis: AxisState) -> tuple[int, float]:
    bits, until = HALF_STEP if axis.half_steps else FULL_STEP, INFINITY
    if axis.jogging:
        bits |= JOGGING
    if axis.direction < 0:
        bits |= PROGRAMMED_NEGATIVE
    if axis.number in board.records:
        start, count = board.records[axis.number]
        end = start + (count - 1) * RECORD_PERIOD
        if board.controller.clock.now < end:
            bits, until = bits | RECORDING, end
    if axis.synchronised:
        bits |= SYNCHRONISED
    if axis.index_found:
        bits |= INDEX_FOUND
    if axis.edge_found:
        bits |= EDGE_FOUND
    return bits, until


def _profile(board: Board, axis: AxisState) -> tuple[int, float]:
    controller, number = board.controller, axis.number
    bits = SHAPES[str(controller.setting(number, "shape"))]
    if controller.is_at_standstill(number):
        return bits, INFINITY
    name, until = phase(controller, number)
    if name == "accel":
        bits |= ACCELERATING
    elif name == "stop":
        bits |= STOPPING
    return bits, until


def _mode(board: Board, axis: AxisState) -> tuple[int, float]:
    bits = MODES[axis.mode]
    if axis.on_arc:
        bits |= ARC
    elif axis.on_line:
        bits |= LINE
    if board.controller.master_of(axis.number) is not None:
        bits |= SLAVE
    return bits, INFINITY
