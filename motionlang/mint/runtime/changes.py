"""When what a Mint program has read changes by itself: with motion, as time is counted, or as it passes a level."""

from __future__ import annotations

from motionlang.controller.readers import Hearing
from motionlang.lang.task import INFINITY

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import Any

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Maker = Callable[[Environment, Row], Callable[..., Any]]


def moving(make: Maker) -> Maker:
    """A reading that may change for as long as an axis moves; `make` makes the function that reads."""
    return _noted(make, lambda environment: environment.part(Changes).moving)


def always(make: Maker) -> Maker:
    """A reading that changes all the time."""
    return _noted(make, lambda environment: environment.part(Changes).at_once)


def _noted(make: Maker, until_of: Callable[[Environment], Callable[[], float]]) -> Maker:
    def made(environment: Environment, row: Row) -> Callable[..., Any]:
        read, attention, until = make(environment, row), environment.attention, until_of(environment)

        def noted(*where: Any) -> Any:
            if attention.notes is not None:
                attention.note(until)
            return read(*where)

        return noted

    return made


def repeatable(make: Maker) -> Maker:
    """A writing that does nothing where it writes what is there already, as reading the word tells."""
    make.repeatable = True  # type: ignore[attr-defined]
    return make


def solved(find: Callable[[Changes, int, float], float]) -> Callable[[Changes, int, float | None], float]:
    """Of an axis that stands nothing changes; what is compared with no level may change at any time."""

    def until(self: Changes, axis: int, level: float | tuple[float] | None) -> float:
        if self.is_still(axis):
            return INFINITY
        if isinstance(level, tuple):
            return min(find(self, axis, level[0]), find(self, axis, -level[0]))
        return self.at_once() if level is None else find(self, axis, level)

    return until


class Changes:
    """The moments, from the clock's on, at which readings change; levels are in user units, or ms of a time.

    A reading that is compared with nothing, level None, changes for as long as something moves; one that is compared
    with what it was before, INFINITY, until it turns round. -INFINITY: whatever it is, nobody asks. One whose sign is
    taken off is compared with `(level,)`.
    """

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._controller, self._clock = environment.controller, environment.clock
        self.is_still = environment.controller.is_still
        self.at_once: Callable[[], float] = environment.attention.at_once

    def hearing(
        self, number: int, until: Callable[..., float] | None = None, wraps: Mapping[int, float] | None = None
    ) -> Hearing:
        """Who hears of a reading of an axis or a channel; `until` says when it passes what it is compared with."""
        attention, find = self._environment.attention, until or self._anything

        def note(level: float | None) -> None:
            if level != -INFINITY:
                attention.note(find, number, level)

        return Hearing(attention, note, wraps)

    def comparable(self, read: Callable[[int], float], until: Callable[..., float]) -> Callable[..., float]:
        """The same of a reading that is bound to none of them."""
        attention = self._environment.attention

        def compared(number: int, level: float | None = None) -> float:
            if attention.notes is not None and level != -INFINITY:
                attention.note(until, number, level)
            return read(number)

        return compared

    def _anything(self, number: int, level: float | None) -> float:
        return self.moving()

    def moving(self) -> float:
        """What may change while anything moves: an axis, or an encoder that the world turns."""
        controller = self._controller
        still = all(map(controller.is_still, controller.axes)) and not any(
            map(controller.turns, controller.encoders)
        )
        return INFINITY if still else self._clock.now

    @solved
    def position(self, axis: int, level: float) -> float:
        controller = self._controller
        return self._place(controller.crossing_time, controller.position, axis, level)

    @solved
    def demand(self, axis: int, level: float) -> float:
        controller = self._controller
        return self._place(controller.demand_crossing_time, controller.demand, axis, level)

    @solved
    def velocity(self, axis: int, level: float) -> float:
        """When the velocity passes a level, or the motion another knot; a simulated motor's may at any time."""
        controller = self._controller
        if controller.has_motor(axis):
            return self._clock.now
        return controller.demand_velocity_crossing_time(axis, self._counts(axis, level, "uu/s"))

    @solved
    def demand_velocity(self, axis: int, level: float) -> float:
        return self._controller.demand_velocity_crossing_time(axis, self._counts(axis, level, "uu/s"))

    @solved
    def following_error(self, axis: int, level: float) -> float:
        """Where no motor is simulated there is none."""
        if level == INFINITY:
            return self._clock.now if self._controller.has_motor(axis) else INFINITY
        return self._controller.error_crossing_time(axis, self._counts(axis, level, "uu"))

    @solved
    def remaining(self, axis: int, level: float) -> float:
        """When so much is still to go."""
        if level == INFINITY:
            return self._clock.now
        controller = self._controller
        return controller.demand_crossing_time(
            axis, controller.target(axis) - self._counts(axis, level, "uu")
        )

    @solved
    def offset(self, axis: int, level: float) -> float:
        """When so much is still to go of the offset of a slave, or of the move of another axis."""
        controller = self._controller
        if level == INFINITY or controller.master_of(axis) is None:
            return self.remaining(axis, level)
        from motionlang.controller.motion.offset import crossing_time

        return crossing_time(controller, controller.axes[axis], self._counts(axis, level, "uu"))

    def _counts(self, axis: int, level: float, unit: str) -> float:
        return self._controller.axes[axis].scale.to_counts(level, unit)

    def _place(
        self,
        passing: Callable[[int, float], float],
        place: Callable[[int], float],
        axis: int,
        level: float,
    ) -> float:
        """When a position passes a level."""
        scale, wrap = self._controller.axes[axis].scale, self._environment.wraps.get(axis, 0.0)
        if level == INFINITY:
            turns = not wrap and not self._controller.has_motor(axis)
            return self._controller.turning_time(axis) if turns else self._clock.now
        here = scale.position_to_user(place(axis))
        return passing_within(wrap, here, level, lambda place: passing(axis, scale.position_to_counts(place)))


def passing_within(wrap: float, here: float, level: float, passing: Callable[[float], float]) -> float:
    """When what is `here` now passes a level, as `passing` tells; what wraps, also when it begins again."""
    if not wrap:
        return passing(level)
    turn = here // wrap * wrap
    places = [turn + each + offset for each in (-wrap, 0.0, wrap) for offset in (0.0, level % wrap)]
    return min(map(passing, places))
