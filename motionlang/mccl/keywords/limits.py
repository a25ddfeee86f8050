"""Limits and faults."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("limits")
_row = _G.row

ROWS = (
    _row("LM", "setting", "W", "axes", "bits", "limit_mode",
         "What a limit does: hard 0 motor off, 1 abrupt stop, 2 smooth stop, +128 inverted switches; "
         "soft +0 motor off, +4 abrupt, +8 smooth.", "1LM10", default=0, low=0, high=255),
    _row("LN", "command", "W", "axes", "bits", "limits_on",
         "Enable limits: 1 hard +, 2 hard -, 4 soft high, 8 soft low; 0 all.", "1LN3", low=0, high=15),
    _row("LF", "command", "W", "axes", "bits", "limits_off",
         "Disable limits: 1 hard +, 2 hard -, 4 soft high, 8 soft low; 0 all.", "1LF12", low=0, high=15),
    _row("HL", "setting", "W", "axes", "uu", "soft_high", "Set the high soft limit.", "1HL50000", default=0),
    _row("LL", "setting", "W", "axes", "uu", "soft_low", "Set the low soft limit.", "1LL-50000", default=0),
    _row("FN", "command", "W", "axes", "", "amplifier_fault_on",
         "Watch the amplifier-fault input: when it comes on the motor is switched off.", "1FN0"),
    _row("FF", "command", "C", "axes", "", "amplifier_fault_off", "Do not watch the amplifier-fault input.", "1FF"),
)  # fmt: skip
