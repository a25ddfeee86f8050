"""Words of Mint v4 by what MintMT has for them."""

from __future__ import annotations

from motionlang.mint.keywords.paths_operations import set_mode
from motionlang.mint.runtime.binding import Row, axis_of, of, of_word
from motionlang.mint.runtime.environment import Environment
from motionlang.mint.runtime.errors import AXIS, Error, Errors


def last(errors: Errors, of_axis: bool = False) -> Error | None:
    """The newest error that stands, and when they have all been read, the one that was read last."""
    known = [*errors.found, *([] if errors.found or errors.shown is None else [errors.shown])]
    return next((each for each in reversed(known) if not of_axis or each.group == AXIS), None)


def read_error(errors: Errors) -> int:
    return 0 if (found := last(errors)) is None else found.number


def read_line(errors: Errors) -> int:
    return 0 if (found := last(errors)) is None else errors.line_of(found)


def read_axis(errors: Errors) -> int:
    return -1 if (found := last(errors, of_axis=True)) is None else found.data[0]


def do_contour(environment: Environment, row: Row, axes: tuple[int, ...], line: int) -> None:
    """CONTOURON and CONTOUROFF."""
    for axis in axes:
        set_mode(environment, "CONTOURMODE", axis_of(environment, axis), row.name.endswith("ON"))


OPERATIONS = {
    "legacy.error": {"read": of(Errors, read_error)},
    "legacy.error_line": {"read": of(Errors, read_line)},
    "legacy.error_axis": {"read": of(Errors, read_axis)},
    "legacy.contour": {"do": of_word(Environment, do_contour)},
}
