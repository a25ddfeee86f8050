"""`motionlang serve`: a virtual board on a TCP port or serial device, or Modbus.

Modbus serves a Mint program.
"""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from motionlang.cli.complaints import refuse, unreadable
from motionlang.cli.input_files import read_machine_file, read_source
from motionlang.cli.machine_options import add_machine, set_values
from motionlang.cli.options import Options
from motionlang.cli.output_queue import never_waiting
from motionlang.cli.parser import add_command
from motionlang.cli.serve_board import serve_board
from motionlang.cli.serve_modbus import serve_modbus
from motionlang.execution import machine_of
from motionlang.serve.address import BadAddress, parse

if TYPE_CHECKING:
    from motionlang.cli.parser import Commands
    from motionlang.source import Source

EPILOG = """\
The board is a PMC controller that understands ASCII MCCL; FILE is sent to it first, as a downloader would.
With --clock real a move takes the time that it takes. With --clock lockstep time stands still unless a host waits for
an answer, so that the same lines are answered the same; a line takes --step seconds, or as long as it waits.

With --modbus FILE is a Mint program, and a Modbus TCP client reads and writes its comms array or NetData: element n is
the holding registers 2n, the low half, and 2n + 1. In lock step machine time goes on by --step for each request.

examples:
  motionlang serve --tcp 127.0.0.1:5010                    then: nc 127.0.0.1 5010
  motionlang serve macros.mcl --tcp 5010 --pty --log
  motionlang serve packer.mnt --modbus 127.0.0.1:5020
  motionlang serve --tcp 0 --clock lockstep --set controller.model=dcx-pci300
"""


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang serve` and its options."""
    parser = add_command(commands, "serve", summary, serve_command, EPILOG)
    add = parser.add_argument
    add("file", metavar="FILE", nargs="?", help="commands that the board gets first; - reads standard input")
    add(
        "--tcp",
        type=_address,
        action="append",
        default=[],
        metavar="HOST:PORT",
        help="listen here; without HOST only this computer can connect, port 0 is any that is free; may be repeated",
    )
    add(
        "--modbus",
        type=_address,
        metavar="HOST:PORT",
        help="run a Mint program and let Modbus TCP clients reach its memory here",
    )
    add("--pty", action="store_true", help="make a serial device, and print its path (not on Windows)")
    _add_time(parser)
    add(
        "--echo",
        action=argparse.BooleanOptionalAction,
        help="send back what hosts send; without it TCP does not, and a serial device as the board does",
    )
    add("--max-hosts", type=_count, default=64, metavar="N", help="connections at once (64)")
    add(
        "--log", action="store_true", help="show on standard error what hosts send and what they are answered"
    )
    add_machine(parser)


def _add_time(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add(
        "--clock",
        choices=("real", "lockstep"),
        default="real",
        help="how machine time passes: with the wall clock (real, the default), or while a host waits (lockstep)",
    )
    add("--factor", type=_positive, metavar="X", help="machine seconds a second, with --clock real (1)")
    add(
        "--step",
        type=_seconds,
        metavar="S",
        help="machine seconds that a line takes at least (0.001), or by which time goes on for a Modbus request "
        "(0.01), with --clock lockstep",
    )


def serve_command(args: argparse.Namespace) -> int:
    """Serve until a signal; the exit status is 0, 1 (an error) or 2 (command line)."""
    _check(args)
    options = Options(args.file or "")
    options.dialect, options.machine = args.dialect, args.machine
    settings, overrides = options.settings, options.overrides
    set_values(args.set, settings, overrides, args.parser)
    source: Source | None = None
    if args.file is not None:
        try:
            source = read_source(args.file)
        except OSError as error:
            return refuse(options, [unreadable(args.file, error)], None, 1)
    options.machine = machine_of(args.file, args.machine)
    if options.machine is not None:
        status = read_machine_file(options, settings)
        if status:
            return status
    if args.modbus is not None:
        assert source is not None
        with never_waiting() as queues:
            return serve_modbus(args, source, settings, overrides, queues)
    with never_waiting() as queues:
        return serve_board(args, source, settings, overrides, queues)


def _check(args: argparse.Namespace) -> None:
    """End the command if options conflict."""
    error = args.parser.error
    if not args.tcp and not args.pty and args.modbus is None:
        error("no host could connect: give --tcp HOST:PORT, --pty or --modbus HOST:PORT")
    if args.factor is not None and args.clock != "real":
        error("--factor is about the wall clock: it goes with --clock real")
    if args.step is not None and args.clock != "lockstep":
        error("--step is about lock step: it goes with --clock lockstep")
    if args.modbus is not None:
        _check_modbus(args)
    elif _speaks_mint(args):
        error("a board that is served understands MCCL; a Mint program is served with --modbus HOST:PORT")


def _check_modbus(args: argparse.Namespace) -> None:
    error = args.parser.error
    if args.tcp or args.pty:
        error("--modbus serves a Mint program, --tcp and --pty an MCCL board: one of them at a time")
    if args.echo is not None or args.log:
        error("--echo and --log are about hosts that send lines; Modbus has none")
    if args.file is None:
        error("--modbus needs the Mint program that it serves: motionlang serve FILE --modbus HOST:PORT")
    if not _speaks_mint(args):
        error(
            "--modbus serves the memory of a Mint program; for a file without a Mint suffix say --dialect mint"
        )


def _speaks_mint(args: argparse.Namespace) -> bool:
    from motionlang.execution import dialect_of

    found = dialect_of(args.file or "")
    return bool(
        args.dialect == "mint" or (args.dialect is None and found is not None and found.name == "mint")
    )


def _address(text: str) -> tuple[str, int]:
    try:
        return parse(text if ":" in text else ":" + text)
    except BadAddress as problem:
        raise argparse.ArgumentTypeError(str(problem)) from None


def _count(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= 1000:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of connections from 1 to 1000")
    return int(text)


def _positive(text: str) -> float:
    return _number(text, 1e-6, 1e6, "a factor from 0.000001 to 1000000")


def _seconds(text: str) -> float:
    return _number(text, 0.0, 3600.0, "a time from 0 to 3600 seconds")


def _number(text: str, low: float, high: float, what: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not low <= value <= high:
        raise argparse.ArgumentTypeError(f"{text!r} is not {what}")
    return value
