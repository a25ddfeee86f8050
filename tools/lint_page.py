"""Writer of the warnings in docs/lint.md: a table, and a section for each rule of the linter.

Only the part of the page between `<!-- rules -->` and `<!-- end -->` is generated.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from motionlang.commands.check.rule import Rule
from motionlang.commands.check.rules import RULES
from motionlang.kernel import dialect

PAGE = Path(__file__).parents[1] / "docs" / "lint.md"
# The groups in the order of the page.
GROUPS = ("Motion", "Control flow", "Names", "Machine")
_GENERATED = re.compile(r"(<!-- rules -->\n).*?(<!-- end -->)", re.DOTALL)


def written() -> str:
    """Return the generated part of the page."""
    groups = {group: [rule for rule in RULES.values() if rule.group == group] for group in GROUPS}
    assert sum(map(len, groups.values())) == len(RULES), "a rule is in an unknown group"
    rows = [f"| `{rule.code}` | {_languages(rule)} |\n" for rules in groups.values() for rule in rules]
    lines = ["\n| warning | language |\n|---|---|\n", *rows]
    for group, rules in groups.items():
        lines.append(f"\n## {group}\n")
        lines += (f"\n### {rule.code}\n\n{rule.text}{''.join(_programs(rule))}" for rule in rules)
    return "".join([*lines, "\n"])


def _languages(rule: Rule) -> str:
    return ", ".join(dialect(language).title for language in rule.cases)


def _programs(rule: Rule) -> Iterator[str]:
    """Yield the programs of each case; those of several languages have titles."""
    for language, case in rule.cases.items():
        title = f"{dialect(language).title}: " if len(rule.cases) > 1 else ""
        machine = _block("the machine file", case.machine) if case.machine else ""
        yield f"{_block(f'{title}with the warning', case.wrong)}{_block(f'{title}without it', case.right)}{machine}"


def _block(title: str, text: str) -> str:
    return f"\n{title[:1].upper()}{title[1:]}:\n\n```text\n{text}```\n"


def files() -> dict[Path, str]:
    text = PAGE.read_text(encoding="utf-8")
    return {PAGE: _GENERATED.sub(lambda found: f"{found[1]}{written()}{found[2]}", text)}
