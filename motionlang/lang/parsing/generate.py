"""Generator of the tables that `motionlang.lang.parsing.parser` runs.

`python -m motionlang.lang.parsing.generate` writes `syntax/tables.py` of each dialect from its `.lark`
grammar. Run it after a change to a grammar; a test compares the tables with the grammars, so that they cannot
drift apart. Lark computes the LALR(1) table. `states` writes its states, `rules` its reducers, and `flat` the
pattern of a rule that needs no table. This module writes the terminals.
"""

from __future__ import annotations

import os
import re
from glob import glob
from importlib import import_module

from lark import Lark

from motionlang.files import replacing
from motionlang.lang.parsing.driver import loop
from motionlang.lang.parsing.flat import Flat
from motionlang.lang.parsing.rules import Rules
from motionlang.lang.parsing.states import States

TYPE_CHECKING = False
if TYPE_CHECKING:
    from types import ModuleType
    from typing import Any

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))


def grammar_path(name: str) -> str:
    """Return the path of a grammar, in an installed package or in a checkout."""
    inside = os.path.join(ROOT, "grammars", name)
    return inside if os.path.exists(inside) else os.path.join(os.path.dirname(ROOT), "grammars", name)


def build_lark(name: str, lexer: str = "basic", **options: Any) -> Lark:
    """Build Lark's parser of a grammar: the source of tables, the reference in tests."""
    path = grammar_path(name)
    with open(path, encoding="utf-8") as file:
        return Lark(
            file.read(),
            parser="lalr",
            lexer=lexer,
            g_regex_flags=re.ASCII,
            import_paths=[os.path.dirname(path)],
            **{"keep_all_tokens": True, "maybe_placeholders": True, **options},
        )


def generate(package: str) -> str:
    """Return the text of the tables module for the grammar of `motionlang.<package>`."""
    actions = import_module(f"motionlang.{package}.syntax.actions")  # a layer above: known by name only
    if hasattr(actions, "ACTIONS"):
        return _with_reducers(f"{package}.lark", package, actions)
    return _with_pattern(f"{package}.lark", actions.RULE, actions.KEPT, actions.QUOTED)


def _heading(name: str) -> list[str]:
    return [
        f'"""The tables of grammars/{name}.\n\n'
        'Written by `python -m motionlang.lang.parsing.generate`, not by hand.\n"""\n',
        "# ruff: noqa\n# mypy: ignore-errors\n# fmt: off\n",
    ]


def _with_pattern(name: str, rule: str, kept: tuple[str, ...], quoted: str) -> str:
    """Return the tables of a grammar in which one pattern matches a whole rule.

    The table then parses only text that the pattern does not match. PIECE cuts a line into the texts that
    should match, as group 1, and matches nothing at the end of the line. SEPARATORS matches what may separate
    them, except comments. COMMENT matches a line up to its comment, which is group 1. BEGINS has the
    character with which a terminal begins.
    """
    lark = build_lark(name, lexer="contextual")
    flat = Flat(lark, rule, kept)
    states = States(lark.parser.parser._parse_table, Rules(None))
    chunk, between = flat.chunk(quoted), "|".join(flat.outside())
    ignored = set(map(str, lark.ignore_tokens))
    separators = "|".join(flat.outside({each.name for each in lark.terminals} - ignored))
    comments = "|".join(flat.outside(ignored))
    cut = f"(?>(?:{between})*)(?:({chunk})|$)"
    before_comment = f"^(?>(?:(?!{comments})(?:{separators}|{chunk}))*)(?=({comments}))"
    terminals = {str(each.name): each.pattern.to_regexp() for each in lark.terminals}
    sections = [
        *_heading(name),
        "import re\n",
        "from motionlang.lang.parsing.parser import Automaton\n",
        f"PIECE = re.compile({cut!r}, re.ASCII)\n",
        f"SEPARATORS = re.compile({f'(?>(?:{separators})*)'!r}, re.ASCII)\n",
        f"COMMENT = re.compile({before_comment!r}, re.ASCII)\n",
        f"{rule.upper()} = re.compile({flat.pattern!r}, re.ASCII)\n",
        f"TERMINALS = {_wrapped(terminals)}\n",
        f"BEGINS = {flat.begins!r}\n",
        "RULES = (\n" + "".join(f"    {each},\n" for each in states.rules.rows) + ")\n",
        "ROWS = (\n" + "".join(f"    {each!r},\n" for each in states.rows) + ")\n",
        f"AUTOMATON = Automaton(TERMINALS, RULES, ROWS, {states.finish})",
    ]
    return "\n".join(sections) + "\n"


