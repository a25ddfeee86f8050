"""The vocabulary: simulated keywords have examples that run, others a diagnostic."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import Controller, Keyword, Source
from motionlang.kernel.controller.axis_verbs import SETTINGS
from motionlang.kernel.lang import Vocabulary
from motionlang.kernel.mint import DIALECT, table
from motionlang.kernel.mint.keywords import ORDER, index, no_effect, unsimulated
from tests.cases import cases
from tools.keyword_pages import machine_of

LIBRARY = Path(index.__file__).with_name("type_library")
SIMULATED = [row for row in table() if row.simulated and row.example]
OTHERS = [row for row in table() if not row.simulated]


# Keywords without a printable effect, and INPUT, which has no operator.
SILENT = {"NOP", "TRON", "TROFF", "BEEPON", "BEEPOFF", "REMOTEPDOOUT", "Input", "Rem"}


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
    "axis, channel": "(0, 0)",
    "preset, parameter": "(0, 0)",
    "count, array": "(0, 0)",
}


def test_a_word_reads_its_default_at_power_up() -> None:
    """A channel has no points before a capture."""
    read = [
        row
        for row in SIMULATED
        if "R" in row.access and isinstance(row.default, float | int) and row.name != "CAPTUREPOINT"
    ]
    indices = [INDICES.get(row.index, f"({', '.join('1' for _ in row.index.split(', '))})") for row in read]
    text = "".join(f"PRINT {row.name}{index} USING 1, 3\n" for row, index in zip(read, indices, strict=True))
    text += "Task Later\nEnd Task\n"
    assert len(read) > 350
    printed = run(Source("power-up.mnt", text)).output
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


def test_nothing_in_the_library_is_shadowed() -> None:
    """A keyword that becomes simulated must be removed from the files of the library.

    The library has no short form that is in use.
    """
    lines = [line for file in sorted(LIBRARY.glob("*.txt")) for line in file.read_text("utf-8").splitlines()]
    spellings = [spelling.lower() for line in lines for spelling in line.split("|")[:2] if spelling]
    assert ORDER.split()[-1] == "library"
    own = {word for file, words in index.FILES.items() if file != "library" for word in words.split()}
    assert len(lines) == 507
    assert len(spellings) == len(set(spellings))
    assert own.isdisjoint(spellings)
    assert {row.name for row in OTHERS if row.verb in VERBS} == {line.partition("|")[0] for line in lines}


VERBS = (no_effect.VERB, unsimulated.VALUE, unsimulated.COMMAND, unsimulated.MOTION)


def test_what_is_not_simulated_is_sorted() -> None:
    assert {row.verb for row in OTHERS} <= set(VERBS)
    for row in OTHERS:
        assert (row.verb == unsimulated.COMMAND) <= (row.access == "C"), row.name
        assert (row.access == "C") <= (row.verb in (unsimulated.COMMAND, unsimulated.MOTION)), row.name


def test_what_only_writing_is_not_simulated_of_is_a_word() -> None:
    assert all((row := table().get(word)) is not None and row.name == word for word in unsimulated.WRITTEN)


MOTION = """
ACCELJERKTIME ACCELTIMEMAX BLEND BLENDDISTANCE BLENDMODE CAM CAMAMPLITUDE CAMEND CAMINDEX CAMPHASE CAMSEGMENT CAMSTART
CAMTABLE CIRCLEA CIRCLER CONTOURANGLE CONTOURMODE DECELJERKTIME DECELTIMEMAX FEEDRATE FEEDRATEMODE FEEDRATEOVERRIDE
FEEDRATEPARAMETER FLY FOLLOW FOLLOWMODE GEARING GEARINGMODE HELIXA HELIXR INCA INCR JOG MASTERCHANNEL MASTERDISTANCE
MASTERSOURCE MAXACCEL MAXDECEL MAXSPEED MOVEA MOVEBUFFERFREE MOVEBUFFERID MOVEBUFFERIDLAST MOVEBUFFERLOW MOVEBUFFERSIZE
MOVEDWELL MOVEOUT MOVEOUTX MOVEPULSEOUTX MOVER NVFLOAT NVLONG OFFSET OFFSETDISTANCE OFFSETMODE OFFSETSTATUS PROFILEMODE
SPLINE SPLINEEND SPLINEINDEX SPLINESEGMENT SPLINESTART SPLINESUSPENDTIME SPLINETABLE SPLINETIME SRAMP SUSPEND
TRIGGERMODE VECTORA VECTORR VELDEMANDPATH
"""


@cases("name", MOTION.split())
def test_the_motion_set_is_simulated(name: str) -> None:
    row = table().get(name)
    assert row is not None
    assert row.simulated


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
    for row in OTHERS:
        codes = {each.code for each in check(Source("a.mnt", used(row)), DIALECT)}
        assert "not-simulated" in codes, row.name
        assert "unknown-word" not in codes, row.name


@cases(
    ("written", "meant"),
    [("SPED(0) = 1", "SPEED"), ("x = POOS(0)", "POS"), ("GOO(0)", "GO")],
)
def test_misspelt_keyword_is_reported_with_a_suggestion(written: str, meant: str) -> None:
    (diagnostic, *_) = check(Source("a.mnt", written), DIALECT)
    assert diagnostic.code == "unknown-word"
    assert f"did you mean {meant}?" in diagnostic.hint


# Written by the compiler itself: WAIT and LINE are statements.
COMPILED = {("wait", "W"), ("line", "C")}


@cases("row", [row for row in table() if row.kind in ("setting", "reading", "move", "command")], ids=str)
def test_what_a_word_does_is_a_function_of_its_file_or_is_the_controllers(row: Keyword) -> None:
    made = {how for how in ("read", "write", "load", "do") if getattr(row.actions, how) is not None}
    for access in row.access:
        hows = {"R": {"read"}, "W": {"write", "load", "do"}, "C": {"do", "write"}}[access]
        own = row.verb in SETTINGS or (access == "R" and hasattr(Controller, row.verb))
        assert made & hows or own or (row.verb, access) in COMPILED, access


def test_keyword_is_found_after_any_earlier_search() -> None:
    for row in table():
        for spelling in filter(None, (row.name, row.short)):
            found = Vocabulary("motionlang.kernel.mint.keywords", index.FILES).get(spelling)
            assert found is not None
            assert found.name == row.name
