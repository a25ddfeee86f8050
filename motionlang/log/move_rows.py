"""Packed moves: rows of numbers and texts, with profiles stored as indices."""

from __future__ import annotations

from bisect import bisect_right
from operator import attrgetter

from motionlang.controller.move import CONTINUED, Action, Move
from motionlang.planners.packed import packed, unpacked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from motionlang.controller.axis import Axis
    from motionlang.planners import Profile

# The action of a packed move that was a path, a jog or the like; its kind is not stored.
_OTHER = Action()
# The two end velocities, which are the complete recipe of a profile without ramps.
_ENDS = 2
# The first fields of a row: the arguments that make a move, and figures of it.
_made = attrgetter("axis", "command", "line", "target")
_figures = attrgetter("commanded_speed", "start_time", "scale", "ended")


class _Overlaid(Move):
    __slots__ = ()
    overlaid = True


def row(move: Move, a: Axis | None) -> tuple[object, ...]:
    """Return a move as a row; a complete profile of the track is stored as its index."""
    profile: object = None if a is None else _profile_index(a, move)
    if profile is None and move.profile is not None:
        profile = packed(move.profile)
    return _row(move, profile)


def _row(move: Move, profile: object) -> tuple[object, ...]:
    # Most are 0.0, for which None takes fewer bytes.
    few = move.zero or None, move.offset or None, move.action is not None, move.overlaid
    return *_made(move), *_figures(move), *few, profile


def move_of(row: tuple[Any, ...], axes: Mapping[int, Axis]) -> Move:
    """Return the move that was packed as a row, on one of the axes."""
    zero, offset, other, overlaid, profile = row[8:]
    move = (_Overlaid if overlaid else Move)(*row[:4])
    move.commanded_speed, move.start_time, move.scale, move.ended = row[4:8]
    move.zero, move.offset = zero or 0.0, offset or 0.0
    move.action = _OTHER if other else None
    if profile is not None:
        move.profile = _profile(axes[move.axis], profile) if isinstance(profile, int) else unpacked(profile)
    return move


def sealed(move: Move, done: Profile) -> Move:
    """Return a copy of the move up to now, because it continues as another entry."""
    made = move_of(_row(move, None), {})
    made.profile, made.ended = done, CONTINUED
    return made


def _profile_index(a: Axis, move: Move) -> int | None:
    """Return the index of the track's profile that is the whole move, or None."""
    k = bisect_right(a.starts, move.start_time) - 1
    while k >= 0 and a.starts[k] == move.start_time:
        if a.profiles[k] is move.profile:
            return k + (0 if a.older is None else a.older.count)
        k -= 1
    return None


def _profile(a: Axis, number: int) -> Profile:
    """Return a profile of the track of an axis."""
    older = a.older
    packed_ones = 0 if older is None else older.count
    if number >= packed_ones:
        return a.profiles[number - packed_ones]
    assert older is not None
    return older.profile(number)
