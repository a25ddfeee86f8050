"""Complete answers of the editor: outlines, folds, signatures, edits, offsets."""

from __future__ import annotations

import pytest

from motionlang.kernel import Diagnostic, Source, dialect
from motionlang_lsp.editor import navigation
from motionlang_lsp.editor.completion import complete
from motionlang_lsp.editor.diagnostics import findings
from motionlang_lsp.editor.fixes import fixes
from motionlang_lsp.editor.formatting import format
from motionlang_lsp.editor.hover import hover
from motionlang_lsp.editor.machine_file import complete_machine_file, hover_machine_file
from motionlang_lsp.editor.navigation import OutlineEntry
from motionlang_lsp.editor.page import Page
from motionlang_lsp.editor.signature import signature
from motionlang_lsp.editor.times import times
from test_lsp.editor.pages import at_cursor, page
from tests.cases import cases

A = "```mint\nConst a = 1\n```"
ONE_TO_20 = " ".join(map(str, range(1, 21)))
COMMENTS = "".join(f"' {number}\n" for number in range(21))
NEVER = "constant · value `1` · never used"
# Language, a text with the cursor, the page there, and the word that it is about.
PAGES = (
    # The comments above belong to a declaration, and that behind it; none below it does.
    ("mint", "' one\n' two\nConst a| = 1 ' mm\n' last", f"{A}\n\none two mm\n\n{NEVER}", "a"),
    ("mint", "Print 1\n\n  ' one\n\t' two_*\nConst a| = 1\nPrint a, a, a",
     f"{A}\n\none two\\_\\*\n\nconstant · value `1` · used 3 times", "a"),
    ("mint", "' before\nPrint 1 ' not this\nConst a| = 1\n", f"{A}\n\n{NEVER}", "a"),
    ("mint", "' apart\n\nConst a| = 1\n", f"{A}\n\n{NEVER}", "a"),
    ("mint", "' one\n: ' two\nConst a| = 1\n", f"{A}\n\n{NEVER}", "a"),
    # Twenty comments at most, that of the line itself among them.
    ("mint", f"{COMMENTS}Const a| = 1\n", f"{A}\n\n{ONE_TO_20}\n\n{NEVER}", "a"),
    ("mint", f"{COMMENTS}Const a| = 1 ' mm\n", f"{A}\n\n{ONE_TO_20.removeprefix('1 ')} mm\n\n{NEVER}", "a"),
    ("mint", "Define speed2 = 3\nPrint spe|ed2\n",
     "```mint\nDefine speed2 = 3\n```\n\ndefine · replaced by `3` · used once", "speed2"),
    ("mint", "Sub s(n|)\nEnd Sub\n", "```mint\nn As Float\n```\n\nparameter of s · never used", "n"),
    ("mint", "#to|p\nGoto top\n", "```mint\n#top\n```\n\nlabel · used once", "top"),
    ("mccl", "MC|5\n", "```mccl\n5\n```\n\nmacro · used once · not defined in this file", "5"),
    ("mccl", "AL5,AR10,AA@1|0\n", "```mccl\nregister 10\n```\n\nregister · used twice", "10"),
    ("mccl", "; up\nMD3,1MR100 ; go\nMC3|\n", "```mccl\nMD3,1MR100 ; go\n```\n\nup go\n\nmacro · used once", "3"),
    ("mccl", "; no\n  \n  ; up\nMD3,1MN\nMC3|\n", "```mccl\nMD3,1MN\n```\n\nup\n\nmacro · used once", "3"),
    (
        "mint", "MOVERTES|T(0, 1) = 3\n",
        "**MOVERTEST** · setting\n\n"
        "*known, not simulated*: a run ends where the program uses it, unless it writes 0. "
        "Reason: the sources have only its name.\n\n"
        "listed by the type library without a meaning\n\n"
        "use: read and write · for: axis, param (code, Mint ActiveX type library, build 5626)"
        " · unit: number (code, Mint ActiveX type library, build 5626)"
        " · known from: Mint ActiveX type library, build 5626 "
        "(only the name, the arguments and the type; the meaning is assumed)",
        "MOVERTEST",
    ),
    (
        "mint", "I|f 1 Then Print 2\n",
        "**If** · statement\n\n"
        "*as remembered, not as printed*: no document that could be read says what it does.\n\n"
        "Do statements when a condition is true.\n\nuse: command"
        " · known from: MN1955 contents (from memory with low confidence, not checked against a manual)\n\n"
        '```mint\nIf 1 < 2 Then PRINT "yes" Else PRINT "no"\n```',
        "If",
    ),
)  # fmt: skip


