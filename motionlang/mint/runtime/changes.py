"""When what a Mint program has read changes by itself: with motion, as time is counted, or as it passes a level."""

from __future__ import annotations

from motionlang.controller.readers import PLACE, Hearing
from motionlang.lang.task import INFINITY

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from typing import Any

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Maker = Callable[[Environment, Row], Callable[..., Any]]
    # What a reading is compared with; `(level,)` where its sign is taken off, None where it is not known.
    Level = float | tuple[float] | None
    Until = Callable[..., float]

# What tells when a reading of an axis passes a level, or turns round where that is infinite, and the level's unit.
CROSSINGS: dict[str, tuple[str, str]] = {
    "position": ("crossing_time", PLACE),
    "demand": ("demand_crossing_time", PLACE),
    "velocity": ("velocity_crossing_time", "uu/s"),
    "demand_velocity": ("demand_velocity_crossing_time", "uu/s"),
    "following_error": ("error_crossing_time", "uu"),
    "remaining": ("remaining_crossing_time", "uu"),
    "following.offset": ("offset_crossing_time", "uu"),
}
# What is kept of such a reading decides nothing.
NOBODY_ASKS = (-INFINITY,)


def moving(make: Maker) -> Maker:
    """A reading that may change for as long as an axis moves; `make` makes the function that reads."""
    return lambda environment, row: (changes := environment.part(Changes)).heard(
        make(environment, row), changes.moving
    )


def always(make: Maker) -> Maker:
    """A reading that changes all the time."""
    return lambda environment, row: (changes := environment.part(Changes)).heard(
        make(environment, row), changes.at_once
    )


def repeatable(make: Maker) -> Maker:
    """A writing that does nothing where it writes what is there already, as reading the word tells."""
    make.repeatable = True  # type: ignore[attr-defined]
    return make


class Changes:
    """The moments, from the clock's on, at which readings change.

    A reading that is compared with nothing, level None, changes for as long as something moves. One that is more than
    ever before, INFINITY, is so until it turns round, and no second time where it stands. -INFINITY: nobody asks.
    """

    def __init__(self, environment: Environment) -> None:
        self._environment = environment

    def hearing(self, number: int, until: Until, wraps: Mapping[int, float] | None = None) -> Hearing:
        """Who hears of a reading of an axis or a channel; `until` says when it passes what it is compared with."""
        attention = self._environment.attention

        def note(level: Level) -> None:
            if level != -INFINITY:
                attention.note(until, number, level)

        return Hearing(attention, note, wraps)

    def heard(self, read: Callable[..., Any], until: Callable[..., float]) -> Callable[..., Any]:
        """A reading bound to none of them: it and `until` are given where it is made and what it is compared with."""
        attention = self._environment.attention

        def heard(*where: Any) -> Any:
            if attention.notes is not None and where[-1:] != NOBODY_ASKS:
                attention.note(until, *where)
            return read(*where)

        return heard

    def at_once(self, *where: Any) -> float:
        """What may change at any time."""
        return self._environment.clock.now

    def moving(self, *where: Any) -> float:
        """What may change while anything moves: an axis, or an encoder that the world turns."""
        controller = self._environment.controller
        still = all(map(controller.is_still, controller.axes)) and not any(
            map(controller.turns, controller.encoders)
        )
        return INFINITY if still else self.at_once()

    def passing(self, verb: str) -> Until:
        """What tells when a reading of an axis passes a level, in user units; nothing changes of one that stands."""
        controller, wraps = self._environment.controller, self._environment.wraps
        if verb not in CROSSINGS:
            return self.moving
        name, unit = CROSSINGS[verb]
        crossing_time = getattr(controller, name)

        def until(axis: int, level: Level = None) -> float:
            wrap = wraps.get(axis) if unit == PLACE else None
            if controller.is_still(axis):
                return self.at_once() if level == INFINITY else INFINITY
            if level is None or (wrap and level == INFINITY):
                return self.at_once()
            if isinstance(level, tuple):
                return min(until(axis, level[0]), until(axis, -level[0]))
            scale = controller.axes[axis].scale
            if unit != PLACE:
                return float(crossing_time(axis, scale.to_counts(level, unit)))
            here = scale.position_to_user(getattr(controller, verb)(axis)) if wrap else 0.0
            return passing_within(
                wrap, here, level, lambda place: crossing_time(axis, scale.position_to_counts(place))
            )

        return until


def passing_within(wrap: float | None, here: float, level: float, passing: Callable[[float], float]) -> float:
    """When what is `here` now passes a level, as `passing` tells; what wraps, also when it begins again."""
    if not wrap:
        return passing(level)
    turn = here // wrap * wrap
    places = [turn + each + offset for each in (-wrap, 0.0, wrap) for offset in (0.0, level % wrap)]
    return min(map(passing, places))
