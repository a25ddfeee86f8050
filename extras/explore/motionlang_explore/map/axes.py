"""The axes of a program: how each is enabled, homed, moved and limited."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from motionlang.kernel.lang import TOPICS, AxisUse, Named, Structure

# What a reader sees for each topic of `keyword.TOPICS`.
TITLES = {
    "enable": "enabled",
    "home": "homed and zeroed",
    "move": "moves",
    "speed": "speeds and rates",
    "limit": "limits",
    "master": "master",
    "scale": "scale",
    "servo": "servo",
    "stop": "stopped",
}


@dataclass(eq=False, slots=True)
class AxisFact:
    """A keyword that the program applies to an axis with one value, and the lines where it does.

    `is_computed` is True if the value is not known before the run.
    """

    topic: str
    keyword: str
    value: str
    is_computed: bool
    lines: list[int] = field(default_factory=list)

    @property
    def text(self) -> str:
        """The keyword and its value."""
        return f"{self.keyword} = {self.value}" if self.value else self.keyword


@dataclass(eq=False, slots=True)
class AxisMap:
    """An axis, None for statements whose axis is known only at run time, or that are about all axes."""

    axis: int | None
    name: str = ""
    facts: list[AxisFact] = field(default_factory=list)

    @property
    def title(self) -> str:
        """The number and the name of the axis."""
        shown = "all or any" if self.axis is None else str(self.axis)
        return f"axis {shown} ({self.name})" if self.name else f"axis {shown}"

    def of(self, topic: str) -> list[AxisFact]:
        """Return the facts of a topic."""
        return [each for each in self.facts if each.topic == topic]


def axes(structure: Structure, names: Sequence[Named]) -> list[AxisMap]:
    """Return the axes of a program in the order of their numbers; statements for all axes come last."""
    found: dict[int | None, AxisMap] = {}
    facts: dict[tuple[int | None, str, str], AxisFact] = {}
    for statement in structure.statements.values():
        for use in statement.axes:
            axis = found.setdefault(use.axis, AxisMap(use.axis))
            key = use.axis, use.row.name, use.value
            if key not in facts:
                facts[key] = fact = _fact(use)
                axis.facts.append(fact)
            if statement.line not in facts[key].lines:
                facts[key].lines.append(statement.line)
    for axis in found.values():
        axis.facts.sort(key=lambda fact: (TOPICS.index(fact.topic), min(fact.lines)))
        named = (each.name for each in names if each.kind == "axis" and each.number == axis.axis)
        axis.name = next(named, "").partition(" (")[0]
    return sorted(found.values(), key=lambda axis: (axis.axis is None, axis.axis or 0))


def _fact(use: AxisUse) -> AxisFact:
    return AxisFact(use.row.topic, use.row.name, use.value, bool(use.value) and use.number is None)
