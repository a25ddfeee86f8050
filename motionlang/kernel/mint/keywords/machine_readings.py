"""Values from the machine file for keywords that cannot be computed.

They are in the section `[mint.values]`:

    [mint.values]
    DRIVEBUSVOLTS = 325                     # for any index
    TEMPERATURE = { "0" = 41.5, "1" = 39 }  # by index; "0, 1" for two indices
"""

from __future__ import annotations

from collections.abc import Mapping

from motionlang.kernel.lang.keyword import WHOLE_UNITS, Keyword
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.tools import as_hint, nearest, shown

SECTION = "mint.values."
# Groups of keywords with a value of their own that the machine file may override.
ANSWERED = frozenset(("identity",))


class SuppliedValues:
    """The values, by keyword and index; None stands for any index."""

    def __init__(self, settings: Mapping[str, object]) -> None:
        self.values: dict[tuple[str, tuple[object, ...] | None], object] = {}
        for key, value in settings.items():
            if key.startswith(SECTION):
                word, _, where = key[len(SECTION) :].partition(".")
                self.values[word.upper(), _numbers(where) if where else None] = value

    def find(self, word: str, unit: str, where: tuple[object, ...]) -> object | None:
        """Return the value of a keyword in its unit, None if the machine file has none."""
        if not self.values:
            return None
        found = self.values.get((word, where), self.values.get((word, None)))
        if found is None or unit == "text":
            return found
        return int(found) if unit in WHOLE_UNITS else float(found)  # type: ignore[call-overload,arg-type]


def words(settings: Mapping[str, object]) -> frozenset[str]:
    """Return the keywords for which the machine file has a value."""
    return frozenset(
        key[len(SECTION) :].partition(".")[0].upper() for key in settings if key.startswith(SECTION)
    )


def _numbers(where: str) -> tuple[object, ...]:
    texts = [each.strip() for each in where.split(",")]
    return tuple(int(each) if each.isdecimal() and len(each) < 10 else each for each in texts)


def problem(key: str, value: object) -> tuple[str, str] | None:
    """Return what is wrong with an entry and a hint, None if the entry is valid."""
    word, _, where = key[len(SECTION) :].partition(".")
    row = table().get(word)
    rows = [each for each in table() if can_be_supplied(each)]
    if row is None or row.name.upper() != word.upper():
        near = nearest(word, [each.name for each in rows]) if row is None else row.name
        hint = f"did you mean {near}?" if near else "motionlang help keywords lists the keywords of Mint"
        return f"there is no readable keyword {word}", hint
    if row not in rows:
        return f"the machine file cannot set {row.name}", _why_not(row)
    return _value_problem(row, where, value)


def can_be_supplied(row: Keyword) -> bool:
    """True if a keyword has a value that the run does not compute itself."""
    return "R" in row.access and (not row.simulated or row.group in ANSWERED)


def _why_not(row: Keyword) -> str:
    return "it has no value" if "R" not in row.access else "the run computes it"


def _value_problem(row: Keyword, where: str, value: object) -> tuple[str, str] | None:
    brackets = 0 if row.index == "none" else len(row.index.split(", "))
    given = len(where.split(",")) if where else brackets
    if given != brackets:
        return f"{row.name} has {brackets} in its brackets, not {given}", f"it stands for {row.index}"
    if row.unit == "text":
        return (
            None
            if isinstance(value, str)
            else (f"{row.name} is a text, not {shown(value)}", as_hint(row.help))
        )
    if isinstance(value, str) or (row.is_whole and value != int(value)):  # type: ignore[call-overload]
        what = "a whole number" if row.is_whole else "a number"
        return f"{row.name} is {what}, not {shown(value)}", as_hint(row.help)
    return None
