"""What loops and waits for conditions ask for, as a profile charges their time by it."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    # What is read, one of `KINDS`, and the number of its axis or channel; None for any of them.
    Read = tuple[str, int | None]

# What a condition can read, and the cause of a wait for that, one of `record.records.CAUSES`.
KINDS = {
    "axis": "axis",
    "position": "axis",
    "input": "input",
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


class Asked:
    """What decides how long a loop or a wait at one place of the program lasts.

    `leaves`   what the conditions read by which it ends; nothing where it only computes
    `within`   what all conditions in it read, those by which it does something in some iterations
    `lines`    the lines of what it carries out
    `counts`   it also ends by itself, when it has counted to its limit
    `why`      how a person would say what it waits for
    """

    __slots__ = ("counts", "leaves", "lines", "why", "within")

    def __init__(
        self,
        leaves: frozenset[Read],
        within: frozenset[Read] = frozenset(),
        lines: frozenset[int] = frozenset(),
        why: str = "",
        counts: bool = False,
    ) -> None:
        self.leaves, self.within, self.lines, self.why = leaves, within, lines, why
        self.counts = counts
