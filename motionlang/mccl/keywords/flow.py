"""Repeating, waiting, jumping, deciding."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("flow")
_row = _G.row

ROWS = (
    _row("RP", "statement", "W", "none", "number", "repeat",
         "Repeat the line, or the macro, up to here n more times; without a number, or with 0, for ever.",
         "AL1,TR0,RP2", meant="REPEAT"),
    _row("WA", "statement", "W", "none", "s", "wait", "Wait for a time.", "WA0.5", low=0, meant="WAIT"),
    _row("WS", "statement", "W", "axes", "s", "wait_stop",
         "Wait for stop: until the trajectory is complete, then for a time.", "1WS0.1", low=0, meant="WAIT IDLE"),
    _row("WT", "statement", "W", "axes", "s", "wait_target",
         "Wait for target: until the axis has been in the deadband for DT, then for a time.", "1WT0.1", low=0,
         meant="WAIT"),
    _row("WP", "statement", "W", "axis", "uu", "wait_position", "Wait until the axis passes a position.",
         "1MN,1MR1000,1WP500"),
    _row("WR", "statement", "W", "axis", "uu", "wait_relative",
         "Wait until the axis has moved this far from where it is now.", "1MN,1MR1000,1WR500"),
    _row("WE", "statement", "W", "axis", "bool", "wait_edge",
         "Wait for the coarse home switch: 0 on, 1 off; completes EL.", "1WE1", low=0, high=1),
    _row("WI", "statement", "C", "axis", "", "wait_index", "Wait for the index mark; completes IA. "
         "The machine file says where marks are (index_every).",
         "1MN,1MR5000,1IA,1WI"),
    _row("JP", "statement", "W", "none", "number", "jump", "Jump to command n of the line or macro; the first is 0.",
         "AL5,JP3,AL6,TR0", low=0),
    _row("JR", "statement", "W", "none", "number", "jump_by", "Jump n commands on from this one, or back.",
         "AL5,JR2,AL6,TR0"),
    _row("IB", "statement", "W", "none", "number", "if_below",
         "If the accumulator is below n carry out the next two commands, else skip them.", "AL5,IB6,AL7,NO,TR0"),
    _row("IE", "statement", "W", "none", "number", "if_equal",
         "If the accumulator equals n carry out the next two commands, else skip them.", "AL5,IE5,AL7,NO,TR0"),
    _row("IG", "statement", "W", "none", "number", "if_greater",
         "If the accumulator is greater than n carry out the next two commands, else skip them.", "AL5,IG4,AL7,NO,TR0"),
    _row("IU", "statement", "W", "none", "number", "if_unequal",
         "If the accumulator does not equal n carry out the next two commands, else skip them.", "AL5,IU4,AL7,NO,TR0"),
    _row("IS", "statement", "W", "none", "number", "if_set",
         "If bit n of the accumulator is set carry out the next two commands, else skip them.", "AL5,IS2,AL7,NO,TR0",
         low=0, high=31),
    _row("IC", "statement", "W", "none", "number", "if_clear",
         "If bit n of the accumulator is clear carry out the next two commands, else skip them.", "AL5,IC1,AL7,NO,TR0",
         low=0, high=31),
    _row("NO", "statement", "C", "none", "", "nothing",
         "No operation; what fills up the two commands that a condition governs.",
         "NO"),
)  # fmt: skip
