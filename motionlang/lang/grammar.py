"""From a `.lark` grammar to the tables that `motionlang.lang.tables` runs; run once, when a grammar changes.

`python -m motionlang.lang.grammar` writes `motionlang/mint/tables.py`. A test compares the two, so that they
cannot drift apart. Lark makes the LALR(1) states; this module numbers them, gives every state a default
reduction (the table is a quarter of the size, and an error is found when the statement before it is whole, so
that "expected" lists only what a reader would), and writes one in-place reducer for every alternative.
"""

from __future__ import annotations

import os
import re
import sys
from collections import Counter

from lark import Lark
from lark.parsers.lalr_analysis import Shift

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def grammar_path(name: str) -> str:
    """Where a grammar stands: inside an installed package, or beside it in a checkout."""
    inside = os.path.join(ROOT, "grammars", name)
    return inside if os.path.exists(inside) else os.path.join(os.path.dirname(ROOT), "grammars", name)


def build_lark(name: str, lexer: str = "basic", **options: Any) -> Lark:
    """Lark's own parser of a grammar: the maker of the tables, and the judge in the tests."""
    path = grammar_path(name)
    with open(path, encoding="utf-8") as file:
        return Lark(
            file.read(),
            parser="lalr",
            lexer=lexer,
            keep_all_tokens=True,
            maybe_placeholders=True,
            g_regex_flags=re.ASCII,
            import_paths=[os.path.dirname(path)],
            **options,
        )


def generate(name: str, package: str, actions: dict[str, str]) -> str:
    """The text of the tables module of a grammar and its actions, for `motionlang.<package>`."""
    lark = build_lark(name)
    table = lark.parser.parser._parse_table
    rules = _Rules(actions)
    rows = _rows(table, rules)
    literals, classes = _terminals(lark)
    token, continued = _token_patterns(lark, literals, classes)
    parts = [
        f'"""The tables of grammars/{name}; written by `python -m motionlang.lang.grammar`, not by hand."""\n',
        "# ruff: noqa\n# mypy: ignore-errors\n# fmt: off\n",
        "from motionlang.lang.tables import Tables",
        f"from motionlang.{package}.build import *",
        f"from motionlang.{package}.nodes import *\n",
        *rules.functions,
        f"\nTOKEN = {token!r}\n",
        f"CONTINUED = {continued!r}\n",
        f"LITERALS = {_wrapped(literals)}\n",
        f"CLASSES = {_wrapped(classes)}\n",
        f"SPELLINGS = {_wrapped(_spellings(lark))}\n",
        "RULES = (\n" + "".join(f"    {each},\n" for each in rules.rows) + ")\n",
        "ROWS = (\n" + "".join(f"    {each!r},\n" for each in rows) + ")\n",
        "TABLES = Tables(TOKEN, CONTINUED, LITERALS, CLASSES, RULES, ROWS, "
        f"{table.start_states['start']}, {table.end_states['start']})",
    ]
    return "\n".join(parts) + "\n"


def _wrapped(mapping: dict[str, str]) -> str:
    return "{\n" + "".join(f"    {key!r}: {value!r},\n" for key, value in mapping.items()) + "}"


# ------------------------------------------------------------------------------------------------ the rules


class _Rules:
    """Numbers the rules in the order in which they are met, and writes their reducers."""

    def __init__(self, actions: dict[str, str]) -> None:
        self.actions = actions
        self.rows: list[str] = []
        self.functions: list[str] = []
        self._numbers: dict[Any, int] = {}
        self._written: dict[str, str] = {}

    def number(self, rule: Any) -> int:
        """The number of a rule of Lark's."""
        if rule not in self._numbers:
            self._numbers[rule] = len(self.rows)
            self.rows.append(f"({len(rule.expansion)}, {str(rule.origin.name)!r}, {self._reducer(rule)})")
        return self._numbers[rule]

    def identity(self, rule: Any) -> bool:
        """Does the rule have one symbol, whose value stays as it is?"""
        return len(rule.expansion) == 1 and rule.options.expand1 and not rule.alias

    def _reducer(self, rule: Any) -> str:
        """The name of the function that does a rule's action, written once for every shape of it."""
        length = len(rule.expansion)
        if self.identity(rule):
            return "None"
        alias = rule.alias or rule.options.template_source or rule.origin.name
        lines = _reducer_body(self._expression(rule, alias), length)
        if not lines:
            return "None"
        text = "\n".join(lines)
        if text not in self._written:
            name = self._written[text] = f"_{alias}_{len(self._written)}"
            self.functions.append(f"\ndef {name}(V, T):\n{text}\n")
        return self._written[text]

    def _expression(self, rule: Any, alias: str) -> str:
        """The action with its `v…` counted over the symbols that are there."""
        present = rule.options.empty_indices or (False,) * len(rule.expansion)
        places: list[str] = []
        symbols = iter(range(len(rule.expansion)))
        for missing in present:
            places.append("None" if missing else f"v{next(symbols)}")
        if alias == "more":
            last = max(i for i, symbol in enumerate(rule.expansion) if not symbol.is_term)
            return f"+ v{last}"
        return re.sub(r"\bv(\d+)", lambda found: places[int(found[1])], self.actions[alias])


