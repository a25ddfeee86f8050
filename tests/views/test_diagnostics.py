"""Error messages, complete, as they are displayed."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel import Diagnostic, Source
from motionlang.views.diagnostics import render, render_all, tally
from motionlang.views.terminal import cells
from tests.cases import examples

PROGRAM = Source(
    "pick.mnt",
    "SPEED = 250\n"
    "\tMOVR(0) = 12\n"
    "漢字 = FOO(3)\n" + "x = 1 + " * 100_000 + "\nPRINT \x1b[31mred\x00\n" + "\n" * 94 + "If x Then\n",
)

MESSAGES = {
    "word": (
        Diagnostic("unknown-word", "there is no keyword MOVR", 2, 2, length=4, hint="did you mean MOVER?"),
        """\
error[unknown-word]: there is no keyword MOVR
 --> pick.mnt:2:2
  |
2 |     MOVR(0) = 12
  |     ^^^^
  hint: did you mean MOVER?
""",
    ),
    "wide letters": (
        Diagnostic("unknown-word", "there is no keyword FOO", 3, 6, length=3),
        """\
error[unknown-word]: there is no keyword FOO
 --> pick.mnt:3:6
  |
3 | 漢字 = FOO(3)
  |        ^^^
""",
    ),
    "a line of 800 kB, in the middle": (
        Diagnostic("syntax", "this is too much", 4, 400_001, length=1),
        """\
error[syntax]: this is too much
 --> pick.mnt:4:400001
  |
4 | …x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 …
  |                                                  ^
""",
    ),
    "the same line, at its start": (
        Diagnostic("syntax", "this is too much", 4, 1, length=700_000),
        """\
error[syntax]: this is too much
 --> pick.mnt:4:1
  |
4 | x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 + x = 1 +…
  | ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
""",
    ),
    "characters that a terminal would obey": (
        Diagnostic("syntax", "a stray \x1b[31m", 5, 7, length=8),
        """\
