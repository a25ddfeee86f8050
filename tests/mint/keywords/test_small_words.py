"""Small rules of single keywords, each with its only test."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.source import Source

RATES = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
PLANT: dict[str, object] = {"axis.0.plant.inertia": 2e-4, "axis.0.plant.viscous": 1e-4}
# A rule, the program, its output, and the machine.
WORDS: dict[str, tuple[str, list[str], dict[str, object]]] = {
    "the last of 64 analogue inputs gives a speed reference": (
        "SPEEDREFSOURCE(0) = 64 : PRINT SPEEDREFSOURCE(0)", ["64"], {}),
    "the number 0 is no error, and 1 is one": (
        "PRINT ERRORSTRING(0) : PRINT ERRORSTRING(1) <> ERRORSTRING(0)", ["no error", "1"], {}),
    "a second between the points of a capture is a million microseconds": (
        "CAPTUREPERIOD = 2000000 : PRINT CAPTUREPERIOD", ["2000000"], {}),
    "a clock that nobody set began when the controller did": (
        "WAIT(1500) : PRINT REALTIMECLOCK", ["2000-01-01 00:00:01"], {}),
    "a brake that has no delays is lifted at once": (
        "MOTORBRAKEOUTPUT(0) = 4 : MOTORBRAKEMODE(0) = 1 : DRIVEENABLE(0) = _OFF : WAIT(9)\n"
        "DRIVEENABLE(0) = _ON : PRINT OUTX(4)", ["1"], {"controller.instruction_time": 1e-9}),
    "a brake that has delays is lifted after the one and set after the other": (
        "MOTORBRAKEOUTPUT(0) = 4 : MOTORBRAKEMODE(0) = 1 : DRIVEENABLE(0) = _OFF\n"
        "MOTORBRAKEDELAY(0, 0) = 20 : MOTORBRAKEDELAY(0, 1) = 20\n"
        "DRIVEENABLE(0) = _ON : WAIT(15) : PRINT OUTX(4) : WAIT(15) : PRINT OUTX(4)\n"
        "DRIVEENABLE(0) = _OFF : WAIT(15) : PRINT OUTX(4) : WAIT(15) : PRINT OUTX(4)", ["0", "1", "1", "0"], {}),
    "without a highest speed there is no time up to it": (
        RATES + "PRINT ACCELTIMEMAX(0), DECELTIMEMAX(0)\nMAXSPEED(0) = 200 : PRINT ACCELTIMEMAX(0)",
        ["00", "200"], {}),
    "a motor that has not moved has no time to settle but what IDLETIME says": (
        "IDLEMODE(0) = 1 : IDLETIME(0) = 10 : PRINT IDLESETTLINGTIME(0)", ["10"], PLANT),
    "IDLETIME behind the move the axis is idle, whatever the sum of the two is rounded to": (
        "Dim n As Integer\nIDLEMODE(0) = 1 : IDLEPOS(0) = 5 : IDLETIME(0) = 5\n"
        "For n = 1 To 30\n  MOVER(0) = n * 7 : GO(0) : PAUSE IDLE(0)\nNext\nPRINT IDLE(0)", ["1"], {}),
    "DEFAULT forgets the following error that warns": (
        "FOLERRORWARNING(0) = 50 : DEFAULT(0) : KPROP(0) = 0.05\n"
        "SPEED(0) = 20000 : ACCEL(0) = 40000 : DECEL(0) = 40000\n"
        "MOVER(0) = 20000 : GO(0) : WAIT(300) : PRINT FOLERROR(0) > 50, AXISWARNING(0)", ["10"], PLANT),
    "the other software limit is at 0 until it is written": (
        RATES + "SOFTLIMITFORWARD(0) = 50 : PRINT SOFTLIMITREVERSE(0)", ["0.0000"], {}),
    "a deadband is so many of the 4096 steps of the range": (
        RATES + "HTACHANNEL(0) = 2 : HTAKPROP(0) = 1 : HTADEADBAND(0) = 64\n"
        "HTA(0) = 53.125 : WAIT(500) : PRINT POS(0)", ["0.0000"],
        {"analogue": [{"channel": 2, "at": 0.0, "value": 50.0}]}),
    "paths are blended into each other, at a distance, and moves have marks, where the program says so": (
        "PRINT BLENDMODE(0), BLENDDISTANCE(0), MOVEBUFFERID(0)", ["00.00000"], {}),
    "a path starts as it is loaded where the first of its axes says so": (
        "TRIGGERMODE(0) = _trAUTO : VECTORR(0, 1) = 3, 4 : PAUSE IDLE(0, 1) : PRINT POS(0), POS(1)",
        ["3.00004.0000"], {}),
    "before it homes an axis has no place at which it did": ("PRINT HOMEPOS(0)", ["0.0000"], {}),
    "COMMSREMOTE is about the first bus": (
        "COMMSREMOTE(2, 7) = 2.5 : PRINT COMMSREMOTE(2, 7), REMOTECOMMS(1, 2, 7), REMOTECOMMS(2, 2, 7)",
        ["2.50002.50001.5000"],
        {"remote": [{"bus": bus, "node": 2, "element": 7, "value": 1.5} for bus in (1, 2)]}),
    "five entries of comms have an event on a NextMove ESB-2": (
        "WAIT 300\nEnd\nEvent COMMS5\n  PRINT 5\nEnd Event\nEvent COMMS6\n  PRINT 6\nEnd Event", ["5"],
        {"controller.model": "NextMove ESB-2",
         "comms": [{"at": 0.1, "element": each, "value": 1} for each in (5, 6)]}),
    "zero has no sign, whether it is known before the run or not": (
        "Dim a As Float = 0\nPRINT Sgn(0), Sgn(0.0), Sgn(a), Sgn(-0.5), Sgn(0.5)", ["000-11"], {}),
    "a comparison of texts is no text": (
        'Const EQUAL_TEXTS = "a" = "a"\nConst BOTH = "a" + "b"\nConst ALSO = "a" & "b"\n'
        "PRINT EQUAL_TEXTS, BOTH, ALSO", ["1abab"], {}),
    "the last of 32 groups is the sign of the bits of a node": (
        "GROUP(1, 31, 7) = 1 : GROUP(1, 0, 8) = 1 : PRINT GROUPINFO(1, 7), GROUPINFO(1, 8)", ["-21474836481"],
        {}),
    # The nut is at 0 and 101 for 0 and 100 of the motor in forward motion, 1 lower in reverse. The motor
    # stays at 0 when the tables come into force.
    "before its first move an axis is compensated as in forward motion": (
        RATES + "Dim forward(3) As Float = 2, 0, 101\nDim back(3) As Float = 2, -1, 100\n"
        "PRECISIONTABLE(0, forward, back) : PRECISIONINCREMENT(0) = 100 : PRECISIONMODE(0) = _lsDUAL_TABLE\n"
        "PRINT ENCODER(0) : MOVEA(0) = 101 : GO(0) : PAUSE IDLE(0) : PRINT ENCODER(0)\n"
        "MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0) : PRINT ENCODER(0)", ["0.0000", "100.0000", "100.0000"], {}),
}  # fmt: skip
# A keyword whose number is just outside its range, and the message.
OUTSIDE = {
    "PRINT GROUPSTATUS(1, 32)": "there is no group 32",
    "PRINT GROUPSTATUS(1, -1)": "there is no group -1",
    "GROUPCOMMS(1, 32, 9) = 4.5": "there is no group 32",
}


@pytest.mark.parametrize("rule", WORDS)
def test_what_it_prints(rule: str) -> None:
    text, expected, machine = WORDS[rule]
    result = run(Source("a.mnt", text), machine=machine, cache=False, until=10.0)
    assert [each.message for each in result.diagnostics] == []
    assert result.output == expected


@pytest.mark.parametrize("text", OUTSIDE)
def test_a_number_outside_its_range_is_refused(text: str) -> None:
    result = run(Source("a.mnt", text), cache=False, until=10.0)
    assert [each.message for each in result.diagnostics] == [OUTSIDE[text]]
