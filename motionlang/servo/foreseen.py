"""The points of a track for a servo that is seen before its time: by NumPy, and to the last bit as one by one.

What such a servo has seen is run again from the middle of a block where something else was done, and must come to the
same: the table of pieces, which rounds by where a block begins, is no help there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from motionlang.planners.evaluate import positions
from motionlang.servo.demand import Generator

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

# Points from which NumPy is quicker than plain floats, which it is not yet where several profiles share few points.
_WORTHWHILE = 100


class Foreseen(Generator):
    """A generator whose points do not depend on how many of them are asked for at once."""

    __slots__ = ()

    def points(
        self, cycle: int, count: int, known: Sequence[float] = ()
    ) -> Sequence[float] | NDArray[np.float64]:
        """`known`, then the points at the ends of `count` cycles from `cycle` on."""
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
