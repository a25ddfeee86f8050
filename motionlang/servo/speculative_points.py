"""Points of a track for a speculative servo, by NumPy, equal to the last bit.

Such a servo repeats samples from the middle of a block after a change, and must reach the same results. The
table of pieces cannot be used, because its rounding depends on where a block begins.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from motionlang.planners.evaluate import positions
from motionlang.servo.demand import Generator

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

# Points from which NumPy is quicker than plain floats. It is not if several profiles share few points.
_WORTHWHILE = 100


class SpeculativeGenerator(Generator):
    """A generator whose points do not depend on how many are computed together."""

    __slots__ = ()

    def points(
        self, cycle: int, count: int, known: Sequence[float] = ()
    ) -> Sequence[float] | NDArray[np.float64]:
        """Return `known` and the points at the ends of `count` cycles from `cycle`."""
        if count < _WORTHWHILE:
            return super().points(cycle, count, known)
        track, period, past = self.track, self.period, cycle + count
        made = np.empty(len(known) + count)
        made[: len(known)] = known
        behind = made[len(known) :]
        while cycle < past:
            k = self.in_force(cycle)
            times = np.multiply(np.arange(cycle + 1, min(self.past(k), past) + 1), period)
            times -= track.starts[k]
            np.add(positions(track.profiles[k], times), self.offset(k), out=behind[: len(times)])
            behind = behind[len(times) :]
            cycle += len(times)
        return made
