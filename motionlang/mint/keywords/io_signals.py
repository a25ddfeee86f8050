"""Outputs that show the state of the controller: that an axis is on, that something is wrong."""

from __future__ import annotations

from motionlang.mint.keywords.axis_settings import Settings, reading, writing
from motionlang.mint.runtime.binding import of
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment

NONE = -1


class Signals(Settings):
    """The outputs, by axis for DRIVEENABLEOUTPUT; an output that is assigned shows the state at once."""

    otherwise = NONE

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.errors = NONE
        self.controller.listeners.append(self._heard, "fault", "switched", "cleared")

    def set(self, name: str, axis: int, value: float) -> None:
        """DRIVEENABLEOUTPUT: the output that is on while the axis is enabled."""
        super().set(name, axis, value)
        self._show(axis)

    def assign_errors(self, output: int) -> None:
        """GLOBALERROROUTPUT: the output that is on while any axis has an error."""
        self.errors = output
        self._show_errors()

    def _heard(self, what: str, axis: int) -> None:
        if what == "switched":
            self._show(axis)
        if what in ("fault", "switched", "cleared"):
            self._show_errors()

    def _show(self, axis: int) -> None:
        output = int(self.setting("DRIVEENABLEOUTPUT", axis))
        if output != NONE:
            self.controller.set_output(output, int(self.controller.is_enabled(axis)))

    def _show_errors(self) -> None:
        if self.errors != NONE:
            controller = self.controller
            controller.set_output(self.errors, int(any(controller.faults(axis) for axis in controller.axes)))


OPERATIONS = {
    "io.signals.enable_output": {"read": reading(Signals), "write": repeatable(writing(Signals))},
    "io.signals.error_output": {
        "read": of(Signals, lambda signals: signals.errors),
        "write": repeatable(of(Signals, Signals.assign_errors)),
    },
}
