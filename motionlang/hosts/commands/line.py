"""`motionlang serve` with the line of a Mint controller, and optionally Modbus."""

from __future__ import annotations

from dataclasses import dataclass

from motionlang.cli.command import Refused
from motionlang.cli.complaints import complain
from motionlang.hosts.address import is_loopback, shown
from motionlang.hosts.commands.modbus import ServedMemory, remark_on_mapping
from motionlang.hosts.commands.options import cannot, remark, say, until_signal, warn
from motionlang.hosts.commands.output_queue import OutputQueue, dropped
from motionlang.hosts.mint.console import MintConsole
from motionlang.hosts.serve import Limits, LockStep, RealTime, Server
from motionlang.hosts.serve.modbus import ModbusServer
from motionlang.hosts.serve.outside import STEP, InTurn
from motionlang.hosts.serve.pace import ServerPace
from motionlang.hosts.serve.spy import Spy
from motionlang.kernel import Diagnostic, ProgramError, Rejected, Source
from motionlang.kernel.mint import VIRTUAL, named
from motionlang.kernel.tools import count_of


@dataclass
class ServedLine(ServedMemory):
    """The line of a Mint controller, and optionally Modbus."""

    def serve_line(self, source: Source | None, queues: list[OutputQueue]) -> int:
        """Serve until a signal; 1 if an interface fails.

        `queues` are those of standard output and standard error.
        """
        settings = self.settings()
        console = self._console(settings, source)
        pace = self._pace(console)
        limits, spy = Limits(hosts=self.max_hosts), Spy(remark, traffic=self.log)
        with Server(console, pace, limits=limits, spy=spy, complain=warn) as server:
            model = str(settings.get("controller.model", ""))
            modbus, status = None, 0
            try:
                opened = self.open_lines(server)
                if opened is not None:
                    modbus = self._open_modbus(server, console, pace, model)
                    self.greet(named(model) or VIRTUAL, len(console.machine.controller.axes))
                    say(opened)
                    if modbus is not None:
                        _say_modbus(modbus)
                        if source is not None:
                            remark_on_mapping(source, model, say)
                    until_signal(server)
                else:
                    status = 1
            except (OSError, UnicodeError) as error:
                assert self.modbus is not None
                cannot(f"cannot listen on {shown(*self.modbus)}", error)
                status = 1
            finally:
                if modbus is not None:
                    modbus.stop()
        if status == 0:
            served = count_of(server.served, "host")
            if modbus is not None:
                served += f", {count_of(modbus.requests, 'Modbus request')}"
            say(f"served {served}; machine time {console.now:.3f} s{dropped(queues)}\n")
        return status

    def _console(self, settings: dict[str, object], source: Source | None) -> MintConsole:
        try:
            console = MintConsole(
                settings,
                self.overrides(),
                complain=lambda found, text: complain(found, text, text.name),
            )
            if source is not None:
                console.load(source)
        except ProgramError as error:
            raise Refused(error.diagnostics, source=source, file=self.file) from None
        except Rejected as rejected:
            raise Refused([Diagnostic(rejected.code, rejected.message, hint=rejected.hint)]) from None
        return console

    def _open_modbus(
        self, lines: Server, console: MintConsole, pace: ServerPace, model: str
    ) -> ModbusServer | None:
        """Open the Modbus address, if one is given; raise OSError if that fails."""
        if self.modbus is None:
            return None

        def entered() -> None:
            pace.entered()
            console.touched()

        questions = InTurn(lines.wake, entered)
        questions.start(console.machine)
        lines.in_turn.append(questions.answer_next)
        server = self.modbus_server(questions, model, warn)
        server.start()
        return server

    def _pace(self, console: MintConsole) -> ServerPace:
        if self.clock == "lockstep":
            pace = LockStep(console, STEP if self.step is None else self.step, at_once=True)
            pace.entered()
            pace.work()  # the program begins before the first host connects
            return pace
        return RealTime(console, self.factor or 1.0)


def _say_modbus(server: ModbusServer) -> None:
    where = shown(server.host, server.port)
    say(f"listening on {where} (Modbus TCP)\n")
    if not is_loopback(server.host):
        warn(f"warning: any computer that can reach this one can write through {where}; there is no password")
