"""Conversion between volts and values of analogue channels, in % of full scale.

Full scale is 10 V on PMC boards.
"""

from __future__ import annotations

PERCENT_PER_VOLT = 10.0


def volts(percent: float) -> float:
    """Convert a channel's value to volts."""
    return percent / PERCENT_PER_VOLT


def percent(value: float) -> float:
    """Convert volts to a channel's value, clamped to ±10 V."""
    return max(-100.0, min(100.0, value * PERCENT_PER_VOLT))
