"""Every known keyword that is not simulated: how far a program runs, and its messages."""

from __future__ import annotations

from motionlang import run
from motionlang.kernel import Keyword, Run, Source
from motionlang.kernel.mint import table
from tests.cases import cases, draws_one_in

OTHERS = [row for row in table() if not row.simulated]
MOTION = [row for row in OTHERS if row.function == "unsimulated.motion"]
SHOWN = {"text": "abc", "number": "2.5000"}
VALUES = {"text": '"abc"', "number": "2.5"}


def ran(*lines: str, **machine: object) -> Run:
    return run(Source("a.mnt", "\n".join(lines)), machine=machine, until=60.0)


def locations(result: Run) -> list[tuple[str, int, int]]:
    return [(each.code, each.line, each.column) for each in result.diagnostics]


def word(row: Keyword) -> str:
    return row.name if row.index == "none" else f"{row.name}({', '.join('0' for _ in row.index.split(', '))})"


@cases("row", [row for row in OTHERS if "W" in row.access and row not in MOTION][::draws_one_in], ids=str)
def test_what_is_written_is_read_back_and_named(row: Keyword) -> None:
    read = f"PRINT {word(row)}" if "R" in row.access else ""
    value, shown = ("0", "0") if row.high == 0 else (VALUES.get(row.unit, "1"), SHOWN.get(row.unit, "1"))
    result = ran(f"{word(row)} = {value}", read, 'PRINT "on"')
    assert result.status == "ended"
    assert result.output == [*([shown] if read else []), "on"]
    assert f"{row.name} (line 1)" in result.notes[0]


@cases("row", [row for row in OTHERS if row.function == "unsimulated.command"], ids=str)
def test_a_command_without_an_effect_is_named(row: Keyword) -> None:
    result = ran(word(row), 'PRINT "on"')
    assert (result.status, result.output, result.diagnostics) == ("ended", ["on"], [])
    assert result.notes == [f"keywords without effect here: {row.name} (line 1)"]


@cases("row", MOTION, ids=str)
def test_keywords_that_move_or_decide_end_the_run_at_their_location_unless_they_are_switched_off(
    row: Keyword,
) -> None:
    statement = word(row) if row.access == "C" else f"{word(row)} = 1"
    result = ran('PRINT "before"', f"IF 1 THEN {statement}", 'PRINT "after"')
    assert (result.status, result.output) == ("fault", ["before"])
    assert locations(result) == [("not-simulated", 2, 11)]
    if "W" in row.access:
        result = ran(f"{word(row)} = 0", 'PRINT "on"')
        assert (result.status, result.output, result.diagnostics) == ("ended", ["on"], [])


@cases("row", [row for row in OTHERS if row.function == "unsimulated.value" and "R" in row.access], ids=str)
def test_unknown_value_ends_the_run_unless_the_machine_file_gives_it(row: Keyword) -> None:
    result = ran(f"PRINT {word(row)}")
    assert result.status == "fault"
    assert locations(result) == [("not-simulated", 1, 7)]
    assert f"[mint.values] {row.name} = " in result.diagnostics[0].hint
    given = {"text": "abc", "number": 2.5}.get(row.unit, 1)
    result = ran(f"PRINT {word(row)}", **{f"mint.values.{row.name}": given})
    assert (result.status, result.output, result.diagnostics) == ("ended", [SHOWN.get(row.unit, "1")], [])
