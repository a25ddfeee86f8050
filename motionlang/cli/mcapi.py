"""`motionlang mcapi`: build PMC's host library, run programs, log, replay."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from motionlang.cli.address import address
from motionlang.cli.complaints import complain
from motionlang.cli.machine_options import add_machine
from motionlang.cli.mcapi_run import environment, run_host
from motionlang.cli.numbers import real
from motionlang.cli.options import Options
from motionlang.cli.parser import add_all, add_command, arrange, option, sentence
from motionlang.cli.serve import ADDRESSES, BOARD, GROUPS, read_board
from motionlang.errors import Diagnostic
from motionlang.serve.address import shown

if TYPE_CHECKING:
    from motionlang.cli.parser import Commands
    from motionlang.mcapi.log import BadLog

OK, WRONG = 0, 1
_NOT_NEGATIVE = real("a number, 0 or more", 0.0, 1e6)
TARGETS = ("linux", "win64", "win32")
PATH_EPILOG = """\
examples:
  motionlang mcapi path
  eval "$(motionlang mcapi path --env 127.0.0.1:4410)"     then: ./host
"""
RUN_EPILOG = """\
PROGRAM runs with MCAPI_HOST, LD_PRELOAD and LD_LIBRARY_PATH set, so that it finds the library as it is. The
exit status is that of PROGRAM.

examples:
  motionlang mcapi build
  motionlang mcapi run -- ./host
  motionlang mcapi run --set controller.model=dcx-pci100 --record a.log -- yaqd-pmc --config stages.toml
"""


def add_parser(family: Commands, summary: str) -> None:
    """Add `motionlang mcapi` and its commands."""
    mcapi = family.add_parser("mcapi", help=summary, description=sentence(summary))
    commands = mcapi.add_subparsers(
        dest="mcapi_command", required=True, metavar="build | path | run | log | replay"
    )
    parser = add_command(commands, "build", "compile the C library into the user's cache", build_command)
    _add_target(parser)
    parser.add_argument("--out", metavar="DIR", help="put the library into this folder instead")
    parser = add_command(commands, "path", "print where the compiled C library is", path_command, PATH_EPILOG)
    _add_target(parser)
    add_all(parser, _ENVIRONMENT)
    _add_run(commands)
    parser = add_command(commands, "log", "print a log of calls as MCCL with times", log_command)
    parser.add_argument("file", metavar="FILE", help="the log")
    _add_replay(commands)


_ENVIRONMENT = (
    option("--env", "HOST:PORT", "print the exports by which a host that you start finds the library and, if its "
           "address is given, the board", address, nargs="?", const=("", 0)),
)  # fmt: skip


def _add_target(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--target", choices=TARGETS, default="linux", help="the system that the library is for (linux)"
    )


def _add_run(commands: Commands) -> None:
    summary = "run a host program as it is on a virtual board"
    parser = add_command(commands, "run", summary, run_command, RUN_EPILOG)
    parser.add_argument(
        "program", metavar="PROGRAM", nargs="+", help="the host program and its arguments, after --"
    )
    parser.add_argument("--record", metavar="FILE", help="write every call with its answer into FILE")
    add_all(parser, (*ADDRESSES, *BOARD))
    add_machine(parser)
    arrange(parser, GROUPS)


_REPLAY = (
    option("file", "FILE", "the log"),
    option("--skew", "S", "how far the times of the log may be from those here, in seconds (0.01)",
           _NOT_NEGATIVE, default=0.01),
    option("--tolerance", "COUNTS", "how far a position may be from the one here, in counts (0)",
           _NOT_NEGATIVE, default=0.0),
)  # fmt: skip


def _add_replay(commands: Commands) -> None:
    summary = "carry out a log of calls in virtual time and compare the answers"
    parser = add_command(commands, "replay", summary, replay_command)
    add_all(parser, _REPLAY)
    add_machine(parser)


def build_command(args: argparse.Namespace) -> int:
    """Compile the library and print its path; 1 if that fails."""
    from motionlang.mcapi.build import TARGETS as BUILT
    from motionlang.mcapi.build import CannotBuild, build

    try:
        path = build(BUILT[args.target], Path(args.out) if args.out is not None else None)
    except CannotBuild as problem:
        return _refuse(str(problem), problem.hint)
    print(path)
    return OK


def path_command(args: argparse.Namespace) -> int:
    """Print the path of the library, or the exports for a host; 1 if it has not been built."""
    if args.env is not None and args.target != "linux":
        args.parser.error("--env is for Linux; on Windows copy the DLL next to the program")
    path = library(args.target)
    if path is None:
        return WRONG
    if args.env is None:
        print(path)
        return OK
    host, port = args.env
    for name, value in environment(os.environ, shown(host, port) if host else "", path).items():
        print(f"export {name}={shlex.quote(value)}")
    return OK


def library(target: str = "linux") -> Path | None:
    """Return the path of the library; None, with a message, if it has not been built."""
    from motionlang.mcapi.build import TARGETS as BUILT
    from motionlang.mcapi.build import default_path

    found = default_path(BUILT[target])
    if found is not None and found.exists():
        return found
    option = "" if target == "linux" else f" --target {target}"
    _refuse("the library of this version has not been built", f"motionlang mcapi build{option} compiles it")
    return None


def run_command(args: argparse.Namespace) -> int:
    """Serve a board to a program until it ends; return the program's exit status."""
    options = Options("")
    status = read_board(args, options)
    if status:
        return status
    path = library()
    return WRONG if path is None else run_host(args, options, path)


def log_command(args: argparse.Namespace) -> int:
    """Print a log as MCCL; 1 if it cannot be read."""
    from motionlang.mcapi.listing import Listing
    from motionlang.mcapi.log import BadLog, model_of, read

    try:
        with open(args.file, "rb") as file:
            listing = Listing(model_of(file))
            file.seek(0)
            for entry in read(file):
                sys.stdout.write(listing.line(entry) + "\n")
    except BadLog as problem:
        return _bad_log(args.file, problem)
    except OSError as error:
        return _refuse(f"{args.file}: {error.strerror or error}", "name a log that --record has written")
    return OK


def replay_command(args: argparse.Namespace) -> int:
    """Replay a log; 1 if it differs or cannot be read."""
    from motionlang.controller.faults import Rejected
    from motionlang.mcapi.log import BadLog, model_of
    from motionlang.mcapi.replay import call_of, replay_file

    options = Options("")
    status = read_board(args, options)
    if status:
        return status
    try:
        with open(args.file, "rb") as file:
            model = model_of(file)
        own = options.settings.get("controller.model", model)
        if model and own != model:
            _note(f"the log is of a {model}, this board is a {own}")
        replay = replay_file(args.file, options.settings, args.skew, args.tolerance)
    except BadLog as problem:
        return _bad_log(args.file, problem)
    except Rejected as rejected:
        return _refuse(rejected.message, rejected.hint)
    except OSError as error:
        return _refuse(f"{args.file}: {error.strerror or error}", "name a log that --record has written")
    first = replay.first
    if first is not None:
        print(f"{os.path.basename(args.file)}:{first.entry.line}: at {first.entry.begin:.6f} s: {first.text}")
        print(f"  {call_of(first.entry)}")
    print(replay.summary)
    return WRONG if first is not None else OK


def _bad_log(name: str, problem: BadLog) -> int:
    return _refuse(f"{name}:{problem.line}: {problem}", "record it again")


def _refuse(message: str, hint: str = "") -> int:
    complain([Diagnostic("mcapi", message, hint=hint)], None, "")
    return WRONG


def _note(message: str) -> None:
    print(f"note: {message}", file=sys.stderr)
