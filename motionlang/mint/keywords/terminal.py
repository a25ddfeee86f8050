"""The terminal: where it prints, and what the operator types."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

ROWS = (
    Keyword("TERMINAL", "tm", "setting", "RW", "none", "bits", "terminal.terminal",
            "The terminals that PRINT and its like mean in this task: 1, 2, 4 and so on up to 128, or several as bits; "
            "0 none. Terminal 1 is the console; the lines of the others are shown with a label.",
            'TERMINAL = _Term2\nPRINT "there"\nTERMINAL = _Term1\nPRINT "here"',
            default=1, low=0, high=255, group="terminal"),
    *(
        Keyword(f"_Term{n}", "", "constant", "R", "none", "integer", str(1 << n - 1),
                f"TERMINAL: terminal {1 << n - 1}.", f"PRINT _Term{n}", group="constants")
        for n in (1, 2, 3)
    ),
    Keyword("INKEY", "ik", "reading", "R", "terminal", "integer", "terminal.key",
            "Code of the next key that the operator has pressed, 0 when there is none; at the terminal in brackets, "
            "or at that of TERMINAL.",
            "PRINT INKEY", default=0.0, group="terminal", driven="key"),
    Keyword("READKEY", "rk", "reading", "R", "none", "integer", "terminal.held_key",
            "Code of the key that the operator holds down, 0 when there is none.",
            "PRINT READKEY", default=0.0, group="terminal", driven="key"),
    Keyword("CLS", "", "command", "C", "terminal", "", "terminal.clear_screen",
            "Clear the terminal's screen (as the ANSI codes that do so).",
            "CLS", group="terminal"),
    Keyword("LOCATE", "", "command", "C", "column, row", "", "terminal.locate",
            "Place the cursor (as the ANSI code that does so); the upper left corner is 1, 1.",
            'LOCATE(1, 2)\nPRINT "second row"', group="terminal"),
    Keyword("LINE", "", "command", "C", "row", "", "line",
            "Print values from the begin of a row of the screen on, with signs and USING as in PRINT.",
            'LINE 2, "speed ", 250', group="terminal"),
    Keyword("BOL", "", "command", "C", "terminal", "", "terminal.line_start",
            "Go to the begin of the line, as Chr(13) does.",
            'PRINT "old",\nBOL\nPRINT "new"', group="terminal"),
    Keyword("BEEP", "", "command", "C", "terminal", "", "terminal.beep",
            "Sound the terminal's bell.",
            "BEEP", group="terminal"),
)  # fmt: skip
