"""Limits, errors of an axis, the inputs given to an axis, and what clears them."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword
from motionlang.mint.keywords.defaults import MODES, STOP_INPUT_MODE

_CLEAR = "JOG(0) = 100\nWAIT = 100\nABORT\nPRINT AXISERROR(0)\nCANCEL(0)\nPRINT AXISERROR(0)"


def _mode(name: str, help: str) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", "integer", "limits.mode",
                   f"{help}: one of _emIGNORE, _emCRASH_STOP, _emCRASH_STOP_DISABLE, _emERROR_DECEL, "
                   "_emERROR_DECEL_DISABLE, _emCALL_EVENT.",
                   f"{name}(0) = _emERROR_DECEL\nPRINT {name}(0)", default=float(MODES[name]), low=0, high=5,
                   group="limits")  # fmt: skip


def _input(name: str, short: str, help: str) -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", "integer", "limits.switches.input", f"{help}; -1 for none.",
                   f"{name}(0) = 3\nPRINT {name}(0)", default=-1.0, low=-1, high=999, group="limits")  # fmt: skip


def _switch(name: str, short: str, verb: str, help: str) -> Keyword:
    return Keyword(name, short, "reading", "R", "axis", "bool", verb, help, f"PRINT {name}(0)", default=0.0,
                   group="limits", driven="input")  # fmt: skip


def _soft(name: str, help: str) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", "uu", "limits.soft", help,
                   "SOFTLIMITFORWARD(0) = 250\nSOFTLIMITREVERSE(0) = -5\nPRINT SOFTLIMITFORWARD(0)",
                   default=0.0, low=-8388607.0, high=8388607.0, group="limits")  # fmt: skip


_MODES = (
    ("IGNORE", "nothing is done"),
    ("CRASH_STOP", "stop at once"),
    ("CRASH_STOP_DISABLE", "stop at once and switch the drive off"),
    ("ERROR_DECEL", "stop at ERRORDECEL"),
    ("ERROR_DECEL_DISABLE", "stop at ERRORDECEL, then switch the drive off"),
    ("CALL_EVENT", "only the event ONERROR"),
)
_CONSTANTS = tuple(
    Keyword(f"_em{name}", "", "constant", "R", "none", "integer", str(value), f"Modes of errors: {help}.",
            f"PRINT _em{name}", group="constants")
    for value, (name, help) in enumerate(_MODES)
)  # fmt: skip
ROWS = (
    *_CONSTANTS,
    _soft("SOFTLIMITFORWARD", "Software limit of forward travel; two limits of 0 are none."),
    _soft("SOFTLIMITREVERSE", "Software limit of reverse travel; two limits of 0 are none."),
    _mode("SOFTLIMITMODE", "What the axis does at a software limit"),
    _mode("LIMITMODE", "What the axis does at a limit switch"),
    _input("LIMITFORWARDINPUT", "lfi", "The input that is the forward limit switch of the axis"),
    _input("LIMITREVERSEINPUT", "lri", "The input that is the reverse limit switch of the axis"),
    _switch("LIMITFORWARD", "lf", "limits.forward", "1 while the forward limit switch is active."),
    _switch("LIMITREVERSE", "lr", "limits.reverse", "1 while the reverse limit switch is active."),
    _switch("LIMIT", "", "limits.either", "1 while one of the two limit switches is active."),
    _mode("FOLERRORMODE", "What the axis does when its following error is fatal"),
    _input("ERRORINPUT", "ei", "The input that tells of an error of the axis"),
    _mode("ERRORINPUTMODE", "What the axis does when its error input becomes active"),
    _switch("ERRORSWITCH", "es", "limits.switches.switch", "1 while the error input of the axis is active."),
    _input("STOPINPUT", "", "The input that stops the axis"),
    Keyword("STOPINPUTMODE", "", "setting", "RW", "axis", "integer", "limits.resetting.stop_mode",
            "What the axis does when its stop input becomes active: _emIGNORE only the event STOP, _emCRASH_STOP "
            "a crash stop, _emERROR_DECEL a stop at ERRORDECEL.",
            "STOPINPUT(0) = 3\nSTOPINPUTMODE(0) = _emCRASH_STOP\nPRINT STOPINPUTMODE(0)",
            default=float(STOP_INPUT_MODE), low=0, high=3, group="limits"),
    _switch("STOPSWITCH", "", "limits.switches.switch", "1 while the stop input of the axis is active."),
    _input("SUSPENDINPUT", "", "The input that suspends the axis for as long as it is active"),
    _switch("SUSPENDSWITCH", "", "limits.switches.switch", "1 while the suspend input of the axis is active."),
    _input("RESETINPUT", "rsi", "The input that resets the axis when it becomes active"),
    Keyword("AXISERROR", "", "setting", "RW", "axis", "bits", "limits.error",
            "Errors of the axis: bit 0 abort, 1 error input, 2 forward limit, 3 reverse limit, 4 forward soft limit, "
            "5 reverse soft limit, 6 following error, 7 analogue limit, 8 drive. Writing 0 clears them; until then the "
            "axis takes no motion.",
            _CLEAR, default=0.0, low=0, high=0, group="limits"),
    Keyword("ERRORDECEL", "", "setting", "RW", "axis", "uu/s2", "error_decel",
            "Deceleration of stops because of an error or of the stop input.",
            "ERRORDECEL(0) = 5000\nPRINT ERRORDECEL(0)", default=100000.0, low=0.0, high=1e12, group="limits"),
    _mode("ABORTMODE", "What the axis does at ABORT"),
    Keyword("ABORT", "", "command", "C", "none", "", "limits.abort",
            "Stop every axis as its ABORTMODE says, and note the error on it.",
            _CLEAR, group="stopping", effect="stop abrupt all"),
    Keyword("STOP", "ST", "command", "C", "axes", "", "limits.resetting.stop",
            "Decelerate the axes to rest as their STOPMODE says, and empty their buffers.",
            "JOG(0) = 100\nWAIT = 500\nSTOP(0)\nPAUSE IDLE(0)\nPRINT IDLE(0)", group="stopping", effect="stop"),
    Keyword("STOPMODE", "", "setting", "RW", "axis", "integer", "limits.resetting.stop_mode",
            "How STOP ends motion: 0 at DECEL, 1 at ERRORDECEL, 2 at once.",
            "STOPMODE(0) = 1\nPRINT STOPMODE(0)", default=0.0, low=0, high=2, group="stopping"),
    Keyword("RESET", "", "command", "C", "axes", "", "limits.resetting.reset",
            "Stop the axis at once, empty its buffer, clear its errors, make its position 0 and switch its drive on.",
            "POS(0) = 5\nRESET(0)\nPRINT POS(0)", group="stopping", effect="stop abrupt datum"),
    Keyword("RESETALL", "", "command", "C", "none", "", "limits.resetting.reset_all",
            "RESET for every axis.",
            "POS(0) = 5\nRESETALL\nPRINT POS(0)", group="stopping", effect="stop abrupt all datum"),
    Keyword("DEFAULT", "", "command", "C", "axes", "", "limits.resetting.default",
            "Give every setting of an axis at rest its default again.",
            "SPEED(0) = 5\nDEFAULT(0)\nPRINT SPEED(0)", group="axis", effect="stop abrupt datum"),
    Keyword("DEFAULTALL", "", "command", "C", "none", "", "limits.resetting.default_all",
            "DEFAULT for every axis.",
            "SPEED(1) = 5\nDEFAULTALL\nPRINT SPEED(1)", group="axis", effect="stop abrupt all datum"),
)  # fmt: skip
# What `motionlang.mint.compile.line_triggers` puts before a line at which the machine file lets a fault happen.
HIDDEN = (
    Keyword("(line)", "", "command", "C", "line", "", "limits.line", "The program has come to a line.", group="limits"),
)  # fmt: skip
