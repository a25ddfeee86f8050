"""The capabilities of a stream, and the environment variables for it."""

from __future__ import annotations

import io

import pytest

from motionlang.views.terminal import (
    cells,
    draws,
    is_terminal,
    printable,
    styled,
    table_width,
    wants_colour,
    width_of,
)


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("variables", "at_terminal", "in_file"),
    [
        ({}, True, False),
        ({"TERM": "dumb"}, False, False),
        ({"NO_COLOR": "1"}, False, False),
        ({"NO_COLOR": ""}, True, False),
        ({"FORCE_COLOR": "1"}, True, True),
        ({"FORCE_COLOR": "1", "TERM": "dumb"}, True, True),
        ({"FORCE_COLOR": "1", "NO_COLOR": "1"}, False, False),
    ],
)
def test_colours_are_for_those_who_want_them(
    monkeypatch: pytest.MonkeyPatch, variables: dict[str, str], at_terminal: bool, in_file: bool
) -> None:
    for name in ("NO_COLOR", "FORCE_COLOR"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("TERM", "xterm")
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert (wants_colour(Terminal()), wants_colour(io.StringIO())) == (at_terminal, in_file)


def test_a_closed_stream_is_no_terminal() -> None:
    stream = Terminal()
    assert is_terminal(stream)
    closed = io.StringIO()
    closed.close()
    assert not is_terminal(closed)


@pytest.mark.parametrize(("columns", "width"), [("72", 72), ("0", 100), ("", 100), ("wide", 100)])
def test_the_width_is_columns_or_a_hundred(monkeypatch: pytest.MonkeyPatch, columns: str, width: int) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    assert width_of(io.StringIO()) == width


def test_a_table_in_a_pipe_has_room_for_all_columns(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "37")
    stream = io.StringIO()
    assert table_width(stream) == 160
    monkeypatch.setattr(stream, "isatty", lambda: True)
    assert table_width(stream) == 37


def test_only_unicode_has_lines() -> None:
    assert draws(io.TextIOWrapper(io.BytesIO(), encoding="utf-8"))
    assert not draws(io.TextIOWrapper(io.BytesIO(), encoding="latin-1"))


@pytest.mark.parametrize(
    ("style", "shown"),
    [
        ("error", "\x1b[1;31mx\x1b[0m"),
        ("location", "\x1b[34mx\x1b[0m"),
        ("dim", "\x1b[2mx\x1b[0m"),
        ("segment", "x"),
        ("", "x"),
    ],
)
def test_styles_paint_and_nothing_else(style: str, shown: str) -> None:
    assert (styled("x", style, True), styled("x", style, False)) == (shown, "x")


@pytest.mark.parametrize(
    ("text", "count"), [("abc", 3), ("é", 1), ("e\u0301", 1), ("漢字", 4), ("├ accel", 7)]
)
def test_cells_that_a_text_takes_up(text: str, count: int) -> None:
    assert cells(text) == count


def test_what_a_terminal_would_obey_is_pictured() -> None:
    assert printable("a\x1b[2J\x07\x7f\u202e") == "a␛[2J␇␡\ufffd"
