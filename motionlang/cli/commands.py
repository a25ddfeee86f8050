"""The complete command line, parsed by argparse; commands are imported on demand."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from importlib import import_module

from motionlang import __version__
from motionlang.cli.complaints import complain
from motionlang.cli.format_options import into
from motionlang.cli.parser import Parser
from motionlang.errors import ProgramError

PROGRAM = "motionlang"
# Every command: the module that has its options, imported only for this command, and its summary.
COMMANDS = {
    "run": ("run_options", "run a program and report what it did"),
    "new": ("new", "write a small program with its machine file"),
    "init": ("init", "write a first machine file for a program, mark the guesses, and run it"),
    "profile": ("run_verbs:profile", "show where the time of a run goes, by line, sub and cause"),
    "prove": ("run_verbs:prove", "verify the motion of a run against the commanded limits"),
    "certify": ("run_verbs:certify", "report how far a run uses each limit of its machine"),
    "plot": ("run_verbs:plot", "draw the motion of a run into a file"),
    "trace": ("run_verbs:trace", "sample the motion of a run into a file"),
    "check": ("check", "find the errors and warnings of programs without running them"),
    "repl": ("repl", "type a program line by line at an interactive prompt"),
    "plan": ("plan", "work out the missing figures of a move and write a program for it"),
    "keywords": ("keywords", "look up a keyword"),
    "explain": ("explain", "explain a diagnostic by its code"),
    "verify": ("verify", "compare programs with their golden files"),
    "pvt": ("pvt", "work with position-velocity-time moves for Copley drives"),
    "servo": ("servo", "simulate and tune the servo loop behind the profile"),
    "diff": (
        "diff",
        "compare two runs: programs, machines or variants, or a program and its golden files",
    ),
    "sweep": ("sweep", "run many variants of a program and find the best"),
    "compare": (
        "compare",
        "compare a recording from a real controller with the run",
    ),
    "probe": ("probe", "write a test program that settles open questions on a real controller"),
    "serve": ("serve", "let hosts talk to a virtual controller, or to a Mint program over Modbus"),
    "mcapi": ("mcapi", "run hosts of PMC boards as they are: build MCAPI, record and replay calls"),
    "lsp": ("lsp", "serve an editor: diagnostics, completion, names, simulated times"),
    "dap": ("dap", "debug a program from an editor, forward and back"),
    "completion": ("completion", "print a completion script for bash, zsh or fish"),
}

EPILOG = """\
examples:
  motionlang run pick.mnt                        print its output, then a table of its moves
  motionlang run pick.mnt --plot pick.html       draw position, velocity and acceleration
  motionlang run pick.mnt --format json          write the same figures as JSON
  motionlang check *.mnt                         check without running
  motionlang plan --distance 20 --time 0.6 --rule third  work out speed and rates, write a program
  motionlang keywords ACCELTIME                  look up a keyword
"""


def parse(given: Sequence[str]) -> int:
    """Parse a command line and run its command; argparse exits with 2 on errors."""
    if given and given[0] == "help":
        given = [*given[1:2], "--help"]
    parser = build_parser(given[0] if given else "")
    arguments, unknown = parser.parse_known_args(_with_factor(given))
    arguments.given = list(given)
    if unknown:
        arguments.parser.error(f"unrecognized arguments: {' '.join(unknown)}")
    command: Callable[[argparse.Namespace], int] = arguments.command
    try:
        if getattr(arguments, "into", None) is not None:
            return into(arguments.into, lambda: command(arguments))
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


def _add(module: str) -> Callable[..., object]:
    """Return the function that adds a command.

    `module` is a module with an `add_parser`, or `MODULE:FUNCTION`.
    """
    name, _, function = module.partition(":")
    found: Callable[..., object] = getattr(import_module(f"motionlang.cli.{name}"), function or "add_parser")
    return found


def build_parser(command: str = "") -> argparse.ArgumentParser:
    """Return the parser with all commands.

    Only `command` gets its options, or all commands if it is "*".
    """
    parser = Parser(
        prog=PROGRAM,
        description="Run motion-controller programs offline, in virtual time: Mint (Baldor/ABB) and MCCL (PMC).",
        epilog=EPILOG,
    )
    parser.add_argument("-V", "--version", action="version", version=f"{PROGRAM} {__version__}")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for name, (module, summary) in COMMANDS.items():
        if command in (name, "*"):
            _add(module)(commands, summary)
        else:
            commands.add_parser(name, help=summary)
    return parser
