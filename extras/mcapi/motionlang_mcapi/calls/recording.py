"""Functions for recorded motion, and counts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl import (
    RECORD_PERIOD,
    Command,
    recorded_actual,
    recorded_optimal,
    recorded_output,
    recorded_times,
)
from motionlang_mcapi import table as mc
from motionlang_mcapi.command import command
from motionlang_mcapi.errors import CallRefused
from motionlang_mcapi.registry import commands, query

if TYPE_CHECKING:
    from motionlang_mcapi.interface import Interface

# The kinds of data, with the names of old hosts.
ACTUAL = (mc.MC_CAPTURE_ACTUAL, mc.MC_DATA_ACTUAL)
OPTIMAL = (mc.MC_CAPTURE_OPTIMAL, mc.MC_DATA_OPTIMAL)
ERROR = (mc.MC_CAPTURE_ERROR, mc.MC_DATA_ERROR)
TORQUE = (mc.MC_CAPTURE_TORQUE, mc.MC_DATA_TORQUE)


@commands("MCCaptureData")
def capture(interface: Interface, axis: int, points: int, period: float, delay: float) -> list[Command]:
    return [command("PR", axis, points)]


@query("MCGetCaptureData")
def captured(interface: Interface, axis: int, type: int, start: int, points: int) -> tuple[float, ...]:
    """Return points of a recording; raise Refused unless all of them are recorded."""
    board = interface.board
    times = recorded_times(board, axis)
    if points <= 0 or start < 0 or start + points > len(times):
        raise CallRefused(mc.MCERR_RANGE)
    times = times[start : start + points]
    state = board.axis(axis)
    if type in TORQUE:
        return tuple(recorded_output(board, state, times))
    if type in ACTUAL:
        return tuple(state.reported(each) for each in recorded_actual(board, state, times))
    optimal = recorded_optimal(board, state, times)
    if type in OPTIMAL:
        return tuple(state.reported(each) for each in optimal)
    if type in ERROR:
        actual = recorded_actual(board, state, times)
        return tuple(state.reported(a - b, "uu") for a, b in zip(optimal, actual, strict=True))
    raise CallRefused(mc.MCERR_CONSTANT)


@query("MCGetCaptureSettings")
def capture_settings(interface: Interface, axis: int) -> tuple[int, float, float, int]:
    _, points = interface.board.records.get(axis, (0.0, 0))
    return points, RECORD_PERIOD, 0.0, len(recorded_times(interface.board, axis))


@query("MCGetCount")
def count(interface: Interface, axis: int, type: int) -> int:
    """Return the number of contour paths, or of recorded points."""
    if type == mc.MC_COUNT_CONTOUR:
        return interface.board.axis(axis).segments
    if type == mc.MC_COUNT_RECORD:
        return len(recorded_times(interface.board, axis))
    known = (mc.MC_COUNT_CAPTURE, mc.MC_COUNT_COMPARE, mc.MC_COUNT_FILTER, mc.MC_COUNT_FILTERMAX)
    raise CallRefused(mc.MCERR_NOTSUPPORTED if type in known else mc.MCERR_CONSTANT)
