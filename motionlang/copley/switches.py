"""Switches and index marks of the machine of a simulated drive."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, floor, inf


@dataclass(frozen=True, slots=True)
class Switches:
    """Positions on the machine in counts; the drive is at 0 when it is switched on.

    The limit switches are active from `negative` down and from `positive` up, the home switch from `home` up.
    Index marks are at the multiples of `index`.
    """

    negative: float = -inf
    positive: float = inf
    home: float = inf
    index: float = 4000.0

    def inputs(self, place: float) -> int:
        """Return object 0x60FD: bits 0 and 1 limit switches, bit 2 home switch."""
        return (place <= self.negative) | (place >= self.positive) << 1 | (place >= self.home) << 2

    def next_index(self, place: float, direction: float) -> float:
        """Return the first index mark beyond a position."""
        count = place / self.index
        return (floor(count) + 1 if direction > 0 else ceil(count) - 1) * self.index
