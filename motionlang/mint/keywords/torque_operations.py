"""TORQUEREF: an output of the motor that ramps, in place of its servo loop; and what the motor demands and draws.

The reference changes once a servo loop, as a drive's does, so a ramp is a flight of steps. It is percent of the full
output, which is torque where the machine file gives the motor a current amplifier.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.keywords.axis_settings import forget, reading
from motionlang.mint.keywords.defaults import LOOP_TIME, PERIOD
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.keywords.io_outputs import LAST_ANALOGUE, Analogue
from motionlang.mint.runtime.binding import axis_of
from motionlang.mint.runtime.changes import moving

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

# Volts of one percent of full scale, and the full scale.
_PERCENT, FULL = 0.1, 10.0


class TorqueReferences:
    """The settings of torque references, by keyword and axis, and the ramps that are under way."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._controller = environment.controller
        self._settings: dict[tuple[str, int], float] = {}
        # The percent in force on axes whose output is the reference's.
        self._present: dict[int, float] = {}
        self._ramping: set[int] = set()
        self._controller.analogue_inputs.listeners.append(self._analogue)

    def setting(self, name: str, axis: int) -> float:
        return self._settings.get((name, axis), 1.0 if name == "TORQUEREFENABLE" else 0.0)

    def set(self, name: str, axis: int, value: float) -> None:
        self._settings[name, axis] = value
        if name in ("TORQUEREFENABLE", "TORQUEREFSOURCE") and (
            self.has(axis) or (name == "TORQUEREFSOURCE" and value)
        ):
            self.run(axis)

    def has(self, axis: int) -> bool:
        """Whether the output of the axis is the reference's: until something closes the loop again."""
        if axis in self._present and not self._controller.is_open(axis):
            del self._present[axis]
        return axis in self._present

    def wanted(self, axis: int) -> float:
        """Percent: what was written, or an analogue input."""
        if not self.setting("TORQUEREFENABLE", axis):
            return 0.0
        source = int(self.setting("TORQUEREFSOURCE", axis))
        return (
            self._environment.part(Analogue).read(source - 1) if source else self.setting("TORQUEREF", axis)
        )

    def run(self, axis: int) -> None:
        """Ramp to the reference, from 0 where the axis has been under control."""
        if not self.has(axis):
            self._open(axis, 0.0)
        if axis not in self._ramping:
            self._step(axis)

    def end(self, axis: int) -> None:
        """Another word has the output now."""
        self._present.pop(axis, None)

    def present(self, axis: int) -> float:
        """The percent in force; 0 where the axis is under control."""
        return self._present[axis] if self.has(axis) else 0.0

    def default(self, axis: int) -> None:
        """DEFAULT."""
        forget(self._settings, axis)

    def _step(self, axis: int) -> None:
        """One servo loop of the ramp."""
        self._ramping.discard(axis)
        if not self.has(axis):
            return
        seconds = self._controller.gain(axis, PERIOD, LOOP_TIME) / 1e6
        present, wanted = self._present[axis], self.wanted(axis)
        following = self._next(axis, present, wanted, seconds)
        if following != present:
            self._open(axis, following)
        if following != wanted:
            self._ramping.add(axis)
            clock = self._environment.clock
            clock.at(clock.now + seconds, lambda: self._step(axis))

    def _next(self, axis: int, present: float, wanted: float, seconds: float) -> float:
        """The percent a servo loop later: it falls towards 0 and rises away from it."""
        rises = present * wanted >= 0.0 and abs(wanted) > abs(present)
        goal = wanted if present * wanted >= 0.0 else 0.0
        time = self.setting("TORQUEREFRISETIME" if rises else "TORQUEREFFALLTIME", axis) / 1000.0
        most = 100.0 * seconds / time if time else abs(goal - present)
        return goal if abs(goal - present) <= most else present + (most if goal > present else -most)

    def _open(self, axis: int, percent: float) -> None:
        self._controller.open_loop(axis, percent * _PERCENT)
        self._present[axis] = percent

    def _analogue(self, channel: int, value: float) -> None:
        for name, axis in list(self._settings):
            if name == "TORQUEREFSOURCE" and self._settings[name, axis] == channel + 1 and self.has(axis):
                self.run(axis)


# ----------------------------------------------------------------------------------------------- operations


def read_reference(environment: Environment, row: Row) -> Operation:
    references = environment.part(TorqueReferences)
    return lambda axis: references.wanted(axis_of(environment, axis))


def write_reference(environment: Environment, row: Row) -> Operation:
    """TORQUEREF: ramp the motor's output to a percentage, in place of its servo loop."""
    references = environment.part(TorqueReferences)

    def write(axis: int, percent: float, line: int) -> None:
        row.check(percent)
        references.set(row.name, axis_of(environment, axis), percent)
        references.run(axis)

    return write


def read_setting(environment: Environment, row: Row) -> Operation:
    """The source of TORQUEREF and its enabling, and its ramps in ms."""
    return reading(environment, row, environment.part(TorqueReferences).setting)


def write_setting(environment: Environment, row: Row) -> Operation:
    """The source of TORQUEREF and its enabling, and its ramps in ms."""
    references, name = environment.part(TorqueReferences), row.name

    def write(axis: int, value: float) -> None:
        row.check(value)
        if name == "TORQUEREFSOURCE" and value:
            checked(int(value) - 1, LAST_ANALOGUE, "analogue input")
        references.set(name, axis_of(environment, axis), value)

    return write


@moving
def read_demand(environment: Environment, row: Row) -> Operation:
    """TORQUEDEMAND: the output to the motor, percent."""
    output = environment.controller.servo_output
    return lambda axis: 100.0 * output(axis_of(environment, axis)) / FULL


@moving
def read_effort(environment: Environment, row: Row) -> Operation:
    """EFFORT: how much of what it can do the motor is asked for."""
    demand = read_demand(environment, row)
    return lambda axis: abs(demand(axis))


@moving
def read_current(environment: Environment, row: Row) -> Operation:
    """CURRENTMEAS and CURRENTDEMAND: of a simulated motor, whose amplifier does what is asked of it."""
    current = environment.controller.motor_current

    def read(axis: int, channel: int) -> float:
        axis_of(environment, axis)
        if channel:
            hint = "channel 0 is the current of the motor, the only one that is simulated"
            raise Refusal("channel", f"{row.name}: there is no current {channel}", hint)
        return current(axis)

    return read


OPERATIONS = {
    "torque.reference": {"read": read_reference, "write": write_reference},
    "torque.setting": {"read": read_setting, "write": write_setting},
    "torque.demand": {"read": read_demand},
    "torque.effort": {"read": read_effort},
    "torque.current": {"read": read_current},
}
