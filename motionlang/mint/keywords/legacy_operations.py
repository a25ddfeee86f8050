"""Words of Mint v4 by what MintMT has for them."""

from __future__ import annotations

from motionlang.mint.keywords.paths_operations import write_mode
from motionlang.mint.runtime.binding import Row as Named
from motionlang.mint.runtime.errors import AXIS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment
    from motionlang.mint.runtime.errors import Error


def _last(environment: Environment, of_axis: bool = False) -> Error | None:
    """The newest error that stands, and when they have all been read, the one that was read last."""
    errors = environment.errors
    known = [*errors.found, *([] if errors.found or errors.shown is None else [errors.shown])]
    return next((each for each in reversed(known) if not of_axis or each.group == AXIS), None)


def read_error(environment: Environment, row: Row) -> Operation:
    environment.errors  # noqa: B018 - it listens from now on
    return lambda: 0 if (last := _last(environment)) is None else last.number


def read_error_line(environment: Environment, row: Row) -> Operation:
    errors = environment.errors
    return lambda: 0 if (last := _last(environment)) is None else errors.line_of(last)


def read_error_axis(environment: Environment, row: Row) -> Operation:
    environment.errors  # noqa: B018 - it listens from now on
    return lambda: -1 if (last := _last(environment, of_axis=True)) is None else last.data[0]


def do_contour(environment: Environment, row: Row) -> Operation:
    """CONTOURON and CONTOUROFF."""
    mode = write_mode(environment, Named("", "CONTOURMODE", "integer", "axis", 0, 1))
    on = int(row.name.endswith("ON"))

    def do(axes: tuple[int, ...], line: int) -> None:
        for axis in axes:
            mode(axis, on)

    return do


OPERATIONS = {
    "legacy.error": {"read": read_error},
    "legacy.error_line": {"read": read_error_line},
    "legacy.error_axis": {"read": read_error_axis},
    "legacy.contour": {"do": do_contour},
}
