"""Servo gains by the keywords of a language, for use outside a program."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from motionlang.kernel.servo import Gains

if TYPE_CHECKING:
    from motionlang.kernel import Keyword

# Quantities of MCCL without a command of their own: the integral's mode, and the rate, for which there are
# three.
FURTHER = {"IO": "integral_mode", "RATE": "rate"}


def gain_words(language: str, rows: Iterable[Keyword]) -> dict[str, str]:
    """Return the quantity of the servo loop that each gain keyword of a language sets."""
    return {row.name: row.tunes for row in rows if row.tunes} | (FURTHER if language == "mccl" else {})


def written(words: Mapping[str, str], values: Mapping[str, float]) -> Gains:
    """Convert values by keyword to the loop's gains; ValueError for an unknown gain."""
    for word in values:
        if word not in words:
            raise ValueError(f"{word} is not a servo gain; these are {', '.join(words)}")
    return {words[word]: (value, word) for word, value in values.items()}


def spoken(words: Mapping[str, str], values: Mapping[str, float]) -> dict[str, float]:
    """Convert values by quantity to values by keyword."""
    by_quantity = {quantity: word for word, quantity in words.items()}
    return {by_quantity[quantity]: value for quantity, value in values.items()}
