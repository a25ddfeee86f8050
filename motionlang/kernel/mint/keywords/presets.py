"""Preset moves: a table of motions, started by an input or by the program."""

from __future__ import annotations

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL, Inputs, checked
from motionlang.kernel.mint.keywords.presets_moves import begin
from motionlang.kernel.mint.runtime.binding import of, of_word
from motionlang.kernel.mint.runtime.environment import Environment

LAST_PRESET = 63
STAYS, STEPS, GOES_ON = range(3)
BY_PROGRAM, BY_INPUTS = range(2)
# Defaults other than 0 of the settings of an axis.
DEFAULTS = {"PRESETTRIGGERINPUT": -1, "PRESETSELECTORINPUT": -1, "PRESETINPUTSMAX": 4}
# The shortest rest in seconds between two presets that run in sequence.
_MIN_TIME = 1e-3


class Presets(StoredSettings):
    """The table of presets and the settings that start them.

    The table is stored by keyword, preset and format, in user units. The start settings are stored by keyword and
    axis.
    """

    defaults = DEFAULTS

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.table: dict[tuple[str, int, int], float] = {}
        self._lines: dict[int, int] = {}
        # Axes that continue with the next preset by themselves, each with the number of the start before it.
        # A rest that began after another start, before presets were disabled and enabled again, has no effect.
        self._going_on: dict[int, int] = {}
        self._starts = 0
        environment.component(Inputs).listeners.append(self._changed)
        self.controller.listeners.append(self._on_event, "idle")

    def entry(self, name: str, preset: int, format: int = 0) -> float:
        return self.table.get((name, preset, format), 0.0)

    def choose(self, row: Keyword, axis: int, value: int, line: int) -> None:
        """Write a start setting.

        If no input is set as the trigger, a preset starts when presets are enabled or another one is selected.
        """
        name = row.name
        if name.endswith("INPUT") and value >= 0:
            checked(value, LAST_CHANNEL)
        before = self.setting(name, axis)
        self.set(name, axis, int(value))
        enabled = self.setting("PRESETMOVEENABLE", axis)
        if name == "PRESETMOVEENABLE":
            if value == before:
                return
            self._going_on.pop(axis, None)
        if name in ("PRESETMOVEENABLE", "PRESETINDEX"):
            self._lines[axis] = line
            if enabled and self.setting("PRESETTRIGGERINPUT", axis) < 0:
                self.start(axis)

    def inputs(self, axis: int) -> int:
        """Return the binary number on the selector inputs."""
        first, count = (int(self.setting(name, axis)) for name in ("PRESETSELECTORINPUT", "PRESETINPUTSMAX"))
        if first < 0:
            return 0
        is_on = self.environment.component(Inputs).is_on
        return sum(1 << k for k in range(count) if is_on(first + k))

    def selected(self, axis: int) -> int:
        """Return the next preset."""
        by_inputs = self.setting("PRESETINDEXSOURCE", axis) == BY_INPUTS
        return self.inputs(axis) if by_inputs else int(self.setting("PRESETINDEX", axis))

    def start(self, axis: int) -> None:
        """Start the selected preset, and select the next one if the mode requires it."""
        preset, mode = self.selected(axis), self.setting("PRESETINDEXMODE", axis)
        self._going_on.pop(axis, None)
        begin(self, axis, preset, self._lines.get(axis, 0))
        if mode != STAYS:
            self._settings["PRESETINDEX", axis] = self._after(preset)
        if mode == GOES_ON:
            self._starts += 1
            self._going_on[axis] = self._starts
            if self.controller.is_idle(axis):
                self._rest(axis)

    def _after(self, preset: int) -> int:
        """Return the next defined preset of the table; the first follows the last."""
        known = sorted(
            number for (name, number, _), kind in self.table.items() if name == "PRESETMOVETYPE" and kind
        )
        return next((number for number in known if number > preset), known[0] if known else preset)

    def _changed(self, channel: int, on: bool) -> None:
        for name, axis in list(self._settings):
            enabled = name == "PRESETMOVEENABLE" and self._settings[name, axis]
            if on and enabled and self.setting("PRESETTRIGGERINPUT", axis) == channel:
                self._start(axis)

    def _on_event(self, what: str, axis: int) -> None:
        if what == "idle" and axis in self._going_on:
            self._rest(axis)

    def _rest(self, axis: int) -> None:
        """Dwell for PRESETDWELLTIME, then continue."""
        clock = self.environment.clock
        seconds = max(self.setting("PRESETDWELLTIME", axis) / 1000.0, _MIN_TIME)
        follows = self._going_on[axis]
        clock.at(clock.now + seconds, lambda: self._go_on(axis, follows))

    def _go_on(self, axis: int, follows: int) -> None:
        if self._going_on.get(axis) == follows and self.controller.is_idle(axis):
            self._start(axis)

    def _start(self, axis: int) -> None:
        """Start a preset outside any statement, so errors are reported to ONERROR."""
        try:
            self.start(axis)
        except Rejected as rejected:
            rejected.line = rejected.line or self._lines.get(axis, 0)
            self.controller.run_time_fault(rejected)


