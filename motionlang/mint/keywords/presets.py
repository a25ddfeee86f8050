"""Preset moves of drives: the table of presets, which one is selected, and what starts it."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0
_LONGEST = 2147483647.0
_TWO = "PRESETMOVETYPE(1, 0) = 4 : PRESETMOVEPOSITION(1) = 10\nPRESETMOVETYPE(2, 0) = 3 : PRESETMOVEPOSITION(2) = 0\n"
_RUN = _TWO + "PRESETINDEX(0) = 1\n{}PRESETMOVEENABLE(0) = 1\nPAUSE IDLE(0)\nPRINT POS(0)"


def _row(name: str, index: str, unit: str, verb: str, help: str, example: str, low: float, high: float,
         default: float = 0.0, group: str = "axis", effect: str = "") -> Keyword:  # fmt: skip
    return Keyword(name, "", "setting", "RW", index, unit, f"presets.{verb}", help, example, default=default, low=low,
                   high=high, group=group, effect=effect)  # fmt: skip


def _entry(name: str, unit: str, help: str, low: float, high: float) -> Keyword:
    return _row(name, "preset", unit, "entry", help, f"{name}(1) = 1\nPRINT {name}(1)", low, high)


def _format(
    name: str, unit: str, help: str, high: float, second: str = "format", low: float = 0.0
) -> Keyword:
    return _row(
        name, f"preset, {second}", unit, "format", help, f"{name}(1, 0) = 3\nPRINT {name}(1, 0)", low, high
    )


def _setting(
    name: str, help: str, low: float, high: float, default: float = 0.0, example: str = ""
) -> Keyword:
    example = example or f"{name}(0) = 1\nPRINT {name}(0)"
    return _row(name, "axis", "integer", "setting", help, example, low, high, default, "motion")


ROWS = (
    _format("PRESETMOVETYPE", "integer",
            "What a preset is (number 0 behind it): 1 HOME, 2 JOG, 3 MOVEA, 4 MOVER, 5 POS, 6 SPEEDREF, 7 TORQUEREF, "
            "8 STOP, 9 SUSPEND, 10 CANCEL; 0 nothing.", 10, "parameter"),
    _entry("PRESETMOVEPOSITION", "number", "Where a preset goes, or how far, in user units of its axis.", -_LARGEST,
           _LARGEST),
    _entry("PRESETMOVESPEED", "number", "The speed of a preset that moves or is a speed reference; 0 for SPEED.",
           -_LARGEST, _LARGEST),
    _format("PRESETACCEL", "number",
            "Acceleration of a preset: format 0 a rate, 1 milliseconds from rest to its speed; 0 for ACCEL.", 1e12),
    _format("PRESETDECEL", "number",
            "Deceleration of a preset: format 0 a rate, 1 milliseconds from its speed to rest; 0 for DECEL.", 1e12),
    _entry("PRESETJOGSPEED", "number", "The speed of a preset that jogs; 0 for SPEED.", 0, _LARGEST),
    _entry("PRESETJOGDIRECTION", "integer", "The direction of a preset that jogs: 0 forwards, 1 in reverse.", 0, 1),
    _entry("PRESETMOVEHOMETYPE", "integer", "The type of HOME of a preset that homes.", 0, 9),
    _format("PRESETMOVEPARAMETER", "number", "The percent of a preset that is a torque reference (number 0 behind it).",
            100, "parameter", -100),
    _row("PRESETINDEX", "axis", "integer", "index",
         "The preset that is next; without a trigger input writing it starts it, while PRESETMOVEENABLE is 1.",
         _RUN.format("") + "\nPRESETINDEX(0) = 2\nPAUSE IDLE(0)\nPRINT POS(0)", 0, 63, group="motion", effect="act"),
    _setting("PRESETINDEXMODE",
             "What follows a preset: 0 it stays selected, 1 the next one of the table is selected, 2 that starts by "
             "itself after PRESETDWELLTIME.", 0, 2),
    _setting("PRESETINDEXSOURCE", "What selects a preset: 0 PRESETINDEX, 1 the inputs from PRESETSELECTORINPUT on.", 0,
             1),
    _setting("PRESETDWELLTIME", "Milliseconds of rest between presets that follow each other by themselves.", 0,
             _LONGEST),
    _setting("PRESETSELECTORINPUT", "The first of the inputs that select a preset, the lowest bit of its number; -1 "
                                    "for none.", -1, 999, -1.0),
    _setting("PRESETINPUTSMAX", "How many inputs select a preset.", 0, 6, 4.0),
    Keyword("PRESETINPUTSTATE", "", "reading", "R", "axis", "integer", "presets.inputs",
            "The preset that the inputs select now.", "PRESETSELECTORINPUT(0) = 4\nPRINT PRESETINPUTSTATE(0)",
            default=0.0, group="state"),
    _setting("PRESETTRIGGERINPUT", "The input whose becoming active starts the preset that is selected; -1 for none.",
             -1, 999, -1.0),
    _row("PRESETMOVEENABLE", "axis", "bool", "setting",
         "Whether presets start; without a trigger input 1 starts the one that is selected.", _RUN.format(""), 0, 1,
         group="motion", effect="hands-over"),
)  # fmt: skip
