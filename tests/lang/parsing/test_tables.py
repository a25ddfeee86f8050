"""The table parser against Lark with the same grammar: equal texts, equal trees."""

from __future__ import annotations

import logging
import re
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import lark
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.lang.parsing import generate, linked_stack
from motionlang.lang.parsing.parser import Stuck, TooDeep
from motionlang.mccl.syntax import tables as mccl_tables
from motionlang.mint.syntax import build, nodes
from motionlang.mint.syntax import tables as mint_tables
from motionlang.mint.syntax.actions import ACTIONS
from motionlang.mint.syntax.tables import TABLES
from tests.cases import examples
from tests.mint.syntax.test_parser_spec import samples

SCRIPTS = Path(__file__).parents[3] / "scripts" / "mint"
NAMES = {**vars(build), **vars(nodes)}


@pytest.mark.parametrize("tables", [mint_tables, mccl_tables])
def test_the_tables_are_those_of_the_grammar(tables: ModuleType) -> None:
    path = Path(str(tables.__file__))
    assert path.read_text() == generate.generate(path.parents[1].name), "run python -m tests.derived"


@pytest.mark.parametrize("name", ["mint.lark", "mccl.lark"])
def test_the_grammar_has_no_conflict(name: str, caplog: pytest.LogCaptureFixture) -> None:
    lark.logger.setLevel(logging.DEBUG)
    lark.logger.propagate = True
    try:
        generate.build_lark(name, "contextual", debug=True)
    finally:
        lark.logger.setLevel(logging.CRITICAL)
    assert "conflict" not in caplog.text.lower()


@pytest.mark.parametrize("tables", [mint_tables, mccl_tables])
def test_no_group_is_repeated_possessively(tables: ModuleType) -> None:
    """Python before 3.11.5 goes on at a wrong place after `(?:ab?c)*+`.

    It does not after `(?>(?:ab?c)*)`.
    """
    text = Path(str(tables.__file__)).read_text()
    assert re.findall(r"(?<!\\)\)(?:[*+?]|\{[0-9,]*\})\+.*", text) == []


def test_every_action_is_used() -> None:
    text = Path(generate.grammar_path("mint.lark")).read_text()
    aliases = set(re.findall(r"-> (\w+)", text)) - {"more"}
    assert aliases == set(ACTIONS)


def test_the_loop_does_by_itself_what_is_reduced_most_often(monkeypatch: pytest.MonkeyPatch) -> None:
    own, called = 0, 0
    reduced, leaves = linked_stack._reduced, {reducer for _, reducer in TABLES.leaves.values()}

    def counted(top: linked_stack.Cell, rule: Any, at: int) -> linked_stack.Cell:
        nonlocal own, called
        own += isinstance(rule[2], int) or rule[2] in leaves
        called += callable(rule[2]) and rule[2] not in leaves
        return reduced(top, rule, at)

    monkeypatch.setattr(linked_stack, "_reduced", counted)
    for path in SCRIPTS.glob("*.mnt"):
        top = linked_stack.empty(TABLES)
        for at, piece in enumerate(TABLES.texts(path.read_text())):
            top, fits = linked_stack.feed(top, TABLES.kind_of[piece], at)
            assert fits
    assert own > called > 0


# ------------------------------------------------------------------------------------------ Lark as the
# reference


@cache
def reference() -> lark.Lark:
    return generate.build_lark("mint.lark")


def by_reference(text: str) -> str:
    """Return the tree that Lark and the same actions make of a text, or "refused"."""
    try:
        tree = reference().parse(text + TABLES.end(text))
    except lark.exceptions.UnexpectedInput:
        return "refused"
    spans = TABLES.spans(text)
    indices = {start: at for at, (start, _) in enumerate(spans)}
    texts = TABLES.texts(text)
    try:
        return repr(_value(tree, indices, texts))
    except build.Misuse:
        return "misused"


