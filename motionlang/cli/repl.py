"""`motionlang repl`: a program typed line by line."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Mapping

from motionlang.cli.input_files import read_machine_file
from motionlang.cli.machine_options import add_machine, set_values
from motionlang.cli.options import Options
from motionlang.cli.parser import Commands, add_command
from motionlang.cli.world_options import add_world, with_world, world_of
from motionlang.controller.faults import Rejected
from motionlang.errors import Diagnostic
from motionlang.execution import language_of, machine_of
from motionlang.lang.dialect import dialect, dialects
from motionlang.repl.commands import load_file
from motionlang.repl.lines import read_lines
from motionlang.repl.session import Session
from motionlang.views.diagnostics import render
from motionlang.views.terminal import draws, is_terminal, plain, wants_colour


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang repl` and its options."""
    parser = add_command(commands, "repl", summary, _repl)
    parser.add_argument("file", metavar="FILE", nargs="?", help="a program to run first, or the language")
    add_machine(parser)
    add_world(parser)


def _repl(arguments: argparse.Namespace) -> int:
    settings: dict[str, object] = {}
    overrides: dict[str, float | str] = {}
    if arguments.file in dialects() and not os.path.exists(arguments.file):
        arguments.dialect, arguments.file = arguments.dialect or arguments.file, None
    language = language_of(arguments.dialect, arguments.file or "")
    set_values(arguments.set, settings, overrides, arguments.parser, language)
    options = Options(arguments.file or "")
    options.dialect = arguments.dialect
    options.machine = machine_of(arguments.file or None, arguments.machine)
    if options.machine is not None:
        status = read_machine_file(options, settings)
        if status:
            return status
    laid = with_world(settings, world_of(arguments), arguments.file or "")
    return 2 if laid is None else open_session(arguments.dialect, arguments.file, laid, overrides)


def open_session(
    dialect_name: str | None = None,
    file: str | None = None,
    machine_settings: Mapping[str, object] | None = None,
    overrides: Mapping[str, float | str] | None = None,
) -> int:
    """Open a session, after running `file` if given; 1 on an error without a terminal.

    Without a dialect name the file's extension selects the dialect; the default is Mint.
    """
    language = language_of(dialect_name, file or "") or dialect("mint")
    at_terminal = is_terminal(sys.stdin) and is_terminal(sys.stdout)
    complain = _show if at_terminal else _complain
    try:
        session = Session(language, machine_settings, overrides, show=_show, complain=complain)
    except Rejected as rejected:
        _complain(render(Diagnostic(rejected.code, rejected.message, hint=rejected.hint)))
        return 1
    session.colour = wants_colour(sys.stdout if at_terminal else sys.stderr)
    if file is not None:
        load_file(session, file)
    if at_terminal:
        from motionlang.repl.prompt import converse

        return converse(session)
    return read_lines(session)


def _show(text: str) -> None:
    print(text if draws(sys.stdout) else plain(text), end="", flush=True)


def _complain(text: str) -> None:
    print(text, end="", file=sys.stderr, flush=True)
