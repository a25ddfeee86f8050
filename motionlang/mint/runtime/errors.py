"""Mint's own errors: their numbers and texts, what has gone wrong so far, and the registers that tell of it."""

from __future__ import annotations

from motionlang.controller.faults import Refusal, names

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.environment import Environment

# Diagnostic code -> number of the synchronous error and its short text. Up to 999 they are MintMT's (their numbers are
# positions in a table, see docs/fidelity.md); the virtual machine's errors have no number that could be read and are
# counted from 1001 here, in the order of the manual's list.
NUMBERS: dict[str, tuple[int, str]] = {
    "axis": (2, "axis number invalid"),
    "range": (3, "value invalid"),
    "zero-speed": (3, "value invalid"),
    "zero-acceleration": (3, "value invalid"),
    "channel": (4, "channel invalid"),
    "output": (6, "output not assigned"),
    "axis-error": (12, "axis has an error"),
    "moving": (10, "axis is moving"),
    "disabled-axis": (40, "drive disabled"),
    "no-connection": (41, "no connection"),
    "terminal": (130, "terminal undefined"),
    "one-terminal": (131, "single terminal required"),
    "capture-running": (74, "capture running"),
    "capture-points": (75, "number of capture points invalid"),
    "buffer-in-use": (142, "move buffer must be empty"),
    "brake": (218, "motor brake on"),
    "capture-stopped": (219, "capture not running"),
    "capture-triggered": (220, "capture not waiting for trigger"),
    "enable-input": (228, "hardware enable input off"),
    "event": (204, "event cannot be pended"),
    "stopping": (236, "axis stopping, move refused"),
    "contour-and-blend": (158, "contour and blend both on"),
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
FIRST_OWN = 1001  # from here on the numbers are this program's
MISC_ERROR = 20000  # the asynchronous error of the controller itself; ERRDATA(1) are its bits
AXIS_ERROR = 10000  # the asynchronous error of an axis; ERRDATA(1) is the axis, ERRDATA(2) its error bits

# The groups of ERRORPRESENT and its family.
ALL, SYNCHRONOUS, AXIS, MISC = 0, 1, 2, 3

_PYTHON: tuple[tuple[type[BaseException], str, str], ...] = (
    (ZeroDivisionError, "division-by-zero", "division by zero"),
    (OverflowError, "overflow", "the result is too large for a number"),
    (RecursionError, "recursion", "calls are nested too deeply"),
)
# What a handler of ONERROR can be told of.
TROUBLE = (Refusal, ZeroDivisionError, OverflowError, RecursionError)


class Error:
    """One error: `number`, the text, the line of the program, or the place where it stood, and what it is about."""

    __slots__ = ("data", "group", "line", "number", "place", "text")

    def __init__(
        self, number: int, text: str, line: int, group: int, data: tuple[int, ...], place: int = 0
    ) -> None:
        self.number, self.text, self.line, self.group, self.data = number, text, line, group, data
        self.place = place


class Errors:
    """The list of errors from the first use on, oldest first, and the one that the registers show."""

    def __init__(self, environment: Environment) -> None:
        self.environment = environment
        self.found: list[Error] = []
        self.shown: Error | None = None
        self.calling: Error | None = None  # the first one of those for which ONERROR is yet to begin
        # Whether an error calls no ONERROR, where a program says so.
        self.masked: Callable[[Error], bool] | None = None
        environment.controller.listeners.append(self._heard, "error", "misc")
        environment.controller.take_mishaps(self._mishap)

    # ----------------------------------------------------------------------------------------- noting

    def failed(self, trouble: BaseException, line: int) -> None:
        """A statement has failed: note it and call ONERROR. A handler cannot repair what never ends."""
        if isinstance(trouble, Refusal) and trouble.code == "never":
            raise trouble
        code, message = _said(trouble)
        number, _ = NUMBERS.get(code, GENERIC)
        self._note(Error(number, message, line, SYNCHRONOUS, ()))

    def _mishap(self, refusal: Refusal) -> bool:
        """Something that the program asked for earlier cannot be done; without ONERROR the program ends with it."""
        if not self.environment.events.handles("onerror"):
            return False
        self.failed(refusal, refusal.line)
        return True

    def _heard(self, what: str, axis: int) -> None:
        if what == "error":
            self.axis_error(axis)
        elif what == "misc":
            text = f"the controller has an error: bits {axis}"
            self._note(Error(MISC_ERROR, text, 0, MISC, (axis,), self._place()))

    def axis_error(self, axis: int) -> None:
        """Note an error of an axis that was not pending before."""
        bits = self.environment.controller.faults(axis)
        text = f"axis {axis} has an error: {names(bits)}"
        self._note(Error(AXIS_ERROR, text, 0, AXIS, (axis, bits), self._place()))

    def _place(self) -> int:
        """The statement that has brought the error about or, where time has, the one where the parent task stands."""
        scheduler = self.environment.machine.scheduler
        if scheduler is None:
            return 0
        return (scheduler.current if scheduler.current.running else scheduler.parent).at

    def _note(self, error: Error) -> None:
        self.found.append(error)
        del self.found[:-100]  # a controller's log does not grow for ever either
        if self.masked is None or not self.masked(error):
            self.calling = self.calling or error
            self.environment.events.raise_("onerror")

    def call(self) -> None:
        """ONERROR begins: the registers tell of the error that has called it, which stays on the list."""
        if self.calling is not None:
            self._show(self.calling)
            self.calling = None

    # ---------------------------------------------------------------------------------------- reading

    def present(self, group: int, data: int) -> int:
        """ERRORPRESENT."""
        return int(any(self._of(group, data)))

    def read_next(self, group: int, data: int) -> int:
        """ERRORREADNEXT: show the oldest error of a group and take it off the list."""
        for error in self._of(group, data):
            self.found.remove(error)
            self._show(error)
            return 1
        return 0

    def read_code(self, code: int, data: int) -> int:
        """ERRORREADCODE: show the newest error of a number."""
        for error in reversed(self.found):
            if error.number == code and (not error.data or data < 0 or error.data[0] == data):
                self._show(error)
                return 1
        return 0

    def _show(self, error: Error) -> None:
        """The registers tell of an error from now on, which is something done by reading."""
        if error is not self.shown:
            self.environment.acts += 1
        self.shown = error

    def clear(self, group: int, data: int) -> None:
        """ERRORCLEAR: forget the errors of a group; those of an axis or the controller are cleared there too.

        Also where the list tells of none: a handler has mostly read it to its end before it clears.
        """
        controller, world = self.environment.controller, self.environment.machine.world
        for error in list(self._of(group, data)):
            self.found.remove(error)
        if group in (ALL, MISC) and world is not None:
            world.misc = 0
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
        """ERRLINE: the line of the error that the registers tell of; 0 for a line typed at a prompt."""
        return self.line_of(self.register())

    def line_of(self, error: Error) -> int:
        """The line of an error, found when it is asked for."""
        line_of = self.environment.line_of
        if not error.line and error.place and line_of is not None:
            error.line = line_of(error.place)
        return error.line

    def register(self) -> Error:
        """The error that ERRCODE, ERRLINE, ERRSTRING and ERRDATA tell of."""
        if self.shown is None and self.found:
            self._show(self.found[-1])
        if self.shown is None:
            raise Refusal(
                "not-primed", "the error registers hold nothing yet", "read an error with ERRORREADNEXT first"
            )
        return self.shown


def _said(trouble: BaseException) -> tuple[str, str]:
    if isinstance(trouble, Refusal):
        return trouble.code, trouble.message
    for kind, code, message in _PYTHON:
        if isinstance(trouble, kind):
            return code, message
    return "", str(trouble)


def text_of(number: int) -> str:
    """ERRORSTRING: the text of an error's number."""
    if number == 0:
        return "no error"
    if number == AXIS_ERROR:
        return "axis error"
    if number == MISC_ERROR:
        return "controller error"
    return next((text for each, text in NUMBERS.values() if each == number), f"error {number}")


def with_number(refusal: Refusal) -> None:
    """Add Mint's own number to the hint of what a program is ended with, where it is known."""
    number, text = NUMBERS.get(refusal.code, GENERIC)
    if GENERIC[0] < number < FIRST_OWN:
        known = f"Mint error {number}, {text}"
        refusal.hint = f"{refusal.hint} ({known})" if refusal.hint else known
