"""The readings of Mint that are values: how numbers are printed, and what settings are until a program writes them."""

from __future__ import annotations

from motionlang.lang.machine.switch import Switch
from motionlang.mint.keywords import table

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from motionlang.lang.keyword import Keyword

# `mint.homespeed-default` is what HOMESPEED is at power-up.
PREFIX, SUFFIX = "mint.", "-default"
# Readings that are no setting of an axis. The first choice is the one taken.
OTHERS = {
    "mint.float-decimals": Switch(low=0, high=9, whole=True),
    "mint.float-zeros": Switch("kept", "dropped"),
    "mint.float-exponent": Switch("e+12", "e+012", "E+12", "E+012"),
    "mint.timerevent": Switch("a period", "at once", "once"),
    "mint.event-queue": Switch("once", "forgotten", "each"),
    "mint.circle-sense": Switch("anticlockwise", "clockwise"),
}
# Settings whose value decides what others read: these are found by the others.
DECISIVE = frozenset({"TIMESCALE", "VELSCALEFACTOR", "ACCELSCALEFACTOR", "SRAMP", "POSROLLOVER"})
_found: dict[str, Switch] = {}


def switches() -> Mapping[str, Switch]:
    """Every reading that can be set, by its name."""
    if not _found:
        _found.update(OTHERS)
        _found.update(
            (name_of(row), Switch(low=row.low, high=row.high, whole=row.is_whole)) for row in with_default()
        )
    return _found


def with_default() -> list[Keyword]:
    """The words whose defaults are readings; of two names of one setting of the controller the first."""
    found: dict[str, Keyword] = {}
    for row in table():
        if has_default(row):
            found.setdefault(row.verb or row.name, row)
    return list(found.values())


def has_default(row: Keyword) -> bool:
    """Whether a word is a setting of each axis that is something before a program writes it.

    What writing does beside keeping the value is no setting: it moves the axis, or hands it over.
    """
    return (
        row.simulated
        and row.kind == "setting"
        and row.access == "RW"
        and row.name not in DECISIVE
        and row.index == "axis"
        and isinstance(row.default, (int, float))
        and not row.effect
        and (row.low is None or row.low != row.high)
    )


def name_of(row: Keyword) -> str:
    """The name of the reading of a word's default."""
    return f"{PREFIX}{row.name.lower()}{SUFFIX}"


def word_of(name: str) -> str:
    """The word whose default a reading is, "" where it is none."""
    return name[len(PREFIX) : -len(SUFFIX)] if name.endswith(SUFFIX) else ""
