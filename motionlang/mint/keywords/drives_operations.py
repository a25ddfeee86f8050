"""References of a drive: SPEEDREF and its ramps, SPEEDTESTREF, VELREF, POSREF.

A ramp is given as the time from rest to the drive's highest speed.
"""

from __future__ import annotations

from math import inf

from motionlang.controller.clock import INFINITY
from motionlang.controller.motion.reference import PERIOD
from motionlang.mint.keywords.axis_settings import Settings, reading, writing
from motionlang.mint.keywords.io_outputs import Analogue, analogue_input
from motionlang.mint.runtime.binding import Row, of, of_word
from motionlang.mint.runtime.changes import moving, repeatable
from motionlang.mint.runtime.environment import Environment
from motionlang.profile.reference import Slope

# Settings that are not 0 until they are written.
DEFAULTS = {"SPEEDREFENABLE": 1.0}


class Drives(Settings):
    """The settings of drives, by keyword and axis (speeds in counts/s, times in ms), and their references."""

    defaults = DEFAULTS
    in_counts = unsigned = True

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        # The line of the program that wrote a reference last, by its word and axis.
        self._lines: dict[tuple[str, int], int] = {}
        self.controller.analogue_inputs.listeners.append(self._analogue)

    def set(self, name: str, axis: int, value: float) -> None:
        if name == "SPEEDREFSOURCE" and value:
            analogue_input(int(value) - 1)
        super().set(name, axis, value)
        if name in ("SPEEDREFENABLE", "SPEEDREFSOURCE") and ("SPEEDREF", axis) in self._lines:
            self.run(axis)

    def refer(self, name: str, axis: int, velocity: float, line: int) -> None:
        """A speed reference is written: SPEEDREF or SPEEDTESTREF, counts/s."""
        self._settings[name, axis] = velocity
        self._lines[name, axis] = line
        self.run(axis, name, velocity != 0.0)

    def run(self, axis: int, name: str = "SPEEDREF", takes: bool = False) -> None:
        """Let the axis follow its reference; from another motion only a reference `takes` it that was just written."""
        velocity, most = self.wanted(axis, name), self.setting("DRIVESPEEDMAX", axis) or inf
        if not self.runs(axis, name) and not (velocity and (takes or self.controller.is_idle(axis))):
            return
        error_time = self.setting("SPEEDREFERRORDECELTIME", axis)
        rate = top_speed(self.environment, axis) / error_time * 1000.0 if error_time else 0.0
        limited = max(-most, min(velocity, most))
        line = self._lines.get((name, axis), 0)
        self.controller.refer_speed(axis, limited, self._slopes(axis, name), rate, name, line)

    def runs(self, axis: int, name: str) -> bool:
        """Whether a reference has the axis."""
        move = self.controller.axes[axis].move
        return move is not None and move.command == name

    def wanted(self, axis: int, name: str = "SPEEDREF") -> float:
        """The reference in force, counts/s: what was written, or an analogue input of the highest speed."""
        if name != "SPEEDREF":
            return self.setting(name, axis)
        if not self.setting("SPEEDREFENABLE", axis):
            return 0.0
        source = int(self.setting("SPEEDREFSOURCE", axis))
        if not source:
            return self.setting(name, axis)
        share = self.environment.part(Analogue).read(source - 1) / 100.0
        return share * top_speed(self.environment, axis)

    def _slopes(self, axis: int, name: str) -> tuple[Slope, Slope]:
        a, top = self.controller.axes[axis], top_speed(self.environment, axis)
        times = [self.setting(f"{name}{way}TIME", axis) / 1000.0 for way in ("ACCEL", "DECEL")]
        rates = (0.0, 0.0) if all(times) else self.controller.rates(a, a.speed)
        made = []
        for way, time, rate in zip(("ACCEL", "DECEL"), times, rates, strict=True):
            edges = [self.setting(f"{name}{way}JERK{edge}TIME", axis) / 1000.0 for edge in ("START", "END")]
            made.append(Slope(top / time if time else rate, *edges))
        return made[0], made[1]

    def _analogue(self, channel: int, value: float) -> None:
        for name, axis in list(self._settings):
            hears = name == "SPEEDREFSOURCE" and self._settings[name, axis] == channel + 1
            if hears and not self.controller.faults(axis) and self.controller.is_enabled(axis):
                self.run(axis)


def top_speed(environment: Environment, axis: int) -> float:
    """The highest speed of an axis, counts/s: DRIVESPEEDMAX, else MAXSPEED, else SPEED."""
    a = environment.controller.axes[axis]
    most = environment.part(Drives).setting("DRIVESPEEDMAX", axis)
    return most or (a.max_speed if a.max_speed < INFINITY else a.speed)


# ----------------------------------------------------------------------------------------------- operations


def write_speed(drives: Drives, row: Row, axis: int, value: float, line: int) -> None:
    """SPEEDREF and SPEEDTESTREF, user units a second."""
    drives.refer(row.name, axis, drives.scale(axis).to_counts(value, row.unit), line)


def read_speed(drives: Drives, row: Row, axis: int) -> float:
    """SPEEDREF and SPEEDTESTREF: the reference in force, from an analogue input where one is its source."""
    return drives.scale(axis).to_user(drives.wanted(axis, row.name), row.unit)


def write_velocity(drives: Drives, row: Row, axis: int, value: float, line: int) -> None:
    """VELREF: within a period of the profiler the axis has the velocity."""
    controller, velocity = drives.controller, drives.scale(axis).to_counts(value, row.unit)
    if velocity == drives.setting(row.name, axis) and drives.runs(axis, row.name):
        return
    drives.set(row.name, axis, velocity)
    change = abs(velocity - controller.demand_velocity(axis))
    slope = Slope(max(change, 1.0) / PERIOD)
    controller.refer_speed(axis, velocity, (slope, slope), 0.0, row.name, line)


def write_position(environment: Environment, row: Row, axis: int, value: float, line: int) -> None:
    """POSREF."""
    controller = environment.controller
    place = controller.axes[axis].scale.position_to_counts(value + environment.turn(axis))
    controller.refer_position(axis, place, row.name, line)


def read_position(environment: Environment, axis: int) -> float:
    """Where the reference is, or would begin: the target of the axis, as far as it has one."""
    target = environment.controller.axes[axis].target
    return environment.place(axis, target if abs(target) < INFINITY else environment.controller.demand(axis))


def read_error(environment: Environment, row: Row, axis: int) -> float:
    """Demanded minus measured velocity."""
    controller = environment.controller
    error = controller.demand_velocity(axis) - controller.velocity(axis)
    return controller.axes[axis].scale.to_user(error, row.unit)


OPERATIONS = {
    "drives.setting": {"read": reading(Drives), "write": repeatable(writing(Drives))},
    "drives.speed": {
        "read": of_word(Drives, read_speed),
        "write": repeatable(of_word(Drives, write_speed)),
    },
    "drives.velocity": {
        "read": reading(Drives),
        "write": repeatable(of_word(Drives, write_velocity)),
    },
    "drives.position": {
        "read": of(Environment, read_position),
        "write": of_word(Environment, write_position),
    },
    "drives.error": {"read": moving(of_word(Environment, read_error))},
}
