"""Digital inputs with a function for an axis.

The functions are limit, error, stop, suspend, reset and home. An assignment is a channel, or -1 for none. The
function is carried out exactly when the state of the input changes.
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.controller.axis import BY_INPUT
from motionlang.kernel.controller.faults import ERROR_INPUT, LIMIT_FORWARD, LIMIT_REVERSE
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.io_inputs import Inputs
from motionlang.kernel.mint.keywords.limits import ACTIONS, AxisErrors, switch_row
from motionlang.kernel.mint.keywords.limits_resetting import AT_ERROR_DECEL, CRASH, StopModes, reset, stop
from motionlang.kernel.mint.runtime.binding import of, of_word
from motionlang.kernel.mint.runtime.environment import Environment

NONE = -1


class SwitchInputs(StoredSettings):
    """The inputs assigned to axes, by keyword and axis."""

    otherwise = NONE

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self._inputs = environment.component(Inputs)
        self._errors = environment.component(AxisErrors)
        self._inputs.listeners.append(self._changed)

    def channel(self, name: str, axis: int) -> int:
        return int(self.setting(name, axis))

    def is_on(self, name: str, axis: int) -> bool:
        """True if the assigned input is active; False if none is assigned."""
        channel = self.channel(name, axis)
        return channel != NONE and self._inputs.is_on(channel)

    def set(self, name: str, axis: int, value: float) -> None:
        """Assign an input; if the input is already active, its function starts at once."""
        with self.controller.reads.replaced():  # it is the controller that reads here
            before = self.is_on(name, axis)
            super().set(name, axis, value)
            has_changed = self.is_on(name, axis) is not before
        if has_changed:
            _MEANINGS[name](self, axis, not before)

    def default(self, axis: int) -> None:
        """Remove all assignments of the axis (DEFAULT)."""
        for name, each in list(self._settings):
            if each == axis:
                self.set(name, axis, NONE)

    def _changed(self, channel: int, on: bool) -> None:
        for (name, axis), assigned in tuple(self._settings.items()):
            if assigned == channel:
                _MEANINGS[name](self, axis, on)

    # -------------------------------------------------------------------------------------------- meanings

    def _forward(self, axis: int, on: bool) -> None:
        self._errors.limit(axis, LIMIT_FORWARD).set_active(on)

    def _reverse(self, axis: int, on: bool) -> None:
        self._errors.limit(axis, LIMIT_REVERSE).set_active(on)

    def _error(self, axis: int, on: bool) -> None:
        self._errors.set_input(axis, ERROR_INPUT, on)

    def _stop(self, axis: int, on: bool) -> None:
        if not on:
            return
        action = ACTIONS[int(self.environment.component(StopModes).setting("STOPINPUTMODE", axis))]
        if action in ("abort", "error-stop"):
            stop(self.environment, axis, CRASH if action == "abort" else AT_ERROR_DECEL)
        self.environment.events.raise_("stop")

    def _suspend(self, axis: int, on: bool) -> None:
        (self.controller.suspend if on else self.controller.resume)(axis, BY_INPUT)

    def _reset(self, axis: int, on: bool) -> None:
        if on:
            reset(self.environment, axis)

    def _home(self, axis: int, on: bool) -> None:
        if self.environment.machine.settings.get(f"axis.{axis}.home_switch") is None:
            self.controller.set_home_switch(axis, on)


_MEANINGS: dict[str, Callable[[SwitchInputs, int, bool], None]] = {
    "LIMITFORWARDINPUT": SwitchInputs._forward,
    "LIMITREVERSEINPUT": SwitchInputs._reverse,
    "ERRORINPUT": SwitchInputs._error,
    "STOPINPUT": SwitchInputs._stop,
    "SUSPENDINPUT": SwitchInputs._suspend,
    "RESETINPUT": SwitchInputs._reset,
    "HOMEINPUT": SwitchInputs._home,
}
# The assignment whose input each of these keywords shows.
SHOWN = {"ERRORSWITCH": "ERRORINPUT", "STOPSWITCH": "STOPINPUT", "SUSPENDSWITCH": "SUSPENDINPUT"}


# ------------------------------------------------------------------------------------------------- keywords

SWITCH_INPUT = Actions(read=setting_reader(SwitchInputs), write=setting_writer(SwitchInputs))
_SWITCH = Actions(
    read=of_word(SwitchInputs, lambda switches, row, axis: int(switches.is_on(SHOWN[row.name], axis)))
)
HOME_SWITCH = Actions(read=of(Environment, lambda e, axis: int(e.controller.is_on_home_switch(axis))))


def _input(name: str, short: str, help: str) -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", "integer", SWITCH_INPUT, f"{help}; -1 for none.",
                   f"{name}(0) = 3\nPRINT {name}(0)", default=-1.0, low=-1, high=999, group="limits",
                   selects="input")  # fmt: skip


ROWS = (
    _input("LIMITFORWARDINPUT", "lfi", "The input that is the forward limit switch of the axis"),
    _input("LIMITREVERSEINPUT", "lri", "The input that is the reverse limit switch of the axis"),
    _input("ERRORINPUT", "ei", "The input that reports an error of the axis"),
    switch_row("ERRORSWITCH", "es", _SWITCH, "1 while the error input of the axis is active."),
    _input("STOPINPUT", "", "The input that stops the axis"),
    switch_row("STOPSWITCH", "", _SWITCH, "1 while the stop input of the axis is active."),
    _input("SUSPENDINPUT", "", "The input that suspends the axis for as long as it is active"),
    switch_row("SUSPENDSWITCH", "", _SWITCH, "1 while the suspend input of the axis is active."),
    _input("RESETINPUT", "rsi", "The input that resets the axis when it becomes active"),
)  # fmt: skip
# The event sources of each kind, created for programs that handle these events.
SOURCES = {"stop": SwitchInputs}
