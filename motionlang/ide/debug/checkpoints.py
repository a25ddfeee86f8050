"""Checkpoints: snapshots of a run along its statements, to go back to.

Problem. A long run has many statements, and a snapshot takes a few milliseconds and a hundred kilobytes.

Idea. The first snapshots are `FIRST` statements apart. When there are more than `MAX_CHECKPOINTS`, every second one is
dropped and the distance doubles. So going back repeats at most an eighth of a run. The distance is a number of
statements, not real time, so the same commands take the same snapshots.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from motionlang.kernel.lang import Snapshot

FIRST, MAX_CHECKPOINTS = 16, 32


@dataclass(eq=False, slots=True)
class Checkpoint:
    """The state of a run after statement `number`, at a time, s, and what the debugger has counted by then."""

    number: int
    time: float
    snapshot: Snapshot
    # Hits by breakpoint.
    hits: Mapping[object, int]
    # The characters written, the answers to INPUT that were used, and the advances of the clock.
    written: int
    answers_used: int
    advances: int


class Checkpoints:
    """The checkpoints of a run, in order; the next one is taken from statement `due` on."""

    def __init__(self) -> None:
        self._taken: list[Checkpoint] = []
        self._distance = FIRST
        self.due: float = FIRST

    def add(self, checkpoint: Checkpoint) -> None:
        """Add a checkpoint; if there are too many, drop every second one."""
        self._taken.append(checkpoint)
        if len(self._taken) > MAX_CHECKPOINTS:
            del self._taken[1::2]
            self._distance *= 2
        self.due = checkpoint.number + self._distance

    def drop_after(self, last: Checkpoint | None) -> None:
        """Drop the checkpoints after one, or all: the run continues from there."""
        number = 0 if last is None else last.number
        self._taken = [each for each in self._taken if each.number <= number]
        self.due = number + self._distance

    def before(self, number: int) -> list[Checkpoint]:
        """Return the checkpoints before a statement, in order."""
        return [each for each in self._taken if each.number < number]

    def before_time(self, time: float) -> Checkpoint | None:
        """Return the last checkpoint before a time."""
        return next((each for each in reversed(self._taken) if each.time < time), None)
