"""Properties of the virtual controller: its type, its equipment, and no defects.

The section `[mint.values]` of the machine file can override each value.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime, timedelta

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword, constant, kind_of
from motionlang.kernel.lang.run_errors import NotSimulated
from motionlang.kernel.mint.keywords.no_effect import StoredValues
from motionlang.kernel.mint.models import named
from motionlang.kernel.mint.runtime.binding import Maker, Operation, axis_of, of
from motionlang.kernel.mint.runtime.changes import always
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.version import __version__

# The item of NUMBEROF that counts axes.
AXES = 0
# The name that WorkBench's library gives its own simulated controller.
VIRTUAL = "Virtual Controller"
_POWER_UP = "2000-01-01 00:00:00"
_DATE = "%Y-%m-%d %H:%M:%S"


def answers(known: Callable[..., object]) -> Maker:
    """Make an operation that reads a machine file value or, without one, `known`.

    `known` is called with the environment and the indices.
    """

    def made(environment: Environment, row: Keyword) -> Operation:
        find, of_axis = environment.component(StoredValues).supplied.find, row.index == "axis"

        def read(*where: int) -> object:
            if of_axis:
                axis_of(environment, where[0])
            supplied = find(row.name, row.unit, where)
            return known(environment, *where) if supplied is None else supplied

        return read

    return made


def version(environment: Environment) -> str:
    return f"motionlang {__version__}"


def count(environment: Environment, item: int) -> int:
    """NUMBEROF: return the number of axes, or of other items in the machine file.

    The run ends if the machine file does not give the number.
    """
    if item == AXES:
        return len(environment.controller.axes)

    words = f"how many there are of item {item} is not known here"
    raise NotSimulated(words, f'give it in the machine file: [mint.values] NUMBEROF = {{ "{item}" = 8 }}')


def takes_moves(environment: Environment, count: int, axes: Sequence[int]) -> int:
    """OKTOLOADMOVE: return 1 if every axis in the array could load a move now."""
    controller = environment.controller

    def takes(axis: int) -> bool:
        a = controller.axes[axis_of(environment, axis)]
        stopping = a.move is not None and a.move.ended in ("stop", "fault")
        return controller.is_enabled(axis) and not a.faults and not stopping and controller.room(axis) > 0

    return int(all(takes(int(axis)) for axis in (axes or [])[1 : count + 1]))


# --------------------------------------------------------------------------------------------- date and time


class Calendar:
    """The date and time on the controller, set by the machine file or the program."""

    def __init__(self, environment: Environment) -> None:
        supplied = environment.component(StoredValues).supplied.find("REALTIMECLOCK", "text", ())
        self.clock = environment.clock
        self.set(str(supplied) if supplied is not None else _POWER_UP, 0.0)

    def set(self, text: str, now: float) -> None:
        """Set date and time; raise Rejected for an invalid date."""
        try:
            self.date = datetime.strptime(text, _DATE)
        except ValueError:
            raise Rejected(
                "range", f"REALTIMECLOCK cannot be {text!r}", f'it takes a text like "{_POWER_UP}"'
            ) from None
        self.since = now

    def text(self) -> str:
        """Return date and time in whole seconds."""
        try:
            return (self.date + timedelta(seconds=int(self.clock.now - self.since + 1e-9))).strftime(_DATE)
        except OverflowError:
            return self.date.strftime(_DATE)


# ------------------------------------------------------------------------------------------------- keywords

_LOCAL = Actions(read=answers(lambda environment, *where: 0))
_FIT = Actions(read=answers(lambda environment, *where: 1))
# There is nothing to clear.
_NOTHING_WRONG = Actions(read=_LOCAL.read, write=lambda environment, row: lambda *given: None)
_DATE_ACTIONS = Actions(
    read=always(of(Calendar, Calendar.text)),
    write=of(Calendar, lambda calendar, text: calendar.set(text, calendar.clock.now)),
)
# The errors of INITERROR on the printed page that is known; 1 to 4 are on the page before.
_INIT_ERRORS = (
    (5, "FAILED_TO_READ_CARRIER_EEPROM", "the EEPROM of the carrier cannot be read"),
    (6, "FAILED_TO_READ_POWER1_EEPROM", "the EEPROM of the power stage cannot be read"),
    (7, "DSP_FAILED_TO_INITIALISE", "the DSP did not initialise"),
    (8, "DSP_LOST_USER_DATA", "the DSP lost user data"),
    (9, "FAILED_TO_CLEAR_ALL", "not everything could be cleared"),
    (10, "FAILED_TO_SET_WATCHDOG", "the watchdog could not be set"),
    (11, "EEPROM_DEFAULTS_USED", "the defaults of the EEPROM are in use, after a reset of the controller"),
)
_NOTHING = Actions(do=lambda environment, row: lambda *given: None)


def _word(
    name: str,
    short: str,
    access: str,
    index: str,
    unit: str,
    actions: Actions,
    help: str,
    default: float | None = 0.0,
) -> Keyword:
    where = "" if index == "none" else "(0)"
    return Keyword(name, short, kind_of(access), access, index, unit, actions, help, f"PRINT {name}{where}",
                   default=None if unit == "text" else default, group="identity")  # fmt: skip


def _fine(name: str, unit: str, help: str) -> Keyword:
    text = f"{help} 0: nothing went wrong. Writing it clears nothing."
    return _word(name, "", "RW", "none", unit, _NOTHING_WRONG, text)


ROWS = (
    _word("PLATFORMNAME", "", "R", "none", "text",
          Actions(read=answers(lambda environment: named(environment.machine.model) or VIRTUAL)),
          "The controller: controller.model of the machine file, or Virtual Controller."),
    _word("FIRMWAREVERSION", "", "R", "none", "text", Actions(read=answers(version)), "The version of this program."),
    _word("NUMBEROF", "no", "RW", "item", "integer", Actions(read=answers(count), write=_NOTHING_WRONG.write),
          "Number of objects of a kind: _noAXES counts the axes; the machine file sets the other kinds. Writing "
          "it changes nothing.",
          default=None),
    Keyword("_noAXES", "", "constant", "R", "none", "integer", str(AXES), "NUMBEROF: axes.", "PRINT NUMBEROF(_noAXES)",
            group="constants"),
    constant("_egCONTROLLER", 3, "ERRORPRESENT and its family: errors of the controller, as _egMISC."),
    _word("AXISBUS", "", "R", "axis", "integer", _LOCAL, "The bus of an axis: 0, as every axis is local."),
    _word("AXISNODE", "", "R", "axis", "integer", _LOCAL,
          "The node of an axis: 0, as every axis is local."),
    _word("MINTEXECUTING", "", "R", "none", "bool", _FIT, "1: the program runs.", 1.0),
    _word("SUPPORTSMINT", "", "R", "none", "bool", _FIT, "1: the controller runs programs.", 1.0),
    _word("PHASESEARCHSTATUS", "", "R", "axis", "bool", _FIT, "1: the motor is commutated.", 1.0),
    _fine("INITERROR", "integer", "Error of the start of the controller, an _ie constant."),
    _fine("INITWARNING", "bits", "Warnings of the start of the controller."),
    Keyword("AVERAGEVEL", "", "reading", "R", "axis", "uu/s", "velocity",
            "Velocity of the axis as VEL has it: there is no noise to average.",
            "JOG(0) = 100\nWAIT = 100\nPRINT AVERAGEVEL(0)\nSTOP(0)", default=0.0, group="state"),
    Keyword("OKTOLOADMOVE", "", "reading", "R", "count, array", "bool", Actions(read=of(Environment, takes_moves)),
            "1 when the axes in an array, so many of them, take a move now: there is room, and none is in error, "
            "switched off or stopping.",
            "Dim a(2) As Integer = 0, 1\nPRINT OKTOLOADMOVE(2, a)", default=1.0, group="state"),
    Keyword("REALTIMECLOCK", "", "setting", "RW", "none", "text", _DATE_ACTIONS,
            "Date and time, 2000-01-01 00:00:00 at power-up until it is set; [mint.values] gives another begin. It "
            "goes with machine time.",
            'REALTIMECLOCK = "2026-11-20 06:30:00"\nWAIT = 2000\nPRINT REALTIMECLOCK', group="identity"),
    Keyword("NOP", "", "command", "C", "none", "", _NOTHING, "Do nothing.", "NOP", group="control"),
    *(
        Keyword(name, "", "command", "C", "none", "", _NOTHING, help, name, group="terminal")
        for name, help in (
            ("TRON", "Line trace on: MintMT has the word for old programs and does nothing."),
            ("TROFF", "Line trace off: MintMT has the word for old programs and does nothing."),
            ("BEEPON", "Key clicks on, which has no effect here."),
            ("BEEPOFF", "Key clicks off, which has no effect here."),
        )
    ),
    *(constant(f"_ie{name}", number, f"INITERROR: {help}.") for number, name, help in _INIT_ERRORS),
)  # fmt: skip
