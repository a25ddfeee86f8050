"""Settings without an effect: kept, read back, and named in the report when the program writes them."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.binding import Row
    from motionlang.mint.environment import Environment

    Operation = Callable[..., object]


class Kept:
    """The values, by keyword and indices."""

    def __init__(self, environment: Environment) -> None:
        self.values: dict[tuple[object, ...], object] = {}


def read_value(environment: Environment, row: Row) -> Operation:
    values, name = environment.part(Kept).values, row.name
    nothing: object = "" if row.unit == "text" else 0.0 if row.unit == "number" else 0
    return lambda *where: values.get((name, *where), nothing)


def write_value(environment: Environment, row: Row) -> Operation:
    values, name, without_effect = environment.part(Kept).values, row.name, environment.machine.without_effect

    def write(*given: object) -> None:
        *where, value = given
        without_effect.setdefault(name)
        values[name, *where] = value

    return write
