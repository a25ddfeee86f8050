"""Readers and writers bound to an axis: made once per program, called repeatedly.

A reader returns values in the unit that it was made for. One of a quantity that changes by itself takes a
`Subscriber`. While there is a subscriber, it is notified of each reading, with a function that gives the time at
which the quantity passes the level it is compared with.
"""

from __future__ import annotations

from collections.abc import Callable
from operator import attrgetter
from typing import Any, Protocol

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.readings import Readings
from motionlang.kernel.controller.scale import POWERS, Scale
from motionlang.kernel.controller.settings import LIVE, SETTINGS, configure
from motionlang.kernel.log.records import ChangedSetting
from motionlang.kernel.planners import Profile

Reader = Callable[..., Any]

Writer = Callable[[Any], object]

# The level of a comparison, None if it is unknown; `(distance, centre)` if the distance from the centre is
# compared.
Level = float | tuple[float, float] | None

Until = Callable[..., float]


class DependencySink(Protocol):
    """A subscriber to readings; `notes` is None while it does not subscribe."""

    notes: list[Any] | None

    def note(self, until: Until, *about: Any) -> None:
        """Record a reading that may change at the time `until(*about)`."""


class Subscriber(Protocol):
    """The subscriber to readings."""

    @property
    def dependencies(self) -> DependencySink: ...


# The unit of a position on the axis, which counts from its zero.
POSITION = "place"
# Verbs that give the time at which a reading passes a level, in counts, or has an extremum if that is
# infinite.
_CROSSINGS = {
    "position": "crossing_time",
    "demand": "demand_crossing_time",
    "velocity": "velocity_crossing_time",
    "demand_velocity": "demand_velocity_crossing_time",
    "following_error": "error_crossing_time",
    "remaining": "remaining_crossing_time",
    "offset_remaining": "offset_crossing_time",
}


class _NoSubscriber:
    """The absence of a subscriber."""

    notes: list[Any] | None = None

    def __init__(self) -> None:
        self.dependencies = self

    def note(self, until: Until, *about: Any) -> None:
        """Ignore the reading."""


NO_SUBSCRIBER: Subscriber = _NoSubscriber()


def reader(
    controller: Readings, name: str, axis: int, unit: str = "", subscriber: Subscriber = NO_SUBSCRIBER
) -> Reader:
    """Return the reader of a setting of `SETTINGS` or of an operation that takes an axis.

    Raises KeyError for an axis that does not exist.
    """
    a = controller.axes[axis]
    if name in SETTINGS:
        return setting(attrgetter(name), a, unit)
    until = passing(controller, name, a, unit)
    written_out = _WRITTEN_OUT.get((name, unit))
    if written_out is not None:
        return written_out(controller, a, subscriber, until)
    operation = getattr(controller, name)
    return converted(lambda: operation(axis), a.scale, unit, subscriber, until)


def passing(controller: Readings, name: str, a: Axis, unit: str) -> Until:
    """Return a function for the time at which a reading passes a level, in its unit.

    If the reading is not compared (level None), it may change at once as long as the axis moves.
    """
    clock, scale, axis = controller.clock, a.scale, a.index
    crossing_time = getattr(controller, _CROSSINGS[name]) if name in _CROSSINGS else None
    is_position = unit == POSITION
    to_counts = scale.position_to_counts if is_position else lambda level: scale.to_counts(level, unit)

    def until(level: float | None = None) -> float:
        if controller.is_still(axis):
            return INFINITY
        if crossing_time is None or level is None:
            return clock.now
        if not (is_position and scale.wrap):
            return crossing_time(axis, to_counts(level))  # type: ignore[no-any-return]
        here = scale.position_to_user(getattr(controller, name)(axis))
        return passing_within(
            scale.wrap, here, level, lambda position: crossing_time(axis, to_counts(position))
        )

    return until


def passing_within(wrap: float | None, here: float, level: float, passing: Callable[[float], float]) -> float:
    """Return when a quantity, now `here`, passes a level; `passing` solves one level.

    A quantity that wraps also passes the level by wrapping. No quantity passes an infinite level.
    """
    if abs(level) == INFINITY:
        return INFINITY
    if not wrap:
        return passing(level)
    base = here // wrap * wrap
    levels = [base + each + offset for each in (-wrap, 0.0, wrap) for offset in (0.0, level % wrap)]
    return min(map(passing, levels))


def setting(get: Callable[[Any], Any], of: object, unit: str) -> Reader:
    """Return a reader of an attribute of `of`, converted to `unit` if one is given."""
    power = POWERS.get(unit)
    if power is None:
        return (lambda: float(get(of))) if unit else lambda: get(of)
    factors: list[tuple[float, float]] = of.scale.factors  # type: ignore[attr-defined]

    def read() -> float:
        rate, per_unit = factors[power]
        return float(get(of)) * rate / per_unit

    return read


