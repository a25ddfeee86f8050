"""Readings that no event tells of: how those say when they change that are bound to no axis."""

from __future__ import annotations

from motionlang.lang.task import INFINITY

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from motionlang.controller.readers import Until
    from motionlang.lang.keyword import Keyword
    from motionlang.mint.runtime.environment import Environment

    Maker = Callable[[Environment, Keyword], Callable[..., Any]]


def moving(make: Maker) -> Maker:
    """A reading that may change for as long as anything moves; `make` makes the function that reads."""
    return lambda environment, row: heard(environment, make(environment, row), end_of_motion(environment))


def always(make: Maker) -> Maker:
    """A reading that changes all the time."""
    return lambda environment, row: heard(environment, make(environment, row), environment.attention.at_once)


def repeatable(make: Maker) -> Maker:
    """A writing that does nothing where it writes what is there already, as reading the word tells."""
    make.repeatable = True  # type: ignore[attr-defined]
    return make


def heard(environment: Environment, read: Callable[..., Any], until: Until) -> Callable[..., Any]:
    """A reading that makes a note: it and `until` are given where it is made and what it is compared with."""
    attention = environment.attention

    def heard(*where: Any) -> Any:
        if attention.notes is not None:
            attention.note(until, *where)
        return read(*where)

    return heard


def end_of_motion(environment: Environment) -> Until:
    """What tells when something may change while anything moves: an axis, or an encoder that the world turns."""
    controller, clock = environment.controller, environment.clock

    def until(*where: Any) -> float:
        still = all(map(controller.is_still, controller.axes)) and not any(
            map(controller.turns, controller.encoders)
        )
        return INFINITY if still else clock.now

    return until
