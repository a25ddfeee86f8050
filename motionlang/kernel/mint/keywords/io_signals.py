"""Outputs that show the state of the controller: an enabled axis, an error."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.runtime.binding import of
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

NONE = -1


class SignalOutputs(StoredSettings):
    """The outputs assigned to states: DRIVEENABLEOUTPUT by axis, GLOBALERROROUTPUT.

    An output shows the state as soon as it is assigned.
    """

    otherwise = NONE

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.errors = NONE
        self.controller.listeners.append(self._on_event, "fault", "switched", "cleared")

    def set(self, name: str, axis: int, value: float) -> None:
        """DRIVEENABLEOUTPUT: assign the output that is on while the axis is enabled."""
        super().set(name, axis, value)
        self._show(axis)

    def assign_errors(self, output: int) -> None:
        """GLOBALERROROUTPUT: assign the output that is on while any axis has an error."""
        self.errors = output
        self._show_errors()

    def _on_event(self, what: str, axis: int) -> None:
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


# ------------------------------------------------------------------------------------------------- keywords

_ERROR_OUTPUT = Actions(
    read=of(SignalOutputs, lambda signals: signals.errors),
    write=repeatable(of(SignalOutputs, SignalOutputs.assign_errors)),
)


ROWS = (
    Keyword("DRIVEENABLEOUTPUT", "deo", "setting", "RW", "axis", "integer",
            Actions("enable_output", read=setting_reader(SignalOutputs),
                    write=repeatable(setting_writer(SignalOutputs))),
            "The output that is on while the drive of the axis is enabled; -1 for none.",
            "DRIVEENABLEOUTPUT(0) = 4\nPRINT OUTX(4)", default=-1.0, low=-1, high=999, group="io", selects="output"),
    Keyword("GLOBALERROROUTPUT", "geo", "setting", "RW", "none", "integer", _ERROR_OUTPUT,
            "The output that is on while any axis has an error; -1 for none.",
            "GLOBALERROROUTPUT = 5\nPRINT OUTX(5)", default=-1.0, low=-1, high=999, group="io", selects="output"),
)  # fmt: skip
