"""The table of keywords: every row is valid, and every example runs."""

from __future__ import annotations

from motionlang.kernel import Keyword
from motionlang.kernel.mccl import table
from tests.cases import cases
from tests.mccl_runs import Runner
from tools.keyword_pages import machine_of

SIMULATED = [row for row in table() if row.simulated]
KNOWN = [row for row in table() if not row.simulated]


@cases("row", SIMULATED, ids=lambda row: row.name)
def test_an_example_stands_alone_and_runs_without_a_complaint(row: Keyword, mccl: Runner) -> None:
    """An example runs as printed, from power-up."""
    assert row.name in row.example
    result = mccl(f"{row.example}\n", until=2.0, machine=machine_of(row))
    assert not [each.message for each in result.diagnostics]
    assert result.status == "ended" or row.name in ("GO", "RP")
    assert not any(line.startswith("?") for line in result.output)


@cases("row", KNOWN, ids=lambda row: row.name)
def test_what_is_not_simulated_says_so(row: Keyword, mccl: Runner) -> None:
    result = mccl(f"1{row.name}1\n")
    assert [each.code for each in result.diagnostics] == ["not-simulated"]
    assert result.output == []


def test_every_row_has_its_action_and_one_that_is_simulated_its_verb() -> None:
    assert all(callable(row.actions.do) for row in table())
    assert all(row.function for row in SIMULATED)
    assert all(row.function == "" for row in KNOWN)


@cases("row", list(table()), ids=lambda row: row.name)
def test_a_row_is_filled_in(row: Keyword) -> None:
    assert len(row.name) == 2
    assert row.name.isupper()
    assert row.help.endswith(".")
    assert row.group
    assert row.index in ("axes", "axis", "none")
    assert row.access in ("C", "W", "R")
