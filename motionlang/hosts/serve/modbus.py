"""Modbus TCP server for the memory that a Mint program shares with its host.

Source: ABB AN00198. Element n of the comms array or of NetData occupies two holding registers: 2n, its low half,
and 2n + 1. Registers of elements that do not exist are answered with "illegal data address". Function codes: 3
and 4 read, 6, 16, 22 and 23 write, 43 identifies the device.

The server has its own thread and event loop. The run answers each request between two steps (`outside.py`).
The requests of a connection are answered in order, one at a time, so a client that sends ahead delays only
itself. Every frame has the header of Modbus TCP: transaction, protocol (0), length, unit. A server without a
unit of its own answers all units. A server with one answers that unit and those that mean the device itself (0
and 255). A frame for another unit or of another protocol is skipped. An invalid length ends the connection,
because the next frame could not be found.
"""

from __future__ import annotations

import asyncio
from asyncio import IncompleteReadError, StreamReader, StreamWriter
from collections.abc import Callable
from functools import partial
from socket import socket
from struct import pack, unpack
from threading import Event, Thread
from time import monotonic

from motionlang.hosts import address
from motionlang.hosts.serve.limits import Limits
from motionlang.hosts.serve.modbus_requests import (
    DEVICE_FAILURE,
    IDENTIFY,
    ILLEGAL_ADDRESS,
    Identity,
    Request,
    RequestRejected,
    exception,
    parse,
)
from motionlang.hosts.serve.outside import Closed, QuestionQueue
from motionlang.hosts.serve.refusals import Refusals
from motionlang.kernel.controller import HostMemory
from motionlang.kernel.version import __version__

# Bytes of the header, and the bounds of the length that it states: at least a unit and a function.
HEADER, MIN_FRAME, MAX_FRAME = 6, 2, 254
# Seconds of real time for the server's thread to start and to end, and for a client to take its answer at the
# end.
PATIENCE, FAREWELL = 10.0, 0.5
# The units that mean the device at the other end of a TCP connection, whatever its own.
THIS_DEVICE = (0, 255)


class ModbusPeer:
    """A client, with a flag for a request in progress and the time of the last one.

    The time is real time, s.
    """

    def __init__(self, writer: StreamWriter) -> None:
        self.writer, self.busy, self.last_received = writer, False, monotonic()


