"""Volts: analogue channels of the controller are percent of full scale, on PMC boards full scale is 10 V."""

from __future__ import annotations

PERCENT_PER_VOLT = 10.0


def volts(percent: float) -> float:
    """A channel's value in volts."""
    return percent / PERCENT_PER_VOLT


def percent(value: float) -> float:
    """Volts as a channel's value; an output ends at 10 V either way."""
    return max(-100.0, min(100.0, value * PERCENT_PER_VOLT))
