"""Conditions that never change or are always true, one small program for each.

The axis of `MOVEA(0) = 100` moves between 0 and 100. A twentieth of that distance more is no certain error, as a motor
overshoots.
"""

from __future__ import annotations

import pytest

from motionlang.mint import DIALECT
from motionlang.source import Source

# Warnings about other things in these programs.
OTHERS = {"no-value", "unused-variable", "busy-loop"}
# A program, and the lines and codes of its warnings.
PROGRAMS: list[tuple[str, list[tuple[int, str]]]] = [
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) = 105", [(2, "exact-position")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) = 106", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) = -5", [(2, "exact-position")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) = -6", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) > 105", []),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) > 106", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) >= 106", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) < -5", []),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) < -6", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) <= -6", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) <> 200", [(2, "exact-position")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) < 200", []),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) > 50", []),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) > -200", []),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE 106 < POS(0)", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE 106 > POS(0)", []),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE -6 >= POS(0)", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE Not (POS(0) < 106)", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE Not (POS(0) > 106)", []),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE Not (POS(0) >= -6)", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) > 106 And INX(1)", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) > 106 Or INX(1)", []),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) > 106 Or POS(0) < -6", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE Not (POS(0) < 106 Or INX(1))", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE Not (POS(0) < 106 And INX(1))", []),
    ("MOVEA(0) = 100 : GO(0)\nWhile POS(0) < 106 : End While", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nWhile POS(0) > 106 : End While", []),
    ("MOVEA(0) = 100 : GO(0)\nRepeat\nUntil POS(0) > 106", [(3, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nRepeat\nUntil POS(0) < 106", []),
    ("MOVEA(0) = 100 : GO(0)\nWhile POS(0) < 106\n  MOVER(0) = 1 : GO(0)\nEnd While", []),
    ("MOVEA(0) = 100 : GO(0)\nWhile POS(0) < 106\n  If INX(1) Then Exit While\nEnd While", []),
    ("MOVEA(0) = -100 : GO(0)\nPAUSE POS(0) > 6", [(2, "endless-wait")]),
    ("MOVEA(0) = -100 : GO(0)\nPAUSE POS(0) < -106", [(2, "endless-wait")]),
    ("MOVEA(0) = 0 : GO(0)\nPAUSE POS(0) > 6", []),
    ("MOVEA(1) = 100 : GO(1)\nPAUSE POS(0) > 106", [(2, "endless-wait")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(1) > 106", [(2, "endless-wait")]),
    ("JOG(0) = 5\nPAUSE IDLE(0)", [(2, "endless-wait")]),
    ("JOG(0) = 5\nPAUSE Not IDLE(0)", []),
    ("JOG(0) = 5\nPAUSE IDLE(0) = 1", [(2, "endless-wait")]),
    ("JOG(0) = 5\nPAUSE IDLE(0) = 0", []),
    ("JOG(0) = 5\nPAUSE IDLE(0) <> 0", [(2, "endless-wait")]),
    ("JOG(0) = 5\nPAUSE IDLE(0) <> 1", []),
    ("JOG(0) = 5\nPAUSE IDLE(0) Or INX(1)", []),
    ("JOG(0) = 5\nPAUSE IDLE(0) And INX(1)", [(2, "endless-wait")]),
    ("JOG(0) = 5\nWhile Not IDLE(0) : End While", [(2, "endless-wait")]),
    ("JOG(0) = 5\nWhile IDLE(0) : End While", []),
    ("JOG(0) = 5\nRepeat\nUntil IDLE(0)", [(3, "endless-wait")]),
    ("JOG(0) = 5\nPAUSE IDLE(1)", []),
    ("JOG(0) = 5\nSOFTLIMITFORWARD(0) = 90\nPAUSE IDLE(0)", []),
    ("JOG(0) = 5\nSOFTLIMITFORWARD(1) = 90\nPAUSE IDLE(0)", [(3, "endless-wait")]),
    ("JOG(0) = 5\nPAUSE IDLE(0)\nEnd\nEvent IN1\n  STOP(0)\nEnd Event", []),
    ("JOG(0) = 5\nPAUSE IDLE(0)\nEnd\nEvent IN1\n  STOP(1)\nEnd Event", [(2, "endless-wait")]),
    ("JOG(0) = 5\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)", []),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) = 100", [(2, "exact-position")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) = 50", [(2, "exact-position")]),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE POS(0) <> 50", [(2, "exact-position")]),
    ("MOVEA(0) = 100 : GO(0)\nIf POS(0) = 50 Then PRINT 1", [(2, "exact-position"), (2, "in-motion")]),
    ("MOVEA(0) = 100 : GO(0)\nIf POS(0) <> 50 Then PRINT 1", [(2, "exact-position"), (2, "in-motion")]),
    ("MOVEA(0) = 100 : GO(0)\nIf 50 = POS(0) Then PRINT 1", [(2, "exact-position"), (2, "in-motion")]),
    ("MOVEA(0) = 100 : GO(0)\nIf POSDEMAND(0) = 50 Then PRINT 1", [(2, "exact-position")]),
    ("MOVEA(0) = 100 : GO(0)\nIf VEL(0) = 50 Then PRINT 1", []),
    ("MOVEA(0) = 100 : GO(0)\nPAUSE IDLE(0)\nIf POS(0) = 50 Then PRINT 1", []),
    ("MOVEA(0) = 100\nIf POS(0) = 50 Then PRINT 1\nGO(0)", []),
    ("JOG(0) = 5\nPAUSE POS(0) = 50", [(2, "exact-position")]),
    ("JOG(0) = 5\nWhile POS(0) <> 50 : End While", [(2, "exact-position")]),
    ("WAIT = 5 > 3", [(1, "wait-condition")]),
    ("WAIT = INX(1)", [(1, "wait-condition")]),
    ("WAIT = IN(1)", []),
    ("PAUSE 100", [(1, "wait-condition")]),
    ("PAUSE(2)", [(1, "wait-condition")]),
    ("PAUSE 1", []),
    ("WAIT = INX(1) Or INX(2)", [(1, "wait-condition")]),
    ("WAIT = TIME", []),
    ("WAIT(Not INX(1))", [(1, "wait-condition")]),
    ("WAIT INX(1)", [(1, "wait-condition")]),
    ("End\nPRINT 1\nPRINT 2", [(2, "unreachable")]),
    ("Goto over\nPRINT 1\nover:\nPRINT 2", [(2, "unreachable")]),
    ("PRINT 1\nEnd\nEnd", []),
    ("Loop\n  PRINT 1\nEnd Loop\nPRINT 2", [(4, "unreachable")]),
    ("Loop\n  If INX(1) Then Exit Loop\nEnd Loop\nPRINT 2", []),
    ("If INX(1) Then\n  End\nElse\n  End\nEnd If\nPRINT 2", [(6, "unreachable")]),
    ("If INX(1) Then\n  End\nEnd If\nPRINT 2", []),
    ("lonely:\nPRINT 1", [(1, "unused-label")]),
    ("used:\nIf INX(1) Then Goto used", []),
    ("Dim n As Integer\nn = INX(9)\nIf 1 = 1 Then PRINT n", [(3, "constant-condition")]),
    ("Dim n As Integer\nn = INX(9)\nIf 1 > 2 Then PRINT n", [(3, "constant-condition")]),
    ("Dim n As Integer\nn = INX(9)\nIf n = 1 Or 2 Then PRINT n", [(3, "constant-condition")]),
    ("Dim n As Integer\nn = INX(9)\nIf n = 1 Or 0 Then PRINT n", [(3, "constant-condition")]),
    ("Dim n As Integer\nn = INX(9)\nIf n = 1 And 2 Then PRINT n", [(3, "constant-condition")]),
    ("Dim n As Integer\nn = INX(9)\nIf n = 1 And 0 Then PRINT n", [(3, "constant-condition")]),
    ("Dim n As Integer\nn = INX(9)\nIf Not (1 = 2) Then PRINT n", [(3, "constant-condition")]),
    ("Dim n As Integer\nn = INX(9)\nPAUSE n > 1", [(3, "endless-wait")]),
    ("Dim n As Integer\nn = INX(9)\nPAUSE n > 1\nEnd\nEvent IN1\n  n = 2\nEnd Event", []),
    ("Dim n As Integer\nn = INX(9)\nPAUSE INX(1)", []),
    ("Dim n As Integer\nn = INX(9)\nPAUSE TIME > 5", []),
    ("PAUSE IDLE(0)", []),
    ("PAUSE POS(0) > 5", [(1, "endless-wait")]),
    ("PAUSE VEL(0) > 5 Or INX(1)", []),
    ("MOVER(1) = 5 : GO(1)\nPAUSE VEL(0) > 5", [(2, "endless-wait")]),
    ("Dim n As Integer\nn = INX(9)\nWhile n < 3 : End While", [(3, "endless-loop")]),
    ("Dim n As Integer\nn = INX(9)\nWhile n < 3\n  n = n + 1\nEnd While", []),
    ("Dim n As Integer\nn = INX(9)\nWhile n < 3\n  If INX(1) Then Exit While\nEnd While", []),
    ("Dim n As Integer\nn = INX(9)\nRepeat\nUntil n > 3", [(3, "endless-loop")]),
    ("Dim n As Integer\nn = INX(9)\nWhile n < 3 And INX(1) : End While", []),
    ("Dim n As Integer\nn = INX(9)\nWhile n < 3 : End While\nEnd\nEvent IN1\n  n = 5\nEnd Event", []),
    (
        "Dim n As Integer\nn = INX(9)\nWhile n < 3\n  more()\nEnd While\nEnd\nSub more()\n  PRINT 1\nEnd Sub",
        [(3, "endless-loop")],
    ),
    (
        "Dim n As Integer\nn = INX(9)\nWhile n < 3\n  more()\nEnd While\nEnd\nSub more()\n  n = n + 1\nEnd Sub",
        [],
    ),
]
# With a machine file that drives input 1 alone.
DRIVEN = {
    "PAUSE INX(1)": [],
    "PAUSE INX(2)": [(1, "endless-wait")],
    "PAUSE INX(1) Or INX(2)": [],
    "While INX(2) : End While": [(1, "endless-wait")],
    "While INX(1) : End While": [],
    "Repeat\nUntil INX(2)": [(2, "endless-wait")],
    "Dim n As Integer\nFor n = 1 To 2\n  PAUSE INX(n)\nNext": [],
}


def warnings(text: str, machine: dict[str, object]) -> list[tuple[int, str]]:
    found = DIALECT.check(Source("a.mnt", text), machine)
    return [(each.line, each.code) for each in found if each.code not in OTHERS]


@pytest.mark.parametrize(("text", "expected"), PROGRAMS, ids=lambda each: str(each)[:60])
def test_warnings_about_a_condition(text: str, expected: list[tuple[int, str]]) -> None:
    assert warnings(text, {}) == expected


@pytest.mark.parametrize("text", DRIVEN)
def test_warnings_about_an_input(text: str) -> None:
    assert warnings(text, {"input": [{"channel": 1, "at": 0.5}]}) == DRIVEN[text]
