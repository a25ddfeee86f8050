"""The parser of a grammar: no conflicts, and stored tables."""

from __future__ import annotations

import logging
import re
from pathlib import Path

import lark
import pytest

from motionlang.kernel.lang.syntax import grammar
from motionlang.kernel.lang.syntax.grammar import GRAMMARS, build, load, store, table_name
from motionlang.kernel.mccl.syntax.parser import OPTIONS
from motionlang.kernel.mint.syntax.build import Builder
from motionlang.kernel.mint.syntax.tokens import PARSER


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
