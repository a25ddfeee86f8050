"""The steps of a program beside its lines, for people to read."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

from motionlang.kernel.lang.step_graph import StepGraph
from motionlang.kernel.lang.steps import CALL, COMMAND, NAMES, Step, Steps
from motionlang.kernel.source import Source


@dataclass(eq=False, slots=True)
class ListedStep:
    """A step: its index, the name of its kind, the index of its target, and the statements that it pays.

    The target is -1 if there is none or if the step computes it.
    """

    index: int
    kind: str
    target: int
    cost: float


@dataclass(eq=False, slots=True)
class ListedLine:
    """Consecutive steps of one line of the program, 0 for steps of no line."""

    line: int
    text: str
    steps: list[ListedStep]


@dataclass(eq=False, slots=True)
class ListedUnit:
    """The steps of the program itself, of a sub, task or handler, or of a line that is written by itself."""

    name: str
    lines: list[ListedLine]


def listed_units(source: Source, graph: StepGraph) -> list[ListedUnit]:
    """Return the steps of a program, those of each unit grouped by their lines."""
    return [_unit(source, graph, steps) for steps in graph.listed]


def _unit(source: Source, graph: StepGraph, steps: Steps) -> ListedUnit:
    first, lines = graph.first(steps), list[ListedLine]()

    def line_of(found: tuple[int, Step]) -> int:
        at = graph.points[first + found[0]].at
        return source.location(at)[0] if at >= 0 else steps.line_number

    for line, group in groupby(enumerate(steps), line_of):
        lines.append(ListedLine(line, source.line(line) if line else "", [_listed(*each) for each in group]))
    return ListedUnit(steps.title, lines)


def _listed(index: int, step: Step) -> ListedStep:
    cost = 1.0 if step.kind == COMMAND else step.cost
    target = -1 if step.kind == CALL else step.to  # a call is of other steps
    return ListedStep(index, NAMES[step.kind], target, cost)
