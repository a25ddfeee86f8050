"""Functions that read an axis: positions, status words and their flags."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.controller import AUXILIARY
from motionlang.kernel.mccl import AxisState, Board, Model, aim
from motionlang.kernel.mccl.axis import status
from motionlang_mcapi import table as mc
from motionlang_mcapi.errors import CallRefused
from motionlang_mcapi.registry import at_once, query

if TYPE_CHECKING:
    from motionlang_mcapi.call import ApiCall
    from motionlang_mcapi.interface import Interface
    from motionlang_mcapi.session import HostProcess

# The word and bit of each flag of MCAPI on a MultiFlex; flags 0 to 30 are bits of word 0.
FLAGS: dict[int, tuple[int, int]] = {
    mc.MC_STAT_MODE_VEL: (3, status.MODES["velocity"]),
    mc.MC_STAT_FULL_STEP: (1, status.FULL_STEP),
    mc.MC_STAT_HALF_STEP: (1, status.HALF_STEP),
    mc.MC_STAT_JOGGING: (1, status.JOGGING),
    mc.MC_STAT_PROG_DIR: (1, status.PROGRAMMED_NEGATIVE),
    mc.MC_STAT_RECORD: (1, status.RECORDING),
    mc.MC_STAT_SYNC: (1, status.SYNCHRONISED),
    mc.MC_STAT_INDEX_FOUND: (1, status.INDEX_FOUND),
    mc.MC_STAT_EDGE_FOUND: (1, status.EDGE_FOUND),
    mc.MC_STAT_ACCEL: (2, status.ACCELERATING),
    mc.MC_STAT_STOPPING: (2, status.STOPPING),
    mc.MC_STAT_MODE_POS: (3, status.MODES["position"]),
    mc.MC_STAT_MODE_TRQE: (3, status.MODES["torque"]),
    mc.MC_STAT_MODE_CNTR: (3, status.MODES["contour"]),
    mc.MC_STAT_MODE_ARC: (3, status.ARC),
    mc.MC_STAT_MODE_LIN: (3, status.LINE),
    mc.MC_STAT_MODE_SLAVE: (3, status.SLAVE),
}


def _of_axis(name: str, value: Callable[[Board, AxisState], float]) -> None:
    query(name)(lambda interface, axis: float(value(interface.board, interface.board.axis(axis))))


_of_axis(
    "MCGetPositionEx", lambda board, axis: axis.reported(board.controller.position(axis.number) + axis.shift)
)
_of_axis(
    "MCGetOptimalEx", lambda board, axis: axis.reported(board.controller.demand(axis.number) + axis.shift)
)
_of_axis("MCGetTargetEx", lambda board, axis: axis.reported(aim(board, axis)))
_of_axis(
    "MCGetFollowingError",
    lambda board, axis: axis.reported(board.controller.following_error(axis.number), "uu"),
)
_of_axis(
    "MCGetVelocityActual", lambda board, axis: axis.reported(board.controller.velocity(axis.number), "uu/s")
)
_of_axis("MCGetIndexEx", lambda board, axis: axis.reported(axis.index_position))
_of_axis("MCGetBreakpointEx", lambda board, axis: axis.reported(axis.breakpoint or 0.0))
_of_axis("MCGetAuxEncIdxEx", lambda board, axis: axis.reported(axis.aux_index, "uu"))
_of_axis(
    "MCGetAuxEncPosEx",
    lambda board, axis: axis.reported(
        board.controller.encoder_position(AUXILIARY + axis.number) - axis.aux_zero, "uu"
    ),
)


@query("MCGetContouringCount")
def contouring_count(interface: Interface, axis: int) -> int:
    return interface.board.axis(axis).segments


@query("MCGetStatus")
def primary(interface: Interface, axis: int) -> int:
    return status.word(interface.board, interface.board.axis(axis), 0)[0]


@query("MCGetStatusEx")
def all_words(interface: Interface, axis: int) -> tuple[int, ...]:
    board = interface.board
    words = range(4) if board.model.words else range(1)
    found = tuple(status.word(board, board.axis(axis), which)[0] for which in words)
    return found + (0,) * (4 - len(found))


@at_once("MCDecodeStatus")
def decode(session: HostProcess, call: ApiCall, status: int, bit: int) -> None:
    call.value = _decoded(session.desk.board.model, (status,), bit)


@at_once("MCDecodeStatusEx")
def decode_words(session: HostProcess, call: ApiCall, status: tuple[int, ...], bit: int) -> None:
    call.value = _decoded(session.desk.board.model, status, bit)


def _decoded(model: Model, words: tuple[int, ...], flag: int) -> int:
    """Return a flag of the status words.

    The meaning of bit 2 of word 0 depends on the model.
    """
    if not mc.MC_STAT_BUSY <= flag <= mc.MC_STAT_AUX_IDX_FND:
        raise CallRefused(mc.MCERR_CONSTANT)
    if flag == mc.MC_STAT_AT_TARGET:
        return words[0] >> 2 & 1 if model.at_target else 0
    if flag == mc.MC_STAT_MODE_VEL and not model.at_target:
        return words[0] >> 2 & 1
    if flag in FLAGS:
        which, bits = FLAGS[flag]
        return int(which < len(words) and bool(int(words[which]) & bits))
    return words[0] >> flag & 1 if flag <= mc.MC_STAT_PHASE else 0
