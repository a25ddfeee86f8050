"""Standing still on purpose: for a time, or until something goes on."""

from __future__ import annotations

from motionlang.planners.curve import Profile, hold, relabelled


def rest(shape: str, position: float, duration: float) -> Profile:
    """Standing at `position` for `duration` seconds; `shape` says why."""
    return relabelled(hold(position).cut(duration), shape)


def halted(profile: Profile, shape: str) -> Profile:
    """A profile that ends at rest, and then stands there for ever; `shape` says why."""
    return relabelled(profile.then(hold(profile.end)), shape)
