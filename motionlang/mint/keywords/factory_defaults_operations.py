"""SYSTEMDEFAULTS and FACTORYDEFAULTS."""

from __future__ import annotations

from motionlang.mint.keywords.limits_resetting import do_default_all
from motionlang.mint.keywords.no_effect_operations import Kept

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]


def do_defaults(environment: Environment, row: Row) -> Operation:
    """SYSTEMDEFAULTS and FACTORYDEFAULTS: DEFAULTALL, and what was kept is forgotten."""
    values, restore = environment.part(Kept).values, do_default_all(environment, row)

    def do() -> None:
        restore()
        values.clear()

    return do


OPERATIONS = {
    "factory_defaults.defaults": {"do": do_defaults},
}