# ----------------------------------------------------------------------------------------------- operations


def _preset(preset: int) -> int:
    return checked(preset, LAST_PRESET, "preset")


def read_entry(presets: Presets, row: Keyword, preset: int, number: int = 0) -> float:
    """Return a field of a preset in user units, 0 until it is written."""
    value = presets.entry(row.name, _preset(preset), _second(row, number))
    return int(value) if row.unit == "integer" else value


def write_entry(presets: Presets, row: Keyword, preset: int, value: float) -> None:
    """Write a field of a preset in user units."""
    presets.table[row.name, _preset(preset), 0] = value


# The second index of keywords that have one: its maximum and its meaning.
_SECOND = {
    "PRESETMOVETYPE": (0, "0 is the type"),
    "PRESETMOVEPARAMETER": (0, "0 is the percent of a torque reference"),
    "PRESETACCEL": (1, "0 is a rate, 1 a time in milliseconds"),
    "PRESETDECEL": (1, "0 is a rate, 1 a time in milliseconds"),
}


def _second(row: Keyword, number: int) -> int:
    last, hint = _SECOND.get(row.name, (0, ""))
    if not 0 <= number <= last:
        raise Rejected("range", f"{row.word} has no parameter {number}", hint)
    return number


def write_format(presets: Presets, row: Keyword, preset: int, number: int, value: float) -> None:
    """Write a field that has a format or a parameter.

    A rate and the time that can replace it clear each other.
    """
    presets.table[row.name, _preset(preset), _second(row, number)] = value
    if row.index == "preset, format":
        presets.table.pop((row.name, preset, 1 - number), None)


# ------------------------------------------------------------------------------------------------- keywords

_FORMAT = Actions(read=of_word(Presets, read_entry), write=of_word(Presets, write_format))
_ENTRY = Actions(read=of_word(Presets, read_entry), write=of_word(Presets, write_entry))
_SETTING = Actions(read=setting_reader(Presets), write=of_word(Presets, Presets.choose))

_MAX_VALUE = 8388607.0
_MAX_TIME = 2147483647.0
_TWO = "PRESETMOVETYPE(1, 0) = 4 : PRESETMOVEPOSITION(1) = 10\nPRESETMOVETYPE(2, 0) = 3 : PRESETMOVEPOSITION(2) = 0\n"
_RUN = _TWO + "PRESETINDEX(0) = 1\n{}PRESETMOVEENABLE(0) = 1\nPAUSE IDLE(0)\nPRINT POS(0)"


def _row(name: str, index: str, unit: str, actions: Actions, help: str, example: str, low: float, high: float,
         default: float = 0.0, group: str = "axis", effect: str = "", selects: str = "") -> Keyword:  # fmt: skip
    return Keyword(name, "", "setting", "RW", index, unit, actions, help, example, default=default, low=low,
                   high=high, group=group, effect=effect, selects=selects)  # fmt: skip


def _entry(name: str, unit: str, help: str, low: float, high: float) -> Keyword:
    return _row(name, "preset", unit, _ENTRY, help, f"{name}(1) = 1\nPRINT {name}(1)", low, high)