error[syntax]: a stray ␛[31m
 --> pick.mnt:5:7
  |
5 | PRINT ␛[31mred␀
  |       ^^^^^^^^
""",
    ),
    "a number of three digits": (
        Diagnostic("missing-end", "If is never closed", 100, 1, length=2, hint="close it with End If"),
        """\
error[missing-end]: If is never closed
   --> pick.mnt:100:1
    |
100 | If x Then
    | ^^
    hint: close it with End If
""",
    ),
    "behind the end of the line": (
        Diagnostic("syntax", "something is missing", 1, 12),
        """\
error[syntax]: something is missing
 --> pick.mnt:1:12
  |
1 | SPEED = 250
  |            ^
""",
    ),
    "only the line is known": (
        Diagnostic("not-simulated", "CAM is not simulated", 1, severity="warning"),
        """\
warning[not-simulated]: CAM is not simulated
 --> pick.mnt:1
  |
1 | SPEED = 250
""",
    ),
    "the whole file": (
        Diagnostic("file", "the file is empty"),
        """\
error[file]: the file is empty
 --> pick.mnt
""",
    ),
}


@pytest.mark.parametrize(("diagnostic", "message"), MESSAGES.values(), ids=MESSAGES)
def test_whole_messages(diagnostic: Diagnostic, message: str) -> None:
    assert render(diagnostic, PROGRAM) == message


def test_without_a_source_there_is_no_location() -> None:
    diagnostic = Diagnostic("file", "pick.mnt cannot be read: no such file", hint="look again")
    assert render(diagnostic) == "error[file]: pick.mnt cannot be read: no such file\n  hint: look again\n"


def test_the_file_as_the_user_called_it() -> None:
    assert " --> cell/pick.mnt:1:1\n" in render(
        Diagnostic("syntax", "no", 1, 1), PROGRAM, name="cell/pick.mnt"
    )


def test_colours_only_paint() -> None:
    diagnostic = MESSAGES["word"][0]
    painted = render(diagnostic, PROGRAM, colour=True)
    assert "\x1b[1;31merror[unknown-word]\x1b[0m" in painted
    plain = painted
    for number in ("0", "1", "1;31", "34", "1;36"):
        plain = plain.replace(f"\x1b[{number}m", "")
    assert plain == MESSAGES["word"][1]


def test_several_are_separated_and_counted() -> None:
    two = [
        Diagnostic("syntax", "one"),
        Diagnostic("syntax", "two"),
        Diagnostic("syntax", "x", severity="warning"),
    ]
    assert render_all(two[:2]) == "error[syntax]: one\n\nerror[syntax]: two\n"
    assert tally(two) == "2 errors, 1 warning"
    assert tally([]) == ""


@settings(max_examples=examples(300))
@given(
    text=st.text(st.characters(codec="utf-8"), max_size=300),
    column=st.integers(0, 400),
    length=st.integers(0, 500),
    width=st.integers(1, 120),
)
def test_any_text_is_shown_within_the_width(text: str, column: int, length: int, width: int) -> None:
    source = Source("x.mnt", text)
    message = render(Diagnostic("syntax", "no", 1, column, length=length), source, width=width)
    for line in message.splitlines()[2:]:
        assert line.isprintable()
        assert cells(line) <= max(width, 24)


def test_times_of_a_repeated_diagnostic_have_no_power_of_ten() -> None:
    found = Diagnostic("range", "SPEED cannot be -1", 1)
    found.count, found.first, found.last = 500_000, 1e-05, 9.99999
    assert "  note: 500 000 times, from 0.00001 s to 9.99999 s\n" in render(found, PROGRAM)


LETTERS = "abcdefghijklmnopqrstuvwxyz0123456789"


@pytest.mark.parametrize(
    ("line", "column", "length", "shown", "marked"),
    [
        (LETTERS, 1, 1, "abcdefghijklmnopqrs…", "^"),
        (LETTERS, 1, 36, "abcdefghijklmnopqrs…", "^^^^^^^^^^^^^^^^^^^"),
        (LETTERS, 5, 3, "abcdefghijklmnopqrs…", "    ^^^"),
        (LETTERS, 19, 1, "abcdefghijklmnopqrs…", "                  ^"),
        # A mark further on has ten cells before it.
        (LETTERS, 20, 1, "…jklmnopqrstuvwxyz0…", "           ^"),
        (LETTERS, 21, 1, "…klmnopqrstuvwxyz01…", "           ^"),
        (LETTERS, 25, 4, "…opqrstuvwxyz012345…", "           ^^^^"),
        (LETTERS, 36, 1, "…z0123456789", "           ^"),
        (LETTERS, 37, 1, "…0123456789", "           ^"),
        (LETTERS, 0, 1, "abcdefghijklmnopqrs…", None),
        # A line of 20 letters fits, with a mark behind it it does not.
        (LETTERS[:20], 20, 1, "abcdefghijklmnopqrst", "                   ^"),
        (LETTERS[:20], 21, 1, "…klmnopqrst", "           ^"),
        (LETTERS[:20], 15, 9, "abcdefghijklmnopqrst", "              ^^^^^^"),
        # A tab goes to the next fourth cell, a letter of Japanese has two cells.
        ("\tab\tc", 2, 2, "    ab  c", "    ^^"),
        ("\tab\tc", 5, 1, "    ab  c", "        ^"),
        ("日本語日本語日本語日本語", 6, 2, "日本語日本語日本語…", "          ^^^^"),
        ("", 1, 1, "", "^"),
    ],
)
def test_the_excerpt_in_twenty_cells(
    line: str, column: int, length: int, shown: str, marked: str | None
) -> None:
    text = render(Diagnostic("syntax", "m", 1, column, length=length), Source("a", line), width=24)
    excerpt, *below = text.split("\n")[3:-1]
    assert excerpt == f"1 | {shown}".rstrip()
    assert below == ([] if marked is None else [f"  | {marked}"])
