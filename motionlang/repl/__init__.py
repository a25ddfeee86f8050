"""The prompt: `motionlang repl`."""

from __future__ import annotations

from collections.abc import Mapping


def main(
    dialect_name: str | None = None,
    file: str | None = None,
    machine_settings: Mapping[str, object] | None = None,
    overrides: Mapping[str, float | str] | None = None,
) -> int:
    """Open a session, after running `file` if there is one; 1 if anything was wrong and no person sat before it.

    Without a name the file's suffix says which dialect is spoken, and it is Mint where nothing does.
    """
    import sys

    from motionlang.controller.faults import Refusal
    from motionlang.errors import Diagnostic
    from motionlang.execution import dialect, dialect_of
    from motionlang.repl.commands import load_file
    from motionlang.repl.session import Session
    from motionlang.views.diagnostics import render
    from motionlang.views.terminal import is_terminal, wants_colour

    language = (dialect(dialect_name) if dialect_name else dialect_of(file or "")) or dialect("mint")
    at_terminal = is_terminal(sys.stdin) and is_terminal(sys.stdout)
    complain = _show if at_terminal else _complain
    try:
        session = Session(language, machine_settings, overrides, show=_show, complain=complain)
    except Refusal as refusal:
        _complain(render(Diagnostic(refusal.code, refusal.message, hint=refusal.hint)))
        return 1
    session.colour = wants_colour(sys.stdout if at_terminal else sys.stderr)
    if file is not None:
        load_file(session, file)
    if at_terminal:
        from motionlang.repl.prompt import converse

        return converse(session)
    from motionlang.repl.lines import read_lines

    return read_lines(session)


def _show(text: str) -> None:
    import sys

    from motionlang.views.terminal import draws, plain

    print(text if draws(sys.stdout) else plain(text), end="", flush=True)


def _complain(text: str) -> None:
    import sys

    print(text, end="", file=sys.stderr, flush=True)
