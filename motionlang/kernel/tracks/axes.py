"""The axes of a run that have a motion to show."""

from __future__ import annotations

from motionlang.kernel.controller.operations import Controller


def axes_of(controller: Controller) -> tuple[int, ...]:
    """Return the axes that ever moved or were given a position, or the first axis."""
    axes = controller.axes
    return tuple(axis.index for axis in axes.values() if len(axis.starts) > 1) or (next(iter(axes)),)
