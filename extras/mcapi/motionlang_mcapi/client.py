"""Connections of the Python class of MCAPI: over the port, and to a virtual board."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Protocol

import motionlang_mcapi.calls  # noqa: F401
from motionlang.hosts.address import BadAddress, parse
from motionlang.hosts.channel import TcpWire
from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve.pace import LockStep
from motionlang.kernel import Machine, checked_settings
from motionlang_mcapi import table as mc
from motionlang_mcapi.call import ApiCall
from motionlang_mcapi.protocol import VERSION, decode, encode, request
from motionlang_mcapi.session import McapiBoard
from motionlang_mcapi.table import FUNCTIONS, Value

Answer = tuple[int, tuple[Value | None, ...]]

# Where a board is if MCAPI_HOST does not say it.
DEFAULT_ADDRESS = "127.0.0.1:4410"
ADDRESS_VARIABLE = "MCAPI_HOST"
# Seconds to connect, and between two looks for an answer.
PATIENCE = 5.0
# Least machine seconds of a call in virtual time, and the most, after which it times out.
STEP, MAX_CALL = 1e-3, 86_400.0


class Calls(Protocol):
    """A connection to a board: carries out a call and returns its result and outputs."""

    def call(self, name: str, handle: int, arguments: Sequence[Value | None]) -> Answer: ...
    def close(self) -> None: ...


class PortCalls:
    """Calls over the port of `motionlang mcapi serve`; the first call connects.

    After a connection failure every call returns MCERR_SOCKET, also on all handles that were open, until the next
    MCOpen.
    """

    def __init__(self, address: str | None = None) -> None:
        self._address = address or os.environ.get(ADDRESS_VARIABLE, DEFAULT_ADDRESS)
        self._wire: TcpWire | None = None
        self._rest = b""

    def call(self, name: str, handle: int, arguments: Sequence[Value | None]) -> Answer:
        """Carry out a call over the connection; only MCOpen opens a connection."""
        if self._wire is None and name != "MCOpen":
            return self._lost(name)
        try:
            if self._wire is None:
                self._connect()
            answer = self._exchange(request(name, handle, arguments))
        except (OSError, ValueError):
            self.close()
            return self._lost(name)
        result, *outputs = answer
        assert isinstance(result, int)
        return result, tuple(outputs)

    def close(self) -> None:
        if self._wire is not None:
            self._wire.close()
            self._wire = None

    def _connect(self) -> None:
        try:
            host, port = parse(self._address)
        except BadAddress as problem:
            raise OSError(str(problem)) from None
        self._wire = TcpWire(host, port, PATIENCE)
        self._rest = b""
        self._exchange(f"Session {VERSION} {encode([f'{os.getpid()}-{id(self)}'])}")

    def _exchange(self, line: str) -> list[Value | None]:
        assert self._wire is not None
        self._wire.send(line.encode("latin-1", "replace") + b"\n")
        found = self._rest
        while b"\n" not in found:
            found += self._wire.receive(PATIENCE)  # a call may take any time
        text, _, self._rest = found.partition(b"\n")
        return decode(text.decode("latin-1"))

    def _lost(self, name: str) -> Answer:
        return FUNCTIONS[name].failed(mc.MCERR_SOCKET), ()


class VirtualBoard:
    """A board in this process, in virtual time.

    Each call takes `step` seconds, or the time that it waits.
    """

    def __init__(
        self,
        machine: Machine | Mapping[str, object] | str | None = None,
        step: float = STEP,
        complain: Callable[[str], None] | None = None,
        record: Callable[[ApiCall], None] | None = None,
    ) -> None:
        self.console = Console(_machine(machine))
        self.desk = McapiBoard(self.console, complain, record)
        self.step = step
        self._session = self.desk.session()
        self._pace = LockStep(self.console, step)

    @property
    def now(self) -> float:
        """Machine time, seconds."""
        return self.console.now

    def advance(self, seconds: float) -> None:
        """Let machine time pass while the host does something else."""
        self.console.run(max(self._pace.busy_until, self.now) + seconds)

    def call(self, name: str, handle: int, arguments: Sequence[Value | None]) -> Answer:
        """Carry out a call, and advance machine time by its duration."""
        console = self.console
        self._pace.entered()
        call = self._session.call(name, handle, arguments)
        if not call.done and not console.run_until(lambda: call.done, console.now + MAX_CALL):
            # Nothing else ends it, or not in a day.
            self._session.give_up(call)
        return call.result, call.outputs

    def close(self) -> None:
        """Do nothing: the board remains as it is."""


def _machine(given: Machine | Mapping[str, object] | str | None) -> Machine:
    if isinstance(given, Machine):
        return given
    return Machine(checked_settings(given or {}), first_axis=1)
