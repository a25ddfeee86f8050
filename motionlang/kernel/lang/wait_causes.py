"""The values read by loops and conditional waits, for the time profile."""

from __future__ import annotations

from dataclasses import dataclass

# A reading, one of `KINDS`, and the number of its axis or channel; None for any of them.
Read = tuple[str, int | None]

# The readings of a condition, and the cause of a wait for each, one of `record.records.CAUSES`.
KINDS = {
    "axis": "axis",
    "position": "axis",
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
    `why`      a description of what it waits for
    """

    leaves: frozenset[Read]
    within: frozenset[Read] = frozenset()
    lines: frozenset[int] = frozenset()
    why: str = ""
    counts: bool = False


@dataclass(eq=False, slots=True)
class InputRead:
    """A position at which a program depends on the world around it.

    `kind`    "wait" (the program stops here until the level comes), "either" (or until something else comes), "poll"
              (the condition of a loop that waits), "work" (the condition that ends a loop with moves), "guard" (an If
              that jumps away at the other level, or a loop with moves that ends there), "test" (any other reading),
              "event" (a handler), "key" (a key that the program compares with) or "answer" (a number that it compares
              an answer with)
    `channel` the number of the input, the code of the key, or the number; None if it is only known at run time
    `level`   the level that lets the program continue, or makes a test true; None if that is unknown
    `line`    the line; `last` is the last line of a loop, or the line that asks for the answer
    `at_any_time`   true in a handler of an event, which no line comes before
    """

    kind: str
    channel: int | None
    level: int | None
    line: int
    last: int
    at_any_time: bool = False

    @property
    def is_input(self) -> bool:
        """True for a digital input, False for a key or an answer."""
        return self.kind not in ("key", "answer")
