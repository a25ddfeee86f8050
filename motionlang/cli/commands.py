"""The complete command line, parsed by argparse; commands are imported on demand.

Other distributions add commands by entry points: docs/contributing/commands.md.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from importlib import import_module
from typing import TYPE_CHECKING

from motionlang.cli.parser import Parser
from motionlang.extras import COMMANDS as EXTRAS
from motionlang.extras import installation
from motionlang.kernel.tools import as_hint
from motionlang.kernel.version import __version__

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

    from motionlang.cli.command import Command

PROGRAM, VERSION = "motionlang", ("-V", "--version")
# Every command by its group: the class that has its options and does its work, imported only for this command, and its
# summary.
GROUPS = {
    "run a program": {
        "run": ("commands.run.command:RunCommand", "run a program and report what it did"),
        "trace": ("commands.trace.command:TraceCommand", "sample the motion of a run into a file"),
        "plot": ("commands.plot.command:Plot", "draw the motion of a run into a file"),
        "profile": (
            "commands.profile.command:ProfileCommand",
            "show where the time of a run goes, by line, sub and cause",
        ),
        "certify": (
            "commands.certify.command:Certify",
            "report how far a run uses each limit of its machine",
        ),
    },
    "write and check one": {
        "check": (
            "commands.check.command:Check",
            "find the errors and warnings of programs without running them",
        ),
        "plan": (
            "commands.plan.command:PlanCommand",
            "work out the figures of a move and write a program for it",
        ),
        "pvt": ("lab.pvt.command:Pvt", "work with position-velocity-time moves for Copley drives"),
        "servo": ("lab.servo.command:ServoSimulation", "simulate and tune the servo loop behind the profile"),
        "repl": ("repl.command:Repl", "type a program line by line at an interactive prompt"),
    },
    "compare and verify": {
        "sweep": ("commands.sweep.command:SweepCommand", "run many variants of a program and find the best"),
        "diff": ("commands.diff.command:Diff", "compare two programs, values or machines"),
        "compare": (
            "commands.compare.command:Compare",
            "compare a recording from a real controller with the run",
        ),
        "verify": ("commands.verify.command:Verify", "compare programs with their golden files"),
    },
    "connect hosts": {
        "serve": ("hosts.commands.serve:Serve", "let hosts talk to a virtual controller"),
    },
    "editor, shell and help": {
        "dap": ("ide.dap.command:Dap", "debug a program from an editor, forward and back"),
        "help": ("commands.help.command:Help", "explain a command, a keyword or a diagnostic's code"),
        "completion": ("cli.completion:Completion", "print a completion script for bash, zsh or fish"),
    },
}
COMMANDS = {name: row for rows in GROUPS.values() for name, row in rows.items()}
# The distribution of each command of the folder extras, which may not be installed. It may extend one of `COMMANDS`.
FOLDERS = {name: folder for folder, names in EXTRAS.items() for name in names}
Parser.verbs = tuple({**COMMANDS, **FOLDERS})

EPILOG = """\

examples:
  motionlang run pick.mnt              print its output and a table of its moves
  motionlang plot pick.mnt pick.html   draw position, velocity and acceleration
  motionlang check *.mnt               find errors without running
  motionlang help ACCELTIME            explain a keyword
"""


def parse(given: Sequence[str]) -> Command:
    """Parse a command line and return its command; argparse exits with 2 on errors."""
    arguments, unknown = build_parser(given[0] if given else "").parse_known_args(given)
    arguments.given = list(given)
    if unknown:
        arguments.parser.error(f"unrecognized arguments: {' '.join(unknown)}")
    made: Command = arguments.made(arguments)
    return made


def _listing(others: Mapping[str, str]) -> str:
    """Return the commands by group, with their summaries."""
    groups: dict[str, Mapping[str, str]] = {
        title: {name: row[1] for name, row in rows.items()} for title, rows in GROUPS.items()
    }
    added = {name: summary for name, summary in others.items() if name not in COMMANDS}
    if added:
        groups["commands of other packages"] = added
    lines = []
    for title, summaries in groups.items():
        lines += [f"{title}:", *(f"  {name:<11} {summary}" for name, summary in summaries.items()), ""]
    return "\n".join(lines)


def _others() -> dict[str, EntryPoint]:
    """Return the commands of other distributions, by name."""
    from importlib.metadata import entry_points  # as slow as a tenth of a short run, which needs none

    found = {each.name: each for each in entry_points(group="motionlang.commands") if _is_allowed(each)}
    return dict(sorted(found.items()))


def _is_allowed(other: EntryPoint) -> bool:
    """True if a command takes the place of none of `COMMANDS`, or is of the distribution that extends it."""
    extends = other.dist is not None and other.dist.name == f"motionlang-{FOLDERS.get(other.name)}"
    return other.name not in COMMANDS or extends


def _summary(other: EntryPoint, others: Iterable[EntryPoint]) -> str:
    """Return the summary of a command: that of its distribution, or in its package if the distribution has several."""
    if other.name in COMMANDS:
        return COMMANDS[other.name][1]
    name, own = other.dist.name if other.dist else other.module, ""
    if len([each for each in others if each.dist is not None and each.dist.name == name]) > 1:
        with suppress(Exception):  # it is reported when the command is typed
            own = import_module(other.module.partition(".")[0]).SUMMARIES[other.name]
    about = str(other.dist.metadata.json.get("summary", "")) if other.dist else ""
    return own or as_hint(about) or f"a command of {name}"


def build_parser(command: str = "") -> argparse.ArgumentParser:
    """Return the parser of a command, of all commands if it is "*", or of their names alone."""
    others = {} if command in VERSION or (command in COMMANDS and command not in FOLDERS) else _others()
    summaries = {name: _summary(each, others.values()) for name, each in others.items()}
    parser = Parser(
        prog=PROGRAM,
        usage=f"{PROGRAM} [-h] [-V] COMMAND ...",
        description="Run motion-controller programs offline: Mint (Baldor/ABB) and MCCL (PMC).",
        epilog=_listing(summaries) + EPILOG,
    )
    if command in FOLDERS and command not in (*others, *COMMANDS):
        folder = FOLDERS[command]
        parser.exit(2, f"{PROGRAM}: error: {command} needs motionlang-{folder}: {installation(folder)}\n")
    parser.add_argument(*VERSION, action="version", version=f"{PROGRAM} {__version__}")
    commands = parser.add_subparsers(prog=PROGRAM, metavar="COMMAND", required=True, help=argparse.SUPPRESS)
    for name in [command] if command in COMMANDS else COMMANDS:
        if name in others:
            continue
        module, summary = COMMANDS[name]
        if command in (name, "*"):
            file, _, made = module.partition(":")
            getattr(import_module(f"motionlang.{file}"), made).add(commands, name, summary)
        else:
            commands.add_parser(name, help=summary)
    for name, each in others.items():
        if command not in (name, "*"):
            commands.add_parser(name, help=summaries[name])
            continue
        try:
            each.load().add(commands, name, summaries[name])
        except Exception as error:  # not a mistake of this package
            parser.exit(2, f"{PROGRAM}: error: {each.value} for the command {name} cannot be used: {error}\n")
    return parser
