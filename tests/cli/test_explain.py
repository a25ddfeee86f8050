"""`motionlang explain`: each example gets its diagnostic, and its fix gets none."""

from __future__ import annotations

import pytest

from motionlang import Source, check, run
from motionlang.cli.explanations import ADVICE, EXAMPLES
from motionlang.errors import CODES
from tests.cli.programs import Cell


def codes(text: str) -> set[str]:
    """Return the codes that a check and a run of a program report."""
    source = Source("a.mcl" if text.startswith(";") else "a.mnt", text)
    found = [*check(source), *run(source, cache=False, until=100.0).diagnostics]
    return {each.code for each in found}


@pytest.mark.parametrize("code", EXAMPLES)
def test_an_example_has_its_diagnostic_and_its_fix_none(code: str) -> None:
    wrong, right = EXAMPLES[code]
    assert code in codes(wrong)
    assert codes(right) == set()


def test_every_explained_code_exists() -> None:
    assert EXAMPLES.keys() | ADVICE.keys() <= CODES.keys()


@pytest.mark.parametrize("code", CODES)
def test_every_code_is_explained_in_80_columns(code: str, cell: Cell) -> None:
    shown = cell("explain", code).out
    assert shown.startswith(f"{code}\n\n  ")
    assert max(map(len, shown.splitlines())) <= 80


def test_the_code_of_a_message_can_be_pasted(cell: Cell) -> None:
    assert (
        cell("explain", "error[never]").out
        == cell("explain", "warning[never]:").out
        == cell("explain", "never").out
    )


def test_without_a_code_all_are_listed(cell: Cell) -> None:
    shown = cell("explain").out
    assert all(f"\n{code} " in f"\n{shown}" for code in CODES)
    assert max(map(len, shown.splitlines())) <= 80


def test_an_unknown_code_gets_a_suggestion(cell: Cell) -> None:
    ran = cell("explain", "never-startd")
    assert (ran.status, ran.out) == (1, "")
    assert "did you mean never-started?" in ran.err
