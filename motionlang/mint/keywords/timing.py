"""Time and waiting."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

ROWS = (
    Keyword("TIME", "", "setting", "RW", "none", "integer", "time",
            "Milliseconds that count up by themselves from 0 at the start; each task has its own count.",
            "TIME = 0\nWAIT = 250\nPRINT TIME", default=0.0, low=-2147483648.0, high=2147483647.0,
            group="control", solved=True),
    Keyword("WAIT", "WT", "setting", "W", "none", "ms", "wait",
            "Let a time pass before the next statement, written WAIT = ms or WAIT(ms).",
            "WAIT = 100\nWAIT(100)\nPRINT TIME", low=0.0, high=2147483647.0, group="control"),
)  # fmt: skip
