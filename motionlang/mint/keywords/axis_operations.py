"""What the settings of an axis do beyond keeping their value."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.runtime.binding import of, scale_of, unchecked
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Maker


def do_default_axes(environment: Environment, axes: tuple[int, ...], line: int) -> None:
    """AXES."""
    for axis in axes:
        scale_of(environment, axis)
    environment.task.axes = axes


def write_buffer_size(environment: Environment, axis: int, value: int) -> None:
    """MOVEBUFFERSIZE, while the buffer is empty."""
    a = environment.controller.axes[axis]
    if a.move is not None or a.buffer:
        words = f"the move buffer of axis {axis} is in use"
        raise Refusal("buffer-in-use", words, f"PAUSE IDLE({axis}) waits until it is empty")
    environment.controller.configure(axis, "buffer_size", value)


def ramp_time(rate: str) -> Maker:
    """What reads a ramp's time in ms, also when a rate was written."""
    time = f"{rate}_time"

    def read(environment: Environment, axis: int) -> int:
        a = environment.controller.axes[axis]
        seconds: float | None = getattr(a, time)
        return round((a.speed / getattr(a, rate) if seconds is None else seconds) * 1000.0)

    return of(Environment, read)


def ramp_rate(rate: str) -> Maker:
    """What reads a rate in user units, also when a time was written."""
    time = f"{rate}_time"

    def read(environment: Environment, axis: int) -> float:
        a = environment.controller.axes[axis]
        seconds: float | None = getattr(a, time)
        return a.scale.to_user(getattr(a, rate) if seconds is None else a.speed / seconds, "uu/s2")

    return of(Environment, read)


def write_profile_mode(environment: Environment, axis: int, value: int) -> None:
    """PROFILEMODE."""
    environment.controller.configure(axis, "shape", "scurve" if value == 1 else "trapezoid")


def write_enabled(environment: Environment, axis: int, value: int) -> None:
    """DRIVEENABLE."""
    controller = environment.controller
    (controller.enable if value else controller.disable)(axis)


OPERATIONS = {
    "default_axes": {"do": of(Environment, do_default_axes)},
    # Settings keep their values in counts, as the controller does: set the scale first.
    "scale": {
        "read": of(Environment, lambda e, axis: float(scale_of(e, axis).counts)),
        "write": of(Environment, lambda e, axis, value: e.controller.set_scale(axis, value)),
    },
    "accel": {"read": ramp_rate("accel")},
    "decel": {"read": ramp_rate("decel")},
    "accel_time": {"read": ramp_time("accel")},
    "decel_time": {"read": ramp_time("decel")},
    "profile_mode": {
        "read": of(Environment, lambda e, axis: int(e.controller.setting(axis, "shape") == "scurve")),
        "write": repeatable(of(Environment, write_profile_mode)),
    },
    "buffer_size": {"write": of(Environment, write_buffer_size)},
    "enabled": {
        "read": of(Environment, lambda e, axis: int(e.controller.is_enabled(axis))),
        "write": unchecked(repeatable(of(Environment, write_enabled))),
    },
}
