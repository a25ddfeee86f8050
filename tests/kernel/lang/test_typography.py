"""Typographic characters, their messages and their plain replacements."""

from __future__ import annotations

from motionlang.kernel.lang.typography import plain, typographic, unclosed
from tests.cases import cases


@cases(
    "line, length, replacement",
    [
        ("“near” : PRINT 1", 6, '"near"'),
        ('"near” : PRINT 1', 6, '"near"'),
        ("“near", 1, '"'),
        ("“”", 2, '""'),
        ("’ a comment", 1, "'"),
        ("’ don’t stop", 1, "'"),
        ("‘a’ b", 0, ""),
        ("− 5", 1, "-"),
        ("\u00a05", 1, " "),
        ("x", 0, ""),
        ("", 0, ""),
    ],
)
def test_the_plain_text_of_the_beginning_of_a_line(line: str, length: int, replacement: str) -> None:
    """With a second single quote the replacement is not certain."""
    assert plain(line) == (length, replacement)


@cases(
    "text, found",
    [
        ("“near”", ('“ is a typographic quote, not a plain "', 'type "')),
        ("’", ("’ is a typographic quote, not a plain '", "type '")),
        ("–5", ("– is a typographic dash, not a plain -", "type -")),
        ("\x93near", ('“ is a typographic quote, not a plain "', 'type "')),
        ("\u00a0", ("this is a non-breaking space, not a plain one", "type a plain space")),
        ("\x80", None),
        ('"', None),
        ("", None),
    ],
)
def test_a_typographic_character_is_named(text: str, found: tuple[str, str] | None) -> None:
    """Windows-1252 has its quotes at 91 to 94 hex."""
    assert typographic(text) == found


@cases(
    "text, found",
    [
        ('"near”', ('” is a typographic quote, not a plain "', 'type "')),
        ('"near', None),
        ("near”", None),
        ("“near”", None),
        ("", None),
    ],
)
def test_a_text_that_a_typographic_quote_closes(text: str, found: tuple[str, str] | None) -> None:
    assert unclosed(text) == found
