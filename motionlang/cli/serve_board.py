"""A served MCCL board on the command line: its output and its end."""

from __future__ import annotations

import signal
import sys
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain
from motionlang.cli.output_queue import dropped
from motionlang.controller.faults import Rejected
from motionlang.errors import Diagnostic
from motionlang.execution import accelerators
from motionlang.lang.machine.machine import Machine
from motionlang.mccl.hosts.console import Console
from motionlang.mccl.models import written_for
from motionlang.serve import Limits, LockStep, RealTime, Server
from motionlang.serve.address import is_loopback, shown
from motionlang.serve.pace import STEP
from motionlang.serve.spy import Spy
from motionlang.source import Source

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable
    from types import FrameType
    from typing import TextIO

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

    `queues` are those of the output.
    """
    server = server_of(args, source, settings, overrides)
    if server is None:
        return 1
    with server:
        if not _open(server, args, server.console):
            return 1
        _until_signal(server)
    _say(f"served {server.served} hosts; machine time {server.console.now:.3f} s{dropped(queues)}\n")
    return 0


def server_of(
    args: argparse.Namespace,
    source: Source | None,
    settings: dict[str, object],
    overrides: dict[str, float | str],
) -> Server | None:
    """Return the server of a board to which the file has been sent.

    None if the board cannot be made.
    """
    if source is not None:
        settings.setdefault("controller.model", written_for(source.name))
    try:
        console = Console(Machine(settings, first_axis=1, overrides=overrides, accelerators=accelerators()))
        download = console.download(
            source or Source("", ""), _say, lambda diagnostic: complain([diagnostic], source, args.file or "")
        )
        download.override(overrides)
    except Rejected as rejected:
        complain([Diagnostic(rejected.code, rejected.message, hint=rejected.hint)], None, "")
        return None
    spy = Spy(_remark) if args.log else None
    limits = Limits(hosts=args.max_hosts)
    return Server(console, _pace(args, console), limits=limits, spy=spy, complain=_complain)


def _pace(args: argparse.Namespace, console: Console) -> Pace:
    if args.clock == "lockstep":
        return LockStep(console, STEP if args.step is None else args.step)
    return RealTime(console, args.factor or 1.0)


def _open(server: Server, args: argparse.Namespace, console: Console) -> bool:
    """Open and print the interfaces; False if one of them cannot be opened."""
    board = console.board
    time = "in lock step" if args.clock == "lockstep" else "in real time"
    if args.factor:
        time += f", {args.factor:g} × real time"
    _say(f"{board.model.title}, {len(board.numbers)} axes, {time}; Ctrl-C ends it\n")
    for host, port in args.tcp:
        if not _listen(server, host, port, echo=bool(args.echo)):
            return False
    if args.mcapi is not None and not _listen(server, *args.mcapi, make=mcapi_hosts(server)):
        return False
    if args.pty:
        try:
            _say(f"serial device {server.device(echo=args.echo)}\n")
        except ImportError as error:
            return _cannot("this system has no pseudo-terminals; use --tcp", error)
        except OSError as error:
            return _cannot("cannot create a serial device", error)
    return True


def _listen(
    server: Server, host: str, port: int, *, echo: bool = False, make: MakeHost | None = None
) -> bool:
    """Listen on an address and say so; False if it cannot be used."""
    try:
        found, port = server.listen(host, port, echo, make)
    except (OSError, UnicodeError) as error:
        return _cannot(f"cannot listen on {shown(host, port)}", error)
    if not is_loopback(found):
        _complain(
            f"warning: any computer that can reach this one can connect to {shown(found, port)}; there is "
            "no password"
        )
    _say(f"listening on {shown(found, port)}{'' if make is None else ' for MCAPI'}\n")
    return True


def mcapi_hosts(server: Server, record: Callable[[Call], None] | None = None) -> MakeHost:
    """Return what makes a host that speaks MCAPI of a connection.

    `record` is called with every call.
    """
    from motionlang.mcapi.host import McapiHost
    from motionlang.mcapi.session import McapiBoard

    board = McapiBoard(server.console, _complain, record)
    return lambda number, channel: McapiHost(number, channel, board, server.limits, server.spy)


def _until_signal(server: Server) -> None:
    """Serve until Ctrl-C or SIGTERM, each of them a normal end."""

    def stop(number: int, frame: FrameType | None) -> None:
        server.stop()

    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        server.run()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _cannot(what: str, error: Exception) -> bool:
    reason = getattr(error, "strerror", None) or str(error)
    complain([Diagnostic("address", f"{what}: {reason.lower()}")], None, "")
    return False


def _say(text: str) -> None:
    _write(sys.stdout, text)


def _remark(text: str) -> None:
    _write(sys.stderr, text)


def _write(stream: TextIO, text: str) -> None:
    """Write a text at once; ignore a reader that has gone."""
    try:
        stream.write(text)
        stream.flush()
    except (OSError, ValueError):
        pass


def _complain(text: str) -> None:
    _remark(f"motionlang serve: {text}\n")
