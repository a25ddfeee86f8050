"""Buffer entries that move nothing: dwells, and changes of outputs."""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.controller.queue.life import run_profile
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners.dwell import rest


class Dwell(Action):
    """A rest of `duration` seconds."""

    __slots__ = ("duration",)

    def __init__(self, duration: float) -> None:
        if not 0.0 <= duration < 1e300:
            raise Rejected("range", f"an axis cannot dwell for {duration:.10g} seconds")
        self.duration = duration

    def begin(self, a: Axis, move: LoggedMove) -> None:
        here = a.position(a.clock.now)
        move.target = here
        run_profile(a, move, rest("dwell", here, self.duration))


class Outputs(Action):
    """A change of digital outputs, which takes no time."""

    __slots__ = ("values",)
    is_instant = True

    def __init__(self, values: dict[int, float]) -> None:
        self.values = values

    def begin(self, a: Axis, move: LoggedMove) -> None:
        for channel, value in self.values.items():
            a.controller.outputs[channel] = value


class Pulse(Action):
    """A digital output turned on for `duration` seconds; another pulse prolongs it."""

    __slots__ = ("channel", "duration")
    is_instant = True

    def __init__(self, channel: int, duration: float) -> None:
        if not 0.0 <= duration < 1e300:
            raise Rejected("range", f"a pulse cannot last {duration:.10g} seconds")
        self.channel, self.duration = channel, duration

    def begin(self, a: Axis, move: LoggedMove) -> None:
        a.controller.pulse(self.channel, self.duration)
