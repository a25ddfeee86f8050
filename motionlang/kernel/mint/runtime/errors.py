"""Mint's own errors: numbers and texts, the list of errors, and its registers."""

from __future__ import annotations

from motionlang.kernel.controller.faults import fault_names
from motionlang.kernel.errors import Rejected
from motionlang.kernel.mint.runtime.environment import Environment

# Diagnostic code -> number of the synchronous error and its short text. Numbers up to 999 are MintMT's:
# positions in a table, see docs/contributing/assumptions.md. Errors of the virtual machine have no number that could be
# read. They are numbered from 1001 here, in the order of the manual's list.
NUMBERS: dict[str, tuple[int, str]] = {
    "axis": (2, "axis number invalid"),
    "range": (3, "value invalid"),
    "zero-speed": (3, "value invalid"),
    "zero-acceleration": (3, "value invalid"),
    "channel": (4, "channel invalid"),
    "axis-error": (12, "axis has an error"),
    "moving": (10, "axis is moving"),
    "disabled-axis": (40, "drive disabled"),
    "no-connection": (41, "no connection"),
    "terminal": (130, "terminal undefined"),
    "one-terminal": (131, "single terminal required"),
    "buffer-in-use": (142, "move buffer must be empty"),
    "enable-input": (228, "hardware enable input off"),
    "stopping": (236, "axis stopping, move refused"),
    "buffer-full": (59, "move buffer full"),
    "not-simulated": (17, "not supported here"),
    "division-by-zero": (1001, "divide by zero"),
    "argument": (1002, "invalid argument"),
    "recursion": (1003, "stack overflow"),
    "index": (1004, "index out of range"),
    "overflow": (1005, "integer out of range"),
    "not-primed": (1006, "error registers not primed"),
    "limit": (1007, "out of memory"),
    "string-overflow": (1008, "string overflow"),
}
GENERIC = (1, "keyword error")
FIRST_OWN = 1001  # numbers from here on are motionlang's
MISC_ERROR = 20000  # the asynchronous error of the controller itself; ERRDATA(1) is its bits
AXIS_ERROR = 10000  # the asynchronous error of an axis; ERRDATA(1) is the axis, ERRDATA(2) its error bits

# The groups of ERRORPRESENT and related keywords.
ALL, SYNCHRONOUS, AXIS, MISC = 0, 1, 2, 3

_PYTHON: tuple[tuple[type[BaseException], str, str], ...] = (
    (ZeroDivisionError, "division-by-zero", "division by zero"),
    (OverflowError, "overflow", "the result is too large for a number"),
)
# The exceptions that an ONERROR handler can handle.
TROUBLE = (Rejected, ZeroDivisionError, OverflowError)


class Error:
    """One error: number, text, group, data, and its program line or source offset."""

    __slots__ = ("data", "group", "line", "number", "offset", "text")

    def __init__(
        self, number: int, text: str, line: int, group: int, data: tuple[int, ...], offset: int = 0
    ) -> None:
        self.number, self.text, self.line, self.group, self.data = number, text, line, group, data
        self.offset = offset


