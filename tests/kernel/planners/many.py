"""Hundreds of thousands of plans from random states, integrated independently.

The integrator takes the duration, the initial acceleration and the jerk of each piece of a profile, and
integrates these from the initial state of the plan, all profiles of a batch at once. It never reads a piece's
position or velocity, so an error in one of these shows at the end of the move.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from motionlang.kernel.planners import plan

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Figures = NDArray[np.float64]

BATCH = 20_000
# Pieces shorter than this fraction of their profile may begin with an acceleration: they are ramps below the
# clock's resolution.
_MOMENT = 1e-9


class States(NamedTuple):
    """Random states and targets over orders of magnitude.

    `rates` has a row for acceleration and one for deceleration, and so has `jerks`.
    """

    speed: Figures
    rates: Figures
    jerks: Figures
    v0: Figures
    a0: Figures
    start: Figures
    target: Figures


def drawn(choose: np.random.Generator, count: int, shape: str) -> States:
    """Return `count` states with accelerations that a ramp of the axis can have.

    The accelerations have either sign.
    """
    speed = 10.0 ** choose.uniform(-1.0, 4.0, count)
    rates = speed * 10.0 ** choose.uniform(-1.0, 2.0, (2, count))
    jerks = rates * 10.0 ** choose.uniform(-0.5, 2.5, (2, count))
    v0 = choose.uniform(-1.5, 1.5, count) * speed * (choose.random(count) < 0.8)
    a0 = choose.uniform(-1.0, 1.0, count) * rates.min(axis=0) * (choose.random(count) < 0.7)
    start = choose.uniform(-1.0, 1.0, count) * speed
    distance = choose.choice((1.0, 10.0, 0.01), count) * choose.uniform(-3.0, 3.0, count) * speed
    return States(speed, rates, jerks, v0, a0 * (shape == "scurve"), start, start + distance)


def integrated(states: States, shape: str) -> dict[str, Figures]:
    """Return for every plan the used fraction of each bound, and the relative gaps."""
    count, smooth = len(states.speed), shape == "scurve"
    columns = [
        each.tolist() for each in (states.start, states.target, states.speed, *states.rates, states.v0)
    ]
    jerk_limited = [each.tolist() for each in (*states.jerks, states.a0)]
    times, pieces = [], []
    for numbers, (up, down, a0) in zip(
        zip(*columns, strict=True), zip(*jerk_limited, strict=True), strict=True
    ):
        made = plan(shape, *(*numbers, 0.0, up, down, a0)) if smooth else plan(shape, *numbers)
        times.append(made.knots)
        pieces.append(made.pieces)
    most = max(map(len, pieces))
    lasts, rate, jerk = (np.zeros((most, count)) for _ in range(3))
    for n, (knots, some) in enumerate(zip(times, pieces, strict=True)):
        for k, piece in enumerate(some):
            lasts[k, n] = knots[k + 1] - knots[k]
            rate[k, n], jerk[k, n] = 2.0 * piece[2], 6.0 * piece[3]
    return _figures_of(states, smooth, lasts, rate, jerk)


def _figures_of(
    states: States, smooth: bool, lasts: Figures, rate: Figures, jerk: Figures
) -> dict[str, Figures]:
    speed, rates, jerks = states.speed, states.rates, states.jerks
    p, v, a = states.start.copy(), states.v0.copy(), states.a0.copy()
    own = np.where(states.a0 * states.v0 >= 0.0, jerks[0], jerks[1])
    came = np.maximum(np.abs(v), np.abs(v + 0.5 * a * np.abs(a) / own) if smooth else 0.0)
    fastest, whole = np.maximum(speed, came), lasts.sum(axis=0)
    names = ("speed", "acceleration", "deceleration", "jerk", "gap")
    found = {name: np.zeros(len(speed)) for name in names}
    low, high = p.copy(), p.copy()
    for dt, a_, j in zip(lasts, rate, jerk, strict=True):
        late = 1e-15 * (1.0 + whole)
        if smooth:
            gap = (np.abs(a_ - a) - 2.0 * late * jerks.max(axis=0)) / rates.max(axis=0)
            _note(found, "gap", np.where(dt > _MOMENT * whole, gap, 0.0))
        # The times of velocity reversal and of its peak, or the ends without one.
        summit = np.clip(np.where(j != 0.0, -a_ / np.where(j, j, 1.0), 0.0), 0.0, dt)
        for begin, end in ((np.zeros_like(dt), summit), (summit, dt)):
            _check(found, states, (v, a_, j), (begin, end, whole), fastest)
        p = p + ((j * dt / 6.0 + 0.5 * a_) * dt + v) * dt
        v, a = v + (0.5 * j * dt + a_) * dt, a_ + j * dt
        low, high = np.minimum(low, p), np.maximum(high, p)
    size = np.maximum.reduce([np.abs(states.target), np.abs(low), np.abs(high), high - low, speed])
    found["end"] = np.abs(p - states.target) / size
    found["rest"] = (np.abs(v) - 2e-15 * (1.0 + whole) * rates.max(axis=0)) / fastest
    return found


def _check(
    found: dict[str, Figures],
    states: States,
    piece: tuple[Figures, Figures, Figures],
    times: tuple[Figures, Figures, Figures],
    fastest: Figures,
) -> None:
    """Check the bounds over an interval of monotone velocity, split where it is zero."""
    (v, a, j), (begin, end, whole) = piece, times
    first, last = (v + (0.5 * j * x + a) * x for x in (begin, end))
    _note(found, "speed", np.maximum(np.abs(first), np.abs(last)) / fastest)
    push = np.maximum(np.abs(a + j * begin), np.abs(a + j * end))
    reverses = first * last < 0.0
    still = np.maximum(np.abs(first), np.abs(last)) <= 1e-9 * fastest
    empty = (end - begin <= 1e-12 * whole) | still
    up = (first + last) * (a + 0.5 * j * (begin + end)) > 0.0
    for side, name in enumerate(("acceleration", "deceleration")):
        mine = ~empty & ~reverses & (up if side == 0 else ~up)
        bound = np.maximum(states.rates[side], np.abs(states.a0))
        _note(found, name, np.where(mine, push / bound, 0.0))
        if j.any():
            _note(found, "jerk", np.where(mine, np.abs(j) / states.jerks[side], 0.0))
    # A motion that reverses eases out at the jerk that it began with, at a rate of either side.
    both = np.maximum(states.rates.max(axis=0), np.abs(states.a0))
    _note(found, "acceleration", np.where(~empty & reverses, push / both, 0.0))
    if j.any():
        _note(found, "jerk", np.where(~empty & reverses, np.abs(j) / states.jerks.max(axis=0), 0.0))


def _note(found: dict[str, Figures], name: str, share: Figures) -> None:
    found[name] = np.maximum(found[name], share)
