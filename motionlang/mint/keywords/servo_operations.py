"""Gains and limits of the servo loop, for axes whose motor is simulated."""

from __future__ import annotations

from motionlang.mint.keywords.defaults import FATAL_ERROR, GAINS, LOOP_TIME, PERIOD
from motionlang.mint.keywords.torque_operations import TorqueReferences
from motionlang.mint.runtime.binding import axis_of, scale_of
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.controller import Controller
    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

# Volts of one percent of full scale.
_PERCENT = 0.1
# What the verb of a gain begins with; the rest is the quantity that it sets.
_GAIN = "servo.gain."


class Loops:
    """The limits of following errors, counts by axis, and torques in force, percent."""

    def __init__(self, environment: Environment) -> None:
        self._controller: Controller = environment.controller
        self.fatal: dict[int, float] = {}
        self.torque: dict[int, float] = {}

    def default(self, axis: int) -> None:
        """DEFAULT."""
        self.fatal.pop(axis, None)
        self._controller.set_error_limit(axis, float("inf"))
        self._controller.set_gains(axis, {})


def _tell(environment: Environment, row: Row, axes: tuple[int, ...]) -> None:
    """Note a word that nothing in this machine goes by."""
    if not any(environment.controller.has_motor(axis) for axis in axes):
        environment.machine.without_effect.setdefault(row.name, [])


def _quantity(row: Row) -> str:
    return row.verb.removeprefix(_GAIN)


def read_gain(environment: Environment, row: Row) -> Operation:
    """A gain of the axis's servo loop, in the units of its word."""
    gain, quantity, whole = environment.controller.gain, _quantity(row), row.unit == "integer"
    default = GAINS[quantity]

    def read(axis: int) -> float:
        value = gain(axis_of(environment, axis), quantity, default)
        return int(value) if whole else value

    return read


@repeatable
def write_gain(environment: Environment, row: Row) -> Operation:
    """A gain of the axis's servo loop; without a motor it has no effect, which the report tells."""
    environment.part(Loops)
    quantity = _quantity(row)

    def write(axis: int, value: float) -> None:
        row.check(value)
        environment.controller.set_gain(axis_of(environment, axis), quantity, float(value), row.name)
        _tell(environment, row, (axis,))

    return write


def read_loop_time(environment: Environment, row: Row) -> Operation:
    controller = environment.controller
    return lambda: int(controller.gain(next(iter(controller.axes)), PERIOD, LOOP_TIME))


def write_loop_time(environment: Environment, row: Row) -> Operation:
    """LOOPTIME, µs, of all axes."""
    controller = environment.controller

    def write(value: int) -> None:
        row.check(value)
        for axis in controller.axes:
            controller.set_gain(axis, PERIOD, float(value), row.name)
        _tell(environment, row, tuple(controller.axes))

    return write


def read_fatal_error(environment: Environment, row: Row) -> Operation:
    """FOLERRORFATAL, user units."""
    fatal = environment.part(Loops).fatal

    def read(axis: int) -> float:
        scale = scale_of(environment, axis)
        return scale.to_user(fatal[axis], "uu") if axis in fatal else FATAL_ERROR

    return read


@repeatable
def write_fatal_error(environment: Environment, row: Row) -> Operation:
    """FOLERRORFATAL, user units; without a motor it has no effect, which the report tells."""
    fatal = environment.part(Loops).fatal

    def write(axis: int, value: float) -> None:
        row.check(value)
        fatal[axis] = abs(scale_of(environment, axis).to_counts(value, "uu"))
        environment.controller.set_error_limit(axis, fatal[axis])
        _tell(environment, row, (axis,))

    return write


def read_torque(environment: Environment, row: Row) -> Operation:
    """TORQUE, percent of full scale; 0 while the loop is closed, or TORQUEREF has the output."""
    controller, torque = environment.controller, environment.part(Loops).torque
    references = environment.part(TorqueReferences)

    def read(axis: int) -> float:
        in_force = controller.is_open(axis_of(environment, axis)) and not references.has(axis)
        return torque.get(axis, 0.0) if in_force else 0.0

    return read


def write_torque(environment: Environment, row: Row) -> Operation:
    """TORQUE: open the loop and put out percent of full scale."""
    torque, references = environment.part(Loops).torque, environment.part(TorqueReferences)

    def write(axis: int, value: float) -> None:
        row.check(value)
        references.end(axis)
        environment.controller.open_loop(axis_of(environment, axis), value * _PERCENT)
        torque[axis] = value

    return write


OPERATIONS = {
    **{f"{_GAIN}{quantity}": {"read": read_gain, "write": write_gain} for quantity in GAINS},
    "servo.loop_time": {"read": read_loop_time, "write": write_loop_time},
    "servo.fatal_error": {"read": read_fatal_error, "write": write_fatal_error},
    "servo.torque": {"read": read_torque, "write": write_torque},
}
