"""The speed of a move: FEEDRATE, its modes, override, limits, and ramps by time."""

from __future__ import annotations

from math import inf

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.runtime.binding import of, of_word
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment


class TimesToMost:
    """The rates that were set as times to reach MAXSPEED, by keyword and axis.

    Each time is stored with the rate that was computed from it.
    """

    def __init__(self, environment: Environment) -> None:
        self._controller = environment.controller
        self._given: dict[tuple[str, int], tuple[float, float]] = {}

    def set(self, name: str, axis: int, seconds: float) -> None:
        """Set the time in seconds in which the axis reaches its highest speed."""
        most = self._controller.axes[axis].max_speed
        if most == inf:
            raise Rejected("range", f"{name} needs the highest speed of axis {axis}", "set MAXSPEED first")
        rate = most / seconds
        self._given[name, axis] = seconds, rate
        self._controller.configure(axis, _rate(name), rate)

    def renew(self, axis: int) -> None:
        """Recompute these rates after a change of MAXSPEED.

        A rate that another keyword has set since then does not change.
        """
        for (name, each), (seconds, rate) in list(self._given.items()):
            a = self._controller.axes[axis]
            if each == axis and getattr(a, _rate(name)) == rate and getattr(a, f"{_rate(name)}_time") is None:
                self.set(name, axis, seconds)


def _rate(name: str) -> str:
    return "accel" if name.startswith("ACCEL") else "decel"


# ----------------------------------------------------------------------------------------------- operations


def read_time_to_most(environment: Environment, row: Keyword, axis: int) -> int:
    """ACCELTIMEMAX and DECELTIMEMAX: return the time in ms, 0 if MAXSPEED is not set."""
    a = environment.controller.axes[axis]
    rate = a.rates(a.speed)[_rate(row.name) == "decel"]
    return round(a.max_speed / rate * 1000.0) if rate and a.max_speed < inf else 0


def write_time_to_most(times: TimesToMost, row: Keyword, axis: int, milliseconds: float) -> None:
    """ACCELTIMEMAX and DECELTIMEMAX: set the time from rest to MAXSPEED in ms."""
    times.set(row.name, axis, milliseconds / 1000.0)


def read_jerk_time(environment: Environment, row: Keyword, axis: int) -> int:
    """Return a jerk time in ms, even if the jerk itself was written."""
    a = environment.controller.axes[axis]
    accel, decel = a.rates(a.speed)
    return round((accel / a.accel_jerk if _rate(row.name) == "accel" else decel / a.decel_jerk) * 1000.0)


def write_s_ramp(environment: Environment, axis: int, percent: float) -> None:
    """SRAMP: set the percentage of a ramp that is rounded; 0 is trapezoidal.

    It replaces the jerk times.
    """
    configure = environment.controller.configure
    for name in ("accel_jerk_time", "decel_jerk_time"):
        configure(axis, name, None)
    configure(axis, "shape", "scurve" if percent else "trapezoid")
    configure(axis, "s_ramp", percent / 100.0 if percent else None)


def read_limit(environment: Environment, row: Keyword, axis: int) -> float:
    """MAXSPEED, MAXACCEL and MAXDECEL: return the limit in user units.

    A limit that is not set reads as the largest valid value.
    """
    a = environment.controller.axes[axis]
    value: float = getattr(a, row.function)
    return 8388607.0 if value == inf else a.scale.to_user(value, row.unit)


def write_limit(environment: Environment, row: Keyword, axis: int, value: float) -> None:
    """MAXSPEED, MAXACCEL and MAXDECEL: set a limit in user units.

    Rates that were set as times to MAXSPEED change with it.
    """
    counts = abs(environment.controller.axes[axis].scale.to_counts(value, row.unit))
    environment.controller.configure(axis, row.function, counts)
    if row.function == "max_speed":
        environment.component(TimesToMost).renew(axis)


# ------------------------------------------------------------------------------------------------- keywords


def _limit(function: str) -> Actions:
    return Actions(
        function, read=of_word(Environment, read_limit), write=repeatable(of_word(Environment, write_limit))
    )


_TIME_TO_MOST = Actions(
    read=of_word(Environment, read_time_to_most), write=repeatable(of_word(TimesToMost, write_time_to_most))
)
_S_RAMP = Actions(
    read=of(Environment, lambda e, axis: 100.0 * (e.controller.axes[axis].s_ramp or 0.0)),
    write=repeatable(of(Environment, write_s_ramp)),
)

