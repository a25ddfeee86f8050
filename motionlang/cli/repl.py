"""`motionlang repl`: a program typed line by line."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.cli.input_files import read_machine_file
from motionlang.cli.machine_options import add_machine, set_values
from motionlang.cli.options import Options
from motionlang.cli.parser import add_command
from motionlang.execution import machine_of
from motionlang.repl import main

if TYPE_CHECKING:
    import argparse

    from motionlang.cli.parser import Commands


def add_parser(commands: Commands, summary: str) -> None:
    """`motionlang repl` and its options."""
    parser = add_command(commands, "repl", summary, _repl)
    parser.add_argument("file", metavar="FILE", nargs="?", help="a program to run first")
    add_machine(parser)


def _repl(arguments: argparse.Namespace) -> int:
    settings: dict[str, object] = {}
    overrides: dict[str, float | str] = {}
    set_values(arguments.set, settings, overrides, arguments.parser)
    options = Options(arguments.machine or "")
    options.machine = machine_of(arguments.file or None, arguments.machine)
    if options.machine is not None:
        status = read_machine_file(options, settings)
        if status:
            return status
    return main(arguments.dialect, arguments.file, settings, overrides)