@cases("language, text, markdown, word", PAGES)
def test_the_page_of_a_word(language: str, text: str, markdown: str, word: str) -> None:
    shown, offset = at_cursor(text, language)
    found = hover(shown, offset)
    assert found is not None
    assert (found.markdown, shown.text[slice(*found.span)]) == (markdown, word)


# Language, a text, and its outline: name, kind, detail, the whole text, and what is inside.
OUTLINES: tuple[tuple[str, str, list[object]], ...] = (
    ("mint", "Sub Travel(far As Float, n)\n  Dim a\nEnd Sub\nConst b = 1", [
        ("Travel", "sub", "far As Float, n As Float", "Sub Travel(far As Float, n)\n  Dim a\nEnd Sub",
         [("a", "variable", "Float", "a", [])]),
        ("b", "constant", "Integer", "b", []),
    ]),
    ("mint", "Event IN1\nPrint 1\nEnd Event\nStartup\nPrint 2\nEnd Startup\n#top\nGoto top", [
        ("IN1", "event", "", "Event IN1\nPrint 1\nEnd Event", []),
        ("Startup", "startup", "", "Startup\nPrint 2\nEnd Startup", []),
        ("top", "label", "", "top", []),
    ]),
    ("mint", "Type Job\n  Dim size As Float\nEnd Type\nTask t\n  Sub s\n  End Sub\nEnd Task", [
        ("Job", "type", "", "Type Job\n  Dim size As Float\nEnd Type", [("size", "member", "Float", "size", [])]),
        ("t", "task", "", "Task t\n  Sub s\n  End Sub\nEnd Task", [("s", "sub", "", "Sub s\n  End Sub", [])]),
    ]),
    ("mccl", "MD3,1MR100\nMD4,1WS\nMC5\nAL1,AR2", [
        ("3", "macro", "", "MD3,1MR100", []), ("4", "macro", "", "MD4,1WS", []),
    ]),
    ("mccl", "MD3,MD4,1WS", [("3", "macro", "", "MD3,MD4,1WS", [("4", "macro", "", "MD3,MD4,1WS", [])])]),
)  # fmt: skip


@cases("language, text, wanted", OUTLINES)
def test_the_outline_of_a_program(language: str, text: str, wanted: list[object]) -> None:
    def rows(symbols: list[OutlineEntry]) -> list[object]:
        assert [text[slice(*each.at)] for each in symbols] == [each.name for each in symbols]
        return [
            (each.name, each.kind, each.detail, text[slice(*each.span)], rows(each.inner)) for each in symbols
        ]

    assert rows(navigation.symbols(page(text, language))) == wanted


# A text, and its folds. The closing line of a block stays visible; one comment or one line has no fold.
FOLDS: tuple[tuple[str, list[tuple[int, int, bool]]], ...] = (
    ("' a\n' b\nPrint 1\n' c\nPrint 2\n\n' d\n' e\n' f", [(1, 2, True), (7, 9, True)]),
    ("Print 1\n' a\nPrint 2\n", []),
    ("  If a Then\nb = 1\nEnd If\nLoop\nEnd Loop\nFor i = 1 To 2 : Next\n' a\n\n' b\n", [(1, 2, False)]),
    ("Print 1 ' a\n' b\n' c\n", [(2, 3, True)]),
)


@cases("text, wanted", FOLDS)
def test_the_folds_of_a_program(text: str, wanted: list[tuple[int, int, bool]]) -> None:
    assert navigation.folds(page(text)) == wanted


TWO = "Sub S(a, b)\nEnd Sub\n"
# A text with the cursor; the signature there, its parameters, and the number of the present one.
CALLS: tuple[tuple[str, str, list[str], int], ...] = (
    (f"{TWO}S(|", "Sub S(a As Float, b As Float)", ["a As Float", "b As Float"], 0),
    (f"{TWO}S(1 + (2), |", "Sub S(a As Float, b As Float)", ["a As Float", "b As Float"], 1),
    (f"{TWO}S(1, 2, |", "Sub S(a As Float, b As Float)", ["a As Float", "b As Float"], -1),
    (f"{TWO}S(POS(0), |", "Sub S(a As Float, b As Float)", ["a As Float", "b As Float"], 1),
    (f"{TWO}S(POS(|", "POS(axis) = user units", ["axis"], 0),
    ("Sub S()\nEnd Sub\nS(|", "Sub S()", [], -1),
    ("Function F(a) As Float\nEnd Function\nx = F(|", "Function F(a As Float) As Float", ["a As Float"], 0),
    ("  SPEED (|", "SPEED(axis) = user units/s", ["axis"], 0),
    ("SPEED[0, |", "SPEED(axis) = user units/s", ["axis"], -1),
    ('SPEED("(", |', "SPEED(axis) = user units/s", ["axis"], -1),
    ("GO(0, 1, |", "GO(axes)", ["axes"], 0),
    ("MOVERTEST(|", "MOVERTEST(axis, param) = number", ["axis, param"], 0),
)
# Texts in which the cursor is in no call: in other brackets, behind a call, at a variable.
NO_CALLS = (
    f"{TWO}S(1 + (2|",
    "S(1)|",
    "Dim a(3)\na(|",
    "x = (|SPEED(0))",
    "SPEED(0) + (1, |",
    "TIME(|",
    "None(|",
    "GO(0) |",
    "' SPEED(|",
)


