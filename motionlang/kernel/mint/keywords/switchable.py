"""The assumptions about Mint that have values: number formats, default settings."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.machine.switch import Switch
from motionlang.kernel.mint.keywords import table

# `mint.homespeed-default` is the value of HOMESPEED at power-up.
PREFIX, SUFFIX = "mint.", "-default"
# Assumptions other than defaults of axis settings. The first choice is the default.
OTHERS = {
    "mint.float-decimals": Switch(low=0, high=9, whole=True),
    "mint.float-zeros": Switch("kept", "dropped"),
    "mint.float-exponent": Switch("e+12", "e+012", "E+12", "E+012"),
    "mint.timerevent": Switch("a period", "at once", "once"),
    "mint.event-queue": Switch("once", "forgotten", "each"),
    "mint.circle-sense": Switch("anticlockwise", "clockwise"),
}
# Settings that determine the values of other settings. Their defaults follow from the assumptions about the
# others.
DECISIVE = frozenset({"SRAMP", "POSROLLOVER"})
# Further names of settings, whose defaults are those of their first names.
SYNONYMS = frozenset({"FEEDRATE", "POSSCALEFACTOR"})


class AssumptionSwitches(Mapping[str, Switch]):
    """The assumptions that can be set; a lookup imports only the file of its keyword."""

    def __getitem__(self, name: str) -> Switch:
        row = row_with_default(word_of(name))
        if row is None:
            return OTHERS[name]
        return Switch(low=row.low, high=row.high, whole=row.is_whole)

    def __iter__(self) -> Iterator[str]:
        yield from OTHERS
        yield from map(name_of, with_default())

    def __len__(self) -> int:
        return len(OTHERS) + len(with_default())


def switches() -> Mapping[str, Switch]:
    """Return every assumption that can be set, by name."""
    return AssumptionSwitches()


def with_default() -> list[Keyword]:
    """Return the keywords whose defaults are assumptions."""
    return [row for row in table() if has_default(row)]


def row_with_default(word: str) -> Keyword | None:
    """Return the named keyword if its default is an assumption, else None."""
    row = table().get(word)
    return row if row is not None and row.name.lower() == word.lower() and has_default(row) else None


def has_default(row: Keyword) -> bool:
    """True if a keyword is an axis setting with a default.

    A keyword whose write does more than store a value is not a setting, because it moves the axis or transfers
    control of it.
    """
    return (
        row.simulated
        and row.kind == "setting"
        and row.access == "RW"
        and row.name not in DECISIVE
        and row.name not in SYNONYMS
        and row.index == "axis"
        and isinstance(row.default, (int, float))
        and row.is_stored
        and (row.low is None or row.low != row.high)
    )


def name_of(row: Keyword) -> str:
    """Return the name of the assumption about a keyword's default."""
    return f"{PREFIX}{row.name.lower()}{SUFFIX}"


def word_of(name: str) -> str:
    """Return the keyword whose default an assumption gives, "" if there is none."""
    return name[len(PREFIX) : -len(SUFFIX)] if name.endswith(SUFFIX) else ""