class Errors:
    """The list of errors, oldest first, and the error in the registers.

    Errors are recorded from the first use of this object on.
    """

    def __init__(self, environment: Environment) -> None:
        self.environment = environment
        self.found: list[Error] = []
        self.shown: Error | None = None
        self.calling: Error | None = None  # the first of the errors for which ONERROR has not begun
        environment.controller.listeners.append(self._on_event, "error", "misc")
        environment.controller.set_fault_handler(self._run_time_fault)

    # -------------------------------------------------------------------------------------- recording

    def failed(self, trouble: BaseException, line: int) -> None:
        """Record the failure of a statement and call ONERROR.

        A `never` error is raised again, because no handler can fix it.
        """
        if isinstance(trouble, Rejected) and trouble.code == "never":
            raise trouble
        code, message = _description(trouble)
        number, _ = NUMBERS.get(code, GENERIC)
        self._note(Error(number, message, line, SYNCHRONOUS, ()))

    def _run_time_fault(self, rejected: Rejected) -> bool:
        """Record an earlier command that cannot be carried out.

        Returns False if there is no ONERROR; the fault then ends the program.
        """
        if not self.environment.events.handles("onerror"):
            return False
        self.failed(rejected, rejected.line)
        return True

    def _on_event(self, what: str, axis: int) -> None:
        if what == "error":
            self.axis_error(axis)
        elif what == "misc":
            text = f"the controller has an error: bits {axis}"
            self._note(Error(MISC_ERROR, text, 0, MISC, (axis,), self._offset()))

    def axis_error(self, axis: int) -> None:
        """Record an axis error that was not already pending."""
        bits = self.environment.controller.faults(axis)
        text = f"axis {axis} has an error: {fault_names(bits)}"
        self._note(Error(AXIS_ERROR, text, 0, AXIS, (axis, bits), self._offset()))

    def _offset(self) -> int:
        """Return the source offset of the statement that caused the error.

        If no statement caused it, this is the statement that the parent task has reached.
        """
        scheduler = self.environment.machine.scheduler
        if scheduler is None:
            return 0
        return (scheduler.current if scheduler.current.running else scheduler.parent).at

    def _note(self, error: Error) -> None:
        self.found.append(error)
        del self.found[:-100]  # a controller's log does not grow forever either
        self.calling = self.calling or error
        self.environment.events.raise_("onerror")

    def call(self) -> None:
        """Put the error that called ONERROR into the registers; it remains in the list."""
        if self.calling is not None:
            self._show(self.calling)
            self.calling = None

    # ------------------------------------------------------------------------------------------ reads

    def present(self, group: int, data: int) -> int:
        """ERRORPRESENT: return 1 if there is an error of the group."""
        return int(any(self._of(group, data)))

    def read_next(self, group: int, data: int) -> int:
        """ERRORREADNEXT: move the oldest error of a group from the list to the registers."""
        for error in self._of(group, data):
            self.found.remove(error)
            self._show(error)
            return 1
        return 0

    def read_code(self, code: int, data: int) -> int:
        """ERRORREADCODE: put the newest error with a number into the registers."""
        for error in reversed(self.found):
            if error.number == code and (not error.data or data < 0 or error.data[0] == data):
                self._show(error)
                return 1
        return 0

    def _show(self, error: Error) -> None:
        """Put an error into the registers, which counts as an action, not as a mere read."""
        if error is not self.shown:
            self.environment.acts += 1
        self.shown = error

    def clear(self, group: int, data: int) -> None:
        """ERRORCLEAR: clear the errors of a group, in the axes and the controller, too.

        This is done even if the list has no error of the group, because a handler has usually read the whole list by
        then.
        """
        controller, world = self.environment.controller, self.environment.machine.world
        for error in list(self._of(group, data)):
            self.found.remove(error)
        if group in (ALL, MISC) and world is not None:
            world.failed = False
        for axis in controller.axes if group == ALL else (data,) if group == AXIS else ():
            if axis in controller.axes and controller.axes[axis].faults:
                controller.clear_faults(axis)

    def _of(self, group: int, data: int) -> list[Error]:
        return [
            error
            for error in self.found
            if group in (ALL, error.group) and (error.group != AXIS or group == ALL or error.data[0] == data)
        ]

    def line(self) -> int:
        """ERRLINE: return the line of the error in the registers, 0 for a prompt's line."""
        return self.line_of(self.register())

    def line_of(self, error: Error) -> int:
        """Return the line of an error, looked up on demand."""
        line_of = self.environment.line_of
        if not error.line and error.offset and line_of is not None:
            error.line = line_of(error.offset)
        return error.line

    def register(self) -> Error:
        """Return the error that ERRCODE, ERRLINE, ERRSTRING and ERRDATA refer to."""
        if self.shown is None and self.found:
            self._show(self.found[-1])
        if self.shown is None:
            raise Rejected(
                "not-primed", "the error registers are still empty", "read an error with ERRORREADNEXT first"
            )
        return self.shown


def _description(trouble: BaseException) -> tuple[str, str]:
    if isinstance(trouble, Rejected):
        return trouble.code, trouble.message
    for kind, code, message in _PYTHON:
        if isinstance(trouble, kind):
            return code, message
    return "", str(trouble)


def text_of(number: int) -> str:
    """ERRORSTRING: return the text of an error number."""
    if number == 0:
        return "no error"
    if number == AXIS_ERROR:
        return "axis error"
    if number == MISC_ERROR:
        return "controller error"
    return next((text for each, text in NUMBERS.values() if each == number), f"error {number}")


def with_number(rejected: Rejected) -> None:
    """Add Mint's own error number to the hint of a Rejected, if it is known."""
    number, text = NUMBERS.get(rejected.code, GENERIC)
    if GENERIC[0] < number < FIRST_OWN:
        known = f"Mint error {number}, {text}"
        rejected.hint = f"{rejected.hint} ({known})" if rejected.hint else known
