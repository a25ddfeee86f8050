"""Exact sums: the builtin `sum` rounds otherwise from Python 3.12 on, and the figures of a run may not."""

from __future__ import annotations

from math import fsum

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable


def total(values: Iterable[float]) -> float:
    """The sum, rounded once; infinite or not a number where no float holds it."""
    terms = tuple(values)
    try:
        return fsum(terms)
    except (OverflowError, ValueError):
        beyond = 0.0  # added one by one they say which
        for term in terms:
            beyond += term
        return beyond


def exact_terms(values: Iterable[float]) -> list[float]:
    """A few floats that add up to exactly what all of these do: their sum, what it lacks, what that lacks."""
    rest = list(values)
    terms: list[float] = []
    while term := fsum(rest):
        terms.append(term)
        rest.append(-term)
    return terms
