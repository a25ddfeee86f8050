"""How Mint prints values.

A Float has four decimals, C's `%.4f`, and from a billion on or below a ten-thousandth C's `%e`; the thresholds are
not documented (docs/fidelity.md). Values are joined without spaces.
"""

from __future__ import annotations

from math import isnan

LARGE, SMALL = 1e9, 1e-4


def show_float(value: float) -> str:
    """A Float as PRINT writes it; `-0` is 0, as Mint does not tell them apart."""
    if SMALL <= value < LARGE or -LARGE < value <= -SMALL:
        return f"{value:.4f}"
    if value == 0:
        return "0.0000"
    if isnan(value):
        return "NaN"
    if value in (float("inf"), float("-inf")):
        return "Inf" if value > 0 else "-Inf"
    return f"{value:e}"


def show_older(value: float) -> str:
    """A Float as a controller with Mint v4 writes it: without the zeros at its end."""
    text = show_float(value)
    return text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text


def show_integer(value: float) -> str:
    """An Integer as PRINT writes it."""
    return f"{value:d}"  # type: ignore[str-format,unused-ignore]


SHOWS = {"float": show_float, "integer": show_integer}
