"""A program's output on a terminal and in a pipe: escape sequences have no effect."""

from __future__ import annotations

import sys

import pytest

from motionlang.views.terminal import harmless
from tests.cli.programs import Cell

NASTY = 'PRINT Chr(27); "]0;owned"; Chr(7)\nPRINT Chr(155); "2J"\nPRINT "a"; Chr(9); "b"\n'


def test_escape_sequences_are_shown_as_pictures_on_a_terminal(
    cell: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    cell.write("a.mnt", NASTY)
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    ran = cell("run", "a.mnt", "--format", "none")
    assert ran.out == "␛]0;owned\a\n\ufffd2J\na\tb\n"


def test_a_pipe_gets_what_was_printed(cell: Cell) -> None:
    cell.write("a.mnt", NASTY)
    assert cell("run", "a.mnt", "--format", "none").out == "\x1b]0;owned\a\n\x9b2J\na\tb\n"


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("plain", "plain"),
        ("\x1b[2J\x1b[H\x1b[3;7Hx\r\n", "\x1b[2J\x1b[H\x1b[3;7Hx\r\n"),
        ("\x1b[31mred", "␛[31mred"),
        ("\x1b[3J\x1b[6n", "␛[3J␛[6n"),
        ("\x1b]52;c;eA==\x07", "␛]52;c;eA==\x07"),
        ("\x1b", "␛"),
        ("\x00\x7f\x85°", "␀␡\ufffd°"),
    ],
)
def test_what_clears_the_screen_or_places_the_cursor_is_obeyed(text: str, shown: str) -> None:
    assert harmless(text) == shown
