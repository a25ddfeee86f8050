"""Literals by address: a run with other values is that of the edited program."""

from __future__ import annotations

import re

import pytest

import motionlang
from motionlang.kernel import Program, ProgramError, Source, dialect
from motionlang.kernel.lang import canonical, revalued
from motionlang.kernel.mccl import Line, MacroFile
from motionlang.kernel.report import text
from tests.cases import cases

DRILL = """\
SPEED(0, 1) = 100, 50 : ACCEL(0, 1) = 1000; : DECEL.0 = 1000
Define clear = 5
d = 40 ' 3
WAIT = 10
WAIT(20)
IF d > 7 THEN MOVEA(0) = -d / 2 - 1 : GO(0)
PAUSE IDLE(0) = 1
MOVEA[0] = -15 : GO[0] : PAUSE IDLE.0

PRINT 10
"""
FEED = '1SV100,1SA1000\nMD3,1MR-5,1WS0.1,1MR5,MC4\nFT"part %d",1MA@3,WA.5 ; WA9\n'


def program(text: str, language: str = "mint") -> Program:
    return dialect(language).program(Source("a", text))


def addresses(text: str, language: str = "mint") -> dict[str, str]:
    """Return the literals of a program by address."""
    return {each.address: each.text for each in program(text, language).literals}


def test_the_literals_of_mint() -> None:
    """Channels and comments are not literals; a number on its own includes its sign."""
    assert addresses(DRILL) == {
        "SPEED[0]@1": "100",
        "SPEED[1]@1": "50",
        "ACCEL[0,1]@1": "1000",
        "DECEL[0]@1": "1000",
        "clear@2": "5",
        "d@3": "40",
        "WAIT@4": "10",
        "WAIT@5": "20",
        "d@6": "7",
        "MOVEA[0]@6:1": "2",
        "MOVEA[0]@6:2": "1",
        "IDLE[0]@7": "1",
        "MOVEA[0]@8": "-15",
    }


CONDITIONS = """\
PAUSE POS(0) > 100 And INX(2) = 1
If n >= 5 Or (k < -3) Then n = 7
For i = 1 To 10 Step 2
Next
If (n = 3) & (k = 4) Then k = 5
If n + 2 > x * 3 Then Exit
Repeat
Until 50 < POS.1
Select Case n
Case 3, 5 To 7
End Select
While 1 : End While
"""


def test_the_literals_of_conditions_and_loops() -> None:
    """Conditions do not change the addresses of writes.

    Numbers of Case and numbers on their own have no address.
    """
    assert addresses(CONDITIONS) == {
        "POS[0]@1": "100",
        "INX[2]@1": "1",
        "n@2": "7",
        "n@2:2": "5",
        "k@2": "-3",
        "i@3:1": "1",
        "i@3:2": "10",
        "i@3:3": "2",
        "n@5": "3",
        "k@5": "5",
        "k@5:2": "4",
        "n@6:1": "2",
        "n@6:2": "3",
        "POS[1]@8": "50",
    }


