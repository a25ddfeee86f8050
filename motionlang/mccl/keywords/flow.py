"""Repetition, jumps and conditions inside a line.

Every `I.` command follows the same rule: if the condition holds, the next command is executed; if not, two
commands are skipped.
"""

from __future__ import annotations

from motionlang.lang.keyword import Actions
from motionlang.mccl import codes
from motionlang.mccl.keywords.row import Group, pure

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.lang.waits import Wait
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask

    Condition = Callable[[float | int, float | int], bool]


@pure
def repeat(task: CommandTask, command: Command) -> Wait | None:
    """Repeat the line up to here n more times (RP).

    Without n, or with 0, it repeats for ever.
    """
    count = task.whole(command)
    if count < 0:
        raise codes.negative_repeat(count)
    here = task.here
    if count == 0 and task.board.assumptions.get("mccl.repeat-for-ever") == "once":
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


@pure
def jump(task: CommandTask, command: Command) -> Wait | None:
    return task.jump(task.whole(command) - task.board.assumptions.get("mccl.jump-base", 0))  # type: ignore[operator]


@pure
def jump_by(task: CommandTask, command: Command) -> Wait | None:
    after = task.board.assumptions.get("mccl.jump-relative") == "next"
    return task.jump(task.here + task.whole(command) + after)


@pure
def nothing(task: CommandTask, command: Command) -> None:
    return None


def skip(task: CommandTask) -> None:
    """Skip the commands that depend on a false condition."""
    task.pc += task.board.assumptions.get("mccl.skipped", 2)  # type: ignore[operator]


def _if(condition: Condition) -> Action:
    @pure
    def decide(task: CommandTask, command: Command) -> None:
        if not condition(task.registers[0], task.value(command)):
            skip(task)

    return decide


def _bit(accumulator: float | int, bit: float | int) -> int:
    return int(accumulator) >> int(bit) & 1


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("flow").row


ROWS = (
    _row("RP", "statement", "W", "none", "number", repeat,
         "Repeat the line, or the macro, up to here n more times; without a number, or with 0, for ever.",
         "AL1,TR0,RP2", meant="REPEAT"),
    _row("JP", "statement", "W", "none", "number", jump, "Jump to command n of the line or macro; the first is 0.",
         "AL5,JP3,AL6,TR0", low=0),
    _row("JR", "statement", "W", "none", "number", jump_by, "Jump n commands on from this one, or back.",
         "AL5,JR2,AL6,TR0"),
    _row("IB", "statement", "W", "none", "number",
         Actions("if_below", do=_if(lambda accumulator, value: accumulator < value)),
         "If the accumulator is below n carry out the next two commands, else skip them.", "AL5,IB6,AL7,NO,TR0"),
    _row("IE", "statement", "W", "none", "number",
         Actions("if_equal", do=_if(lambda accumulator, value: accumulator == value)),
         "If the accumulator equals n carry out the next two commands, else skip them.", "AL5,IE5,AL7,NO,TR0"),
    _row("IG", "statement", "W", "none", "number",
         Actions("if_greater", do=_if(lambda accumulator, value: accumulator > value)),
         "If the accumulator is greater than n carry out the next two commands, else skip them.", "AL5,IG4,AL7,NO,TR0"),
    _row("IU", "statement", "W", "none", "number",
         Actions("if_unequal", do=_if(lambda accumulator, value: accumulator != value)),
         "If the accumulator does not equal n carry out the next two commands, else skip them.", "AL5,IU4,AL7,NO,TR0"),
    _row("IS", "statement", "W", "none", "number",
         Actions("if_set", do=_if(lambda accumulator, bit: _bit(accumulator, bit) == 1)),
         "If bit n of the accumulator is set carry out the next two commands, else skip them.", "AL5,IS2,AL7,NO,TR0",
         low=0, high=31),
    _row("IC", "statement", "W", "none", "number",
         Actions("if_clear", do=_if(lambda accumulator, bit: _bit(accumulator, bit) == 0)),
         "If bit n of the accumulator is clear carry out the next two commands, else skip them.", "AL5,IC1,AL7,NO,TR0",
         low=0, high=31),
    _row("NO", "statement", "C", "none", "", nothing,
         "No operation; what fills up the two commands that a condition governs.",
         "NO"),
)  # fmt: skip
