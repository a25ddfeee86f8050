"""Gains and limits of the servo loop, for axes whose motor is simulated."""

from __future__ import annotations

from motionlang.mint.keywords.defaults import FATAL_ERROR, GAINS, LOOP_TIME, PERIOD
from motionlang.mint.keywords.torque_operations import TorqueReferences
from motionlang.mint.runtime.binding import Row, of, of_word
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment

# Volts of one percent of full scale.
_PERCENT = 0.1
# What the verb of a gain begins with; the rest is the quantity that it sets.
_GAIN = "servo.gain."


class Loops:
    """The limits of following errors, counts by axis, and torques in force, percent."""

    def __init__(self, environment: Environment) -> None:
        self.environment = environment
        self.fatal: dict[int, float] = {}
        self.torque: dict[int, float] = {}

    @property
    def references(self) -> TorqueReferences:
        return self.environment.part(TorqueReferences)

    def default(self, axis: int) -> None:
        """DEFAULT."""
        self.fatal.pop(axis, None)
        self.environment.controller.set_error_limit(axis, float("inf"))
        self.environment.controller.set_gains(axis, {})


def _tell(environment: Environment, row: Row, axes: tuple[int, ...]) -> None:
    """Note a word that nothing in this machine goes by."""
    if not any(environment.controller.has_motor(axis) for axis in axes):
        environment.machine.without_effect.setdefault(row.name, [])


def _quantity(row: Row) -> str:
    return row.verb.removeprefix(_GAIN)


def read_gain(environment: Environment, row: Row, axis: int) -> float:
    """A gain of the axis's servo loop, in the units of its word."""
    quantity = _quantity(row)
    value = environment.controller.gain(axis, quantity, GAINS[quantity])
    return int(value) if row.unit == "integer" else value


def write_gain(loops: Loops, row: Row, axis: int, value: float) -> None:
    """A gain of the axis's servo loop; without a motor it has no effect, which the report tells."""
    loops.environment.controller.set_gain(axis, _quantity(row), float(value), row.name)
    _tell(loops.environment, row, (axis,))


def read_loop_time(environment: Environment) -> int:
    controller = environment.controller
    return int(controller.gain(next(iter(controller.axes)), PERIOD, LOOP_TIME))


def write_loop_time(environment: Environment, row: Row, value: int) -> None:
    """LOOPTIME, µs, of all axes."""
    controller = environment.controller
    for axis in controller.axes:
        controller.set_gain(axis, PERIOD, float(value), row.name)
    _tell(environment, row, tuple(controller.axes))


def read_fatal_error(loops: Loops, axis: int) -> float:
    """FOLERRORFATAL, user units."""
    scale, fatal = loops.environment.controller.axes[axis].scale, loops.fatal
    return scale.to_user(fatal[axis], "uu") if axis in fatal else FATAL_ERROR


def write_fatal_error(loops: Loops, row: Row, axis: int, value: float) -> None:
    """FOLERRORFATAL, user units; without a motor it has no effect, which the report tells."""
    controller = loops.environment.controller
    loops.fatal[axis] = abs(controller.axes[axis].scale.to_counts(value, "uu"))
    controller.set_error_limit(axis, loops.fatal[axis])
    _tell(loops.environment, row, (axis,))


def read_torque(loops: Loops, axis: int) -> float:
    """TORQUE, percent of full scale; 0 while the loop is closed, or TORQUEREF has the output."""
    in_force = loops.environment.controller.is_open(axis) and not loops.references.has(axis)
    return loops.torque.get(axis, 0.0) if in_force else 0.0


def write_torque(loops: Loops, axis: int, value: float) -> None:
    """TORQUE: open the loop and put out percent of full scale."""
    loops.references.end(axis)
    loops.environment.controller.open_loop(axis, value * _PERCENT)
    loops.torque[axis] = value


_ANY_GAIN = {"read": of_word(Environment, read_gain), "write": repeatable(of_word(Loops, write_gain))}
OPERATIONS = {
    **{f"{_GAIN}{quantity}": _ANY_GAIN for quantity in GAINS},
    "servo.loop_time": {
        "read": of(Environment, read_loop_time),
        "write": of_word(Environment, write_loop_time),
    },
    "servo.fatal_error": {
        "read": of(Loops, read_fatal_error),
        "write": repeatable(of_word(Loops, write_fatal_error)),
    },
    "servo.torque": {"read": of(Loops, read_torque), "write": of(Loops, write_torque)},
}