def _format(
    name: str, unit: str, help: str, high: float, second: str = "format", low: float = 0.0
) -> Keyword:
    return _row(
        name, f"preset, {second}", unit, _FORMAT, help, f"{name}(1, 0) = 3\nPRINT {name}(1, 0)", low, high
    )


def _setting(
    name: str, help: str, low: float, high: float, default: float = 0.0, example: str = "", selects: str = ""
) -> Keyword:
    example = example or f"{name}(0) = 1\nPRINT {name}(0)"
    return _row(
        name, "axis", "integer", _SETTING, help, example, low, high, default, "motion", selects=selects
    )


ROWS = (
    _format("PRESETMOVETYPE", "integer",
            "Type of a preset: 1 HOME, 2 JOG, 3 MOVEA, 4 MOVER, 5 POS, 6 SPEEDREF, 7 TORQUEREF, 8 STOP, "
            "9 SUSPEND, 10 CANCEL; 0 none.", 10, "parameter"),
    _entry("PRESETMOVEPOSITION", "number", "Position or distance of a preset, in user units of its axis.", -_MAX_VALUE,
           _MAX_VALUE),
    _entry("PRESETMOVESPEED", "number", "The speed of a preset that moves or is a speed reference; 0 for SPEED.",
           -_MAX_VALUE, _MAX_VALUE),
    _format("PRESETACCEL", "number",
            "Acceleration of a preset: format 0 a rate, 1 milliseconds from rest to its speed; 0 for ACCEL.", 1e12),
    _format("PRESETDECEL", "number",
            "Deceleration of a preset: format 0 a rate, 1 milliseconds from its speed to rest; 0 for DECEL.", 1e12),
    _entry("PRESETJOGSPEED", "number", "The speed of a preset that jogs; 0 for SPEED.", 0, _MAX_VALUE),
    _entry("PRESETJOGDIRECTION", "integer", "The direction of a preset that jogs: 0 forwards, 1 in reverse.", 0, 1),
    _entry("PRESETMOVEHOMETYPE", "integer", "The type of HOME of a preset that homes.", 0, 9),
    _format("PRESETMOVEPARAMETER", "number", "The percent of a preset that is a torque reference (number 0 behind it).",
            100, "parameter", -100),
    _row("PRESETINDEX", "axis", "integer",
         Actions(read=of(Presets, Presets.selected), write=of_word(Presets, Presets.choose)),
         "The preset that is next; without a trigger input writing it starts it, while PRESETMOVEENABLE is 1.",
         _RUN.format("") + "\nPRESETINDEX(0) = 2\nPAUSE IDLE(0)\nPRINT POS(0)", 0, 63, group="motion", effect="act"),
    _setting("PRESETINDEXMODE",
             "Action after a preset: 0 keep it selected, 1 select the next one in the table, 2 select the "
             "next one and start it after PRESETDWELLTIME.", 0, 2),
    _setting("PRESETINDEXSOURCE", "Selector of presets: 0 PRESETINDEX, 1 the inputs from PRESETSELECTORINPUT on.", 0,
             1),
    _setting("PRESETDWELLTIME", "Milliseconds of rest between presets that follow each other by themselves.", 0,
             _MAX_TIME),
    _setting("PRESETSELECTORINPUT", "The first of the inputs that select a preset, the lowest bit of its number; -1 "
                                    "for none.", -1, 999, -1.0, selects="input"),
    _setting("PRESETINPUTSMAX", "Number of inputs that select a preset.", 0, 6, 4.0),
    Keyword("PRESETINPUTSTATE", "", "reading", "R", "axis", "integer", Actions(read=of(Presets, Presets.inputs)),
            "The preset that the inputs select now.", "PRESETSELECTORINPUT(0) = 4\nPRINT PRESETINPUTSTATE(0)",
            default=0.0, group="state"),
    _setting("PRESETTRIGGERINPUT", "The input whose becoming active starts the preset that is selected; -1 for none.",
             -1, 999, -1.0, selects="input"),
    _row("PRESETMOVEENABLE", "axis", "bool", _SETTING,
         "Enables presets; without a trigger input, 1 starts the selected preset.", _RUN.format(""), 0, 1,
         group="motion", effect="hands-over"),
)  # fmt: skip
