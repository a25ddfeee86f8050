"""An exploration as text: a row for each transition, and the cycles."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator

from motionlang.kernel.lang import Structure
from motionlang.kernel.tools import count_of
from motionlang_explore.exploration import (
    Exploration,
    FoundWorld,
    MachineCycle,
    StateNode,
    Transition,
    in_words,
)
from motionlang_explore.exploration.rests import lines_of, statements_of

# So many cycles are shown, and so many acts of a transition.
MAX_CYCLES, MAX_ACTS = 3, 8


def exploration_text(found: Exploration) -> str:
    """Return the states of a program with their transitions, its likeliest cycles and a world."""
    structure = found.program.structure
    line = structure.line
    states = count_of(len(found.nodes) - 1, "state")
    lines = [f"{found.program.source.name}: {states}, {count_of(found.trials, 'trial')}"]
    for node in found.nodes:
        lines += ["", _head(node, structure), *_rows(node, line)]
    if found.cycles:
        lines += ["", "cycles", *(f"  {_cycle(each, line)}" for each in found.cycles[:MAX_CYCLES])]
    if found.cycles or found.world.settings:
        lines += ["", *_world(found.world)]
    return "\n".join(lines) + "\n"


def _world(world: FoundWorld) -> Iterator[str]:
    """Yield the entries of a world in the form of a machine file, and how often lines then move an axis."""
    lines = Counter(each.line for each in world.run.machine.log.moves)
    counts = ", ".join(f"line {line} {count_of(count, 'move')}" for line, count in sorted(lines.items()))
    yield f"its world, played {count_of(world.times, 'time')}: {counts} in {world.run.time:.2f} s"
    for table, entries in world.settings.items():
        assert isinstance(entries, list)
        yield from (
            f"  [[{table}]] {', '.join(f'{key} = {value!r}' for key, value in each.items())}"
            for each in entries
        )


def causes_of(transition: Transition) -> str:
    """Return what leads to a transition, in words."""
    if not transition.causes:
        return f"by itself after {transition.seconds:.2f} s" if transition.source is not None else "by itself"
    return in_words(transition.causes)


def _head(node: StateNode, structure: Structure) -> str:
    if node.state is None:
        return "power-up"
    return f"waits in {lines_of(node.state, structure.line)}: {statements_of(node.state, structure)}"


def _rows(node: StateNode, line: Callable[[int], int]) -> Iterator[str]:
    for each in node.transitions:
        acts = ", ".join((*map(str, each.acts[:MAX_ACTS]), *(["…"] if len(each.acts) > MAX_ACTS else [])))
        target = "end" if each.target is None else lines_of(each.target, line)
        yield f"  {causes_of(each)} → {target}, {each.seconds:.2f} s{': ' if acts else ''}{acts}"


def _cycle(cycle: MachineCycle, line: Callable[[int], int]) -> str:
    lines = ", ".join(map(str, dict.fromkeys(cycle.lines)))
    steps = " → ".join(f"{lines_of(each.source, line)} ({causes_of(each)})" for each in cycle.transitions)
    return f"{steps or 'work without a rest'}; lines {lines} move axes"