# A statement, and the literals of it and of the next one.
STATEMENTS: dict[str, dict[str, str]] = {
    "SPEED(0, \\\n 1) = 5, \\ ' both\n 6\nWAIT = 7": {"SPEED[0]@1": "5", "SPEED[1]@1": "6", "WAIT@4": "7"},
    "MOVEA(0, 1) = 5, \\\n 6 : WAIT = 7": {"MOVEA[0]@1": "5", "MOVEA[1]@1": "6", "WAIT@2": "7"},
    "SPEED(0, 1) = (5 + 6), 7": {"SPEED[0]@1:1": "5", "SPEED[0]@1:2": "6", "SPEED[1]@1": "7"},
    "If (n = 3 And k = 4) Then k = 5": {"n@1": "3", "k@1:2": "4", "k@1": "5"},
    "PAUSE (POS(0) > 5 Or (INX(3) = 1)) : WAIT = 2": {"POS[0]@1": "5", "INX[3]@1": "1", "WAIT@1": "2"},
    "SPEED(n Mod 2) = 5 : WAIT(3) : SPEED(1) = 6": {"SPEED[nMod2]@1": "5", "WAIT@1": "3", "SPEED[1]@1": "6"},
    "x = f(1, (2 + 3), 4) : WAIT = 5": {"WAIT@1": "5"},
    "WAIT 7 : PRINT 5\nWAIT 2 + 1": {"WAIT@1": "7", "WAIT@2:1": "2", "WAIT@2:2": "1"},
    # An index with a dot is none that WAIT has: it has no address.
    "WAIT.7 : WAIT(8)": {"WAIT@1": "8"},
    "' a comment (\nSPEED(0) = 5 ' ) another\nWAIT = 2": {"SPEED[0]@2": "5", "WAIT@3": "2"},
    "SPEED(0)) = 5\nWAIT = 3": {"WAIT@2": "3"},
    # Values of several axes, and a list that does not match them.
    "SPEED(0, 1) = 5;": {"SPEED[0,1]@1": "5"},
    "SPEED(0,1,2) = 5, 6;": {"SPEED[0]@1": "5", "SPEED[1,2]@1": "6"},
    "SPEED(0,1) = 5, 6, 7": {"SPEED[0,1]@1:1": "5", "SPEED[0,1]@1:2": "6", "SPEED[0,1]@1:3": "7"},
    "SPEED = 5, 6": {"SPEED@1:1": "5", "SPEED@1:2": "6"},
    "SPEED.0 = 5 : SPEED.1.2 = 6": {"SPEED[0]@1": "5", "SPEED[1,2]@1": "6"},
    # A sign is part of a number on its own; the numbers of an index or an argument are none.
    "x = -5 : y = - 6": {"x@1": "-5", "y@1": "- 6"},
    "x = 5 - 3 : y = (6)": {"x@1:1": "5", "x@1:2": "3", "y@1:1": "6"},
    "x = 5 * (3 + f(2, a(4)))": {"x@1:1": "5", "x@1:2": "3"},
    "SPEED(a(1)) = 5\nIf a(b(2)) = 4 Then Exit": {"SPEED[a(1)]@1": "5", "a[b(2)]@2": "4"},
    "SPEED(f(1, 2), 3) = 5, 6": {"SPEED[f(1,2)]@1": "5", "SPEED[3]@1": "6"},
    "x = `a : SPEED(`a`) = `b` + 5": {},
    "x = `a` + 5": {"x@1:1": "5"},
    # Settings and commands without an index take their value in brackets, or after a blank.
    "TIME(5) : WAIT(1, 2) : OUT 5 : GO(5)": {"TIME@1": "5", "WAIT@1:1": "1", "WAIT@1:2": "2"},
    "WAIT(5) 7 : SPEED(0) 5 : SPEED 5 : x 5 : 5 = x : (5) = x": {},
    # Declarations have none, apart from Define.
    "Const c = 5 : Dim x = 5, y = 6 : Define k = 5": {"k@1": "5"},
    "If x Then WAIT = 5 Else WAIT = 6": {"WAIT@1:1": "5", "WAIT@1:2": "6"},
    "If x = 1 Then y = 2 : z = 3": {"x@1": "1", "y@1": "2", "z@1": "3"},
    # The operators of bits join comparisons, unless one side has none.
    "If (x = 1) & (y = 2) Then Exit": {"x@1": "1", "y@1": "2"},
    "If x & 3 = 1 Then Exit": {"x@1:1": "3", "x@1:2": "1"},
    "If (x & 3) = 1 Then Exit": {"x@1:1": "3", "x@1:2": "1"},
    "If (a(3) = 4) Then Exit": {"a[3]@1": "4"},
    "If x = 1 & y = 2 Then Exit": {"x@1:1": "1", "x@1:2": "2"},  # (x = (1 & y)) = 2
    "If Not x = 1 Xor 2 < y Then Exit": {"x@1": "1", "y@1": "2"},
    "If x Mod 4 = 1 Then y = 9 Mod 5": {"x@1:1": "4", "x@1:2": "1", "y@1:1": "9", "y@1:2": "5"},
    "If x & 3 Then PAUSE 5 : If 5 Then PRINT 5 > x And x < 6": {},
    "Repeat : While x = 5 : End While : Until 3 = x": {"x@1:1": "5", "x@1:2": "3"},
    # The right side of an assignment is no condition.
    "x = y > 5 And z < 6": {"x@1:1": "5", "x@1:2": "6"},
    # The numbers of a For belong to its variable.
    "For i = -1 To a(3) Step - 2 : Next": {"i@1:1": "-1", "i@1:2": "- 2"},
    # A name may be a control word where that is impossible.
    "For to = 1 To 5 : Next : To = 5": {"To@1": "5", "To@1:2": "1", "To@1:3": "5"},
    # A line with a syntax error has none.
    "WAIT = 5\nIf x = 1 & y = 2\nWAIT = 6": {"WAIT@1": "5", "WAIT@3": "6"},
}


