"""Format values as Mint prints them.

A Float has four decimals, C's `%.4f`. From 1e9 on, or below 1e-4, it has C's `%e`; the
thresholds are not documented (docs/contributing/assumptions.md). Values are joined without spaces.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf, isnan

from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.mint.models import V4, age

LARGE, SMALL = 1e9, 1e-4
DECIMALS = 4


def show_float(value: float) -> str:
    """Format a Float for PRINT; -0 prints as 0, since Mint does not distinguish them."""
    if SMALL <= value < LARGE or -LARGE < value <= -SMALL:
        return f"{value:.4f}"
    if value == 0:
        return "0.0000"
    if isnan(value):
        return "NaN"
    if value in (inf, -inf):
        return "Inf" if value > 0 else "-Inf"
    return f"{value:e}"


def show_older(value: float) -> str:
    """Format a Float as a Mint v4 controller does, without trailing zeros."""
    text = show_float(value)
    return text.rstrip("0").rstrip(".") if "." in text and "e" not in text else text


def show_integer(value: float) -> str:
    """Format an Integer for PRINT."""
    return f"{value:d}"  # type: ignore[str-format,unused-ignore]


def shows_float(machine: Machine) -> Callable[[float], str]:
    """Return the function that formats Floats for PRINT on a machine.

    It depends on the controller, which may have v4, and on the machine file's `[assumptions]`.
    """
    assumptions, older = machine.assumptions, machine.model != "" and _is_older(machine.model)
    if not assumptions:
        return show_older if older else show_float
    decimals: int = assumptions.get("mint.float-decimals", DECIMALS)  # type: ignore[assignment]
    drops = assumptions.get("mint.float-zeros", "dropped" if older else "kept") == "dropped"
    exponent = str(assumptions.get("mint.float-exponent", "e+12"))

    def show(value: float) -> str:
        text = show_float(value)
        mantissa, e, power = text.partition("e")
        if e:
            sign, digits = power[0], power[1:]
            return f"{mantissa}{exponent[0]}{sign}{digits.zfill(len(exponent) - 2)}"
        if text[-1].isdigit():
            text = f"{value:.{decimals}f}"
            text = text if float(text) else text.replace("-", "")
        return text.rstrip("0").rstrip(".") if drops and "." in text else text

    return show


def _is_older(model: str) -> bool:
    return age(model) == V4
