"""Positions that are caught at an edge, and outputs that are switched at a position."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_ARMED = "LATCHTRIGGERCHANNEL(0) = 3\nLATCHENABLE(0) = 1\nPRINT {}(0)"
_FAST = "FASTSELECT(0) = 3\nFASTENABLE(0) = 1\nPRINT {}(0)"


def _setting(
    name: str, sets: str, index: str, unit: str, value: str, help: str, high: float, default: float = 0.0
) -> Keyword:
    return Keyword(name, "", "setting", "RW", index, unit, f"latches.setting.{sets}", help,
                   f"{name}(0) = {value}\nPRINT {name}(0)", default=default, low=0, high=high,
                   group="latches")  # fmt: skip


def _reading(name: str, index: str, unit: str, verb: str, help: str, example: str) -> Keyword:
    return Keyword(name, "", "reading", "R", index, unit, verb, help, example.format(name), default=0.0,
                   group="latches")  # fmt: skip


def _compare(name: str, sets: str, help: str, low: float, high: float, default: float) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", "integer", f"latches.position_compare.{sets}", help,
                   f"{name}(0) = 1\nPRINT {name}(0)", default=default, low=low, high=high, group="latches")  # fmt: skip


ROWS = (
    _setting("LATCHTRIGGERMODE", "trigger_mode", "latch", "integer", "1",
             "What triggers a latch: 0 an input, 1 the encoder's index.", 1),
    _setting("LATCHTRIGGERCHANNEL", "input", "latch", "integer", "3", "The input that triggers a latch.", 999),
    _setting("LATCHTRIGGEREDGE", "edge", "latch", "integer", "2",
             "The edge that triggers a latch: 0 becoming active, 1 becoming inactive, 2 both.", 2),
    _setting("LATCHSOURCE", "source", "latch", "integer", "1",
             "What a latch catches: 0 the position of an axis in user units, 1 what its encoder has counted.", 1),
    _setting("LATCHSOURCECHANNEL", "axis", "latch", "integer", "1", "The axis whose position a latch catches.", 63),
    _setting("LATCHMODE", "again", "latch", "integer", "1",
             "0: a latch catches once and must be enabled again; 1: it stays enabled, and reading LATCH resets it.", 1),
    _setting("LATCHINHIBITTIME", "inhibit_time", "latch", "ms", "20",
             "How long after an edge a latch ignores further ones.", 2147483647),
    _setting("LATCHINHIBITVALUE", "inhibit_distance", "latch", "uu", "5",
             "How far the axis must be from the position caught last before an edge counts again.", 8388607.0),
    Keyword("LATCHENABLE", "", "setting", "RW", "latch", "bool", "latches.enable",
            "Arm a latch; it forgets what it had caught.",
            _ARMED.format("LATCHENABLE"), default=0.0, low=0, high=1, group="latches"),
    _reading("LATCH", "latch", "bool", "latches.caught", "1 when a latch has caught a position.", _ARMED),
    _reading("LATCHVALUE", "latch", "number", "latches.value", "What a latch has caught.", _ARMED),
    _setting("FASTSELECT", "input", "axis", "integer", "3", "The input that triggers the fast latch of the axis.", 999),
    Keyword("FASTENABLE", "", "setting", "W", "axis", "integer", "latches.enable",
            "Arm the fast latch of the axis; it forgets what it had caught.",
            _FAST.format("FASTLATCH"), low=0, high=1, group="latches"),
    _setting("FASTLATCHEDGE", "edge", "axis", "bool", "1",
             "0: the input triggers when it becomes active; 1: inactive.", 1),
    _setting("FASTLATCHMODE", "again", "axis", "integer", "1", "0: the fast latch catches once; 1: it stays armed.", 1),
    _setting("FASTLATCHDISTANCE", "inhibit_distance", "axis", "uu", "5",
             "How far the axis must be from the position caught last before an edge counts again.", 8388607.0),
    _reading("FASTLATCH", "axis", "bool", "latches.caught", "1 when the fast latch of the axis has caught.", _FAST),
    _reading("FASTPOS", "axis", "number", "latches.value", "The position that the fast latch has caught.", _FAST),
    _reading("FASTENCODER", "axis", "number", "latches.encoder",
             "What the encoder had counted when the fast latch caught.", _FAST),
    _compare("COMPAREMODE", "mode",
             "0: the output comes on at position 0 and stays on; 1: it is on between positions 0 and 1.", 0, 1, 0.0),
    _compare("COMPAREOUTPUT", "output",
             "The output that the position compare of the axis switches; -1 for none.", -1, 999, -1.0),
    Keyword("COMPAREPOS", "", "setting", "RW", "axis, register", "uu", "latches.position_compare.position",
            "The positions with which the axis is compared: registers 0 and 1.",
            "COMPAREPOS(0, 1) = 25\nPRINT COMPAREPOS(0, 1)",
            default=0.0, low=-8388607.0, high=8388607.0, group="latches"),
    Keyword("COMPAREENABLE", "", "setting", "RW", "output", "bool", "latches.position_compare.enable",
            "Whether the position compare switches an output.",
            "COMPAREOUTPUT(0) = 2\nCOMPAREENABLE(2) = 1\nPRINT COMPAREENABLE(2)",
            default=0.0, low=0, high=1, group="latches"),
    _reading("COMPARELATCH", "axis", "bool", "latches.position_compare.passed",
             "1 when the axis has been at a compare position since the compare was enabled.", "PRINT {}(0)"),
)  # fmt: skip
