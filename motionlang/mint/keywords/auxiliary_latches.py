"""Latches of auxiliary encoders, and index marks."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_FAST = "FASTAUXSELECT(0) = 3\nFASTAUXENABLE(0) = 1\nPRINT {}(0)"
_MARK = "AUXENCODERZEROENABLE(0) = 1\nPRINT {}(0)"


def _setting(name: str, unit: str, verb: str, value: str, help: str, high: float) -> Keyword:
    return Keyword(name, "", "setting", "RW", "auxchannel", unit, f"auxiliary_latches.{verb}", help,
                   f"{name}(0) = {value}\nPRINT {name}(0)", default=0.0, low=0, high=high, group="latches")  # fmt: skip


def _reading(name: str, short: str, index: str, unit: str, verb: str, help: str, example: str) -> Keyword:  # fmt: skip
    return Keyword(name, short, "reading", "R", index, unit, f"auxiliary_latches.{verb}", help, example.format(name),
                   default=0.0, group="latches")  # fmt: skip


def _enable(name: str, verb: str, help: str, example: str) -> Keyword:
    return Keyword(name, "", "setting", "W", "auxchannel", "bool", f"auxiliary_latches.{verb}", help, example,
                   low=0, high=1, group="latches")  # fmt: skip


ROWS = (
    _setting("FASTAUXSELECT", "integer", "setting.input", "3",
             "The input that triggers the latch of an auxiliary encoder.", 999),
    _enable("FASTAUXENABLE", "enable", "Arm the latch of an auxiliary encoder; it forgets what it had caught.",
            _FAST.format("FASTAUXLATCH")),
    _setting("FASTAUXLATCHEDGE", "bool", "setting.edge", "1",
             "0: the input triggers when it becomes active; 1: inactive.", 1),
    _setting("FASTAUXLATCHMODE", "integer", "setting.again", "1", "0: the latch catches once; 1: it stays armed.", 1),
    _setting("FASTAUXLATCHDISTANCE", "number", "setting.inhibit_distance", "5",
             "How far the encoder must be from the position caught last before an edge counts again.", 8388607.0),
    _reading("FASTAUXLATCH", "", "auxchannel", "bool", "caught", "1 when the latch of an auxiliary encoder has caught.",
             _FAST),
    _reading("FASTAUXENCODER", "", "auxchannel", "number", "encoder", "What AUXENCODER was when its latch caught.",
             _FAST),
    _reading("ENCODERZLATCH", "", "channel", "bool", "passed",
             "1 when an encoder has passed an index mark since this was read last.",
             "MOVER(0) = 100\nGO(0)\nPRINT ENCODERZLATCH(0)"),
    _reading("AUXENCODERZLATCH", "aez", "auxchannel", "bool", "aux_passed",
             "1 when an auxiliary encoder has passed an index mark since this was read last.", _MARK),
    _enable("AUXENCODERZEROENABLE", "zero_enable", "Catch the position of an auxiliary encoder at its next index mark.",
            _MARK.format("AUXENCODERZEROPOSITION")),
    _setting("AUXENCODERZEROLATCHMODE", "integer", "zero_mode", "1",
             "0: AUXENCODERZEROENABLE is for one mark; 1: for every one from then on.", 1),
    _reading("AUXENCODERZEROPOSITION", "", "auxchannel", "number", "zero_place",
             "What AUXENCODER was at the index mark.", _MARK),
)  # fmt: skip
