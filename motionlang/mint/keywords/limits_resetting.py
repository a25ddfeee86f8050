"""Ending motion and starting afresh: STOP and its mode, RESET, DEFAULT."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.keywords.axis_settings import Settings, reading, writing
from motionlang.mint.keywords.defaults import STOP_INPUT_MODE
from motionlang.mint.runtime.binding import axis_of, of, on_axes, on_every_axis
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment, mint_settings

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

# STOPMODE: how STOP brings an axis to rest.
AT_DECEL, AT_ERROR_DECEL, CRASH = 0, 1, 2
_DEFAULTS = {"STOPMODE": AT_DECEL, "STOPINPUTMODE": STOP_INPUT_MODE}


class StopModes(Settings):
    """STOPMODE of every axis, and STOPINPUTMODE."""

    defaults = _DEFAULTS


def stop(environment: Environment, axis: int, mode: float) -> None:
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


def default(environment: Environment, axis: int) -> None:
    """Settings as at power-up; refused in motion."""
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


def do_stop(environment: Environment, axes: tuple[int, ...], line: int) -> None:
    """STOP: each axis as its STOPMODE says; one that there is not stops none."""
    setting = environment.part(StopModes).setting
    for axis in axes:
        axis_of(environment, axis)
    for axis in axes:
        stop(environment, axis, setting("STOPMODE", axis))


def held_by_stop(environment: Environment, numbers: tuple[int, ...], line: int) -> object:
    """What STOP changes of its axes beside their motion, of which the clock tells."""
    controller = environment.controller
    return [
        (controller.room(axis), controller.is_suspended(axis), controller.axes[axis].sequence)
        for axis in numbers
        if axis in controller.axes
    ]


OPERATIONS = {
    "limits.resetting.stop": {
        "do": repeatable(of(Environment, do_stop)),
        "held": of(Environment, held_by_stop),
    },
    "limits.resetting.stop_mode": {"read": reading(StopModes), "write": writing(StopModes)},
    "limits.resetting.reset": {"do": on_axes(reset)},
    "limits.resetting.reset_all": {"do": on_every_axis(reset)},
    "limits.resetting.default": {"do": on_axes(default)},
    "limits.resetting.default_all": {"do": on_every_axis(default)},
}
