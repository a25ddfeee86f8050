"""Gains of the servo loop by the words of a language, for who is given them outside a program."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from motionlang.lang.keyword import Keyword
    from motionlang.servo.gains import Gains

# Quantities of MCCL that no command of their own sets: the integral's mode, and the rate, for which there are three.
BESIDE = {"IO": "integral_mode", "RATE": "rate"}


def gain_words(language: str, rows: Iterable[Keyword]) -> dict[str, str]:
    """By its word the quantity of the loop that each gain of a language sets."""
    return {row.name: row.tunes for row in rows if row.tunes} | (BESIDE if language == "mccl" else {})


def written(words: Mapping[str, str], values: Mapping[str, float]) -> Gains:
    """Values by their word, as the loop takes them; ValueError where a word is no gain."""
    for word in values:
        if word not in words:
            raise ValueError(f"{word} is not a servo gain; these are {', '.join(words)}")
    return {words[word]: (value, word) for word, value in values.items()}


def spoken(words: Mapping[str, str], values: Mapping[str, float]) -> dict[str, float]:
    """Values by their quantity as the words have them."""
    by_quantity = {quantity: word for word, quantity in words.items()}
    return {by_quantity[quantity]: value for quantity, value in values.items()}
