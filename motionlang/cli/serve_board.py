"""A served MCCL board on the command line: how it is made, its output and its end."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain
from motionlang.cli.output_queue import dropped
from motionlang.cli.serve_hosts import greet, listen, open_lines, remark, say, until_signal, warn
from motionlang.controller.faults import Rejected
from motionlang.errors import Diagnostic
from motionlang.lang.machine.machine import Machine
from motionlang.mccl.hosts.console import Console
from motionlang.mccl.models import written_for
from motionlang.serve import Limits, LockStep, RealTime, Server
from motionlang.serve.pace import STEP
from motionlang.serve.spy import Spy
from motionlang.source import Source

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable

    from motionlang.cli.output_queue import OutputQueue
    from motionlang.mcapi.call import Call
    from motionlang.serve.pace import Pace
    from motionlang.serve.server import MakeHost


def serve_board(
    args: argparse.Namespace,
    source: Source | None,
    settings: dict[str, object],
    overrides: dict[str, float | str],
    queues: list[OutputQueue],
) -> int:
    """Serve until a signal; 1 if the board or an interface fails.

    `queues` are those of standard output and standard error.
    """
    made = server_of(args, source, settings, overrides, Spy(remark, traffic=args.log))
    if made is None:
        return 1
    server, console = made
    with server:
        board = console.board
        opened = open_lines(server, args)
        if opened is not None and args.mcapi is not None:
            line = listen(server, *args.mcapi, make=mcapi_hosts(server, console))
            opened = None if line is None else opened + line
        if opened is None:
            return 1
        greet(args, board.model.title, len(board.numbers))
        say(opened)
        until_signal(server)
    say(f"served {server.served} hosts; machine time {console.now:.3f} s{dropped(queues)}\n")
    return 0


def server_of(
    args: argparse.Namespace,
    source: Source | None,
    settings: dict[str, object],
    overrides: dict[str, float | str],
    spy: Spy | None,
) -> tuple[Server, Console] | None:
    """Return server and console of a board, after the file has been sent to it.

    None if the board cannot be made.
    """
    if source is not None:
        settings.setdefault("controller.model", written_for(source.name))
    try:
        console = Console(Machine(settings, first_axis=1, overrides=overrides))
        download = console.download(
            source or Source("", ""), say, lambda diagnostic: complain([diagnostic], source, args.file or "")
        )
        download.override(overrides)
    except Rejected as rejected:
        complain([Diagnostic(rejected.code, rejected.message, hint=rejected.hint)], None, "")
        return None
    limits = Limits(hosts=args.max_hosts)
    return Server(console, _pace(args, console), limits=limits, spy=spy, complain=warn), console


def _pace(args: argparse.Namespace, console: Console) -> Pace:
    if args.clock == "lockstep":
        return LockStep(console, STEP if args.step is None else args.step)
    return RealTime(console, args.factor or 1.0)


def mcapi_hosts(server: Server, console: Console, record: Callable[[Call], None] | None = None) -> MakeHost:
    """Return a function that makes a host speaking MCAPI for each connection.

    `record` is called with every call.
    """
    from motionlang.mcapi.host import McapiHost
    from motionlang.mcapi.session import McapiBoard

    board = McapiBoard(console, warn, record)
    return lambda number, channel: McapiHost(number, channel, board, server.limits, server.spy)
