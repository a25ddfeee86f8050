"""`motionlang serve` with the line of a Mint controller, and optionally Modbus."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain
from motionlang.cli.output_queue import dropped
from motionlang.cli.serve_hosts import cannot, greet, open_lines, remark, say, until_signal, warn
from motionlang.cli.serve_modbus import modbus_server, remark_on_mapping
from motionlang.controller.faults import Rejected
from motionlang.errors import Diagnostic, ProgramError, count_of
from motionlang.mint.hosts.console import MintConsole
from motionlang.mint.keywords.identity import VIRTUAL
from motionlang.mint.models import named
from motionlang.serve import Limits, LockStep, RealTime, Server
from motionlang.serve.address import is_loopback, shown
from motionlang.serve.outside import STEP, InTurn
from motionlang.serve.spy import Spy

if TYPE_CHECKING:
    import argparse

    from motionlang.cli.output_queue import OutputQueue
    from motionlang.serve.modbus import ModbusServer
    from motionlang.serve.pace import Pace
    from motionlang.source import Source


def serve_line(
    args: argparse.Namespace,
    source: Source | None,
    settings: dict[str, object],
    overrides: dict[str, float | str],
    queues: list[OutputQueue],
) -> int:
    """Serve until a signal; 1 if the program or an interface fails.

    `queues` are those of standard output and standard error.
    """
    file = args.file or ""
    try:
        console = MintConsole(
            settings,
            overrides,
            complain=lambda found, text: complain(found, text, text.name),
        )
        if source is not None:
            console.load(source)
    except ProgramError as error:
        complain(error.diagnostics, source, file)
        return 1
    except Rejected as rejected:
        complain([Diagnostic(rejected.code, rejected.message, hint=rejected.hint)], None, "")
        return 1
    pace = _pace(args, console)
    limits, spy = Limits(hosts=args.max_hosts), Spy(remark, traffic=args.log)
    with Server(console, pace, limits=limits, spy=spy, complain=warn) as server:
        model = str(settings.get("controller.model", ""))
        modbus, status = None, 0
        try:
            opened = open_lines(server, args)
            if opened is not None:
                modbus = _open_modbus(args, server, console, pace, model)
                greet(args, named(model) or VIRTUAL, len(console.machine.controller.axes))
                say(opened)
                if modbus is not None:
                    _say_modbus(modbus.server)
                    if source is not None:
                        remark_on_mapping(source, model, say)
                until_signal(server)
            else:
                status = 1
        except (OSError, UnicodeError) as error:
            cannot(f"cannot listen on {shown(*args.modbus)}", error)
            status = 1
        finally:
            if modbus is not None:
                modbus.close()
    if status == 0:
        served = count_of(server.served, "host")
        if modbus is not None:
            served += f", {count_of(modbus.server.requests, 'Modbus request')}"
        say(f"served {served}; machine time {console.now:.3f} s{dropped(queues)}\n")
    return status


class _Modbus:
    """A Modbus server whose requests are answered in the thread of the line server."""

    def __init__(self, server: ModbusServer, questions: InTurn) -> None:
        self.server, self._questions = server, questions

    def close(self) -> None:
        self._questions.close()
        self.server.stop()


def _open_modbus(
    args: argparse.Namespace, lines: Server, console: MintConsole, pace: Pace, model: str
) -> _Modbus | None:
    """Open the Modbus address, if one is given; raise OSError if that fails."""
    if args.modbus is None:
        return None

    def entered() -> None:
        pace.entered()
        console.touched()

    questions = InTurn(lines.wake, entered)
    questions.start(console.machine)
    lines.in_turn.append(questions.answer_all)
    server = modbus_server(args, questions, model, warn)
    server.start()
    return _Modbus(server, questions)


def _say_modbus(server: ModbusServer) -> None:
    where = shown(server.host, server.port)
    say(f"listening on {where} (Modbus TCP)\n")
    if not is_loopback(server.host):
        warn(f"warning: any computer that can reach this one can write through {where}; there is no password")


def _pace(args: argparse.Namespace, console: MintConsole) -> Pace:
    if args.clock == "lockstep":
        pace = LockStep(console, STEP if args.step is None else args.step, at_once=True)
        pace.entered()
        pace.work()  # the program begins before the first host connects
        return pace
    return RealTime(console, args.factor or 1.0)
