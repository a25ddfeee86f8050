"""PRINT … USING: width and decimals.

`USING width` and `USING width, decimals`. A negative width prints the sign of positive numbers, too. Negative
decimals select the exponent form. A number that is too long for its width is printed in full, never cut
(docs/contributing/assumptions.md).
"""

from __future__ import annotations

from motionlang.kernel.errors import Rejected

# Wider than any terminal: a wild width is an error, not a request for a gigabyte of blanks.
WIDEST = 255


def using_float(value: float, width: int, decimals: int = 0) -> str:
    """Format a Float as `%w.df`, with a sign for a negative width; -0 prints as 0.

    Negative decimals give `%w.de`.
    """
    sign, width = _width(width)
    kind = "f" if decimals >= 0 else "e"
    return f"{value:{sign}z{width}.{_decimals(decimals)}{kind}}"


def using_integer(value: float, width: int, decimals: int | None = None) -> str:
    """Format an Integer as `%wd`, with a sign for a negative width.

    With decimals it is formatted as a Float.
    """
    if decimals is not None:
        return using_float(value, width, decimals)
    sign, width = _width(width)
    return f"{int(value):{sign}{width}d}"


def using_text(value: str, width: int, decimals: int = 0) -> str:
    """Format a string padded on the right, or on the left for a negative width."""
    _, size = _width(width)
    return value.rjust(size) if width < 0 else value.ljust(size)


def _width(width: int) -> tuple[str, int]:
    if abs(width) > WIDEST:
        raise Rejected("range", f"USING cannot be {width} wide", f"a width is at most {WIDEST}")
    return ("+" if width < 0 else ""), abs(width)


def _decimals(decimals: int) -> int:
    if abs(decimals) > WIDEST:
        raise Rejected("range", f"USING cannot have {decimals} decimals", f"there are at most {WIDEST}")
    return abs(decimals)


USING = {"float": using_float, "integer": using_integer, "text": using_text}
