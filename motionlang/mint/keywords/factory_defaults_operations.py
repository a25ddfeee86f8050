"""SYSTEMDEFAULTS and FACTORYDEFAULTS."""

from __future__ import annotations

from motionlang.mint.keywords.limits_resetting import default
from motionlang.mint.keywords.no_effect_operations import Kept
from motionlang.mint.runtime.binding import of
from motionlang.mint.runtime.environment import Environment


def do_defaults(environment: Environment) -> None:
    """SYSTEMDEFAULTS and FACTORYDEFAULTS: DEFAULTALL, and what was kept is forgotten."""
    for axis in environment.controller.axes:
        default(environment, axis)
    environment.part(Kept).values.clear()


OPERATIONS = {
    "factory_defaults.defaults": {"do": of(Environment, do_defaults)},
}
