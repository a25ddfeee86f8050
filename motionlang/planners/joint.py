"""Several axes on one path: the path's profile, scaled onto each axis."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

from motionlang.planners.curve import Profile


def scaled(profile: Profile, start: float, factor: float) -> Profile:
    """Return the path's profile scaled to an axis, from `start`, by `factor`."""
    return profile.scaled(start, factor)


def path_length(starts: Sequence[float], targets: Sequence[float]) -> float:
    """Return the Euclidean length of the straight line between two points."""
    return hypot(*(target - start for start, target in zip(starts, targets, strict=True)))


def on_line(path: Profile, starts: Sequence[float], targets: Sequence[float]) -> list[Profile]:
    """Return the axis profiles of a straight line; `path` runs from 0 to its length.

    The end positions are exact.
    """
    length = path.distance
    made = []
    for start, target in zip(starts, targets, strict=True):
        axis = path.scaled(start, (target - start) / length if length else 0.0)
        axis.end = target
        made.append(axis)
    return made
