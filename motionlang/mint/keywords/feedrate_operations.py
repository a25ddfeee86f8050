"""Ramps and speeds that are given in another way: by times, by percentages, for single moves."""

from __future__ import annotations

from math import inf

from motionlang.controller.faults import Refusal
from motionlang.mint.runtime.binding import axis_of, scale_of
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

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
        rate = most / seconds if seconds else 0.0
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


def read_override(environment: Environment, row: Row) -> Operation:
    setting = environment.controller.setting
    return lambda axis: 100.0 * float(setting(axis_of(environment, axis), "override"))  # type: ignore[arg-type]


@repeatable
def write_override(environment: Environment, row: Row) -> Operation:
    def write(axis: int, value: float) -> None:
        row.check(value)
        environment.controller.configure(axis_of(environment, axis), "override", value / 100.0)

    return write


def _parameter(parameter: int) -> str:
    if not 0 <= parameter < len(PARAMETERS):
        hint = "0 is the speed, 1 the acceleration, 2 the deceleration"
        raise Refusal("range", f"FEEDRATEPARAMETER has no parameter {parameter}", hint)
    return PARAMETERS[parameter]


def read_parameter(environment: Environment, row: Row) -> Operation:
    """FEEDRATEPARAMETER, user units; 0 where moves have the axis's own rate."""
    axes = environment.controller.axes

    def read(axis: int, parameter: int) -> float:
        unit, scale = _parameter(parameter), scale_of(environment, axis)
        own = axes[axis].own_rates
        return scale.to_user((own[parameter] if own is not None else None) or 0.0, unit)

    return read


def write_parameter(environment: Environment, row: Row) -> Operation:
    """FEEDRATEPARAMETER: a rate for the moves that are loaded from now on, user units; 0 takes it back."""
    controller = environment.controller

    def write(axis: int, parameter: int, value: float) -> None:
        row.check(value)
        unit, scale = _parameter(parameter), scale_of(environment, axis)
        own = list(controller.axes[axis].own_rates or (None, None, None))
        own[parameter] = abs(scale.to_counts(value, unit)) or None
        controller.configure(axis, "own_rates", tuple(own) if any(own) else None)

    return write


def read_time_to_most(environment: Environment, row: Row) -> Operation:
    """ACCELTIMEMAX and DECELTIMEMAX, ms; 0 without MAXSPEED."""
    axes, which = environment.controller.axes, 0 if row.name.startswith("ACCEL") else 1

    def read(axis: int) -> int:
        a = axes[axis_of(environment, axis)]
        rate = a.rates(a.speed)[which]
        return round(a.max_speed / rate * 1000.0) if rate and a.max_speed < inf else 0

    return read


@repeatable
def write_time_to_most(environment: Environment, row: Row) -> Operation:
    """ACCELTIMEMAX and DECELTIMEMAX, ms from rest to MAXSPEED."""
    times, name = environment.part(TimesToMost), row.name

    def write(axis: int, milliseconds: float) -> None:
        row.check(milliseconds)
        times.set(name, axis_of(environment, axis), milliseconds / 1000.0)

    return write


def read_jerk_time(environment: Environment, row: Row) -> Operation:
    """In ms, also where the jerk itself was written."""
    axes, which = environment.controller.axes, 0 if row.name.startswith("ACCEL") else 1

    def read(axis: int) -> int:
        a = axes[axis_of(environment, axis)]
        jerk = a.decel_jerk if which else a.accel_jerk
        return round(a.rates(a.speed)[which] / jerk * 1000.0)

    return read


@repeatable
def write_jerk_time(environment: Environment, row: Row) -> Operation:
    """ACCELJERKTIME and DECELJERKTIME, ms in which a rate builds up."""
    configure = environment.controller.configure
    name = "accel_jerk_time" if row.name.startswith("ACCEL") else "decel_jerk_time"

    def write(axis: int, milliseconds: float) -> None:
        row.check(milliseconds)
        configure(axis_of(environment, axis), name, milliseconds / 1000.0)

    return write


def read_s_ramp(environment: Environment, row: Row) -> Operation:
    """SRAMP, percent."""
    axes = environment.controller.axes

    def read(axis: int) -> float:
        a = axes[axis_of(environment, axis)]
        return 100.0 * (a.s_ramp or 0.0)

    return read


@repeatable
def write_s_ramp(environment: Environment, row: Row) -> Operation:
    """SRAMP: the percentage of a ramp that is rounded; it replaces jerk times, and 0 makes trapezoids."""
    configure = environment.controller.configure

    def write(axis: int, percent: float) -> None:
        row.check(percent)
        axis_of(environment, axis)
        for name in ("accel_jerk_time", "decel_jerk_time"):
            configure(axis, name, None)
        configure(axis, "shape", "scurve" if percent else "trapezoid")
        configure(axis, "s_ramp", percent / 100.0 if percent else None)

    return write


def read_limit(environment: Environment, row: Row) -> Operation:
    """MAXSPEED and the like; without a limit the largest number that they take."""
    axes = environment.controller.axes
    attribute = {"MAXSPEED": "max_speed", "MAXACCEL": "max_accel", "MAXDECEL": "max_decel"}[row.name]

    def read(axis: int) -> float:
        scale = scale_of(environment, axis)
        value: float = getattr(axes[axis], attribute)
        return 8388607.0 if value == inf else scale.to_user(value, row.unit)

    return read


@repeatable
def write_limit(environment: Environment, row: Row) -> Operation:
    """MAXSPEED, MAXACCEL and MAXDECEL, user units; rates that were times to MAXSPEED follow it."""
    configure, times = environment.controller.configure, environment.part(TimesToMost)
    attribute = {"MAXSPEED": "max_speed", "MAXACCEL": "max_accel", "MAXDECEL": "max_decel"}[row.name]

    def write(axis: int, value: float) -> None:
        row.check(value)
        configure(axis, attribute, abs(scale_of(environment, axis).to_counts(value, row.unit)))
        if attribute == "max_speed":
            times.renew(axis)

    return write


OPERATIONS = {
    "feedrate.override": {"read": read_override, "write": write_override},
    "feedrate.parameter": {"read": read_parameter, "write": write_parameter},
    "feedrate.limit": {"read": read_limit, "write": write_limit},
    "feedrate.time_to_most": {"read": read_time_to_most, "write": write_time_to_most},
    "feedrate.jerk_time": {"read": read_jerk_time, "write": write_jerk_time},
    "feedrate.s_ramp": {"read": read_s_ramp, "write": write_s_ramp},
}
