"""Tolerances for equal figures, with units, such as time=1ms and position=0.01uu."""

from __future__ import annotations

import re
from math import inf

# Figures that differ by no more than this fraction, or this amount, are equal: another mathematical library
# is no difference.
MIN_RELATIVE, MIN_ABSOLUTE = 1e-9, 1e-12
_TUBE = re.compile(r"(\w+)=([0-9.eE+-]+)\s*(%|[a-zA-Z/²]*)$")
# The kinds of tolerances, their units and factors to the units of a report.
UNITS = {
    "time": {"s": 1.0, "ms": 1e-3, "us": 1e-6},
    "position": {"uu": 1.0},
    "speed": {"uu/s": 1.0},
}
# The fields of a report that a tolerance applies to.
FIELDS = {
    "time": "time", "start_time": "time", "duration": "time", "settle_time": "time", "start": "position",
    "end": "position", "distance": "position", "position": "position", "peak_following_error": "position",
    "following_error": "position", "peak_speed": "speed",
    "commanded_speed": "speed",
}  # fmt: skip


class Tolerance:
    """Tolerances by kind: an amount, or a fraction of the figure."""

    def __init__(self, *texts: str) -> None:
        """Parse texts such as "time=1ms", "position=0.01uu", "speed=2%".

        Raises ValueError for any other text.
        """
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

    def same(self, expected: object, found: object, field: str = "") -> bool:
        """True if two values of a field are equal within its tolerance."""
        if isinstance(expected, float) and isinstance(found, float):
            kind = FIELDS.get(field, "")
            size = max(abs(expected), abs(found))
            tube = max(
                self._sizes.get(kind, 0.0),
                self._relative.get(kind, MIN_RELATIVE) * size,
                MIN_RELATIVE * size,
                MIN_ABSOLUTE,
            )
            return expected == found or abs(expected - found) <= tube
        return expected == found and type(expected) is type(found)


EXACT = Tolerance()
