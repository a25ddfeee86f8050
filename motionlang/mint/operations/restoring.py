"""SYSTEMDEFAULTS and FACTORYDEFAULTS."""

from __future__ import annotations

from motionlang.mint.operations.kept import Kept
from motionlang.mint.operations.resetting import do_default_all

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.binding import Row
    from motionlang.mint.environment import Environment

    Operation = Callable[..., object]


def do_defaults(environment: Environment, row: Row) -> Operation:
    """SYSTEMDEFAULTS and FACTORYDEFAULTS: DEFAULTALL, and what was kept is forgotten."""
    values, restore = environment.part(Kept).values, do_default_all(environment, row)

    def do() -> None:
        restore()
        values.clear()

    return do
