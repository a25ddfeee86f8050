"""HTA: hold to analogue, an axis that is moved so that an analogue input holds its value."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0


def _setting(name: str, unit: str, help: str, low: float, high: float, default: float = 0.0,
             short: str = "") -> Keyword:  # fmt: skip
    example = f"{name}(0) = 0\nPRINT {name}(0)"
    return Keyword(name, short, "setting", "RW", "axis", unit, "hold_to_analogue.setting", help, example,
                   default=default, low=low, high=high, group="axis")  # fmt: skip


def _gain(name: str, help: str, short: str = "") -> Keyword:
    return _setting(name, "number", help, -_LARGEST, _LARGEST, short=short)


ROWS = (
    Keyword("HTA", "", "setting", "RW", "axis", "%", "hold_to_analogue.hold",
            "Hold to analogue: move the axis so that the analogue input HTACHANNEL comes to this value, percent, and "
            "keeps it, at SPEED at most, until STOP or CANCEL. The axis must be idle and without error; while it holds "
            "it takes a further HTA and no other motion. No GO is needed. It reads the value that is held, or was "
            "last.",
            "HTACHANNEL(0) = 1 : HTAKPROP(0) = 2\nHTA(0) = 25\nWAIT = 200\nPRINT VEL(0)\nSTOP(0)",
            default=0.0, low=-100.0, high=100.0, group="motion", effect="act"),
    _setting("HTACHANNEL", "integer", "The analogue input that HTA holds.", 0, 63),
    _gain("HTAKPROP", "User units a second for each percent of error (wanted minus measured); negative to turn the "
                      "direction round.", "HKP"),
    _gain("HTADAMPING", "User units a second for each percent by which the error changes in a tick of the profiler."),
    _gain("HTAKINT", "User units a second for each percent of the errors of all ticks, summed; the sum begins anew "
                     "within HTADEADBAND and when this is written."),
    _setting("HTADEADBAND", "number", "An error up to this is none: counts of the converter, 4096 of which are the "
                                      "range of the input.", 0, 100, short="HDB"),
    _setting("HTAFILTER", "number", "How much of the filtered value of the tick before goes into the next one, 0 to 1: "
                                    "0 does not filter.", 0, 0.9999),
)  # fmt: skip
