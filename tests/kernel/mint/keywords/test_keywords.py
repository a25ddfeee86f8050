"""The vocabulary: simulated keywords have examples that run, others a diagnostic."""

from __future__ import annotations

import re

import pytest

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import Keyword, Source
from motionlang.kernel.mint import DIALECT, table
from tests.cases import cases, draws_one_in
from tools.keyword_pages import machine_of

SIMULATED = [row for row in table() if row.simulated and row.example]
OTHERS = [row for row in table() if not row.simulated]
# Keywords without a printable effect, and INPUT, which has no operator.
SILENT = {"NOP", "TRON", "TROFF", "Input", "Rem"}


@pytest.mark.slow
@cases("row", SIMULATED, ids=lambda row: row.name)
def test_an_example_has_its_word_runs_and_shows_something(row: Keyword) -> None:
    assert re.search(rf"\b{row.name}\b", row.example, re.IGNORECASE)
    result = run(Source("example.mnt", row.example), machine=machine_of(row), until=60.0)
    assert [each.message for each in result.diagnostics] == []
    assert result.status == "ended"
    assert (result.output == []) is (row.name in SILENT)


# Indices with which a keyword is read on a default machine, if not 1 for each.
INDICES = {
    "none": "",
    "axis": "(0)",
    "channel": "(0)",
    "bus, node": "(1, 2)",
    "bank": "(0)",
    "task": "(Later)",
}


def test_a_word_reads_its_default_at_power_up() -> None:
    read = [row for row in SIMULATED if "R" in row.access and isinstance(row.default, float | int)]
    indices = [INDICES.get(row.index, f"({', '.join('1' for _ in row.index.split(', '))})") for row in read]
    text = "".join(f"PRINT {row.name}{index} USING 1, 3\n" for row, index in zip(read, indices, strict=True))
    text += "Task Later\nEnd Task\n"
    assert len(read) > 150
    printed = run(Source("power-up.mnt", text), machine={"controller.instruction_time": 1e-4}).output
    # A reading of its own statement's time is 0 before the first one.
    assert {
        row.name
        for row, value in zip(read, printed, strict=True)
        if abs(float(value) - float(row.default or 0.0)) > 5e-4
    } == {"SYSTEMSECONDS", "TIME"}


def test_rows_are_complete() -> None:
    for row in table():
        assert row.help, row.name
        assert row.access in ("R", "W", "RW", "C"), row.name
        if row.simulated and row.kind not in ("constant",):
            assert row.example or row.name == "Controller", row.name


def test_no_name_or_short_form_has_two_keywords() -> None:
    """A keyword that becomes simulated must be removed from the files of the type library."""
    spellings = [each.lower() for row in table() for each in {row.name.lower(), row.short.lower()} if each]
    assert {each for each in spellings if spellings.count(each) > 1} == set()


@cases(
    ("short", "name"),
    [
        ("MB", "MOVEBUFFERSIZE"),
        ("FRM", "FEEDRATEMODE"),
        ("FRO", "FEEDRATEOVERRIDE"),
        ("OFS", "OFFSETSTATUS"),
        ("GR", "GEARING"),
        ("GRM", "GEARINGMODE"),
        ("SPL", "SPLINE"),
        ("MA", "MOVEA"),
        ("ps", "POS"),
        ("cn", "CANCEL"),
        ("st", "STOP"),
        ("de", "DRIVEENABLE"),
        ("kp", "KPROP"),
        ("hps", "HOMEPOS"),
    ],
)
def test_a_documented_short_form_has_the_row_of_its_keyword(short: str, name: str) -> None:
    row = table().get(short)
    assert row is not None
    assert (row.name, row.word) == (name, short.upper())


def used(row: Keyword) -> str:
    """Return a valid statement with a keyword."""
    word = row.name if row.index == "none" else f"{row.name}({', '.join('0' for _ in row.index.split(', '))})"
    if "R" in row.access:
        return f"x = Len({word})" if row.unit == "text" else f"x = {word}"
    return word if row.access == "C" else f"{word} = 1"


def test_a_word_that_is_not_simulated_is_never_called_unknown() -> None:
    for row in OTHERS[::draws_one_in]:
        codes = {each.code for each in check(DIALECT.program(Source("a.mnt", used(row))))}
        assert "not-simulated" in codes, row.name
        assert "unknown-word" not in codes, row.name
