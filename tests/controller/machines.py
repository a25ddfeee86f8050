"""Controllers for tests, with round numbers."""

from __future__ import annotations

from motionlang.controller.controller import Controller


def machine(axes: int = 2, **settings: float | str) -> Controller:
    """`axes` axes that run at 10 counts/s with rates of 100 counts/s², or as `settings` say."""
    controller = Controller(axes)
    for axis in controller.axes:
        for name, value in {"speed": 10.0, "accel": 100.0, "decel": 100.0, **settings}.items():
            controller.configure(axis, name, value)
    return controller


def until(controller: Controller, time: float) -> Controller:
    """The controller at `time`."""
    controller.clock.advance(time)
    return controller
