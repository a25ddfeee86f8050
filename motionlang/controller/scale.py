"""The only door between user units and counts."""

from __future__ import annotations

# Power of the length in a quantity of each unit; everything else passes the door unchanged.
_LENGTHS = {"uu": 0, "uu/s": 1, "uu/s2": 2, "uu/s3": 3}


class Scale:
    """`counts` per user unit, seconds per user time unit (`rate`), and the zero that positions count from.

    MCCL has all three (US, UR, UO); Mint only the first, and on newer drives units of their own for speeds and for
    accelerations and jerks: `speed` and `acceleration`, None where they go by `counts`.
    """

    __slots__ = ("acceleration", "counts", "rate", "speed", "zero")

    def __init__(self, counts: float = 1.0, rate: float = 1.0, zero: float = 0.0) -> None:
        self.set(counts, rate, zero)

    def set(self, counts: float, rate: float = 1.0, zero: float = 0.0) -> None:
        """One unit of length for everything."""
        self.counts, self.rate, self.zero = counts, rate, zero
        self.speed: float | None = None
        self.acceleration: float | None = None

    def to_counts(self, value_uu: float, unit: str = "uu") -> float:
        """A value in a user unit, in counts and seconds; `zero` is not a matter of lengths but of positions."""
        power = _LENGTHS.get(unit)
        if power is None:
            return value_uu
        return value_uu * self.per_unit(power) / self.rate**power

    def to_user(self, value: float, unit: str = "uu") -> float:
        """A value in counts and seconds, in a user unit."""
        power = _LENGTHS.get(unit)
        if power is None:
            return value
        return value * self.rate**power / self.per_unit(power)

    def per_unit(self, power: int) -> float:
        """Counts in the unit of length of positions (0), speeds (1), accelerations (2) or jerks (3)."""
        own = self.speed if power == 1 else self.acceleration if power else None
        return self.counts if own is None else own

    def position_to_counts(self, position_uu: float) -> float:
        return position_uu * self.counts + self.zero

    def position_to_user(self, position: float) -> float:
        return (position - self.zero) / self.counts
