"""The pieces of a history of profiles as NumPy columns, and their values at evenly spaced times."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.planners.curve import Profile, pieces_of
from motionlang.kernel.planners.evaluate import evaluate, piece_values

Array = NDArray[np.float64]

# The quantities of a profile, and the derivative of position that each is.
ORDERS = {"position": 0, "velocity": 1, "acceleration": 2, "jerk": 3}


class PieceTable:
    """The pieces of a history as columns: start times and coefficients (7 x pieces).

    The columns have cubics for drawing in place of formulas; samples come from the formulas.
    """

    def __init__(self, starts: Sequence[float], profiles: Sequence[Profile]) -> None:
        begins, pieces = pieces_of(starts, profiles)
        self.origins = np.array(begins)
        self.columns = np.array(pieces, dtype=np.float64).reshape(-1, 7).T
        self._formulas = [
            (start, min(start + profile.duration, end), profile)
            for start, end, profile in zip(starts, [*starts[1:], inf], profiles, strict=False)
            if not profile.pieced
        ]

    @property
    def is_exact(self) -> bool:
        """True if no profile is a formula, which the columns only approximate."""
        return not self._formulas

    def sample(self, t0: float, dt: float, n: int, order: int = 0) -> Array:
        """Return n values of derivative `order` at t0, t0 + dt, …

        A time at a knot, within rounding, belongs to the next piece.
        """

        def first(times: Array) -> NDArray[np.int64]:
            rounding = min(1e-9, 1e-15 * (abs(t0) / dt + n))
            return np.clip(np.ceil((times - t0) / dt - rounding), 0, n).astype(np.int64)

        if not len(self.origins):
            return np.zeros(n)
        counts = np.diff(np.concatenate(([0], first(self.origins[1:]), [n])))
        piece = np.repeat(np.arange(len(counts)), counts)
        out = piece_values(self.columns, piece, np.arange(n) * dt - (self.origins - t0)[piece], order)
        for begin, end, profile in self._formulas:
            low, high = first(np.array([begin, end])).tolist()
            times = np.maximum(t0 + np.arange(low, high) * dt - begin, 0.0)
            out[low:high] = evaluate(profile, times, order)
        return out
