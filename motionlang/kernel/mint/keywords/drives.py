"""References of a drive: SPEEDREF and its ramps, SPEEDTESTREF, VELREF, POSREF.

A ramp is given by the time from rest to the drive's highest speed.
"""

from __future__ import annotations

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.motion.reference import PERIOD
from motionlang.kernel.lang.keyword import Actions, Keyword, kind_of
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.io_outputs import Analogue, analogue_input
from motionlang.kernel.mint.runtime.binding import of, of_word, scale_of
from motionlang.kernel.mint.runtime.changes import moving, repeatable
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.planners.reference import Slope

# Settings with a default other than 0.
DEFAULTS = {"SPEEDREFENABLE": 1.0}


class Drives(StoredSettings):
    """The settings of drives, by keyword and axis, and their references.

    Speeds are in counts/s, times in ms.
    """

    defaults = DEFAULTS
    in_counts = unsigned = True

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        # The program line that last wrote a reference, by keyword and axis.
        self._lines: dict[tuple[str, int], int] = {}
        self.controller.analogue_inputs.listen(self._analogue)

    def set(self, name: str, axis: int, value: float) -> None:
        if name == "SPEEDREFSOURCE" and value:
            analogue_input(int(value) - 1)
        super().set(name, axis, value)
        if name in ("SPEEDREFENABLE", "SPEEDREFSOURCE") and ("SPEEDREF", axis) in self._lines:
            self.run(axis)

    def refer(self, name: str, axis: int, velocity: float, line: int) -> None:
        """Set a new speed reference, SPEEDREF or SPEEDTESTREF, in counts/s."""
        self._settings[name, axis] = velocity
        self._lines[name, axis] = line
        self.run(axis, name, velocity != 0.0)

    def run(self, axis: int, name: str = "SPEEDREF", takes: bool = False) -> None:
        """Make the axis follow its reference.

        A reference replaces another motion only if it was just written (`takes`).
        """
        velocity, most = self.wanted(axis, name), self.setting("DRIVESPEEDMAX", axis) or INFINITY
        if not self.runs(axis, name) and not (velocity and (takes or self.controller.is_idle(axis))):
            return
        error_time = self.setting("SPEEDREFERRORDECELTIME", axis)
        rate = top_speed(self.environment, axis) / error_time * 1000.0 if error_time else 0.0
        line = self._lines.get((name, axis), 0)
        self.controller.refer_speed(axis, velocity, self._slopes(axis, name), rate, name, line, most)

    def runs(self, axis: int, name: str) -> bool:
        """True if the axis follows this reference."""
        move = self.controller.axes[axis].move
        return move is not None and move.command == name

    def wanted(self, axis: int, name: str = "SPEEDREF") -> float:
        """Return the reference in force in counts/s.

        This is the value written, or the value of an analogue input as a fraction of the highest speed.
        """
        if name != "SPEEDREF":
            return self.setting(name, axis)
        if not self.setting("SPEEDREFENABLE", axis):
            return 0.0
        source = int(self.setting("SPEEDREFSOURCE", axis))
        if not source:
            return self.setting(name, axis)
        share = self.environment.component(Analogue).read(source - 1) / 100.0
        return share * top_speed(self.environment, axis)

    def _slopes(self, axis: int, name: str) -> tuple[Slope, Slope]:
        top = top_speed(self.environment, axis)
        times = [self.setting(f"{name}{ramp}TIME", axis) / 1000.0 for ramp in ("ACCEL", "DECEL")]
        rates = (0.0, 0.0) if all(times) else self.controller.rates(axis)
        made = []
        for ramp, time, rate in zip(("ACCEL", "DECEL"), times, rates, strict=True):
            edges = [self.setting(f"{name}{ramp}JERK{edge}TIME", axis) / 1000.0 for edge in ("START", "END")]
            made.append(Slope(top / time if time else rate, *edges))
        return made[0], made[1]

    def _analogue(self, channel: int, value: float) -> None:
        for name, axis in list(self._settings):
            hears = name == "SPEEDREFSOURCE" and self._settings[name, axis] == channel + 1
            if hears and not self.controller.faults(axis) and self.controller.is_enabled(axis):
                self.run(axis)


