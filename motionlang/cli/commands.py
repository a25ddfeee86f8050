"""The complete command line, parsed by argparse: its commands, imported on demand."""

from __future__ import annotations

import argparse
import sys
from importlib import import_module
from typing import TYPE_CHECKING

from motionlang import __version__
from motionlang.cli.complaints import complain
from motionlang.cli.parser import Parser
from motionlang.errors import ProgramError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence


PROGRAM = "motionlang"
# Every command: the module that has its options, imported only for this command, and its summary.
COMMANDS = {
    "run": ("run_options", "run a program on the virtual machine and report what it did"),
    "init": ("init", "write a first machine file for a program, with guesses marked, and run it"),
    "check": ("check", "report every mistake and every warning of every file; nothing is run"),
    "repl": ("repl", "type a program line by line and watch the axes"),
    "plan": ("plan", "find the missing figures of a move, and a program for it"),
    "profiles": ("profiles", "compare the four velocity profiles of PMC's TN1069 by a move"),
    "keywords": ("keywords", "list the words of a language, or explain one"),
    "verify": ("verify", "run programs and compare them with their golden files"),
    "pvt": ("pvt", "position-velocity-time moves for Copley drives"),
    "servo": ("servo", "the servo behind the profile: slip, DAC steps, tuning, comparison"),
    "diff": (
        "diff",
        "tell what is otherwise: two programs, machines or variants, or a program and its golden files or a recording",
    ),
    "sweep": ("sweep", "run a program in many variants, on all processors, and say which is best"),
    "compare": (
        "compare",
        "hold what a real controller recorded against the run: residuals, lag and overshoot, line by line",
    ),
    "probe": ("probe", "ask a real controller which of the open readings hold"),
    "serve": ("serve", "let hosts talk to a virtual board, or to a Mint program over Modbus"),
    "completion": ("completion", "print what a shell needs to complete the command line"),
}

EPILOG = """\
examples:
  motionlang run pick.mnt                        what the program prints, then a table of its moves
  motionlang run pick.mnt --plot pick.png        position, velocity and acceleration as a picture
  motionlang run pick.mnt --report json          the same figures for another program
  motionlang check *.mnt                         every mistake of every file, nothing run
  motionlang plan --distance 20 --time 0.6 --rule third
                                                 the speed and the rates of a move, and a program for it
  motionlang keywords ACCELTIME                  what a word means, with an example
"""


def parse(given: Sequence[str]) -> int:
    """Parse a command line and run its command; argparse exits with 2 on errors."""
    if given and given[0] == "help":
        given = [*given[1:2], "--help"]
    parser = build_parser(given[0] if given else "")
    if not given:
        parser.print_help(sys.stderr)
        return 2
    arguments, unknown = parser.parse_known_args(_with_factor(given))
    arguments.given = list(given)
    if unknown:
        whose = getattr(arguments, "parser", parser)
        whose.error(f"unrecognized arguments: {' '.join(unknown)}")
    try:
        command: Callable[[argparse.Namespace], int] = arguments.command
        return command(arguments)
    except ProgramError as error:  # for a machine that cannot be built from the command line
        complain(error.diagnostics, None, "")
        return 1


def _with_factor(given: Sequence[str]) -> list[str]:
    """Rewrite `--realtime FILE` to `--realtime=1 FILE` for argparse."""
    words = list(given)
    for i, word in enumerate(words):
        following = words[i + 1] if i + 1 < len(words) else ""
        if word == "--realtime" and not following[:1].isdigit() and following[:1] not in ("-", "."):
            words[i] = "--realtime=1"
    return words


def build_parser(command: str = "") -> argparse.ArgumentParser:
    """Return the parser with all commands.

    The options are those of one command, or of all if `command` is "*".
    """
    parser = Parser(
        prog=PROGRAM,
        description="Run programs of motion controllers offline, in virtual time: Mint (Baldor/ABB) and MCCL (PMC).",
        epilog=EPILOG,
    )
    parser.add_argument("--version", action="version", version=f"{PROGRAM} {__version__}")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for name, (module, summary) in COMMANDS.items():
        if command in (name, "*"):
            import_module(f"motionlang.cli.{module}").add_parser(commands, summary)
        else:
            commands.add_parser(name, help=summary)
    return parser
