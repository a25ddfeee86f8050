"""When what a Mint program has read changes by itself: with motion, as time is counted, or as it passes a level."""

from __future__ import annotations

from motionlang.controller.readers import Hearing
from motionlang.lang.task import INFINITY

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import Any

    from motionlang.lang.attention import Attention
    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Maker = Callable[[Environment, Row], Callable[..., Any]]


def moving(make: Maker) -> Maker:
    """A reading that may change for as long as an axis moves; `make` makes the function that reads."""

    def made(environment: Environment, row: Row) -> Callable[..., Any]:
        read, attention, until = (
            make(environment, row),
            environment.attention,
            environment.part(Changes).moving,
        )

        def noted(*where: Any) -> Any:
            if attention.notes is not None:
                attention.note(until)
            return read(*where)

        return noted

    return made


def always(make: Maker) -> Maker:
    """A reading that changes all the time."""

    def made(environment: Environment, row: Row) -> Callable[..., Any]:
        read, attention = make(environment, row), environment.attention

        def noted(*where: Any) -> Any:
            attention.note(attention.at_once)
            return read(*where)

        return noted

    return made


def repeatable(make: Maker) -> Maker:
    """A writing that does nothing where it writes what is there already, as reading the word tells."""
    make.repeatable = True  # type: ignore[attr-defined]
    return make


def comparable(
    environment: Environment, read: Callable[[int], float], until: Callable[..., float]
) -> Callable[..., float]:
    """A reading of an axis that may be told what it is compared with: `until` says when it passes that."""
    attention, moving = environment.attention, environment.part(Changes).moving

    def compared(axis: int, level: float | None = None) -> float:
        found = read(axis)
        if attention.notes is not None:
            note(attention, moving, until, axis, level)
        return found

    return compared


def note(
    attention: Attention,
    moving: Callable[[], float],
    until: Callable[..., float],
    axis: int,
    level: float | None,
) -> None:
    """Note the reading of an axis, with the level that it is compared with where that is known."""
    if level is None:
        attention.note(moving)
    else:
        attention.note(until, axis, level)


class Changes:
    """The moments, from the clock's on, at which readings change; levels are in user units, or ms of a time."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._controller, self._clock = environment.controller, environment.clock

    def hearing(
        self, axis: int, until: Callable[..., float] | None = None, wraps: Mapping[int, float] | None = None
    ) -> Hearing:
        """Who hears of a reading of an axis; `until` says when it passes the level that it is compared with."""
        attention, moving = self._environment.attention, self.moving

        def note(level: float | None) -> None:
            if level is None or until is None:
                attention.note(moving)
            else:
                attention.note(until, axis, level)

        return Hearing(attention, note, wraps)

    def moving(self) -> float:
        """What may change while any axis moves."""
        controller = self._controller
        return INFINITY if all(map(controller.is_still, controller.axes)) else self._clock.now

    def position(self, axis: int, level: float) -> float:
        return self._passing(self._controller.crossing_time, self._controller.position, axis, level)

    def demand(self, axis: int, level: float) -> float:
        return self._passing(self._controller.demand_crossing_time, self._controller.demand, axis, level)

    def remaining(self, axis: int, level: float) -> float:
        """When so much is still to go."""
        controller = self._controller
        if controller.is_still(axis):
            return INFINITY
        left = controller.axes[axis].scale.to_counts(level, "uu")
        return controller.demand_crossing_time(axis, controller.target(axis) - left)

    def offset(self, axis: int, level: float) -> float:
        """When so much is still to go of the offset of a slave, or of the move of another axis."""
        controller = self._controller
        if controller.is_still(axis) or controller.master_of(axis) is None:
            return self.remaining(axis, level)
        from motionlang.controller.motion.offset import crossing_time

        a = controller.axes[axis]
        return crossing_time(controller, a, a.scale.to_counts(level, "uu"))

    def _passing(
        self,
        passing: Callable[[int, float], float],
        place: Callable[[int], float],
        axis: int,
        level: float,
    ) -> float:
        """When a position passes a level; one that wraps, also when it begins again."""
        if self._controller.is_still(axis):
            return INFINITY
        scale = self._controller.axes[axis].scale
        wrap = self._environment.wraps.get(axis)
        if not wrap:
            return passing(axis, scale.position_to_counts(level))
        turn = scale.position_to_user(place(axis)) // wrap * wrap
        places = [turn + each + offset for each in (-wrap, 0.0, wrap) for offset in (0.0, level % wrap)]
        return min(passing(axis, scale.position_to_counts(place)) for place in places)
