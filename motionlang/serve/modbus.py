"""A Modbus TCP server in front of the memory that a Mint program shares with its host (ABB AN00198).

Element n of the comms array or of NetData is the holding registers 2n, its low half, and 2n + 1. Registers of elements
that do not exist are answered with "illegal data address". Function codes: 3 and 4 read, 6, 16, 22 and 23 write.
"""

from __future__ import annotations

import asyncio
import logging
from threading import Event, Thread
from typing import TYPE_CHECKING

from motionlang.extras import need
from motionlang.serve.outside import Closed

if TYPE_CHECKING:
    from typing import Any

    from motionlang.controller.io.host_memory import HostMemory
    from motionlang.serve.outside import Outside

REGISTER_FUNCTIONS = frozenset((3, 4, 6, 16, 22, 23))
REGISTERS = 2000
# Wall seconds that the server's thread has to start and to end.
PATIENCE = 10.0


class ModbusServer:
    """Listens at an address from `start` to `stop`, in a thread of its own; `port` is the one it got.

    OSError from `start` where the address cannot be had, MissingExtra where pymodbus is not installed.
    """

    def __init__(self, outside: Outside, host: str, port: int) -> None:
        self._outside, self.host, self.port = outside, host, port
        self.requests = 0
        self._asked = 0  # requests that have no answer yet
        self._ready = Event()
        self._trouble: Exception | None = None
        self._loop: asyncio.AbstractEventLoop | None = None
        self._server: Any = None
        self._thread: Thread | None = None

    def start(self) -> None:
        """Listen; returns when clients can connect."""
        need("Modbus", "pymodbus")
        logging.getLogger("pymodbus").setLevel(logging.CRITICAL)  # a client that is wrong is told so, not we
        self._thread = Thread(target=self._serve, name="modbus", daemon=True)
        self._thread.start()
        self._ready.wait(PATIENCE)
        if self._trouble is not None:
            raise self._trouble

    def stop(self) -> None:
        """Close every connection and end the thread."""
        if self._loop is not None and self._server is not None and self._thread is not None:
            asyncio.run_coroutine_threadsafe(self._end(), self._loop)
            self._thread.join(PATIENCE)

    def _serve(self) -> None:
        try:
            asyncio.run(self._listen())
        except OSError as error:
            self._trouble = error
        finally:
            self._ready.set()

    async def _listen(self) -> None:
        from pymodbus.server import ModbusTcpServer
        from pymodbus.simulator import DataType, SimData, SimDevice

        registers = SimData(0, count=REGISTERS, values=0, datatype=DataType.REGISTERS)
        device = SimDevice(id=0, simdata=[registers], action=self._action)
        self._loop = asyncio.get_running_loop()
        self._server = ModbusTcpServer(device, address=(self.host, self.port))
        if not await self._server.listen():
            raise OSError(f"{self.host}:{self.port} cannot be listened at")
        self.port = self._server.transport.sockets[0].getsockname()[1]
        self._ready.set()
        await self._server.serving

    async def _end(self) -> None:
        """Let every client have its answer first; none takes long, as the run answers no more."""
        while self._asked:
            await asyncio.sleep(0)
        await self._server.shutdown()

    async def _action(
        self,
        function: int,
        start: int,
        address: int,
        count: int,
        registers: list[int],
        values: list[int] | list[bool] | None,
    ) -> Any:
        """One request of a client: answered by the run, with what its memory holds."""
        from pymodbus.constants import ExcCodes

        if function not in REGISTER_FUNCTIONS:
            return ExcCodes.ILLEGAL_FUNCTION
        self.requests += 1
        self._asked += 1
        try:
            question = self._outside.ask(lambda: self._exchange(address, count, values))
            found = await asyncio.wrap_future(question)
        except Closed:
            return ExcCodes.DEVICE_FAILURE
        finally:
            self._asked -= 1
        if found is None:
            return ExcCodes.ILLEGAL_ADDRESS
        registers[address - start : address - start + count] = found  # type: ignore[call-overload]
        return None

    def _exchange(self, address: int, count: int, values: list[int] | list[bool] | None) -> list[int] | None:
        """Write where there are values, then read; None where there are no such registers."""
        assert self._outside.machine is not None
        memory: HostMemory = self._outside.machine.host
        if not memory.has_registers(memory.mapping, address, count):
            return None
        if values is not None:
            memory.write_registers(memory.mapping, address, list(values))
        return memory.registers(memory.mapping, address, count)
