"""Printed lines and moves as words that a comparison shows."""

from __future__ import annotations

import re
from math import inf
from typing import Protocol

from motionlang.kernel.planners import Profile

_ESCAPES = re.compile(r"\x1b(?:\[[0-9;?]*[A-Za-z]|[^\[])|[\x00-\x08\x0b-\x1f\x7f]")
_FIGURE = re.compile(r"[-+]?\d[\d.]*(?:[eE][-+]?\d+)?")


def plain(text: str) -> str:
    """Return a printed line without escape codes and control characters."""
    return _ESCAPES.sub("", text).strip()


def without_figures(text: str) -> str:
    """Return a printed line with a mark for each of its figures, which differ, and are padded, from run to run."""
    return " ".join(_FIGURE.sub("#", text).split())


class AnyMove(Protocol):
    """A move: that of a log, or a record of one."""

    @property
    def command(self) -> str: ...
    @property
    def profile(self) -> Profile | None: ...
    @property
    def scale(self) -> float: ...
    @property
    def zero(self) -> float: ...


def described(move: AnyMove, is_homing: bool) -> str:
    """Return where a move goes and how fast, in user units and words; "" for an entry that moves nothing.

    Of a homing, whose phases end at its switch, it is the command; a jog has its command, and the place where it ended.
    """
    profile, scale = move.profile, move.scale or 1.0
    if profile is None or is_homing:
        return "" if profile is None else move.command
    words = [move.command] if profile.duration == inf or profile.shape == "jog" else []
    if profile.duration < inf:
        words.append(f"to {round((profile.end - move.zero) / scale, 6) + 0.0:.6g}")
    if profile.duration == inf:
        words.append(f"at {profile.end_velocity / scale:.6g}")
    elif speed := profile.peak_speed:
        words.append(f"at {abs(speed / scale):.6g}")
    return " ".join(words)
