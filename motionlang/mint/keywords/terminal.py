"""The terminal: where it prints, and what the operator types."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LIBRARY = "Mint type library"

ROWS = (
    Keyword("INKEY", "ik", "reading", "R", "none", "integer", "terminal.key",
            "Code of the next key that the operator has pressed, 0 when there is none.",
            "PRINT INKEY", default=0.0, source=_LIBRARY, trust="code", group="terminal"),
    Keyword("READKEY", "rk", "reading", "R", "none", "integer", "terminal.held_key",
            "Code of the key that the operator holds down, 0 when there is none.",
            "PRINT READKEY", default=0.0, source=_LIBRARY, trust="code", group="terminal"),
    Keyword("CLS", "", "command", "C", "none", "", "clear_screen",
            "Clear the terminal's screen (as the ANSI codes that do so).",
            "CLS", source=_LIBRARY, trust="memory", group="terminal"),
    Keyword("LOCATE", "", "command", "C", "column, row", "", "locate",
            "Place the cursor (as the ANSI code that does so); the upper left corner is 1, 1.",
            'LOCATE(1, 2)\nPRINT "second row"', source=_LIBRARY, trust="memory", group="terminal"),
    Keyword("LINE", "", "command", "C", "row", "", "line",
            "Print values from the begin of a row of the screen on.",
            'LINE 2, "speed ", 250', source="MN1955 contents", trust="memory", group="terminal"),
    Keyword("BOL", "", "command", "C", "none", "", "line_start",
            "Go to the begin of the line, as Chr(13) does.",
            'PRINT "old",\nBOL\nPRINT "new"', source="symbol table of a Baldor drive", trust="code",
            group="terminal"),
    Keyword("BEEP", "", "command", "C", "none", "", "beep",
            "Sound the terminal's bell.",
            "BEEP", source=_LIBRARY, trust="memory", group="terminal"),
)  # fmt: skip