@pytest.mark.parametrize("text", STATEMENTS)
def test_where_a_statement_ends(text: str) -> None:
    assert addresses(text) == STATEMENTS[text]


# A program, and the numbers that it gives to names.
CONSTANTS: dict[str, dict[str, str]] = {
    "Const a = 5, b As Float = 6": {"a": "5", "b": "6"},
    "Dim a = 5, b As Integer = 6, c, d": {"a": "5", "b": "6"},
    "Dim NV a As Integer = 7": {"a": "7"},
    # A Define has an address.
    "Define a = 5 : x = a": {},
    'Const a = -5, b = 5 * 2, c = 5 Mod 2, d = (5), e = "x"': {},
    "Dim a(2) As Float = 5, 6": {},
}


@pytest.mark.parametrize("text", CONSTANTS)
def test_the_constants_of_mint(text: str) -> None:
    assert {each.address: each.text for each in program(text).constants} == CONSTANTS[text]


def test_a_condition_is_varied() -> None:
    """A move at 100 uu/s with ramps of 5 uu prints TIME at 30, or at 60."""
    text = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVEA(0) = 90 : GO(0)\nPAUSE POS(0) >= 30\nPRINT TIME\n"
    at = [
        motionlang.run(Source("a.mnt", text), overrides={"POS[0]@3": value}).output for value in (30.0, 60.0)
    ]
    assert at == [["350"], ["650"]]  # 0.1 s for the first 5 uu, then 10 ms per uu
    loop = "Dim i, n\nFor i = 1 To 10\n  n = n + 1\nNext\nPRINT n\n"
    assert motionlang.run(Source("a.mnt", loop), overrides={"i@2:2": 4.0}).output == ["4.0000"]


def test_the_literals_of_mccl() -> None:
    """The numbers of macros and registers are not literals.

    If a command occurs twice in a line, its address has a number.
    """
    assert addresses(FEED, "mccl") == {
        "1SV@1": "100",
        "1SA@1": "1000",
        "1MR@2:1": "-5",
        "1WS@2": "0.1",
        "1MR@2:2": "5",
        "WA@3": ".5",
    }


@pytest.mark.parametrize(
    ("written", "address"),
    [
        ("SPEED.0@12", "SPEED[0]@12"),
        ("SPEED(0, 1) @ 12", "SPEED[0,1]@12"),
        ("SPEED[0]", "SPEED[0]"),
        ("MOVEA[0]@6:2", "MOVEA[0]@6:2"),
        ("1SV", "1SV"),
        ("line:12.value", "line:12"),
        ("speed", None),
        ("line: 07", "line:7"),
        ("x@007:02", "x@7:2"),
        ("SPEED.0.1", "SPEED[0,1]"),
        ("SPEED()", "SPEED[]"),
        ("x:2", None),
        ("1SV:2", "1SV:2"),
        ("a b@2", "ab@2"),
        ("line:x", None),
        ("x[1", None),
        ("axis.0.travel", None),
        ("run.until", None),
    ],
)
def test_the_spellings_of_an_address(written: str, address: str | None) -> None:
    assert canonical(written) == address


