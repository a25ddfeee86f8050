"""Variables of an axis: a program looks up names and reads and writes addresses.

The names are ours unless a source gives them (docs/contributing/assumptions.md). The addresses are all ours. An
address of one board is not valid on another, so programs look them up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import ceil, floor
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.motion.encoder import AUXILIARY
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis import motor
from motionlang.kernel.mccl.axis.axis import AxisState
from motionlang.kernel.mccl.axis.launch import aim
from motionlang.kernel.mccl.axis.status import VOLATILE, word
from motionlang.kernel.mccl.codes import Fault

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.board import Board

    # The value, and the time until which it is valid without a notifying event.
    Reader = Callable[[Board, AxisState], tuple[float | int, float]]
    Writing = Callable[[Board, AxisState, float], None]

FIRST, STEP = 0x100, 4


def _word(which: int) -> Reader:
    return lambda board, axis: word(board, axis, which)


def _moving(value: Callable[[Board, AxisState], float]) -> Reader:
    def read_moving(board: Board, axis: AxisState) -> tuple[float, float]:
        controller = board.controller
        return value(board, axis), INFINITY if controller.is_still(axis.number) else controller.clock.now

    return read_moving


_aimed = _moving(aim)


def _target(board: Board, axis: AxisState) -> tuple[float, float]:
    if abs(board.controller.target(axis.number)) < INFINITY:
        return aim(board, axis), INFINITY
    return _aimed(board, axis)


def _setting(name: str) -> Reader:
    """Return the reader of a motion setting, in counts and seconds."""
    return lambda board, axis: (float(board.controller.setting(axis.number, name) or 0.0), INFINITY)


def _of(name: str) -> Reader:
    """Return the reader of an attribute of the axis state."""
    return lambda board, axis: (float(getattr(axis, name)), INFINITY)


def _stored_value(name: str, default: float) -> Reader:
    return lambda board, axis: (axis.stored.get(name, default), INFINITY)


def _auxiliary(board: Board, axis: AxisState) -> tuple[float, float]:
    counted = board.controller.encoder_position(AUXILIARY + axis.number) - axis.aux_zero
    moving = board.controller.encoder_velocity(AUXILIARY + axis.number) != 0.0
    return counted, board.controller.clock.now if moving else board.controller.clock.next_time()


def _write_setting(name: str) -> Writing:
    def write_setting(board: Board, axis: AxisState, value: float) -> None:
        board.controller.configure(axis.number, name, value)
        if name == "accel" and not board.model.separate_decel:
            board.controller.configure(axis.number, "decel", value)

    return write_setting


def _write(name: str) -> Writing:
    return lambda board, axis, value: setattr(axis, name, value)


def _write_limit(name: str) -> Writing:
    def write_limit(board: Board, axis: AxisState, value: float) -> None:
        setattr(axis, name, value)
        board.limits[axis.number].set_soft_limits()

    return write_limit


def _write_deadband(board: Board, axis: AxisState, value: float) -> None:
    axis.deadband = value
    motor.settle(board, axis)


def _write_auxiliary(board: Board, axis: AxisState, value: float) -> None:
    axis.aux_zero = board.controller.encoder_position(AUXILIARY + axis.number) - value


_READERS: dict[str, Reader] = {
    "STATUS": _word(0),
    "AUXSTATUS": _word(1),
    "PROFILE": _word(2),
    "MODE": _word(3),
    "POSITION": _moving(lambda board, axis: board.controller.position(axis.number) + axis.shift),
    "OPTIMAL": _moving(lambda board, axis: board.controller.demand(axis.number) + axis.shift),
    "TARGET": _target,
    "VELOCITY": _moving(lambda board, axis: board.controller.velocity(axis.number)),
    "ERROR": _moving(lambda board, axis: board.controller.following_error(axis.number)),
    "INDEX": lambda board, axis: (axis.index_position, INFINITY),
    "SEGMENT": lambda board, axis: (axis.segments, INFINITY),
    "SPEED": _setting("speed"),
    "ACCEL": _setting("accel"),
    "DECEL": _setting("decel"),
    "MINSPEED": _of("minimum"),
    "DEADBAND": _of("deadband"),
    "HIGHLIMIT": _of("soft_high"),
    "LOWLIMIT": _of("soft_low"),
    "BACKLASH": _of("backlash"),
    "AUXPOSITION": _auxiliary,
    "AUXINDEX": _of("aux_index"),
    "OUTPUTMODE": _stored_value("output_mode", 0.0),
    "INPUTMODE": _stored_value("input_mode", 0.0),
    "ENCODERSCALE": _stored_value("encoder_scaling", 1.0),
    "CURRENT": _stored_value("current", 1.0),
    "LOOPRATE": _stored_value("kept_rate", 4000.0),
}

NAMES: dict[str, int] = {name: FIRST + STEP * k for k, name in enumerate(_READERS)}
_BY_ADDRESS = {NAMES[name]: reader for name, reader in _READERS.items()}


def changes_by_event(board: Board, address: int, bits: Iterable[int]) -> bool:
    """True if only events or commands change these bits of a variable."""
    return address == NAMES["STATUS"] and not any(VOLATILE >> bit & 1 for bit in bits)


def crossing_time(board: Board, axis: AxisState, address: int, level: float) -> float:
    """Return when the variable at an address will next be `level`, counts or counts/s.

    Returns the current time if this is unknown.
    """
    controller, number = board.controller, axis.number
    if address == NAMES["AUXPOSITION"]:
        return controller.encoder_crossing_time(AUXILIARY + number, level + axis.aux_zero)
    if address == NAMES["POSITION"] and axis.play is None:
        return controller.crossing_time(number, level)
    if address == NAMES["OPTIMAL"] and axis.play is None:
        return controller.demand_crossing_time(number, level)
    if address == NAMES["VELOCITY"]:
        return controller.velocity_crossing_time(number, level)
    if address == NAMES["ERROR"]:
        return controller.error_crossing_time(number, level)
    return controller.clock.now


def levels(test: str, limit: float, is_whole: bool) -> tuple[float, ...]:
    """Return the levels of a reading at which the result of comparing it with `limit` changes.

    `test` is the function of the comparison. A reading that `is_whole` has lost its fraction.
    """
    if not is_whole:
        return (limit,)
    if test == "if_greater":
        firsts = [floor(limit) + 1]
    elif test == "if_below":
        firsts = [ceil(limit)]
    else:
        firsts = [int(limit), int(limit) + 1] if limit == floor(limit) else []
    # A whole number above 0 is read from itself on, one up to 0 from above the number before it on.
    return tuple([float(first if first > 0 else first - 1) for first in firsts])


# The variables that can be written, with their writers; all others are read-only.
_WRITINGS: dict[str, Writing] = {
    "POSITION": lambda board, axis, value: board.define_position(axis, value - axis.shift),
    "SPEED": _write_setting("speed"),
    "ACCEL": _write_setting("accel"),
    "DECEL": _write_setting("decel"),
    "MINSPEED": _write("minimum"),
    "DEADBAND": _write_deadband,
    "HIGHLIMIT": _write_limit("soft_high"),
    "LOWLIMIT": _write_limit("soft_low"),
    "BACKLASH": lambda board, axis, value: axis.set_backlash(value),
    "AUXPOSITION": _write_auxiliary,
}
_SIGNED = frozenset({"POSITION", "HIGHLIMIT", "LOWLIMIT", "AUXPOSITION"})


def write(board: Board, axis: AxisState, address: int, value: float) -> None:
    """Write the variable at an address, in counts and seconds.

    The effect is the same as that of the corresponding command.
    """
    name = next((each for each, base in NAMES.items() if base == address), "")
    writing = _WRITINGS.get(name)
    if writing is None:
        known = ", ".join(_WRITINGS)
        what = f"{name} can only be read" if name else f"address {address} cannot be written"
        raise Fault(codes.PARAMETER, what, f"these can be written: {known}", "range")
    if name not in _SIGNED and value < 0.0:
        raise Fault(codes.PARAMETER, f"{name} accepts 0 or more, not {value:.10g}", kind="range")
    writing(board, axis, value)


def read(board: Board, axis: AxisState, address: int) -> tuple[float | int, float]:
    """Return the variable at an address, and the time until which it is valid.

    Positions and speeds are in counts.
    """
    reader = _BY_ADDRESS.get(address)
    if reader is None:
        raise Fault(
            codes.PARAMETER,
            f"address {address} cannot be read",
            'find an address with LU"STATUS"',
            "range",
        )
    return reader(board, axis)
