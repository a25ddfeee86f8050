"""HTA: an axis that moves to hold an analogue input at a value (MN1270 p. 87-91).

Velocity = HTAKPROP × error + HTADAMPING × change of the error + HTAKINT × sum of the errors, once per tick of
the profiler. The error is the wanted minus the measured value in percent, and 0 within HTADEADBAND, which
is in counts of the converter. The sum is reset to 0 within the dead band and by a write to HTAKINT.
"""

from __future__ import annotations

from motionlang.kernel.controller.faults import fault_names
from motionlang.kernel.controller.motion.sampled_velocity import SampledVelocity
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.io_outputs import HIGHEST, Analogue, analogue_input
from motionlang.kernel.mint.runtime.binding import of
from motionlang.kernel.mint.runtime.environment import Environment

# Steps of the converter over the range of an input, which is -100 to 100 percent or 0 to 100 percent.
COUNTS = 4096.0


class Hold:
    """An axis that holds an input: its wanted value in percent, and the loop state."""

    track: SampledVelocity

    def __init__(self, holds: Holds, axis: int, wanted: float) -> None:
        self.holds, self.axis, self.wanted = holds, axis, wanted
        self.before: float | None = None
        self.filtered: float | None = None
        self.total = 0.0

    def decide(self) -> tuple[float, bool]:
        """Compute the velocity for the next period, in counts/s.

        Also returns True if the velocity may still change although the input does not.
        """
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
        channel, inputs = int(setting("HTACHANNEL", axis)), self.holds.environment.component(Analogue)
        measured = inputs.read(channel)
        share = setting("HTAFILTER", axis)
        before = measured if self.filtered is None else self.filtered
        self.filtered = share * before + (1.0 - share) * measured
        error = self.wanted - self.filtered
        lively = abs(self.filtered - measured) > 1e-6
        deadband = setting("HTADEADBAND", axis) * 2.0 * HIGHEST / COUNTS
        return (0.0 if abs(error) <= deadband else error), lively


class Holds(StoredSettings):
    """The settings of HTA, by keyword and axis, and the axes that hold an input."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self._holding: dict[int, Hold] = {}
        environment.controller.analogue_inputs.listen(self._changed)

    def set(self, name: str, axis: int, value: float) -> None:
        """Write a setting; an axis that holds an input uses it at once.

        A new HTAKINT clears the sum of errors.
        """
        if name == "HTACHANNEL":
            analogue_input(int(value))
        super().set(name, axis, value)
        hold = self.holding(axis)
        if hold is not None:
            if name == "HTAKINT":
                hold.total = 0.0
            hold.track.wake()

    def holding(self, axis: int) -> Hold | None:
        """Return the hold that is active on an axis, None if there is none."""
        hold = self._holding.get(axis)
        return hold if hold is not None and hold.track.holds else None

    def wanted(self, axis: int) -> float:
        """Return the value in percent that an axis holds or last held, initially 0."""
        hold = self._holding.get(axis)
        return hold.wanted if hold is not None else 0.0

    def start(self, axis: int, wanted: float, line: int) -> None:
        """Make an idle axis hold the input at a value in percent.

        An axis that already holds continues with the new value. Raises Rejected if the axis has an error.
        """
        hold = self.holding(axis)
        if hold is not None:
            hold.wanted = wanted
            hold.track.wake()
            return
        faults = self.environment.controller.faults(axis)
        if faults:
            raise Rejected(
                "axis-error", f"axis {axis} has an error: {fault_names(faults)}", "clear the error before HTA"
            )
        hold = Hold(self, axis, wanted)
        hold.track = self.environment.controller.track(axis, hold.decide, "HTA", line)
        self._holding[axis] = hold

    def _changed(self, channel: int, value: float) -> None:
        for axis in list(self._holding):
            hold = self.holding(axis)
            if hold is not None and self.setting("HTACHANNEL", axis) == channel:
                hold.track.wake()


# ------------------------------------------------------------------------------------------------- keywords

HOLD = Actions(read=of(Holds, Holds.wanted), write=of(Holds, Holds.start))
_SETTING = Actions(read=setting_reader(Holds), write=setting_writer(Holds))

_MAX_VALUE = 8388607.0


def _setting(name: str, unit: str, help: str, low: float, high: float, default: float = 0.0,
             short: str = "", selects: str = "") -> Keyword:  # fmt: skip
    example = f"{name}(0) = 0\nPRINT {name}(0)"
    return Keyword(name, short, "setting", "RW", "axis", unit, _SETTING, help, example,
                   default=default, low=low, high=high, group="axis", selects=selects)  # fmt: skip


def _gain(name: str, help: str, short: str = "") -> Keyword:
    return _setting(name, "number", help, -_MAX_VALUE, _MAX_VALUE, short=short)


ROWS = (
    Keyword("HTA", "", "setting", "RW", "axis", "%", HOLD,
            "Hold to analogue: move the axis so that the analogue input HTACHANNEL comes to this value, percent, and "
            "keeps it, at SPEED at most, until STOP or CANCEL. The axis must be idle and without error; while it holds "
            "it takes a further HTA and no other motion. No GO is needed. It reads the value that is held, or was "
            "last.",
            "HTACHANNEL(0) = 1 : HTAKPROP(0) = 2\nHTA(0) = 25\nWAIT = 200\nPRINT VEL(0)\nSTOP(0)",
            default=0.0, low=-100.0, high=100.0, group="motion", effect="act"),
    _setting("HTACHANNEL", "integer", "The analogue input that HTA holds.", 0, 63, selects="analogue input"),
    _gain("HTAKPROP", "User units a second for each percent of error (wanted minus measured); negative to "
                      "reverse the direction.", "HKP"),
    _gain("HTADAMPING", "User units a second for each percent by which the error changes in a tick of the profiler."),
    _gain("HTAKINT", "User units a second for each percent of the sum of the errors of all ticks; the sum restarts "
            "within HTADEADBAND and when this is written."),
    _setting("HTADEADBAND", "number", "The largest error that counts as none, counts of a 12-bit converter.", 0, 100,
             short="HDB"),
    _setting("HTAFILTER", "number", "Weight of the previous filtered value in the next one, 0 to 1: "
                                    "0 does not filter.", 0, 0.9999),
)  # fmt: skip
