"""Repeating, jumping and deciding inside a line.

The rule of every `I.` command: when the condition holds the next command is carried out, else two are skipped.
"""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.codes import Fault

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.lang.task import Wait
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask

    Condition = Callable[[float | int, float | int], bool]


def repeat(task: CommandTask, command: Command) -> Wait | None:
    """Carry out the line up to here n more times; for ever without n, or with 0."""
    count = task.whole(command)
    if count < 0:
        raise Fault(
            codes.NEGATIVE_REPEAT,
            f"RP cannot repeat {count} times",
            "RP without a number repeats for ever",
            "range",
        )
    here = task.here
    if count == 0 and task.board.readings.get("mccl.repeat-for-ever") == "once":
        count = 1
    if count == 0:
        return task.jump(0)
    left = task.repeats.get(here, count)
    if left == 0:
        del task.repeats[here]
        return None
    task.repeats[here] = left - 1
    assert task.line is not None
    if here != task.loop_log.end or task.loop_log.target:
        task.loop_log.back(task.line, 0, here)
    task.pc = 0
    task.board.effects += 1
    return None


def jump(task: CommandTask, command: Command) -> Wait | None:
    return task.jump(task.whole(command) - task.board.readings.get("mccl.jump-base", 0))  # type: ignore[operator]


def jump_by(task: CommandTask, command: Command) -> Wait | None:
    after = task.board.readings.get("mccl.jump-relative") == "next"
    return task.jump(task.here + task.whole(command) + after)


def nothing(task: CommandTask, command: Command) -> None:
    return None


def skip(task: CommandTask) -> None:
    """A condition has failed: what it governs is not carried out."""
    task.pc += task.board.readings.get("mccl.skipped", 2)  # type: ignore[operator]


def _if(condition: Condition) -> Action:
    def decide(task: CommandTask, command: Command) -> None:
        if not condition(task.registers[0], task.value(command)):
            skip(task)

    return decide


def _bit(accumulator: float | int, bit: float | int) -> int:
    return int(accumulator) >> int(bit) & 1


ACTIONS: dict[str, Action] = {
    "repeat": repeat,
    "jump": jump,
    "jump_by": jump_by,
    "nothing": nothing,
    "if_below": _if(lambda accumulator, value: accumulator < value),
    "if_equal": _if(lambda accumulator, value: accumulator == value),
    "if_greater": _if(lambda accumulator, value: accumulator > value),
    "if_unequal": _if(lambda accumulator, value: accumulator != value),
    "if_set": _if(lambda accumulator, bit: _bit(accumulator, bit) == 1),
    "if_clear": _if(lambda accumulator, bit: _bit(accumulator, bit) == 0),
}
PURE = frozenset(ACTIONS)
