"""Switches and index marks of the machine that a simulated drive moves."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, floor, inf


@dataclass(frozen=True, slots=True)
class Switches:
    """Positions of the switches on the machine, counts; the drive starts at 0.

    The limit switches are active at and below `negative`, and at and above `positive`, the home switch at and above
    `home`. There is an index mark at each multiple of `index`.
    """

    negative: float = -inf
    positive: float = inf
    home: float = inf
    index: float = 4000.0

    def inputs(self, position: float) -> int:
        """Return object 0x60FD: bits 0 and 1 are limit switches, bit 2 the home switch."""
        return (position <= self.negative) | (position >= self.positive) << 1 | (position >= self.home) << 2

    def next_index(self, position: float, direction: float) -> float:
        """Return the first index mark beyond a position."""
        count = position / self.index
        return (floor(count) + 1 if direction > 0 else ceil(count) - 1) * self.index
