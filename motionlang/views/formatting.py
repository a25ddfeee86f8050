"""Figures and outcomes in the wording that every view uses."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import isfinite
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from motionlang.kernel import Run

DIALECTS = {"mint": "Mint", "mccl": "MCCL"}
# A share of the largest number of a column below which another one is a rounding error of zero.
ROUNDING = 1e-12
_OUTCOMES = {
    "ended": "ended after {}",
    "until": "still running at the time limit of {}",
    "out": "still waiting at {}",  # for what the machine file has ended before, and ends no more
    "stopped": "stopped after {}",
    "fault": "stopped by an error at {}",
    "interrupted": "interrupted at {}",
    "open": "{} so far",  # a session, which ends only when its user leaves
}


def outcome(run: Run) -> str:
    """Return how the run ended, and its machine time."""
    text = _OUTCOMES["out" if run.has_run_out else run.status].format(clock_time(run.time))
    return f"{text} by {run.machine.stop}" if run.status == "stopped" else text


def dialect_name(name: str) -> str:
    """Return a dialect's name as its vendor writes it."""
    return DIALECTS.get(name, name)


def clock_time(seconds: float) -> str:
    """Format a machine time, with minutes and hours if needed and no needless digits."""
    if seconds < 60.0:
        return f"{_plain(seconds, 6)} s"
    minutes, rest = divmod(round(seconds, 3 if seconds < 3600.0 else 0), 60.0)
    if minutes < 60.0:
        return f"{int(minutes)} min {_plain(rest, 3)} s"
    return f"{int(minutes // 60)} h {int(minutes % 60):02d} min {_plain(rest, 0)} s"


def significant(value: float, digits: int) -> str:
    """Format a number with at most `digits` significant digits; 7e-05 is 0.00007."""
    text = f"{value:.{digits}g}"
    mantissa, _, exponent = text.partition("e-")
    if not exponent:
        return text
    return f"{value:.{len(mantissa.partition('.')[2]) + int(exponent)}f}"


def figure(value: float, decimals: int = 3) -> str:
    """Format a number of a column with `decimals`.

    Powers of ten are used if the text would be too long or show only zeros.
    """
    size = abs(value)
    if size >= 1e9 or 0.0 < size < 0.5 * 10.0**-decimals:
        return f"{value:.6g}"
    return f"{value + 0.0:.{decimals}f}"


def formatter(values: Iterable[float], most: int = 4) -> Callable[[float], str]:
    """Return a function that formats the numbers of a column, which all have the fewest decimals that show them.

    The decimals are at most `most`, unless all are small. A number that is a rounding error of zero, compared with the
    largest, is 0.
    """
    values = [value for value in values if isfinite(value)]
    least = ROUNDING * max(map(abs, values), default=0.0)
    decimals = decimals_of((value for value in values if abs(value) > least), most)
    return lambda value: figure(value if abs(value) > least else 0.0, decimals)


def decimals_of(values: Iterable[float], most: int = 4) -> int:
    """Return the fewest decimals that show all of `values`, at most `most`.

    The result may exceed `most` if all values are small.
    """
    values = list(values)
    largest = max(map(abs, values), default=0.0)
    while most < 12 and 0.0 < largest < 10.0 ** (2 - most):
        most += 1
    for decimals in range(most):
        if all(abs(value - round(value, decimals)) <= 1e-9 * max(1.0, abs(value)) for value in values):
            return decimals
    return most


def grouped(count: int) -> str:
    """Format an integer in groups of three digits: 20 000."""
    return f"{count:,}".replace(",", " ")


def line_number(line: int) -> str:
    """Format the number of a line; a line that is not known is an empty cell."""
    return str(line or "")


def peak_of(value: float) -> str:
    """Format the figure next to a curve to six digits."""
    return f"{value:.6g}"


def _plain(value: float, decimals: int) -> str:
    text = f"{value:.{decimals}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text
