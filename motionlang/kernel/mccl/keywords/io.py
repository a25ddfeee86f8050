"""Digital and analogue channels.

Digital levels are logical: a low-true channel is on if its level is low.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.lang.steps import BRANCH
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.axis import real
from motionlang.kernel.mccl.axis.inputs import is_input_of_axis
from motionlang.kernel.mccl.axis.volts import percent, volts
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.flow import skip_unless
from motionlang.kernel.mccl.keywords.row import Group, accumulator, pure, written
from motionlang.kernel.mccl.models import elsewhere, models_with

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.board import Board
    from motionlang.kernel.mccl.runtime.task import CommandTask
    from motionlang.kernel.mccl.runtime.writer import LineWriter


def is_on(board: Board, channel: int) -> bool:
    """True if a channel is on.

    An output has the level that the program has set, an input the level from the world.
    """
    controller = board.controller
    level = controller.output(channel) if channel in board.outputs else controller.input(channel)
    return (level != 0) is not (channel in board.controller.inputs.active_low)


# They count their own effect: only a changed channel is an effect.
@pure
def channel_on(task: CommandTask, command: Command) -> None:
    _switch(task, command, True)


@pure
def channel_off(task: CommandTask, command: Command) -> None:
    _switch(task, command, False)


def channel_input(task: CommandTask, command: Command) -> None:
    task.board.outputs.discard(task.whole(command))


def channel_output(task: CommandTask, command: Command) -> None:
    task.board.outputs.add(task.whole(command))


def channel_high(task: CommandTask, command: Command) -> None:
    channel = task.whole(command)
    inputs = task.board.controller.inputs
    inputs.set_active_low(inputs.active_low - {channel})
    task.board.inputs.check(channel)


def channel_low(task: CommandTask, command: Command) -> None:
    channel = task.whole(command)
    inputs = task.board.controller.inputs
    inputs.set_active_low(inputs.active_low | {channel})
    task.board.inputs.check(channel)


def tell_channel(task: CommandTask, command: Command) -> None:
    channel = _existing(task, command)
    on = is_on(task.board, channel)
    words = task.board.assumptions.get("mccl.channel-form") == "ON"
    task.tell(channel, ("ON" if on else "OFF") if words else str(int(on)))


def tell_analog(task: CommandTask, command: Command) -> None:
    channel = task.whole(command)
    task.tell(channel, real(volts(task.board.controller.analogue_input(channel))))


@accumulator("sets")
@pure
def get_analog(task: CommandTask, command: Command) -> None:
    task.registers[0] = volts(task.board.controller.analogue_input(task.whole(command)))


def set_analog(task: CommandTask, command: Command) -> None:
    """Set an analogue output to the accumulator's value in volts, clamped to ±10 V."""
    task.board.controller.set_analogue_output(task.whole(command), percent(float(task.registers[0])))


@written
@pure
def do_if_on(line: LineWriter, command: Command) -> None:
    line.jump(BRANCH, line.end, _is_on)


@written
@pure
def do_if_off(line: LineWriter, command: Command) -> None:
    line.jump(BRANCH, line.end, _is_off)


@written
@pure
def if_on(line: LineWriter, command: Command) -> None:
    skip_unless(line, _is_on)


@written
@pure
def if_off(line: LineWriter, command: Command) -> None:
    skip_unless(line, _is_off)


def wait_on(task: CommandTask, command: Command) -> Wait | None:
    return _wait(task, command, True)


def wait_off(task: CommandTask, command: Command) -> Wait | None:
    return _wait(task, command, False)


def _switch(task: CommandTask, command: Command, on: bool) -> None:
    board, channel = task.board, task.whole(command)
    if channel not in board.outputs:
        # An output of this board that the program has made an input needs no other board.
        others = "" if channel in board.model.outputs else models_with(lambda each: channel in each.outputs)
        as_outputs = f"; it is one on {others}: controller.model in the machine file" if others else ""
        hint = f"CT{channel} makes it an output{as_outputs}"
        raise Fault(codes.PARAMETER, f"channel {channel} is an input", hint, "read-only")
    if board.controller.set_output(channel, int(on is not (channel in board.controller.inputs.active_low))):
        board.effects += 1
    else:
        board.rewrites += 1


