"""Ramps and speeds that are given in another way: by times, by percentages, for single moves."""

from __future__ import annotations

from math import inf

from motionlang.controller.faults import Refusal
from motionlang.mint.runtime.binding import Row, of, of_word
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment

# FEEDRATEPARAMETER: what each parameter is, in user units.
PARAMETERS = ("uu/s", "uu/s2", "uu/s2")


class TimesToMost:
    """Which rates were given as times to MAXSPEED: the rate that was made of each, by keyword and axis."""

    def __init__(self, environment: Environment) -> None:
        self._controller = environment.controller
        self._given: dict[tuple[str, int], tuple[float, float]] = {}

    def set(self, name: str, axis: int, seconds: float) -> None:
        """Have the axis reach its highest speed in a time."""
        most = self._controller.axes[axis].max_speed
        if most == inf:
            raise Refusal("range", f"{name} needs the highest speed of axis {axis}", "set MAXSPEED first")
        rate = most / seconds
        self._given[name, axis] = seconds, rate
        self._controller.configure(axis, _rate(name), rate)

    def renew(self, axis: int) -> None:
        """MAXSPEED has changed: so do the rates that are still those made of it."""
        for (name, each), (seconds, rate) in list(self._given.items()):
            a = self._controller.axes[axis]
            if each == axis and getattr(a, _rate(name)) == rate and getattr(a, f"{_rate(name)}_time") is None:
                self.set(name, axis, seconds)


def _rate(name: str) -> str:
    return "accel" if name.startswith("ACCEL") else "decel"


# ----------------------------------------------------------------------------------------------- operations


def _parameter(parameter: int) -> str:
    if not 0 <= parameter < len(PARAMETERS):
        hint = "0 is the speed, 1 the acceleration, 2 the deceleration"
        raise Refusal("range", f"FEEDRATEPARAMETER has no parameter {parameter}", hint)
    return PARAMETERS[parameter]


def read_parameter(environment: Environment, axis: int, parameter: int) -> float:
    """FEEDRATEPARAMETER, user units; 0 where moves have the axis's own rate."""
    a, unit = environment.controller.axes[axis], _parameter(parameter)
    return a.scale.to_user((a.own_rates[parameter] if a.own_rates is not None else None) or 0.0, unit)


def write_parameter(environment: Environment, axis: int, parameter: int, value: float) -> None:
    """FEEDRATEPARAMETER: a rate for the moves that are loaded from now on, user units; 0 takes it back."""
    a, unit = environment.controller.axes[axis], _parameter(parameter)
    own = list(a.own_rates or (None, None, None))
    own[parameter] = abs(a.scale.to_counts(value, unit)) or None
    environment.controller.configure(axis, "own_rates", tuple(own) if any(own) else None)


def read_time_to_most(environment: Environment, row: Row, axis: int) -> int:
    """ACCELTIMEMAX and DECELTIMEMAX, ms; 0 without MAXSPEED."""
    a = environment.controller.axes[axis]
    rate = a.rates(a.speed)[_rate(row.name) == "decel"]
    return round(a.max_speed / rate * 1000.0) if rate and a.max_speed < inf else 0


def write_time_to_most(times: TimesToMost, row: Row, axis: int, milliseconds: float) -> None:
    """ACCELTIMEMAX and DECELTIMEMAX, ms from rest to MAXSPEED."""
    times.set(row.name, axis, milliseconds / 1000.0)


def read_jerk_time(environment: Environment, row: Row, axis: int) -> int:
    """In ms, also where the jerk itself was written."""
    a = environment.controller.axes[axis]
    accel, decel = a.rates(a.speed)
    return round((accel / a.accel_jerk if _rate(row.name) == "accel" else decel / a.decel_jerk) * 1000.0)


def write_s_ramp(environment: Environment, axis: int, percent: float) -> None:
    """SRAMP: the percentage of a ramp that is rounded; it replaces jerk times, and 0 makes trapezoids."""
    configure = environment.controller.configure
    for name in ("accel_jerk_time", "decel_jerk_time"):
        configure(axis, name, None)
    configure(axis, "shape", "scurve" if percent else "trapezoid")
    configure(axis, "s_ramp", percent / 100.0 if percent else None)


def read_limit(environment: Environment, row: Row, axis: int) -> float:
    """MAXSPEED and the like; without a limit the largest number that they take."""
    a = environment.controller.axes[axis]
    value: float = getattr(a, row.verb)
    return 8388607.0 if value == inf else a.scale.to_user(value, row.unit)


def write_limit(environment: Environment, row: Row, axis: int, value: float) -> None:
    """MAXSPEED, MAXACCEL and MAXDECEL, user units; rates that were times to MAXSPEED follow it."""
    counts = abs(environment.controller.axes[axis].scale.to_counts(value, row.unit))
    environment.controller.configure(axis, row.verb, counts)
    if row.verb == "max_speed":
        environment.part(TimesToMost).renew(axis)


_LIMIT = {"read": of_word(Environment, read_limit), "write": repeatable(of_word(Environment, write_limit))}
OPERATIONS = {
    "feedrate.parameter": {
        "read": of(Environment, read_parameter),
        "write": of(Environment, write_parameter),
    },
    **dict.fromkeys(("max_speed", "max_accel", "max_decel"), _LIMIT),
    "feedrate.time_to_most": {
        "read": of_word(Environment, read_time_to_most),
        "write": repeatable(of_word(TimesToMost, write_time_to_most)),
    },
    "accel_jerk_time": {"read": of_word(Environment, read_jerk_time)},
    "decel_jerk_time": {"read": of_word(Environment, read_jerk_time)},
    "feedrate.s_ramp": {
        "read": of(Environment, lambda e, axis: 100.0 * (e.controller.axes[axis].s_ramp or 0.0)),
        "write": repeatable(of(Environment, write_s_ramp)),
    },
}
