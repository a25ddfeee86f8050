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


class Changes:
    """The moments, from the clock's on, at which readings change; levels are in user units, or ms of a time.

    A reading that is compared with nothing, level None, changes for as long as something moves; one that is compared
    with what it was before, INFINITY, until it turns round. -INFINITY: whatever it is, nobody asks.
    """

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._controller, self._clock = environment.controller, environment.clock

    def hearing(
        self, axis: int, until: Callable[..., float] | None = None, wraps: Mapping[int, float] | None = None
    ) -> Hearing:
        """Who hears of a reading of an axis; `until` says when it passes the level that it is compared with."""
        attention = self._environment.attention
        if until is None:
            return Hearing(attention, lambda level: attention.note(self.moving), wraps)

        def note(level: float | None) -> None:
            if level != -INFINITY:
                attention.note(until, axis, level)

        return Hearing(attention, note, wraps)

    def comparable(self, read: Callable[[int], float], until: Callable[..., float]) -> Callable[..., float]:
        """A reading of an axis or a channel that may be told what it is compared with."""
        attention = self._environment.attention

        def compared(number: int, level: float | None = None) -> float:
            found = read(number)
            if attention.notes is not None and level != -INFINITY:
                attention.note(until, number, level)
            return found

        return compared

    def moving(self) -> float:
        """What may change while anything moves: an axis, or an encoder that the world turns."""
        controller = self._controller
        still = all(map(controller.is_still, controller.axes)) and not any(
            map(controller.turns, controller.encoders)
        )
        return INFINITY if still else self._clock.now

    def position(self, axis: int, level: float | None) -> float:
        return self._of_axis(self._controller.crossing_time, self._controller.position, axis, level)

    def demand(self, axis: int, level: float | None) -> float:
        return self._of_axis(self._controller.demand_crossing_time, self._controller.demand, axis, level)

    def velocity(self, axis: int, level: float | None) -> float:
        """When the velocity passes a level, or the motion another knot; a simulated motor's may at any time."""
        if level is None or self._controller.has_motor(axis):
            return self._standing(axis)
        return self.demand_velocity(axis, level)

    def demand_velocity(self, axis: int, level: float | None) -> float:
        if level is None:
            return self._standing(axis)
        scale = self._controller.axes[axis].scale
        return self._controller.demand_velocity_crossing_time(axis, scale.to_counts(level, "uu/s"))

    def following_error(self, axis: int, level: float | None) -> float:
        """Where no motor is simulated there is none."""
        return self._standing(axis) if self._controller.has_motor(axis) else INFINITY

    def remaining(self, axis: int, level: float | None) -> float:
        """When so much is still to go."""
        controller = self._controller
        if level is None or level == INFINITY or controller.is_still(axis):
            return self._standing(axis)
        left = controller.axes[axis].scale.to_counts(level, "uu")
        return controller.demand_crossing_time(axis, controller.target(axis) - left)

    def offset(self, axis: int, level: float | None) -> float:
        """When so much is still to go of the offset of a slave, or of the move of another axis."""
        controller = self._controller
        if (
            level is None
            or level == INFINITY
            or controller.is_still(axis)
            or controller.master_of(axis) is None
        ):
            return self.remaining(axis, level)
        from motionlang.controller.motion.offset import crossing_time

        a = controller.axes[axis]
        return crossing_time(controller, a, a.scale.to_counts(level, "uu"))

    def _standing(self, axis: int) -> float:
        return INFINITY if self._controller.is_still(axis) else self._clock.now

    def _of_axis(
        self,
        passing: Callable[[int, float], float],
        place: Callable[[int], float],
        axis: int,
        level: float | None,
    ) -> float:
        """When a position passes a level."""
        if level is None or self._controller.is_still(axis):
            return self._standing(axis)
        scale, wrap = self._controller.axes[axis].scale, self._environment.wraps.get(axis, 0.0)
        if level == INFINITY:
            turns = not wrap and not self._controller.has_motor(axis)
            return self._controller.turning_time(axis) if turns else self._clock.now
        return passing_within(
            wrap,
            scale.position_to_user(place(axis)),
            level,
            lambda place: passing(axis, scale.position_to_counts(place)),
        )


def passing_within(wrap: float, here: float, level: float, passing: Callable[[float], float]) -> float:
    """When what is `here` now passes a level, as `passing` tells; what wraps, also when it begins again."""
    if not wrap:
        return passing(level)
    turn = here // wrap * wrap
    places = [turn + each + offset for each in (-wrap, 0.0, wrap) for offset in (0.0, level % wrap)]
    return min(map(passing, places))