def _is_on(task: CommandTask, command: Command) -> bool:
    return is_on(task.board, _existing(task, command))


def _is_off(task: CommandTask, command: Command) -> bool:
    return not is_on(task.board, _existing(task, command))


def _existing(task: CommandTask, command: Command) -> int:
    """Return the channel of a command; raise Fault if neither the board nor the machine has it."""
    board, channel = task.board, task.whole(command)
    if channel <= board.model.channels or channel in board.outputs or board.is_driven(channel):
        return channel
    if is_input_of_axis(board, channel):
        return channel
    hint = elsewhere(lambda each: channel <= each.channels)
    words = f"the {board.model.title} has no digital channel {channel}"
    raise Fault(codes.PARAMETER, words, hint or f"they are 1 to {board.model.channels}", "channel")


def _wait(task: CommandTask, command: Command, on: bool) -> Wait | None:
    board, channel = task.board, _existing(task, command)
    if is_on(board, channel) is on:
        return None
    state = "on" if on else "off"
    return Wait(
        board.controller.clock.now,
        lambda: is_on(board, channel) is on,
        lambda: INFINITY,
        f"for channel {channel} to be {state}",
        "input",
        (channel,),
    )


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("input and output").row
_reports_row = Group("reports").row


ROWS = (
    _row("CN", "command", "W", "none", "number", channel_on, "Switch an output channel on.", "CT9,CN9", low=1,
         high=255, channel="output", output="1"),
    _row("CF", "command", "W", "none", "number", channel_off, "Switch an output channel off.", "CT9,CF9", low=1,
         high=255, channel="output", output="0"),
    _row("CI", "command", "W", "none", "number", channel_input, "Make the channel an input.", "CI1", low=1,
         high=255, channel="digital"),
    _row("CT", "command", "W", "none", "number", channel_output, "Make the channel an output.", "CT9", low=1,
         high=255, channel="digital"),
    _row("CH", "command", "W", "none", "number", channel_high, "High level means on.", "CH1", low=1, high=255,
         channel="digital"),
    _row("CL", "command", "W", "none", "number", channel_low, "Low level means on.", "CL1", low=1, high=255,
         channel="digital"),
    _row("DN", "command", "W", "none", "number", do_if_on,
         "Carry out the rest of the line only if the channel is on.",
         "DN1,1TP", low=1, high=255, channel="input", reads="input", tests="channel {} on"),
    _row("DF", "command", "W", "none", "number", do_if_off,
         "Carry out the rest of the line only if the channel is off.", "DF1,1TP", low=1, high=255, channel="input",
         reads="input", tests="channel {} off"),
    _row("IN", "command", "W", "none", "number", if_on,
         "If the channel is on carry out the next two commands, else skip them.", "IN1,AL1,NO", low=1, high=255,
         channel="input", reads="input", tests="channel {} on"),
    _row("IF", "command", "W", "none", "number", if_off,
         "If the channel is off carry out the next two commands, else skip them.", "IF1,AL1,NO", low=1, high=255,
         channel="input", reads="input", tests="channel {} off"),
    _row("WN", "command", "W", "none", "number", wait_on, "Wait until the channel is on.", "CT9,CN9,WN9",
         low=1, high=255, channel="input", reads="input", waits="input", tests="channel {} on"),
    _row("WF", "command", "W", "none", "number", wait_off, "Wait until the channel is off.", "WF1", low=1,
         high=255, channel="input", reads="input", waits="input", tests="channel {} off"),
    _row("GA", "command", "W", "none", "number", get_analog, "Get an analogue input into the accumulator, volts.",
         "GA1,TR0", low=1, high=255, channel="analogue input", reads="analogue"),
    _row("OA", "command", "W", "none", "number", set_analog,
         "Put the accumulator out on an analogue channel, volts.",
         "AL5,OA1", low=1, high=255, channel="analogue output", output="accumulator"),
    _reports_row("TC", "reading", "R", "none", "number", tell_channel, "Tell a digital channel: 1 on, 0 off.", "TC1",
                 low=1, high=255, channel="input"),
    _reports_row("TA", "reading", "R", "none", "number", tell_analog, "Tell an analogue input, volts.", "TA1",
                 low=1, high=255, channel="analogue input"),
)  # fmt: skip
