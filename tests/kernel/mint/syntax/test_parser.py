"""Properties of any text: positions, highlighting, completeness, any text."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang import parse
from motionlang.kernel import Machine, ProgramError, Source
from motionlang.kernel.mint import DIALECT as MINT
from motionlang.kernel.mint.syntax.nodes import For, If, Wrong
from motionlang.kernel.mint.syntax.parser import read
from tests.cases import examples
from tests.kernel.mint.syntax.test_parser_errors import samples as broken
from tests.kernel.mint.syntax.test_parser_spec import samples

is_complete = MINT.interactive(Machine()).is_complete


def locations(text: str) -> list[tuple[int, int, int]]:
    """Return line, column and length of the beginning of each statement."""
    tree: Any = parse(text, "mint")
    return [MINT.locate(Source("a.mnt", text), each.start) for each in tree.body]


def test_locations() -> None:
    text = "Auto\n\n' note\nx = 1 : speed(0) = 2\n\tGO(0) : REM now\nMOVER.0 = 3"
    assert locations(text) == [(1, 1, 4), (4, 1, 1), (4, 9, 5), (5, 2, 2), (6, 1, 7)]


def test_locations_after_continued_lines() -> None:
    assert locations("x = 1 + \\\n  2 _ ' more\n + 3\ny = 4 : z = \\\n5\nw = 1") == [
        (1, 1, 1),
        (4, 1, 1),
        (4, 9, 1),
        (6, 1, 1),
    ]


def test_equality_ignores_locations() -> None:
    for text in ("x = 1", "INPUT n"):
        assert parse(text, "mint") == parse(f"\n\n  {text.replace(' ', '   ')} ' note", "mint")
    assert parse("x = 1", "mint") != parse("x = 2", "mint")


@pytest.mark.parametrize("name", samples())
def test_tokens_are_the_text(name: str) -> None:
    """The tokens are in order at their offsets, and omit only blanks and line ends."""
    text, end = samples()[name], 0
    for kind, piece, at in MINT.tokens(text):
        assert kind in {"word", "control", "number", "string", "comment", "operator", "separator"}
        assert text[end:at].strip() == ""
        assert text[at : at + len(piece)] == piece
        end = at + len(piece)
    assert text[end:].strip() == ""


def test_kinds_of_tokens() -> None:
    text = 'If x.1 >= 0x1F Then GO(`A`) : REM hi\ny = "a" \\\n ~ 12ab é \'end'
    assert [f"{kind} {piece}" for kind, piece, _ in MINT.tokens(text)] == [
        *("control If", "word x.1", "operator >=", "number 0x1F", "control Then", "word GO", "separator ("),
        *("string `A`", "separator )", "separator :", "comment REM hi", "word y", "operator =", 'string "a"'),
        *("separator \\", "operator ~", "bad 12ab", "bad é", "comment 'end"),
    ]


@pytest.mark.parametrize(
    "text", ["", "x = 1", "If a Then b = 1", "If a Then\nEnd If", "x = (", "Next", "For i = 1 To 3 : Next"]
)
def test_complete(text: str) -> None:
    assert is_complete(text)


@pytest.mark.parametrize(
    "text", ["If a Then", "If a Then\nElse\n", "x = 1 + \\", "x = 1 + _\n", "For i = 1 To 3 : x = i", "Sub f"]
)
def test_not_complete(text: str) -> None:
    assert not is_complete(text)


SOUP = st.text(st.sampled_from("IfThenEndSubForNext x1.+-*/=<>()[],;:#?'\"`\\_~!&|\n\t\0é"), max_size=40)
LINES = [line for text in [*samples().values(), *broken().values()] for line in text.split("\n")]


BROKEN = """\
If a = 1 Than
  b = 1 : c = (
End If 3
For i = 1 T 3
  Fro j = 1 To 3
  Next j
Sub f(a
  Next
"""


def test_a_text_with_syntax_errors_has_a_tree() -> None:
    """A Wrong is in place of a faulty statement or condition, and missing ends are added."""
    module = read(Source("broken.mnt", BROKEN))
    assert [each.line for each in module.errors] == [1, 2, 3, 4, 4, 5, 7, 7, 8]
    condition, loop = module.body
    assert isinstance(condition, If)
    assert isinstance(loop, For)
    assert [type(each).__name__ for each in (condition.condition, *condition.body)] == [
        "Wrong",
        "Assign",
        "Wrong",
    ]
    assert BROKEN[condition.body[1].start : condition.body[1].end] == "c = ("
    assert [type(each).__name__ for each in loop.body] == ["For"]
    assert [(sub.name, sub.body) for sub in module.subs] == [("f", [Wrong(0, 0)])]


@settings(max_examples=examples(300))
@given(st.one_of(SOUP, st.lists(st.sampled_from(LINES), max_size=10).map("\n".join)))
def test_any_text_is_answered(text: str) -> None:
    """The result is a tree, or diagnostics inside the text without duplicates."""
    diagnostics = read(Source("any.mnt", text)).errors
    assert len(diagnostics) == len({(d.line, d.column, d.message) for d in diagnostics})
    assert all(1 <= d.line <= text.count("\n") + 2 and d.column >= 1 for d in diagnostics)
    list(MINT.tokens(text))
    is_complete(text)


BLOCKS = ["For i = 1 To 3|Next", "While a|End While", "If a Then|End If", "Repeat|Until a", "Loop|End Loop"]


@settings(max_examples=examples(200))
@given(st.lists(st.tuples(st.sampled_from(BLOCKS), st.integers(0, 6)), min_size=1, max_size=7), st.data())
def test_one_line_missing_is_one_diagnostic(shape: list[tuple[str, int]], data: st.DataObject) -> None:
    """If a block lacks its opener or closer, one diagnostic names its line.

    The program is indented.
    """
    lines, open_blocks = [], []  # type: ignore[var-annotated]
    for block, closed in shape:
        opener, closer = block.split("|")
        lines.append((len(open_blocks), opener, len(lines)))
        open_blocks.append((closer, lines[-1][2]))
        for _ in range(min(closed, len(open_blocks))):
            end, begin = open_blocks.pop()
            lines.append((len(open_blocks), end, begin))
    while open_blocks:
        end, begin = open_blocks.pop()
        lines.append((len(open_blocks), end, begin))
    removed = data.draw(st.sampled_from([i for i, line in enumerate(lines) if line[2] != i]))
    opener_line = lines.pop(removed)[2] + 1
    text = "\n".join("  " * depth + word for depth, word, _ in lines)
    with pytest.raises(ProgramError) as caught:
        parse(text, "mint")
    assert [(d.code, d.line) for d in caught.value.diagnostics] == [("missing-end", opener_line)]


def test_parsing_imports_nothing_heavy() -> None:
    """For a fast start, parsing loads Lark and no other large library."""
    code = (
        "import sys, motionlang;"
        "motionlang.parse('x = 1', 'mint');"
        "print(*{'lark', 'argparse', 'numpy', 'rich'} & set(sys.modules))"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert out.stdout.strip() == "lark"
