"""What the virtual controller knows of itself: what it is, what it has, and that nothing of it is broken.

The machine file can give each of them another answer, in its section `[mint.readings]`.
"""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

# What NUMBEROF counts.
AXES = 0


def _word(
    name: str,
    short: str,
    access: str,
    index: str,
    unit: str,
    verb: str,
    help: str,
    default: float | None = 0.0,
) -> Keyword:
    where = "" if index == "none" else "(0)"
    kind = "setting" if "W" in access else "reading"
    return Keyword(name, short, kind, access, index, unit, f"identity.{verb}", help, f"PRINT {name}{where}",
                   default=None if unit == "text" else default, group="identity")  # fmt: skip


def _fine(name: str, short: str, access: str, index: str, unit: str, help: str) -> Keyword:
    given = " Writing it clears nothing." if "W" in access else ""
    return _word(name, short, access, index, unit, "nothing_wrong", f"{help} 0: nothing went wrong.{given}")


ROWS = (
    _word("PLATFORMNAME", "", "R", "none", "text", "platform",
          "The controller: controller.model of the machine file, or Virtual Controller."),
    _word("FIRMWAREVERSION", "", "R", "none", "text", "version", "The version of this program."),
    _word("NUMBEROF", "no", "R", "item", "integer", "count",
          "How many there are of something: _noAXES counts the axes; of other things the machine file knows.",
          default=None),
    Keyword("_noAXES", "", "constant", "R", "none", "integer", str(AXES), "NUMBEROF: axes.", "PRINT NUMBEROF(_noAXES)",
            group="constants"),
    Keyword("_egCONTROLLER", "", "constant", "R", "none", "integer", "3",
            "ERRORPRESENT and its family: errors of the controller, as _egMISC.", "PRINT _egCONTROLLER",
            group="constants"),
    _word("AXISBUS", "", "R", "axis", "integer", "local", "The bus of an axis: 0, as every axis is local."),
    _word("AXISNODE", "", "R", "axis", "integer", "local",
          "The node of an axis: 0, as every axis is local."),
    _word("MINTEXECUTING", "", "R", "none", "bool", "fit", "1: the program runs.", 1.0),
    _word("SUPPORTSMINT", "", "R", "none", "bool", "fit", "1: the controller runs programs.", 1.0),
    _word("PHASESEARCHSTATUS", "", "R", "axis", "bool", "fit_axis", "1: the motor is commutated.", 1.0),
    _fine("INITERROR", "", "RW", "none", "bits", "Errors of the start of the controller."),
    _fine("INITWARNING", "", "RW", "none", "bits", "Warnings of the start of the controller."),
    Keyword("AVERAGEVEL", "", "reading", "R", "axis", "uu/s", "velocity",
            "Velocity of the axis as VEL has it: there is no noise of which to take the average.",
            "JOG(0) = 100\nWAIT = 100\nPRINT AVERAGEVEL(0)\nSTOP(0)", default=0.0, group="state"),
    Keyword("OKTOLOADMOVE", "", "reading", "R", "count, array", "bool", "identity.takes_moves",
            "1 when the axes in an array, so many of them, take a move now: there is room, and none is in error, "
            "switched off or stopping.",
            "Dim a(2) As Integer = 0, 1\nPRINT OKTOLOADMOVE(2, a)", default=1.0, group="state"),
    Keyword("REALTIMECLOCK", "", "setting", "RW", "none", "text", "identity.date",
            "Date and time, 2000-01-01 00:00:00 at power-up until it is set; [mint.readings] gives another begin. It "
            "goes with machine time.",
            'REALTIMECLOCK = "2026-11-20 06:30:00"\nWAIT = 2000\nPRINT REALTIMECLOCK', group="identity"),
    Keyword("NOP", "", "command", "C", "none", "", "identity.nothing", "Do nothing.", "NOP", group="control"),
    *(
        Keyword(name, "", "command", "C", "none", "", "identity.nothing", help, name, group="terminal")
        for name, help in (
            ("TRON", "Line trace on: MintMT has the word for old programs and does nothing."),
            ("TROFF", "Line trace off: MintMT has the word for old programs and does nothing."),
            ("BEEPON", "Key clicks on: nobody hears them here."),
            ("BEEPOFF", "Key clicks off: nobody hears them here."),
        )
    ),
)  # fmt: skip
