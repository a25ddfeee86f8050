"""The time at which a profile reaches a position or a velocity.

Each piece is cut at its extrema; the sections are then solved.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable
from math import inf
from typing import TYPE_CHECKING

from motionlang.kernel.planners.pieces import (
    acceleration_in,
    even_points,
    position_in,
    still_points,
    velocity_in,
)
from motionlang.kernel.planners.root import bracketed_root

if TYPE_CHECKING:
    from motionlang.kernel.planners.curve import Profile
    from motionlang.kernel.planners.ramps import Piece

    Value = Callable[[Piece, float], float]
    Extrema = Callable[[Piece, float], tuple[float, ...]]

# Fraction of the positions of a profile that covers the rounding of a position in a piece.
_MARGIN = 1e-9


def position_crossing(profile: Profile, position: float, after: float) -> float | None:
    """Return the first time >= `after` at which the profile is at `position`, or None.

    Beyond its end the profile rests or continues at its end velocity.
    """
    after = max(after, 0.0)
    knots, pieces, _ = profile.curve
    first = max(bisect_left(knots, after) - 1, 0)
    how = (position_in, velocity_in, still_points)
    found = _first(profile, position, after, how, profile.end, first, True)
    if found is not None:
        return found
    return _after_the_end(profile, position, after)


def velocity_crossing(profile: Profile, velocity: float, after: float) -> float | None:
    """Return the first time >= `after` at which the velocity is `velocity`, or None.

    A jump of the velocity (PVT, linear) does not count as crossing it.
    """
    after = max(after, 0.0)
    last = profile.end_velocity
    first = max(bisect_left(profile.knots, after) - 1, 0)
    how = (velocity_in, acceleration_in, even_points)
    found = _first(profile, velocity, after, how, last, first, False)
    if found is None and velocity == last and profile.duration != inf:
        return max(after, profile.duration)
    return found


def _after_the_end(profile: Profile, position: float, after: float) -> float | None:
    duration, velocity = profile.duration, profile.end_velocity
    if duration == inf:
        return None
    if position == profile.end and (velocity == 0.0 or after <= duration):
        return max(after, duration)
    if velocity == 0.0:
        return None
    time = duration + (position - profile.end) / velocity
    return time if time >= max(after, duration) else None


def _first(
    profile: Profile,
    wanted: float,
    after: float,
    how: tuple[Value, Value, Extrema],
    last: float,
    first: int,
    may_skip: bool,
) -> float | None:
    """Search the pieces from number `first` on.

    `last` is the value at the end of the profile. `may_skip`: test if a piece is on one side of a position before it
    is searched.
    """
    knots, pieces, _ = profile.curve
    value = how[0]
    for i in range(first, len(pieces)):
        piece, begin, finish = pieces[i], knots[i], knots[i + 1]
        length = finish - begin
        following = value(pieces[i + 1], 0.0) if i + 1 < len(pieces) else last
        if may_skip and _stays_on_one_side(piece, wanted, length, following):
            continue
        ending = _joined(value(piece, 0.0), value(piece, length), following)
        x = _first_in(piece, wanted, (max(after - begin, 0.0), length), how, ending)
        if x is not None:
            return min(begin + x, finish)
    return None


def _stays_on_one_side(piece: Piece, wanted: float, duration: float, following: float) -> bool:
    """True if a piece is certainly on one side of a position, and `following` too.

    This check decides most pieces of a long table at a fraction of the cost of a search.
    """
    if not isinstance(piece, tuple) or piece[4] or duration == inf:
        return False
    c0, c1, c2, c3, _, _, _ = piece
    gap = wanted - c0
    farthest = (((abs(c3) * duration + abs(c2)) * duration) + abs(c1)) * duration
    # The margin covers the rounding of both this sum and the position.
    return abs(gap) > farthest + _MARGIN * (abs(gap) + abs(wanted)) and gap * (wanted - following) > 0.0


def _joined(beginning: float, ending: float, following: float) -> float:
    """Return the value at the end of a piece, equal to the start of the next piece.

    So no rounding gap hides a crossing. A gap too large for rounding is a jump, and `ending` is returned.
    """
    gap, size = abs(following - ending), abs(beginning) + abs(ending) + abs(following)
    return following if gap <= 1e-7 * size else ending


def _first_in(
    piece: Piece, wanted: float, span: tuple[float, float], how: tuple[Value, Value, Extrema], ending: float
) -> float | None:
    value, slope, extrema = how
    low, finish = span
    if finish == inf:
        return _on_a_line(piece, wanted, low, value, slope)
    # A piece without length still connects the end of the piece before it to the start of the next.
    a, y_a = low, value(piece, low) if low < finish or not finish else ending
    for b in (*(x for x in extrema(piece, finish) if x > low), finish):
        y_b = value(piece, b) if b < finish else ending
        if y_a == wanted:
            return a
        if y_b == wanted:
            return b
        if (y_a < wanted) is not (y_b < wanted):
            if a == b:
                return a
            return bracketed_root(lambda x: (value(piece, x) - wanted, slope(piece, x)), a, b, y_b > y_a)
        a, y_a = b, y_b
    return None


def _on_a_line(piece: Piece, wanted: float, low: float, value: Value, slope: Value) -> float | None:
    gap, speed = wanted - value(piece, low), slope(piece, low)
    if gap == 0.0:
        return low
    return low + gap / speed if gap * speed > 0.0 else None
