"""`motionlang serve FILE --modbus`: the comms memory of a Mint program on Modbus."""

from __future__ import annotations

import signal
import sys
from math import inf
from typing import TYPE_CHECKING

from motionlang import __version__
from motionlang.cli.complaints import complain
from motionlang.cli.output_queue import dropped
from motionlang.cli.serve_hosts import cannot, remark, warn
from motionlang.controller.io.host_memory import PRODUCTS, product
from motionlang.execution import end_of, run
from motionlang.mint.keywords.identity import VIRTUAL
from motionlang.mint.models import named
from motionlang.serve import Limits
from motionlang.serve.address import is_loopback, shown
from motionlang.serve.outside import STEP, LockStep, RealTime
from motionlang.views.terminal import shower

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable

    from motionlang.cli.output_queue import OutputQueue
    from motionlang.result import Run
    from motionlang.serve.modbus import ModbusServer
    from motionlang.serve.outside import Outside
    from motionlang.source import Source


def serve_modbus(
    args: argparse.Namespace,
    source: Source,
    settings: dict[str, object],
    overrides: dict[str, float | str],
    queues: list[OutputQueue],
) -> int:
    """Run the program until it ends or a signal arrives; 1 if it cannot be run."""
    host, port = args.modbus
    outside = _outside(args)
    server = modbus_server(args, outside, str(settings.get("controller.model", "")), warn)
    try:
        server.start()
    except (OSError, UnicodeError) as error:
        cannot(f"cannot listen on {shown(host, port)}", error, "choose another port")
        return 1
    _greet(server, source, str(settings.get("controller.model", "")))
    before = signal.signal(signal.SIGTERM, signal.default_int_handler)  # a normal end, like Ctrl-C
    try:
        result = run(
            source,
            dialect="mint",
            machine=settings,
            until=end_of(settings) if "run.until" in settings else inf,
            overrides=overrides,
            show=_show,
            outside=outside,
        )
    finally:
        signal.signal(signal.SIGTERM, before)
        outside.close()
        server.stop()
    return _farewell(result, server, args.file, queues)


def modbus_server(
    args: argparse.Namespace, outside: Outside, model: str, complain: Callable[[str], None]
) -> ModbusServer:
    """Return the Modbus server of the command line, which identifies as the model."""
    from motionlang.serve.modbus import ModbusServer
    from motionlang.serve.modbus_requests import Identity

    host, port = args.modbus
    return ModbusServer(
        outside,
        host,
        port,
        limits=Limits(hosts=args.max_hosts),
        unit=args.unit,
        identity=Identity("motionlang", named(model) or VIRTUAL, __version__),
        complain=complain,
        remark=remark,
    )


def _outside(args: argparse.Namespace) -> Outside:
    if args.clock == "lockstep":
        return LockStep(STEP if args.step is None else args.step)
    return RealTime(args.factor or 1.0)


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
    remark(f"answered {server.requests} requests; machine time {result.time:.3f} s{dropped(queues)}\n")
    return int(any(each.severity == "error" for each in troubles))


def _show(text: str) -> None:
    shower(sys.stdout)(text)
    sys.stdout.flush()
