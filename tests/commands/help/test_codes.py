"""`motionlang help CODE`: each example has its diagnostic, and its fix has none."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path

import pytest

import motionlang
from motionlang.commands.check.rules import RULES
from motionlang.commands.help.codes import fix
from motionlang.commands.help.explanations import EXAMPLES, FIXES, Example
from motionlang.kernel import CODES
from tests.cli.programs import Cell

# By code: why there is no example.
WITHOUT_EXAMPLE = {
    "crash": "no program is known that causes one",
    "interrupted": "it takes a key press or a signal",
    "limit": "it takes a log of several gigabytes",
}
# Codes in brackets, and in JSON.
_CODE = re.compile(r'(?:error|warning)\[([\w-]+)\]|"code": "([\w-]+)"')


def codes(cell: Cell, example: Example) -> set[str]:
    """Return the codes that an example's command prints."""
    for name, text in example.files.items():
        cell.write(name, text)
    verb, *rest = example.command.split()
    until = ["--until", "100"] if verb == "run" and "--until" not in rest else []
    ran = cell(verb, *rest, *until)
    return {found[1] or found[2] for found in _CODE.finditer(ran.out + ran.err)}


@pytest.mark.parametrize("code", EXAMPLES)
def test_an_example_has_its_diagnostic_and_its_fix_none(
    code: str, cell: Cell, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest
) -> None:
    if code == "window":  # its commands draw
        request.getfixturevalue("unrendered")
    if code == "extra":  # an installation without the libraries of --trace pick.parquet
        found = importlib.util.find_spec
        monkeypatch.setattr(
            importlib.util, "find_spec", lambda name: None if name == "pyarrow" else found(name)
        )
    wrong, right = EXAMPLES[code]
    assert code in codes(cell, wrong)
    if code != "address":  # the right command serves until it is interrupted
        assert codes(cell, right) == set()


def test_every_code_is_that_of_a_rule_or_has_a_fix_and_an_example_or_a_reason() -> None:
    assert not FIXES.keys() & RULES.keys()
    assert FIXES.keys() | RULES.keys() == CODES.keys()
    assert not EXAMPLES.keys() & WITHOUT_EXAMPLE.keys()
    assert EXAMPLES.keys() | WITHOUT_EXAMPLE.keys() == FIXES.keys()


def test_every_code_that_is_raised_exists() -> None:
    """A code that is not in the list has no explanation."""
    raised = re.compile(r"\b(?:Rejected|Diagnostic)\(\s*\"([a-z-]+)\"")
    files = Path(motionlang.__file__).parent.rglob("*.py")
    assert {found[1] for path in files for found in raised.finditer(path.read_text("utf-8"))} <= CODES.keys()


@pytest.mark.parametrize("code", CODES)
def test_every_code_is_explained_in_80_columns(code: str, cell: Cell) -> None:
    shown = cell("help", f"error[{code}]").out
    assert shown.startswith(f"{code}\n\n  ")
    assert f"Fix: {fix(code).split()[0]}" in shown
    assert max(map(len, shown.splitlines())) <= 80


def test_the_code_of_a_message_can_be_pasted(cell: Cell) -> None:
    assert (
        cell("help", "error[never]").out == cell("help", "warning[never]:").out == cell("help", "never").out
    )


def test_all_codes_are_listed(cell: Cell) -> None:
    shown = cell("help", "codes").out
    assert all(f"\n{code} " in f"\n{shown}" for code in CODES)
    assert max(map(len, shown.splitlines())) <= 80


def test_an_unknown_code_gets_a_suggestion(cell: Cell) -> None:
    ran = cell("help", "never-startd")
    assert (ran.status, ran.out) == (1, "")
    assert "did you mean never-started?" in ran.err
