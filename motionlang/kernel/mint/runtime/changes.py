"""Readings of no axis that change without an event, and the times of change."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.readers import Until
from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.runtime.environment import Environment

Maker = Callable[[Environment, Keyword], Callable[..., Any]]


def moving(make: Maker) -> Maker:
    """Make a reading that may change while anything moves, from the maker of its read."""
    return lambda environment, row: with_dependency(
        environment, make(environment, row), end_of_motion(environment)
    )


def always(make: Maker) -> Maker:
    """Make a reading that may change at any time."""
    return lambda environment, row: with_dependency(
        environment, make(environment, row), environment.dependencies.at_once
    )


def repeatable(make: Maker) -> Maker:
    """Mark a write that is a no-op if its value equals the present reading."""
    make.repeatable = True  # type: ignore[attr-defined]
    return make


def reported(make: Maker) -> Maker:
    """Mark a repeatable write that returns true if it has changed anything."""
    make.reported = True  # type: ignore[attr-defined]
    return repeatable(make)


def with_dependency(environment: Environment, read: Callable[..., Any], until: Until) -> Callable[..., Any]:
    """Return a read that also records its dependency.

    `until` receives the indices and the level of comparison, as `read` does.
    """
    dependencies = environment.dependencies

    def with_dependency(*where: Any) -> Any:
        if dependencies.notes is not None:
            dependencies.note(until, *where)
        return read(*where)

    return with_dependency


def end_of_motion(environment: Environment) -> Until:
    """Return a function that is now while anything moves, otherwise infinity.

    It is the time at which a reading may change. Motion is that of axes and of the encoders of the machine file.
    """
    controller, clock = environment.controller, environment.clock

    def until(*where: Any) -> float:
        still = all(map(controller.is_still, controller.axes)) and not any(
            map(controller.turns, controller.encoders)
        )
        return INFINITY if still else clock.now

    return until
