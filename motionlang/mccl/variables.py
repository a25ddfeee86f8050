"""The variables of an axis that a program can look up by name and read by address.

The names are ours where no source gives them (docs/fidelity.md); the addresses are ours throughout, and an address of
one board is none of another's: programs look them up.
"""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.codes import Fault
from motionlang.mccl.status import word

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mccl.axis import AxisState
    from motionlang.mccl.board import Board

    # The value, and the time until which it stays without an event to tell of a change.
    Reading = Callable[[Board, AxisState], tuple[float | int, float]]

INFINITY = float("inf")
FIRST, STEP = 0x100, 4


def _word(which: int) -> Reading:
    return lambda board, axis: word(board, axis, which)


def _position(board: Board, axis: AxisState) -> tuple[float, float]:
    return _moving(board, axis, board.controller.position(axis.number))


def _optimal(board: Board, axis: AxisState) -> tuple[float, float]:
    return _moving(board, axis, board.controller.demand(axis.number))


def _velocity(board: Board, axis: AxisState) -> tuple[float, float]:
    return _moving(board, axis, board.controller.velocity(axis.number))


def _following(board: Board, axis: AxisState) -> tuple[float, float]:
    return _moving(board, axis, board.controller.following_error(axis.number))


def _target(board: Board, axis: AxisState) -> tuple[float, float]:
    target = board.controller.target(axis.number)
    return (target, INFINITY) if abs(target) < INFINITY else _position(board, axis)


def _index(board: Board, axis: AxisState) -> tuple[float, float]:
    return axis.index_position, INFINITY


def _segments(board: Board, axis: AxisState) -> tuple[float, float]:
    return axis.segments, INFINITY


def _moving(board: Board, axis: AxisState, value: float) -> tuple[float, float]:
    """A value that changes as long as the axis moves."""
    controller = board.controller
    return value, INFINITY if controller.is_still(axis.number) else controller.clock.now


_READINGS: dict[str, Reading] = {
    "STATUS": _word(0),
    "AUXSTATUS": _word(1),
    "PROFILE": _word(2),
    "MODE": _word(3),
    "POSITION": _position,
    "OPTIMAL": _optimal,
    "TARGET": _target,
    "VELOCITY": _velocity,
    "ERROR": _following,
    "INDEX": _index,
    "SEGMENT": _segments,
}

NAMES: dict[str, int] = {name: FIRST + STEP * k for k, name in enumerate(_READINGS)}
_BY_ADDRESS = {NAMES[name]: reading for name, reading in _READINGS.items()}


def read(board: Board, axis: AxisState, address: int) -> tuple[float | int, float]:
    """The variable at an address, and the time until which it is sure to stay; positions and speeds in counts."""
    reading = _BY_ADDRESS.get(address)
    if reading is None:
        raise Fault(
            codes.PARAMETER,
            f"there is nothing to read at address {address}",
            'LU"STATUS" finds an address',
            "range",
        )
    return reading(board, axis)
