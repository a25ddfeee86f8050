"""PRINT … USING: width and decimals.

`USING width` and `USING width, decimals`. A negative width asks for the sign of positive numbers too; decimals below
zero for the exponent form; a width that does not suffice is exceeded, never cut (docs/fidelity.md).
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal

# Wider than any terminal: a wild width is a mistake, not a request for a gigabyte of blanks.
WIDEST = 255


def using_float(value: float, width: int, decimals: int = 0) -> str:
    """A Float: `%w.df`, with a sign for a negative width, `%w.de` for negative decimals; 0 has no minus."""
    sign, width = _width(width)
    kind = "f" if decimals >= 0 else "e"
    return f"{value:{sign}z{width}.{_decimals(decimals)}{kind}}"


def using_integer(value: float, width: int, decimals: int | None = None) -> str:
    """An Integer: `%wd`, with a sign for a negative width; with decimals it is shown as a Float."""
    if decimals is not None:
        return using_float(value, width, decimals)
    sign, width = _width(width)
    return f"{int(value):{sign}{width}d}"


def using_text(value: str, width: int, decimals: int = 0) -> str:
    """A text: filled up with blanks on the right, on the left for a negative width."""
    _, size = _width(width)
    return value.rjust(size) if width < 0 else value.ljust(size)


def _width(width: int) -> tuple[str, int]:
    if abs(width) > WIDEST:
        raise Refusal("range", f"USING cannot be {width} wide", f"a width is at most {WIDEST}")
    return ("+" if width < 0 else ""), abs(width)


def _decimals(decimals: int) -> int:
    if abs(decimals) > WIDEST:
        raise Refusal("range", f"USING cannot have {decimals} decimals", f"there are at most {WIDEST}")
    return abs(decimals)


USING = {"float": using_float, "integer": using_integer, "text": using_text}
