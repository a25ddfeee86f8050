"""A terminal while a command runs: keys are not echoed, and a line says how to end it."""

from __future__ import annotations

import io
import os
import threading

import pytest

from motionlang.kernel import dialect
from motionlang.repl.running import LINE, Running
from motionlang.repl.session import Session
from motionlang.views import progress
from motionlang.views.single_keys import single_keys


class Terminal(io.StringIO):
    """A screen that notifies when the line appears."""

    def __init__(self) -> None:
        super().__init__()
        self.has_line = threading.Event()

    def isatty(self) -> bool:
        return True

    def write(self, text: str) -> int:
        count = super().write(text)
        if LINE in self.getvalue():
            self.has_line.set()
        return count


@pytest.mark.parametrize("term", ["xterm", "dumb"])
def test_the_line_appears_and_disappears_while_the_user_is_asked(
    term: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(progress, "RUN_PATIENCE", 0.01)
    monkeypatch.setenv("TERM", term)
    screen = Terminal()
    monkeypatch.setattr("sys.stderr", screen)
    session = Session(dialect("mint"), show=lambda text: print(text, end="", file=screen))
    asked: list[bool] = []

    def answer(begun: str) -> str:
        asked.append(running.is_shown)
        return "5"

    session.ask = answer
    running = Running(session)
    session.feed("Dim n As Integer")
    with running:
        assert screen.has_line.wait(60 if term == "xterm" else 0.1) == (term == "xterm")
        assert running.is_shown == (term == "xterm")
        session.feed("INPUT n\nPRINT n")
    assert asked == [False]
    assert not running.is_shown
    assert screen.getvalue().endswith("5\n") or term == "xterm"


def test_keys_typed_ahead_stay_and_are_not_echoed() -> None:
    pty, termios = pytest.importorskip("pty"), pytest.importorskip("termios")
    ours, theirs = pty.openpty()
    os.write(ours, b"a\n")
    before = termios.tcgetattr(theirs)
    with single_keys(theirs):
        assert not termios.tcgetattr(theirs)[3] & termios.ECHO
        assert os.read(theirs, 10) == b"a\n"
    assert termios.tcgetattr(theirs) == before
    os.close(ours)
    os.close(theirs)
