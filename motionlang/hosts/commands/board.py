"""A served MCCL board on the command line: how it is made, its output and its end."""

from __future__ import annotations

from dataclasses import dataclass

from motionlang.cli.command import Refused
from motionlang.cli.complaints import complain
from motionlang.hosts.commands.options import Served, remark, say, until_signal, warn
from motionlang.hosts.commands.output_queue import OutputQueue, dropped
from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Limits, LockStep, RealTime, Server
from motionlang.hosts.serve.pace import STEP, ServerPace
from motionlang.hosts.serve.spy import Spy
from motionlang.kernel import Diagnostic, Machine, Rejected, Source
from motionlang.kernel.mccl import written_for
from motionlang.kernel.tools import count_of


@dataclass
class ServedBoard(Served):
    """A served MCCL board."""

    def open_board(self, server: Server, console: Console) -> str | None:
        """Open the lines for hosts and return what to print; None if one cannot be opened."""
        return self.open_lines(server)

    def serve_board(self, source: Source | None, queues: list[OutputQueue]) -> int:
        """Serve until a signal; 1 if an interface fails.

        `queues` are those of standard output and standard error.
        """
        server, console = server_of(self, source, Spy(remark, traffic=self.log))
        with server:
            board = console.board
            opened = self.open_board(server, console)
            if opened is None:
                return 1
            self.greet(board.model.title, len(board.numbers))
            say(opened)
            until_signal(server)
        say(f"served {count_of(server.served, 'host')}; machine time {console.now:.3f} s{dropped(queues)}\n")
        return 0


def server_of(served: Served, source: Source | None, spy: Spy | None) -> tuple[Server, Console]:
    """Return server and console of a board, after the file has been sent to it.

    Refused if the board cannot be made.
    """
    settings, overrides = served.settings(), served.overrides()
    if source is not None:
        settings.setdefault("controller.model", written_for(source.name))
    try:
        console = Console(Machine(settings, first_axis=1, overrides=overrides))
        download = console.download(
            source or Source("", ""), say, lambda diagnostic: complain([diagnostic], source, served.file)
        )
        download.override(overrides)
    except Rejected as rejected:
        raise Refused([Diagnostic(rejected.code, rejected.message, hint=rejected.hint)]) from None
    limits = Limits(hosts=served.max_hosts)
    return Server(console, _pace(served, console), limits=limits, spy=spy, complain=warn), console


def _pace(served: Served, console: Console) -> ServerPace:
    if served.clock == "lockstep":
        return LockStep(console, STEP if served.step is None else served.step)
    return RealTime(console, served.factor or 1.0)
