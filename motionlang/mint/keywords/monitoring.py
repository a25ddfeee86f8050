"""Analogue inputs with limits, warnings, drives and enable inputs, and masks of errors."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword
from motionlang.mint.keywords.defaults import FATAL_ERROR, MODES

_ADC = "ADCMIN(2) = 10\nADCMAX(2) = 90\nADCMONITOR(0) = 4\nPRINT {}"
_FAIL = "{}SPEED(0) = 0\nMOVER(0) = 1\nGO(0)\nPRINT IDLE(0)\nEnd\nEvent ONERROR\n  PRINT ERRCODE\nEnd Event"


def _word(
    name: str, short: str, access: str, index: str, unit: str, verb: str, help: str, example: str,
    default: float = 0.0, low: float | None = None, high: float | None = None, group: str = "errors",
) -> Keyword:  # fmt: skip
    kind = "reading" if access == "R" else "setting"
    return Keyword(name, short, kind, access, index, unit, verb, help, example, default=default, low=low, high=high,
                   group=group)  # fmt: skip


ROWS = (
    _word("ADCMAX", "", "RW", "channel", "%", "monitoring.limit",
          "The highest value of an analogue input without error.",
          _ADC.format("ADCMAX(2)"), 100.0, -100.0, 100.0, "io"),
    _word("ADCMIN", "", "RW", "channel", "%", "monitoring.limit",
          "The lowest value of an analogue input without error.",
          _ADC.format("ADCMIN(2)"), -100.0, -100.0, 100.0, "io"),
    _word("ADCMONITOR", "", "RW", "axis", "bits", "monitoring.minded",
          "Bit pattern of the analogue inputs that the axis minds: beyond ADCMIN and ADCMAX they are an error of it.",
          _ADC.format("ADCMONITOR(0)"), group="io"),
    _word("ADCERROR", "", "R", "axis", "bits", "monitoring.beyond",
          "Bit pattern of the analogue inputs that the axis minds and that are beyond their limits now.",
          _ADC.format("ADCERROR(0)"), group="io"),
    _word("ADCERRORMODE", "", "RW", "axis", "integer", "limits.mode",
          "What the axis does when an analogue input that it minds goes beyond its limits: one of _emIGNORE, "
          "_emCRASH_STOP, _emCRASH_STOP_DISABLE, _emERROR_DECEL, _emERROR_DECEL_DISABLE, _emCALL_EVENT.",
          "ADCERRORMODE(0) = _emERROR_DECEL\nPRINT ADCERRORMODE(0)", float(MODES["ADCERRORMODE"]), 0, 5, "limits"),
    Keyword("ADCOFFSETTRIM", "", "command", "C", "channel", "", "monitoring.trim",
            "Make what an analogue input shows now its zero, by its ADCOFFSET.",
            "ADCOFFSETTRIM(0)\nPRINT ADC(0)", group="io"),
    _word("FOLERRORWARNING", "", "RW", "axis", "uu", "monitoring.following_warning",
          "The following error beyond which the axis warns, in AXISWARNING; only a simulated motor has one.",
          "FOLERRORWARNING(0) = 2\nPRINT FOLERRORWARNING(0)", FATAL_ERROR, 0.0, 8388607.0, "servo"),
    _word("AXISWARNING", "", "RW", "axis", "bits", "monitoring.warning",
          "Warnings of the axis: bit 0, its following error was beyond FOLERRORWARNING. Writing 0 clears them.",
          "AXISWARNING(0) = 0\nPRINT AXISWARNING(0)", 0.0, 0, 0),
    _word("AXISWARNINGDISABLE", "", "RW", "axis", "bits", "monitoring.warning_disable",
          "Bit pattern of the warnings that the axis does not give.",
          "AXISWARNINGDISABLE(0) = 1\nPRINT AXISWARNINGDISABLE(0)"),
    _word("ERRORMASK", "", "RW", "axis", "bits", "monitoring.mask",
          "Bit pattern of the errors of the axis, as in AXISERROR, that call ONERROR; the axis stops as ever.",
          "ERRORMASK(0) = 0x7E\nABORT\nPRINT AXISERROR(0), AXISERROR(1)\nEnd\nEvent ONERROR\n"
          "  While ERRORREADNEXT(_egAXIS, 1)\n    PRINT ERRSTRING\n  End While\nEnd Event", -1.0),
    _word("ERRORMASKCODE", "", "RW", "code, data", "bool", "monitoring.code_mask",
          "1: the error of that number, of an axis the one that data names, does not call ONERROR.",
          _FAIL.format("ERRORMASKCODE(3, 0) = _TRUE\n"), 0.0, 0, 1),
    _word("ASYNCERRORPRESENT", "", "R", "none", "bool", "monitoring.asynchronous",
          "1 while the list of errors has one that no statement has made: of an axis or of the controller.",
          "PRINT ASYNCERRORPRESENT"),
    _word("DRIVEENABLESWITCH", "des", "R", "axis", "bool", "monitoring.enable_switch",
          "1 while the hardware enable input of the drive is on, or where the machine file gives it none.",
          "PRINT DRIVEENABLESWITCH(0)", 1.0),
    _word("ENABLESWITCH", "", "R", "axis", "bool", "monitoring.enable_switch",
          "The same as DRIVEENABLESWITCH.", "PRINT ENABLESWITCH(0)", 1.0),
    _word("DRIVEERROR", "dre", "RW", "axis", "bits", "monitoring.drive_error",
          "Errors of the drive, which only the machine file brings about. Writing 0 clears the errors of the axis.",
          "DRIVEERROR(0) = 0\nPRINT DRIVEERROR(0)", 0.0, 0, 0),
    _word("DRIVEFAULT", "", "R", "axis", "integer", "monitoring.drive_fault", "1 while the drive has an error.",
          "PRINT DRIVEFAULT(0)"),
    _word("MISCERROR", "", "RW", "none", "bits", "monitoring.misc",
          "Errors of the controller itself, which only the machine file brings about. Writing 0 clears them.",
          "MISCERROR = 0\nPRINT MISCERROR", 0.0, 0, 0),
    _word("MISCERRORDISABLE", "", "RW", "none", "bits", "monitoring.misc_disable",
          "Bit pattern of the errors of the controller that MISCERROR does not show and that call no ONERROR.",
          "MISCERRORDISABLE = 1\nPRINT MISCERRORDISABLE"),
)  # fmt: skip
