"""Every rule of the linter finds its mistake in its wrong programs, and nothing in the right ones."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.commands.check import check, rules
from motionlang.commands.check.rule import RuleCase
from motionlang.commands.check.rules import RULES
from motionlang.kernel import CODES, Source, dialect, read_machine

CASES = [
    pytest.param(code, language, case, id=f"{code}-{language}")
    for code, rule in RULES.items()
    for language, case in rule.cases.items()
]


def codes(language: str, text: str, machine: str) -> set[str]:
    """Return the codes of all diagnostics of a program."""
    settings = read_machine(Source("pick.machine.toml", machine)) if machine else {}
    return {each.code for each in check(dialect(language).program(Source("pick", text), settings))}


@pytest.mark.parametrize(("code", "language", "case"), CASES)
def test_a_rule_warns_of_its_wrong_program_and_not_of_the_right_one(
    code: str, language: str, case: RuleCase
) -> None:
    assert code in codes(language, case.wrong, case.machine)
    assert codes(language, case.right, case.machine) == set()


def test_every_rule_has_a_sentence_and_a_file_of_its_name() -> None:
    assert RULES.keys() <= CODES.keys()
    files = Path(str(rules.__file__)).parent.glob("*.py")
    names = {path.stem.replace("_", "-") for path in files if path.stem != "__init__"}
    assert names == RULES.keys()
