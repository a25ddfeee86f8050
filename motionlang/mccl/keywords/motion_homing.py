"""Homing: find the index mark or the home edge now (FI, FE), or arm the search and wait later (IA + WI, EL + WE)."""

from __future__ import annotations

from motionlang.lang.task import Wait
from motionlang.mccl.axis.inputs import is_active
from motionlang.mccl.keywords.flow_waits import passing_flag
from motionlang.mccl.motion.edge_search import Seek

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask

INFINITY = float("inf")


def find_index(task: CommandTask, command: Command) -> Wait | None:
    return _complete(task, task.axis(command), _begin(task, command, "index"))


def find_edge(task: CommandTask, command: Command) -> Wait | None:
    return _complete(task, task.axis(command), _begin(task, command, "edge"))


def arm_index(task: CommandTask, command: Command) -> None:
    _begin(task, command, "index")


def arm_edge(task: CommandTask, command: Command) -> None:
    _begin(task, command, "edge")


def wait_index(task: CommandTask, command: Command) -> Wait | None:
    """WI: wait for the index mark; one that was armed by IA gives the position its value."""
    axis = task.axis(command)
    seek = task.board.seeks.get(axis.number)
    if seek is None or seek.kind != "index":
        # Nothing is armed: the next mark is waited for, and the zero stays.
        seek = Seek(task.board, axis, "index", 0.0)
        return _until_caught(task, axis, seek)
    return _complete(task, axis, seek)


def wait_edge(task: CommandTask, command: Command) -> Wait | None:
    """Wait for the home input, 0 on or 1 off; an armed edge that has been caught is applied."""
    board, axis = task.board, task.axis(command)
    wanted = not task.value(command)

    def finish(now: float) -> None:
        seek = board.seeks.get(axis.number)
        if seek is not None and seek.kind == "edge" and seek.done:
            del board.seeks[axis.number]
            seek.apply()

    if is_active(board, axis, "home") is wanted:
        finish(board.controller.clock.now)
        return None
    task.then = finish
    return passing_flag(
        board,
        lambda: is_active(board, axis, "home") is wanted,
        f"for the home switch of axis {axis.number} to be {'on' if wanted else 'off'}",
    )


def _begin(task: CommandTask, command: Command, kind: str) -> Seek:
    board, axis = task.board, task.axis(command)
    old = board.seeks.pop(axis.number, None)
    if old is not None:
        old.cancel()
    seek = board.seeks[axis.number] = Seek(board, axis, kind, axis.position(float(task.value(command))))
    return seek


def _complete(task: CommandTask, axis: AxisState, seek: Seek) -> Wait | None:
    """Wait until the position is caught, and give it its value."""
    board = task.board

    def finish(now: float) -> None:
        board.seeks.pop(axis.number, None)
        if seek.done:
            seek.apply()

    if seek.done:
        finish(board.controller.clock.now)
        return None
    task.then = finish
    return _until_caught(task, axis, seek)


def _until_caught(task: CommandTask, axis: AxisState, seek: Seek) -> Wait:
    what = "the index mark" if seek.kind == "index" else "the home switch"
    return passing_flag(task.board, lambda: seek.done, f"for {what} of axis {axis.number}")


ACTIONS: dict[str, Action] = {
    "find_index": find_index,
    "find_edge": find_edge,
    "arm_index": arm_index,
    "arm_edge": arm_edge,
    "wait_index": wait_index,
    "wait_edge": wait_edge,
}
