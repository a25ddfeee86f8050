"""Hover, definition, references, rename, symbols and folding."""

from __future__ import annotations

import pytest

from motionlang_lsp.editor import navigation
from motionlang_lsp.editor.hover import hover
from motionlang_lsp.editor.navigation import RenameRefused
from test_lsp.editor.pages import at_cursor, page
from tests.cases import cases

PROGRAM = """\
Const limit = 250 ' mm
Dim count As Integer
' Moves by a distance.
' The axis has to be enabled.
Sub Travel(far As Float)
  MOVER(0) = far : GO(0)
  count = count + 1
End Sub
Travel(limit)
"""


def with_cursor(line: str) -> str:
    """Return `PROGRAM` with the cursor `|` of `line`, which is one of its lines."""
    return PROGRAM.replace(line.replace("|", ""), line, 1)


# A line of `PROGRAM` with the cursor, and texts that the page there has.
PAGES = (
    ("Travel(lim|it)", ("Const limit = 250", "mm", "value `250`", "used once")),
    ("|Travel(limit)", ("Sub Travel(far As Float)", "Moves by a distance. The axis has to be enabled.")),
    ("  count = cou|nt + 1", ("Dim count As Integer", "variable", "used twice")),
    ("  MOVER(0) = far| : GO(0)", ("far As Float", "parameter of Travel")),
    ("  MO|VER(0) = far : GO(0)", ("**MOVER** · move", "unit: user units", "known from")),
)


@cases("line, wanted", PAGES)
def test_hover_shows_what_is_known(line: str, wanted: tuple[str, ...]) -> None:
    shown = hover(*at_cursor(with_cursor(line)))
    assert shown is not None
    assert [text for text in wanted if text not in shown.markdown] == []


def test_hover_of_a_macro_shows_its_line() -> None:
    shown = hover(*at_cursor("MD3,1MR100,1WS\nMC|3\n", "mccl"))
    assert shown is not None
    assert "MD3,1MR100,1WS" in shown.markdown


CHANNELS = "' IN 3 door   OUT 2 lamp\nPAUSE INX(3)\nOUTX(2) = INX(3)\nEvent IN3\nSTOP(0)\nEnd Event\n"


@cases(
    "line, wanted",
    [
        (
            "PAUSE I|NX(3)",
            "input 3 (door); waited for at line 2; read at line 3; starts event IN3\n\n**INX",
        ),
        ("|OUTX(2) = INX(3)", "output 2 (lamp); written at line 3\n\n**OUTX"),
        ("OUTX(2) = INX|(3)", "input 3 (door); waited for at line 2"),
        ("ST|OP(0)", "**STOP"),
    ],
)
def test_hover_of_a_channel_lists_its_uses(line: str, wanted: str) -> None:
    shown = hover(*at_cursor(CHANNELS.replace(line.replace("|", ""), line, 1)))
    assert shown is not None
    assert shown.markdown.startswith(wanted)


def test_hover_of_a_channel_in_mccl() -> None:
    shown = hover(*at_cursor("; in 3 press open\nW|N3,CN9\nIF3,CF9\n", "mccl"))
    assert shown is not None
    assert shown.markdown.startswith("input 3 (press open); waited for at line 2; read at line 3\n\n**WN**")


def test_hover_in_a_text_with_errors_has_only_the_keyword() -> None:
    shown = hover(*at_cursor("PAUSE I|NX(3)\nPAUSE (\n"))
    assert shown is not None
    assert shown.markdown.startswith("**INX**")


def test_nothing_is_known_of_a_number() -> None:
    assert hover(*at_cursor("x = 1|2\nPrint x\n")) is None


def test_the_definition_of_a_name_is_its_declaration() -> None:
    shown, offset = at_cursor(with_cursor("Travel(lim|it)"))
    assert navigation.definition(shown, offset) == (6, 11)


