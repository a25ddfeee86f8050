"""Semantic tokens, the layout of a program, and the simulated times of its lines."""

from __future__ import annotations

from pathlib import Path

from motionlang.kernel import Source, dialect
from motionlang_lsp.editor.formatting import format
from motionlang_lsp.editor.page import Page
from motionlang_lsp.editor.times import Times, times
from motionlang_lsp.editor.tokens import MODIFIERS, TYPES, tokens
from test_lsp.editor.pages import page
from tests.cases import cases

PROGRAMS = sorted((Path(__file__).parents[4] / "scripts").rglob("*.mnt"))


def kinds(text: str, language: str = "mint") -> list[tuple[str, str]]:
    shown = page(text, language)
    lines = shown.text.split("\n")
    return [
        (lines[line][column : column + length], TYPES[kind])
        for line, column, length, kind, _ in tokens(shown)
    ]


def test_a_word_has_the_kind_of_its_definition() -> None:
    text = "Const top = 3\nSub Lift(far)\nMOVER(0) = far : SPEED.0 = top ' up\nEnd Sub\n"
    found = kinds(text)
    assert found[:3] == [("Const", "keyword"), ("top", "variable"), ("=", "operator")]
    assert {("Lift", "function"), ("far", "parameter"), ("MOVER", "function"), ("SPEED", "property")} < set(
        found
    )
    assert ("' up", "comment") in found


def test_a_macro_file_has_axes_commands_and_registers() -> None:
    assert kinds("1MR@10 ; go\n", "mccl") == [
        ("1", "number"), ("MR", "function"), ("@10", "variable"), ("; go", "comment"),
    ]  # fmt: skip


def test_a_constant_is_read_only() -> None:
    (first,) = (each for each in tokens(page("Const top = 3\n")) if each[1] == 6)
    assert first[4] == 1 << MODIFIERS.index("readonly")


def test_each_word_has_its_modifiers() -> None:
    """A keyword is one of the library, and one that is not simulated deprecated."""
    text = "Const top = 3\nMOVER(0) = top\nSPEED(0) = 5\nMOVERTEST(0, 1) = 3\n"
    shown = page(text)
    lines = shown.text.split("\n")
    found = {
        lines[line][column : column + length]: [MODIFIERS[bit] for bit in range(8) if bits >> bit & 1]
        for line, column, length, _, bits in tokens(shown)
        if length > 1
    }
    assert found == {
        "Const": [],
        "top": ["readonly"],
        "MOVER": ["defaultLibrary"],
        "SPEED": ["defaultLibrary"],
        "MOVERTEST": ["deprecated", "defaultLibrary"],
    }


def laid_out(text: str) -> str:
    shown = page(text)
    for edit in sorted(format(shown), key=lambda each: each.span, reverse=True):
        text = text[: edit.span[0]] + edit.text + text[edit.span[1] :]
    return text


# A text, and the text in the layout of the language.
LAYOUTS = (
    ("If a Then\nb = 1   \n   ElseIf c Then\nb = 2\nElse\nb = 3\nEnd If\n",
     "If a Then\n  b = 1\nElseIf c Then\n  b = 2\nElse\n  b = 3\nEnd If\n"),
    ("For i = 1 To 2\nFor j = 1 To 2\nk = k + 1\nNext j, i\nk = 0\n",
     "For i = 1 To 2\n  For j = 1 To 2\n    k = k + 1\nNext j, i\nk = 0\n"),
    ("Select Case k\nCase 1\nk = 2\nCase Else\nk = 3\nEnd Select\n",
     "Select Case k\nCase 1\n  k = 2\nCase Else\n  k = 3\nEnd Select\n"),
    ("  If a Then b = 1\n   ' why\nSub s\n' how\nEnd Sub\n", "If a Then b = 1\n' why\nSub s\n  ' how\nEnd Sub\n"),
    ("#WIND\nGO.0\nRETURN\n#NEXT\nEND\n", "#WIND\n  GO.0\nRETURN\n#NEXT\nEND\n"),
    ("Loop\nx = 1 + _\n      2\nEnd Loop\n", "Loop\n  x = 1 + _\n      2\nEnd Loop\n"),
    ("Loop\n\"a\n", "Loop\n\"a\n"),
    # The keywords of declarations may be names of variables.
    ("event = 3\ntask(1) = 4\ntype.x = 5\nk = 0\n", "event = 3\ntask(1) = 4\ntype.x = 5\nk = 0\n"),
    ("Event TIMER\nk = 1 : event = 3\nEnd Event\n", "Event TIMER\n  k = 1 : event = 3\nEnd Event\n"),
)  # fmt: skip


