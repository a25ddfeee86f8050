"""The complete command line, parsed by argparse; commands are imported on demand.

Other distributions add commands by entry points: docs/contributing/commands.md.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from importlib import import_module
from typing import TYPE_CHECKING

from motionlang.cli.command import Command
from motionlang.cli.parser import Parser
from motionlang.kernel.tools import as_hint
from motionlang.kernel.version import __version__

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

PROGRAM, VERSION = "motionlang", ("-V", "--version")
# Every command by its group: the class that has its options and does its work, imported only for this command, and its
# summary.
GROUPS = {
    "run a program": {
        "run": ("commands.run.command:RunCommand", "run a program and report what it did"),
        "panel": ("commands.panel.command:PanelCommand", "operate the machine of a program in a browser"),
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
        "init": ("commands.init.command:Init", "write a first machine file for a program, and run it"),
        "check": (
            "commands.check.command:Check",
            "find the errors and warnings of programs without running them",
        ),
        "map": ("commands.map.command:Map", "show what a program does: channels, axes, structure, states"),
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
        "improve": (
            "commands.improve.command:Improve",
            "find a shorter cycle within the limits of the machine",
        ),
        "diff": ("commands.diff.in_all_ways:DiffInAllWays", "compare two programs, values or machines"),
        "compare": (
            "commands.compare.command:Compare",
            "compare a recording from a real controller with the run",
        ),
        "verify": ("commands.verify.command:Verify", "compare programs with their golden files"),
        "cover": (
            "commands.cover.command:Cover",
            "show which statements and conditions of programs their runs reach",
        ),
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
# The commands of the distributions in the folder extras, which may not be installed.
EXTRAS = ("mcapi", "copley", "lsp")
Parser.verbs = (*COMMANDS, *EXTRAS)

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
    if others:
        groups["commands of other packages"] = others
    lines = []
    for title, summaries in groups.items():
        lines += [f"{title}:", *(f"  {name:<11} {summary}" for name, summary in summaries.items()), ""]
    return "\n".join(lines)


def _others() -> dict[str, EntryPoint]:
    """Return the commands of other distributions, by name."""
    from importlib.metadata import entry_points  # as slow as a tenth of a short run, which needs none

    found = {each.name: each for each in entry_points(group="motionlang.commands")}
    return {name: found[name] for name in sorted(found.keys() - COMMANDS.keys())}


def _summary(other: EntryPoint, others: Iterable[EntryPoint]) -> str:
    """Return the summary of a command: that of its distribution, or of its class if the distribution has several."""
    name, own = other.dist.name if other.dist else other.module, ""
    if len([each for each in others if each.dist is not None and each.dist.name == name]) > 1:
        with suppress(Exception):  # it is reported when the command is typed
            own = other.load().summary
    about = str(other.dist.metadata.json.get("summary", "")) if other.dist else ""
    return own or as_hint(about) or f"a command of {name}"


def build_parser(command: str = "") -> argparse.ArgumentParser:
    """Return the parser of a command, of all commands if it is "*", or of their names alone."""
    others = {} if command in (*COMMANDS, *VERSION) else _others()
    summaries = {name: _summary(each, others.values()) for name, each in others.items()}
    parser = Parser(
        prog=PROGRAM,
        usage=f"{PROGRAM} [-h] [-V] COMMAND ...",
        description="Run motion-controller programs offline: Mint (Baldor/ABB) and MCCL (PMC).",
        epilog=_listing(summaries) + EPILOG,
    )
    if command in EXTRAS and command not in others:
        install = f"python -m pip install ./extras/{command}"
        parser.exit(2, f"{PROGRAM}: error: {command} needs motionlang-{command}: {install}\n")
    parser.add_argument(*VERSION, action="version", version=f"{PROGRAM} {__version__}")
    commands = parser.add_subparsers(prog=PROGRAM, metavar="COMMAND", required=True, help=argparse.SUPPRESS)
    for name in [command] if command in COMMANDS else COMMANDS:
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
