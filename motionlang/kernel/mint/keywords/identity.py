"""Readings of the virtual controller about itself, and words without an effect.

The section `[mint.values]` of the machine file can override each value.
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.lang.keyword import Actions, Keyword, constant
from motionlang.kernel.lang.run_errors import NotSimulated
from motionlang.kernel.mint.keywords.no_effect import StoredValues
from motionlang.kernel.mint.runtime.binding import Maker, Operation, axis_of
from motionlang.kernel.mint.runtime.environment import Environment

# The item of NUMBEROF that counts axes.
AXES = 0


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


def count(environment: Environment, item: int) -> int:
    """NUMBEROF: return the number of axes, or of other items in the machine file.

    The run ends if the machine file does not give the number.
    """
    if item == AXES:
        return len(environment.controller.axes)

    words = f"how many there are of item {item} is not known here"
    raise NotSimulated(words, f'give it in the machine file: [mint.values] NUMBEROF = {{ "{item}" = 8 }}')


# ------------------------------------------------------------------------------------------------- keywords

_COUNT = Actions(read=answers(count), write=lambda environment, row: lambda *given: None)
_FIT = Actions(read=answers(lambda environment, *where: 1))
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


def _fit(name: str, index: str, help: str) -> Keyword:
    where = "" if index == "none" else "(0)"
    return Keyword(name, "", "reading", "R", index, "bool", _FIT, help, f"PRINT {name}{where}", default=1.0,
                   group="identity")  # fmt: skip


ROWS = (
    Keyword("NUMBEROF", "no", "setting", "RW", "item", "integer", _COUNT,
            "Number of objects of a kind: _noAXES counts the axes; the machine file sets the other kinds. Writing "
            "it changes nothing.", "PRINT NUMBEROF(0)", group="identity"),
    Keyword("_noAXES", "", "constant", "R", "none", "integer", str(AXES), "NUMBEROF: axes.", "PRINT NUMBEROF(_noAXES)",
            group="constants"),
    constant("_egCONTROLLER", 3, "ERRORPRESENT and its family: errors of the controller, as _egMISC."),
    _fit("MINTEXECUTING", "none", "1: the program runs."),
    _fit("SUPPORTSMINT", "none", "1: the controller runs programs."),
    Keyword("NOP", "", "command", "C", "none", "", _NOTHING, "Do nothing.", "NOP", group="control"),
    *(
        Keyword(name, "", "command", "C", "none", "", _NOTHING, help, name, group="terminal")
        for name, help in (
            ("TRON", "Line trace on: MintMT has the word for old programs and does nothing."),
            ("TROFF", "Line trace off: MintMT has the word for old programs and does nothing."),
        )
    ),
    *(constant(f"_ie{name}", number, f"INITERROR: {help}.") for number, name, help in _INIT_ERRORS),
)  # fmt: skip
