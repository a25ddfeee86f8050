"""Random states and targets of moves, from which plans are compared with a second implementation."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Figures = NDArray[np.float64]


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
