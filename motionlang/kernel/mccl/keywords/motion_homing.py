"""Homing to an index mark or a home edge.

FI and FE search at once; IA and EL arm the search, and a later WI or WE waits for it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.lang.steps import DO, TRY, WAIT
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.mccl.axis.inputs import is_active
from motionlang.kernel.mccl.keywords.flow_waits import passing_flag
from motionlang.kernel.mccl.keywords.row import Group, written
from motionlang.kernel.mccl.motion.edge_search import Seek

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import CommandTask
    from motionlang.kernel.mccl.runtime.writer import LineWriter


@written
def find_index(line: LineWriter, command: Command) -> None:
    line.act(DO, _search("index"))
    line.act(TRY, _complete)


@written
def find_edge(line: LineWriter, command: Command) -> None:
    line.act(DO, _search("edge"))
    line.act(TRY, _complete)


def arm_index(task: CommandTask, command: Command) -> None:
    _begin(task, command, "index")


def arm_edge(task: CommandTask, command: Command) -> None:
    _begin(task, command, "edge")


@written
def wait_index(line: LineWriter, command: Command) -> None:
    """Wait for the index mark (WI).

    If IA armed the search, the position at the mark gets the value that IA gave. If nothing is armed, the zero is
    unchanged.
    """
    line.act(TRY, _complete)


@written
def wait_edge(line: LineWriter, command: Command) -> None:
    """Wait for the home input to be on (0) or off (1).

    If an armed edge has been caught, it is applied.
    """
    line.act(WAIT, _until_input)
    line.act(DO, _apply_edge)


def _search(kind: str) -> Callable[[CommandTask, Command], None]:
    def search(task: CommandTask, command: Command) -> None:
        task.search = _begin(task, command, kind)

    return search


def _begin(task: CommandTask, command: Command, kind: str) -> Seek:
    board, axis = task.board, task.axis(command)
    old = board.seeks.pop(axis.number, None)
    if old is not None:
        old.cancel()
    seek = board.seeks[axis.number] = Seek(board, axis, kind, axis.position(float(task.value(command))))
    return seek


def _complete(task: CommandTask, command: Command) -> Wait | None:
    """Wait until the position is caught, then assign its value if the search was armed."""
    board, axis = task.board, task.axis(command)
    seek = task.search
    armed = board.seeks.get(axis.number)
    if seek is None and armed is not None and armed.kind == "index":
        seek = armed
    if seek is None:
        task.search = seek = Seek(board, axis, "index", 0.0)
    if not seek.done:
        what = "the index mark" if seek.kind == "index" else "the home switch"
        return passing_flag(board, lambda: seek.done, f"for {what} of axis {axis.number}")
    task.search = None
    if seek is armed:
        del board.seeks[axis.number]
        seek.apply()
    return None


def _until_input(task: CommandTask, command: Command) -> Wait | None:
    board, axis, wanted = task.board, task.axis(command), not task.value(command)
    if is_active(board, axis, "home") is wanted:
        return None
    return passing_flag(
        board,
        lambda: is_active(board, axis, "home") is wanted,
        f"for the home switch of axis {axis.number} to be {'on' if wanted else 'off'}",
    )


def _apply_edge(task: CommandTask, command: Command) -> None:
    seeks, number = task.board.seeks, task.axis(command).number
    seek = seeks.get(number)
    if seek is not None and seek.kind == "edge" and seek.done:
        del seeks[number]
        seek.apply()


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("motion").row
_flow_row = Group("flow").row


ROWS = (
    _row("FI", "command", "W", "axis", "uu", find_index,
         "Find the index mark: while the axis runs, wait for the mark; there the position becomes this one. "
         "The machine file says where marks are (index_every).",
         "1MN,1VM,1GO,1FI0,1ST", effect="act datum", meant="HOME", waits="axis", topic="home"),
    _row("FE", "command", "W", "axis", "uu", find_edge,
         "Find the edge of the coarse home switch: while the axis runs, wait for it; there the position becomes "
         "this one. The machine file says where the switch is (home_switch).", "1MN,1VM,1GO,1FE0,1ST",
         effect="act datum", meant="HOME", waits="axis", topic="home"),
    _row("IA", "command", "W", "axis", "uu", arm_index,
         "Arm the index capture; complete it with WI, when the position at the mark becomes this one.", "1IA0",
         topic="home"),
    _row("EL", "command", "W", "axis", "uu", arm_edge,
         "Arm the capture of the home edge; complete it with WE, when the position at the edge becomes this one.",
         "1EL0", topic="home"),
    _flow_row("WE", "statement", "W", "axis", "bool", wait_edge,
              "Wait for the coarse home switch: 0 on, 1 off; completes EL.", "1WE1", low=0, high=1,
              effect="act datum", waits="axis", topic="home"),
    _flow_row("WI", "statement", "C", "axis", "", wait_index, "Wait for the index mark; completes IA. "
              "The machine file says where marks are (index_every).",
              "1MN,1MR5000,1IA,1WI", effect="act datum", waits="axis", topic="home"),
)  # fmt: skip
