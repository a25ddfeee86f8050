"""Digital and analogue channels, in terms of logic: a low-true channel is on when its level is low."""

from __future__ import annotations

from motionlang.lang.task import Wait
from motionlang.mccl import codes
from motionlang.mccl.axis.axis import real
from motionlang.mccl.axis.volts import percent, volts
from motionlang.mccl.codes import Fault
from motionlang.mccl.keywords.flow_operations import skip

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.board import Board
    from motionlang.mccl.runtime.task import Action, CommandTask

INFINITY = float("inf")


def is_on(board: Board, channel: int) -> bool:
    """Whether a channel is on: an output as it was set, an input as the world has it."""
    controller = board.controller
    level = controller.output(channel) if channel in board.outputs else controller.input(channel)
    return (level != 0) is not (channel in board.low_true)


def channel_on(task: CommandTask, command: Command) -> None:
    _switch(task, command, True)


def channel_off(task: CommandTask, command: Command) -> None:
    _switch(task, command, False)


def channel_input(task: CommandTask, command: Command) -> None:
    task.board.outputs.discard(task.whole(command))


def channel_output(task: CommandTask, command: Command) -> None:
    task.board.outputs.add(task.whole(command))


def channel_high(task: CommandTask, command: Command) -> None:
    channel = task.whole(command)
    task.board.low_true.discard(channel)
    task.board.inputs.look_at(channel)


def channel_low(task: CommandTask, command: Command) -> None:
    channel = task.whole(command)
    task.board.low_true.add(channel)
    task.board.inputs.look_at(channel)


def tell_channel(task: CommandTask, command: Command) -> None:
    channel = task.whole(command)
    on = is_on(task.board, channel)
    words = task.board.readings.get("mccl.channel-form") == "ON"
    task.tell(channel, ("ON" if on else "OFF") if words else str(int(on)))


def tell_analog(task: CommandTask, command: Command) -> None:
    channel = task.whole(command)
    task.tell(channel, real(volts(task.board.controller.analogue_input(channel))))


def get_analog(task: CommandTask, command: Command) -> None:
    task.registers[0] = volts(task.board.controller.analogue_input(task.whole(command)))


def set_analog(task: CommandTask, command: Command) -> None:
    """The accumulator as volts; the output stops at 10 V either way."""
    task.board.controller.set_analogue_output(task.whole(command), percent(float(task.registers[0])))


def do_if_on(task: CommandTask, command: Command) -> None:
    _do_rest(task, is_on(task.board, task.whole(command)))


def do_if_off(task: CommandTask, command: Command) -> None:
    _do_rest(task, not is_on(task.board, task.whole(command)))


def if_on(task: CommandTask, command: Command) -> None:
    if not is_on(task.board, task.whole(command)):
        skip(task)


def if_off(task: CommandTask, command: Command) -> None:
    if is_on(task.board, task.whole(command)):
        skip(task)


def wait_on(task: CommandTask, command: Command) -> Wait | None:
    return _wait(task, command, True)


def wait_off(task: CommandTask, command: Command) -> Wait | None:
    return _wait(task, command, False)


def _switch(task: CommandTask, command: Command, on: bool) -> None:
    board, channel = task.board, task.whole(command)
    if channel not in board.outputs:
        raise Fault(
            codes.PARAMETER, f"channel {channel} is an input", f"CT{channel} makes it an output", "read-only"
        )
    board.controller.set_output(channel, int(on is not (channel in board.low_true)))


def _do_rest(task: CommandTask, yes: bool) -> None:
    if not yes:
        assert task.line is not None
        task.pc = len(task.line.commands)


def _wait(task: CommandTask, command: Command, on: bool) -> Wait | None:
    board, channel = task.board, task.whole(command)
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


ACTIONS: dict[str, Action] = {
    "channel_on": channel_on,
    "channel_off": channel_off,
    "channel_input": channel_input,
    "channel_output": channel_output,
    "channel_high": channel_high,
    "channel_low": channel_low,
    "tell_channel": tell_channel,
    "tell_analog": tell_analog,
    "get_analog": get_analog,
    "set_analog": set_analog,
    "do_if_on": do_if_on,
    "do_if_off": do_if_off,
    "if_on": if_on,
    "if_off": if_off,
    "wait_on": wait_on,
    "wait_off": wait_off,
}
PURE = frozenset({"get_analog", "do_if_on", "do_if_off", "if_on", "if_off"})
