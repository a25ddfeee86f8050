"""Digital inputs that are given a meaning for an axis: limits, error, stop, suspend, reset, home.

An assignment is a channel, -1 for none. What an input means happens when its state changes, at that very moment.
"""

from __future__ import annotations

from motionlang.controller.faults import ERROR_INPUT, LIMIT_FORWARD, LIMIT_REVERSE
from motionlang.controller.triggers.conditions import BY_INPUT
from motionlang.mint.keywords.axis_settings import writing
from motionlang.mint.keywords.defaults import STOP_INPUT_MODE
from motionlang.mint.keywords.io_inputs import Inputs
from motionlang.mint.keywords.limits_operations import ACTIONS, AxisErrors
from motionlang.mint.keywords.limits_resetting import AT_ERROR_DECEL, CRASH, reset, stop
from motionlang.mint.runtime.binding import axis_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

NONE = -1


class Switches:
    """The inputs assigned to axes, by keyword and axis."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._inputs = environment.part(Inputs)
        self._errors = environment.part(AxisErrors)
        self._channels: dict[tuple[str, int], int] = {}
        self.stop_modes: dict[int, int] = {}
        self._inputs.listeners.append(self._changed)

    def channel(self, name: str, axis: int) -> int:
        return self._channels.get((name, axis), NONE)

    def is_on(self, name: str, axis: int) -> bool:
        """Whether the input that is assigned is active; one that is not assigned is not."""
        channel = self.channel(name, axis)
        return channel != NONE and self._inputs.is_on(channel)

    def assign(self, name: str, axis: int, channel: int) -> None:
        """Give an input a meaning; one that is active already acts at once."""
        before = self.is_on(name, axis)
        self._channels[name, axis] = channel
        if self.is_on(name, axis) is not before:
            _MEANINGS[name](self, axis, not before)

    def default(self, axis: int) -> None:
        """DEFAULT: no input has a meaning for the axis."""
        self.stop_modes.pop(axis, None)
        for name, each in list(self._channels):
            if each == axis:
                self.assign(name, axis, NONE)

    def _changed(self, channel: int, on: bool) -> None:
        for (name, axis), assigned in tuple(self._channels.items()):
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
        action = ACTIONS[self.stop_modes.get(axis, STOP_INPUT_MODE)]
        if action in ("abort", "error-stop"):
            stop(self._environment, axis, CRASH if action == "abort" else AT_ERROR_DECEL)
        self._environment.events.raise_("stop")

    def _suspend(self, axis: int, on: bool) -> None:
        controller = self._environment.controller
        (controller.suspend if on else controller.resume)(axis, BY_INPUT)

    def _reset(self, axis: int, on: bool) -> None:
        if on:
            reset(self._environment, axis)

    def _home(self, axis: int, on: bool) -> None:
        controller = self._environment.controller
        if self._environment.machine.settings.get(f"axis.{axis}.home_switch") is None:
            controller.set_home_switch(axis, on)


_MEANINGS: dict[str, Callable[[Switches, int, bool], None]] = {
    "LIMITFORWARDINPUT": Switches._forward,
    "LIMITREVERSEINPUT": Switches._reverse,
    "ERRORINPUT": Switches._error,
    "STOPINPUT": Switches._stop,
    "SUSPENDINPUT": Switches._suspend,
    "RESETINPUT": Switches._reset,
    "HOMEINPUT": Switches._home,
}
# Reading keyword -> the assignment whose input it shows.
SHOWN = {"ERRORSWITCH": "ERRORINPUT", "STOPSWITCH": "STOPINPUT", "SUSPENDSWITCH": "SUSPENDINPUT"}


# ----------------------------------------------------------------------------------------------- operations


def read_input(environment: Environment, row: Row) -> Operation:
    switches, name = environment.part(Switches), row.name
    return lambda axis: switches.channel(name, axis_of(environment, axis))


def write_input(environment: Environment, row: Row) -> Operation:
    """LIMITFORWARDINPUT, HOMEINPUT and the like: the input that is the switch, -1 for none."""
    return writing(environment, row, environment.part(Switches).assign)


def read_switch(environment: Environment, row: Row) -> Operation:
    switches, name = environment.part(Switches), SHOWN[row.name]
    return lambda axis: int(switches.is_on(name, axis_of(environment, axis)))


def read_home_switch(environment: Environment, row: Row) -> Operation:
    axes = environment.controller.axes
    return lambda axis: int(axes[axis_of(environment, axis)].home)


def read_stop_input_mode(environment: Environment, row: Row) -> Operation:
    modes = environment.part(Switches).stop_modes
    return lambda axis: modes.get(axis_of(environment, axis), STOP_INPUT_MODE)


def write_stop_input_mode(environment: Environment, row: Row) -> Operation:
    """STOPINPUTMODE."""
    modes = environment.part(Switches).stop_modes

    def write(axis: int, mode: int) -> None:
        row.check(mode)
        modes[axis_of(environment, axis)] = mode

    return write


OPERATIONS = {
    "limits.switches.input": {"read": read_input, "write": write_input},
    "limits.switches.switch": {"read": read_switch},
    "limits.switches.stop_input_mode": {"read": read_stop_input_mode, "write": write_stop_input_mode},
    "limits.switches.home_switch": {"read": read_home_switch},
}
# What raises the events of a kind, made for programs that handle them.
SOURCES = {"stop": Switches}
