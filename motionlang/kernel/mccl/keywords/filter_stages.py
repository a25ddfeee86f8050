"""Loop rate, output stage and encoder of an axis.

The settings are stored, and shown in the status words and the variables.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Actions
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis import motor
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords.row import Group

if TYPE_CHECKING:
    from motionlang.kernel.mccl.resolve.command import Command
    from motionlang.kernel.mccl.runtime.task import Action, CommandTask

# MCAPI's output modes: the name of each, and whether a simulated motor has it.
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
    """Set how the amplifier is driven (OM).

    A simulated motor stays bipolar, and a warning is reported.
    """
    mode = task.whole(command)
    if mode not in OUTPUT_MODES:
        modes = ", ".join(map(str, OUTPUT_MODES))
        raise Fault(codes.PARAMETER, f"there is no output mode {mode}", f"the modes are {modes}", "range")
    name, simulated = OUTPUT_MODES[mode]
    for axis in task.axes(command):
        axis.stored["output_mode"] = float(mode)
        if not simulated and task.board.controller.has_motor(axis.number):
            message = f"the simulated motor of axis {axis.number} has a bipolar amplifier, not {name}"
            task.board.warn(task, "not-simulated", message, "the mode is stored and reported")


def _keep(name: str, value: float) -> Action:
    def keep(task: CommandTask, command: Command) -> None:
        for axis in task.axes(command):
            axis.stored[name] = value

    return keep


def _keep_parameter(name: str) -> Action:
    def keep(task: CommandTask, command: Command) -> None:
        for axis in task.axes(command):
            axis.stored[name] = float(task.value(command))

    return keep


def _rate(hertz: float) -> Action:
    """Return an action that sets the rate of the servo loop.

    A simulated motor changes its loop rate at once. Profiles are exact and have no rate.
    """

    def switch(task: CommandTask, command: Command) -> None:
        for axis in task.axes(command):
            axis.stored["kept_rate"] = hertz
            motor.tune(task.board, axis)

    return switch


# ------------------------------------------------------------------------------------------------- keywords

_row = Group("servo filter").row
_trajectory_row = Group("trajectory").row


ROWS = (
    _row("OM", "setting", "W", "axes", "number", output_mode,
         "Output mode: 0 bipolar, 1 unipolar, 2 and 3 the same as PWM, 4 piezo, 32768 and 49152 sine without and with "
         "encoder; stepper 0 pulse and direction, 1 CW and CCW. Stored, reported as the variable OUTPUTMODE.",
         '1OM2,LU"OUTPUTMODE",1RL@0,TR0', default=0, low=0, high=0xC000),
    _row("IM", "setting", "W", "axes", "bool", Actions("input_mode", do=_keep_parameter("input_mode")),
         "Input mode of a stepper: 0 open loop, 1 closed loop. Stored, reported as the variable INPUTMODE; a "
         "stepper here "
         "loses no steps.", '1IM1,LU"INPUTMODE",1RL@0,TR0', default=0, low=0, high=1),
    _row("ES", "setting", "W", "axes", "number", Actions("encoder_scaling", do=_keep_parameter("encoder_scaling")),
         "Encoder counts per step of a closed-loop stepper. Stored, reported as the variable ENCODERSCALE.",
         '1ES2.5,LU"ENCODERSCALE",1RV@0,TR0', default=1, low=-1e6, high=1e6),
    _trajectory_row("HS", "setting", "C", "axes", "", Actions("high_rate", do=_rate(4000.0)),
                    "High speed: the servo loop of a simulated motor runs at 4 kHz; profiles are exact and "
                    "have no rate.", "1HS", family="rates"),
    _trajectory_row("MS", "setting", "C", "axes", "", Actions("medium_rate", do=_rate(2000.0)),
                    "Medium speed: the servo loop of a simulated motor runs at 2 kHz.", "1MS", family="rates"),
    _trajectory_row("LS", "setting", "C", "axes", "", Actions("low_rate", do=_rate(1000.0)),
                    "Low speed: the servo loop of a simulated motor runs at 1 kHz.", "1LS", family="rates"),
    _trajectory_row("FC", "setting", "C", "axes", "", Actions("full_current", do=_keep("current", FULL)),
                    "Full motor current (stepper): stored, reported as the variable CURRENT.",
                    '1FC,LU"CURRENT",1RV@0,TR0'),
    _trajectory_row("HC", "setting", "C", "axes", "", Actions("half_current", do=_keep("current", HALF)),
                    "Half motor current (stepper): stored, reported as the variable CURRENT.",
                    '1HC,LU"CURRENT",1RV@0,TR0'),
)  # fmt: skip
