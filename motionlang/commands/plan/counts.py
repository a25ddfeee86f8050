"""Counts per user unit, from the encoder and the mechanics of a machine (AN00115).

The mechanics are a gear and a screw, or a linear scale.
"""

from __future__ import annotations

from math import isfinite


def rotary_scale(lines: float, per_turn: float, gear: float = 1.0, quadrature: int = 4) -> float:
    """Return the counts per unit of a rotary encoder with `lines` lines.

    The motor makes `gear` revolutions for `per_turn` units.
    """
    _positive(lines=lines, per_turn=per_turn, gear=gear)
    if quadrature not in (1, 2, 4):
        raise ValueError(f"a line gives 1, 2 or 4 counts, not {quadrature}")
    return lines * quadrature * gear / per_turn


def linear_scale(resolution: float) -> float:
    """Return the counts per unit of a linear encoder with a count every `resolution`.

    Quadrature is not applied.
    """
    _positive(resolution=resolution)
    return 1.0 / resolution


def _positive(**values: float) -> None:
    for name, value in values.items():
        if not (isfinite(value) and value > 0.0):
            raise ValueError(f"{name.replace('_', ' ')} must be greater than zero")
