"""A served MCCL board on the command line: how it is made, its output and its end."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Refused, option
from motionlang.cli.complaints import complain
from motionlang.hosts.address import parse
from motionlang.hosts.commands.options import (
    Address,
    Addresses,
    Served,
    listen,
    remark,
    say,
    until_signal,
    warn,
)
from motionlang.hosts.commands.output_queue import OutputQueue, dropped
from motionlang.hosts.mcapi.call import ApiCall
from motionlang.hosts.mcapi.host import McapiHost
from motionlang.hosts.mcapi.session import McapiBoard
from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Limits, LockStep, RealTime, Server
from motionlang.hosts.serve.pace import STEP, ServerPace
from motionlang.hosts.serve.server import MakeHost
from motionlang.hosts.serve.spy import Spy
from motionlang.kernel import Diagnostic, Machine, Rejected, Source
from motionlang.kernel.mccl import written_for
from motionlang.kernel.tools import count_of


@dataclass
class ServedBoard(Served):
    """A served MCCL board."""

    title: ClassVar[str] = Addresses.title
    mcapi: Address | None = option(
        "HOST:PORT",
        "listen here for hosts that call PMC's library MCAPI",
        read=parse,
    )

    def serve_board(self, source: Source | None, queues: list[OutputQueue]) -> int:
        """Serve until a signal; 1 if an interface fails.

        `queues` are those of standard output and standard error.
        """
        server, console = server_of(self, source, Spy(remark, traffic=self.log))
        with server:
            board = console.board
            opened = self.open_lines(server)
            if opened is not None and self.mcapi is not None:
                line = listen(server, *self.mcapi, make=mcapi_hosts(server, console))
                opened = None if line is None else opened + line
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


def mcapi_hosts(
    server: Server, console: Console, record: Callable[[ApiCall], None] | None = None
) -> MakeHost:
    """Return a function that makes a host speaking MCAPI for each connection.

    `record` is called with every call.
    """
    board = McapiBoard(console, warn, record)
    return lambda number, channel: McapiHost(number, channel, board, server.limits, server.spy)
