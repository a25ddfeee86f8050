"""Numbers on the command line: types for argparse, each with its range."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from math import nan
from sys import float_info


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
            raise argparse.ArgumentTypeError(f"{text!r} is not {what}")
        return value

    return parse


def whole(what: str, low: int, high: int) -> Callable[[str], int]:
    """Return the type of a whole number from `low` to `high`, like `real`."""

    def parse(text: str) -> int:
        if not text.isdecimal() or len(text) > 10 or not low <= int(text) <= high:
            raise argparse.ArgumentTypeError(f"{text!r} is not {what}")
        return int(text)

    return parse


machine_time = real("a time in seconds, 0 or more", 0.0)


def quantity_names(text: str) -> tuple[str, ...]:
    """Return the names of quantities of a run, separated by commas."""
    from motionlang.analysis.quantities import quantity

    names = tuple(each.strip() for each in text.split(","))
    try:
        for name in names:
            quantity(name)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
    return names
