"""The only conversion between user units and counts."""

from __future__ import annotations

# Power of the length in a quantity of each unit; all other quantities are not converted.
POWERS = {"uu": 0, "uu/s": 1, "uu/s2": 2, "uu/s3": 3}


def in_unit(value: float, factors: tuple[float, float]) -> float:
    """Convert a value in counts and seconds to a user unit, given its `factors`."""
    rate, per_unit = factors
    return value * rate / per_unit


class Scale:
    """`counts` per user unit, seconds per user time unit (`rate`), the `zero`, and the `wrap`.

    A position that is shown starts again from 0 at `wrap` user units; 0 means that it does not. MCCL has the first
    three (US, UR, UO). Mint has the first and the last (POSWRAP).
    """

    __slots__ = ("counts", "factors", "rate", "wrap", "zero")

    def __init__(self, counts: float = 1.0, rate: float = 1.0, zero: float = 0.0) -> None:
        # By the power of the length: the factor and the divisor of a value in counts and seconds.
        self.factors: list[tuple[float, float]] = []
        self.counts, self.wrap = counts, 0.0
        self.set(counts, rate, zero)

    def set(self, counts: float, rate: float = 1.0, zero: float = 0.0) -> None:
        """Set one unit of length for positions, speeds and accelerations; the wrap keeps its counts."""
        if self.wrap:
            self.wrap *= abs(self.counts / counts)
        self.counts, self.rate, self.zero = counts, rate, zero
        self.factors[:] = [(rate**power, counts) for power in range(len(POWERS))]

    def to_counts(self, value_uu: float, unit: str = "uu") -> float:
        """Convert a value to counts and seconds; `zero` affects positions, not lengths."""
        power = POWERS.get(unit)
        if power is None:
            return value_uu
        rate, per_unit = self.factors[power]
        return value_uu * per_unit / rate

    def to_user(self, value: float, unit: str = "uu") -> float:
        """Convert a value in counts and seconds to a user unit."""
        power = POWERS.get(unit)
        if power is None:
            return value
        return in_unit(value, self.factors[power])

    def position_to_counts(self, position_uu: float) -> float:
        return position_uu * self.counts + self.zero

    def position_to_user(self, position: float) -> float:
        return (position - self.zero) / self.counts

    def shown_position(self, position: float) -> float:
        """Return a position in user units within the wrap."""
        value = (position - self.zero) / self.counts
        return value % self.wrap if self.wrap else value
