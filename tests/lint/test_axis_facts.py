"""Facts about axes that the checks of motion know, one small program for each.

A fact that is certain on only one of two paths is not known. In some programs a line is wrong only because
of another one.
"""

from __future__ import annotations

import pytest

from motionlang.mint import DIALECT
from motionlang.source import Source

# The warnings that these facts give.
CODES = {
    "in-motion", "nothing-loaded", "never-started", "zero-speed", "zero-acceleration", "scale-after-speed",
    "scale-in-motion", "time-before-speed", "beyond-travel", "buffer-overfilled",
}  # fmt: skip
# A program, and the lines and codes of its warnings.
PROGRAMS: list[tuple[str, list[tuple[int, str]]]] = [
    ("MOVER(0) = 10 : GO(0)\nPRINT POS(0)", [(2, "in-motion")]),
    ("MOVER(0) = 10 : GO(0)\nWAIT 5\nPRINT POS(0)", []),
    ("MOVER(0) = 10 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)", []),
    ("MOVER(0) = 10 : GO(0)\nPAUSE POS(0) > 5\nPRINT POS(0)", []),
    ("MOVER(0) = 10 : GO(0)\nWhile POS(0) < 5 : WAIT 1 : End While\nPRINT POS(0)", []),
    ("MOVER(0) = 10 : GO(0)\nPOS(0) = 0", [(2, "in-motion")]),
    ("MOVER(0) = 10 : GO(0)\nPRINT POS(1)", []),
    ("MOVER(0) = 10 : GO(0)\nSTOP(0)\nPRINT POS(0)", []),
    ("MOVER(0) = 10 : GO(0)\nshow()\nPRINT POS(0)\nEnd\nSub show()\n PRINT 1\nEnd Sub", []),
    ("MOVER(0) = 10\nIf INX(1) Then\n GO(0)\nEnd If\nPRINT POS(0)", []),
    ("MOVER(0) = 10\nIf INX(1) Then\n GO(0)\nElse\n GO(0)\nEnd If\nPRINT POS(0)", [(7, "in-motion")]),
    ("MOVER(0) = 10 : GO(0)\nJOG(0) = 5\nPRINT POS(0)", []),
    ("GO(0)", [(1, "nothing-loaded")]),
    ("MOVER(0) = 10 : GO(0)\nGO(0)", [(2, "nothing-loaded")]),
    ("MOVER(0) = 10 : GO(0, 1)", []),
    ("MOVER(1) = 10 : GO(0, 1)", []),
    ("GO(0, 1)", [(1, "nothing-loaded")]),
    ("MOVER(0) = 10 : STOP(0) : GO(0)", [(1, "never-started"), (1, "nothing-loaded")]),
    ("VECTORR(0, 1) = 3, 4 : GO(0)", []),
    ("VECTORR(0, 1) = 3, 4 : GO(1)", []),
    ("SPEED(0) = 0 : MOVER(0) = 10 : GO(0)", [(1, "zero-speed")]),
    ("ACCEL(0) = 0 : MOVER(0) = 10 : GO(0)", [(1, "zero-acceleration")]),
    ("DECEL(0) = 0 : MOVER(0) = 10 : GO(0)", [(1, "zero-acceleration")]),
    ("SPEED(0) = 0 : SPEED(0) = 5 : MOVER(0) = 10 : GO(0)", []),
    ("MOVER(0) = 10 : SPEED(0) = 0 : GO(0)", [(1, "zero-speed")]),
    ("MOVER(0) = 10 : SPEED(0) = 0 : GO(0) : SPEED(0) = 5", [(1, "zero-speed")]),
    ("MOVER(0) = 10 : GO(0) : SPEED(0) = 0 : MOVER(0) = 10 : GO(0)", []),
    ("SPEED(0) = 0 : ACCEL(0) = 0 : MOVER(0) = 10 : GO(0)", [(1, "zero-speed")]),
    ("SPEED(1) = 0 : MOVER(0) = 10 : GO(0)", []),
    ("SPEED(0) = 50\nSCALEFACTOR(0) = 1000\nMOVER(0) = 10 : GO(0)", [(2, "scale-after-speed")]),
    ("SPEED(0) = 50\nSCALEFACTOR(0) = 1000\nSPEED(0) = 50\nMOVER(0) = 10 : GO(0)", []),
    (
        "SPEED(0) = 50 : ACCEL(0) = 50\nSCALEFACTOR(0) = 1000\nSPEED(0) = 50\nMOVER(0) = 10 : GO(0)",
        [(2, "scale-after-speed")],
    ),
    ("SPEED(0) = 50\nSCALEFACTOR(0) = 1000\nMOVER(0) = 10\nMOVER(0) = 5 : GO(0)", [(2, "scale-after-speed")]),
    ("SPEED(0) = 50\nSCALEFACTOR(1) = 1000\nMOVER(0) = 10 : GO(0)", []),
    ("ACCELTIME(0) = 50\nSCALEFACTOR(0) = 1000\nMOVER(0) = 10 : GO(0)", []),
    ("JOG(0) = 5\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("JOG(0) = 0\nSCALEFACTOR(0) = 10", []),
    ("JOG(0) = 5\nSTOP(0)\nSCALEFACTOR(0) = 10", []),
    ("JOG(0) = 5\nCANCEL(0)\nSCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0)\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("MOVER(0) = 10\nSCALEFACTOR(0) = 10\nGO(0)", []),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0)\nSCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0) : PAUSE Not IDLE(0)\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) = 1\nSCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) <> 0\nSCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) = 0\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    # Every comparison that is true at one of 0 and 1 alone.
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) > 0\nSCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0) : PAUSE 1 <= IDLE(0)\nSCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0) : PAUSE 0 <> IDLE(0)\nSCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0) : PAUSE Not IDLE(0) < 1\nSCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) < 1\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("MOVER(0) = 10 : GO(0) : PAUSE 1 > IDLE(0)\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) >= 0\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) <> 5\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) = 2\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) <> 1\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) And INX(1)\nSCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0) : PAUSE INX(1) And IDLE(0)\nSCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0) : PAUSE IDLE(0) Or INX(1)\nSCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("MOVER(0) = 10 : GO(0)\nIf IDLE(0) Then SCALEFACTOR(0) = 10", []),
    ("MOVER(0) = 10 : GO(0)\nIf Not IDLE(0) Then SCALEFACTOR(0) = 10", [(2, "scale-in-motion")]),
    ("If Not IDLE(0) Then\n  SCALEFACTOR(0) = 10\nEnd If", [(2, "scale-in-motion")]),
    (
        "MOVER(0) = 10 : GO(0)\nIf IDLE(0) Or INX(1) Then\n  PRINT 1\nElse\n  SCALEFACTOR(0) = 10\nEnd If",
        [(5, "scale-in-motion")],
    ),
    ("ACCELTIME(0) = 50\nSPEED(0) = 5", [(1, "time-before-speed")]),
    ("DECELTIME(0) = 50\nACCELTIME(0) = 50\nSPEED(0) = 5\nSPEED(0) = 6", [(1, "time-before-speed")]),
    ("SPEED(0) = 5\nACCELTIME(0) = 50\nSPEED(0) = 6", []),
    ("ACCELTIME(0) = 50\nSPEED(1) = 5", []),
    ("ACCELTIME(0) = 50\nACCEL(0) = 5\nSPEED(0) = 5", [(1, "time-before-speed")]),
]
# The same with an axis that can travel from -20 to 100.
TRAVELS: list[tuple[str, list[tuple[int, str]]]] = [
    ("MOVEA(0) = 100 : GO(0)", []),
    ("MOVEA(0) = 100.5 : GO(0)", [(1, "beyond-travel")]),
    ("MOVEA(0) = -20 : GO(0)", []),
    ("MOVEA(0) = -20.5 : GO(0)", [(1, "beyond-travel")]),
    ("MOVER(0) = 101 : GO(0)", [(1, "beyond-travel")]),
    ("MOVEA(0) = 60 : GO(0) : PAUSE IDLE(0)\nMOVER(0) = 50 : GO(0)", [(2, "beyond-travel")]),
    ("MOVEA(0) = 60 : MOVER(0) = 50 : GO(0)", [(1, "beyond-travel")]),
    ("MOVEA(0) = 60 : GO(0)\nSTOP(0)\nMOVER(0) = 50 : GO(0)", []),
    ("MOVEA(0) = 60 : GO(0) : PAUSE IDLE(0)\nSTOP(0)\nMOVER(0) = 50 : GO(0)", [(3, "beyond-travel")]),
    ("MOVEA(0) = 60\nSTOP(0)\nMOVER(0) = 50 : GO(0)", [(1, "never-started")]),
    ("MOVEA(0) = 60 : GO(0) : PAUSE IDLE(0)\nPOS(0) = 0\nMOVEA(0) = 50 : GO(0)", [(3, "beyond-travel")]),
    ("MOVEA(0) = 60 : GO(0) : PAUSE IDLE(0)\nPOS(0) = 0\nMOVEA(0) = 40 : GO(0)", []),
    ("MOVEA(0) = 60 : GO(0) : PAUSE IDLE(0)\nPOS(0) = 60\nMOVER(0) = 50 : GO(0)", [(3, "beyond-travel")]),
    ("MOVEA(0) = 60 : GO(0)\nWAIT 9\nPOS(0) = 0\nMOVEA(0) = 50 : GO(0)", []),
    ("JOG(0) = 5\nWAIT 100 : STOP(0) : PAUSE IDLE(0)\nMOVER(0) = 101 : GO(0)", []),
    ("JOG(0) = 5\nWAIT 100 : STOP(0) : PAUSE IDLE(0)\nMOVEA(0) = 101 : GO(0)", [(3, "beyond-travel")]),
    ("VECTORA(0, 1) = 101, 0 : GO(0)", [(1, "beyond-travel")]),
    ("VECTORA(1, 0) = 0, 101 : GO(1)", [(1, "beyond-travel")]),
    ("VECTORR(0, 1) = 60, 0 : VECTORR(0, 1) = 60, 0 : GO(0)", [(1, "beyond-travel")]),
    ("VECTORR(0, 1) = 60, 0 : VECTORR(0, 1) = -60, 0 : GO(0)", []),
    ("CIRCLER(0, 1) = 60, 0, 180 : MOVER(0) = 50 : GO(0)", []),
    ("SCALEFACTOR(0) = 2\nMOVEA(0) = 60 : GO(0)", []),
    ("MOVEA(0) = 60 : GO(0) : PAUSE IDLE(0)\nSCALEFACTOR(0) = 2\nMOVER(0) = 30 : GO(0)", []),
    ("SCALEFACTOR(0) = 2\nMOVER(0) = 60 : GO(0)", []),
    ("Dim n As Integer\nFor n = 1 To 3\n  MOVER(0) = 50 : GO(0) : PAUSE IDLE(0)\nNext", []),
    (
        "If INX(1) Then\n  MOVEA(0) = 60\nElse\n  MOVEA(0) = 70\nEnd If\nGO(0) : PAUSE IDLE(0)\nMOVER(0) = 50 : GO(0)",
        [],
    ),
    (
        "If INX(1) Then\n  MOVEA(0) = 60\nElse\n  MOVEA(0) = 60\nEnd If\nGO(0) : PAUSE IDLE(0)\nMOVER(0) = 50 : GO(0)",
        [(7, "beyond-travel")],
    ),
    ("away()\nMOVER(0) = 50 : GO(0)\nEnd\nSub away()\n  MOVEA(0) = 60 : GO(0) : PAUSE IDLE(0)\nEnd Sub", []),
    (
        "MOVEA(0) = 60 : GO(0) : PAUSE IDLE(0)\nMOVER(0) = 50 : GO(0)\nEnd\nEvent IN1\n  STOP(0)\nEnd Event",
        [],
    ),
    (
        "MOVEA(0) = 60 : GO(0) : PAUSE IDLE(0)\nMOVER(0) = 50 : GO(0)\nEnd\nEvent IN1\n  STOP(1)\nEnd Event",
        [(2, "beyond-travel")],
    ),
    ("HOME(0) = 0 : PAUSE IDLE(0)\nMOVER(0) = 101 : GO(0)", []),
    ("RESET(0)\nMOVER(0) = 101 : GO(0)", []),
]
LOAD_THREE = (
    "fill(0)\nSub fill(ByVal a As Integer)\n  MOVER(a) = 1\n  MOVER(a) = 1\n  MOVER(a) = 1\n  GO(a)\nEnd Sub"
)
# Moves that wait in the buffer, which has 2 entries, and settings that no move uses.
WAITING: list[tuple[str, list[tuple[int, str]]]] = [
    ("MOVER(0) = 1\nMOVER(0) = 1\nMOVER(0) = 1\nGO(0)", [(3, "buffer-overfilled")]),
    ("MOVER(0) = 1\nMOVER(0) = 1\nGO(0)", []),
    ("MOVEBUFFERSIZE(0) = 3\nMOVER(0) = 1\nMOVER(0) = 1\nMOVER(0) = 1\nGO(0)", []),
    (
        "MOVEBUFFERSIZE(0) = 3\nMOVER(0) = 1\nMOVER(0) = 1\nMOVER(0) = 1\nMOVER(0) = 1\nGO(0)",
        [(5, "buffer-overfilled")],
    ),
    ("MOVEBUFFERSIZE(1) = 3\nMOVER(0) = 1\nMOVER(0) = 1\nMOVER(0) = 1\nGO(0)", [(4, "buffer-overfilled")]),
    ("MOVER(0) = 1\nMOVER(0) = 1\nGO(0)\nMOVER(0) = 1\nGO(0)", []),
    ("TRIGGERMODE(0) = _trAUTO\nMOVER(0) = 1\nMOVER(0) = 1\nMOVER(0) = 1", []),
    ("TRIGGERMODE(1) = _trAUTO\nMOVER(0) = 1\nMOVER(0) = 1\nMOVER(0) = 1\nGO(0)", [(4, "buffer-overfilled")]),
    ("Dim n As Integer\nFor n = 1 To 3\n  MOVER(0) = n\nNext\nGO(0)", [(3, "buffer-overfilled")]),
    ("Dim n As Integer\nFor n = 1 To 2\n  MOVER(0) = n\nNext\nGO(0)", []),
    ("Dim n As Integer\nFor n = 3 To 1 Step -1\n  MOVER(0) = n\nNext\nGO(0)", [(3, "buffer-overfilled")]),
    ("Dim n As Integer\nFor n = 2 To 1 Step -1\n  MOVER(0) = n\nNext\nGO(0)", []),
    ("Dim n As Integer\nFor n = 1 To 6 Step 2\n  MOVER(0) = n\nNext\nGO(0)", [(3, "buffer-overfilled")]),
    ("Dim n As Integer\nFor n = 1 To 4 Step 2\n  MOVER(0) = n\nNext\nGO(0)", []),
    (
        "Dim n As Integer\nMOVER(0) = 1\nFor n = 1 To 2\n  MOVER(0) = n\nNext\nGO(0)",
        [(4, "buffer-overfilled")],
    ),
    ("Dim n As Integer\nFor n = 1 To 3\n  MOVER(0) = n\n  GO(0)\nNext", []),
    ("Dim n As Integer\nFor n = 1 To 3\n  MOVER(0) = n\n  If INX(1) Then Exit For\nNext\nGO(0)", []),
    ("Dim n As Integer\nFor n = 1 To 3\n  If INX(1) Then MOVER(0) = n\nNext\nGO(0)", []),
    ("Dim n As Integer\nFor n = 1 To 3\n  MOVER(0) = n : n = 3\nNext\nGO(0)", []),
    ("Dim n As Integer\nFor n = 1 To INX(1)\n  MOVER(0) = n\nNext\nGO(0)", []),
    (
        "Dim n As Integer\nFor n = 1 To 2\n  MOVER(0) = n : MOVER(0) = 1\nNext\nGO(0)",
        [(3, "buffer-overfilled")],
    ),
    ("Dim n As Integer\nFor n = 1 To 3\n  MOVER(0) = n\n  STOP(0)\nNext", [(3, "never-started")]),
    ("Dim n As Integer\nJOG(0) = 5\nFor n = 1 To 3\n  MOVER(0) = n\nNext\nGO(0)", []),
    ("VECTORR(0, 1) = 3, 4\nVECTORR(0, 1) = 3, 4\nVECTORR(0, 1) = 3, 4\nGO(0)", [(3, "buffer-overfilled")]),
    ("VECTORR(0, 1) = 3, 4\nMOVER(1) = 1\nMOVER(1) = 1\nGO(0, 1)", []),
    ("MOVER(1) = 1\nMOVER(1) = 1\nVECTORR(0, 1) = 3, 4\nGO(0, 1)", []),
    ("MOVER(1) = 1\nMOVER(1) = 1\nMOVER(0, 1) = 1, 1\nGO(0, 1)", [(3, "buffer-overfilled")]),
    ("n = 3\nMOVEBUFFERSIZE(0) = n\nMOVER(0) = 1\nMOVER(0) = 1\nMOVER(0) = 1\nGO(0)", []),
    ("n = 0\nMOVEBUFFERSIZE(n) = 3\nMOVER(0) = 1\nMOVER(0) = 1\nMOVER(0) = 1\nGO(0)", []),
    (LOAD_THREE, [(5, "buffer-overfilled")]),
    ("MOVEBUFFERSIZE(0) = 3\n" + LOAD_THREE, []),
    (
        "Dim n As Integer\nMOVER(0) = 1\nFor n = 1 To 2\n  MOVER(0) = n\n  MOVER(0) = 1\nNext\nGO(0)",
        [(5, "buffer-overfilled")],
    ),
    ("MOVER(0) = 1\nSTOP(1)\nGO(0)", []),
    ("MOVER(0) = 1\nMOVER(1) = 1\nSTOP(1)\nGO(0, 1)", [(2, "never-started")]),
    ("n = 0\nMOVER(0) = 1\nGO(n)", []),
    ("MOVER(0) = 1", [(1, "never-started")]),
    ("MOVER(0) = 1\nGO(1)", [(1, "never-started"), (2, "nothing-loaded")]),
    ("MOVER(0, 1) = 1, 2\nGO(0)", []),
    ("MOVER(0, 1) = 1, 2\nGO(0, 1)", []),
    ("MOVER(0) = 1\nIf INX(1) Then GO(0)", []),
    ("MOVER(0) = 1\nSTOP(0)\nGO(0)", [(1, "never-started"), (3, "nothing-loaded")]),
    ("MOVER(0) = 1\nEnd\nEvent IN1\n  GO(0)\nEnd Event", []),
    ("MOVER(0) = 1\nEnd\nEvent IN1\n  GO(1)\nEnd Event", [(1, "never-started")]),
    ("MOVER(0) = 1\nstart()\nEnd\nSub start()\n  GO(0)\nEnd Sub", []),
    ("MOVER(0) = 1\nstart()\nEnd\nSub start()\n  GO(1)\nEnd Sub", [(1, "never-started")]),
    ("MOVER(0) = 1\nstart(0)\nEnd\nSub start(ByVal a As Integer)\n  GO(a)\nEnd Sub", []),
    ("load()\nGO(0)\nEnd\nSub load()\n  MOVER(0) = 1\nEnd Sub", []),
    (
        "load()\nGO(1)\nEnd\nSub load()\n  MOVER(0) = 1\nEnd Sub",
        [(2, "nothing-loaded"), (5, "never-started")],
    ),
    ("VECTORR(0, 1) = 3, 4\nGO(1)", []),
    ("CAM(0) = 1", [(1, "never-started")]),
    ("SPEED(0) = 5\nSPEED(0) = 6\nMOVER(0) = 1 : GO(0)", [(1, "unused-setting")]),
    ("SPEED(0) = 5\nSCALEFACTOR(0) = 2\nSPEED(0) = 6\nMOVER(0) = 1 : GO(0)", [(1, "unused-setting")]),
    ("SPEED(0) = 5\nWAIT 5\nSPEED(0) = 6\nMOVER(0) = 1 : GO(0)", []),
    ("SPEED(0) = 5\nPAUSE INX(1)\nSPEED(0) = 6\nMOVER(0) = 1 : GO(0)", []),
    ("SPEED(0) = 5\nPRINT SPEED(0)\nSPEED(0) = 6\nMOVER(0) = 1 : GO(0)", []),
    ("SPEED(0) = 5\nPRINT SPEED(1)\nSPEED(0) = 6\nMOVER(0) = 1 : GO(0)", [(1, "unused-setting")]),
    ("SPEED(0) = 5\nSPEED(1) = 6\nMOVER(0, 1) = 1, 1 : GO(0, 1)", []),
    ("SPEED(0, 1) = 5;\nSPEED(1) = 6\nMOVER(0, 1) = 1, 1 : GO(0, 1)", []),
    ("SPEED(0, 1) = 5;\nSPEED(0, 1) = 6;\nMOVER(0, 1) = 1, 1 : GO(0, 1)", [(1, "unused-setting")]),
    ("SPEED(0) = 5\nACCEL(0) = 6\nMOVER(0) = 1 : GO(0)", []),
    ("SPEED(0) = 5\nIf INX(1) Then SPEED(0) = 6\nMOVER(0) = 1 : GO(0)", []),
    (
        "SPEED(0) = 5\nIf INX(1) Then\n  SPEED(0) = 6\nElse\n  SPEED(0) = 7\nEnd If\nMOVER(0) = 1 : GO(0)",
        [(1, "unused-setting")],
    ),
    ("MOVER(0) = 1 : GO(0) : PAUSE IDLE(0)\nSPEED(0) = 5", [(2, "unused-setting")]),
    ("MOVER(0) = 1 : GO(0)\nSPEED(0) = 5", []),
    (
        "MOVER(0) = 1 : GO(0) : PAUSE IDLE(0)\nSPEED(0) = 5\nEnd\nEvent IN1\n  MOVER(0) = 1 : GO(0)\nEnd Event",
        [],
    ),
    (
        "MOVER(0) = 1 : GO(0) : PAUSE IDLE(0)\nSPEED(0) = 5\nEnd\nEvent IN1\n  MOVER(1) = 1 : GO(1)\nEnd Event",
        [(2, "unused-setting")],
    ),
    (
        "SPEED(0) = 5\nmove()\nSPEED(0) = 6\nmove()\nEnd\nSub move()\n  MOVER(0) = 1 : GO(0) : PAUSE IDLE(0)\nEnd Sub",
        [],
    ),
    (
        "Sub fast()\n  SPEED(0) = 5\n  SPEED(0) = 6\nEnd Sub\nfast()\nMOVER(0) = 1 : GO(0)",
        [(2, "unused-setting")],
    ),
    ("Dim a As Integer = 0\nSPEED(a) = 5\nSPEED(a) = 6\nMOVER(0) = 1 : GO(0)", []),
    ("SPEED(0) = 5\nACCEL(0) = 5 : ACCELTIME(0) = 5\nMOVER(0) = 1 : GO(0)", [(2, "unused-setting")]),
    (
        "Dim n As Integer\nSPEED(0) = 5\nFor n = 1 To 2\n  SPEED(0) = 6 : MOVER(0) = 1 : GO(0) : PAUSE IDLE(0)\nNext",
        [(2, "unused-setting")],
    ),
]