def top_speed(environment: Environment, axis: int) -> float:
    """Return the highest speed in counts/s.

    This is DRIVESPEEDMAX; if that is not set, MAXSPEED; if that is not set either, SPEED.
    """
    a = environment.controller.axes[axis]
    most = environment.component(Drives).setting("DRIVESPEEDMAX", axis)
    return most or (a.max_speed if a.max_speed < INFINITY else a.speed)


# ----------------------------------------------------------------------------------------------- operations


def write_speed(drives: Drives, row: Keyword, axis: int, value: float, line: int) -> None:
    """SPEEDREF and SPEEDTESTREF: write the reference in user units per second."""
    drives.refer(row.name, axis, drives.scale(axis).to_counts(value, row.unit), line)


def read_speed(drives: Drives, row: Keyword, axis: int) -> float:
    """SPEEDREF and SPEEDTESTREF: return the reference in force, in user units/s.

    It may come from an analogue input.
    """
    return drives.scale(axis).to_user(drives.wanted(axis, row.name), row.unit)


def write_velocity(drives: Drives, row: Keyword, axis: int, value: float, line: int) -> None:
    """VELREF: reach a velocity within one period of the profiler."""
    controller, velocity = drives.controller, drives.scale(axis).to_counts(value, row.unit)
    if velocity == drives.setting(row.name, axis) and drives.runs(axis, row.name):
        return
    drives.set(row.name, axis, velocity)
    change = abs(velocity - controller.demand_velocity(axis))
    slope = Slope(max(change, 1.0) / PERIOD)
    controller.refer_speed(axis, velocity, (slope, slope), 0.0, row.name, line)


def write_position(environment: Environment, row: Keyword, axis: int, value: float, line: int) -> None:
    """POSREF: write a position reference."""
    controller = environment.controller
    controller.refer_position(axis, environment.absolute_counts(axis, value), row.name, line)


def read_position(environment: Environment, axis: int) -> float:
    """POSREF: return the target of the axis or, without one, its demand."""
    target = environment.controller.axes[axis].target
    return scale_of(environment, axis).shown_position(
        target if abs(target) < INFINITY else environment.controller.demand(axis)
    )


def read_error(environment: Environment, row: Keyword, axis: int) -> float:
    """Return the demanded minus the measured velocity."""
    controller = environment.controller
    error = controller.demand_velocity(axis) - controller.velocity(axis)
    return controller.axes[axis].scale.to_user(error, row.unit)


# ------------------------------------------------------------------------------------------------- keywords

_SETTING = Actions(read=setting_reader(Drives), write=repeatable(setting_writer(Drives)))
_SPEED = Actions(read=of_word(Drives, read_speed), write=repeatable(of_word(Drives, write_speed)))
_POSITION = Actions(read=of(Environment, read_position), write=of_word(Environment, write_position))
_ERROR = Actions(read=moving(of_word(Environment, read_error)))

_MAX_VALUE = 8388607.0
_MAX_TIME = 2147483647.0
_RUN = "DRIVESPEEDMAX(0) = 1000 : SPEEDREFACCELTIME(0) = 500 : SPEEDREFDECELTIME(0) = 500\n"
_STOP = "\nSPEEDREF(0) = 0\nPAUSE IDLE(0)\nPRINT POS(0)"


def _setting(name: str, unit: str, help: str, example: str, high: float, default: float = 0.0, short: str = "",
             effect: str = "") -> Keyword:  # fmt: skip
    return Keyword(name, short, "setting", "RW", "axis", unit, _SETTING, help, example, default=default, low=0,
                   high=high, group="axis", effect=effect)  # fmt: skip


def _time(name: str, help: str) -> Keyword:
    return _setting(name, "number", help, f"{name}(0) = 200\nPRINT {name}(0)", _MAX_TIME)


def _ignored(environment: Environment, axis: int, value: float) -> None:
    """Accept a value that has no effect."""


def _reading(
    name: str, short: str, unit: str, actions: str | Actions, help: str, access: str = "R"
) -> Keyword:
    return Keyword(name, short, kind_of(access), access, "axis", unit, actions, help,
                   f"JOG(0) = 100\nWAIT = 100\nPRINT {name}(0)\nCANCEL(0)", default=0.0, group="state")  # fmt: skip


def _reference(name: str, short: str, unit: str, actions: Actions, help: str, example: str) -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", unit, actions, help, example, default=0.0, low=-_MAX_VALUE,
                   high=_MAX_VALUE, group="motion", effect="act")  # fmt: skip


