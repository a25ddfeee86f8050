"""The prompt at a terminal.

It has history, highlighting, completion and blocks, and shows the machine in the bottom bar.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from contextlib import nullcontext
from textwrap import wrap

from prompt_toolkit import PromptSession
from prompt_toolkit.auto_suggest import AutoSuggestFromHistory
from prompt_toolkit.document import Document
from prompt_toolkit.formatted_text import ANSI, StyleAndTextTuples
from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent
from prompt_toolkit.lexers import Lexer
from prompt_toolkit.output import ColorDepth
from prompt_toolkit.patch_stdout import patch_stdout
from prompt_toolkit.styles import Style

from motionlang.kernel import Dialect
from motionlang.kernel.version import __version__
from motionlang.repl import status
from motionlang.repl.commands import is_command
from motionlang.repl.complete import WordCompleter
from motionlang.repl.history import history
from motionlang.repl.interrupt import Interrupts
from motionlang.repl.live import Live
from motionlang.repl.running import Running
from motionlang.repl.session import Session
from motionlang.views.formatting import dialect_name
from motionlang.views.highlight import pieces
from motionlang.views.single_keys import has_keys, single_keys
from motionlang.views.terminal import width_of

# Seconds between two updates of the bottom bar in live mode.
REFRESH = 0.1
STYLE = Style.from_dict(
    {
        "prompt": "bold",
        "dotted": "ansimagenta",
        "move": "ansicyan bold",
        "keyword": "ansicyan",
        "not-simulated": "ansired",
        "control": "ansiblue bold",
        "unknown": "ansired underline",
        "axis": "bold",
        "register": "ansimagenta",
        "number": "ansigreen",
        "string": "ansiyellow",
        "comment": "ansibrightblack italic",
        "bottom-toolbar": "noreverse ansibrightblack",
        "bottom-toolbar.text": "",
    }
)
# The style of each kind of word.
_STYLES = {
    "move": "class:move",
    "keyword": "class:keyword",
    "not-simulated": "class:not-simulated",
    "control": "class:control",
    "number": "class:number",
    "axis": "class:axis",
    "register": "class:register",
    "string": "class:string",
    "text": "class:string",
    "comment": "class:comment",
    "bad": "class:unknown",
    "unknown": "class:unknown",
}


def banner(session: Session) -> str:
    """Return the line above the first prompt, which fits in 80 columns."""
    axes = len(session.machine.controller.axes)
    return (
        f"motionlang {__version__}, {dialect_name(session.dialect.name)}, {axes} axes. "
        "Tab completes, .help shows help, Ctrl-D ends."
    )


def converse(session: Session) -> int:
    """Read and execute lines until the user leaves; return 0.

    The exit status is always 0, because a person at a terminal has seen every error.
    """
    interrupts = Interrupts(echoed=not has_keys())
    session.interrupted = interrupts.pressed
    session.live = False
    live = Live(session)
    language, ask = session.dialect, _asker(session, live)
    session.ask = _answer
    running = Running(session)
    print("\n".join(wrap(banner(session), width_of(sys.stdout))))
    while not session.over:
        try:
            with patch_stdout(raw=True):
                text = ask.prompt(refresh_interval=REFRESH if session.live else 0)
        except KeyboardInterrupt:
            continue
        except EOFError:
            break
        # Keys typed ahead are echoed once, by the next prompt.
        with interrupts, single_keys(sys.stdin.fileno()) if has_keys() else nullcontext(), running:
            live.begin()
            session.width = width_of(sys.stdout)
            session.feed(text)
            live.end()
        if session.dialect is not language:
            language, ask = session.dialect, _asker(session, live)
    return 0


def _answer(begun: str) -> str | None:
    """Return the line that the user types after a question.

    The program itself prints both, as it prints the text of `[[answer]]`.
    """
    print(end="\r", flush=True)  # the question is overwritten by itself
    try:
        line = PromptSession[str](erase_when_done=True).prompt(ANSI(begun))
    except EOFError:
        line = None
    print(begun, end="", flush=True)
    return line


def _asker(session: Session, live: Live) -> PromptSession[str]:
    def bar() -> StyleAndTextTuples:
        live.catch_up()
        return [("", status.one_line(*session.shown) + ("   live" if session.live else ""))]

    name = session.dialect.name
    return PromptSession(
        [("class:prompt", f"{name}> ")],
        prompt_continuation=[("class:prompt", f"{'.' * len(name)}> ")],
        multiline=True,
        lexer=WordLexer(session.dialect),
        completer=WordCompleter(session.dialect),
        complete_while_typing=False,
        auto_suggest=AutoSuggestFromHistory(),
        history=history(name),
        bottom_toolbar=bar,
        key_bindings=_keys(session),
        style=STYLE,
        color_depth=ColorDepth.DEPTH_1_BIT if os.environ.get("NO_COLOR") else None,
    )


def _keys(session: Session) -> KeyBindings:
    """Return the key bindings.

    Enter executes a complete text and extends an incomplete one by a line. Alt-Enter always begins a new line.
    """
    keys = KeyBindings()

    @keys.add("enter")
    def enter(event: KeyPressEvent) -> None:
        buffer = event.current_buffer
        if buffer.complete_state and buffer.complete_state.current_completion:
            buffer.complete_state = None
        elif session.is_complete(buffer.text):
            buffer.validate_and_handle()
        else:
            buffer.newline(copy_margin=True)

    @keys.add("escape", "enter")
    def newline(event: KeyPressEvent) -> None:
        event.current_buffer.newline(copy_margin=True)

    return keys


def styled(dialect: Dialect, text: str) -> StyleAndTextTuples:
    """Split all of `text` into fragments, each with its style."""
    if is_command(text):
        return [("class:dotted", text)]
    return [(_STYLES.get(kind, ""), piece) for _, kind, piece in pieces(dialect, text)]


class WordLexer(Lexer):
    """`styled` for each line, in the form that the terminal needs."""

    def __init__(self, dialect: Dialect) -> None:
        self._dialect = dialect

    def lex_document(self, document: Document) -> Callable[[int], StyleAndTextTuples]:
        """Return a function from line number to styled text; it is empty past the end."""
        lines: list[StyleAndTextTuples] = [[]]
        for style, text, *_ in styled(self._dialect, document.text):
            first, *rest = text.split("\n")
            lines[-1].append((style, first))
            lines.extend([(style, fragment)] for fragment in rest)
        return lambda number: lines[number] if number < len(lines) else []