@cases("text, wanted, parameters, active", CALLS)
def test_the_parameters_of_a_call(text: str, wanted: str, parameters: list[str], active: int) -> None:
    shown = signature(*at_cursor(text))
    assert shown is not None
    assert (shown.text, shown.parameters, shown.active) == (wanted, parameters, active)


@cases("text", NO_CALLS)
def test_other_brackets_have_no_parameters(text: str) -> None:
    assert signature(*at_cursor(text)) is None


def test_every_line_and_column_has_an_offset() -> None:
    """A line or a column beyond the end has the offset of the nearest one."""
    shown = page("ab\n\nx = 2\n")
    assert [[shown.offset(line, column) for column in range(8)] for line in range(6)] == [
        [0] * 8,
        [0, 0, 1, 2, 2, 2, 2, 2],
        [3, 3, 3, 3, 3, 3, 3, 3],
        [4, 4, 5, 6, 7, 8, 9, 9],
        [10] * 8,
        [10] * 8,
    ]
    lines = [(0, 2)] * 3 + [(3, 3)] + [(4, 9)] * 6 + [(10, 10)]
    assert [shown.line_of(offset) for offset in range(11)] == lines
    assert [page("\na").line_of(offset) for offset in range(3)] == [(0, 0), (1, 2), (1, 2)]


def test_every_offset_has_its_token() -> None:
    """At a boundary, a word precedes an operator, and the first token the second."""
    shown = page("ab + SPEED.1=x2\nSPEED(0)")
    ab, speed, x2 = ("word", "ab", 0), ("word", "SPEED.1", 5), ("word", "x2", 13)
    second = ("word", "SPEED", 16), ("separator", "(", 21), ("number", "0", 22), ("separator", ")", 23)
    assert [shown.token(offset) for offset in range(25)] == [
        *[ab] * 3, *[("operator", "+", 3)] * 2, *[speed] * 8, *[x2] * 3, *[second[0]] * 6, *second[1:],
    ]  # fmt: skip
    keywords = [shown.keyword(offset) for offset in range(25)]
    spans = [found and (found[0].name, found[1]) for found in keywords]
    assert spans == [
        *[None] * 5, *[("SPEED", (5, 10))] * 8, *[None] * 3, *[("SPEED", (16, 21))] * 6, *[None] * 3,
    ]  # fmt: skip


# A text, and the edits of its layout: the smallest span, the text in it, and the new text.
EDITS = (
    ("If a Then\nb = 1   \n   c = 2\nEnd If", [((10, 18), "b = 1   ", "  b = 1"), ((21, 22), " ", "")]),
    ("Loop\n\tb = b\n   b   \n   \nEnd Loop", [
        ((5, 6), "\t", "  "), ((14, 19), " b   ", "b"), ((20, 23), "   ", ""),
    ]),
    ("   b\nb  ", [((0, 3), "   ", ""), ((6, 8), "  ", "")]),
)  # fmt: skip


@cases("text, wanted", EDITS)
def test_an_edit_is_as_small_as_possible(text: str, wanted: list[object]) -> None:
    assert [(each.span, text[slice(*each.span)], each.text) for each in format(page(text))] == wanted


LOST = "been lost: the editor has opened this file in a wrong encoding"
# A text, and its diagnostics: line, column, message.
UNDECODED = (
    ("\ufffdx = 1\nPrint x\n", [(1, 1, f"1 character has {LOST}")]),
    ("Print 1 \ufffd 2", [(1, 9, f"1 character has {LOST}")]),
    ("Print 1\nx\ufffd = 1 \ufffd\nPrint y y\n", [
        (2, 2, f"2 characters have {LOST}"), (3, 9, "expected the end of the line, found `y`"),
    ]),
)  # fmt: skip


@cases("text, wanted", UNDECODED)
def test_undecoded_characters_have_one_diagnostic(text: str, wanted: list[object]) -> None:
    assert [(each.line, each.column, each.message) for each in findings(page(text))] == wanted


@pytest.mark.parametrize(("line", "column", "count"), [(1, 1, 1), (1, 0, 0), (0, 1, 0)])
def test_a_diagnostic_without_an_offset_has_no_fix(line: int, column: int, count: int) -> None:
    found = Diagnostic("syntax", "no", line, column, length=1, fix="x")
    assert len(list(fixes(page("y\n"), found))) == count


