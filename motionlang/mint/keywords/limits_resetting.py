"""Ending motion and starting afresh: STOP and its mode, RESET, DEFAULT."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.runtime.binding import axis_of
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import mint_settings

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

# STOPMODE: how STOP brings an axis to rest.
AT_DECEL, AT_ERROR_DECEL, CRASH = 0, 1, 2


class StopModes:
    """STOPMODE of every axis."""

    def __init__(self, environment: Environment) -> None:
        self.modes: dict[int, int] = {}

    def default(self, axis: int) -> None:
        self.modes.pop(axis, None)


def stop(environment: Environment, axis: int, mode: int) -> None:
    """Bring an axis to rest in one of the ways of STOPMODE."""
    controller = environment.controller
    if mode == CRASH:
        controller.abort(axis, "stop")
        return
    controller.stop(axis, "stop", mode == AT_ERROR_DECEL)


def reset(environment: Environment, axis: int) -> None:
    """Errors cleared, moves forgotten, position zero, drive on."""
    controller = environment.controller
    controller.abort(axis)
    controller.clear_faults(axis)
    controller.enable(axis)
    controller.define_position(axis, 0.0)


def _default(environment: Environment, axis: int) -> None:
    controller = environment.controller
    if not controller.is_idle(axis):
        raise Refusal("moving", f"axis {axis} is moving", "DEFAULT needs the axis at rest")
    controller.restore(axis)
    mint_settings(controller, axis)
    controller.set_scale(axis, 1.0)
    for part in environment.parts():
        forget: Callable[[int], None] | None = getattr(part, "default", None)
        if forget is not None:
            forget(axis)
    if environment.power_up is not None:
        environment.power_up.set(axis)


# ----------------------------------------------------------------------------------------------- operations


@repeatable
def do_stop(environment: Environment, row: Row) -> Operation:
    """STOP: each axis as its STOPMODE says; one that there is not stops none."""
    modes = environment.part(StopModes).modes

    def do(axes: tuple[int, ...], line: int) -> None:
        for axis in axes:
            axis_of(environment, axis)
        for axis in axes:
            stop(environment, axis, modes.get(axis, AT_DECEL))

    return do


def held_by_stop(environment: Environment, row: Row) -> Operation:
    """What STOP changes of its axes beside their motion, of which the clock tells."""
    axes, room, is_suspended = (
        environment.controller.axes,
        environment.controller.room,
        environment.controller.is_suspended,
    )

    def held(numbers: tuple[int, ...], line: int) -> object:
        return [(room(axis), is_suspended(axis), axes[axis].sequence) for axis in numbers if axis in axes]

    return held


def read_stop_mode(environment: Environment, row: Row) -> Operation:
    modes = environment.part(StopModes).modes
    return lambda axis: modes.get(axis_of(environment, axis), AT_DECEL)


def write_stop_mode(environment: Environment, row: Row) -> Operation:
    """STOPMODE."""
    modes = environment.part(StopModes).modes

    def write(axis: int, mode: int) -> None:
        row.check(mode)
        modes[axis_of(environment, axis)] = mode

    return write


def do_reset(environment: Environment, row: Row) -> Operation:
    def do(axes: tuple[int, ...], line: int) -> None:
        for axis in [axis_of(environment, axis) for axis in axes]:
            reset(environment, axis)

    return do


def do_reset_all(environment: Environment, row: Row) -> Operation:
    def do() -> None:
        for axis in environment.controller.axes:
            reset(environment, axis)

    return do


def do_default(environment: Environment, row: Row) -> Operation:
    def do(axes: tuple[int, ...], line: int) -> None:
        for axis in [axis_of(environment, axis) for axis in axes]:
            _default(environment, axis)

    return do


def do_default_all(environment: Environment, row: Row) -> Operation:
    def do() -> None:
        for axis in environment.controller.axes:
            _default(environment, axis)

    return do


OPERATIONS = {
    "limits.resetting.stop": {"do": do_stop, "held": held_by_stop},
    "limits.resetting.stop_mode": {"read": read_stop_mode, "write": write_stop_mode},
    "limits.resetting.reset": {"do": do_reset},
    "limits.resetting.reset_all": {"do": do_reset_all},
    "limits.resetting.default": {"do": do_default},
    "limits.resetting.default_all": {"do": do_default_all},
}
