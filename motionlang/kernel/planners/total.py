"""Exact sums, for results that do not depend on the Python version.

The builtin `sum` rounds differently from Python 3.12 on.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import fsum


def total(values: Iterable[float]) -> float:
    """Return the sum, rounded once; infinite or NaN if no float represents it."""
    terms = tuple(values)
    try:
        return fsum(terms)
    except (OverflowError, ValueError):
        beyond = 0.0  # adding one by one shows which
        for term in terms:
            beyond += term
        return beyond


def exact_terms(values: Iterable[float]) -> list[float]:
    """Return a few floats whose exact sum is the exact sum of all values.

    They are the rounded sum, its error, the error of that error, and so on.
    """
    rest = list(values)
    terms: list[float] = []
    while term := fsum(rest):
        terms.append(term)
        rest.append(-term)
    return terms
