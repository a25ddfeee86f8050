"""Waiting for a condition without polling: at the solved moment, at events, or at the profiler's ticks."""

from __future__ import annotations

from motionlang.lang.task import Wait
from motionlang.mint.runtime.environment import INFINITY, TICK

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from motionlang.mint.runtime.environment import Environment

    Watches = tuple[tuple[Any, ...], ...]

# How far past a solved moment a condition is looked at: `POS > 50` is false at the very moment of 50.
_AFTER = (0.0, 1e-12, 1e-10, 1e-8)


def watch(
    environment: Environment, t: float, ready: Callable[[], object], watches: Watches, why: str
) -> Wait:
    """Wait until `ready`; `watches` tell when it may become true while nothing else happens.

    A watch is `("position" | "demand" | "remaining", axis, level)`, `("time", base, level)` (None: the task's TIME),
    `("motion",)` for what changes while an axis moves, and is looked at every tick, or `("tick",)`; axis, base and
    level are functions, as they may change while the program waits. For a loop, which looks more often than that, there
    are `("moving",)` and `("always",)`.
    """
    waiting = _Waiting(environment, ready, watches)
    return Wait(t, waiting.ready, waiting.due, why)


def next_change(environment: Environment, since: float, watches: Watches) -> float:
    """The first moment after `since` at which one of `watches` changes, nothing else happening."""
    waiting, clock = _Waiting(environment, bool, watches), environment.clock
    now, clock.now = clock.now, since
    try:
        return min((waiting.moment(*each) for each in watches), default=INFINITY)
    finally:
        clock.now = now


class _Waiting:
    """A condition and the moment for which it was last solved."""

    def __init__(self, environment: Environment, condition: Callable[[], object], watches: Watches) -> None:
        self.environment, self.condition, self.watches = environment, condition, watches
        self.solved = -1.0
        self.task = environment.task

    def ready(self) -> bool:
        """Whether the condition is true now, or from this very moment on."""
        self.environment.task = self.task  # whose TIME the condition may read
        clock = self.environment.clock
        now = clock.now
        if now != self.solved:
            return bool(self.condition())
        try:
            for after in _AFTER:
                clock.now = now + after * max(1.0, now)
                if self.condition():
                    return True
        finally:
            clock.now = now
        return False

    def due(self) -> float:
        """The next moment at which the condition may change by itself."""
        self.environment.task = self.task
        clock = self.environment.clock
        now = clock.now
        if now == self.solved:
            clock.now = now + 1e-7 * max(1.0, now)  # past what was just looked at
        try:
            moment = min((self.moment(*each) for each in self.watches), default=INFINITY)
        finally:
            clock.now = now
        if moment <= now:
            moment = now + TICK
        self.solved = moment
        return moment

    def moment(
        self, kind: str, axis: Callable[[], float] | None = None, level: Callable[[], float] | None = None
    ) -> float:
        """The next moment at which one watch changes."""
        controller = self.environment.controller
        now = self.environment.clock.now
        if kind == "tick":
            return _next_tick(now)
        if kind == "always":
            return now
        if kind in ("motion", "moving"):
            if all(map(controller.is_still, controller.axes)):
                return INFINITY
            return _next_tick(now) if kind == "motion" else now
        assert level is not None
        if kind == "time":
            return _counted(now, self.task.timer[0] if axis is None else axis(), level())
        assert axis is not None
        return self._crossing(kind, int(axis()), level())

    def _crossing(self, kind: str, axis: int, level_uu: float) -> float:
        controller = self.environment.controller
        if axis not in controller.axes or controller.is_still(axis):
            return INFINITY  # a refusal, if there is to be one, comes from the condition itself
        scale = controller.axes[axis].scale
        if kind in ("position", "demand"):
            wrap = self.environment.wraps.get(axis)
            if wrap:
                return self._wrapped_crossing(kind, axis, level_uu, wrap)
            return self._passing(kind, axis)(axis, scale.position_to_counts(level_uu))
        if kind == "following.offset" and controller.master_of(axis) is not None:
            from motionlang.controller.motion.offset import crossing_time

            return crossing_time(controller, controller.axes[axis], scale.to_counts(level_uu, "uu"))
        return controller.demand_crossing_time(
            axis, controller.target(axis) - scale.to_counts(level_uu, "uu")
        )

    def _passing(self, kind: str, axis: int) -> Callable[[int, float], float]:
        controller = self.environment.controller
        return controller.crossing_time if kind == "position" else controller.demand_crossing_time

    def _wrapped_crossing(self, kind: str, axis: int, level_uu: float, wrap: float) -> float:
        """The next moment at which a wrapped position passes a level, or begins again."""
        controller = self.environment.controller
        scale, passing = controller.axes[axis].scale, self._passing(kind, axis)
        here = controller.position(axis) if kind == "position" else controller.demand(axis)
        turn = scale.position_to_user(here) // wrap * wrap
        places = [turn + each + offset for each in (-wrap, 0.0, wrap) for offset in (0.0, level_uu % wrap)]
        return min(passing(axis, scale.position_to_counts(place)) for place in places)


def _next_tick(now: float) -> float:
    return (int(now / TICK + 1e-6) + 1) * TICK


def _counted(now: float, base: float, level: float) -> float:
    """When TIME next passes `level`: it reaches it, and a millisecond later it is beyond it."""
    for milliseconds in (level, level + 1.0):
        moment = base + milliseconds / 1000.0
        if moment > now:
            return moment
    return INFINITY