def _with_reducers(name: str, package: str, actions: ModuleType) -> str:
    """Return the tables, with reducers, of a grammar that parses the whole text.

    Each alternative of the grammar has an action.
    """
    lark = build_lark(name)
    table = lark.parser.parser._parse_table
    nodes = import_module(f"motionlang.{package}.syntax.nodes")
    rules = Rules(actions.ACTIONS, nodes, actions.INLINED, actions.LEAVES.values())
    states = States(table, rules)
    literals, classes = _terminals(lark)
    token, continued = _token_patterns(lark, literals, classes)
    numbers = {
        action: (number, reducer) for number, (action, (_, reducer)) in enumerate(rules.leaves.items(), 1)
    }
    leaves = "".join(
        "    {!r}: ({}, {}),\n".format(kind, *numbers[action]) for kind, action in actions.LEAVES.items()
    )
    sections = [
        *_heading(name),
        "from motionlang.lang.parsing.parser import SHIFT, Tables, goto, leaf, move, new",
        f"from motionlang.{package}.syntax.build import *",
        f"from motionlang.{package}.syntax.nodes import *\n",
        *rules.functions,
        loop(rules.inlined.values(), (lines for lines, _ in rules.leaves.values())),
        f"\nTOKEN = {token!r}\n",
        f"CONTINUED = {continued!r}\n",
        f"LITERALS = {_wrapped(literals)}\n",
        f"CLASSES = {_wrapped(classes)}\n",
        f"SPELLINGS = {_wrapped(_spellings(lark))}\n",
        "RULES = (\n" + "".join(f"    {each},\n" for each in rules.rows) + ")\n",
        "ROWS = (\n" + "".join(f"    {each!r},\n" for each in states.rows) + ")\n",
        "LEAVES = {\n" + leaves + "}\n",
        f"TABLES = Tables(TOKEN, CONTINUED, LITERALS, CLASSES, RULES, ROWS, {states.finish}, LEAVES, _run)",
    ]
    return "\n".join(sections) + "\n"


def _wrapped(mapping: dict[str, str]) -> str:
    return "{\n" + "".join(f"    {key!r}: {value!r},\n" for key, value in mapping.items()) + "}"


# -------------------------------------------------------------------------------------------- the terminals


# Texts that match no terminal. Each is consumed in full, so that broken text is read once: an open string,
# `12abc`.
_LEFTOVERS = r'"[^\n]*|[0-9][A-Za-z0-9_]*|.'
_FIRST = re.compile(
    r"\[(?:\\.|[^\]\\])+\]|\\?."
)  # every class begins with a character or a set of characters
_JOINED = re.compile(r"(?:\\.|[^\\()\[\]+*?.])+")  # "<>" | "<=": literal texts only


def _terminals(lark: Lark) -> tuple[dict[str, str], dict[str, str]]:
    """Split the terminals into literal texts and patterns for other kinds of token.

    Literal texts are operators, and keywords in lower case.
    """
    literals, classes = {}, {}
    for terminal in lark.terminals:
        if terminal.name in lark.ignore_tokens:
            continue
        pattern = terminal.pattern.value.removeprefix("(?:").removesuffix(")")
        if terminal.pattern.type == "str":
            literals[terminal.pattern.value.lower()] = str(terminal.name)
        elif _JOINED.fullmatch(pattern):
            for text in pattern.split("|"):
                literals[re.sub(r"\\(.)", r"\1", text).lower()] = str(terminal.name)
        else:
            classes[str(terminal.name)] = terminal.pattern.to_regexp()
    return dict(sorted(literals.items())), classes


def _spellings(lark: Lark) -> dict[str, str]:
    """Map the kind of a fixed token to its spelling, for messages and completion."""
    return {str(each.name): each.pattern.value for each in lark.terminals if each.pattern.type == "str"}


def _token_patterns(lark: Lark, literals: dict[str, str], classes: dict[str, str]) -> tuple[str, str]:
    """Return two patterns that match any token: without and with continued lines.

    Keywords are recognized afterwards.
    """
    ignored = {
        each.name: each.pattern.to_regexp() for each in lark.terminals if each.name in lark.ignore_tokens
    }
    operators = [re.escape(text) for text in literals if len(text) > 1 and not text[0].isalpha()]
    found = "|".join([_signs(literals, classes), *classes.values(), *operators, _LEFTOVERS])
    blank = ignored.pop("BLANK")
    some = re.sub(r"(?<=\])\+\+$", "*+", blank)  # no group repeats a set of characters as fast
    return f"{some}({found})", f"(?:{'|'.join([blank, *ignored.values()])})*({found})"


def _signs(literals: dict[str, str], classes: dict[str, str]) -> str:
    """Return the set of one-character tokens with which no other token begins.

    These tokens are the most frequent; a set matches them in one step.
    """
    others = [text[0] for text in literals if len(text) > 1]
    firsts = [re.compile(_FIRST.match(pattern)[0]) for pattern in classes.values()]  # type: ignore[index]
    alone = [
        text
        for text in literals
        if len(text) == 1 and text not in others and not any(first.match(text) for first in firsts)
    ]
    return f"[{re.escape(''.join(alone))}]"


def main() -> int:
    """Write the tables of every dialect whose `actions` module defines a tree."""
    for file in sorted(glob(os.path.join(ROOT, "*", "syntax", "actions.py"))):
        package = os.path.basename(os.path.dirname(os.path.dirname(file)))
        with replacing(os.path.join(ROOT, package, "syntax", "tables.py")) as tables:
            tables.write(generate(package).encode())
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
