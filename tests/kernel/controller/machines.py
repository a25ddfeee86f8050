"""Controllers for tests, with round numbers."""

from __future__ import annotations

from motionlang.kernel import Controller


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


def cam(
    controller: Controller,
    axis: int,
    master: int,
    positions: list[float],
    values: list[float],
    *,
    cyclic: bool = False,
) -> None:
    """Let an axis follow a table over the positions of its master from here, counts."""
    controller.load_cam(
        axis, master, lambda start: (positions, [start + each for each in values]), cyclic=cyclic
    )
    controller.go([axis])


def offset(
    controller: Controller,
    axis: int,
    distance: float,
    mode: int = 0,
    over: float = 0.0,
    command: str = "",
    line: int = 0,
) -> None:
    """Superpose a distance on following, in a mode of OFFSETMODE; at rest move by it."""
    controller.load_offset(axis, distance, mode, over, command, line)
    controller.go([axis])