def _reducer_body(expression: str, length: int) -> list[str]:
    """The lines that replace the last `length` values by one, taking only what is needed off the stack."""
    append = expression.startswith("+ ")
    value = expression.removeprefix("+ ")
    used = {int(digits) for digits in re.findall(r"\bv(\d+)", value)}
    if length == 0:
        return [f"    V.append({value})"]
    if value == "v0":
        return _drop(length - 1)
    lines = []
    for place in sorted(used, reverse=True) if length <= 3 else sorted(used):
        if length > 3:
            lines.append(f"    v{place} = V[{place - length}]")
    if length > 3:
        lines += _drop(length - 1)
    else:
        for place in range(length - 1, 0, -1):
            lines.append(f"    v{place} = V.pop()" if place in used else "    V.pop()")
        if 0 in used:
            lines.append("    v0 = V[-1]")
    lines.append(f"    V[-1].append({value})" if append else f"    V[-1] = {value}")
    return lines


def _drop(count: int) -> list[str]:
    return ["    V.pop()"] * count if count <= 2 else [f"    del V[-{count}:]"]


# ----------------------------------------------------------------------------------------------- the states


def _rows(table: Any, rules: _Rules) -> list[str]:
    """Every state as text; the order is Lark's, which is the same on every run."""
    through = _bypasses(table, rules)
    return [_row(actions, rules, through, table) for _, actions in sorted(table.states.items())]


def _bypasses(table: Any, rules: _Rules) -> dict[int, str]:
    """The states that can only rename one symbol: a shift to one goes on to where the renaming leads."""
    found = {}
    for number, actions in table.states.items():
        all_rules = {arg for kind, arg in actions.values() if kind is not Shift}
        if len(all_rules) == 1 and all(kind is not Shift for kind, _ in actions.values()):
            rule = all_rules.pop()
            if rules.identity(rule):
                found[number] = rule.origin.name
    return found


def _row(actions: Any, rules: _Rules, through: dict[int, str], table: Any) -> str:
    targets: dict[int, list[str]] = {}
    reductions: Counter[Any] = Counter(arg for kind, arg in actions.values() if kind is not Shift)
    default = reductions.most_common(1)[0][0] if reductions else None
    others: dict[Any, list[str]] = {}
    for symbol, (kind, arg) in actions.items():
        if kind is Shift:
            while arg in through:
                arg = actions[through[arg]][1]
            targets.setdefault(arg, []).append(symbol)
        elif arg is not default:
            others.setdefault(arg, []).append(symbol)
    entries = [f"{target}={','.join(sorted(symbols))}" for target, symbols in sorted(targets.items())]
    entries += sorted(
        f"r{rules.number(rule)}={','.join(sorted(symbols))}" for rule, symbols in others.items()
    )
    if default is not None:
        entries.append(f"d{rules.number(default)}")
    return " ".join(entries)


# -------------------------------------------------------------------------------------------- the terminals


# Texts that no terminal matches, each swallowed whole so that broken text is read once: an open string, `12abc`.
_LEFTOVERS = r'"[^\n]*|[0-9][A-Za-z0-9_]*|.'
_JOINED = re.compile(r"(?:\\.|[^\\()\[\]+*?.])+")  # "<>" | "<=": literal texts and nothing else


def _terminals(lark: Lark) -> tuple[dict[str, str], dict[str, str]]:
    """The literal texts (words in lower case, operators) and the patterns of the other kinds of token."""
    literals, classes = {}, {}
    for terminal in lark.terminals:
        if terminal.name in lark.ignore_tokens:
            continue
        pattern = re.sub(r"\(\?i?:|(?<!\\)\)", "", terminal.pattern.value)
        if terminal.pattern.type == "str":
            literals[terminal.pattern.value.lower()] = str(terminal.name)
        elif _JOINED.fullmatch(pattern):
            for text in pattern.split("|"):
                literals[re.sub(r"\\(.)", r"\1", text).lower()] = str(terminal.name)
        else:
            classes[str(terminal.name)] = terminal.pattern.to_regexp()
    return dict(sorted(literals.items())), classes


def _spellings(lark: Lark) -> dict[str, str]:
    """From the kind of a fixed token to its text as the grammar spells it, for messages and completion."""
    return {str(each.name): each.pattern.value for each in lark.terminals if each.pattern.type == "str"}


def _token_patterns(lark: Lark, literals: dict[str, str], classes: dict[str, str]) -> tuple[str, str]:
    """One pattern for every token, without and with continued lines; words are told apart afterwards."""
    ignored = {
        each.name: each.pattern.to_regexp() for each in lark.terminals if each.name in lark.ignore_tokens
    }
    operators = [re.escape(text) for text in literals if len(text) > 1 and not text[0].isalpha()]
    found = "|".join([*classes.values(), *operators, _LEFTOVERS])
    blank = ignored.pop("BLANK")
    return f"(?:{blank})?({found})", f"(?:{'|'.join([blank, *ignored.values()])})*({found})"


def main(arguments: list[str]) -> int:
    """Write the tables of every dialect that has a grammar."""
    from motionlang.mint.actions import ACTIONS

    with open(os.path.join(ROOT, "mint", "tables.py"), "w", encoding="utf-8") as file:
        file.write(generate("mint.lark", "mint", ACTIONS))
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
