"""A listener to the operations, profiles and settings of a controller."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis


class MotionListener:
    """A listener to the motion of a controller, which ignores every report.

    Subclasses override what they need. They only read: a listener changes neither the axes nor the run.
    """

    def add(self, a: Axis) -> None:
        """An axis is about to get another profile; its move and settings are those of the profile."""

    def heed(self, a: Axis) -> None:
        """A setting of a moving axis was written, or the axis was stopped or suspended."""

    def jogs(self, a: Axis, velocity: float) -> None:
        """An axis was commanded to jog at a velocity, counts/s."""

    def gears(self, a: Axis, ratio: float) -> None:
        """An axis was commanded to follow its master at a ratio."""

    def stop(self, a: Axis, ended: str) -> None:
        """An axis is about to decelerate to rest; `ended` is the keyword."""

    def freeze(self, a: Axis, ended: str) -> None:
        """An axis is about to stop at once; `ended` is the keyword."""

    def offset(self, a: Axis, distance: float, line: int) -> None:
        """An offset of a distance, counts, is about to begin."""

    def refuse(self, a: Axis) -> None:
        """A buffered move, or a step of a homing, was rejected as it began."""

    def finish_updates(self) -> None:
        """An interrupt has ended the run, and tracks and log have been completed."""
