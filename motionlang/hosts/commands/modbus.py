"""`motionlang serve FILE --modbus`: the comms memory of a Mint program on Modbus."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from typing import ClassVar

from motionlang.cli.command import WrongOption, option
from motionlang.cli.complaints import complain
from motionlang.cli.readers import whole
from motionlang.hosts.address import is_loopback, parse, shown
from motionlang.hosts.commands.options import Address, Served, cannot, remark, warn
from motionlang.hosts.commands.output_queue import OutputQueue, dropped
from motionlang.hosts.serve import Limits
from motionlang.hosts.serve.modbus import ModbusServer
from motionlang.hosts.serve.modbus_requests import Identity
from motionlang.hosts.serve.outside import STEP, LockStepQueue, QuestionQueue, RealTimeQueue
from motionlang.kernel import Run, Source, end_of, run
from motionlang.kernel.controller import PRODUCTS, product
from motionlang.kernel.mint import VIRTUAL, named
from motionlang.kernel.tools import count_of
from motionlang.kernel.version import __version__
from motionlang.views.terminal import shower


@dataclass
class ServedMemory(Served):
    """The comms memory of a Mint program on Modbus."""

    title: ClassVar[str] = "Modbus"
    modbus: Address | None = option(
        "HOST:PORT",
        "serve the memory of a Mint program to Modbus TCP clients",
        read=parse,
    )
    unit: int | None = option(
        "N",
        "the unit that is answered, besides 0 and 255, which mean any (all)",
        read=whole("a Modbus unit from 1 to 247", 1, 247),
    )

    def check(self) -> None:
        super().check()
        if self.unit is not None and self.modbus is None:
            raise WrongOption("--unit needs --modbus HOST:PORT")

    def serve_modbus(self, source: Source, queues: list[OutputQueue]) -> int:
        """Run the program until it ends or a signal arrives; 1 if it cannot be run."""
        settings, outside = self.settings(), self._outside()
        model = str(settings.get("controller.model", ""))
        server = self.modbus_server(outside, model, warn)
        try:
            server.start()
        except (OSError, UnicodeError) as error:
            assert self.modbus is not None
            cannot(f"cannot listen on {shown(*self.modbus)}", error, "choose another port")
            return 1
        _greet(server, source, model)
        before = signal.signal(signal.SIGTERM, signal.default_int_handler)  # a normal end, like Ctrl-C
        try:
            result = run(
                source,
                dialect="mint",
                machine=settings,
                until=end_of(settings) if "run.until" in settings else inf,
                overrides=self.overrides(),
                show=_show,
                outside=outside,
            )
        finally:
            signal.signal(signal.SIGTERM, before)
            server.stop()
        return _farewell(result, server, self.file, queues)

    def modbus_server(
        self, outside: QuestionQueue, model: str, complain: Callable[[str], None]
    ) -> ModbusServer:
        """Return the Modbus server of the command line, which identifies as the model."""
        assert self.modbus is not None
        return ModbusServer(
            outside,
            *self.modbus,
            limits=Limits(hosts=self.max_hosts),
            unit=self.unit,
            identity=Identity("motionlang", named(model) or VIRTUAL, __version__),
            complain=complain,
            remark=remark,
        )

    def _outside(self) -> QuestionQueue:
        if self.clock == "lockstep":
            return LockStepQueue(STEP if self.step is None else self.step)
        return RealTimeQueue(self.factor or 1.0)


def _greet(server: ModbusServer, source: Source, model: str) -> None:
    where = shown(server.host, server.port)
    remark(f"listening on {where} (Modbus TCP); Ctrl-C ends it\n")
    remark_on_mapping(source, model, remark)
    if not is_loopback(server.host):
        remark(
            f"warning: any computer that can reach this one can write through {where}; there is no password\n"
        )


def remark_on_mapping(source: Source, model: str, say: Callable[[str], None]) -> None:
    """Say which memory clients see, unless the program selects the mapping."""
    if PRODUCTS[product(model)] == "netdata" and "modbusparameter" not in source.text.lower():
        mapping = "MODBUSPARAMETER(_busETHERNET, _mpREGISTER_MAPPING) = _rmCOMMS_ARRAY"
        say(f"clients see NETINTEGER and NETFLOAT; {mapping} in the program shows them COMMS\n")


def _farewell(result: Run, server: ModbusServer, file: str, queues: list[OutputQueue]) -> int:
    troubles = [each for each in result.diagnostics if each.code != "interrupted"]
    complain(troubles, result.source, file)
    remark(
        f"answered {count_of(server.requests, 'request')}; machine time {result.time:.3f} s{dropped(queues)}\n"
    )
    return int(any(each.severity == "error" for each in troubles))


def _show(text: str) -> None:
    shower(sys.stdout)(text)
    sys.stdout.flush()
