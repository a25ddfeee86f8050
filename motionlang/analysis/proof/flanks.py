"""Initial velocity, acceleration and, for PMC's S-curves, flank of planned motion.

PMC's ramps have no jerk limit of their own. If a ramp is interrupted, the acceleration is first reduced along
its falling flank, and the new ramp follows. The proof takes slope and wave of the ramp from the track before
the profile, never from the profile that it checks.
"""

from __future__ import annotations

from bisect import bisect_right
from math import inf, isfinite, pi
from typing import NamedTuple

from motionlang.analysis.proof.segments import derivatives
from motionlang.log.order import Order
from motionlang.log.track import WholeTrack
from motionlang.planners import Profile
from motionlang.planners.ramps import Piece


class Begin(NamedTuple):
    """The initial velocity and acceleration of a plan, after its initial flank.

    `came` is the speed before the flank, `acceleration_before` the acceleration there. `left` is how long the
    previous profile would have continued to change its velocity, s; it applies to motion that may continue as
    planned. `planned` is the same time for motion that slows down by the same ramps as before: its plan was
    checked when it was made.
    """

    velocity: float
    acceleration: float
    time: float
    distance: float
    came: float
    acceleration_before: float
    left: float | None
    planned: float = inf


def begin(a: WholeTrack, i: int, order: Order, earlier: Order, shifted: bool) -> Begin:
    """Return the initial state of profile i.

    If `shifted`, the profile is a copy of the previous one at a new zero.
    """
    profile = a.profiles[i]
    entry = profile.at(0.0)
    v, acceleration = entry.velocity, entry.acceleration
    left, planned = None, inf
    stops = order.kind == "stop" and acceleration * v < 0.0
    if i and a.profiles[i - 1].pieced and (v or acceleration):
        before, elapsed = a.profiles[i - 1], a.starts[i] - a.starts[i - 1]
        remaining = max(0.0, last_change(before) - elapsed)
        if shifted or stops:
            left = remaining
        if stops and (rest := before.velocity_crossing(0.0, elapsed)) is not None:
            left = min(remaining, rest - elapsed)  # it may reverse, but a stop ends at its rest
        if acceleration * v < 0.0 and abs(v) <= order.speed and _ramps(order) == _ramps(earlier):
            planned = remaining
    own = left if shifted else None  # the rest of a plan is rounded like the complete plan
    if order.jerks[0] < inf:
        return Begin(v, acceleration, 0.0, 0.0, abs(v), acceleration, own, planned)
    if order.shape == "trapezoid" or not acceleration or not i or not a.profiles[i - 1].pieced:
        return Begin(v, 0.0, 0.0, 0.0, abs(v), 0.0, own, planned)
    before, elapsed = a.profiles[i - 1], a.starts[i] - a.starts[i - 1]
    flank = _flank(before, elapsed) if order.shape != "parabolic" else None
    if flank is None:
        return Begin(v, 0.0, 0.0, 0.0, abs(v), acceleration, left)
    falling, x, time = flank
    p0, v0, _, _ = derivatives(falling, x)
    p1, v1, _, _ = derivatives(falling, x + time)
    return Begin(v + v1 - v0, 0.0, time, p1 - p0 + (v - v0) * time, abs(v), acceleration, left)


def _ramps(order: Order) -> tuple[object, ...]:
    return order.kind, order.line, order.shape, order.rates, order.jerks, order.ramp, order.step


def last_change(profile: Profile) -> float:
    """Return the time after which the velocity of a profile is constant."""
    knots = profile.knots
    return knots[-1] if isfinite(knots[-1]) else knots[-2]


def is_without_flank(profile: Profile, elapsed: float) -> bool:
    """True if an acceleration stays constant to its end, as in a trapezoid."""
    knots = profile.knots
    k = min(max(0, bisect_right(knots, elapsed) - 1), len(profile.pieces) - 1)
    _, _, half, slope, amplitude, _, _ = profile.pieces[k]
    return bool(half and not slope and not amplitude and _flank(profile, elapsed) is None)


def _flank(profile: Profile, elapsed: float) -> tuple[Piece, float, float] | None:
    """Return the flank of a profile's ramp: its curve, its start, and its duration.

    None if the ramp has none, like a trapezoid.
    """
    knots = profile.knots
    k = min(max(0, bisect_right(knots, elapsed) - 1), len(profile.pieces) - 1)
    piece, x = profile.pieces[k], elapsed - knots[k]
    _, _, _, c3, amplitude, omega, phase = piece
    if amplitude:
        angle = omega * x + phase
        if not 0.0 < angle < pi:
            return None
        falls = max(angle, pi - angle)
        return piece, (falls - phase) / omega, (pi - falls) / omega
    position, v, acceleration, _ = derivatives(piece, x)
    slope = c3
    if not slope and k + 1 < len(profile.pieces):
        following = profile.pieces[k + 1]
        slope = 0.0 if following[4] or following[3] * acceleration >= 0.0 else following[3]
    if not slope:
        return None
    slope = -abs(slope) if acceleration > 0.0 else abs(slope)
    return (position, v, 0.5 * acceleration, slope, 0.0, 0.0, 0.0), 0.0, -acceleration / (6.0 * slope)
