"""The servo loop of an axis: gains, period, following-error limit, torque.

They act on the motor that the machine file simulates. Without one they are stored and read back, and the
report states that they had no effect.
"""

from __future__ import annotations

from math import inf

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.defaults import FATAL_ERROR, GAINS, LOOP_TIME, PERIOD
from motionlang.kernel.mint.runtime.binding import of, of_word
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

# Volts of one percent of full scale.
_PERCENT = 0.1


class LoopSettings:
    """The following-error limits in counts and the torques in percent, by axis."""

    def __init__(self, environment: Environment) -> None:
        self.environment = environment
        self.fatal: dict[int, float] = {}
        self.torque: dict[int, float] = {}

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        self.fatal.pop(axis, None)
        self.environment.controller.set_error_limit(axis, inf)
        self.environment.controller.set_gains(axis, {})


def _report_no_effect(environment: Environment, row: Keyword, axes: tuple[int, ...]) -> None:
    if not any(environment.controller.has_motor(axis) for axis in axes):
        environment.machine.without_effect.setdefault(row.name, [])


def _quantity(row: Keyword) -> str:
    return row.tunes


def read_gain(environment: Environment, row: Keyword, axis: int) -> float:
    """Return a gain of the axis's servo loop in the unit of its keyword."""
    quantity = _quantity(row)
    value = environment.controller.gain(axis, quantity, GAINS[quantity])
    return int(value) if row.unit == "integer" else value


def write_gain(loops: LoopSettings, row: Keyword, axis: int, value: float) -> None:
    """Set a gain of the axis's servo loop.

    Without a motor it has no effect, which the report states.
    """
    loops.environment.controller.set_gain(axis, _quantity(row), float(value), row.name)
    _report_no_effect(loops.environment, row, (axis,))


def read_loop_time(environment: Environment) -> int:
    controller = environment.controller
    return int(controller.gain(next(iter(controller.axes)), PERIOD, LOOP_TIME))


def write_loop_time(environment: Environment, row: Keyword, value: int) -> None:
    """LOOPTIME: set the servo period of all axes in µs."""
    controller = environment.controller
    for axis in controller.axes:
        controller.set_gain(axis, PERIOD, float(value), row.name)
    _report_no_effect(environment, row, tuple(controller.axes))


def read_fatal_error(loops: LoopSettings, axis: int) -> float:
    """FOLERRORFATAL: return the limit in user units."""
    scale, fatal = loops.environment.controller.axes[axis].scale, loops.fatal
    return scale.to_user(fatal[axis], "uu") if axis in fatal else FATAL_ERROR


def write_fatal_error(loops: LoopSettings, row: Keyword, axis: int, value: float) -> None:
    """FOLERRORFATAL: set the limit in user units.

    Without a motor it has no effect, which the report states.
    """
    controller = loops.environment.controller
    loops.fatal[axis] = abs(controller.axes[axis].scale.to_counts(value, "uu"))
    controller.set_error_limit(axis, loops.fatal[axis])
    _report_no_effect(loops.environment, row, (axis,))


def read_torque(loops: LoopSettings, axis: int) -> float:
    """TORQUE: return the output in percent of full scale, 0 while the loop is closed."""
    return loops.torque.get(axis, 0.0) if loops.environment.controller.is_open(axis) else 0.0


def write_torque(loops: LoopSettings, axis: int, value: float) -> None:
    """TORQUE: open the loop and output a percentage of full scale."""
    loops.environment.controller.open_loop(axis, value * _PERCENT)
    loops.torque[axis] = value


# ------------------------------------------------------------------------------------------------- keywords

_GAIN = Actions(read=of_word(Environment, read_gain), write=repeatable(of_word(LoopSettings, write_gain)))
_LOOP_TIME = Actions(read=of(Environment, read_loop_time), write=of_word(Environment, write_loop_time))
_FATAL_ERROR = Actions(
    read=of(LoopSettings, read_fatal_error), write=repeatable(of_word(LoopSettings, write_fatal_error))
)


def _gain(name: str, short: str, tunes: str, help: str, high: float, unit: str = "number") -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", unit, _GAIN, help,
                   f"{name}(0) = 2\nPRINT {name}(0)", default=GAINS[tunes], low=0.0, high=high, group="servo",
                   tunes=tunes)  # fmt: skip


ROWS = (
    _gain("KPROP", "kp", "proportional",
          "Proportional gain: DAC steps (2048 for 10 V) for each count of following error.", 1e9),
    _gain("KINT", "ki", "integral",
          "Integral gain: DAC steps for each count of following error summed over servo loops.", 1e9),
    _gain("KINTLIMIT", "kil", "integral_limit",
          "The most that the integral contributes, percent of full scale.", 100.0),
    _gain("KINTMODE", "kim", "integral_mode",
          "Action of the integral: 0 never, 1 always, 2 at steady or zero demanded speed, 3 at zero demanded speed.",
          3.0, "integer"),
    _gain("KDERIV", "kd", "derivative",
          "Derivative gain: DAC steps for each count by which the error changes in a servo loop.", 1e9),
    _gain("KVEL", "", "velocity_feedback",
          "Velocity feedback: DAC steps for each count that the motor moves in a servo loop.", 1e9),
    _gain("KVELFF", "", "velocity_ff",
          "Velocity feed-forward: DAC steps for each count of demanded motion in a servo loop.", 1e9),
    _gain("KACCEL", "", "accel_ff",
          "Acceleration feed-forward: DAC steps for each count by which that changes in a servo loop.",
          1e9),
    Keyword("LOOPTIME", "lt", "setting", "RW", "none", "integer", _LOOP_TIME,
            "The time of one servo loop in microseconds; it can be set until the first motion.",
            "LOOPTIME = 500\nPRINT LOOPTIME", default=LOOP_TIME, low=50.0, high=100000.0, group="servo",
            tunes="period"),
    Keyword("FOLERRORFATAL", "", "setting", "RW", "axis", "uu", _FATAL_ERROR,
            "The following error beyond which the axis does what FOLERRORMODE says.",
            "FOLERRORFATAL(0) = 2\nPRINT FOLERRORFATAL(0)", default=FATAL_ERROR, low=0.0, high=8388607.0,
            group="servo"),
    Keyword("TORQUE", "", "setting", "RW", "axis", "%",
            Actions(read=of(LoopSettings, read_torque), write=of(LoopSettings, write_torque)),
            "Give the motor a constant output, percent of full scale, in place of its servo loop, until CANCEL, STOP, "
            "RESET or a move closes the loop again. It needs a simulated motor.",
            "PRINT TORQUE(0)", default=0.0, low=-100.0, high=100.0, group="servo", effect="act"),
)  # fmt: skip
