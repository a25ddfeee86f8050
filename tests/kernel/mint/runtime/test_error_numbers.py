"""The numbers that a handler of ONERROR reads, and the registers of errors."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

DIM = "Dim n As Integer, x As Float, t As String * 3, a(2) As Integer\n"
HANDLER = "\nEnd\nEvent ONERROR\n  While ERRORREADNEXT(_egALL, 0)\n    PRINT ERRCODE\n  End While\nEnd Event"
NODES: dict[str, object] = {"modbus.server": [{"id": 4}]}
# What is done, and the numbers of the errors.
NUMBERS: dict[str, list[int]] = {
    "n = 99\nPRINT POS(n)": [2],
    "n = -1\nSPEED(0) = n": [3],
    "JOGCOMMAND(0) = 1": [3],
    "n = 1000\nOUTX(n) = 1": [4],
    "n = 64\nPRINT ADC(n)": [4],
    "JOG(0) = 5 : BACKLASH(0) = 1 : CANCEL(0)": [10],
    "JOG(0) = 5 : HOME(0) = _hmNEGATIVE_INDEX : CANCEL(0)": [10],
    "DRIVEENABLE(0) = _OFF\nMOVER(0) = 1": [40],
    "PRINT MODBUSTCP16(5, 1)": [41],
    "PRINT MODBUSTCP16(4, 65536)": [4],
    "n = 256\nPRINT INKEY(n)": [130],
    "CAPTURE = 1 : CAPTURE = 1": [74],
    "n = 0\nCAPTURENUMPOINTS = n": [75],
    "CAPTURETRIGGER": [219],
    "CAPTURE = 1 : CAPTURETRIGGER": [220],
    "CONTOURMODE(0) = 1 : BLENDMODE(0) = 1": [158],
    "BLENDMODE(0) = 1 : CONTOURMODE(0) = 1": [158],
    "MOVER(0) = 1 : MOVEBUFFERSIZE(0) = 5": [142],
    "MOTORBRAKE(0) = _ON : MOVER(0) = 1": [218],
    "JOG(0) = 5000 : WAIT 500 : STOP(0) : MOVER(0) = 1": [236],
    "n = 0\nPRINT 1 / n": [1001],
    "n = 0\nPRINT 1 \\ n": [1001],
    "x = -1\nPRINT Sqrt(x)": [1002],
    "n = 0\nPRINT Mid(t, n)": [1002],
    "n = 3\na(n) = 1": [1004],
    "x = 3e9\nn = x": [1005],
    "PRINT ERRCODE": [1006],
    't = "abc"\nt = t + t': [1008],
    "ABORT : CANCELALL": [10000],
}


def ran(text: str, handler: str = HANDLER) -> Run:
    machine = {**NODES, "controller.axes": 1}
    return run(Source("a.mnt", DIM + text + handler), machine=machine, until=10.0)


@pytest.mark.parametrize("text", NUMBERS)
def test_the_number_of_an_error(text: str) -> None:
    assert ran(text).output == [str(number) for number in NUMBERS[text]]


TEXTS = {
    0: "no error", 1: "error 1", 2: "axis number invalid", 3: "value invalid", 4: "channel invalid",
    6: "output not assigned", 10: "axis is moving", 12: "axis has an error", 17: "not supported here",
    40: "drive disabled", 41: "no connection", 59: "move buffer full", 74: "capture running",
    75: "number of capture points invalid", 130: "terminal undefined", 131: "single terminal required",
    142: "move buffer must be empty", 158: "contour and blend both on", 204: "event cannot be pended",
    218: "motor brake on", 219: "capture not running", 220: "capture not waiting for trigger",
    228: "hardware enable input off", 236: "axis stopping, move refused", 999: "error 999",
    1001: "divide by zero", 1002: "invalid argument", 1003: "stack overflow", 1004: "index out of range",
    1005: "integer out of range", 1006: "error registers not primed", 1007: "out of memory", 1008: "string overflow",
    10000: "axis error", 10001: "error 10001", 20000: "controller error",
}  # fmt: skip


def test_the_text_of_a_number() -> None:
    result = ran("\n".join(f"PRINT ERRORSTRING({number})" for number in TEXTS), "")
    assert result.output == list(TEXTS.values())


def test_errors_are_read_from_the_oldest_on_and_found_by_their_number_from_the_newest() -> None:
    """Lines 3 to 5 have the errors 1004, 1001 and 1004."""
    text = (
        "n = 3\na(n) = 1\nPRINT 1 / (n - 3)\na(n) = 2\n"
        "PRINT ERRORREADCODE(1004, -1), ERRLINE, ERRORREADCODE(1001, 0), ERRLINE, ERRORREADCODE(1005, 0), ERRLINE\n"
        "PRINT ERRORREADNEXT(_egALL, 0), ERRLINE, ERRORREADNEXT(_egSYNCHRONOUS, 0), ERRLINE\n"
        "PRINT ERRORREADNEXT(_egAXIS, 0), ERRLINE, ERRORPRESENT(_egALL, 0), ERRORPRESENT(_egMISC, 0)\n"
        "PRINT ERRORREADNEXT(_egALL, 0), ERRLINE, ERRORREADNEXT(_egALL, 0), ERRLINE\nEnd\n"
        "Event ONERROR\n  n = n\nEnd Event"
    )
    assert ran(text, "").output == ["151404", "1314", "0410", "1505"]


def test_an_axis_error_is_that_of_its_axis_with_its_bits() -> None:
    """ABORT is bit 0. ERRORCLEAR clears the error of its axis and of no other one."""
    text = (
        "ABORT\nPRINT ERRORPRESENT(_egAXIS, 0), ERRORPRESENT(_egAXIS, 1), ERRORPRESENT(_egSYNCHRONOUS, 0)\n"
        "PRINT ERRORREADCODE(10000, 1), ERRORREADCODE(10000, 0), ERRDATA(1), ERRDATA(2), ERRDATA(3), ERRDATA(0)\n"
        "ERRORCLEAR(_egAXIS, 1) : PRINT AXISERROR(0), ERRORPRESENT(_egALL, 0)\n"
        "ERRORCLEAR(_egSYNCHRONOUS, 0) : PRINT AXISERROR(0), ERRORPRESENT(_egALL, 0)\n"
        "ERRORCLEAR(_egAXIS, 0) : PRINT AXISERROR(0), ERRORPRESENT(_egALL, 0)\nEnd\n"
        "Event ONERROR\n  n = n\nEnd Event"
    )
    assert ran(text, "").output == ["100", "010100", "11", "11", "00"]


def test_the_list_has_the_last_100_errors() -> None:
    """Of 150 errors the first 50 are gone."""
    text = (
        "For n = 1 To 150\n  x = 1 / (n - n)\nNext\nn = 0\n"
        "While ERRORREADNEXT(_egALL, 0)\n  n = n + 1\nEnd While\nPRINT n\nEnd\nEvent ONERROR\n  x = x\nEnd Event"
    )
    assert ran(text, "").output == ["100"]
