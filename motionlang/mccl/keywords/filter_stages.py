"""Loop rate, output stage and encoder of an axis: kept, told by the status words and the variables."""

from __future__ import annotations

from motionlang.mccl import codes
from motionlang.mccl.axis import motor
from motionlang.mccl.codes import Fault

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.runtime.task import Action, CommandTask

# MCAPI's output modes: what they are, and whether a simulated motor has them.
OUTPUT_MODES: dict[int, tuple[str, bool]] = {
    0: ("bipolar; a stepper: pulse and direction", True),
    1: ("unipolar; a stepper: clockwise and counterclockwise pulses", False),
    2: ("bipolar PWM", True),
    3: ("unipolar PWM", False),
    4: ("piezo", False),
    0x8000: ("sine without encoder", False),
    0xC000: ("sine with encoder", True),
}
FULL, HALF = 1.0, 0.5


def output_mode(task: CommandTask, command: Command) -> None:
    """OM: how the amplifier is driven; a simulated motor stays bipolar, which is said."""
    mode = task.whole(command)
    if mode not in OUTPUT_MODES:
        modes = ", ".join(map(str, OUTPUT_MODES))
        raise Fault(codes.PARAMETER, f"there is no output mode {mode}", f"the modes are {modes}", "range")
    name, simulated = OUTPUT_MODES[mode]
    for axis in task.axes(command):
        axis.kept["output_mode"] = float(mode)
        if not simulated and task.board.controller.has_motor(axis.number):
            message = f"the simulated motor of axis {axis.number} has a bipolar amplifier, not {name}"
            task.board.warn(task, "not-simulated", message, "the mode is kept and told")


def _keep(name: str, value: float) -> Action:
    def keep(task: CommandTask, command: Command) -> None:
        for axis in task.axes(command):
            axis.kept[name] = value

    return keep


def _keep_parameter(name: str) -> Action:
    def keep(task: CommandTask, command: Command) -> None:
        for axis in task.axes(command):
            axis.kept[name] = float(task.value(command))

    return keep


def _rate(hertz: float) -> Action:
    """A rate of the servo loop: a simulated motor has it at once; profiles are exact and have none."""

    def switch(task: CommandTask, command: Command) -> None:
        for axis in task.axes(command):
            axis.kept["kept_rate"] = hertz
            motor.tune(task.board, axis)

    return switch


ACTIONS: dict[str, Action] = {
    "output_mode": output_mode,
    "input_mode": _keep_parameter("input_mode"),
    "encoder_scaling": _keep_parameter("encoder_scaling"),
    "full_current": _keep("current", FULL),
    "half_current": _keep("current", HALF),
    "high_rate": _rate(4000.0),
    "medium_rate": _rate(2000.0),
    "low_rate": _rate(1000.0),
}
