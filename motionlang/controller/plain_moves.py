"""Plain moves: from rest to rest by a trapezoid, on an axis that nobody looks at meanwhile; tuples, no objects.

Most moves there are begin and end with nobody asking. As long as that is so a move in the buffer is an `Entry`, a move
that was started a `Row`, in the log and beside the track of its axis. `Axis` makes what everybody else knows of it, a
`Move` and profiles on its track, when somebody looks; what they are is what they would have been from the beginning.
"""

from __future__ import annotations

from motionlang.controller.move import Move
from motionlang.planners.curve import Profile, hold

TYPE_CHECKING = False
if TYPE_CHECKING:
    # Target, base, command, line, speed and mark, each as `Move` has it.
    Entry = tuple[float, float | None, str, int, float | None, int]
    # Axis, start time, start, end, duration, recipe of the profile, speed asked for, scale, zero, and what was loaded.
    Row = tuple[int, float, float, float, float, tuple[float, ...], float, float, float, Entry]
    # Way, speed, acceleration and deceleration, and what comes of them: duration and recipe of the profile.
    Plan = tuple[float, float, float, float, tuple[float, tuple[float, ...]]]

# A plan that is that of no move.
NO_PLAN: Plan = (float("nan"), 0.0, 0.0, 0.0, (0.0, ()))


def entry_of(axis: int, entry: Entry) -> Move:
    """The entry of the buffer."""
    target, base, command, line, speed, mark = entry
    move = Move(axis, command, line, target)
    move.base, move.speed, move.id = base, speed, mark
    return move


def move_of(row: Row) -> Move:
    """The move that was started."""
    axis, start_time, _, end, _, _, asked, scale, zero, entry = row
    move = entry_of(axis, entry)
    move.target, move.asked, move.start_time = end, asked, start_time
    move.scale, move.zero, move.released = scale, zero, True
    move.profile = profile_of(row)
    return move


def profile_of(row: Row) -> Profile:
    """Its profile."""
    return Profile("trapezoid", row[2], row[3], row[4], row[5])


def written(rows: list[Row], under_way: bool) -> tuple[list[float], list[Profile]]:
    """Moves in a row, and the rests behind them, as a track has them; behind the last one only where it is over."""
    starts: list[float] = []
    profiles: list[Profile] = []
    for row in rows:
        starts += row[1], row[1] + row[4]
        profiles += profile_of(row), hold(row[3])
    if under_way:
        del starts[-1], profiles[-1]
    return starts, profiles