def test_a_member_is_declared_in_its_type_even_if_that_follows() -> None:
    text = "Dim j As Job\nj.si|ze = 1\nType Job\n  Dim size As Float\nEnd Type\n"
    shown, offset = at_cursor(text)
    declared = shown.text.index("size As Float")
    assert navigation.definition(shown, offset) == (declared, declared + len("size"))


@pytest.mark.parametrize("use", ["Dim j As Jo|b\n", "Dim j(3) As Jo|b\n", "Sub S(j As Jo|b)\nEnd Sub\n"])
def test_a_type_is_declared_where_its_block_begins(use: str) -> None:
    text = f"{use}Type Job\n  Dim size As Float\nEnd Type\nDim k As Job\n"
    shown, offset = at_cursor(text)
    declared, first, last = (
        shown.text.index("Type Job") + 5,
        shown.text.index("Job"),
        shown.text.rindex("Job"),
    )
    assert navigation.definition(shown, offset) == (declared, declared + 3)
    uses = navigation.references(shown, offset, declaration=False)
    assert uses == [(first, first + 3), (last, last + 3)]
    page_of_it = hover(shown, offset)
    assert page_of_it is not None
    assert "Type Job: size" in page_of_it.markdown


def test_references_are_all_uses_with_or_without_the_declaration() -> None:
    shown, offset = at_cursor(with_cursor("  count = cou|nt + 1"))
    lines = [shown.source.location(start)[0] for start, _ in navigation.references(shown, offset)]
    assert lines == [2, 7, 7]
    assert len(navigation.references(shown, offset, declaration=False)) == 2


def test_a_new_name_changes_all_uses() -> None:
    shown, offset = at_cursor("n = 1\nFor n = 1 To 3\nNext |n\n")
    assert [(each.span, each.text) for each in navigation.rename(shown, offset, "i")] == [
        ((0, 1), "i"), ((10, 11), "i"), ((26, 27), "i"),
    ]  # fmt: skip


# A text with the cursor, and why nothing there gets the name `speed`.
REFUSED = (
    ("GO|(0)\n", "GO is a keyword"),
    ("Print 1|2\n", "there is no name here"),
    ("x| = 1\nPrint x\n", "SPEED is a keyword of Mint"),
    ("x| = 1\nPrint x +\n", "the text has lines that cannot be read; correct them first"),
    ("Event IN|1\nEnd Event\n", "an event handler has the name of its event"),
)


@cases("text, reason", REFUSED)
def test_a_name_is_refused_with_a_reason(text: str, reason: str) -> None:
    with pytest.raises(RenameRefused) as refused:
        navigation.rename(*at_cursor(text), "speed")
    assert str(refused.value) == reason


@pytest.mark.parametrize("name", ["x1", "_x", "A_b2", "X"])
def test_a_new_name_has_letters_digits_and_underscores(name: str) -> None:
    assert [each.text for each in navigation.rename(*at_cursor("x| = 1\nPrint x\n"), name)] == [name, name]


@pytest.mark.parametrize("name", ["", "1x", "a b", "x.1", "x+1", "x ", " x", "x:", "#x", "ü", "Dim", "step"])
def test_what_is_no_name_is_refused(name: str) -> None:
    with pytest.raises(RenameRefused) as refused:
        navigation.rename(*at_cursor("x| = 1\nPrint x\n"), name)
    assert str(refused.value) == f"{name} is not a name: use letters, digits and _, and no keyword"


def test_spans_of_names() -> None:
    text = "Dim parts As Integer\nSub Travel()\n  parts = parts + 1\nEnd Sub\nTravel()\n"
    names = page(text).names
    assert [each.name for each in names.definitions] == ["parts", "Travel"]
    travel = names.definitions[1]
    assert travel.span == (25, 31)  # behind a line of 21 characters and `Sub `
    assert travel.scope == (0, len(text))
    assert names.blocks[0].span == (21, text.index("End Sub") + 7)
