"""Loops that only compute or replace a motion, short paths, and unknown servers."""

from __future__ import annotations

import pytest

from motionlang.mint import DIALECT
from motionlang.source import Source

DIM = "Dim n As Integer, x As Float\nn = INX(9) : x = n\nPRINT x\n"
# Loops from line 4 on, and the lines of their warnings.
BUSY: dict[str, list[int]] = {
    "Loop\n  n = n + 1\nEnd Loop": [4],
    "While 1\n  n = n + 1\nEnd While": [4],
    "again:\nn = n + 1\nGoto again": [4],
    "Loop\n  PRINT 1\nEnd Loop": [4],
    "Loop\n  more()\nEnd Loop\nSub more()\n  n = n + 1\nEnd Sub": [4],
    "Loop\n  n = n + 1\n  If n > 5 Then Exit Loop\nEnd Loop": [],
    "Loop\n  n = n + 1\n  If n > 5 Then End\nEnd Loop": [],
    "Loop\n  n = n + 1\n  WAIT 1\nEnd Loop": [],
    "Loop\n  n = n + 1\n  PAUSE INX(1)\nEnd Loop": [],
    "Loop\n  n = INX(1)\nEnd Loop": [],
    "Loop\n  n = TIME\nEnd Loop": [],
    "Loop\n  x = Rnd\nEnd Loop": [],
    "Loop\n  OUTX(1) = n\nEnd Loop": [],
    "Loop\n  more()\nEnd Loop\nSub more()\n  WAIT 1\nEnd Sub": [],
    "Loop\nEnd Loop": [],
    "Loop\n  n = n + 1\nEnd Loop\nEvent IN1\n  PRINT n\nEnd Event": [],
    "Loop\n  n = n + 1\nEnd Loop\nTask other\n  PRINT n\nEnd Task": [],
    "WAIT 5\nLoop\n  n = n + 1\nEnd Loop": [5],
    "Loop\n  WAIT 1\n  Loop\n    n = n + 1\n  End Loop\nEnd Loop": [6],
}
REPLACED: dict[str, list[int]] = {
    "For n = 1 To 5\n  JOG(0) = n\nNext": [5],
    "For n = 1 To 5\n  JOG(0) = 5\nNext": [],
    "For n = 1 To 5\n  JOG(0) = n\n  WAIT 1\nNext": [],
    "For n = 1 To 5\n  JOG(0) = n\n  PAUSE IDLE(0)\nNext": [],
    "For n = 1 To 5\n  JOG(0) = n\n  MOVER(1) = 1\nNext\nGO(1)": [],
    "For n = 1 To 5\n  JOG(0) = n\n  more()\nNext\nSub more()\n  PRINT 1\nEnd Sub": [],
    "For n = 1 To 5\n  If INX(1) Then JOG(0) = n\nNext": [],
    "While INX(1)\n  x = x + 1\n  JOG(0) = x\nEnd While": [6],
    "While INX(1)\n  x = 5\n  JOG(0) = x\nEnd While": [],
    "While INX(1)\n  x = x + 1\n  JOG(0) = n\nEnd While": [],
    "Repeat\n  x = x + 1\n  JOG(0) = x\n  JOG(1) = x\nUntil INX(1)": [6],
    "For n = 1 To 5\n  SPEED(0) = n\nNext\nMOVER(0) = 1 : GO(0)": [],
}
BLENDS: dict[str, list[int]] = {
    # Paths of 5 and 10: half of 5 is 2.5.
    "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 3\nVECTORR(0, 1) = 3, 4\nVECTORR(0, 1) = 6, 8\nGO(0)": [5],
    "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 2.5\nVECTORR(0, 1) = 3, 4\nVECTORR(0, 1) = 6, 8\nGO(0)": [],
    "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 3\nVECTORR(0, 1) = 6, 8\nVECTORR(0, 1) = 3, 4\nGO(0)": [],
    "BLENDMODE(0) = 1 : BLENDDISTANCE(1) = 3\nVECTORR(0, 1) = 3, 4\nVECTORR(0, 1) = 6, 8\nGO(0)": [],
    "BLENDDISTANCE(0) = 3\nVECTORR(0, 1) = 3, 4\nVECTORR(0, 1) = 6, 8\nGO(0)": [],
    "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 3\nVECTORA(0, 1) = 3, 4\nVECTORR(0, 1) = 6, 8\nGO(0)": [],
    "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 3\nVECTORR(0, 1) = n, 4\nVECTORR(0, 1) = 6, 8\nGO(0)": [],
}
# Server 4 has the registers 6 to 20, and a register of server 9 changes.
SERVED: dict[str, list[int]] = {
    "PRINT MODBUSTCP16(4, 6), MODBUSTCP16(4, 20), MODBUSTCP32(4, 19)": [],
    "PRINT MODBUSTCP16(4, 5)": [4],
    "PRINT MODBUSTCP16(4, 21)": [4],
    "PRINT MODBUSTCP32(4, 20)": [4],
    "PRINT MODBUSTCPFLOAT(4, 19)": [],
    "PRINT MODBUSTCPFLOAT(4, 20)": [4],
    "PRINT MODBUSTCP16(5, 6)": [4],
    "MODBUSTCP16(5, 6) = 1": [4],
    "PRINT MODBUSTCP16(9, 65535)": [],
    "PRINT MODBUSTCP32(9, 65535)": [4],
    "PRINT MODBUSTCP16(n, 5)": [],
    "End\nEvent IN1\n  PRINT MODBUSTCP16(5, 6)\nEnd Event": [6],
}
SERVERS: dict[str, object] = {
    "modbus.server": [{"id": 4, "first": 6, "last": 20}],
    "modbus.register": [{"server": 9, "register": 1, "value": 1}],
}


def lines(code: str, text: str, machine: dict[str, object] | None = None) -> list[int]:
    """Return the lines of the warnings with a code."""
    return [
        each.line for each in DIALECT.check(Source("a.mnt", DIM + text), machine or {}) if each.code == code
    ]


@pytest.mark.parametrize("text", BUSY)
def test_a_loop_that_only_computes(text: str) -> None:
    assert lines("busy-loop", text) == BUSY[text]


@pytest.mark.parametrize("text", REPLACED)
def test_a_motion_that_each_iteration_replaces(text: str) -> None:
    assert lines("never-waits", text) == REPLACED[text]


@pytest.mark.parametrize("text", BLENDS)
def test_a_path_that_is_too_short_for_its_blend(text: str) -> None:
    assert lines("blend-distance", text) == BLENDS[text]


@pytest.mark.parametrize("text", SERVED)
def test_a_request_that_no_server_answers(text: str) -> None:
    assert lines("no-connection", text, SERVERS) == SERVED[text]
