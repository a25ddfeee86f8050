"""When a simulated motor stands for good, so that nobody need look at it until something is done to it."""

from __future__ import annotations

from operator import sub

# Seconds of rest after which a motor that hunts, but no further than before, is left to it.
HUNTING = 20.0
# What two blocks of a motor at rest may differ by: counts, and volts.
_SLACK = (1e-6, 1e-6, 1e-9, 1e-9)

TYPE_CHECKING = False
if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Extent = tuple[float, ...]


def extent(place: NDArray[np.float64], output: NDArray[np.float64]) -> Extent:
    """How far samples of the motor's position and of its output went, each way."""
    return -float(place.min()), float(place.max()), -float(output.min()), float(output.max())


class Stillness:
    """`calm` while the motor stands, as far as nothing is done to it; it does before its first command."""

    __slots__ = ("_before", "_rested", "_widest", "calm")

    def __init__(self) -> None:
        self.calm = True
        # How far the motor went in the last block of rest, in all of them, and how many seconds they were.
        self._before: Extent | None = None
        self._widest: Extent | None = None
        self._rested = 0.0

    def disturb(self) -> None:
        """Something was done: what was seen so far says nothing more."""
        self.calm, self._before, self._widest, self._rested = False, None, None, 0.0

    def judge(self, extent: Extent | None, seconds: float) -> None:
        """Take a block into account: how far position and output went, each way; None where the demand moved."""
        before, widest = self._before, self._widest if extent is not None else None
        self._before = extent
        self._rested = self._rested + seconds if extent is not None else 0.0
        self._widest = extent if widest is None or extent is None else tuple(map(max, widest, extent))
        hunting = self._rested > HUNTING and not _grown(widest, extent)
        self.calm = hunting or not _grown(before, extent)


def _grown(before: Extent | None, after: Extent | None) -> bool:
    """Whether a block went further than what was before it."""
    if before is None or after is None:
        return True
    return any(by > slack for by, slack in zip(map(sub, after, before), _SLACK, strict=True))