def _value(item: Any, indices: dict[int, int], texts: list[str]) -> Any:
    if item is None:
        return None
    if isinstance(item, lark.Token):
        return indices[item.start_pos or 0]
    values = [_value(child, indices, texts) for child in item.children]
    if item.data == "more":
        last = next(
            v
            for v, child in zip(values[::-1], item.children[::-1], strict=True)
            if not isinstance(child, lark.Token)
        )
        return _append(values[0], last)
    action = ACTIONS[item.data]
    scope = {"T": texts, "S": None, **{f"v{i}": value for i, value in enumerate(values)}}
    value = eval(action.removeprefix("+ "), NAMES, scope)
    return _append(values[0], value) if action.startswith("+ ") else value


def _append(values: list[Any], value: Any) -> list[Any]:
    values.append(value)
    return values


def ours(text: str) -> str:
    texts = TABLES.texts(text)
    try:
        return repr(TABLES.parse(texts, TABLES.kinds_of(texts)))
    except Stuck:
        return "refused"
    except build.Misuse:
        return "misused"
    except TooDeep:
        return "too deep"


@pytest.mark.parametrize("name", samples())
def test_samples(name: str) -> None:
    text = samples()[name]
    assert ours(text) == by_reference(text) != "refused"


def test_gallery() -> None:
    for path in SCRIPTS.glob("**/*.mnt"):
        text = path.read_text()
        assert ours(text) == by_reference(text), path.name


# A program is lines of tokens: mostly valid ones, so that both parsers go deep, in any order, so that both
# fail.
PIECES = [piece for text in samples().values() for piece in TABLES.texts(text) if piece]
LINES = [
    line
    for text in samples().values()
    for line in text.split("\n")
    if not line.rstrip().endswith(("\\", " _"))
]


@settings(max_examples=examples(150))
@given(st.lists(st.sampled_from(LINES), max_size=8))
def test_lines_in_any_order(lines: list[str]) -> None:
    text = "\n".join(lines)
    assert ours(text) == by_reference(text)


@settings(max_examples=examples(250))
@given(st.lists(st.sampled_from(PIECES), max_size=14))
def test_tokens_in_any_order(pieces: list[str]) -> None:
    text = " ".join(pieces)
    assert ours(text) == by_reference(text)


@settings(max_examples=examples(250))
@given(
    st.sampled_from(sorted(samples().values())),
    st.integers(0, 400),
    st.sampled_from(PIECES),
    st.integers(0, 2),
)
def test_one_token_changed(text: str, index: int, piece: str, removed: int) -> None:
    spans = TABLES.spans(text)
    if spans:
        start, end = spans[index % len(spans)][0], spans[(index + removed) % len(spans)][0]
        text = f"{text[:start]} {piece} {text[max(start, end) :]}"
    assert ours(text) == by_reference(text)


OPERATORS = [
    "+",
    "-",
    "*",
    "/",
    "\\",
    "^",
    "&",
    "|",
    "<<",
    ">>",
    "<",
    "<=",
    "=",
    "<>",
    "Mod",
    "And",
    "Or",
    "Xor",
]
EXPRESSIONS = st.recursive(
    st.sampled_from(["a", "1", "2.5", "f(3)", "POS.1", '"s"', "p.x", "g[0]"]),
    lambda inner: st.one_of(
        st.tuples(inner, st.sampled_from(OPERATORS), inner).map(" ".join),
        st.tuples(st.sampled_from(["-", "~", "Not ", "+"]), inner).map("".join),
        inner.map("({})".format),
    ),
    max_leaves=12,
)


@settings(max_examples=examples(250))
@given(EXPRESSIONS)
def test_expressions(text: str) -> None:
    assert ours(f"x = {text}") == by_reference(f"x = {text}")
    assert ours(f"Fill {text}, 2") == by_reference(f"Fill {text}, 2")


@settings(max_examples=examples(200))
@given(st.text(st.sampled_from("aREMrem019.xX_e+-'\"`\\:;,()=<> \t\n#?"), max_size=24))
def test_any_text(text: str) -> None:
    assert ours(text) == by_reference(text)
