"""The inputs of a program."""

from __future__ import annotations

from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT as MINT
from tests.cases import cases

# A program, and for each input its number, the level at which a condition is true, and its line.
INPUTS: list[tuple[str, list[tuple[int | None, int | None, int]]]] = [
    ("PAUSE INX(3)", [(3, 1, 1)]),
    ("PAUSE Not INX(3)", [(3, 0, 1)]),
    ("PAUSE Not Not INX(3)", [(3, 1, 1)]),
    ("PAUSE INX(3) = 0", [(3, 0, 1)]),
    ("PAUSE 1 = INX(3)", [(3, 1, 1)]),
    ("PAUSE INX(3) <> 1", [(3, 0, 1)]),
    ("PAUSE INX(3) <> 0", [(3, 1, 1)]),
    ("PAUSE Not (INX(3) = 1)", [(3, 0, 1)]),
    ("PAUSE INX(3) = _ON", [(3, 1, 1)]),
    ("PAUSE INX(3) = _OFF", [(3, 0, 1)]),
    ("PAUSE INX(3) > 0", [(3, None, 1)]),
    ("PAUSE INX(3) = 2", [(3, None, 1)]),
    ("PAUSE INX(3) & 1", [(3, None, 1)]),
    ("PAUSE -INX(3)", [(3, None, 1)]),
    ("While 1\nPRINT INX(2)\nWend", [(2, None, 2)]),
    ("PAUSE INX(3) And Not INX(4) Or IDLE(0)", [(3, 1, 1), (4, 0, 1)]),
    ("PAUSE INX(3) And (IDLE(0) Or INX(4))", [(3, 1, 1), (4, 1, 1)]),
    ("PAUSE Not (INX(3) = 0 And POS(0) < 5)", [(3, 1, 1)]),
    ("While INX(2)\nJOG(0) = 5\nWend", [(2, 1, 1)]),
    ("While Not INX(2)\nJOG(0) = 5\nWend", [(2, 0, 1)]),
    ("Repeat\nJOG(0) = 5\nUntil INX(2) = 1", [(2, 1, 3)]),
    ("PAUSE INX.1\nEND\n#IN3\nRETURN", [(1, 1, 1), (3, None, 3)]),
    # A Define counts where it is used.
    ("DEFINE START = INX.5\nPAUSE START\nIF START THEN ? 1", [(5, 1, 2), (5, 1, 3)]),
    ("DEFINE READY = INX.5 = 0\n\nPAUSE READY\nx = READY", [(5, 0, 3), (5, None, 4)]),
    ("Const DOOR = 7\nPAUSE INX(DOOR)", [(7, 1, 2)]),
    ("Dim n\nn = 4\nPAUSE INX(n)", [(None, 1, 3)]),
    # A bank: the channels whose bits the program compares or masks, the first one if there are none.
    ("PAUSE IN(0)", [(0, 1, 1)]),
    ("PAUSE IN(0) = 1", [(0, 1, 1)]),
    ("PAUSE 0 = IN", [(0, 0, 1)]),
    ("PAUSE IN(0) <> 4", [(2, 0, 1)]),
    ("PAUSE IN(1) & 6", [(33, 1, 1), (34, 1, 1)]),
    ("PAUSE IN(0) & 6 = 4", [(1, 0, 1), (2, 1, 1)]),
    ("PAUSE Not (IN(0) & 6 = 6)", [(1, None, 1), (2, None, 1)]),
    ("PAUSE IN(0) > 2", [(1, None, 1)]),
    ("PAUSE IN(0) = 1\nPAUSE IN(0) = 2",
     [(0, 1, 1), (1, 0, 1), (0, 0, 2), (1, 1, 2)]),
    ("While IN(0) & 2 = 0\nWend", [(1, 0, 1)]),
    ("Dim b\nb = IN(0)\nIf b & 4 = 0 Then End", [(2, None, 2), (2, 0, 3)]),
    # Banks and inputs that do not exist.
    ("PAUSE INX(1000)", [(None, 1, 1)]),
    ("PAUSE IN(99)", [(None, None, 1)]),
    ("PRINT IN(0)", [(None, None, 1)]),
    ("Dim n\nn = 1\nPAUSE IN(n) = 1", [(None, None, 3)]),
    ("While INX(3)\nWAIT 1\nWend", [(3, 1, 1)]),
    ("While Not INX(3)\nWAIT 1\nWAIT 2\nWend", [(3, 0, 1)]),
    ("Repeat\nWAIT 1\nUntil INX(3)", [(3, 1, 3)]),
    ("If INX(3) Then PRINT 1", [(3, 1, 1)]),
    ("If INX(3) Then End", [(3, 1, 1)]),
    ("If Not INX(3) Then\nPRINT 1\nGoto a\nEnd If\n#a", [(3, 0, 1)]),
    ("If INX(3) Then\nEnd\nElse\nPRINT 1\nEnd If", [(3, 1, 1)]),
    ("If INX(3) Then GoSub a\nEnd\n#a\nReturn", [(3, 1, 1)]),
    ("PRINT INX(3)", [(3, None, 1)]),
    ("PRINT 1\nPRINT INX(4), INX(3)\nPAUSE INX(2)",
     [(3, None, 2), (4, None, 2), (2, 1, 3)]),
    # Handlers of inputs, with and without statements.
    ("End\nEvent IN5\n' comment\nPRINT 1\nEnd Event", [(5, None, 2)]),
    ("End\nEvent IN0\nEnd Event", [(0, None, 2)]),
    ("End\nEvent TIMER\nPRINT 1\nEnd Event", []),
]  # fmt: skip


@cases("text, expected", INPUTS)
def test_where_a_program_depends_on_inputs(
    text: str, expected: list[tuple[int | None, int | None, int]]
) -> None:
    found = MINT.program(Source("a.mnt", text)).reads
    assert found == expected
