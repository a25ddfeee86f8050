"""The base of the Python class of MCAPI: structures, errors, connections.

The class itself, with a method for every function, is generated (`binding.py`).
"""

from __future__ import annotations

import os
import socket
from collections.abc import Callable, Mapping, Sequence
from typing import Any, ClassVar, Protocol, TypeVar

import motionlang.mcapi.calls  # noqa: F401
from motionlang.execution import checked_settings
from motionlang.lang.machine.file import read_machine
from motionlang.lang.machine.machine import Machine
from motionlang.mcapi import constants as mc
from motionlang.mcapi.call import Call
from motionlang.mcapi.protocol import VERSION, decode, encode, request
from motionlang.mcapi.session import McapiBoard
from motionlang.mcapi.table import FUNCTIONS, STRUCTURES, Value
from motionlang.mccl.hosts.console import Console
from motionlang.serve.address import BadAddress, parse
from motionlang.source import Source

Answer = tuple[int, tuple[Value | None, ...]]
Self = TypeVar("Self", bound="Binding")

# Where a board is if MCAPI_HOST does not say it.
DEFAULT_ADDRESS = "127.0.0.1:4410"
ADDRESS_VARIABLE = "MCAPI_HOST"
# Seconds to connect.
PATIENCE = 5.0
# Least machine seconds of a call in virtual time, and the most, after which it times out.
STEP, MAX_CALL = 1e-3, 86_400.0
# Errors that are not raised.
QUIET = (mc.MCERR_NOERROR, mc.MCERR_NOTSUPPORTED)


class McapiException(Exception):
    """A call has failed: `code` is one of MCERR, `msg` its text."""

    def __init__(self, code: int) -> None:
        self.code = code
        self.msg = mc.MESSAGES.get(code, f"unknown error {code}")
        super().__init__(self.msg)


class Structure:
    """A structure of MCAPI: plain attributes, initially 0."""

    names: ClassVar[tuple[str, ...]]

    def __init__(self) -> None:
        structure = STRUCTURES[type(self).__name__]
        for field in structure.fields:
            zero: Any = 0.0 if field.kind == "d" else 0
            setattr(self, field.name, [zero] * field.count if field.count > 1 else zero)

    def __repr__(self) -> str:
        names = [field.name for field in STRUCTURES[type(self).__name__].values]
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)!r}' for name in names)})"

    def values(self) -> list[float]:
        """Return the values that are transported."""
        found: list[float] = []
        for field in STRUCTURES[type(self).__name__].values:
            value = getattr(self, field.name)
            found += value if field.count > 1 else [value]
        return found

    def fill(self, values: Sequence[Any]) -> None:
        """Set the values from an answer."""
        at = 0
        for field in STRUCTURES[type(self).__name__].values:
            setattr(self, field.name, list(values[at : at + field.count]) if field.count > 1 else values[at])
            at += field.count


class Calls(Protocol):
    """A connection to a board: carries out a call and returns its result and outputs."""

    def call(self, name: str, handle: int, arguments: Sequence[Value | None]) -> Answer: ...
    def close(self) -> None: ...


class PortCalls:
    """Calls over the port of `motionlang serve --mcapi`; the first call connects.

    After a connection failure every call returns MCERR_SOCKET, also on all handles that were open, until the next
    MCOpen.
    """

    def __init__(self, address: str | None = None) -> None:
        self._address = address or os.environ.get(ADDRESS_VARIABLE, DEFAULT_ADDRESS)
        self._socket: socket.socket | None = None
        self._rest = b""

    def call(self, name: str, handle: int, arguments: Sequence[Value | None]) -> Answer:
        """Carry out a call over the connection; only MCOpen opens a connection."""
        if self._socket is None and name != "MCOpen":
            return self._lost(name)
        try:
            if self._socket is None:
                self._connect()
            answer = self._exchange(request(name, handle, arguments))
        except (OSError, ValueError):
            self.close()
            return self._lost(name)
        result, *outputs = answer
        assert isinstance(result, int)
        return result, tuple(outputs)

    def close(self) -> None:
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    def _connect(self) -> None:
        try:
            host, port = parse(self._address)
        except BadAddress as problem:
            raise OSError(str(problem)) from None
        self._socket = socket.create_connection((host, port), PATIENCE)
        self._socket.settimeout(None)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._rest = b""
        self._exchange(f"Session {VERSION} {encode([f'{os.getpid()}-{id(self)}'])}")

    def _exchange(self, line: str) -> list[Value | None]:
        assert self._socket is not None
        self._socket.sendall(line.encode("latin-1", "replace") + b"\n")
        found = self._rest
        while b"\n" not in found:
            more = self._socket.recv(65536)
            if not more:
                raise ConnectionError("the board has closed the connection")
            found += more
        text, _, self._rest = found.partition(b"\n")
        return decode(text.decode("latin-1"))

    def _lost(self, name: str) -> Answer:
        return (-mc.MCERR_SOCKET if name == "MCOpen" else mc.MCERR_SOCKET), ()


