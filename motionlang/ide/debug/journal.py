"""The journal of a session: manual changes, each with the statement after it.

A replay makes the same changes before the same statements. An entry made after stepping back invalidates all later
ones, because they belong to another continuation of the run.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf


@dataclass(eq=False, slots=True)
class Assigned:
    """A variable that was assigned another value.

    `path` consists of its scope and the names that lead to it.
    """

    statement: int
    path: tuple[str, ...]
    value: object


@dataclass(eq=False, slots=True)
class Entered:
    """Inputs and keys as machine-file entries; times are relative to the statement."""

    statement: int
    entries: Mapping[str, object]


@dataclass(eq=False, slots=True)
class Answered:
    """An answer to INPUT."""

    statement: int
    text: str


class Journal:
    """All manual changes in the order of their statements, and the answers to INPUT."""

    def __init__(self) -> None:
        self.changes: list[Assigned | Entered] = []
        self.answers: list[Answered] = []

    def add(self, change: Assigned | Entered) -> None:
        """Add a change, and remove all changes after its statement."""
        self._truncate(change.statement)
        self.changes.append(change)

    def answer(self, statement: int, text: str, number: int) -> None:
        """Add the answer to an INPUT; `number` counts INPUTs from 0."""
        del self.answers[number:]
        self.answers.append(Answered(statement, text))

    def at(self, statement: int) -> Sequence[Assigned | Entered]:
        """Return the changes before a statement."""
        return [each for each in self.changes if each.statement == statement]

    def following(self, statement: int) -> float:
        """Return the number of the next statement with a change; infinity if none."""
        return min((each.statement for each in self.changes if each.statement > statement), default=inf)

    def _truncate(self, statement: int) -> None:
        self.changes = [each for each in self.changes if each.statement <= statement]
        self.answers = [each for each in self.answers if each.statement < statement]