# Language, a text with the cursor, and all labels proposed there with their rank: names have 0, keywords that are
# not simulated 3.
LABELS: tuple[tuple[str, str, list[tuple[str, int]]], ...] = (
    ("mccl", "MD1,1MN\nMD12,1WS\nMD2,1WS\nAR13\nMC1|", [("1", 0), ("12", 0)]),
    ("mccl", "MD14,1MN\nAL5,AR10,AR20\nAA@1|", [("1", 0), ("10", 0)]),
    ("mccl", "MD1,1MN\nMR1|", []),
    ("mccl", "DW|", []),
    ("mccl", "1QQ5|", []),
    ("mccl", "1QQ@5|", []),
    ("mccl", "1G|", [("GA", 2), ("GH", 2), ("GM", 2), ("GO", 2), ("GT", 2), ("GU", 3), ("GX", 2)]),
    # HTA is the beginning of HTAKPROP, HKP its short form.
    ("mint", "HKP|", [("HTAKPROP", 2)]),
    ("mint", "HTAK|", [("HTAKPROP", 2), ("HTAKINT", 2)]),
)  # fmt: skip


@cases("language, text, wanted", LABELS)
def test_all_proposals(language: str, text: str, wanted: list[tuple[str, int]]) -> None:
    found = complete(*at_cursor(text, language))
    assert sorted((each.label, each.rank) for each in found) == sorted(wanted)


# A machine file with the cursor, and the key whose page is shown there.
KEYS = (
    ("[axis.1]\n|travel = 1", "travel", "axis.1.travel"),
    ("[axis.1]\ntravel| = 1", "travel", "axis.1.travel"),
    ("[axis.1]\ntravel |= 1", "", ""),
    ("[axis.1]|\ntravel = 1", "", ""),
    ("|\naxis.2.travel = 1", "", ""),
    ("\naxis.2.tra|vel = 3", "axis.2.travel", "axis.2.travel"),
    ("tra|vel = 3", "", ""),
    ("[axis.3]\nlimits.jerk| = 3\n", "limits.jerk", "axis.3.limits.jerk"),
    ("[[input]]\nchannel = 1\n[[fault]]\nki|nd = 3", "kind", "[[fault]] kind"),
    ("[[fault]]\n[axis.0]\nmo|tor = 3", "motor", "axis.0.motor"),
)


@cases("text, word, name", KEYS)
def test_the_page_of_a_key_of_a_machine_file(text: str, word: str, name: str) -> None:
    offset = text.index("|")
    plain = text.replace("|", "")
    found = hover_machine_file(Source("a.machine.toml", plain), offset)
    shown = ("", "") if found is None else (plain[slice(*found.span)], found.markdown.split("**")[1])
    assert shown == (word, name)


# The beginning of a machine file; label, start and text of what may follow.
MACHINE_FILES: tuple[tuple[str, list[tuple[str, int, str]]], ...] = (
    ("\n[[enc", [("[[encoder]]", 3, "encoder]]")]),
    ("\n[axis.3]\ntra", [("travel", 10, "travel = ")]),
    ("[axis.3]\n  tra", [("travel", 11, "travel = ")]),
    ("[axis.3]\n2 tra", []),
    ("\n[[fault]]\nki", [("kind", 11, "kind = ")]),
    ("axis.11.tra", [("axis.11.travel", 0, "axis.11.travel = ")]),
    ("run.u", [("run.until", 0, "run.until = ")]),
    ("[axis.0]\nmotor =   ", [("servo", 19, '"servo"'), ("stepper", 19, '"stepper"')]),
)


@cases("text, wanted", MACHINE_FILES)
def test_what_follows_in_a_machine_file(text: str, wanted: list[tuple[str, int, str]]) -> None:
    found = complete_machine_file(Source("a.machine.toml", text), len(text))
    assert [(each.label, each.start, each.text) for each in found] == wanted


def test_the_times_of_a_line() -> None:
    """A wait of less than 0.5 ms is not shown; from 100 s on a time has no decimals."""
    program = """\
SPEED(0) = 1 : ACCEL(0) = 1e6 : DECEL(0) = 1e6
MOVER(0) = 123.4 : GO(0)
PAUSE IDLE(0)
WAIT = 1
WAIT = 0
MOVER(0) = 99.96 : GO(0) : WAIT = 100400
"""
    shown = Page(Source("a.mnt", program), dialect("mint"), {"run.until": 1000.0})
    assert times(shown).texts() == {
        2: "123 s (1×)", 3: "waits 123 s", 4: "waits 0.001 s", 6: "100 s (1×) · waits 100 s",
    }  # fmt: skip
