"""References of a drive: SPEEDREF and its ramps, SPEEDTESTREF, VELREF, POSREF.

A ramp is given as the time from rest to the drive's highest speed.
"""

from __future__ import annotations

from math import inf

from motionlang.controller.clock import INFINITY
from motionlang.controller.motion.reference import PERIOD
from motionlang.mint.keywords.axis_settings import forget
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.keywords.io_outputs import LAST_ANALOGUE, Analogue
from motionlang.mint.runtime.binding import axis_of, scale_of
from motionlang.mint.runtime.changes import moving, repeatable
from motionlang.profile.reference import Slope

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

# Settings that are not 0 until they are written.
DEFAULTS = {"SPEEDREFENABLE": 1.0}


class Drives:
    """The settings of drives, by keyword and axis (speeds in counts/s, times in ms), and their references."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._controller = environment.controller
        self._settings: dict[tuple[str, int], float] = {}
        # The line of the program that wrote a reference last, by its word and axis.
        self._lines: dict[tuple[str, int], int] = {}
        self._controller.analogue_inputs.listeners.append(self._analogue)

    def setting(self, name: str, axis: int) -> float:
        return self._settings.get((name, axis), DEFAULTS.get(name, 0.0))

    def set(self, name: str, axis: int, value: float) -> None:
        self._settings[name, axis] = value
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
        if not self.runs(axis, name) and not (velocity and (takes or self._controller.is_idle(axis))):
            return
        error_time = self.setting("SPEEDREFERRORDECELTIME", axis)
        rate = top_speed(self._environment, axis) / error_time * 1000.0 if error_time else 0.0
        limited = max(-most, min(velocity, most))
        line = self._lines.get((name, axis), 0)
        self._controller.refer_speed(axis, limited, self._slopes(axis, name), rate, name, line)

    def runs(self, axis: int, name: str) -> bool:
        """Whether a reference has the axis."""
        move = self._controller.axes[axis].move
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
        share = self._environment.part(Analogue).read(source - 1) / 100.0
        return share * top_speed(self._environment, axis)

    def default(self, axis: int) -> None:
        """DEFAULT."""
        forget(self._settings, axis)

    def _slopes(self, axis: int, name: str) -> tuple[Slope, Slope]:
        a, top = self._controller.axes[axis], top_speed(self._environment, axis)
        times = [self.setting(f"{name}{way}TIME", axis) / 1000.0 for way in ("ACCEL", "DECEL")]
        rates = (0.0, 0.0) if all(times) else self._controller.rates(a, a.speed)
        made = []
        for way, time, rate in zip(("ACCEL", "DECEL"), times, rates, strict=True):
            edges = [self.setting(f"{name}{way}JERK{edge}TIME", axis) / 1000.0 for edge in ("START", "END")]
            made.append(Slope(top / time if time else rate, *edges))
        return made[0], made[1]

    def _analogue(self, channel: int, value: float) -> None:
        for name, axis in list(self._settings):
            hears = name == "SPEEDREFSOURCE" and self._settings[name, axis] == channel + 1
            if hears and not self._controller.faults(axis) and self._controller.is_enabled(axis):
                self.run(axis)


def top_speed(environment: Environment, axis: int) -> float:
    """The highest speed of an axis, counts/s: DRIVESPEEDMAX, else MAXSPEED, else SPEED."""
    a = environment.controller.axes[axis]
    most = environment.part(Drives).setting("DRIVESPEEDMAX", axis)
    return most or (a.max_speed if a.max_speed < INFINITY else a.speed)


# ----------------------------------------------------------------------------------------------- operations


def read_setting(environment: Environment, row: Row) -> Operation:
    """DRIVESPEEDMAX, times in ms and the other settings of speed references."""
    drives, name, unit = environment.part(Drives), row.name, row.unit

    def read(axis: int) -> float:
        value = scale_of(environment, axis).to_user(drives.setting(name, axis), unit)
        return int(value) if unit in ("integer", "bool") else value

    return read


@repeatable
def write_setting(environment: Environment, row: Row) -> Operation:
    """DRIVESPEEDMAX, times in ms and the other settings of speed references."""
    drives, name, unit = environment.part(Drives), row.name, row.unit

    def write(axis: int, value: float) -> None:
        row.check(value)
        if name == "SPEEDREFSOURCE" and value:
            checked(int(value) - 1, LAST_ANALOGUE, "analogue input")
        drives.set(name, axis, abs(scale_of(environment, axis).to_counts(value, unit)))

    return write


@repeatable
def write_speed(environment: Environment, row: Row) -> Operation:
    """SPEEDREF and SPEEDTESTREF, user units a second."""
    drives, name, unit = environment.part(Drives), row.name, row.unit

    def write(axis: int, value: float, line: int) -> None:
        row.check(value)
        drives.refer(name, axis, scale_of(environment, axis).to_counts(value, unit), line)

    return write


def read_speed(environment: Environment, row: Row) -> Operation:
    """SPEEDREF and SPEEDTESTREF: the reference in force, from an analogue input where one is its source."""
    drives, name, unit = environment.part(Drives), row.name, row.unit

    def read(axis: int) -> float:
        return scale_of(environment, axis).to_user(drives.wanted(axis_of(environment, axis), name), unit)

    return read


@repeatable
def write_velocity(environment: Environment, row: Row) -> Operation:
    """VELREF: within a period of the profiler the axis has the velocity."""
    controller, drives = environment.controller, environment.part(Drives)

    def write(axis: int, value: float, line: int) -> None:
        row.check(value)
        velocity = scale_of(environment, axis).to_counts(value, row.unit)
        if velocity == drives.setting(row.name, axis) and drives.runs(axis, row.name):
            return
        drives.set(row.name, axis, velocity)
        change = abs(velocity - controller.demand_velocity(axis))
        slope = Slope(max(change, 1.0) / PERIOD)
        controller.refer_speed(axis, velocity, (slope, slope), 0.0, row.name, line)

    return write


def read_velocity(environment: Environment, row: Row) -> Operation:
    drives, name, unit = environment.part(Drives), row.name, row.unit
    return lambda axis: scale_of(environment, axis).to_user(drives.setting(name, axis), unit)


def write_position(environment: Environment, row: Row) -> Operation:
    """POSREF."""
    controller = environment.controller

    def write(axis: int, value: float, line: int) -> None:
        row.check(value)
        place = scale_of(environment, axis).position_to_counts(value + environment.turn(axis))
        controller.refer_position(axis, place, row.name, line)

    return write


def read_position(environment: Environment, row: Row) -> Operation:
    """Where the reference is, or would begin: the target of the axis, as far as it has one."""
    controller = environment.controller

    def read(axis: int) -> float:
        target = controller.axes[axis_of(environment, axis)].target
        place = target if abs(target) < INFINITY else controller.demand(axis)
        shown = scale_of(environment, axis).position_to_user(place)
        wrap = environment.wraps.get(axis)
        return shown % wrap if wrap else shown

    return read


@moving
def read_error(environment: Environment, row: Row) -> Operation:
    """Demanded minus measured velocity."""
    controller = environment.controller

    def read(axis: int) -> float:
        error = controller.demand_velocity(axis_of(environment, axis)) - controller.velocity(axis)
        return scale_of(environment, axis).to_user(error, row.unit)

    return read


OPERATIONS = {
    "drives.setting": {"read": read_setting, "write": write_setting},
    "drives.speed": {"read": read_speed, "write": write_speed},
    "drives.velocity": {"read": read_velocity, "write": write_velocity},
    "drives.position": {"read": read_position, "write": write_position},
    "drives.error": {"read": read_error},
}
