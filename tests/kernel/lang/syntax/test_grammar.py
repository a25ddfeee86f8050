"""The parser of a grammar: no conflicts, stored tables, tokens of any text."""

from __future__ import annotations

import logging
import re
from pathlib import Path

import lark
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel.lang.syntax import grammar
from motionlang.kernel.lang.syntax.grammar import BAD, GRAMMARS, build, lex, load, store, table_name
from motionlang.kernel.mccl.syntax.parser import OPTIONS
from motionlang.kernel.mint.syntax.build import Builder
from motionlang.kernel.mint.syntax.tokens import PARSER, ended
from tests.cases import examples


@pytest.mark.parametrize(("name", "options"), [("mint", {}), ("mccl", OPTIONS)])
def test_a_grammar_has_no_conflict(
    name: str, options: dict[str, object], caplog: pytest.LogCaptureFixture
) -> None:
    lark.logger.setLevel(logging.DEBUG)
    lark.logger.propagate = True
    try:
        build(name, None, debug=True, **options)
    finally:
        lark.logger.setLevel(logging.CRITICAL)
    assert "conflict" not in caplog.text.lower()


def test_a_conflict_is_an_error() -> None:
    """`strict` of Lark needs a library for its terminals; the table refuses two reductions by itself."""
    with pytest.raises(lark.exceptions.GrammarError, match="Reduce/Reduce"):
        lark.Lark('start: a | b\na: "x"\nb: "x"', parser="lalr")


def test_every_alternative_has_a_method() -> None:
    names = {rule.alias for rule in PARSER.rules if rule.alias}
    methods = {name for name in vars(Builder) if not name.startswith("_")}
    assert names == methods


def test_a_rule_without_a_method_has_one_symbol() -> None:
    assert all(rule.options.expand1 for rule in PARSER.rules if not rule.alias)


def test_no_group_is_repeated_possessively() -> None:
    """Python before 3.11.5 goes on at a wrong place after `(?:ab?c)*+`.

    It does not after `(?>(?:ab?c)*)`.
    """
    patterns = "\n".join(terminal.pattern.to_regexp() for terminal in PARSER.terminals)
    assert re.findall(r"(?<!\\)\)(?:[*+?]|\{[0-9,]*\})\+.*", patterns) == []


# -------------------------------------------------------------------------------------------- stored tables


@pytest.fixture
def built(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    """Return the list of the paths of cached tables with which a parser is built."""
    found: list[object] = []

    def recorded(name: str, builder: Builder, **options: object) -> lark.Lark:
        found.append(options.get("cache"))
        return build(name, builder, **options)

    monkeypatch.setattr(grammar, "build", recorded)
    return found


def parses(parser: lark.Lark) -> bool:
    return repr(parser.parse("x = 1\n")) == repr(PARSER.parse("x = 1\n"))


def test_a_stored_table_is_loaded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, built: list[object]
) -> None:
    grammars = Path(GRAMMARS)
    for name in ("common.lark", "mint.lark"):
        (tmp_path / name).write_text((grammars / name).read_text())
    monkeypatch.setattr(grammar, "GRAMMARS", str(tmp_path))
    store("mint", Builder(), str(tmp_path))
    store("mint", Builder(), str(tmp_path))
    assert [path.name for path in tmp_path.glob("*.table")] == [table_name("mint")]
    assert built == [None]
    assert parses(load("mint", Builder()))
    assert built == [None]


def test_the_table_of_another_version_is_not_loaded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, built: list[object]
) -> None:
    """Lark then keeps one in the cache folder."""
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / "cache"))
    assert table_name("mint", "3.10") != table_name("mint")
    monkeypatch.setattr(lark, "__version__", "0.0")
    path = tmp_path / "cache" / table_name("mint")
    assert parses(load("mint", Builder()))
    assert built == [str(path)]
    assert path.exists()
    assert parses(load("mint", Builder()))


def test_without_a_cache_the_table_is_built_in_memory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, built: list[object]
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / "file"))
    monkeypatch.setattr(lark, "__version__", "0.0")
    assert parses(load("mint", Builder()))
    assert built == [False]


# --------------------------------------------------------------------------------------------------- tokens


@settings(max_examples=examples(200))
@given(st.text(st.sampled_from("aREMrem019.xX_e+-'\"`\\:;,()=<> \t\n#?é\0"), max_size=24))
def test_any_text_has_tokens(text: str) -> None:
    """They are in order, and leave out only blanks and marks of continuation."""
    end = 0
    for token in lex(PARSER, ended(text)):
        assert token.start_pos is not None
        assert token.end_pos is not None
        assert re.fullmatch(r"(?:[ \t]|[\\_][ \t]*(?:'[^\n]*)?\n)*", ended(text)[end : token.start_pos])
        assert ended(text)[token.start_pos : token.end_pos] == token
        end = token.end_pos


@pytest.mark.parametrize(
    ("text", "bad"),
    [('x = "open\ny', '"open'), ("12abc = 1", "12abc"), ("a @ b", "@"), ("`ab`", "`"), ("é", "é")],
)
def test_a_text_of_no_terminal_is_one_token(text: str, bad: str) -> None:
    assert next(str(token) for token in lex(PARSER, text) if token.type == BAD) == bad
