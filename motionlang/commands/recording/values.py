"""A cell of a recording as a number: decimal points and commas, levels in words, units behind the number."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import nan

import numpy as np
from numpy.typing import NDArray

# Words of PLCs, loggers and spreadsheets for the two levels of a channel.
LEVELS = {
    **dict.fromkeys(("true", "on", "yes", "high", "wahr", "ein", "ja", "vrai"), 1.0),
    **dict.fromkeys(("false", "off", "no", "low", "falsch", "aus", "nein", "faux"), 0.0),
}
# Digits with blanks, apostrophes or separators of thousands in them, and a unit such as mm or °C behind them.
_FIGURE = re.compile(r"([-+]?[\d.,'’\s\u202f]*\d[.,]?(?:[eE][-+]?\d+)?)\s*[^\W\d]*[°%²³/\w]{0,8}")
# Larger numbers are no measurement; times have up to 19 digits.
LARGEST = 1e25
_GROUPS = str.maketrans("", "", "'’ \t\u00a0\u202f")


def number(cell: str) -> float:
    """Return the number or the level in a cell, NaN if it has neither."""
    try:
        value = float(cell) if "_" not in cell else nan
    except ValueError:
        value = _written(cell)
    return value if abs(value) <= LARGEST else nan


def _written(cell: str) -> float:
    """Return the number in a cell that is no number of Python's."""
    level = LEVELS.get(cell.lower())
    if level is not None:
        return level
    found = _FIGURE.fullmatch(cell)
    if found is None:
        return nan
    digits = found[1].translate(_GROUPS)
    comma, point = digits.rfind(","), digits.rfind(".")
    if digits.count(",") > 1 or (comma >= 0 and point > comma):
        digits = digits.replace(",", "")
    elif comma >= 0:
        digits = digits.replace(".", "").replace(",", ".")
    try:
        return float(digits)
    except ValueError:
        return nan


def numbers(cells: Sequence[str]) -> NDArray[np.float64]:
    """Return the numbers in a column, NaN where there are none."""
    return np.fromiter(map(number, cells), dtype=np.float64, count=len(cells))