class ModbusServer:
    """A server that listens from `start` to `stop`; `port` is the actual port.

    At most `limits.hosts` clients are connected. A further client replaces the one that has been silent longest, if
    that is at least `limits.idle` seconds. Otherwise the new client is rejected and `complain` is called. `remark` is
    called with a line for each client that connects or leaves. `unit` is the only unit that is answered, None for
    all. `start` raises OSError if the address is not available.
    """

    def __init__(
        self,
        outside: QuestionQueue,
        host: str,
        port: int,
        *,
        limits: Limits | None = None,
        unit: int | None = None,
        identity: Identity | None = None,
        complain: Callable[[str], None] = lambda text: None,
        remark: Callable[[str], None] = lambda text: None,
    ) -> None:
        self._remark = remark
        self._outside, self.host, self.port = outside, host, port
        self._unit = unit
        self._identity = identity or Identity("motionlang", "Virtual Controller", __version__)
        self._limits = limits or Limits()
        self._refusals = Refusals(complain)
        self.requests = 0
        self._connections: dict[asyncio.Task[None], ModbusPeer] = {}
        self._ready = Event()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._over: asyncio.Event | None = None
        self._thread: Thread | None = None

    def start(self) -> None:
        """Start listening; return when clients can connect."""
        try:
            listener = address.listen(self.host, self.port)
        except OSError as error:
            where = address.shown(self.host, self.port)
            raise OSError(error.errno, error.strerror or str(error), where) from None
        self.port = listener.getsockname()[1]
        run = partial(asyncio.run, self._listen(listener))
        self._thread = Thread(target=run, name="modbus", daemon=True)
        self._thread.start()
        self._ready.wait(PATIENCE)

    def stop(self) -> None:
        """Answer no more requests, close every connection and end the thread."""
        self._outside.close()
        if self._loop is not None and self._over is not None and self._thread is not None:
            self._loop.call_soon_threadsafe(self._over.set)
            self._thread.join(PATIENCE)

    async def _listen(self, listener: socket) -> None:
        self._loop, self._over = asyncio.get_running_loop(), asyncio.Event()
        server = await asyncio.start_server(self._accept, sock=listener)
        self._ready.set()
        await self._over.wait()
        server.close()
        self._refusals.flush()
        await self._end()

    async def _end(self) -> None:
        """Let clients read their answers before closing.

        The time is short, because the run no longer answers.
        """
        for connection in self._connections.values():
            if not connection.busy:
                connection.writer.close()
        if self._connections:
            _, late = await asyncio.wait(self._connections, timeout=FAREWELL)
            for task in late:
                task.cancel()

    # ------------------------------------------------------------------------------------------- connections

    async def _accept(self, reader: StreamReader, writer: StreamWriter) -> None:
        name = address.shown(*writer.get_extra_info("peername")[:2])
        if len(self._connections) >= self._limits.hosts and not self._make_room():
            self._refuse(f"{name} was turned away: {self._limits.hosts} clients are connected already")
            writer.close()
            return
        task = asyncio.current_task()
        assert task is not None
        connection = self._connections[task] = ModbusPeer(writer)
        self._remark(f"Modbus client {name} connected\n")
        try:
            while await self._answer_next(reader, connection):
                pass
        except (OSError, IncompleteReadError, asyncio.CancelledError):
            pass
        finally:
            self._connections.pop(task, None)
            writer.close()
            self._remark(f"Modbus client {name} has left\n")

    def _make_room(self) -> bool:
        """Disconnect the longest-silent client if it is idle; it may reconnect."""
        silent = [(each.last_received, task) for task, each in self._connections.items() if not each.busy]
        task = self._limits.to_drop(silent, monotonic())
        if task is not None:
            del self._connections[task]
            task.cancel()
        return task is not None

    def _refuse(self, text: str) -> None:
        scheduled = self._refusals.left is not None
        self._refusals.add(text)
        left = self._refusals.left
        if left is not None and not scheduled:
            asyncio.get_running_loop().call_later(left, self._refusals.flush)

    # -------------------------------------------------------------------------------------------- requests

    async def _answer_next(self, reader: StreamReader, connection: ModbusPeer) -> bool:
        """Answer a client's next request; return False if the next frame cannot be found."""
        transaction, protocol, length = unpack(">HHH", await reader.readexactly(HEADER))
        if not MIN_FRAME <= length <= MAX_FRAME:
            return False
        unit, *_ = request = await reader.readexactly(length)
        connection.last_received = monotonic()
        if protocol == 0 and (self._unit is None or unit == self._unit or unit in THIS_DEVICE):
            connection.busy = True
            answer = await self._answer(request[1:])
            connection.writer.write(pack(">HHHB", transaction, 0, len(answer) + 1, unit) + answer)
            connection.busy = False
            await connection.writer.drain()
        return self._over is not None and not self._over.is_set()

    async def _answer(self, data: bytes) -> bytes:
        """Return the response to a request, or the exception that rejects it."""
        try:
            if data[0] == IDENTIFY:
                self.requests += 1
                return self._identity.answer(data)
            request = parse(data)
            self.requests += 1
            question = self._outside.ask(lambda: self._exchange(request))
            found = await asyncio.wrap_future(question)
        except RequestRejected as rejected:
            return exception(data[0], rejected.code)
        except Closed:
            return exception(data[0], DEVICE_FAILURE)
        assert isinstance(found, list)
        return request.answer(found)

    def _exchange(self, request: Request) -> list[int]:
        """Write, then read, and return the registers read.

        Raises Rejected, without writing, if a register does not exist.
        """
        assert self._outside.machine is not None
        memory: HostMemory = self._outside.machine.host
        area = memory.mapping
        if not all(memory.has_registers(area, first, count) for first, count in request.spans):
            raise RequestRejected(ILLEGAL_ADDRESS)
        values = request.values
        if request.masks is not None:
            keep, add = request.masks
            (old,) = memory.registers(area, request.into, 1)
            values = (old & keep | add & ~keep,)
        if values:
            memory.write_registers(area, request.into, values)
        return memory.registers(area, request.start, request.quantity)
