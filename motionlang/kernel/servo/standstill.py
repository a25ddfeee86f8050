"""Detection of a simulated motor that stays at standstill until it is disturbed."""

from __future__ import annotations

from itertools import chain
from operator import sub
from typing import TYPE_CHECKING

from motionlang.kernel.servo.step import State

# Seconds of rest after which a motor that hunts, but no further than before, counts as at standstill.
HUNTING = 20.0
# The allowed difference of two blocks of a motor at rest: counts, and volts.
_SLACK = (1e-6, 1e-6, 1e-9, 1e-9)
# The rounding of a motor that stays: in any unit, and as a fraction.
_STILL, _ROUNDING = 1e-9, 1e-14


if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

Extent = tuple[float, ...]


def extent(position: NDArray[np.float64], output: NDArray[np.float64]) -> Extent:
    """Return the range of a motor's position and output over some samples."""
    return -float(position.min()), float(position.max()), -float(output.min()), float(output.max())


def is_still(extent: Extent, before: State, after: State) -> bool:
    """True if only rounding moves a motor, so that further samples repeat the present one.

    `extent` is its range of position and output over some samples; the states are those before and after them.
    """
    low, high, least, most = extent
    ranges = ((-low, high), (-least, most), *zip(chain(*before), chain(*after), strict=True))
    return all(abs(b - a) <= _STILL + _ROUNDING * abs(a) for a, b in ranges)


class StandstillDetector:
    """A detector of a motor at standstill that lasts until a disturbance.

    `at_standstill` is also true before any command.
    """

    def __init__(self) -> None:
        self.at_standstill = True
        # The range of the motor in the last block of rest, in all of them, and their duration in seconds.
        self._before: Extent | None = None
        self._widest: Extent | None = None
        self._rested = 0.0

    def disturb(self) -> None:
        """Discard the history after a disturbance."""
        self.at_standstill, self._before, self._widest, self._rested = False, None, None, 0.0

    def check(self, extent: Extent | None, seconds: float) -> None:
        """Add a block of samples to the history and update `at_standstill`.

        `extent` is its range of position and output, or None if the command moved; `seconds` is its duration.
        """
        before, widest = self._before, self._widest if extent is not None else None
        self._before = extent
        self._rested = self._rested + seconds if extent is not None else 0.0
        self._widest = extent if widest is None or extent is None else tuple(map(max, widest, extent))
        hunting = self._rested > HUNTING and not _grown(widest, extent)
        self.at_standstill = hunting or not _grown(before, extent)


def _grown(before: Extent | None, after: Extent | None) -> bool:
    """True if a block exceeds the range before it."""
    if before is None or after is None:
        return True
    return any(by > slack for by, slack in zip(map(sub, after, before), _SLACK, strict=True))
