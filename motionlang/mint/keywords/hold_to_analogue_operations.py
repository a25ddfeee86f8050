"""HTA: an axis that is moved so that an analogue input holds its value (MN1270 p. 87 to 91).

Velocity = HTAKPROP error + HTADAMPING change of the error + HTAKINT sum of the errors, once a tick of the profiler; the
error is the value that is wanted minus the one that is measured, percent, and 0 within HTADEADBAND, which is in counts
of the converter. The sum begins anew there and when HTAKINT is written.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal, names
from motionlang.mint.keywords.axis_settings import Settings, reading, writing
from motionlang.mint.keywords.io_outputs import Analogue, analogue_input
from motionlang.mint.runtime.binding import of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.motion.sampled_velocity import Track
    from motionlang.mint.runtime.environment import Environment

# Steps of the converter over the range of an input, -100 to 100 percent or 0 to 100.
COUNTS = 4096.0


class Hold:
    """One axis that holds an input: what is wanted, percent, and what its law remembers."""

    __slots__ = ("axis", "before", "filtered", "holds", "total", "track", "wanted")

    track: Track

    def __init__(self, holds: Holds, axis: int, wanted: float) -> None:
        self.holds, self.axis, self.wanted = holds, axis, wanted
        self.before: float | None = None
        self.filtered: float | None = None
        self.total = 0.0

    def decide(self) -> tuple[float, bool]:
        """The velocity for the next period, counts/s, and whether it may yet change while the input stays."""
        setting, axis = self.holds.setting, self.axis
        error, lively = self._error()
        if not error:
            self.total = 0.0
        change = error - self.before if self.before is not None else 0.0
        self.before = error
        self.total += error
        speed = setting("HTAKPROP", axis) * error + setting("HTADAMPING", axis) * change
        speed += setting("HTAKINT", axis) * self.total
        a = self.holds.environment.controller.axes[axis]
        velocity = a.scale.to_counts(speed, "uu/s")
        return max(-a.speed, min(velocity, a.speed)), lively or bool(change or error)

    def _error(self) -> tuple[float, bool]:
        setting, axis = self.holds.setting, self.axis
        channel, inputs = int(setting("HTACHANNEL", axis)), self.holds.environment.part(Analogue)
        measured = inputs.read(channel)
        share = setting("HTAFILTER", axis)
        before = measured if self.filtered is None else self.filtered
        self.filtered = share * before + (1.0 - share) * measured
        error = self.wanted - self.filtered
        lively = abs(self.filtered - measured) > 1e-6
        lowest, highest = inputs.range(channel)
        deadband = setting("HTADEADBAND", axis) * (highest - lowest) / COUNTS
        return (0.0 if abs(error) <= deadband else error), lively


class Holds(Settings):
    """The settings of holding, by keyword and axis, and the axes that hold."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self._holding: dict[int, Hold] = {}
        environment.controller.analogue_inputs.listeners.append(self._changed)

    def set(self, name: str, axis: int, value: float) -> None:
        """Write a setting; an axis that holds goes by it at once, and a new HTAKINT begins a new sum."""
        if name == "HTACHANNEL":
            analogue_input(int(value))
        super().set(name, axis, value)
        hold = self.holding(axis)
        if hold is not None:
            if name == "HTAKINT":
                hold.total = 0.0
            hold.track.wake()

    def holding(self, axis: int) -> Hold | None:
        """What holds an axis now."""
        hold = self._holding.get(axis)
        return hold if hold is not None and hold.track.holds else None

    def wanted(self, axis: int) -> float:
        """The value that an axis holds, percent, or held last; 0 before it held any."""
        hold = self._holding.get(axis)
        return hold.wanted if hold is not None else 0.0

    def start(self, axis: int, wanted: float, line: int) -> None:
        """Let an axis that is idle and without error hold a value, percent; one that holds already goes on with it."""
        hold = self.holding(axis)
        if hold is not None:
            hold.wanted = wanted
            hold.track.wake()
            return
        faults = self.environment.controller.faults(axis)
        if faults:
            raise Refusal(
                "axis-error", f"axis {axis} has an error: {names(faults)}", "clear the error before HTA"
            )
        hold = Hold(self, axis, wanted)
        hold.track = self.environment.controller.track(axis, hold.decide, "HTA", line)
        self._holding[axis] = hold

    def _changed(self, channel: int, value: float) -> None:
        for axis in list(self._holding):
            hold = self.holding(axis)
            if hold is not None and self.setting("HTACHANNEL", axis) == channel:
                hold.track.wake()


OPERATIONS = {
    "hold_to_analogue.hold": {"read": of(Holds, Holds.wanted), "write": of(Holds, Holds.start)},
    "hold_to_analogue.setting": {"read": reading(Holds), "write": writing(Holds)},
}
