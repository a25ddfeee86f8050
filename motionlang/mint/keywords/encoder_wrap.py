"""How often wrapped positions have begun again, and motion that older controllers have words for."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_ROUND = "POSWRAP(0) = 360\nMOVER(0) = 800\nGO(0)\nPRINT {0}(0)\nPAUSE IDLE(0)\nPRINT {0}(0)"


def _turns(name: str, verb: str, help: str) -> Keyword:
    return Keyword(name, "", "reading", "R", "axis", "integer", verb, help, _ROUND.format(name), default=0.0,
                   group="state")  # fmt: skip


ROWS = (
    _turns("POSROLLOVERDEMAND", "encoder_wrap.demand", "How many times POSDEMAND has wrapped."),
    _turns("POSROLLOVERTARGET", "encoder_wrap.target", "How many times POS will have wrapped when the move is over."),
    _turns("POSROLLOVERTARGETLAST", "encoder_wrap.last_target",
           "How many times POS will have wrapped when the buffer is empty."),
    Keyword("DATUM", "", "command", "C", "axes", "", "encoder_wrap.datum",
            "Find the encoder's index in reverse, which is HOME of type _hmNEGATIVE_INDEX (v3).",
            "If HOMEINPUT(0) >= 0 Then DATUM(0)\nPAUSE IDLE(0)\nPRINT HOMESTATUS(0)",
            group="motion", effect="act datum"),
    Keyword("FREQ", "", "setting", "RW", "axis", "number", "encoder_wrap.frequency",
            "Run at a constant number of pulses a second, its sign the direction, until stopped or told another one.",
            "FREQ(0) = 100\nWAIT = 500\nSTOP(0)\nPAUSE IDLE(0)\nPRINT FREQ(0)",
            default=0.0, low=-8388607.0, high=8388607.0, group="motion", effect="act"),
)  # fmt: skip
