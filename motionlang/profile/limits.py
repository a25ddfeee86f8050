"""The numbers a planner accepts, and the sentences it refuses the others with."""

from __future__ import annotations

from math import inf, isfinite, isnan

STILL = 1e-60
"""A velocity this small is rest: the ramp from it would underflow."""


def check_positive(**quantities: float) -> None:
    """Raise ValueError naming the first quantity that is not a finite number greater than zero."""
    for name, value in quantities.items():
        word = name.replace("_", " ")
        if isnan(value):
            raise ValueError(f"{word} is not a number")
        if not value > 0.0:
            raise ValueError(f"{word} must be greater than zero")
        if value == inf:
            raise ValueError(f"{word} must be finite")


def check_finite(**quantities: float) -> None:
    """Raise ValueError naming the first quantity that is NaN or infinite."""
    for name, value in quantities.items():
        word = name.replace("_", " ")
        if isnan(value):
            raise ValueError(f"{word} is not a number")
        if not isfinite(value):
            raise ValueError(f"{word} must be finite")


def check_ramp(ramp: float) -> None:
    """Raise ValueError unless 0 < ramp <= 0.5, the range of TN1069's trapezoidal S-curve (aPSn)."""
    if not 0.0 < ramp <= 0.5:
        raise ValueError("ramp must be greater than zero and at most 0.5")


def too_large() -> ValueError:
    """The error for a move whose figures leave the range of a 64-bit float."""
    return ValueError("the move is too large: its duration is not a finite number")
