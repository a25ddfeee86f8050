"""What the settings of an axis do beyond keeping their value."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.runtime.binding import scale_of
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment


def do_default_axes(environment: Environment, row: Row) -> Operation:
    """AXES."""

    def do(axes: tuple[int, ...], line: int) -> None:
        for axis in axes:
            scale_of(environment, axis)
        environment.task.axes = axes

    return do


def write_buffer_size(environment: Environment, row: Row) -> Operation:
    """MOVEBUFFERSIZE, while the buffer is empty."""

    def write(axis: int, value: int) -> None:
        scale_of(environment, axis)
        a = environment.controller.axes[axis]
        if a.move is not None or a.buffer:
            words = f"the move buffer of axis {axis} is in use"
            raise Refusal("buffer-in-use", words, f"PAUSE IDLE({axis}) waits until it is empty")
        environment.controller.configure(axis, "buffer_size", value)

    return write


def _time_setting(environment: Environment, row: Row, rate: str) -> Operation:
    """Reads a ramp's time in ms, also when a rate was written."""
    setting = environment.controller.setting

    def read(axis: int) -> int:
        scale_of(environment, axis)
        seconds = setting(axis, row.verb)
        if seconds is None:
            seconds = float(setting(axis, "speed")) / float(setting(axis, rate))  # type: ignore[arg-type]
        return round(float(seconds) * 1000.0)

    return read


def read_accel_time(environment: Environment, row: Row) -> Operation:
    return _time_setting(environment, row, "accel")


def read_decel_time(environment: Environment, row: Row) -> Operation:
    return _time_setting(environment, row, "decel")


def _rate_setting(environment: Environment, row: Row, time: str) -> Operation:
    """Reads a rate, also when a time was written."""
    setting = environment.controller.setting

    def read(axis: int) -> float:
        scale = scale_of(environment, axis)
        seconds = setting(axis, time)
        rate = setting(axis, row.verb) if seconds is None else float(setting(axis, "speed")) / float(seconds)  # type: ignore[arg-type]
        return scale.to_user(float(rate), row.unit)  # type: ignore[arg-type]

    return read


def read_accel(environment: Environment, row: Row) -> Operation:
    return _rate_setting(environment, row, "accel_time")


def read_decel(environment: Environment, row: Row) -> Operation:
    return _rate_setting(environment, row, "decel_time")


def write_scale(environment: Environment, row: Row) -> Operation:
    """Settings keep their values in counts, as the controller does: set the scale first."""

    def write(axis: int, value: float) -> None:
        scale_of(environment, axis)
        environment.controller.set_scale(axis, value)

    return write


def read_scale(environment: Environment, row: Row) -> Operation:
    return lambda axis: float(scale_of(environment, axis).counts)


@repeatable
def write_profile_mode(environment: Environment, row: Row) -> Operation:
    """PROFILEMODE."""
    configure = environment.controller.configure

    def write(axis: int, value: int) -> None:
        scale_of(environment, axis)
        configure(axis, "shape", "scurve" if value == 1 else "trapezoid")

    return write


def read_profile_mode(environment: Environment, row: Row) -> Operation:
    def read(axis: int) -> int:
        scale_of(environment, axis)
        return int(environment.controller.setting(axis, "shape") == "scurve")

    return read


@repeatable
def write_enabled(environment: Environment, row: Row) -> Operation:
    """DRIVEENABLE."""
    controller = environment.controller

    def write(axis: int, value: int) -> None:
        scale_of(environment, axis)
        (controller.enable if value else controller.disable)(axis)

    return write


def read_enabled(environment: Environment, row: Row) -> Operation:
    def read(axis: int) -> int:
        scale_of(environment, axis)
        return int(environment.controller.is_enabled(axis))

    return read


OPERATIONS = {
    "default_axes": {"do": do_default_axes},
    "scale": {"read": read_scale, "write": write_scale},
    "accel": {"read": read_accel},
    "decel": {"read": read_decel},
    "accel_time": {"read": read_accel_time},
    "decel_time": {"read": read_decel_time},
    "profile_mode": {"read": read_profile_mode, "write": write_profile_mode},
    "buffer_size": {"write": write_buffer_size},
    "enabled": {"read": read_enabled, "write": write_enabled},
}
