"""Mint and MCCL in Pygments: no text is lost, and keywords have their kinds."""

from __future__ import annotations

from pathlib import Path

from pygments.token import Comment, Error, Keyword, Name, Number, String

from motionlang import run
from motionlang.kernel import Source
from motionlang.views.pygments_lexers import McclLexer, MintLexer
from tests.cases import cases

ROOT = Path(__file__).parents[2]


def test_the_words_of_mint() -> None:
    found = {
        text: kind
        for kind, text in MintLexer().get_tokens('If POS(0) > 1.5 Then PRINT "x" : MOVER(0) = 3 \' on\n')
    }
    assert found["If"] in Keyword
    assert (found["POS"], found["MOVER"]) == (Name.Builtin, Name.Function)
    assert (found["1.5"], found['"x"'], found["' on"]) == (Number, String, Comment)


def test_the_words_of_mccl() -> None:
    found = {text: kind for kind, text in McclLexer().get_tokens("1MR1000,XX5 ; on\n")}
    assert found["MR"] == Name.Function
    assert found["XX"] in (Error, Name)


@cases(
    "path", sorted([*ROOT.glob("scripts/*/*.mnt"), *ROOT.glob("scripts/*/*.mcl")]), ids=lambda path: path.name
)
def test_nothing_is_left_out(path: Path) -> None:
    lexer = (MintLexer if path.suffix == ".mnt" else McclLexer)(stripnl=False, ensurenl=False)
    text = path.read_text(encoding="utf-8").replace("\r\n", "\n")
    found = list(lexer.get_tokens(text))
    assert "".join(piece for _, piece in found) == text
    assert [piece for kind, piece in found if kind is Error] == []


def test_a_run_in_a_notebook() -> None:
    shown = run(Source("a.mnt", 'PRINT "<b>"\nMOVER(0) = 5\nGO(0)\nMOVER(0) = 5\n'))._repr_html_()
    assert shown.startswith("<pre>&lt;b&gt;</pre>\n<pre>warning[never-started]")
    assert "MOVER" in shown.rpartition("<pre>")[2]
