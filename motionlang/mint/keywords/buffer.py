"""The move buffer: marks, levels, what starts its moves, and entries that are no moves."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0

_TRIGGERS = (
    ("AUTO", "a move starts as soon as it is loaded"),
    ("GO", "moves start at GO"),
    ("INPUT", "moves start when the input TRIGGERINPUT becomes active"),
    ("POSITION", "moves start when the axis or encoder TRIGGERCHANNEL passes TRIGGERVALUE"),
)
_CONSTANTS = tuple(
    Keyword(f"_tr{name}", "", "constant", "R", "none", "integer", str(value), f"TRIGGERMODE: {help}.",
            f"PRINT _tr{name}", group="constants")
    for value, (name, help) in enumerate(_TRIGGERS)
)  # fmt: skip


def _trigger(name: str, verb: str, unit: str, help: str, low: float, high: float, default: float) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, verb, help, f"{name}(0) = 1\nPRINT {name}(0)",
                   default=default, low=low, high=high, group="buffer")  # fmt: skip


ROWS = (
    *_CONSTANTS,
    Keyword("MOVEBUFFERID", "MBI", "setting", "RW", "axis", "integer", "move_id",
            "The mark that moves loaded from now on carry, a number of 16 bits.",
            "MOVEBUFFERID(0) = 7\nMOVER(0) = 10\nGO(0)\nPRINT MOVEBUFFERIDLAST(0)",
            default=0.0, low=-32768.0, high=32767.0, group="buffer"),
    Keyword("MOVEBUFFERIDLAST", "", "reading", "R", "axis", "integer", "buffer.last_id",
            "The mark of the move that is executing, or of the last one.",
            "MOVEBUFFERID(0) = 7\nMOVER(0) = 10\nGO(0)\nPRINT MOVEBUFFERIDLAST(0)", default=0.0, group="buffer"),
    Keyword("MOVEBUFFERSTATUS", "MBS", "reading", "R", "axis", "bits", "buffer.status",
            "Status of the moves: bit 0 the move has a speed of its own (FEEDRATEMODE), 1 the override holds for it, "
            "2 it is run through as a contour, 3 the buffer is empty, 4 full, 5 suspended and at rest, 6 the move ends "
            "at rest because of the angle to the next.",
            "MOVER(0) = 10\nPRINT MOVEBUFFERSTATUS(0)\nGO(0)", default=8.0, low=0, high=119, group="buffer"),
    Keyword("MOVEBUFFERLOW", "", "setting", "RW", "axis", "integer", "buffer_low",
            "The event MBLOW comes when an entry leaves the buffer and more places than this are free; -1 for never.",
            "MOVEBUFFERLOW(0) = 1\nPRINT MOVEBUFFERLOW(0)", default=-1.0, low=-1, high=100, group="buffer"),
    Keyword("TRIGGERMODE", "", "setting", "RW", "axis", "integer", "buffer.trigger",
            "What starts moves: _trAUTO at once when they are loaded, _trGO at GO, _trINPUT at the input TRIGGERINPUT, "
            "_trPOSITION when TRIGGERCHANNEL passes TRIGGERVALUE. GO starts them in every mode.",
            "TRIGGERMODE(0) = _trAUTO\nMOVER(0) = 10\nPAUSE IDLE(0)\nPRINT POS(0)",
            default=1.0, low=0, high=3, group="buffer", effect="hands-over switch"),
    _trigger("TRIGGERINPUT", "buffer.trigger", "integer", "The input that starts moves; -1 for none.", -1, 999,
             -1.0),
    _trigger("TRIGGERSOURCE", "buffer.trigger", "integer",
             "What TRIGGERCHANNEL is: 0 an axis, 1 an encoder, 2 an auxiliary encoder.", 0, 2, 0.0),
    _trigger("TRIGGERCHANNEL", "buffer.trigger", "integer", "The axis or encoder whose position starts moves.",
             0, 999, 0.0),
    _trigger("TRIGGERVALUE", "buffer.trigger", "number",
             "The position, in units of TRIGGERCHANNEL, whose passing starts moves.", -_LARGEST, _LARGEST, 0.0),
    Keyword("MOVEDWELL", "", "move", "W", "axis", "ms", "buffer.dwell",
            "Put a rest of some milliseconds between moves into the buffer.",
            "MOVER(0) = 10\nMOVEDWELL(0) = 250\nGO(0)\nPAUSE IDLE(0)\nPRINT TIME >= 250",
            low=0, high=2147483647.0, group="motion", effect="entry"),
    Keyword("MOVEOUT", "", "move", "W", "axis, bank", "bits", "buffer.out",
            "Set a bank of outputs between two moves of the buffer.",
            "MOVER(0) = 10\nMOVEOUT(0, 0) = 5\nGO(0)\nPAUSE IDLE(0)\nPRINT OUT(0)", group="motion", effect="entry"),
    Keyword("MOVEOUTX", "", "move", "W", "axis, channel", "bool", "buffer.out_bit",
            "Set one output between two moves of the buffer.",
            "MOVER(0) = 10\nMOVEOUTX(0, 3) = _ON\nGO(0)\nPAUSE IDLE(0)\nPRINT OUTX(3)", group="motion", effect="entry"),
    Keyword("MOVEPULSEOUTX", "", "move", "W", "axis, channel", "ms", "buffer.pulse",
            "Turn an output on for some milliseconds, between two moves of the buffer; they do not wait for its end.",
            "MOVER(0) = 10\nMOVEPULSEOUTX(0, 3) = 50\nGO(0)\nPAUSE IDLE(0)\nPRINT OUTX(3)\nWAIT = 50\nPRINT OUTX(3)",
            low=0, high=2147483647.0, group="motion", effect="entry"),
)  # fmt: skip
