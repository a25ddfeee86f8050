"""A sensor whose analogue value depends on the position of an axis.

Examples are a force, a distance, the tension of a web. The sensor is sampled when a profile begins or ends, and
at every tick of the profiler while the axis moves.

The motion is known in advance, so the ticks need not be events. A sample is computed when it is read, and the
samples of a profile are logged when it is over or the log is read (these sensors are in
`AnalogueInputs.computed`). Programs that compare a sample with a level get the tick at which it passes the level
from `until`. The ticks are events only if listeners must be notified of each sample, the language does not
record dependencies, or the axis has a simulated motor.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.clock import Event
    from motionlang.controller.controller import Controller
    from motionlang.planners import Profile

# The period of the profiler, seconds.
PERIOD = 1e-3


def next_tick(now: float) -> float:
    """Return the next tick of the profiler; all functions run at ticks share it."""
    return (int(now / PERIOD + 1e-6) + 1) * PERIOD


class Sensor:
    """A sensor on an axis that puts its value on a channel while it is active.

    The value is `value` plus `per_unit` for each user unit beyond `origin`, a machine position.
    """

    __slots__ = ("_controller", "_event", "active", "axis", "origin", "per_unit", "put", "value")

    def __init__(
        self,
        controller: Controller,
        axis: int,
        origin: float,
        value: float,
        per_unit: float,
        put: Callable[[float], None],
    ) -> None:
        self._controller, self.axis = controller, axis
        self.origin, self.value, self.per_unit, self.put = origin, value, per_unit, put
        self.active = False
        self._event: Event | None = None
        controller.axes[axis].followers.append(self._moved)

    def switch(self, active: bool) -> None:
        """Activate or deactivate the sensor as the axis enters or leaves its region."""
        self.active = active
        if active:
            self._sample()
        else:
            self._cancel()
            self.put(0.0)

    def _moved(self, profile: Profile) -> None:
        if self.active:
            self._sample()

    def _sample(self) -> None:
        self._cancel()
        controller, a = self._controller, self._controller.axes[self.axis]
        place = a.scale.to_user(controller.position(self.axis) - a.datum)
        self.put(self.value + self.per_unit * (place - self.origin))
        if not controller.is_still(self.axis):
            self._event = controller.clock.at(next_tick(controller.clock.now), self._sample)

    def _cancel(self) -> None:
        if self._event is not None:
            self._event.cancel()
            self._event = None
