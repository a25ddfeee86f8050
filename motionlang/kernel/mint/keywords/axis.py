"""Settings of an axis: scale, speeds, rates, jerks, profile shape, enabling."""

from __future__ import annotations

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.runtime.binding import Maker, of, scale_of, unchecked
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment


def do_default_axes(environment: Environment, axes: tuple[int, ...], line: int) -> None:
    """AXES: set the default axes of the task."""
    for axis in axes:
        scale_of(environment, axis)
    environment.task.axes = axes


def write_buffer_size(environment: Environment, axis: int, value: int) -> None:
    """MOVEBUFFERSIZE: set the buffer size; raise Rejected unless the buffer is empty."""
    a = environment.controller.axes[axis]
    if a.move is not None or a.buffer:
        words = f"the move buffer of axis {axis} is in use"
        raise Rejected("buffer-in-use", words, f"PAUSE IDLE({axis}) waits until it is empty")
    environment.controller.configure(axis, "buffer_size", value)


def ramp_time(rate: str) -> Maker:
    """Make an operation that returns a ramp time in ms, even if a rate was written."""
    time = f"{rate}_time"

    def read(environment: Environment, axis: int) -> int:
        a = environment.controller.axes[axis]
        seconds: float | None = getattr(a, time)
        return round((a.speed / getattr(a, rate) if seconds is None else seconds) * 1000.0)

    return of(Environment, read)


def ramp_rate(rate: str) -> Maker:
    """Make an operation that returns a rate in user units, even if a time was written."""
    time = f"{rate}_time"

    def read(environment: Environment, axis: int) -> float:
        a = environment.controller.axes[axis]
        seconds: float | None = getattr(a, time)
        return a.scale.to_user(getattr(a, rate) if seconds is None else a.speed / seconds, "uu/s2")

    return of(Environment, read)


def write_profile_mode(environment: Environment, axis: int, value: int) -> None:
    """PROFILEMODE: choose the S-curve or the trapezoidal profile."""
    environment.controller.configure(axis, "shape", "scurve" if value == 1 else "trapezoid")


def write_enabled(environment: Environment, axis: int, value: int) -> None:
    """DRIVEENABLE: enable or disable the axis."""
    controller = environment.controller
    (controller.enable if value else controller.disable)(axis)


# ------------------------------------------------------------------------------------------------- keywords

# Settings are stored in counts, as in the controller, so a program sets the scale first.
_SCALE = Actions(
    read=of(Environment, lambda e, axis: float(scale_of(e, axis).counts)),
    write=of(Environment, lambda e, axis, value: e.controller.set_scale(axis, value)),
)
_PROFILE_MODE = Actions(
    read=of(Environment, lambda e, axis: int(e.controller.setting(axis, "shape") == "scurve")),
    write=repeatable(of(Environment, write_profile_mode)),
)
_ENABLED = Actions(
    read=of(Environment, lambda e, axis: int(e.controller.is_enabled(axis))),
    write=unchecked(repeatable(of(Environment, write_enabled))),
)

_MAX_VALUE = 8388607.0
_MAX_TIME = 2147483647.0


