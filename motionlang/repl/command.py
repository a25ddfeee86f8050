"""`motionlang repl`: a program typed line by line."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from dataclasses import dataclass

from motionlang.cli.command import argument
from motionlang.cli.option_groups import ProgramOptions, WorldOptions, with_world
from motionlang.kernel import Diagnostic, Rejected, Source, dialect, dialects, language_of
from motionlang.repl.commands import load_file
from motionlang.repl.interrupt import Interrupts
from motionlang.repl.session import Session
from motionlang.views.diagnostics import render
from motionlang.views.terminal import draws, is_terminal, plain, wants_colour


@dataclass
class Repl(WorldOptions, ProgramOptions):
    """Type a program line by line at an interactive prompt."""

    file: str = argument("FILE", "a program to run first, or the language", default="")

    def check(self) -> None:
        if self.file in dialects() and not os.path.exists(self.file):
            self.lang, self.file = self.lang or self.file, ""
        super().check()

    def run(self) -> int:
        settings = with_world(self.settings(), self.entries())
        return open_session(self.lang, self.file or None, settings, self.overrides())


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


def read_lines(session: Session) -> int:
    """Execute every line of standard input, without a terminal; return 1 if any had an error.

    An INPUT takes the next line. Ctrl-C ends the command cleanly and then raises KeyboardInterrupt, because no user
    can continue the session.
    """
    interrupts = Interrupts()
    session.interrupted = interrupts.pressed
    lines = map(_text, getattr(sys.stdin, "buffer", sys.stdin))
    session.ask = lambda begun: next(lines, None)
    for line in lines:
        with interrupts:
            session.feed(line)
            if interrupts.pressed():
                raise KeyboardInterrupt
        if session.over:
            break
    session.finish()
    return 1 if session.failed else 0


def _text(raw: str | bytes) -> str:
    return (raw if isinstance(raw, str) else Source.from_bytes("", raw).text).rstrip("\n")


def _show(text: str) -> None:
    print(text if draws(sys.stdout) else plain(text), end="", flush=True)


def _complain(text: str) -> None:
    print(text, end="", file=sys.stderr, flush=True)
