"""The numbers a planner accepts, and the messages for those it rejects."""

from __future__ import annotations

from math import inf, isfinite, isnan

# A velocity this small is rest: the ramp from it would underflow.
STILL = 1e-60


# Bounds of speeds, rates, jerks and times. Their squares and quotients then stay in the range of a float.
SMALLEST, LARGEST = 1e-60, 1e60


def check_positive(**quantities: float) -> None:
    """Check that quantities are between SMALLEST and LARGEST.

    Raises ValueError for the first one that is outside or NaN.
    """
    for name, value in quantities.items():
        if SMALLEST <= value <= LARGEST:
            continue
        word = name.replace("_", " ")
        if isnan(value):
            raise ValueError(f"{word} is not a number")
        if not value > 0.0:
            raise ValueError(f"{word} must be greater than zero")
        if value == inf:
            raise ValueError(f"{word} must be finite")
        raise ValueError(f"{word} must lie between {SMALLEST:g} and {LARGEST:g}")


def check_rates(speed: float, accel: float, decel: float) -> None:
    """Raise ValueError unless a move may have this speed and these rates."""
    if not (
        speed >= SMALLEST and accel >= SMALLEST and decel >= SMALLEST and speed + accel + decel <= LARGEST
    ):
        check_positive(speed=speed, acceleration=accel, deceleration=decel)
        raise too_large()


def check_finite(**quantities: float) -> None:
    """Check that quantities are finite and do not exceed LARGEST.

    Raises ValueError for the first one that fails.
    """
    for name, value in quantities.items():
        if -LARGEST <= value <= LARGEST:
            continue
        word = name.replace("_", " ")
        if isnan(value):
            raise ValueError(f"{word} is not a number")
        if not isfinite(value):
            raise ValueError(f"{word} must be finite")
        raise ValueError(f"{word} must lie between -{LARGEST:g} and {LARGEST:g}")


def check_ramp(ramp: float) -> None:
    """Raise ValueError unless 0 < ramp <= 0.5, the range of TN1069's aPSn."""
    if not 0.0 < ramp <= 0.5:
        raise ValueError("ramp must be greater than zero and at most 0.5")


def too_large() -> ValueError:
    """Return the error for a move whose figures exceed the range of a 64-bit float."""
    return ValueError("the move is too large: its duration is not a finite number")
