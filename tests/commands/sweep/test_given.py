"""A program compiled once for many values gives exactly the results of `--set`."""

from __future__ import annotations

import pytest

from motionlang.kernel import Source, dialect, run
from motionlang.kernel.mint.program import MintProgram
from motionlang.kernel.report import text

MOVES = """
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
MOVER(0) = length : GO(0) : PAUSE IDLE(0)
PRINT "at ", POS(0), " of ", length
"""
# The source of a name's value, the name and its values; true if the value can be bound at the start.
CASES: dict[str, tuple[str, str, tuple[float | str, ...], bool]] = {
    "a constant": ("Const length = 30" + MOVES, "length", (12.0, 7.25), True),
    "one with a type": ("Const length As Float = 30" + MOVES, "length", (12.0, 7.25), True),
    "a whole one, cut off": ("Const length As Integer = 30" + MOVES, "LENGTH", (12.75, -7.25), True),
    "constants made of it": (
        "Const pitch = 5\nConst turns As Integer = pitch * 2\nConst length = turns + pitch / 2" + MOVES,
        "pitch",
        (4.0, 2.5),
        True,
    ),
    "a variable": ("Dim length As Float = 30" + MOVES, "length", (12.0, 7.25), True),
    "a whole variable": ("Dim length As Integer\nlength = 3" + MOVES, "length", (12.0, 8.9), True),
    "a name that nobody declares": ("length = 30" + MOVES, "length", (12.0, 7.25), True),
    "a text": ('Const word = "one"\nPRINT word, Len(word)', "word", ("three", ""), True),
    "a loop": ("Const n As Integer = 3\nDim i\nFor i = 1 To n : PRINT i : Next", "n", (0.0, 5.0), True),
    "an axis": ("Const x = 0\nMOVER(x) = 20 : GO(x) : PAUSE IDLE(x) : PRINT POS(x)", "x", (1.0, 3.0), True),
    "a choice": ('Const n = 1\nSelect Case n\nCase 1 : PRINT "one"\nCase 2 To 4 : PRINT "some"\nEnd Select', "n",
                 (1.0, 3.0), True),
    "a condition": ('Const n = 1\nIf n > 2 Then PRINT "many" Else PRINT "few"', "n", (1.0, 3.0), True),
    "a name that a sub has too": (
        'Const n = 1\nConst m = n + 1\nSay()\nSub Say()\n Dim n = 9\n PRINT m, " ", n\nEnd Sub',
        "n",
        (4.0, 5.0),
        True,
    ),
    "the size of an array": ("Const n = 4\nDim a(n) As Integer\na(n) = 7 : PRINT a(n)", "n", (2.0, 3.0), False),
    "a number that is given as a text": ("Const n = 4\nPRINT n", "n", ("four", 5.0), False),
    "what no float can hold": ("Const n = 4\nPRINT n", "n", (float("inf"), 5.0), True),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_as_if_it_were_in_the_text(case: str) -> None:
    program, name, values, is_bound = CASES[case]
    source = Source("given.mnt", program)
    compiled = dialect("mint").compile_given(source, {}, {name: values[0]})
    assert isinstance(compiled, MintProgram)
    assert (name in compiled.given) is (is_bound or case.startswith("a number"))
    for value in (*values, *values):
        alone = run(source, overrides={name: value})
        assert alone.status == "ended", alone.diagnostics
        again = run(source, overrides={name: value}, compiled=compiled)
        assert text(again) == text(alone), (case, value)


def test_two_names_of_which_one_decides_how_the_program_is_made() -> None:
    source = Source("two.mnt", "Const n = 4\nConst step = 2\nDim a(n)\na(n) = step : PRINT n, a(n)")
    compiled = dialect("mint").compile_given(source, {}, {"n": 4.0, "step": 2.0})
    assert isinstance(compiled, MintProgram)
    assert list(compiled.given) == ["step"]
    for n, step in ((2.0, 1.0), (3.0, 5.5), (2.0, 7.0)):
        values = {"n": n, "step": step}
        assert text(run(source, overrides=values, compiled=compiled)) == text(run(source, overrides=values))


def test_a_file_of_commands_runs_again_and_again() -> None:
    source = Source("r.mcl", "1MN\n1SV10,1SA100,1SD100\n1MR@5,1WS0\n1TP\n")
    compiled = dialect("mccl").compile_given(source, {}, {"R5": 1.0})
    for value in (3.0, 40.0, 3.0):
        alone = run(source, overrides={"R5": value})
        assert alone.output
        assert text(run(source, overrides={"R5": value}, compiled=compiled)) == text(alone)
