"""Values of what has more than two levels: keys, analogue inputs, numbers of a host.

Two unusual values are played. A comparison whose margin (left side minus right side) differs between the two runs
depends on the value, plain, shifted or scaled, as in `k = k - 48 : IF k = 1` or `ADC(0) * 3 > set - 5`. The margin is
linear in the value, so the value at which the sides are equal follows from the two, and a value on each side of it.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite

from motionlang.commands.explore.trials import Change, Trial
from motionlang.kernel import Program

# Two unusual keys, levels and numbers.
KEYS, LEVELS, NUMBERS = ("~", "|"), (41.0, 43.0), (7771.0, 7773.0)
ENTER = "\r"
# Digits and Enter are keys that a person tries.
USUAL = (*"1234567890", ENTER)
# So many values are tried of one channel.
MAX_VALUES = 24


def probes(program: Program) -> Iterator[tuple[Change, Change]]:
    """Yield two unusual changes of each channel with more than two levels that a program reads."""
    found: dict[tuple[str, int], None] = {}
    for statement in program.structure.statements.values():
        for use in statement.channels:
            if use.access == "read" and use.channel in _TABLES:
                number = int(use.number) if use.number.isdecimal() else 0
                found[_TABLES[use.channel], number if use.channel != "key" else 0] = None
    for table, number in found:
        first, second = KEYS if table == "key" else LEVELS if table == "analogue" else NUMBERS
        yield Change(table, number, first), Change(table, number, second)


_TABLES = {"key": "key", "analogue input": "analogue", "comms element": "comms"}


def solved(first: Change, second: Change, one: Trial, other: Trial) -> list[Change]:
    """Return the values of a channel at which comparisons turn, from the trials with two other values of it."""
    a, b = _number(first), _number(second)
    found: dict[float, None] = {}
    for at, margins in _margins(one).items():
        for m, n in zip(margins, _margins(other).get(at, []), strict=False):
            slope = (n - m) / (b - a)
            if slope and isfinite(slope):
                root = a - m / slope
                found |= dict.fromkeys(value for value in _near(first, root))
    changes = [change for value in found if (change := _change(first, value)) is not None]
    if first.table == "key":
        changes += [first._replace(value=each) for each in USUAL]
    return list(dict.fromkeys(changes))[:MAX_VALUES]


def _margins(trial: Trial) -> dict[int, list[float]]:
    """Return left side minus right side of the comparisons of numbers, by source offset."""
    return {
        at: [
            float(left) - float(right)
            for left, right in sides
            if isinstance(left, (int, float)) and isinstance(right, (int, float))
        ]
        for at, sides in trial.comparisons.items()
    }


def _number(change: Change) -> float:
    return float(ord(change.value)) if isinstance(change.value, str) else change.value


def _near(change: Change, root: float) -> tuple[float, ...]:
    """Return a root, or the next usual value on each side of it."""
    if change.table == "analogue":
        return round(root + 2.0, 1), round(root - 2.0, 1)
    if not float(root).is_integer():
        return round(root + 0.5), round(root - 0.5)
    return (root,) if change.table == "key" else (root, root + 1.0)


def _change(change: Change, value: float) -> Change | None:
    """Return a change to a value, None if there is no such key or level."""
    if change.table == "key":
        known = value == ord(ENTER) or 32 <= value < 127
        return change._replace(value=chr(int(value))) if known and value == int(value) else None
    if change.table == "analogue" and not 0.0 <= value <= 100.0:
        return None
    return change._replace(value=value)
