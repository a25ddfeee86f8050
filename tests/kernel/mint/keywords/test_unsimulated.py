"""Known keywords that are not simulated: how far a program runs, and its messages."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import Diagnostic, Keyword, Machine, ProgramError, Run, Source, read_machine
from motionlang.kernel.lang import KEYS
from motionlang.kernel.mint import DIALECT, table
from motionlang.kernel.mint.keywords import identity
from motionlang.kernel.mint.keywords import legacy as older
from motionlang.kernel.mint.keywords.machine_readings import can_be_supplied
from motionlang.kernel.mint.keywords.unsimulated import COMMAND, MOTION, VALUE
from motionlang.kernel.tools import as_hint
from motionlang.repl.runner import Runner
from tests.cases import cases, examples

MEANINGLESS = "listed by the type library without a meaning"
OTHERS = [row for row in table() if not row.simulated]


def ran(*lines: str, **machine: object) -> Run:
    return run(Source("a.mnt", "\n".join(lines)), machine=machine, until=60.0)


def locations(result: Run) -> list[tuple[str, int, int]]:
    return [(each.severity, each.line, each.column) for each in result.diagnostics]


def word(row: Keyword) -> str:
    return row.name if row.index == "none" else f"{row.name}({', '.join('0' for _ in row.index.split(', '))})"


def value(row: Keyword) -> str:
    return '"abc"' if row.unit == "text" else "2.5" if row.unit == "number" else "1"


def shown(row: Keyword) -> str:
    return {"text": "abc", "number": "2.5000"}.get(row.unit, "1")


# --------------------------------------------------------------------------------------- every listed keyword


@pytest.mark.slow
@cases("row", [row for row in OTHERS if "W" in row.access and row.verb != MOTION], ids=str)
def test_what_is_written_is_read_back_and_named(row: Keyword) -> None:
    read = f"PRINT {word(row)}" if "R" in row.access else ""
    result = ran(f"{word(row)} = {value(row)}", read, 'PRINT "on"')
    assert result.status == "ended"
    assert result.output == [*([shown(row)] if read else []), "on"]
    assert f"{row.name} (line 1)" in result.notes[0]


@cases("row", [row for row in OTHERS if row.verb == COMMAND], ids=str)
def test_a_command_without_an_effect_is_named(row: Keyword) -> None:
    result = ran(word(row), 'PRINT "on"')
    assert (result.status, result.output, result.diagnostics) == ("ended", ["on"], [])
    assert result.notes == [f"keywords without effect here: {row.name} (line 1)"]


@cases("row", [row for row in OTHERS if row.verb == MOTION], ids=str)
def test_keywords_that_move_or_decide_end_the_run_at_their_location(row: Keyword) -> None:
    statement = word(row) if row.access == "C" else f"{word(row)} = 1"
    result = ran('PRINT "before"', f"IF 1 THEN {statement}", 'PRINT "after"')
    assert (result.status, result.output) == ("fault", ["before"])
    assert locations(result) == [("error", 2, 11)]
    assert {each.code for each in result.diagnostics} == {"not-simulated"}


@cases("row", [row for row in OTHERS if row.verb == MOTION and "W" in row.access], ids=str)
def test_what_would_move_may_be_switched_off(row: Keyword) -> None:
    result = ran(f"{word(row)} = 0", 'PRINT "on"')
    assert (result.status, result.output, result.diagnostics) == ("ended", ["on"], [])


@cases("row", [row for row in OTHERS if row.verb == VALUE and "R" in row.access], ids=str)
def test_unknown_value_ends_the_run_unless_the_machine_file_gives_it(row: Keyword) -> None:
    result = ran(f"PRINT {word(row)}")
    assert result.status == "fault"
    assert locations(result) == [("error", 1, 7)]
    assert f"[mint.values] {row.name} = " in result.diagnostics[0].hint
    reported = "abc" if row.unit == "text" else 2.5 if row.unit == "number" else 1
    result = ran(f"PRINT {word(row)}", **{f"mint.values.{row.name}": reported})
    assert (result.status, result.output, result.diagnostics) == ("ended", [shown(row)], [])


# ------------------------------------------------------------------------------------------- warnings


def test_run_reports_the_check_warnings_at_which_it_may_end() -> None:
    text = "CONFIG(0) = 1\nBINARY\nPRINT TEMPERATURE(0)\nAUTOTUNE(0, 1)\nAUTOHOMEMODE(0) = 0"
    checked = [each for each in check(Source("a.mnt", text), DIALECT) if each.code == "not-simulated"]
    assert [each.line for each in checked] == [1, 2, 3, 4, 5]
    found = ran(text).diagnostics
    assert [each.as_dict() for each in found if each.severity == "warning"] == [checked[3].as_dict()]
    assert [each.line for each in found if each.severity == "error"] == [3]  # it has its own message


def test_a_text_is_no_number_for_them_either() -> None:
    codes = {each.code for each in check(Source("a.mnt", 'DRIVEPARAMETERFLOAT(1, 2) = "abc"'), DIALECT)}
    assert "type" in codes


def test_at_the_prompt_they_end_the_line() -> None:
    """An error in a typed sub is at its call in the last line."""
    reported: list[tuple[str, int, int]] = []

    def report(found: list[Diagnostic], source: Source) -> None:
        reported.extend((each.message, each.line, each.column) for each in found)

    runner = Runner(DIALECT, Machine(), report, lambda time: None)
    for line in ("PARAMETERSAVE", "AUTOTUNE(0, 1)", "Sub S()\n AUTOTUNE(0, 1)\nEnd Sub", "PRINT 1 : S()"):
        runner.execute(Source("<line>", line))
    assert reported == [("AUTOTUNE is not simulated", 1, column) for column in (1, 11)]


# ------------------------------------------------------------------------------------------- the machine file


@pytest.mark.parametrize(
    ("line", "message", "hint"),
    [
        ("DRIVEBUSVOLT = 3", "there is no readable keyword DRIVEBUSVOLT", "did you mean DRIVEBUSVOLTS?"),
        ("dbv = 3", "there is no readable keyword dbv", "did you mean DRIVEBUSVOLTS?"),
        ("POS = 3", "the machine file cannot set POS", "the run computes it"),
        ("AUTOTUNE = 3", "the machine file cannot set AUTOTUNE", "it has no value"),
        ("HALL = 2.5", "HALL is a whole number, not 2.5", "hall sensors group"),
        ('HALL = "a"', "HALL is a whole number, not 'a'", "hall sensors group"),
        ('DBVOLTS = "a"', "DBVOLTS is a whole number, not 'a'", "dynamic brake group"),
        (
            'EFFORTS = "a"',
            "there is no readable keyword EFFORTS",
            "motionlang help keywords lists the keywords of Mint",
        ),
        ("PRODUCTSERIALNUMBER = 3", "PRODUCTSERIALNUMBER is a text, not 3", MEANINGLESS),
        ('HALL = { "0, 1" = 2 }', "HALL has 1 in its brackets, not 2", "it stands for axis"),
        (
            "HALL = [1]",
            "mint.values.HALL must be a number, a text, true or false, not [1]",
            as_hint(KEYS["mint.values.KEYWORD"][1]),
        ),
    ],
)
def test_machine_file_mistake_is_reported_with_its_line(line: str, message: str, hint: str) -> None:
    with pytest.raises(ProgramError) as caught:
        read_machine(Source("m.toml", f"[mint.values]\nTEMPERATURE = 20.5\n{line}\n"))
    (found,) = caught.value.diagnostics
    assert (found.message, found.line, found.column) == (message, 3, 1)
    assert found.hint == hint


def test_every_unknown_value_can_be_supplied() -> None:
    assert all(can_be_supplied(row) for row in OTHERS if "R" in row.access)
    assert all(can_be_supplied(row) for row in identity.ROWS if row.group == "identity")
    assert not any(can_be_supplied(row) for row in older.ROWS)


# --------------------------------------------------------------------------------------------------- any order

given_values = st.sampled_from(["0", "1", "n", "x", '"t"'])
indices = st.sampled_from(["0", "1", "n", "x", "less", '"a"'])


@st.composite
def statements(draw: st.DrawFn) -> str:
    row: Keyword = draw(st.sampled_from(OTHERS))
    count = draw(st.integers(0, 3)) if row.index != "axis" else 1
    where = ", ".join(draw(indices) for _ in range(count))
    use = f"{row.name}({where})" if count else row.name
    if row.access == "C" or ("W" in row.access and draw(st.booleans())):
        return use if row.access == "C" else f"{use} = {draw(given_values)}"
    return f"PRINT {use}"


@settings(max_examples=examples(200), suppress_health_check=list(HealthCheck))
@given(st.lists(statements(), min_size=1, max_size=8))
def test_no_program_ends_in_a_traceback(lines: list[str]) -> None:
    first = "Dim n As Integer = 3, x As Float = 2.5, less As Integer = -1"
    result = ran(first, *lines)
    assert result.status in ("ended", "fault")
    assert all(each.line for each in result.diagnostics)