@cases("text, wanted", LAYOUTS)
def test_blocks_are_indented(text: str, wanted: str) -> None:
    assert laid_out(text) == wanted


@cases("path", PROGRAMS, ids=lambda path: path.name)
def test_the_layout_changes_no_token_and_is_stable(path: Path) -> None:
    """The blanks before each line are removed first, so that every line is laid out."""
    text = Source.read(path).text
    flat = "\n".join(line.lstrip(" \t") for line in text.split("\n"))
    done = laid_out(flat)
    assert laid_out(done) == done
    assert written(done) == written(flat) == written(text)


def written(text: str) -> list[tuple[str, str]]:
    return [(kind, piece.rstrip()) for kind, piece, _ in dialect("mint").tokens(text) if piece.strip()]


def test_mccl_has_no_layout() -> None:
    assert format(page("  1MN\n", "mccl")) == []


# 10 units at 100 units/s and 1000 units/s² from rest to rest: a triangle of 2 · sqrt(10/1000) s = 0.2 s.
CYCLE = """\
Dim zero
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
For i = 1 To 12
  MOVER(0) = 10 : GO(0)
  Pause IDLE(0)
  WAIT = 25
Next
Print 1 / zero
MOVER(0) = 10 : GO(0)
"""


def test_each_line_has_its_simulated_time() -> None:
    """Twelve moves of 0.2 s and twelve waits of 25 ms, until a fault ends the run."""
    found = times(page(CYCLE))
    assert [(each.line, str(each)) for each in found.lines] == [
        (4, "2.4 s (12×)"), (5, "waits 2.4 s"), (6, "waits 0.3 s"),
    ]  # fmt: skip
    assert found.fault == (8, "division by zero")
    assert found.texts()[8] == "ends here: division by zero"
    assert found.until == 0


def test_a_line_without_a_time_is_left_out() -> None:
    """A wait of 0 s has no text."""
    assert [(each.line, str(each)) for each in times(page("WAIT = 0\nWAIT = 5\n")).lines] == [
        (2, "waits 0.005 s")
    ]


def test_a_loop_that_polls_waits_at_its_line() -> None:
    """A move of 10 at 100/s with ramps of 1000/s² takes 0.2 s; the loop is skipped."""
    text = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVER(0) = 10 : GO(0)\nWhile Not IDLE(0)\nEnd While\n"
    assert [(each.line, str(each)) for each in times(page(text)).lines] == [
        (2, "0.2 s (1×)"),
        (3, "waits 0.2 s"),
    ]


def test_a_program_without_an_end_is_cut_short() -> None:
    """An iteration takes 0.5 s and three statements of 10 µs, so 59 fit into 30 s."""
    found = times(
        Page(
            Source("a.mnt", "Loop\n  WAIT = 500\n  Print 1\nEnd Loop\n"), dialect("mint"), {"run.until": 30.0}
        )
    )
    assert [(each.line, str(each)) for each in found.lines] == [(2, "waits 29.5 s")]
    assert found.until == 30.0
    assert found.texts() == {2: "waits 29.5 s · still running at 30 s"}


def test_each_task_without_an_end_has_the_line_at_which_the_run_was_cut() -> None:
    """The end of the program ends its tasks, so a jog that goes on has no line."""
    task = "Task t\nLoop\nWAIT = 100\nEnd Loop\nEnd Task\n"

    def cut(text: str) -> Times:
        return times(Page(Source("a.mnt", text), dialect("mint"), {"run.until": 1.9}))

    found = cut(f"RUN t\nLoop\nWAIT = 500\nEnd Loop\n{task}")
    assert found.running == [3, 7]
    assert found.texts()[7].endswith(" · still running at 1.9 s")
    assert cut(f"RUN t\nJOG(0) = 1\n{task}").running == []
    assert cut("Loop\nEnd Loop\n").running == [1]
    assert cut("WAIT = 5\n").running == []


def test_a_question_that_nothing_answers_ends_the_run_at_its_line() -> None:
    found = times(page("Dim n\nInput n\n"))
    assert found.fault is not None
    assert found.fault[0] == 2


def test_a_program_with_errors_has_no_times() -> None:
    found = times(page("WAIT = 5\nPrint 3 3\n"))
    assert (found.lines, found.fault, found.until) == ([], None, 0.0)
