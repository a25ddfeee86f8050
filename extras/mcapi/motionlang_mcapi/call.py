"""One call of a host, from its arrival to its answer."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from motionlang.kernel.mccl import Line

if TYPE_CHECKING:
    from motionlang_mcapi.session import Handle
    from motionlang_mcapi.table import ApiFunction, Value


class ApiCall:
    """A function with its arguments and, when `done`, its results.

    `arguments` are the inputs of the table, flattened: a structure as its values, an array as its length and
    values, and None for a NULL pointer. `outputs` are flattened, too, and empty if the call failed. `value` is the
    result of a function that returns a value. `begin` and `end` are machine times, s.
    """

    def __init__(
        self, function: ApiFunction, number: int, arguments: tuple[Value | None, ...], begin: float
    ) -> None:
        self.function, self.number, self.arguments = function, number, arguments
        self.handle: Handle | None = None
        # The number of the host process.
        self.host = 0
        # The line that carries it out.
        self.line: Line | None = None
        self.outputs: tuple[Value, ...] = ()
        self.value = self.code = 0
        self.done = False
        self.begin = self.end = begin
        # Called when the call is done.
        self.finished: Callable[[ApiCall], None] | None = None

    def finish(self, now: float, code: int | None = None) -> None:
        """Complete the call, once; its code becomes the last error of the handle."""
        if self.done:
            return
        if code is not None:
            self.code = code
        self.done, self.end = True, now
        if self.code:
            self.outputs = ()
            if self.handle is not None:
                self.handle.error = self.code
        if self.finished is not None:
            self.finished(self)

    @property
    def result(self) -> int:
        """The return value in C, or the error code of a function that returns none."""
        return self.value if self.function.is_value else self.code
