"""Commanded standstill: for a time, or until another motion resumes."""

from __future__ import annotations

from motionlang.kernel.planners.curve import Profile, hold, relabelled


def rest(shape: str, position: float, duration: float) -> Profile:
    """Return a rest of `duration` seconds at `position`; `shape` names its cause."""
    return relabelled(hold(position).cut(duration), shape)


def with_rest(profile: Profile) -> Profile:
    """Return the profile of a suspension: the given one, then an endless rest."""
    return relabelled(profile.then(hold(profile.end)), "suspend")
