"""The inputs of a program."""

from __future__ import annotations

from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT as MINT
from tests.cases import cases

# A program, and for each input or key its kind, number, the level that lets the program continue or makes a test true,
# its line, and the last line of a loop.
INPUTS: list[tuple[str, list[tuple[str, int | None, int | None, int, int]]]] = [
    ("PAUSE INX(3)", [("wait", 3, 1, 1, 1)]),
    ("PAUSE Not INX(3)", [("wait", 3, 0, 1, 1)]),
    ("PAUSE Not Not INX(3)", [("wait", 3, 1, 1, 1)]),
    ("PAUSE INX(3) = 0", [("wait", 3, 0, 1, 1)]),
    ("PAUSE 1 = INX(3)", [("wait", 3, 1, 1, 1)]),
    ("PAUSE INX(3) <> 1", [("wait", 3, 0, 1, 1)]),
    ("PAUSE INX(3) <> 0", [("wait", 3, 1, 1, 1)]),
    ("PAUSE Not (INX(3) = 1)", [("wait", 3, 0, 1, 1)]),
    ("PAUSE INX(3) = _ON", [("wait", 3, 1, 1, 1)]),
    ("PAUSE INX(3) = _OFF", [("wait", 3, 0, 1, 1)]),
    ("PAUSE INX(3) > 0", [("wait", 3, None, 1, 1)]),
    ("PAUSE INX(3) = 2", [("wait", 3, None, 1, 1)]),
    ("PAUSE INX(3) & 1", [("wait", 3, None, 1, 1)]),
    ("PAUSE -INX(3)", [("test", 3, None, 1, 1)]),
    ("While 1\nPRINT INX(2)\nWend", [("test", 2, None, 2, 2)]),
    ("PAUSE INX(3) And Not INX(4) Or IDLE(0)", [("either", 3, 1, 1, 1), ("either", 4, 0, 1, 1)]),
    ("PAUSE INX(3) And (IDLE(0) Or INX(4))", [("wait", 3, 1, 1, 1), ("wait", 4, 1, 1, 1)]),
    ("PAUSE Not (INX(3) = 0 And POS(0) < 5)", [("either", 3, 1, 1, 1)]),
    ("While INX(2)\nJOG(0) = 5\nWend", [("guard", 2, 1, 1, 2)]),
    ("While Not INX(2)\nJOG(0) = 5\nWend", [("work", 2, 1, 1, 2)]),
    ("Repeat\nJOG(0) = 5\nUntil INX(2) = 1", [("work", 2, 1, 3, 3)]),
    ("PAUSE INX.1\nEND\n#IN3\nRETURN", [("wait", 1, 1, 1, 1), ("event", 3, None, 3, 3)]),
    # A Define counts where it is used.
    ("DEFINE START = INX.5\nPAUSE START\nIF START THEN ? 1", [("wait", 5, 1, 2, 2), ("test", 5, 1, 3, 3)]),
    ("DEFINE READY = INX.5 = 0\n\nPAUSE READY\nx = READY", [("wait", 5, 0, 3, 3), ("test", 5, None, 4, 4)]),
    ("Const DOOR = 7\nPAUSE INX(DOOR)", [("wait", 7, 1, 2, 2)]),
    ("Dim n\nn = 4\nPAUSE INX(n)", [("wait", None, 1, 3, 3)]),
    # A bank: the channels whose bits the program compares or masks, the first one if there are none.
    ("PAUSE IN(0)", [("wait", 0, 1, 1, 1)]),
    ("PAUSE IN(0) = 1", [("wait", 0, 1, 1, 1)]),
    ("PAUSE 0 = IN", [("wait", 0, 0, 1, 1)]),
    ("PAUSE IN(0) <> 4", [("wait", 2, 0, 1, 1)]),
    ("PAUSE IN(1) & 6", [("wait", 33, 1, 1, 1), ("wait", 34, 1, 1, 1)]),
    ("PAUSE IN(0) & 6 = 4", [("wait", 1, 0, 1, 1), ("wait", 2, 1, 1, 1)]),
    ("PAUSE Not (IN(0) & 6 = 6)", [("wait", 1, None, 1, 1), ("wait", 2, None, 1, 1)]),
    ("PAUSE IN(0) > 2", [("wait", 1, None, 1, 1)]),
    ("PAUSE IN(0) = 1\nPAUSE IN(0) = 2",
     [("wait", 0, 1, 1, 1), ("wait", 1, 0, 1, 1), ("wait", 0, 0, 2, 2), ("wait", 1, 1, 2, 2)]),
    ("While IN(0) & 2 = 0\nWend", [("poll", 1, 1, 1, 1)]),
    ("Dim b\nb = IN(0)\nIf b & 4 = 0 Then End", [("test", 2, None, 2, 2), ("guard", 2, 1, 3, 3)]),
    # Banks and inputs that do not exist.
    ("PAUSE INX(1000)", [("wait", None, 1, 1, 1)]),
    ("PAUSE IN(99)", [("test", None, None, 1, 1)]),
    ("PRINT IN(0)", [("test", None, None, 1, 1)]),
    ("Dim n\nn = 1\nPAUSE IN(n) = 1", [("test", None, None, 3, 3)]),
    ("While INX(3)\nWAIT 1\nWend", [("poll", 3, 0, 1, 2)]),
    ("While Not INX(3)\nWAIT 1\nWAIT 2\nWend", [("poll", 3, 1, 1, 3)]),
    ("Repeat\nWAIT 1\nUntil INX(3)", [("poll", 3, 1, 3, 3)]),
    # An If that jumps away is a guard, unless it has an Else.
    ("If INX(3) Then PRINT 1", [("test", 3, 1, 1, 1)]),
    ("If INX(3) Then End", [("guard", 3, 0, 1, 1)]),
    ("If Not INX(3) Then\nPRINT 1\nGoto a\nEnd If\n#a", [("guard", 3, 1, 1, 1)]),
    ("If INX(3) Then\nEnd\nElse\nPRINT 1\nEnd If", [("test", 3, 1, 1, 1)]),
    ("If INX(3) Then GoSub a\nEnd\n#a\nReturn", [("test", 3, 1, 1, 1)]),
    ("PRINT INX(3)", [("test", 3, None, 1, 1)]),
    ("PRINT 1\nPRINT INX(4), INX(3)\nPAUSE INX(2)",
     [("test", 3, None, 2, 2), ("test", 4, None, 2, 2), ("wait", 2, 1, 3, 3)]),
    # Handlers of inputs, with and without statements.
    ("End\nEvent IN5\n' comment\nPRINT 1\nEnd Event", [("event", 5, None, 2, 4)]),
    ("End\nEvent IN0\nEnd Event", [("event", 0, None, 2, 2)]),
    ("End\nEvent TIMER\nPRINT 1\nEnd Event", []),
    # The choices of a menu; with one number alone, the answer is a value that is checked.
    ("Dim n\nINPUT n\nIf n = 1 Then PRINT 1\nIf 2 <> n Then PRINT 2\nIf n = 1 Then PRINT 3",
     [("answer", 1, None, 3, 2), ("answer", 2, None, 4, 2)]),
    ("Dim n\nINPUT n\nSelect Case n\nCase 1, 7\nPRINT 1\nCase 8 To 9\nEnd Select",
     [("answer", 1, None, 4, 2), ("answer", 7, None, 4, 2)]),
    ("Dim n\nINPUT n\nIf n = 0 Then End", []),
    # Keys from the space to the tilde.
    ("If INKEY = 65 Then PRINT 1", [("key", 65, None, 1, 1)]),
    ("If READKEY <> 66 Then PRINT 1", [("key", 66, None, 1, 1)]),
    ("Dim k\nk = INKEY\nIf k = 32 Then PRINT 1\nIf 126 <> k Then PRINT 2",
     [("key", 32, None, 3, 3), ("key", 126, None, 4, 4)]),
    ("Dim k\nk = INKEY\nIf k = 31 Then PRINT 1\nIf k = 127 Then PRINT 2\nIf k > 65 Then PRINT 3", []),
    ("Dim k\nk = 5\nIf k = 65 Then PRINT 1", []),
]  # fmt: skip


@cases("text, expected", INPUTS)
def test_where_a_program_depends_on_inputs(
    text: str, expected: list[tuple[str, int | None, int | None, int, int]]
) -> None:
    found = MINT.program(Source("a.mnt", text)).reads
    assert [(each.kind, each.channel, each.level, each.line, each.last) for each in found] == expected
