"""The order behind a profile: the kind of motion and the settings in force.

This module contains only records.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf
from typing import NamedTuple

from motionlang.kernel import Axis
from motionlang.kernel.planners import Profile

ENDLESS = (inf, inf)


class PathOrder(NamedTuple):
    """A path as commanded: its axes, its master first, and its geometry.

    Geometry. `line` has the ends of a straight path. An arc has `centre`, `angle` (degrees) and `rest`, the
    ends of its further axes; `plane` has the indices of the two axes of the circle. `length` is the nominal
    length, None for the length in space. The numbers of a `relative` path count from its start. `scales` are
    counts per unit.

    Limits. `most`, `most_accel` and `most_decel` are the limits of the axes. The path may be entered at an
    angle of up to `angle_into` degrees.

    Sequence. `begun` is the start time. The path is the `nth` of the run, since several may begin at one time.
    `entry` is the number of the log entry of the axis that the order is for, -1 for a path that has not
    begun. A path that `comes_to_rest` was stopped or
    suspended: it may come to rest anywhere, and if it `leads_on`, on a later path that it continues into.
    """

    members: tuple[int, ...]
    scales: tuple[float, ...]
    begun: float
    nth: int
    relative: bool
    line: tuple[float, ...]
    centre: tuple[float, float]
    angle: float
    rest: tuple[float, ...]
    plane: tuple[int, int]
    length: float | None
    most: tuple[float, ...]
    most_accel: tuple[float, ...]
    most_decel: tuple[float, ...]
    angle_into: float
    comes_to_rest: bool = False
    leads_on: bool = False
    entry: int = -1


class Tie(NamedTuple):
    """The master of an axis: a track, at a `ratio`, or on a `curve` from `origin` on.

    A ratio applies once it is `locked`; it is reached along a `ramp`, or at once. `table` is the source of
    the curve: master positions, the values there, and the kind of interpolation.
    """

    master: Axis
    ratio: float = 0.0
    locked: float = inf
    curve: Profile | None = None
    origin: float = 0.0
    direction: int = 1
    table: tuple[tuple[float, ...], tuple[float, ...], str] | None = None
    ramp: bool = False

    def takes_up(self, earlier: Tie | None) -> bool:
        """True if it starts a ratio that the axis did not follow before."""
        if self.curve is not None:
            return False
        return (
            earlier is None
            or earlier.curve is not None
            or (earlier.master, earlier.ratio) != (self.master, self.ratio)
        )


class Order(NamedTuple):
    """The order of one profile: kind, source line, and bounds in counts and seconds.

    `kind` is "rest", "move", "step", "jog", "stop", "path", or the name of the action that makes the profile;
    an action has infinite bounds. `rates` and `jerks` are pairs, for speeding up and for slowing down; jerks
    are infinite except for S-ramps. `goal` is the velocity of a jog, or the position or velocity of a
    reference, `ramp` the ratio of a PMC S-curve. `step` is the velocity at which a stepper starts and stops a
    move of kind "step" at once. `points` are the points that a profile has to pass, with their velocities and the times
    between them.
    """

    kind: str
    line: int
    speed: float = inf
    rates: tuple[float, float] = ENDLESS
    jerks: tuple[float, float] = ENDLESS
    shape: str = ""
    goal: float = 0.0
    ramp: float = 0.0
    path: PathOrder | None = None
    tie: Tie | None = None
    points: tuple[Sequence[float], Sequence[float], Sequence[float]] | None = None
    step: float = 0.0

    @property
    def bends(self) -> bool:
        """True if the acceleration of its shape is continuous."""
        return self.jerks[0] < inf or self.shape in ("scurve", "sinusoidal")

    @property
    def settings(self) -> tuple[object, ...]:
        """The settings that affect a motion in progress."""
        if self.path is not None:
            limits = self.path.most, self.path.most_accel, self.path.most_decel
            return self.kind, self.path.entry, self.speed, self.rates, limits, self.path.comes_to_rest
        return self.kind, self.speed, self.goal, self.rates, None if self.tie is None else self.tie.ratio
