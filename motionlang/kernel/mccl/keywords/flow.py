"""Repetition, jumps and conditions inside a line.

Every `I.` command follows the same rule: if the condition holds, the next command is executed; if not, two
commands are skipped.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Actions
from motionlang.kernel.lang.steps import BACK, BRANCH, DO
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.row import Group, accumulator, pure, written

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import Action, CommandTask
    from motionlang.kernel.mccl.runtime.writer import LineWriter

Condition = Callable[[float | int, float | int], bool]


@written
@pure
def repeat(line: LineWriter, command: Command) -> None:
    """Repeat the line up to here n more times (RP).

    Without n, or with 0, it repeats for ever.
    """
    index, once = line.index, line.board.assumptions.get("mccl.repeat-for-ever") == "once"
    if command.number == 0 and not once:
        line.act(BACK, None, to=0)
        return

    def again(task: CommandTask, command: Command) -> bool:
        count = task.whole(command)
        if count < 0:
            raise codes.negative_repeat(count)
        if count == 0 and not once:
            return True
        left = task.repeats.get(index, count or 1)
        if left == 0:
            del task.repeats[index]
            return False
        task.repeats[index] = left - 1
        return True

    line.act(BACK, again, to=0)


@written
@pure
def jump(line: LineWriter, command: Command) -> None:
    _jump(line, command, -line.board.assumptions.get("mccl.jump-base", 0))  # type: ignore[operator]


@written
@pure
def jump_by(line: LineWriter, command: Command) -> None:
    after = line.board.assumptions.get("mccl.jump-relative") == "next"
    _jump(line, command, line.index + after)


def _jump(line: LineWriter, command: Command, origin: int) -> None:
    """Go on with the command that the parameter gives, counted from `origin`."""
    base: int = line.board.assumptions.get("mccl.jump-base", 0)  # type: ignore[assignment]
    end = line.end

    def target(task: CommandTask, command: Command) -> int:
        index = origin + task.whole(command)
        if not 0 <= index <= end:
            raise Fault(
                codes.PARAMETER,
                f"there is no command {base + index} here",
                f"they are numbered {base} to {base + end - 1}",
                "range",
            )
        return index

    line.go(target, None if command.number is None else origin + command.number)


@written
@pure
def nothing(line: LineWriter, command: Command) -> None:
    line.act(DO, lambda task, command: None)


def skip_unless(line: LineWriter, condition: Callable[[CommandTask, Command], bool]) -> None:
    """Skip the commands that depend on a condition if it is false."""
    skipped: int = line.board.assumptions.get("mccl.skipped", 2)  # type: ignore[assignment]
    line.jump(BRANCH, line.index + 1 + skipped, condition)


def _if(condition: Condition) -> Action:
    """Return a comparison of the accumulator with the parameter."""

    @written
    @accumulator("compares")
    @pure
    def decide(line: LineWriter, command: Command) -> None:
        def test(task: CommandTask, command: Command) -> bool:
            value = task.value(command)
            task.tested(command, is_bit=False)
            task.board.loops.compared(task.registers[0] - value)
            if task.hook is not None:
                task.hook.compared(task.registers[0], value)
            return condition(task.registers[0], value)

        skip_unless(line, test)

    return decide


def _if_bit(wanted: int) -> Action:
    """Return a test of the bit of the accumulator that the parameter gives."""

    @written
    @accumulator("tests")
    @pure
    def decide(line: LineWriter, command: Command) -> None:
        def test(task: CommandTask, command: Command) -> bool:
            task.tested(command, is_bit=True)
            return int(task.registers[0]) >> int(task.value(command)) & 1 == wanted

        skip_unless(line, test)

    return decide


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
         "If the accumulator is below n carry out the next two commands, else skip them.", "AL5,IB6,AL7,NO,TR0",
         tests="accumulator < {}"),
    _row("IE", "statement", "W", "none", "number",
         Actions("if_equal", do=_if(lambda accumulator, value: accumulator == value)),
         "If the accumulator equals n carry out the next two commands, else skip them.", "AL5,IE5,AL7,NO,TR0",
         tests="accumulator = {}"),
    _row("IG", "statement", "W", "none", "number",
         Actions("if_greater", do=_if(lambda accumulator, value: accumulator > value)),
         "If the accumulator is greater than n carry out the next two commands, else skip them.", "AL5,IG4,AL7,NO,TR0",
         tests="accumulator > {}"),
    _row("IU", "statement", "W", "none", "number",
         Actions("if_unequal", do=_if(lambda accumulator, value: accumulator != value)),
         "If the accumulator does not equal n carry out the next two commands, else skip them.", "AL5,IU4,AL7,NO,TR0",
         tests="accumulator <> {}"),
    _row("IS", "statement", "W", "none", "number",
         Actions("if_set", do=_if_bit(1)),
         "If bit n of the accumulator is set carry out the next two commands, else skip them.", "AL5,IS2,AL7,NO,TR0",
         low=0, high=31, tests="bit {} set"),
    _row("IC", "statement", "W", "none", "number",
         Actions("if_clear", do=_if_bit(0)),
         "If bit n of the accumulator is clear carry out the next two commands, else skip them.", "AL5,IC1,AL7,NO,TR0",
         low=0, high=31, tests="bit {} clear"),
    _row("NO", "statement", "C", "none", "", nothing,
         "No operation; what fills up the two commands that a condition governs.",
         "NO"),
)  # fmt: skip