@pytest.mark.parametrize(
    ("address", "old", "new"),
    [
        ("SPEED[1]@1", "100, 50", "100, 250"),
        ("ACCEL[0,1]@1", "1000;", "250;"),
        ("clear@2", "clear = 5", "clear = 250"),
        ("WAIT@5", "WAIT(20)", "WAIT(250)"),
        ("movea[0]@6:2", "- 1 :", "- 250 :"),
        ("MOVEA.0@8", "= -15", "= 250"),
        ("line:8.value", "= -15", "= 250"),
    ],
)
def test_a_value_replaces_a_number_of_the_tree(address: str, old: str, new: str) -> None:
    key = canonical(address)
    assert key is not None
    made = program(DRILL).with_values({key: 250.0})
    assert made.tree == program(DRILL.replace(old, new)).tree
    assert made.places.notes == []


def test_the_only_write_of_a_line_is_meant_next_to_a_loop() -> None:
    text = "For i = 1 To n : WAIT = 5 : Next"
    made = program(text).with_values({"line:1": 7.0})
    assert made.tree == program("For i = 1 To n : WAIT = 7 : Next").tree


def test_an_address_without_a_line_is_every_write() -> None:
    made = program(DRILL).with_values({"Wait": 7.5})
    assert made.tree == program(re.sub(r"(WAIT\D*)\d+", r"\g<1>7.5", DRILL)).tree
    assert made.places.notes == ["WAIT = 7.5 sets 2 literals, lines 4, 5"]
    assert [each.text for each in revalued(made) if each.base == "WAIT"] == ["7.5", "7.5"]
    assert [each.text for each in made.literals if each.base == "WAIT"] == ["10", "20"]


def test_a_value_replaces_a_parameter_of_mccl() -> None:
    """The command shows its new text; its position is the old one."""
    made = dialect("mccl").program(Source("a", FEED)).with_values({"1MR@2:1": 250.5, "1SV@1": -5})
    assert isinstance(made, MacroFile)
    lines = [line for line in made.lines if isinstance(line, Line)]
    assert [line.text for line in lines[:2]] == ["1SV-5,1SA1000", "MD3,1MR250.5,1WS0.1,1MR5,MC4"]
    assert [each.value for each in lines[1].commands] == [3, 250.5, 0.1, 5, 4]
    assert [each.text for each in revalued(made)] == ["-5", "1000", "250.5", "0.1", "5", ".5"]
    assert made.errors[0].column == 1


def test_a_keyword_is_a_name_only_if_the_program_declares_it() -> None:
    """`--set wait=…` sets the declared name if there is one, and not the keyword.

    If there is none, it once replaced only the first WAIT.
    """
    text = "WAIT = 10\nWAIT = 10\nPRINT TIME"
    assert motionlang.run(Source("a.mnt", text), overrides={"Wait": 30}).output == ["60"]
    own = "Const step As Float = 2\nPRINT step"  # the word of For … To … Step
    assert motionlang.run(Source("a.mnt", own), overrides={"step": 3}).output == ["3.0000"]


ALL = "write SPEED[0]@1, SPEED[1]@1, ACCEL[0,1]@1, DECEL[0]@1 …; check --literals lists all"
NO_ADDRESS = "the numbers of line 10 have no address: those of CASE, PRINT and brackets have none"


@cases(
    "address, message, hint",
    [
        ("SPEED[0]@2", "line 2 writes no literal to SPEED[0]", "write SPEED[0]@1"),
        ("MOVEA[0]@6", "MOVEA[0]@6 is one of 2 literals", "write MOVEA[0]@6:1, MOVEA[0]@6:2"),
        ("MOVEA[0]@6:9", "line 6 has 2 literals of MOVEA[0]", "write MOVEA[0]@6:1, MOVEA[0]@6:2"),
        ("WAIT@4:2", "line 4 has 1 literal of WAIT", "write WAIT@4"),
        ("d@7", "line 7 writes no literal to D", "write d@3, d@6"),
        ("line:1", "line 1 has 4 literals", "write SPEED[0]@1, SPEED[1]@1, ACCEL[0,1]@1, DECEL[0]@1"),
        ("line:6", "line 6 has 3 literals", "write d@6, MOVEA[0]@6:1, MOVEA[0]@6:2"),
        ("line:9", "line 9 has no literals", ALL),
        ("line:99", "line 99 has no literals", ALL),
        ("line:10", NO_ADDRESS, ALL),
        ("x@10", NO_ADDRESS, ALL),
        ("x@9", "line 9 writes no literal to X", ALL),
        ("SPEED[7]", "the program writes no literal to SPEED[7]", "write SPEED[1]@1"),
        ("IDLE[0]", "the program writes no literal to IDLE[0]", "write IDLE[0]@7"),
        ("IDLE", "the program writes no literal to IDLE", "write IDLE[0]@7"),
        ("SPED[0]@1", "line 1 writes no literal to SPED[0]", "write SPEED[0]@1"),
    ],
)
def test_what_is_wrong_names_the_addresses(address: str, message: str, hint: str) -> None:
    with pytest.raises(ProgramError) as wrong:
        program(DRILL).with_values({address: 1.0}).require()
    (found,) = wrong.value.diagnostics
    shown = hint if hint == ALL else f"{hint}; check --literals lists all"
    assert (found.code, found.message, found.hint) == ("option", message, shown)


