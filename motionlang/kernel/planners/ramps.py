"""Velocity ramps, and their expansion into cubic pieces with up to one sine term.

A *recipe* is a flat tuple v0, T1, kind1, v1, T2, kind2, v2 ...: velocities joined by ramps, each with its
duration and its kind. Planners return only recipes, because the running program needs the plan, but not its pieces,
which are for drawing. A kind between 0 and 0.5 is the ramp ratio of a trapezoidal acceleration (0 a constant
acceleration, 0.5 a triangular one); the others are the three constants below.

A *piece* is (c0, c1, c2, c3, amplitude, omega, phase) in time x since its knot:
p(x) = c0 + c1 x + c2 x^2 + c3 x^3 + amplitude sin(omega x + phase). A sine piece has c2 = c3 = 0 and stays
inside one half wave, 0 <= omega x + phase <= pi.
"""

from __future__ import annotations

from math import inf, pi
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from motionlang.kernel.planners.pieces import Formula

# Ramps of a velocity: v0, T1, kind1, v1 and so on.
Recipe = tuple[float, ...]
# A piece of a profile that is one polynomial or one half wave.
Plain = tuple[float, float, float, float, float, float, float]
Marks = tuple[tuple[str, int], ...]
# A piece of a profile, plain or a formula.
Piece: TypeAlias = "Plain | Formula"
# Knots, pieces, and the first piece of each phase.
Curve: TypeAlias = "tuple[tuple[float, ...], tuple[Piece, ...], Marks]"
PlainCurve = tuple[tuple[float, ...], tuple[Plain, ...], Marks]

# Acceleration A sin(pi t/T): TN1069's sinusoidal S-curve.
SINE = -1.0
# Acceleration falling linearly from its peak to zero (TN1069, parabolic). It speeds up.
FALLING = -2.0
# Acceleration growing linearly from zero to its peak, to slow down.
RISING = -3.0

# Durations, s, too short to divide by their square. Ramps this short, or below the clock's resolution, are left out.
MOMENT = 1e-100


def ramp_distance(v_from: float, duration: float, kind: float, v_to: float) -> float:
    """Return the distance of a ramp.

    Symmetrical kinds have the mean of both velocities. Parabolic ones cover two thirds: TN1069 has S_A = T_A VEL/2, and
    2/3 T_A VEL for the parabolic profile.
    """
    if kind == FALLING:
        return (v_from + 2.0 * v_to) * duration / 3.0
    if kind == RISING:
        return (2.0 * v_from + v_to) * duration / 3.0
    return 0.5 * (v_from + v_to) * duration


def expand(start: float, recipe: Recipe) -> PlainCurve:
    """Return knots, pieces and phase marks of a recipe that begins at `start`.

    A mark is the name of a phase and the index of its first piece.
    """
    time = 0.0
    knots = [0.0]
    pieces: list[Plain] = []
    marks: list[tuple[str, int]] = []
    for i in range(0, len(recipe) - 1, 3):
        v_from, duration, kind, v_to = recipe[i : i + 4]
        if duration < MOMENT or time + duration == time:
            continue
        last = i + 4 == len(recipe)
        marks.append((_name(v_from, v_to, last), len(pieces)))
        _add_ramp(knots, pieces, time, start, (v_from, duration, kind, v_to))
        time += duration
        knots[-1] = time
        if duration != inf:
            start += ramp_distance(v_from, duration, kind, v_to)
    return tuple(knots), tuple(pieces), tuple(marks)


def named_ramps(recipe: Recipe) -> list[tuple[str, float, float, float, float]]:
    """Return name, duration, distance and end velocities of each ramp.

    Ramps that take no time are omitted.
    """
    found = []
    final = len(recipe) - 4
    for i in range(0, final + 1, 3):
        v_from, duration, kind, v_to = recipe[i : i + 4]
        if duration > 0.0:
            distance = ramp_distance(v_from, duration, kind, v_to)
            found.append((_name(v_from, v_to, i == final), duration, distance, v_from, v_to))
    return found


def _name(v_from: float, v_to: float, last: bool) -> str:
    if v_from == v_to:
        return "slew"
    if abs(v_to) > abs(v_from):
        return "accel"
    return "stop" if v_to == 0.0 and not last else "decel"


def _add_ramp(
    knots: list[float], pieces: list[Plain], time: float, p: float, ramp: tuple[float, float, float, float]
) -> None:
    v_from, duration, kind, v_to = ramp
    change = v_to - v_from
    if change == 0.0:
        pieces.append((p, v_from, 0.0, 0.0, 0.0, 0.0, 0.0))
    elif kind == 0.0:
        pieces.append((p, v_from, 0.5 * change / duration, 0.0, 0.0, 0.0, 0.0))
    elif kind == SINE:
        amplitude = -0.5 * change * duration / pi
        pieces.append((p, 0.5 * (v_from + v_to), 0.0, 0.0, amplitude, pi / duration, 0.0))
    elif kind == FALLING:
        pieces.append((p, v_from, change / duration, -change / (3.0 * duration * duration), 0.0, 0.0, 0.0))
    elif kind == RISING:
        pieces.append((p, v_from, 0.0, change / (3.0 * duration * duration), 0.0, 0.0, 0.0))
    else:
        _add_trapezoidal(knots, pieces, time, p, ramp)
        return
    knots.append(time + duration)


def _add_trapezoidal(
    knots: list[float], pieces: list[Plain], time: float, p: float, ramp: tuple[float, float, float, float]
) -> None:
    """Add the pieces of a ramp with trapezoidal acceleration.

    It rises for ratio T, is constant, and falls for ratio T (TN1069, Mint's S-ramp).
    """
    v_from, duration, ratio, v_to = ramp
    rise = (
        min(ratio, 0.5) * duration
    )  # if the peak is only just reached, rounding may put it after the middle
    hold = duration - 2.0 * rise
    risen, falling, finish = time + rise, time + (duration - rise), time + duration
    if not time < risen <= falling < finish:  # too short for the clock's resolution
        _add_ramp(knots, pieces, time, p, (v_from, duration, 0.0, v_to))
        return
    peak = (v_to - v_from) / (duration - rise)
    sixth = peak / (6.0 * rise)
    bend = 0.5 * peak * rise
    pieces.append((p, v_from, 0.0, sixth, 0.0, 0.0, 0.0))
    knots.append(risen)
    p += v_from * rise + sixth * rise * rise * rise
    if hold > 0.0 and risen < falling:
        v = v_from + bend
        pieces.append((p, v, 0.5 * peak, 0.0, 0.0, 0.0, 0.0))
        knots.append(falling)
        p += (v + 0.5 * peak * hold) * hold
    pieces.append((p, v_to - bend, 0.5 * peak, -sixth, 0.0, 0.0, 0.0))
    knots.append(finish)
