"""Rejections by Mint's motion keywords: a program, the line, and the message."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.mint import DIALECT
from motionlang.source import Source

RUN = {
    "VECTORR(0, 0) = 1, 2": "a path needs two or more different axes",
    "AXES[0, 1]\nCIRCLER = 1, 2": "CIRCLER is given 2 axes and 2 values",
    "AXES[0]\nVECTORA = 1": "VECTORA is given 1 axes and 1 values",
    "CONTOURMODE(0) = 1\nBLENDMODE(0) = 1": "BLENDMODE cannot be set while CONTOURMODE is",
    "FOLLOW(0) = 1": "axis 0 cannot follow axis 0: it would follow itself",
    "MASTERCHANNEL(1) = 9\nFOLLOW(1) = 1": "there is no axis 9",
    "MASTERDISTANCE(0) = 5\nFLY(0) = 5": "axis 0 cannot follow axis 0: it would follow itself",
    "FLY(1) = 5": "FLY needs the distance of the master",
    "CAM(1) = 0": "axis 1 has no cam table",
    "Dim a(3) As Float = 5, 1, 1\nCAMTABLE(1, a)": "CAMTABLE: element 1 of the table says that it has 5 segments, and "
    "the array has room for 2",
    "Dim a(3) As Float = 2, 1, 1\nCAMTABLE(1, a)\nMASTERDISTANCE(1) = 5\nCAMSTART(1) = 3\nCAM(1) = 0": "CAM: the table "
    "has segments 1 to 2, not 3 to 2",
    "Dim a(3) As Float = 2, 1, 1\nCAMTABLE(1, a)\nMASTERDISTANCE(1) = -5\nCAM(1) = 0": "axis 1 cannot follow the "
    "table: the positions of a table must rise from 0",
    "Dim a(3) As Float = 2, 1, 1\nCAMSEGMENT(1, 0, 1, a)": "CAMSEGMENT: axis 1 has no table 0",
    "SPLINE(0) = 0": "axis 0 has no spline",
    "Dim a(3) As Float = 2, 1, 1\nSPLINETABLE(0, a)\nMOVER(0) = 5\nSPLINE(0) = 0": "axis 0 is moving, or its buffer is "
    "not empty",
    "Dim a(3) As Float = 2, 1, 1\nDim t(2) As Float = 1, 1\nSPLINETABLE(0, a, NULL, t)\nSPLINE(0) = 0": "SPLINETABLE: "
    "one of the arrays has 1 segments and another 2",
    "Dim a(3) As Float = 2, 1, 1\nDim t(3) As Float = 2, 100\nSPLINETABLE(0, a, NULL, t)\nSPLINE(0) = 0": "a segment "
    "of a spline cannot take 0 ms",
    "FOLLOW(1) = 1\nJOG(0) = 5\nOFFSET(1) = 1e308": "OFFSET cannot be 1e+308",
    "SCALEFACTOR(0) = 500\nPOS(0) = 1e308": "POS cannot be 1e+308",
    "ACCELTIMEMAX(0) = 100": "ACCELTIMEMAX needs the highest speed of axis 0",
    "FEEDRATEPARAMETER(0, 3) = 1": "FEEDRATEPARAMETER has no parameter 3",
    "JOG(0) = 5\nWAIT = 10\nINCR(0) = 5": "axis 0 is not on a move to a position",
    "JOG(0) = 5\nWAIT = 10\nDECEL(0) = 1\nSTOP(0)\nMOVER(0) = 5": "axis 0 is stopping",
    "JOG(0) = 5\nWAIT = 10\nDECEL(0) = 1\nSTOP(0)\nVECTORR(1, 0) = 5, 5": "axis 0 is stopping",
    "MOVER(0) = 5\nMOVEBUFFERSIZE(0) = 5": "the move buffer of axis 0 is in use",
    "MOVEOUTX(0, 5000) = 1": "there is no output 5000",
}
CHECKED = {
    "VECTORR(0) = 1": "VECTORR needs 2 axes or more in brackets, 1 given",
    "VECTORR(0, 1) = 1": "VECTORR needs 2 values here, 1 given",
    "CIRCLER(0, 1) = 1, 2": "CIRCLER needs 3 values here, 2 given",
    "HELIXA(0, 1) = 1, 2, 3, 4": "HELIXA needs 3 axes in brackets, 2 given",
    "CAMTABLE(0)": "CAMTABLE takes axis, array, array in brackets, 1 given",
    "Dim a As Float\nCAMTABLE(0, a)": "CAMTABLE needs an array of numbers with one subscript here",
    "Dim a(2, 2) As Float\nCAMTABLE(0, a)": "CAMTABLE needs an array of numbers with one subscript here",
    "FEEDRATEMODE(0) = 4": "FEEDRATEMODE cannot be 4",
    "VECTORR(0, 9) = 1, 2": "there is no axis 9",
    "x = FLY(0)": "FLY can be written but not read",
}


@pytest.mark.parametrize(("program", "message"), RUN.items(), ids=lambda text: text.split("\n")[-1])
def test_run_reports_the_line_at_fault(program: str, message: str) -> None:
    (diagnostic,) = run(Source("a.mnt", program), cache=False).diagnostics
    assert diagnostic.message == message
    assert diagnostic.line == program.count("\n") + 1


@pytest.mark.parametrize(("program", "message"), CHECKED.items(), ids=lambda text: text.split("\n")[-1])
def test_check_reports_rejections_before_the_run(program: str, message: str) -> None:
    assert message in [each.message for each in DIALECT.check(Source("a.mnt", program))]


def test_a_rejected_home_leaves_the_axis_free() -> None:
    """The brake holds the axis, so HOME is rejected.

    Once the brake is released the axis moves, and its soft limit stops it at 15 of 20.
    """
    program = (
        "SOFTLIMITFORWARD(0) = 15 : SOFTLIMITREVERSE(0) = -15\n"
        "MOTORBRAKE(0) = 1\nHOME(0) = 3\nMOTORBRAKE(0) = 0\n"
        "MOVER(0) = 20 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n"
        "Event ONERROR\n  ERRORCLEAR(_egALL, 0)\nEnd Event\n"
    )
    result = run(Source("brake.mnt", program), until=1.0, cache=False)
    assert [float(line) for line in result.output] == [15.0]
    assert [event.kind for event in result.controller.log.events] == [
        "handler",
        "soft limit",
        "velocity jump",
        "handler",
        "cleared",
    ]