class VirtualBoard:
    """A board in this process, in virtual time.

    Each call takes `step` seconds, or the time that it waits.
    """

    def __init__(
        self,
        machine: Machine | Mapping[str, object] | str | None = None,
        step: float = STEP,
        complain: Callable[[str], None] | None = None,
        record: Callable[[Call], None] | None = None,
    ) -> None:
        self.console = Console(_machine(machine))
        self.desk = McapiBoard(self.console, complain, record)
        self.step = step
        self._session = self.desk.session()
        self._busy_until = 0.0

    @property
    def now(self) -> float:
        """Machine time, seconds."""
        return self.console.now

    def advance(self, seconds: float) -> None:
        """Let machine time pass while the host does something else."""
        self.console.run(max(self._busy_until, self.now) + seconds)

    def call(self, name: str, handle: int, arguments: Sequence[Value | None]) -> Answer:
        """Carry out a call, and advance machine time by its duration."""
        console = self.console
        if self._busy_until > console.now:
            console.run(self._busy_until)
        self._busy_until = console.now + self.step
        call = self._session.call(name, handle, arguments)
        if not call.done and not console.run_until(lambda: call.done, console.now + MAX_CALL):
            # Nothing else ends it, or not in a day.
            self._session.give_up(call)
        return call.result, call.outputs

    def close(self) -> None:
        """Do nothing: the board remains as it is."""


class Binding:
    """The base of the class `Mcapi`: makes calls and converts their results."""

    def __init__(self, board: Calls | str | None = None) -> None:
        self._calls = PortCalls(board) if board is None or isinstance(board, str) else board
        self._handle = 0

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
        return mc.MESSAGES.get(error, f"unknown error {error}")

    def ProcessException(self, error: int = -1) -> int:  # noqa: N802
        """Raise McapiException for an error, by default the last one; return its code.

        An error that is raised is no longer the last error, or a later 0 would raise it again.
        """
        code = self.GetError() if error == -1 else error
        if code not in QUIET:
            self.GetError()
            raise McapiException(code)
        return code

    def _do(self, name: str, *arguments: Value | None) -> tuple[Any, ...]:
        """Carry out a call whose result is an error code or nothing; return its outputs."""
        code, outputs = self._calls.call(name, self._handle, arguments)
        if code and not FUNCTIONS[name].result:
            self.GetError()
        self.ProcessException(code)
        return outputs

    def _get(self, name: str, *arguments: Value | None) -> Any:
        """Carry out a call with one output; 0 if it is not supported."""
        outputs = self._do(name, *arguments)
        return outputs[0] if outputs else 0

    def _value(self, name: str, *arguments: Value | None) -> int:
        """Carry out a call whose result is a value; 0 may also mean an error."""
        value, _ = self._calls.call(name, self._handle, arguments)
        if value == 0:
            self.ProcessException()
        return value

    def _is(self, name: str, *arguments: Value | None) -> int:
        """Carry out a call whose result is true or false."""
        return self._calls.call(name, self._handle, arguments)[0]

    def _fill(self, structure: Structure, name: str, *arguments: Value | None) -> None:
        """Carry out a call that fills a structure; an error does not change it."""
        outputs = self._do(name, *arguments)
        if outputs:
            structure.fill(outputs)

    def _text(self, buffer: bytearray, name: str, *arguments: Value | None) -> int:
        """Carry out a call that fills a buffer with text and a terminating zero.

        Returns the number of characters.
        """
        count, outputs = self._calls.call(name, self._handle, arguments)
        if outputs:
            found = str(outputs[0]).encode("latin-1", "replace")
            buffer[: len(found) + 1] = found + b"\0"
        elif count == 0:
            self.ProcessException()
        return count


def _machine(given: Machine | Mapping[str, object] | str | None) -> Machine:
    if isinstance(given, Machine):
        return given
    settings = read_machine(Source.read(given)) if isinstance(given, str) else checked_settings(given or {})
    return Machine(settings, first_axis=1)
