"""Controllers for tests, with round numbers."""

from __future__ import annotations

from motionlang.controller.controller import Controller


def machine(axes: int = 2, **settings: float | str) -> Controller:
    """Return `axes` axes at 10 counts/s and 100 counts/s², or with `settings`."""
    controller = Controller(axes)
    for axis in controller.axes:
        for name, value in {"speed": 10.0, "accel": 100.0, "decel": 100.0, **settings}.items():
            controller.configure(axis, name, value)
    return controller


def until(controller: Controller, time: float) -> Controller:
    """Return the controller at `time`."""
    controller.clock.advance(time)
    return controller
