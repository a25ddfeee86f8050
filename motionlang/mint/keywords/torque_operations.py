"""TORQUEREF: an output of the motor that ramps, in place of its servo loop; and what the motor demands and draws.

The reference changes once a servo loop, as a drive's does, so a ramp is a flight of steps. It is percent of the full
output, which is torque where the machine file gives the motor a current amplifier.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.keywords.axis_settings import Settings, reading, writing
from motionlang.mint.keywords.defaults import LOOP_TIME, PERIOD
from motionlang.mint.keywords.io_outputs import Analogue, analogue_input
from motionlang.mint.runtime.binding import Row, of, of_word
from motionlang.mint.runtime.changes import moving
from motionlang.mint.runtime.environment import Environment

# Volts of one percent of full scale, and the full scale.
_PERCENT, FULL = 0.1, 10.0
DEFAULTS = {"TORQUEREFENABLE": 1.0}


class TorqueReferences(Settings):
    """The settings of torque references, by keyword and axis, and the ramps that are under way."""

    defaults = DEFAULTS

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        # The percent in force on axes whose output is the reference's.
        self._present: dict[int, float] = {}
        self._ramping: set[int] = set()
        self.controller.analogue_inputs.listeners.append(self._analogue)

    def set(self, name: str, axis: int, value: float) -> None:
        """Write a setting; an axis whose output is the reference's goes by it at once."""
        if name == "TORQUEREFSOURCE" and value:
            analogue_input(int(value) - 1)
        super().set(name, axis, value)
        if name in ("TORQUEREFENABLE", "TORQUEREFSOURCE") and (
            self.has(axis) or (name == "TORQUEREFSOURCE" and value)
        ):
            self.run(axis)

    def has(self, axis: int) -> bool:
        """Whether the output of the axis is the reference's: until something closes the loop again."""
        if axis in self._present and not self.controller.is_open(axis):
            del self._present[axis]
        return axis in self._present

    def wanted(self, axis: int) -> float:
        """Percent: what was written, or an analogue input."""
        if not self.setting("TORQUEREFENABLE", axis):
            return 0.0
        source = int(self.setting("TORQUEREFSOURCE", axis))
        return self.environment.part(Analogue).read(source - 1) if source else self.setting("TORQUEREF", axis)

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

    def _step(self, axis: int) -> None:
        """One servo loop of the ramp."""
        self._ramping.discard(axis)
        if not self.has(axis):
            return
        seconds = self.controller.gain(axis, PERIOD, LOOP_TIME) / 1e6
        present, wanted = self._present[axis], self.wanted(axis)
        following = self._next(axis, present, wanted, seconds)
        if following != present:
            self._open(axis, following)
        if following != wanted:
            self._ramping.add(axis)
            clock = self.environment.clock
            clock.at(clock.now + seconds, lambda: self._step(axis))

    def _next(self, axis: int, present: float, wanted: float, seconds: float) -> float:
        """The percent a servo loop later: it falls towards 0 and rises away from it."""
        rises = present * wanted >= 0.0 and abs(wanted) > abs(present)
        goal = wanted if present * wanted >= 0.0 else 0.0
        time = self.setting("TORQUEREFRISETIME" if rises else "TORQUEREFFALLTIME", axis) / 1000.0
        most = 100.0 * seconds / time if time else abs(goal - present)
        return goal if abs(goal - present) <= most else present + (most if goal > present else -most)

    def _open(self, axis: int, percent: float) -> None:
        self.controller.open_loop(axis, percent * _PERCENT)
        self._present[axis] = percent

    def _analogue(self, channel: int, value: float) -> None:
        for name, axis in list(self._settings):
            if name == "TORQUEREFSOURCE" and self._settings[name, axis] == channel + 1 and self.has(axis):
                self.run(axis)


# ----------------------------------------------------------------------------------------------- operations


def write_reference(references: TorqueReferences, row: Row, axis: int, percent: float, line: int) -> None:
    """TORQUEREF: ramp the motor's output to a percentage, in place of its servo loop."""
    references.set(row.name, axis, percent)
    references.run(axis)


def demand(environment: Environment, axis: int) -> float:
    """TORQUEDEMAND: the output to the motor, percent."""
    return 100.0 * environment.controller.servo_output(axis) / FULL


def read_current(environment: Environment, row: Row, axis: int, channel: int) -> float:
    """CURRENTMEAS and CURRENTDEMAND: of a simulated motor, whose amplifier does what is asked of it."""
    if channel:
        hint = "channel 0 is the current of the motor, the only one that is simulated"
        raise Refusal("channel", f"{row.name}: there is no current {channel}", hint)
    return environment.controller.motor_current(axis)


OPERATIONS = {
    "torque.reference": {
        "read": of(TorqueReferences, TorqueReferences.wanted),
        "write": of_word(TorqueReferences, write_reference),
    },
    "torque.setting": {"read": reading(TorqueReferences), "write": writing(TorqueReferences)},
    "torque.demand": {"read": moving(of(Environment, demand))},
    "torque.effort": {"read": moving(of(Environment, lambda e, axis: abs(demand(e, axis))))},
    "torque.current": {"read": moving(of_word(Environment, read_current))},
}
