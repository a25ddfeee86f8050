"""Tolerances for equal figures, with units, such as time=1ms and position=0.01uu."""

from __future__ import annotations

import re
from math import inf

# Figures that differ by no more than this fraction, or this amount, are equal: another mathematical library
# is no difference.
MIN_RELATIVE, MIN_ABSOLUTE = 1e-9, 1e-12
_TUBE = re.compile(r"(\w+)=([0-9.eE+-]+)\s*(%|[a-zA-Z/²]*)$")
# The kinds of tolerances, their units and factors to the units of a run.
UNITS = {
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6},
    "position": {"uu": 1.0},
    "speed": {"uu/s": 1.0},
}


class Tolerance:
    """Tolerances by kind: an amount, or a fraction of the figure.

    `shifts` is True if a time may also be in a printed figure: what comes later prints a later time.
    """

    def __init__(self, *texts: str, least: float = MIN_RELATIVE, shifts: bool = False) -> None:
        """Parse texts such as "time=1ms", "position=0.01uu", "speed=2%"; `least` is the fraction of any figure.

        Raises ValueError for any other text.
        """
        self.least, self.shifts = least, shifts
        self._sizes: dict[str, float] = {}
        self._relative: dict[str, float] = {}
        for text in texts:
            found = _TUBE.match(text.strip())
            units = UNITS.get(found[1]) if found else None
            if found is None or units is None or (found[3] != "%" and found[3] not in units):
                raise ValueError(
                    f"{text!r} is not a tolerance such as time=1ms, position=0.01uu, speed=10uu/s or speed=2%"
                )
            try:
                size = float(found[2])
            except ValueError:
                raise ValueError(f"{found[2]!r} in {text!r} is not a number") from None
            if not 0.0 <= size < inf:
                raise ValueError(f"the tolerance {text!r} must be 0 or more")
            if found[3] == "%":
                self._relative[found[1]] = size / 100.0
            else:
                self._sizes[found[1]] = size * units[found[3]]

    def size(self, kind: str) -> float:
        """Return the absolute tolerance of times, positions or speeds."""
        return self._sizes.get(kind, 0.0)

    def of(self, kind: str, one: float, other: float, unit: float = 1.0) -> float:
        """Return by how much two figures of a kind may differ; a size counts in so many of their units."""
        largest = max(abs(one), abs(other))
        fraction = max(self._relative.get(kind, 0.0), self.least)
        return max(self.size(kind) * unit, fraction * largest, MIN_ABSOLUTE)

    def is_figure(self, one: float, other: float) -> bool:
        """True if two printed figures may be the same time, in s or ms, position or speed."""
        units = (("time", 1.0), ("time", 1000.0), ("position", 1.0), ("speed", 1.0))
        return any(abs(one - other) <= self.of(kind, one, other, unit) for kind, unit in units)
