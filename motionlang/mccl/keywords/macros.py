"""Macros and background tasks."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("macros and tasks")
_row = _G.row

ROWS = (
    _row("MD", "statement", "W", "none", "number", "define_macro",
         "Define macro n as the rest of the line; must come first in its line.", "MD1,1MN,1MR1000"),
    _row("MC", "statement", "W", "none", "number", "call_macro", "Call macro n and come back.",
         "MD1,AL5\nMC1,TR0"),
    _row("MJ", "statement", "W", "none", "number", "jump_macro", "Jump to macro n and do not come back.",
         "MD1,AL5,TR0\nMJ1"),
    _row("RM", "command", "C", "none", "", "reset_macros", "Forget all macros.", "RM"),
    _row("GT", "statement", "W", "none", "number", "start_task",
         "Run macro n as a background task; its number is then in the accumulator.", "MD1,WA0.1\nGT1,TR0",
         family="tasks"),
    _row("ET", "statement", "W", "none", "number", "end_task", "End a background task.", "MD1,WA9\nGT1,ET@0", low=0,
         family="tasks"),
    _row("BK", "statement", "C", "none", "", "leave", "Leave the macro, or the line.", "AL5,BK,AL6"),
)  # fmt: skip
