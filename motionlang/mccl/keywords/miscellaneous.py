"""The rest: how the controller talks, and words of which little but the name is known."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("miscellaneous")
_row, _known = _G.row, _G.known

ROWS = (
    _row("DM", "command", "C", "none", "", "decimal", "Decimal replies.", "DM"),
    _row("HM", "command", "C", "none", "", "hexadecimal", "Hexadecimal replies of whole numbers.", "HM,1TS"),
    _row("EF", "command", "C", "none", "", "echo_off", "Echo off.", "EF"),
    _row("EN", "command", "C", "none", "", "echo_on", "Echo on.", "EN"),
    _row("PC", "command", "W", "none", "number", "prompt_character",
         "Set the character code of the prompt; 0 for none.", "PC62", low=0, high=126),
    _row("XN", "command", "W", "none", "number", "xon_code",
         "Set the code that lets the controller send; 0 for none.",
         "XN17", low=0, high=255),
    _row("XF", "command", "W", "none", "number", "xoff_code", "Set the code that stops the controller sending; 0 for "
         "none.", "XF19", low=0, high=255),
    _known("DW", "command", "none", "Disable the watchdog; there is none here."),
    _known("FM", "command", "none", "Only the name is known, perhaps float mode."),
    _row("OT", "command", "W", "none", "text", "put_text", "Put out a line of text; the form of the text is ours.",
         'OT"ready"'),
    _row("FT", "command", "W", "none", "text", "put_whole",
         "Put out a line of text with the accumulator as a whole number in it (%d, %x); the form is ours.",
         'AL12,FT"parts: %4d"'),
    _row("FD", "command", "W", "none", "text", "put_real",
         "Put out a line of text with the accumulator as a real number in it (%f, %e, %g); the form is ours.",
         'AL1,AD3.0,FD"%.3f mm"'),
    _known("CB", "command", "axis", "Capture positions; where the captured ones are read is not known."),
    _known("BC", "command", "axis", "Begin position compare; the output it switches is not known."),
    _known("LC", "command", "axis", "Load a position to compare with; the output it switches is not known."),
    _known("NC", "command", "axis", "No position compare any more."),
    _known("OC", "command", "axis", "Output of position compare: 0 none, 1 static, 2 toggle, 3 one-shot, 5 strobe."),
    _known("OP", "command", "axis", "Period of the one-shot output of position compare."),
    _known("YF", "command", "axis", "Digital filter on."),
    _known("NF", "command", "axis", "Digital filter off."),
    _known("ZF", "command", "axis", "Digital filter cleared."),
    _known("FL", "command", "axis", "Digital filter coefficients loaded."),
)  # fmt: skip
