"""Generator of the tables of MCCL.

`python -m motionlang.lang.parsing.generate` writes `syntax/tables.py` of the dialect from its `.lark` grammar. Run it
after a change to the grammar; a test compares the tables with it, so that they cannot drift apart. Lark computes the
LALR(1) table. `states` writes its states, and `flat` the pattern of a rule that needs no table.
"""

from __future__ import annotations

import os
import re
from glob import glob
from importlib import import_module

from lark import Lark

from motionlang.files import replacing
from motionlang.lang.parsing.flat import Flat
from motionlang.lang.parsing.rules import Rules
from motionlang.lang.parsing.states import States

TYPE_CHECKING = False
if TYPE_CHECKING:
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
    states = States(lark.parser.parser._parse_table, Rules())
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


def _wrapped(mapping: dict[str, str]) -> str:
    return "{\n" + "".join(f"    {key!r}: {value!r},\n" for key, value in mapping.items()) + "}"


def main() -> int:
    """Write the tables of every dialect whose `actions` module defines a tree."""
    for file in sorted(glob(os.path.join(ROOT, "*", "syntax", "actions.py"))):
        package = os.path.basename(os.path.dirname(os.path.dirname(file)))
        with replacing(os.path.join(ROOT, package, "syntax", "tables.py")) as tables:
            tables.write(generate(package).encode())
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
