"""`motionlang serve`: a virtual controller on TCP, a serial device or Modbus.

The controller is an MCCL board, or it runs a Mint program. Modbus requires a Mint program.
"""

from __future__ import annotations

import argparse

from motionlang.cli.address import address
from motionlang.cli.complaints import no_dialect, refuse, unreadable
from motionlang.cli.input_files import read_machine_file, read_source
from motionlang.cli.machine_options import add_machine, set_values
from motionlang.cli.numbers import real, whole
from motionlang.cli.options import Options
from motionlang.cli.output_queue import never_waiting
from motionlang.cli.parser import Commands, add_all, add_command, arrange, flag, option
from motionlang.cli.serve_board import serve_board
from motionlang.cli.serve_can import serve_can
from motionlang.cli.serve_line import serve_line
from motionlang.cli.serve_modbus import serve_modbus
from motionlang.errors import Diagnostic, MissingExtra
from motionlang.execution import language_of, machine_of
from motionlang.source import STDIN, Source

EPILOG = """\
The board is a PMC controller with ASCII MCCL; FILE is sent to it first, as a downloader would. If FILE is a Mint
program, hosts are connected to the serial line of its controller: PRINT, INPUT, keys, Ctrl-E, typed lines, downloads
and HCP frames. With --dialect mint and no FILE the controller has no program yet. With --clock real,
machine time follows real time. With --clock lockstep, machine time passes only while a host waits for an answer, so the
same lines always get the same answers; a line takes --step seconds, or as long as it waits.

With --can, simulated drives (CiA 402) are nodes of a CAN bus; --set axis.1.travel=[-9000,9000] and the like place the
switches of drive 1, in counts.

With --modbus, FILE is a Mint program, and Modbus TCP clients read and write its comms array or NetData: element n is
holding registers 2n (low half) and 2n + 1. In lock step, machine time advances by --step for each request.

examples:
  motionlang serve --tcp 127.0.0.1:5010                    then: nc 127.0.0.1 5010
  motionlang serve macros.mcl --tcp 5010 --pty --log
  motionlang serve packer.mnt --tcp 127.0.0.1:5300
  motionlang serve packer.mnt --modbus 127.0.0.1:5020 --unit 1
  motionlang serve --can socketcan:vcan0 --drives 2 --eds drive.eds
  motionlang serve --tcp 0 --clock lockstep --set controller.model=dcx-pci300
"""

GROUPS = {
    "addresses": "tcp mcapi modbus unit pty can drives eds max-hosts",
    "time": "clock factor step",
    "lines": "echo log",
}


def _bus(text: str) -> tuple[str, str]:
    interface, colon, channel = text.partition(":")
    if not (interface and colon and channel):
        raise argparse.ArgumentTypeError(f"{text!r} is not INTERFACE:CHANNEL, such as socketcan:vcan0")
    return interface, channel


# The addresses of ASCII hosts.
ADDRESSES = (
    option("--tcp", "HOST:PORT", "listen on this address; without HOST only this computer can connect, port 0 is any "
           "free port; may be repeated", address, action="append", default=[]),
    flag("--pty", "create a serial device and print its path (not on Windows)"),
)  # fmt: skip

_OPTIONS = (
    option("file", "FILE", "commands to send to the board first; - reads standard input", nargs="?"),
    option("--modbus", "HOST:PORT", "run a Mint program and serve its memory to Modbus TCP clients on this address",
           address),
    option("--unit", "N", "the Modbus unit that is answered, in addition to 0 and 255, which mean any device "
           "(default: all)", whole("a Modbus unit from 1 to 247", 1, 247)),
    option("--mcapi", "HOST:PORT", "listen on this address for hosts that call PMC's library MCAPI (see `motionlang "
           "mcapi`)", address),
    option("--can", "INTERFACE:CHANNEL", "put simulated CANopen drives on a bus of python-can (needs the extra can)",
           _bus),
    option("--drives", "N", "the number of drives on the bus, nodes 1 to N (1)",
           whole("a number of drives from 1 to 127", 1, 127)),
    option("--eds", "FILE", "write the EDS file of the drives"),
)  # fmt: skip