def warnings(text: str, machine: dict[str, object]) -> list[tuple[int, str]]:
    found = DIALECT.check(Source("a.mnt", text), machine)
    return [(each.line, each.code) for each in found if each.code in CODES]


@pytest.mark.parametrize(("text", "expected"), PROGRAMS, ids=lambda each: str(each)[:50])
def test_warnings_about_an_axis(text: str, expected: list[tuple[int, str]]) -> None:
    assert warnings(text, {}) == expected


@pytest.mark.parametrize(("text", "expected"), TRAVELS, ids=lambda each: str(each)[:50])
def test_warnings_about_its_travel(text: str, expected: list[tuple[int, str]]) -> None:
    assert warnings(text, {"axis.0.travel": [-20.0, 100.0]}) == expected


@pytest.mark.parametrize(("text", "expected"), WAITING, ids=lambda each: str(each)[:50])
def test_warnings_about_what_waits_for_a_move(text: str, expected: list[tuple[int, str]]) -> None:
    found = DIALECT.check(Source("a.mnt", text), {})
    assert [(each.line, each.code) for each in found] == expected


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("PRINT 1", [(6, "two-tasks")]),
        ("PAUSE TASKSTATUS(Press) = 0", []),
        ("TASKSUSPEND(Press)", []),
        ("TASKRESUME(Press)", []),
        ("End Press", []),
    ],
)
def test_tasks_that_take_turns_may_command_one_axis(line: str, expected: list[tuple[int, str]]) -> None:
    task = "Task Press\nMOVER(0) = 5 : GO(0)\nEnd Task\n"
    found = DIALECT.check(Source("a.mnt", f"Run Press\n{line}\nMOVER(0) = 3 : GO(0)\nEnd\n{task}"), {})
    assert [(each.line, each.code) for each in found] == expected
