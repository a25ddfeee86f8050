"""Readers of the values of options: numbers with their ranges, lists of names."""

from __future__ import annotations

from collections.abc import Callable
from math import nan
from sys import float_info

from motionlang.kernel import failures


def real(
    what: str, low: float, high: float = float_info.max, *, above: bool = False
) -> Callable[[str], float]:
    """Return the type of a number from `low`, or `above` it, to `high`.

    `what` names it in messages.
    """

    def parse(text: str) -> float:
        try:
            value = float(text)
        except ValueError:
            value = nan
        if not (low < value <= high or (value == low and not above)):
            raise ValueError(f"{text!r} is not {what}")
        return value

    return parse


def whole(what: str, low: int, high: int) -> Callable[[str], int]:
    """Return the type of a whole number from `low` to `high`, like `real`."""

    def parse(text: str) -> int:
        if not text.isdecimal() or len(text) > 10 or not low <= int(text) <= high:
            raise ValueError(f"{text!r} is not {what}")
        return int(text)

    return parse


def integer(text: str) -> int:
    """Return a whole number of any sign."""
    try:
        return int(text)
    except ValueError:
        raise ValueError(f"{text!r} is not a whole number") from None


def number(text: str) -> float:
    """Return any number."""
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"{text!r} is not a number") from None


COUNT = whole("a whole number above 0", 1, 999_999_999)
wall_time = real("a time in seconds above 0", 0.0, above=True)
machine_time = real("a time in seconds, 0 or more", 0.0)


def columns(text: str) -> list[str]:
    """Return the names of columns of a trace, separated by commas."""
    from motionlang.kernel.tracks import quantity_of

    found = [each.strip() for each in text.split(",")]
    for each in found:
        quantity_of(each)
    return found


def allowed(text: str) -> frozenset[str]:
    """Return the kinds of events that are accepted, separated by commas."""
    return failures.allowed(each.strip() for each in text.split(","))


def among(*names: str) -> Callable[[str], frozenset[str]]:
    """Return a reader of some of these names, separated by commas."""

    def read(text: str) -> frozenset[str]:
        found = frozenset(each.strip() for each in text.split(","))
        unknown = sorted(found.difference(names))
        if unknown:
            raise ValueError(f"{unknown[0]!r} is not one of {', '.join(names)}")
        return found

    return read


def axes(text: str) -> tuple[int, ...]:
    """Return the numbers of axes, separated by commas."""
    try:
        return tuple(int(each) for each in text.split(","))
    except ValueError:
        raise ValueError(f"{text!r} is not a list of axes such as 0,2") from None


def path(text: str) -> tuple[int, ...]:
    """Return the two or three axes of a path, separated by commas."""
    found = axes(text)
    if len(found) not in (2, 3) or len(set(found)) != len(found):
        raise ValueError(f"{text!r} is not a path: give two or three axes, such as 0,1")
    return found