# A served board: its time and its lines.
BOARD = (
    option("--clock", None, "how machine time passes: in real time (default), or in lock step, only while a host waits",
           choices=("real", "lockstep"), default="real"),
    option("--factor", "X", "run at X × real time, with --clock real (1)",
           real("a factor from 0.000001 to 1000000", 1e-6, 1e6)),
    option("--step", "S", "with --clock lockstep, the least machine time of a line (0.001 s), or, for a Mint program, "
           "the machine time of a line, frame or request (0.01 s)", real("a time from 0 to 3600 seconds", 0.0, 3600.0)),
    option("--echo", None, "echo the characters that hosts send; default: off for TCP, as on the board for a serial "
           "device", action=argparse.BooleanOptionalAction),
    option("--max-hosts", "N", "maximum number of simultaneous connections (64)",
           whole("a number of connections from 1 to 1000", 1, 1000), default=64),
    flag("--log", "log commands and answers to standard error"),
)  # fmt: skip


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang serve` and its options."""
    parser = add_command(commands, "serve", summary, serve_command, EPILOG)
    add_all(parser, (*ADDRESSES, *_OPTIONS, *BOARD))
    add_machine(parser)
    arrange(parser, GROUPS)


def serve_command(args: argparse.Namespace) -> int:
    """Serve until a signal; return 0, 1 (an error) or 2 (wrong command line)."""
    _check(args)
    options = Options(args.file or "")
    source: Source | None = None
    if args.file is not None:
        if args.file != STDIN and language_of(args.dialect, args.file) is None:
            return refuse(options, [no_dialect(args.file)], None, 2)
        try:
            source = read_source(args.file)
        except OSError as error:
            return refuse(options, [unreadable(args.file, error)], None, 1)
    status = read_board(args, options)
    if status:
        return status
    settings, overrides = options.settings, options.overrides
    if args.can is not None and overrides:
        args.parser.error(f"--set {next(iter(overrides))}: the drives of --can run no program with names")
    with never_waiting() as queues:
        if args.can is not None:
            try:
                return serve_can(args, settings, queues)
            except MissingExtra as lacking:
                return refuse(options, [Diagnostic("extra", lacking.message, hint=lacking.hint)], None, 1)
        if _speaks_mint(args) and (args.tcp or args.pty):
            return serve_line(args, source, settings, overrides, queues)
        if args.modbus is not None:
            assert source is not None
            return serve_modbus(args, source, settings, overrides, queues)
        return serve_board(args, source, settings, overrides, queues)


def read_board(args: argparse.Namespace, options: Options) -> int:
    """Read the settings of a board from the command line and the machine file.

    Returns an exit status, not 0 if that fails.
    """
    options.dialect, options.machine = args.dialect, args.machine
    language = language_of(args.dialect, options.file)
    set_values(args.set, options.settings, options.overrides, args.parser, language)
    options.machine = machine_of(options.file or None, args.machine)
    return read_machine_file(options, options.settings) if options.machine is not None else 0


def check_time(args: argparse.Namespace) -> None:
    """End the command with an error if options of time conflict."""
    if args.factor is not None and args.clock != "real":
        args.parser.error("--factor needs --clock real")
    if args.step is not None and args.clock != "lockstep":
        args.parser.error("--step needs --clock lockstep")


def _check(args: argparse.Namespace) -> None:
    """End the command with an error if options conflict."""
    error = args.parser.error
    if not args.tcp and not args.pty and args.mcapi is None and args.modbus is None and args.can is None:
        error(
            "no address for hosts: give --tcp, --mcapi or --modbus with HOST:PORT, --pty, or --can INTERFACE:CHANNEL"
        )
    check_time(args)
    if args.can is None and (args.drives is not None or args.eds is not None):
        error("--drives and --eds need --can INTERFACE:CHANNEL")
    if args.can is not None:
        _check_can(args)
    if args.unit is not None and args.modbus is None:
        error("--unit needs --modbus HOST:PORT")
    if args.mcapi is not None and _speaks_mint(args):
        error("--mcapi serves an MCCL board; serve a Mint program with --tcp, --pty or --modbus")
    if args.modbus is not None:
        _check_modbus(args)


def _check_can(args: argparse.Namespace) -> None:
    error = args.parser.error
    if args.file is not None or args.tcp or args.pty or args.modbus is not None or args.mcapi is not None:
        error("--can serves drives, which run no program: leave out FILE, --tcp, --pty, --mcapi and --modbus")
    if args.clock != "real":
        error("--can needs --clock real: masters have their own time")
    if args.echo is not None or args.log:
        error("--echo and --log have no effect with --can")
    args.drives = args.drives or 1


def _check_modbus(args: argparse.Namespace) -> None:
    error = args.parser.error
    lines = args.tcp or args.pty
    if (args.echo is not None or args.log) and not lines:
        error("--echo and --log need --tcp or --pty")
    if args.file is None and not (lines and _speaks_mint(args)):
        error("--modbus needs a Mint program: motionlang serve FILE --modbus HOST:PORT")
    if not _speaks_mint(args):
        error("--modbus serves a Mint program; for a file with another extension add --dialect mint")


def _speaks_mint(args: argparse.Namespace) -> bool:
    from motionlang.execution import dialect_of

    found = dialect_of(args.file or "")
    return bool(
        args.dialect == "mint" or (args.dialect is None and found is not None and found.name == "mint")
    )
