"""The assumptions about Mint that are values: number formats and setting defaults."""

from __future__ import annotations

from motionlang.lang.machine.switch import Switch
from motionlang.mint.keywords import table

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from motionlang.lang.keyword import Keyword

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
DECISIVE = frozenset({"TIMESCALE", "VELSCALEFACTOR", "ACCELSCALEFACTOR", "SRAMP", "POSROLLOVER"})
_found: dict[str, Switch] = {}


def switches() -> Mapping[str, Switch]:
    """Return every assumption that can be set, by name."""
    if not _found:
        _found.update(OTHERS)
        _found.update(
            (name_of(row), Switch(low=row.low, high=row.high, whole=row.is_whole)) for row in with_default()
        )
    return _found


def with_default() -> list[Keyword]:
    """Return the keywords whose defaults are assumptions.

    If two keywords name one setting of the controller, the first counts.
    """
    found: dict[str, Keyword] = {}
    for row in table():
        if has_default(row):
            found.setdefault(row.verb or row.name, row)
    return list(found.values())


def has_default(row: Keyword) -> bool:
    """True if a keyword is an axis setting with a default.

    A keyword whose write does more than store a value is not a setting: it moves the axis, or transfers
    control of it.
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
    """Return the name of the assumption for a keyword's default."""
    return f"{PREFIX}{row.name.lower()}{SUFFIX}"


def word_of(name: str) -> str:
    """Return the keyword whose default an assumption is, "" if it is none."""
    return name[len(PREFIX) : -len(SUFFIX)] if name.endswith(SUFFIX) else ""
