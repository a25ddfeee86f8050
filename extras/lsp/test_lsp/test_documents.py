"""Positions and offsets of a text, and what is sent of two lists of tokens."""

from __future__ import annotations

from functools import partial
from typing import Any

import pytest
from lsprotocol import types

from motionlang.kernel import Diagnostic
from motionlang_lsp.convert import diagnostic
from motionlang_lsp.documents import OpenDocument, characters
from test_lsp.test_answers import span
from test_lsp.wire import URI
from tests.counted_calls import all_calls

CONVERTED = [
    ((2, 3, 4), span(1, 2, 6)),
    ((2, 3, 0), span(1, 2, 3)),
    ((2, 3, 99), span(1, 2, 9)),
    ((2, 99, 1), span(1, 9, 9)),
    ((2, 1, 1), span(1, 0, 1)),
    ((2, 0, 0), span(1, 2, 7)),
    ((0, 0, 0), span(0, 0, 5)),
    ((0, 3, 1), span(0, 0, 5)),
    ((3, 0, 0), span(2, 0, 0)),
    ((9, 1, 1), span(2, 0, 0)),
]


@pytest.mark.parametrize(("place", "wanted"), CONVERTED)
def test_a_diagnostic_marks_its_place_or_its_line(
    place: tuple[int, int, int], wanted: dict[str, Any]
) -> None:
    """A line is marked without the blanks around it.

    No place at all is the first line.
    """
    document = OpenDocument(URI, "first\n  one b  \n", 1)
    found = diagnostic(document, Diagnostic("syntax", "message", *place[:2], length=place[2]))
    start, end = found.range.start, found.range.end
    assert (start.line, start.character, end.line, end.character) == (
        wanted["start"]["line"], wanted["start"]["character"], wanted["end"]["line"], wanted["end"]["character"],
    )  # fmt: skip
    assert found.message == "message"


@pytest.mark.parametrize(
    ("line", "count", "wanted"),
    [
        ("abc", 2, 2),
        ("abc", 9, 3),
        ("abc", 0, 0),
        ("\u00e4bc", 2, 2),
        ("\u00e4bc", 9, 3),
        ("\u00e4bc", 0, 0),
        ("\U0001f527bc", 1, 0),
        ("\U0001f527bc", 2, 1),
        ("\U0001f527bc", 3, 2),
        ("\uffffbc", 1, 1),
    ],
)
def test_characters_of_utf_16_units(line: str, count: int, wanted: int) -> None:
    """A character above U+FFFF has two units; half of it is none of it."""
    assert characters(line, count) == wanted


def test_a_change_in_a_text_of_twice_the_length_is_twice_the_work() -> None:
    start, calls = types.Position(0, 0), []
    inserted = types.TextDocumentContentChangePartial(types.Range(start, start), " ")
    for count in (20, 500, 1000):  # the first one prepares
        document = OpenDocument(URI, "MOVER(0) = 5\n" * count, 1)
        calls.append(all_calls(partial(document.change, [inserted], 2)))
    assert calls[2] <= 2.1 * calls[1]


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_positions_of_offsets(end: str) -> None:
    """An offset counts one character for a line end."""
    document = OpenDocument(URI, f"ab{end}\U0001f527c{end}", 1)
    places = [(0, 0), (0, 1), (0, 2), (1, 0), (1, 2), (1, 3), (2, 0)]
    for offset, (line, character) in enumerate(places):
        position = types.Position(line, character)
        assert document.position(offset) == position
        assert document.offset(position) == offset
    assert document.position(-1) == types.Position(0, 0)
    assert document.position(99) == types.Position(2, 0)
    for line, character, offset in ((0, 9, 2), (1, 9, 5), (9, 0, 6), (2, 5, 6)):
        assert document.offset(types.Position(line, character)) == offset
    assert [document.source_offset(line) for line in (1, 2, 3, 4)] == [0, 3, 6, 6]


def test_a_position_behind_an_empty_line_is_its_end() -> None:
    document = OpenDocument(URI, "\nabc", 1)
    assert [document.offset(types.Position(0, character)) for character in (0, 1, 9)] == [0, 0, 0]


@pytest.mark.parametrize(
    ("uri", "name"),
    [(URI, "a.mnt"), ("file:///a/b/", "b"), ("untitled:1", "untitled:1"), ("/", "/"), ("b", "b")],
)
def test_the_file_name_of_a_text(uri: str, name: str) -> None:
    assert OpenDocument(uri, "", 1).name == name
