"""Typographic characters, their messages and their plain replacements."""

from __future__ import annotations

from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT
from tests.cases import cases

QUOTE, DASH = '“ is a typographic quote, not a plain "', "– is a typographic dash, not a plain -"
APOSTROPHE, MINUS = "’ is a typographic quote, not a plain '", "− is a typographic dash, not a plain -"
BLANK = "this is a non-breaking space, not a plain one"


@cases(
    "line, column, length, message, hint, fix",
    [
        ("PRINT “near”", 7, 6, QUOTE, 'type "', '"near"'),
        ('PRINT “near"', 7, 6, QUOTE, 'type "', '"near"'),
        ("PRINT “”", 7, 2, QUOTE, 'type "', '""'),
        ("PRINT \x93near\x94", 7, 1, QUOTE, 'type "', ""),  # Windows-1252
        ('PRINT "near”', 7, 6, QUOTE.replace("“", "”"), 'type "', '"near"'),
        ("PRINT 1 ’ don’t stop", 9, 1, APOSTROPHE, "type '", "'"),
        ("n = 5 – 3", 7, 1, DASH, "type -", "-"),
        ("n = − 5", 5, 1, MINUS, "type -", "-"),
        ("n =\u00a05", 4, 1, BLANK, "type a plain space", " "),
    ],
)
def test_a_typographic_character_is_named_with_its_replacement(
    line: str, column: int, length: int, message: str, hint: str, fix: str
) -> None:
    found = check(Source("a.mnt", line), DIALECT)[0]
    assert (found.column, found.length, found.message, found.hint, found.fix) == (
        column, length, message, hint, fix,
    )  # fmt: skip
