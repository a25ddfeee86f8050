"""Recording of motion, computed when it is reported.

Nothing is sampled while the machine runs.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Actions
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.axis import AxisState, real
from motionlang.kernel.mccl.axis.status import RECORD_PERIOD
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.board import Board
    from motionlang.kernel.mccl.runtime.task import Action, CommandTask


def record(task: CommandTask, command: Command) -> None:
    """Record n points from now on; 0 ends a recording."""
    count, now = task.whole(command), task.board.controller.clock.now
    for axis in task.axes(command):
        old = task.board.records.get(axis.number)
        if count:
            task.board.records[axis.number] = (now, count)
            axis.recorded_play = None if axis.play is None else axis.play.copied()
        elif old is not None:
            start, most = old
            task.board.records[axis.number] = (start, min(most, _taken(now - start, most)))


def _teller(reader: Callable[[CommandTask, AxisState, list[float]], list[str]]) -> Action:
    def tell(task: CommandTask, command: Command) -> None:
        wanted = task.whole(command)
        for axis in task.axes(command):
            if axis.number not in task.board.records:
                if command.axis:
                    raise Fault(
                        codes.PARAMETER,
                        f"nothing was recorded of axis {axis.number}",
                        f"{axis.number}PR100 records 100 points",
                    )
                continue
            times = recorded_times(task.board, axis.number)
            for text in reader(task, axis, times[:wanted] if wanted else times):
                task.tell(axis.number, text)

    return tell


def recorded_times(board: Board, axis: int) -> list[float]:
    """Return the machine times of the points recorded so far of an axis.

    Empty without a recording.
    """
    if axis not in board.records:
        return []
    start, most = board.records[axis]
    return [start + k * RECORD_PERIOD for k in range(_taken(board.controller.clock.now - start, most))]


def _taken(elapsed: float, most: int) -> int:
    return min(most, int(elapsed / RECORD_PERIOD + 1e-9) + 1)


def recorded_optimal(board: Board, axis: AxisState, times: list[float]) -> list[float]:
    """Return the optimal positions of the motor at recorded times, counts."""
    a = board.controller.axes[axis.number]
    return _of_motor(axis, times, [a.position(time) for time in times])


def recorded_actual(board: Board, axis: AxisState, times: list[float]) -> list[float]:
    """Return the actual positions of the motor at recorded times, counts."""
    return _of_motor(axis, times, _recalled(board, axis, "actual", times))


def recorded_output(board: Board, axis: AxisState, times: list[float]) -> list[float]:
    """Return the outputs to the motor at recorded times, volts."""
    return _recalled(board, axis, "output", times)


def _recalled(board: Board, axis: AxisState, quantity: str, times: list[float]) -> list[float]:
    from motionlang.kernel.tracks.history import recall

    return recall(board.controller, axis.number, quantity, times)


def _of_motor(axis: AxisState, times: list[float], positions: list[float]) -> list[float]:
    """Add what the motor led the load by, as TP and TO do."""
    if axis.recorded_play is None:
        return positions
    shifts = axis.recorded_play.shifts(times)
    return [position + shift for position, shift in zip(positions, shifts, strict=True)]


def _optimal(task: CommandTask, axis: AxisState, times: list[float]) -> list[str]:
    return [task.quantity(axis, counts) for counts in recorded_optimal(task.board, axis, times)]


def _actual(task: CommandTask, axis: AxisState, times: list[float]) -> list[str]:
    return [task.quantity(axis, counts) for counts in recorded_actual(task.board, axis, times)]


def _torque(task: CommandTask, axis: AxisState, times: list[float]) -> list[str]:
    return [real(volts) for volts in recorded_output(task.board, axis, times)]


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("motion").row
_reports_row = Group("reports").row


ROWS = (
    _row("PR", "command", "W", "axes", "number", record,
         "Record n points of the motion, one every millisecond, read out with DO, DR and DQ.", "1PR100",
         low=0, high=10000),
    _reports_row("DO", "reading", "R", "axes", "uu", Actions("tell_recorded_optimal", do=_teller(_optimal)),
                 "Tell n recorded optimal positions, one a line; 0 for all of them.",
                 "1MN,1PR5,1MR50,1WS,1DO0", low=0),
    _reports_row("DR", "reading", "R", "axes", "uu", Actions("tell_recorded_actual", do=_teller(_actual)),
                 "Tell n recorded actual positions, one a line; 0 for all of them.",
                 "1MN,1PR5,1MR50,1WS,1DR0", low=0),
    _reports_row("DQ", "reading", "R", "axes", "number", Actions("tell_recorded_torque", do=_teller(_torque)),
                 "Tell n recorded outputs in volts, one a line; 0 V without a simulated motor.",
                 "1MN,1PR5,1MR50,1WS,1DQ0", low=0),
)  # fmt: skip