def converted(
    read: Callable[[], Any], scale: Scale, unit: str, subscriber: Subscriber, until: Until = float
) -> Reader:
    """Return a reader that converts to `unit`, if one is given."""
    if not unit and subscriber is NO_SUBSCRIBER:
        return read
    power, factors = POWERS.get(unit), scale.factors
    dependencies, note = subscriber.dependencies, subscriber.dependencies.note

    def read_and_record(level: Level = None) -> Any:
        if dependencies.notes is not None:
            note(until, level)
        if power is None:
            return float(read()) if unit else read()
        rate, per_unit = factors[power]
        return float(read()) * rate / per_unit

    return read_and_record


def writer(a: Axis, name: str, unit: str = "") -> Writer:
    """Return a writer of one of `SETTINGS`, bound to an axis and a unit."""
    clock, axis, add = a.clock, a.index, a.controller.log.settings.add
    live, time = name in LIVE, f"{name}_time" if name in ("accel", "decel") else ""
    power, factors = POWERS.get(unit), a.scale.factors

    def write(value: Any) -> None:
        if power is not None:
            rate, per_unit = factors[power]
            value = value * per_unit / rate
        if (live and a.is_moving) or not value:
            configure(a, name, value)
            return
        if getattr(a, name) != value:
            add(ChangedSetting(clock.now, axis, name, value))
        setattr(a, name, value)
        if time:
            setattr(a, time, None)

    return write


def _position(
    controller: Readings, a: Axis, subscriber: Subscriber, until_passed: Until, actual: bool = True
) -> Reader:
    """Return the reader of the position.

    It caches the present piece of the profile, because polling loops read little else.
    """
    clock, scale = controller.clock, a.scale
    dependencies = subscriber.dependencies
    note = dependencies.note
    begun = since = c0 = c1 = c2 = c3 = 0.0
    still, until = False, -1.0
    profile: Profile | None = None

    def read(level: Level = None) -> float:
        nonlocal begun, since, until, profile, still, c0, c1, c2, c3
        if dependencies.notes is not None:
            note(until_passed, level)
        if actual and a.feedback is not None:
            found = a.feedback.position
        else:
            time = clock.now - begun
            if since < time < until and a.present is profile:
                if still:
                    found = c0
                else:
                    x = time - since
                    found = ((c3 * x + c2) * x + c1) * x + c0
            else:
                profile, begun, since, until, (c0, c1, c2, c3) = _piece(a, clock.now)
                x = clock.now - begun - since
                found = (
                    ((c3 * x + c2) * x + c1) * x + c0 if x > 0.0 and until > 0.0 else a.position(clock.now)
                )
                still = c1 == c2 == c3 == 0.0
                c0 += 0.0  # no minus zero, as a sum with the other terms gives none
        found = (found - scale.zero) / scale.counts
        return found % scale.wrap if scale.wrap else found

    return read


def _velocity(
    controller: Readings, a: Axis, subscriber: Subscriber, until_passed: Until, actual: bool = True
) -> Reader:
    """Return the reader of the velocity; it caches the present piece of the profile."""
    clock, factors = controller.clock, a.scale.factors
    dependencies, note = subscriber.dependencies, subscriber.dependencies.note
    begun = since = c1 = twice_c2 = thrice_c3 = 0.0
    until = -1.0
    profile: Profile | None = None

    def read(level: Level = None) -> float:
        nonlocal begun, since, until, profile, c1, twice_c2, thrice_c3
        if dependencies.notes is not None:
            note(until_passed, level)
        if actual and a.feedback is not None:
            found = a.feedback.velocity
        else:
            time = clock.now - begun
            if since < time < until and a.present is profile:
                x = time - since
                found = (thrice_c3 * x + twice_c2) * x + c1 if twice_c2 or thrice_c3 else c1
            else:
                profile, begun, since, until, (_, c1, c2, c3) = _piece(a, clock.now)
                twice_c2, thrice_c3 = 2.0 * c2, 3.0 * c3
                x = clock.now - begun - since
                if x > 0.0 and until > 0.0:
                    found = (thrice_c3 * x + twice_c2) * x + c1 if twice_c2 or thrice_c3 else c1
                else:
                    found = a.velocity(clock.now)
        rate, per_unit = factors[1]
        return found * rate / per_unit

    return read


def _piece(a: Axis, now: float) -> tuple[Profile, float, float, float, tuple[float, ...]]:
    """Return the profile, its start time, and its present cubic with its interval.

    The interval is in s after the start. It is empty if the profile has no cubic there.
    """
    profile, begun = a.profiles[-1], a.starts[-1]
    return profile, begun, *(profile.cubic(now - begun) or (0.0, -1.0, (0.0, 0.0, 0.0, 0.0)))


def _is_idle(controller: Readings, a: Axis, subscriber: Subscriber, until_passed: Until) -> Reader:
    return a.idle_reader()


_WRITTEN_OUT: dict[tuple[str, str], Callable[..., Reader]] = {
    ("position", POSITION): _position,
    ("demand", POSITION): lambda controller, a, subscriber, until: _position(
        controller, a, subscriber, until, False
    ),
    ("velocity", "uu/s"): _velocity,
    ("demand_velocity", "uu/s"): lambda controller, a, subscriber, until: _velocity(
        controller, a, subscriber, until, False
    ),
    ("is_idle", ""): _is_idle,
}
