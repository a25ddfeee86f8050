"""Hosts of a board: their handles, and how a call reaches the interface.

Problem    A host process has any number of threads, each with a connection, and its handles are valid in all
           of them. A handle of another host is not. A wrong argument must not reach the board.
Idea       A `HostProcess` is one host process. It checks a call against the table in this order: handle, NULL,
           finite numbers, axis. Then it runs the function that `calls/` has for the call, of one of four kinds:
             commands   a list of MCCL commands, carried out by the interface, or added to an open block
             reading    a function that the interface calls at the machine time of the call
             at once    an action that concerns only the handle or the block
             poll       a condition, which occupies no interface
Data       `McapiBoard` has the objects that the sessions of a board share: two interfaces and the handles.
Invariants No value of the board is stored here: every call reads it from the board.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from math import isfinite
from typing import Any

from motionlang.hosts.mccl.console import Console
from motionlang.kernel import INFINITY, Rejected
from motionlang.kernel.mccl import Command, CommandTask, Fault
from motionlang_mcapi import table as mc
from motionlang_mcapi.call import ApiCall
from motionlang_mcapi.command import command, line, own, takes_all_axes
from motionlang_mcapi.errors import CallRefused, code_of
from motionlang_mcapi.interface import Interface, Poll, expire
from motionlang_mcapi.registry import AT_ONCE, COMMANDS, POLLS, QUERIES
from motionlang_mcapi.table import BITS, FUNCTIONS, STRUCTURES, ApiFunction, Argument, Value

MAX_HANDLES = 1000
# Arguments that are axes.
AXES = ("axis", "master", "caxis")


class BadCall(ValueError):
    """A call that does not match the table: its sender does not speak the protocol."""


def function_named(name: str) -> ApiFunction:
    """Return a function; raise BadCall if the table does not have it."""
    function = FUNCTIONS.get(name)
    if function is None:
        why = ": the dialogs of MCDLG are not simulated" if name.startswith("MCDLG_") else ""
        raise BadCall(f"there is no function {name[:40]!r}{why}")
    return function


class Handle:
    """An open handle; `error` is its last error, `timeout` 0 for none."""

    def __init__(self, session: HostProcess, number: int, mode: int, interface: Interface) -> None:
        self.session, self.number, self.mode, self.interface = session, number, mode, interface
        self.error = 0
        self.timeout = 0.0
        # The reply to the last pmccmdex.
        self.reply = ""

    @property
    def is_ascii(self) -> bool:
        return bool(self.mode & mc.MC_OPEN_ASCII)

    @property
    def is_exclusive(self) -> bool:
        return bool(self.mode & mc.MC_OPEN_EXCLUSIVE)


class McapiBoard:
    """A board for hosts that speak MCAPI.

    `complain` is called once for each unsupported function, with the reason. `record` is called with every
    completed call.
    """

    def __init__(
        self,
        console: Console,
        complain: Callable[[str], None] | None = None,
        record: Callable[[ApiCall], None] | None = None,
    ) -> None:
        self.console, self.board = console, console.board
        self.record = record
        self.handles: list[Handle] = []
        self._complain = complain or _to_standard_error
        self._interfaces: dict[bool, Interface] = {}
        self._sessions: dict[str, HostProcess] = {}
        self._complained: set[str] = set()
        self._count = 0

    @property
    def now(self) -> float:
        return self.console.now

    def session(self, token: str = "") -> HostProcess:
        """Return the session of a host process.

        A connection without a token is a process of its own.
        """
        found = self._sessions.get(token)
        if found is None:
            self._count += 1
            found = HostProcess(self, token, self._count)
            if token:
                self._sessions[token] = found
        found.connections += 1
        return found

    def interface(self, is_ascii: bool) -> Interface:
        """Return one of the two interfaces, creating it for its first handle."""
        found = self._interfaces.get(is_ascii)
        if found is None:
            port = None
            if is_ascii:
                port = self.console.open(echo=False)
                port.take()
            found = self._interfaces[is_ascii] = Interface(self.board, port)
            self.board.join(found)
            self.console.start(found)
        return found

    def unsupported(self, name: str, reason: str) -> None:
        """Report an unsupported function, once."""
        if name not in self._complained:
            self._complained.add(name)
            self._complain(f"{name} is not supported: {reason}")

    def forget(self, session: HostProcess) -> None:
        """Remove the session of a host that is gone."""
        self._sessions.pop(session.token, None)


class HostProcess:
    """One host process: its handles, and its pending calls."""

    def __init__(self, desk: McapiBoard, token: str, number: int) -> None:
        self.desk, self.token, self.number = desk, token, number
        self.connections = 0
        self.handles: dict[int, Handle] = {}
        self._pending: dict[ApiCall, Poll | None] = {}

    def leave(self) -> None:
        """Close a connection.

        Closing the last one removes the host, with its block and calls.
        """
        self.connections -= 1
        if self.connections > 0:
            return
        for call, poll in list(self._pending.items()):
            call.finished = None
            if poll is not None:
                poll.done = True
            elif call.handle is not None:
                call.handle.interface.drop(call)
        self._pending.clear()
        for handle in list(self.handles.values()):
            self.close(handle)
        self.desk.forget(self)

    def give_up(self, call: ApiCall) -> None:
        """End a call that can no longer complete."""
        poll = self._pending.get(call)
        if poll is not None:
            poll.done = True
        elif call.handle is not None:
            call.handle.interface.drop(call)
        call.finish(self.desk.now, mc.MCERR_TIMEOUT)

    def open(self, mode: int) -> Handle:
        """Open a handle; raise Refused if the interface does not allow it."""
        kind = self._checked_mode(mode, None)
        number = next(number for number in range(1, MAX_HANDLES + 2) if number not in self.handles)
        if number > MAX_HANDLES:
            raise CallRefused(mc.MCERR_OUT_OF_HANDLES)
        handle = Handle(self, number, mode, self.desk.interface(kind == mc.MC_OPEN_ASCII))
        self.handles[number] = handle
        self.desk.handles.append(handle)
        return handle

    def reopen(self, handle: Handle, mode: int) -> None:
        """Change the mode of a handle."""
        kind = self._checked_mode(mode, handle)
        self._release(handle)
        handle.mode, handle.interface = mode, self.desk.interface(kind == mc.MC_OPEN_ASCII)

    def close(self, handle: Handle) -> None:
        """Close a handle, discard its block, and release its reservation."""
        self._release(handle)
        del self.handles[handle.number]
        self.desk.handles.remove(handle)

    def _release(self, handle: Handle) -> None:
        interface = handle.interface
        if interface.block is not None and interface.block.handle is handle:
            interface.block = None
        if interface.owner is handle:
            interface.owner = None

    def _checked_mode(self, mode: int, own_handle: Handle | None) -> int:
        """Return the kind of interface that a mode requests."""
        kind = mode & (mc.MC_OPEN_ASCII | mc.MC_OPEN_BINARY)
        if kind not in (mc.MC_OPEN_ASCII, mc.MC_OPEN_BINARY) or mode & ~(
            kind | mc.MC_OPEN_EXCLUSIVE | mc.MC_THREAD
        ):
            raise CallRefused(mc.MCERR_UNSUPPORTED_MODE)
        others = [each for each in self.desk.handles if each is not own_handle and each.mode & kind]
        if others and (mode & mc.MC_OPEN_EXCLUSIVE or any(each.is_exclusive for each in others)):
            raise CallRefused(mc.MCERR_OPEN_EXCLUSIVE)
        return kind

    # ----------------------------------------------------------------------------------------------- calls

    def call(
        self,
        name: str,
        number: int,
        arguments: Sequence[Value | None],
        finished: Callable[[ApiCall], None] | None = None,
    ) -> ApiCall:
        """Begin a call with the flattened inputs of the table; it may complete at once.

        `number` is the handle. Raises BadCall if the table has no function with this name and these arguments.
        """
        function = function_named(name)
        call = ApiCall(function, number, tuple(arguments), self.desk.now)
        call.host = self.number
        self._pending[call] = None

        def done(ended: ApiCall) -> None:
            self._pending.pop(ended, None)
            if self.desk.record is not None:
                self.desk.record(ended)
            if finished is not None:
                finished(ended)

        call.finished = done
        try:
            self._begin(call, CallInputs(function, call.arguments))
        except BadCall:
            self._pending.pop(call, None)
            raise
        except CallRefused as refused:
            self._fail(call, refused.code)
        except (Fault, Rejected) as trouble:
            self._fail(call, code_of(trouble))
        return call

    def _fail(self, call: ApiCall, code: int) -> None:
        call.value = call.function.failed(code)
        call.finish(self.desk.now, code)

    def _begin(self, call: ApiCall, given: CallInputs) -> None:
        function = call.function
        name = function.name
        if function.has_handle:
            call.handle = self.handles.get(call.number)
            if call.handle is None:
                raise CallRefused(mc.MCERR_CONTROLLER)
        if function.unsupported:
            self.desk.unsupported(name, function.unsupported)
            raise CallRefused(mc.MCERR_NOTSUPPORTED)
        if given.null:
            raise CallRefused(mc.MCERR_RANGE)
        if not all(isfinite(each) for each in given.flat if isinstance(each, float)):
            raise CallRefused(mc.MCERR_RANGE)
        self._check_axes(function, given)
        if name in AT_ONCE:
            self._at_once(call, given)
        elif name in POLLS:
            self._poll(call, given)
        elif name in QUERIES:
            self._read(call, given)
        else:
            assert call.handle is not None
            self._command(call, commands_for(call.handle.interface, function, given.by_name))

    def _check_axes(self, function: ApiFunction, given: CallInputs) -> None:
        for name in AXES:
            number = given.by_name.get(name)
            if number is None or (name == "caxis" and given.by_name["mode"] != mc.MC_MODE_CONTOUR):
                continue
            if number == 0:
                if not (name == "axis" and _takes_all_axes(function)):
                    raise CallRefused(mc.MCERR_ALL_AXES)
            elif number not in self.desk.board.axes:
                raise CallRefused(mc.MCERR_AXIS_NUMBER)

    def _at_once(self, call: ApiCall, given: CallInputs) -> None:
        found = AT_ONCE[call.function.name](self, call, **given.by_name)
        if found is None:
            call.finish(self.desk.now)
        elif found:
            self._submit(call)

    def _poll(self, call: ApiCall, given: CallInputs) -> None:
        ready, due, seconds, finish = POLLS[call.function.name](self, call, **given.by_name)
        if ready() or seconds <= 0.0:
            finish(ready())
            call.finish(self.desk.now)
            return

        def end(is_ready: bool) -> None:
            finish(is_ready)
            call.finish(self.desk.now)

        poll = Poll(self.desk.board, ready, due, self.desk.now + seconds, end)
        self._pending[call] = poll
        self.desk.console.start(poll)

    def _read(self, call: ApiCall, given: CallInputs) -> None:
        """Read at once if the interface is idle, else after its queued calls.

        Reading at once takes no machine time.
        """
        query = QUERIES[call.function.name]
        handle = call.handle
        assert handle is not None
        by_name = given.by_name

        def read(task: CommandTask, _: Command | None) -> None:
            try:
                found = query(task, **by_name)
            except CallRefused as refused:
                call.code = refused.code
                return
            if call.function.is_value:
                call.value = found
            else:
                call.outputs = found if isinstance(found, tuple) else (found,)

        if handle.interface.occupied or handle.interface.owner not in (None, handle):
            call.line = line([own(call.function.name, read)])
            self._submit(call)
        else:
            read(handle.interface, None)
            call.finish(self.desk.now)

    def _command(self, call: ApiCall, commands: list[Command]) -> None:
        """Carry out commands, or add them to the open block."""
        assert call.handle is not None
        interface = call.handle.interface
        if call.function.is_value:
            call.value = 1
        if interface.block is not None:
            interface.block.add(commands)
            call.finish(self.desk.now)
        elif commands:
            call.line = line(commands)
            self._submit(call)
        else:
            call.finish(self.desk.now)

    def _submit(self, call: ApiCall) -> None:
        handle = call.handle
        assert handle is not None
        handle.interface.submit(call)
        if handle.timeout > 0.0:
            end = self.desk.now + handle.timeout
            interface = handle.interface

            def give_up(_: bool) -> None:
                if not call.done:
                    expire(call, interface, self.desk.now)

            self.desk.console.start(Poll(self.desk.board, lambda: call.done, lambda: INFINITY, end, give_up))


class CallInputs:
    """The inputs of a call: flattened, and by argument name.

    `null` is True if one of them is a NULL pointer.
    """

    __slots__ = ("by_name", "flat", "null")

    def __init__(self, function: ApiFunction, flat: tuple[Value | None, ...]) -> None:
        self.flat = flat
        self.null = False
        self.by_name: dict[str, Any] = {}
        at = 0
        for each in function.arguments:
            if each.out:
                # Of a result only whether there is room for it is sent.
                self.null = self.null or (self._next(at) is None and not each.optional)
                at += 1
                continue
            at = self._take(each, at)
        if at != len(flat):
            raise BadCall(f"{function.name} has {at} arguments, not {len(flat)}")

    def _next(self, at: int) -> Value | None:
        if at >= len(self.flat):
            raise BadCall("arguments are missing")
        return self.flat[at]

    def _take(self, each: Argument, at: int) -> int:
        value = self._next(at)
        if each.kind in STRUCTURES or each.size:
            if value is None:
                self.null = True
                return at + 1
            if not isinstance(value, int) or not 0 <= value <= len(self.flat) - at - 1:
                raise BadCall(f"{each.name} needs the number of its values")
            found = self.flat[at + 1 : at + 1 + value]
            if each.kind in STRUCTURES:
                structure = STRUCTURES[each.kind]
                found = found + (0,) * (len(structure.names()) - len(found))
                if value > len(structure.names()) or not all(isinstance(one, (int, float)) for one in found):
                    raise BadCall(f"{each.kind} does not have these values")
            self.by_name[each.name] = found
            return at + 1 + value
        if value is None and each.kind not in BITS and each.kind != "d":
            self.null = self.null or not each.optional
            self.by_name[each.name] = None
        else:
            self.by_name[each.name] = _converted(each, value)
        return at + 1


def _converted(each: Argument, value: Value | None) -> Value:
    """Return a value converted to its argument's type, wrapped as in C.

    Raises BadCall if it cannot be converted.
    """
    if each.kind in BITS:
        if not isinstance(value, int):
            raise BadCall(f"{each.name} is an integer")
        return wrapped(value, BITS[each.kind])
    if each.kind == "d":
        if not isinstance(value, (int, float)):
            raise BadCall(f"{each.name} is a number")
        return float(value)
    if each.kind == "str":
        if not isinstance(value, str):
            raise BadCall(f"{each.name} is a text")
        return value
    assert value is not None
    return value


def wrapped(value: int, bits: int) -> int:
    """Wrap an integer to `-bits` (signed) or `bits` (unsigned) bits."""
    size = abs(bits)
    value &= (1 << size) - 1
    return value - (1 << size) if bits < 0 and value >> (size - 1) else value


def _takes_all_axes(function: ApiFunction) -> bool:
    if any(each.takes_all for each in function.arguments):
        return True
    first = function.mccl.partition(",")[0]
    if function.name in QUERIES or len(first) < 3 or first[0] != "a":
        return False
    return takes_all_axes(first[1:3])


def commands_for(interface: Interface, function: ApiFunction, given: dict[str, Any]) -> list[Command]:
    """Return the commands of a function; `given` has its arguments by name."""
    made = COMMANDS.get(function.name)
    if made is not None:
        return made(interface, **given)
    return [_by_column(function.mccl, given)]


def _by_column(mccl: str, given: dict[str, Any]) -> Command:
    head, _, parameter = mccl.rstrip("}").partition("{")
    axis: int = given["axis"] if head[0] == "a" else 0
    value: float | None = given[parameter] if parameter else None
    return command(head[-2:], axis, value)


def _to_standard_error(text: str) -> None:
    print(f"motionlang: {text}", file=sys.stderr)