_MAX_VALUE = 8388607.0
_MAX_TIME = 2147483647.0
_HALF = "SPEED(0) = 20\nFEEDRATEMODE(0) = 2\nFEEDRATEOVERRIDE(0) = 50\nMOVER(0) = 100\nGO(0)\nWAIT = 100\nPRINT VEL(0)"


def _most(name: str, unit: str, actions: Actions, help: str, example: str) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, actions, help, example, default=_MAX_VALUE, low=1e-6,
                   high=1e12, group="axis")  # fmt: skip


def _ramp_time(name: str, actions: Actions, help: str, example: str, low: float, gives: str) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", "ms", actions, help, example, low=low, high=_MAX_TIME,
                   group="axis", gives=gives)  # fmt: skip


ROWS = (
    Keyword("FEEDRATE", "", "setting", "RW", "axis", "uu/s", "speed",
            "Another name of SPEED: slew speed of moves; with bit 0 of FEEDRATEMODE each keeps that of its loading.",
            "FEEDRATE(0) = 250\nPRINT FEEDRATE(0), SPEED(0)",
            default=40000.0, low=0.0, high=_MAX_VALUE, group="axis", gives="speed"),
    Keyword("FEEDRATEMODE", "FRM", "setting", "RW", "axis", "integer", "feedrate_mode",
            "Bit 0: moves keep the speed with which they are loaded; without it a new speed acts at once. "
            "Bit 1: FEEDRATEOVERRIDE acts.",
            "FEEDRATEMODE(0) = 1\nPRINT FEEDRATEMODE(0)", default=0.0, low=0, high=3, group="axis"),
    Keyword("FEEDRATEOVERRIDE", "FRO", "setting", "RW", "axis", "%", "override",
            "Percentage of its speed at which a move runs, where bit 1 of FEEDRATEMODE is set; it acts at once.",
            _HALF, default=100.0, low=0.0, high=_MAX_VALUE, group="axis"),
    _most("MAXSPEED", "uu/s", _limit("max_speed"),
          "The highest speed of moves, of JOG, of an axis on a path, and of OFFSET in its mode 1 and above.",
          "MAXSPEED(0) = 50\nSPEED(0) = 80\nMOVER(0) = 100\nGO(0)\nWAIT = 100\nPRINT VEL(0)"),
    _most("MAXACCEL", "uu/s2", _limit("max_accel"),
          "The highest acceleration of moves, of JOG and of an axis on a path.",
          "MAXACCEL(0) = 50\nPRINT MAXACCEL(0)"),
    _most("MAXDECEL", "uu/s2", _limit("max_decel"),
          "The highest deceleration of moves, of JOG, of STOP and on a path.",
          "MAXDECEL(0) = 50\nPRINT MAXDECEL(0)"),
    _ramp_time("ACCELTIMEMAX", _TIME_TO_MOST,
               "Acceleration given as the time from rest to MAXSPEED; replaces ACCEL.",
               "MAXSPEED(0) = 100\nACCELTIMEMAX(0) = 200\nPRINT ACCEL(0)", 0.001, "accel"),
    _ramp_time("DECELTIMEMAX", _TIME_TO_MOST,
               "Deceleration given as the time from MAXSPEED to rest; replaces DECEL.",
               "MAXSPEED(0) = 100\nDECELTIMEMAX(0) = 200\nPRINT DECEL(0)", 0.001, "decel"),
    _ramp_time("ACCELJERKTIME", Actions("accel_jerk_time", read=of_word(Environment, read_jerk_time)),
               "Jerk given as the time in which ACCEL builds up in an S-ramp, 0 for at once; replaces ACCELJERK.",
               "ACCEL(0) = 500\nACCELJERKTIME(0) = 100\nPRINT ACCELJERK(0)", 0, "accel jerk"),
    _ramp_time("DECELJERKTIME", Actions("decel_jerk_time", read=of_word(Environment, read_jerk_time)),
               "Jerk given as the time in which DECEL builds up in an S-ramp, 0 for at once; replaces DECELJERK.",
               "DECEL(0) = 500\nDECELJERKTIME(0) = 100\nPRINT DECELJERK(0)", 0, "decel jerk"),
    Keyword("SRAMP", "", "setting", "RW", "axis", "%", _S_RAMP,
            "Smoothing of ramps in percent: 0 a trapezoid, 100 acceleration that only rises and falls. Replaces "
            "PROFILEMODE and the jerks; ACCEL and DECEL stay the peaks, so ramps grow by this percentage.",
            "SPEED(0) = 100\nACCEL(0) = 500\nSRAMP(0) = 50\nPRINT ACCELJERK(0)",
            default=0.0, low=0.0, high=100.0, group="axis"),
)  # fmt: skip
