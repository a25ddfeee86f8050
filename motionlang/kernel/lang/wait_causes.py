"""The values read by loops and conditional waits, for the time profile."""

from __future__ import annotations

from dataclasses import dataclass

# A reading, one of `KINDS`, and the number of its axis or channel; None for any of them.
Read = tuple[str, int | None]

# The readings of a condition, and the cause of a wait for each, one of `record.records.CAUSES`.
KINDS = {
    "axis": "axis",
    "position": "axis",
    "following": "axis",
    "input": "input",
    "latch": "condition",
    "analogue": "input",
    "encoder": "input",
    "time": "time",
    "task": "task",
    "operator": "operator",
    "host": "host",
    "other": "condition",
}
# The cause of a wait that ended while its axis moved, such as for a position.
MOVING = "moving"


@dataclass(eq=False, slots=True)
class LoopDependencies:
    """The readings that decide the duration of a loop or a wait at a source offset.

    `leaves`   the readings in the conditions that end it; none if it only computes
    `within`   the readings in all conditions in it, including branches that only some iterations take
    `lines`    the lines that it executes
    `counts`   true if it also ends by itself, when it has counted to its limit
    `computes` true if it assigns to a variable that decides when it ends
    `why`      a description of what it waits for
    """

    leaves: frozenset[Read]
    within: frozenset[Read] = frozenset()
    lines: frozenset[int] = frozenset()
    why: str = ""
    counts: bool = False
    computes: bool = False
