"""Controllers for tests, with round numbers."""

from __future__ import annotations

from motionlang.controller.controller import Controller
from motionlang.controller.moves.path import run_of


def machine(axes: int = 2, **settings: float | str) -> Controller:
    """Return a controller whose axes have 10 counts/s and 100 counts/s².

    `settings` change the settings of every axis.
    """
    controller = Controller(axes)
    for axis in controller.axes:
        for name, value in {"speed": 10.0, "accel": 100.0, "decel": 100.0, **settings}.items():
            controller.configure(axis, name, value)
    return controller


def until(controller: Controller, time: float) -> Controller:
    """Advance the controller to `time`, s, and return it."""
    controller.clock.advance(time)
    return controller


def remaining(controller: Controller, axis: int) -> float:
    """Return the remaining distance along the present path of an axis, user units."""
    run = run_of(controller.axes[axis])
    assert run is not None
    return run.present.remaining