_EDGES = (
    ("ACCEL", "START", "from rest builds up"),
    ("ACCEL", "END", "fades as SPEEDREF is reached"),
    ("DECEL", "START", "to a lower SPEEDREF builds up"),
    ("DECEL", "END", "fades as the lower SPEEDREF is reached"),
)


ROWS = (
    _setting("DRIVESPEEDMAX", "uu/s",
             "The highest speed of the application: limits SPEEDREF, and is what its ramp times lead to.",
             "DRIVESPEEDMAX(0) = 1000\nPRINT DRIVESPEEDMAX(0)", _MAX_VALUE, short="dsm"),
    _reference("SPEEDREF", "sdr", "uu/s", _SPEED,
               "Speed reference: ramp to a speed in the SPEEDREF… times and keep it, until another one is written; 0 "
               "brings the axis to rest.", _RUN + "SPEEDREF(0) = 500\nWAIT = 1000\nPRINT VEL(0)" + _STOP),
    _setting("SPEEDREFENABLE", "bool", "0 lets the axis ramp to rest whatever SPEEDREF is, 1 lets it go on.",
             _RUN + "SPEEDREF(0) = 500\nSPEEDREFENABLE(0) = 0\nPAUSE IDLE(0)\nPRINT SPEEDREF(0)", 1, 1.0, effect="act"),
    _setting("SPEEDREFSOURCE", "integer",
             "Source of the speed reference: 0 SPEEDREF, n analogue input n - 1, whose 100 % are the "
             "highest speed.",
             "SPEEDREFSOURCE(0) = 1\nPRINT SPEEDREF(0)", 64, effect="hands-over"),
    _time("SPEEDREFACCELTIME", "Time of a SPEEDREF ramp from rest to the highest speed (DRIVESPEEDMAX, else MAXSPEED, "
                               "else SPEED), ms; 0 uses ACCEL."),
    _time("SPEEDREFDECELTIME", "Time of a SPEEDREF ramp from the highest speed to rest, ms; 0 uses DECEL."),
    *(_time(f"SPEEDREF{ramp}JERK{edge}TIME", f"Milliseconds in which the {ramp.lower()}eration {what}; the ramp grows "
                                            "by half of it.") for ramp, edge, what in _EDGES),
    _time("SPEEDREFERRORDECELTIME", "Milliseconds from the highest speed to rest when an error stops an axis that "
                                    "follows SPEEDREF; 0 for ERRORDECEL."),
    _reference("SPEEDTESTREF", "", "uu/s", _SPEED,
               "A speed reference for tests, with ramps of its own.",
               "DRIVESPEEDMAX(0) = 1000 : SPEEDTESTREFACCELTIME(0) = 500 : SPEEDTESTREFDECELTIME(0) = 500\n"
               "SPEEDTESTREF(0) = 500\nWAIT = 1000\nPRINT VEL(0)\nSPEEDTESTREF(0) = 0"),
    _time("SPEEDTESTREFACCELTIME", "Milliseconds from rest to the highest speed in ramps of SPEEDTESTREF."),
    _time("SPEEDTESTREFDECELTIME", "Milliseconds from the highest speed to rest in ramps of SPEEDTESTREF."),
    _reference("VELREF", "", "uu/s",
               Actions(read=setting_reader(Drives), write=repeatable(of_word(Drives, write_velocity))),
               "Velocity reference: within a millisecond the axis has this velocity, without a ramp of its own.",
               "VELREF(0) = 100\nWAIT = 100\nPRINT VEL(0)\nVELREF(0) = 0"),
    _reference("POSREF", "", "uu", _POSITION,
               "Position reference: within a millisecond the axis is there, in a straight line.",
               "POSREF(0) = 2\nWAIT = 2\nPRINT POS(0)"),
    _reading("SPEEDDEMAND", "sdd", "uu/s", Actions("demand_velocity", write=of(Environment, _ignored)),
             "The speed that the drive is to have now; SPEEDREF sets it. Writing SPEEDDEMAND changes nothing.", "RW"),
    _reading("SPEEDMEASURED", "sms", "uu/s", "velocity", "The measured speed, as VEL."),
    _reading("SPEEDERROR", "", "uu/s", _ERROR, "Demanded minus measured speed."),
    _reading("VELERROR", "", "uu/s", _ERROR, "Demanded minus measured velocity."),
)  # fmt: skip
