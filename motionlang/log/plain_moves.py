"""Trapezoidal moves from rest to rest, stored as tuples until they are packed.

Most moves of a machine are of this kind. `fast/moves.py` writes such rows; readers of the log get `Move`.
"""

from __future__ import annotations

from motionlang.controller.move import Move
from motionlang.planners.curve import Profile

# Target, base, command, line, speed and identifier, like those of `Move`.
Entry = tuple[float, float | None, str, int, float | None, int]
# Axis, start time, start, end, duration, recipe of the profile, commanded speed, scale, zero, and the
# loaded entry.
Row = tuple[int, float, float, float, float, tuple[float, ...], float, float, float, Entry]


def entry_of(axis: int, entry: Entry) -> Move:
    """Return the entry of the move buffer as a `Move`."""
    target, base, command, line, speed, mark = entry
    move = Move(axis, command, line, target)
    move.base, move.speed, move.id = base, speed, mark
    return move


def move_of(row: Row) -> Move:
    """Return the move that a row describes."""
    axis, start_time, _, end, _, _, asked, scale, zero, entry = row
    move = entry_of(axis, entry)
    move.target, move.commanded_speed, move.start_time = end, asked, start_time
    move.scale, move.zero, move.released = scale, zero, True
    move.profile = profile_of(row)
    return move


def profile_of(row: Row) -> Profile:
    """Return the profile of the move that a row describes."""
    return Profile("trapezoid", row[2], row[3], row[4], row[5])