ROWS = (
    Keyword("AXES", "", "command", "C", "axes", "", Actions("default_axes", do=of(Environment, do_default_axes)),
            "Which axes a keyword without brackets means, in this task; axis 0 until it is set.",
            "AXES[0, 1]\nSPEED = 10, 20\nPRINT SPEED(1)", group="axis"),
    Keyword("SCALEFACTOR", "SCALE", "setting", "RW", "axis", "number", _SCALE,
            "Encoder counts per user unit; every distance, speed and rate of the axis is in that unit.",
            "SCALEFACTOR(0) = 1200\nPRINT SCALEFACTOR(0)",
            default=1.0, low=1e-6, high=1e12, group="axis", effect="scale"),
    Keyword("POSSCALEFACTOR", "", "setting", "RW", "axis", "number", _SCALE,
            "Another name of SCALEFACTOR, on newer drives.",
            "POSSCALEFACTOR(0) = 1200\nPRINT SCALEFACTOR(0)",
            default=1.0, low=1e-6, high=1e12, group="axis", effect="scale"),
    Keyword("SPEED", "SP", "setting", "RW", "axis", "uu/s", "speed",
            "Slew speed of moves; a change acts at once on the move in progress. At 0 a move holds until it rises.",
            "SPEED(0) = 250\nPRINT SPEED(0)", default=40000.0, low=0.0, high=_MAX_VALUE, group="axis", gives="speed",
            meant="VELOCITY"),
    Keyword("ACCEL", "AC", "setting", "RW", "axis", "uu/s2", Actions("accel", read=ramp_rate("accel")),
            "Acceleration of moves; replaces an ACCELTIME set before. At 0 no move starts, and in motion 0 is refused.",
            "ACCEL(0) = 1250\nPRINT ACCEL(0)", default=100000.0, low=0.0, high=1e12, group="axis", gives="accel",
            meant="ACCELERATION"),
    Keyword("DECEL", "", "setting", "RW", "axis", "uu/s2", Actions("decel", read=ramp_rate("decel")),
            "Deceleration of moves; replaces a DECELTIME set before. At 0 no move starts, and in motion 0 is refused.",
            "DECEL(0) = 1250\nPRINT DECEL(0)", default=100000.0, low=0.0, high=1e12, group="axis", gives="decel",
            meant="DECELERATION"),
    Keyword("ACCELTIME", "", "setting", "RW", "axis", "ms", Actions("accel_time", read=ramp_time("accel")),
            "Acceleration given as the time from rest to SPEED; replaces ACCEL.",
            "SPEED(0) = 50\nACCELTIME(0) = 200\nPRINT ACCELTIME(0)",
            low=1e-3, high=_MAX_TIME, group="axis", gives="accel"),
    Keyword("DECELTIME", "", "setting", "RW", "axis", "ms", Actions("decel_time", read=ramp_time("decel")),
            "Deceleration given as the time from SPEED to rest; replaces DECEL.",
            "SPEED(0) = 50\nDECELTIME(0) = 200\nPRINT DECELTIME(0)",
            low=1e-3, high=_MAX_TIME, group="axis", gives="decel"),
    Keyword("ACCELJERK", "", "setting", "RW", "axis", "uu/s3", "accel_jerk",
            "Rate at which acceleration builds up and falls in an S-ramp.",
            "PROFILEMODE(0) = 1\nACCELJERK(0) = 5000\nPRINT ACCELJERK(0)",
            default=1e6, low=0.0, high=1e15, group="axis", gives="accel jerk"),
    Keyword("DECELJERK", "", "setting", "RW", "axis", "uu/s3", "decel_jerk",
            "Rate at which deceleration builds up and falls in an S-ramp.",
            "PROFILEMODE(0) = 1\nDECELJERK(0) = 5000\nPRINT DECELJERK(0)",
            default=1e6, low=0.0, high=1e15, group="axis", gives="decel jerk"),
    Keyword("PROFILEMODE", "", "setting", "RW", "axis", "integer", _PROFILE_MODE,
            "Shape of moves: _pmTRAPEZOIDAL or _pmSRAMP, seven sections with ACCEL as the peak.",
            "PROFILEMODE(0) = _pmSRAMP\nPRINT PROFILEMODE(0)", default=0.0, low=0, high=1, group="axis", gives="shape"),
    Keyword("MOVEBUFFERSIZE", "MB", "setting", "RW", "axis", "integer",
            Actions("buffer_size", write=of(Environment, write_buffer_size)),
            "Number of moves that the buffer of the axis can hold, without the one in progress.",
            "MOVEBUFFERSIZE(0) = 10\nPRINT MOVEBUFFERSIZE(0)", default=2.0, low=2, high=100, group="axis"),
    Keyword("DRIVEENABLE", "DE", "setting", "RW", "axis", "bool", _ENABLED,
            "State of the drive of the axis, 1 if enabled; a move on a disabled axis is rejected.",
            "DRIVEENABLE(0) = _TRUE\nPRINT DRIVEENABLE(0)", default=1.0, low=0, high=1, group="axis", effect="switch",
            meant="ENABLE DISABLE", topic="enable"),
    Keyword("DRIVEENABLESWITCH", "des", "reading", "R", "axis", "bool",
            Actions(read=of(Environment, lambda e, axis: int(e.controller.may_enable(axis)))),
            "1 while the hardware enable input of the drive is on, or where the machine file gives it none.",
            "PRINT DRIVEENABLESWITCH(0)", default=1.0, group="errors"),
)  # fmt: skip