def test_all_wrong_addresses_are_reported() -> None:
    with pytest.raises(ProgramError) as wrong:
        program(DRILL).with_values({"SPEED[0]@2": 1.0, "other": 3.0, "line:9": 2.0}).require()
    assert [each.message for each in wrong.value.diagnostics] == [
        "line 2 writes no literal to SPEED[0]",
        "line 9 has no literals",
    ]


def test_a_program_without_literals_has_no_hint() -> None:
    with pytest.raises(ProgramError) as wrong:
        program("PRINT x").with_values({"line:1": 1.0}).require()
    assert [(each.message, each.hint) for each in wrong.value.diagnostics] == [("line 1 has no literals", "")]


@cases(
    "value, text",
    [
        (5.0, "5"),
        (0.25, "0.25"),
        (-3, "-3"),
        (999999999999999.0, "999999999999999"),
        (1e15, "1000000000000000.0"),
        (-1e15, "-1000000000000000.0"),
        (1e300, "1e+300"),
    ],
)
def test_the_notation_of_a_value(value: float, text: str) -> None:
    """Whole numbers below 1e15 have no decimal point."""
    (found,) = revalued(program("WAIT = 7").with_values({"WAIT@1": value}))
    assert found.text == text


@cases("value", ["a", float("inf"), float("-inf"), float("nan")])
def test_a_literal_is_a_finite_number(value: float | str) -> None:
    """An infinite value once ended in an internal error."""
    with pytest.raises(ProgramError) as wrong:
        program("WAIT = 7").with_values({"WAIT@1": value}).require()
    assert [each.message for each in wrong.value.diagnostics] == [f"WAIT@1 is a number, not {value!r}"]


STROKE = (
    "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVEA(0) = 50 : GO(0)\nPAUSE IDLE(0)\nWAIT = 20\n"
)


def test_a_run_is_that_of_the_edited_text() -> None:
    """50 mm at 250 mm/s and 1000 mm/s² is a triangle, and takes 2 √(50 / 1000) s."""
    run = motionlang.run(Source("a.mnt", STROKE), overrides={"SPEED[0]@1": 250})
    plain = motionlang.run(Source("a.mnt", STROKE.replace("= 100 ", "= 250 ")))
    assert text(run) == text(plain)
    profile = run.machine.log.moves[0].profile
    assert profile is not None
    assert profile.duration == pytest.approx(2 * (50 / 1000) ** 0.5)


def test_every_row_of_a_sweep_is_a_run_of_the_edited_text() -> None:
    """A variant without an error runs the compiled program with other constants.

    -5 is rejected, as in the edited program.
    """
    speeds = (50, 100, -5, 250)
    source = Source("a.mnt", STROKE)
    rows = motionlang.sweep(source, {"SPEED[0]@1": list(speeds)}, keep=["time", "prints", "moves"])
    for row, speed in zip(sorted(rows, key=lambda row: row.index), speeds, strict=True):
        run = motionlang.run(Source("a.mnt", STROKE.replace("= 100 ", f"= {speed} ")))
        assert row["time"] == run.time
        assert row["prints"] == "\n".join(run.output)
        assert row["moves"] == len(run.machine.log.moves)
        errors = [each.message for each in run.diagnostics]
        assert ([] if row.problem is None else [row.problem["message"]]) == errors
