"""Ending motion and resetting: STOP and its mode, RESET, DEFAULT."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.defaults import STOP_INPUT_MODE
from motionlang.kernel.mint.runtime.binding import axis_of, of, on_axes, on_every_axis
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment, mint_settings

# STOPMODE: how STOP brings an axis to rest.
AT_DECEL, AT_ERROR_DECEL, CRASH = 0, 1, 2
_DEFAULTS = {"STOPMODE": AT_DECEL, "STOPINPUTMODE": STOP_INPUT_MODE}


class StopModes(StoredSettings):
    """STOPMODE of every axis, and STOPINPUTMODE."""

    defaults = _DEFAULTS


def stop(environment: Environment, axis: int, mode: float) -> None:
    """Bring an axis to rest as a STOPMODE specifies."""
    controller = environment.controller
    if mode == CRASH:
        controller.abort(axis, "stop")
        return
    controller.stop(axis, "stop", mode == AT_ERROR_DECEL)


def reset(environment: Environment, axis: int) -> None:
    """Clear errors, discard moves, set the position to zero and enable the drive."""
    controller = environment.controller
    controller.abort(axis)
    controller.clear_faults(axis)
    controller.enable(axis)
    controller.define_position(axis, 0.0)


def default(environment: Environment, axis: int) -> None:
    """Reset the settings to their power-up values; raise Rejected while in motion."""
    controller = environment.controller
    controller.require_idle(axis, "DEFAULT")
    controller.restore(axis)
    mint_settings(controller, axis)
    controller.set_scale(axis, 1.0)
    for component in environment.components():
        forget: Callable[[int], None] | None = getattr(component, "default", None)
        if forget is not None:
            forget(axis)
    if environment.power_up is not None:
        environment.power_up.set(axis)


# ----------------------------------------------------------------------------------------------- operations


def do_stop(environment: Environment, axes: tuple[int, ...], line: int) -> None:
    """STOP: stop each axis in its STOPMODE; if one does not exist, none stops."""
    setting = environment.component(StopModes).setting
    for axis in axes:
        axis_of(environment, axis)
    for axis in axes:
        stop(environment, axis, setting("STOPMODE", axis))


def stored_by_stop(environment: Environment, numbers: tuple[int, ...], line: int) -> object:
    """Return what STOP changes in its axes and in the log, apart from motion.

    Changes of motion are reported by the clock.
    """
    controller = environment.controller
    return environment.machine.log.events.past, [
        (controller.room(axis), controller.is_suspended(axis), controller.axes[axis].homing)
        for axis in numbers
        if axis in controller.axes
    ]


# ------------------------------------------------------------------------------------------------- keywords

_STOP_MODE = Actions(read=setting_reader(StopModes), write=setting_writer(StopModes))


ROWS = (
    Keyword("STOPINPUTMODE", "", "setting", "RW", "axis", "integer", _STOP_MODE,
            "Reaction of the axis when its stop input becomes active: _emIGNORE only the event STOP, "
            "_emCRASH_STOP a crash stop, _emERROR_DECEL a stop at ERRORDECEL.",
            "STOPINPUT(0) = 3\nSTOPINPUTMODE(0) = _emCRASH_STOP\nPRINT STOPINPUTMODE(0)",
            default=float(STOP_INPUT_MODE), low=0, high=3, group="limits"),
    Keyword("STOP", "ST", "command", "C", "axes", "",
            Actions(do=repeatable(of(Environment, do_stop)), replaced=of(Environment, stored_by_stop)),
            "Decelerate the axes to rest as their STOPMODE says, and empty their buffers.",
            "JOG(0) = 100\nWAIT = 500\nSTOP(0)\nPAUSE IDLE(0)\nPRINT IDLE(0)", group="stopping", effect="stop",
            meant="HALT"),
    Keyword("STOPMODE", "", "setting", "RW", "axis", "integer", _STOP_MODE,
            "Action of STOP: 0 stop at DECEL, 1 at ERRORDECEL, 2 at once.",
            "STOPMODE(0) = 1\nPRINT STOPMODE(0)", default=0.0, low=0, high=2, group="stopping"),
    Keyword("RESET", "", "command", "C", "axes", "", Actions(do=on_axes(reset)),
            "Stop the axis at once, empty its buffer, clear its errors, make its position 0 and switch its drive on.",
            "POS(0) = 5\nRESET(0)\nPRINT POS(0)", group="stopping", effect="stop abrupt datum"),
    Keyword("RESETALL", "", "command", "C", "none", "", Actions(do=on_every_axis(reset)),
            "RESET for every axis.",
            "POS(0) = 5\nRESETALL\nPRINT POS(0)", group="stopping", effect="stop abrupt all datum"),
    Keyword("DEFAULT", "", "command", "C", "axes", "", Actions(do=on_axes(default)),
            "Give every setting of an axis at rest its default again.",
            "SPEED(0) = 5\nDEFAULT(0)\nPRINT SPEED(0)", group="axis", effect="stop abrupt datum"),
    Keyword("DEFAULTALL", "", "command", "C", "none", "", Actions(do=on_every_axis(default)),
            "DEFAULT for every axis.",
            "SPEED(1) = 5\nDEFAULTALL\nPRINT SPEED(1)", group="axis", effect="stop abrupt all datum"),
)  # fmt: skip
