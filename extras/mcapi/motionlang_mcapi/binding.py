"""The class `Mcapi`: PMC's Python binding of MCAPI, without PMC's library.

It has a method for every function of the table, such as `MoveAbsolute` for MCMoveAbsolute. Those with a meaning
of their own are written here; the others are made from the table.
"""

from __future__ import annotations

from ast import literal_eval
from collections.abc import Callable, Mapping
from inspect import Parameter, Signature
from typing import TYPE_CHECKING, Any, TypeVar

from motionlang.kernel import Machine
from motionlang_mcapi import table as mc
from motionlang_mcapi.client import STEP, Calls, PortCalls, VirtualBoard
from motionlang_mcapi.table import BITS, FUNCTIONS, STRUCTURES, ApiFunction, Argument, Value

Self = TypeVar("Self", bound="Mcapi")

# Errors that are not raised.
QUIET = (mc.MCERR_NOERROR, mc.MCERR_NOTSUPPORTED)


class McapiException(Exception):
    """A call has failed: `code` is one of MCERR, `msg` its text."""

    def __init__(self, code: int) -> None:
        self.code = code
        self.msg = mc.text_of(code)
        super().__init__(self.msg)


class Mcapi:
    """MCAPI as PMC's Python binding has it, without the library."""

    def __init__(self, board: Calls | str | None = None) -> None:
        self._calls = PortCalls(board) if board is None or isinstance(board, str) else board
        self._handle = 0

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            """Return a method that is made from the table."""

    @classmethod
    def virtual(
        cls: type[Self], machine: Machine | Mapping[str, object] | str | None = None, step: float = STEP
    ) -> Self:
        """Return a host of a virtual board in this process.

        `machine` is a machine, its settings, or a machine file. Machine time passes only in calls: each takes
        `step` seconds, or the time that it waits. `advance` lets time pass between them.
        """
        return cls(VirtualBoard(machine, step))

    @property
    def board(self) -> VirtualBoard:
        """The virtual board; raises TypeError if the board is behind a port."""
        if not isinstance(self._calls, VirtualBoard):
            raise TypeError("a board behind a port has its own time")
        return self._calls

    @property
    def now(self) -> float:
        """Machine time of a virtual board, seconds."""
        return self.board.now

    def advance(self, seconds: float) -> None:
        """Let machine time of a virtual board pass, by seconds."""
        self.board.advance(seconds)

    def Handle(self) -> int:  # noqa: N802
        """Return the handle, 0 if there is none."""
        return self._handle

    def Open(self, id: int, mode: int, opts: str | None = None) -> int:  # noqa: N802
        """Open a handle; return it, or minus the error code."""
        self._handle, _ = self._calls.call("MCOpen", 0, (id, mode, opts))
        return self._handle

    def Close(self) -> None:  # noqa: N802
        """Close the handle."""
        if self._handle > 0:
            self._calls.call("MCClose", self._handle, ())
            self._handle = 0

    def GetError(self) -> int:  # noqa: N802
        """Return the last error of the handle and clear it."""
        return self._calls.call("MCGetError", self._handle, ())[0]

    def TranslateErrorEx(self, error: int) -> str:  # noqa: N802
        """Return the text of an error code."""
        return mc.text_of(error)

    def ProcessException(self, error: int = -1) -> int:  # noqa: N802
        """Raise McapiException for an error, by default the last one; return its code.

        An error that is raised is no longer the last error, or a later 0 would raise it again.
        """
        code = self.GetError() if error == -1 else error
        if code not in QUIET:
            self.GetError()
            raise McapiException(code)
        return code

    def _call(self, function: ApiFunction, given: dict[str, Any]) -> Any:
        """Carry out a call with arguments by name; raise McapiException if it fails.

        An error does not change a structure or a buffer.
        """
        arguments = [value for each in function.arguments for value in _sent(each, given)]
        result, outputs = self._calls.call(function.name, self._handle, arguments)
        if function.is_value:
            if outputs:
                text = str(outputs[0]).encode("latin-1", "replace")
                given["buffer"][: len(text) + 1] = text + b"\0"
            elif result == 0 and function.zero_may_fail:
                self.ProcessException()
            return result
        if result and not function.result:
            self.GetError()
        self.ProcessException(result)
        found = function.outputs
        if not found:
            return None
        if found[0].kind in STRUCTURES:
            if outputs:
                given[found[0].name].fill(outputs)
            return None
        if any(each.size for each in found):
            return list(outputs)
        if len(found) > 1:
            return outputs
        return outputs[0] if outputs else 0


def _sent(each: Argument, given: dict[str, Any]) -> list[Value | None]:
    """Return the flattened values of an argument."""
    if each.out or each.kind == "memory":
        return [1]
    value = given[each.name]
    if each.kind in STRUCTURES:
        value = value.values()
    elif not each.size:
        return [int(value) if each.kind in BITS else value]
    return [len(value), *value]


def _signature(function: ApiFunction) -> Signature:
    """Return the parameters of a method: inputs and structures, unless the table has others."""
    names = [each.name for each in function.arguments if not each.out or each.kind in STRUCTURES]
    found = [Parameter("self", Parameter.POSITIONAL_ONLY)]
    for each in function.python.split(", ") if function.python else names:
        name, _, default = each.partition("=")
        value = literal_eval(default) if default else Parameter.empty
        found.append(Parameter(name, Parameter.POSITIONAL_OR_KEYWORD, default=value))
    return Signature(found)


def _method(function: ApiFunction, name: str) -> Callable[..., Any]:
    signature = _signature(function)

    def method(self: Mcapi, *arguments: Any, **named: Any) -> Any:
        given = signature.bind(self, *arguments, **named)
        return self._call(function, given.arguments)

    method.__name__, method.__qualname__ = name, f"Mcapi.{name}"
    method.__doc__ = function.effect
    vars(method)["__signature__"] = signature
    return method


for _function in FUNCTIONS.values():
    _name = _function.name.removeprefix("MC")
    if not hasattr(Mcapi, _name):
        setattr(Mcapi, _name, _method(_function, _name))
