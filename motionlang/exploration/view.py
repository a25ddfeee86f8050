"""An exploration as text: a row for each transition, and the cycles."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence

from motionlang.exploration.changes import in_words
from motionlang.exploration.cycles import MachineCycle
from motionlang.exploration.rests import RestState, TaskRest
from motionlang.exploration.states import StateNode, Transition
from motionlang.exploration.world import FoundWorld
from motionlang.kernel import Program
from motionlang.kernel.lang import Structure
from motionlang.kernel.tools import count_of, ranges

# So many cycles are shown, and so many acts of a transition.
MAX_CYCLES, MAX_ACTS = 3, 8


def exploration_text(
    program: Program,
    nodes: Sequence[StateNode],
    trials: int,
    cycles: Sequence[MachineCycle],
    world: FoundWorld | None,
) -> str:
    """Return the states of a program with their transitions, its likeliest cycles and a world, None if cut off."""
    structure = program.structure
    line = structure.line
    states = count_of(len(nodes) - 1, "state")
    lines = [f"{program.source.name}: {states}, {count_of(trials, 'trial')}"]
    for node in nodes:
        lines += ["", _head(node, structure), *_rows(node, line)]
    if cycles:
        lines += ["", "cycles", *(f"  {_cycle(each, line)}" for each in cycles[:MAX_CYCLES])]
    if world is None:
        lines += ["", "cut off before its world was found"]
    elif cycles or world.settings:
        lines += ["", *_world(world)]
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


def lines_of(state: RestState | None, line: Callable[[int], int]) -> str:
    """Return the lines of a state, with those of the calls that lead there; `line` is that of a source offset."""
    if state is None:
        return "power-up"
    return " and ".join(_place(each, line) for each in state)


def _place(place: TaskRest, line: Callable[[int], int]) -> str:
    lines = ranges(line(at) for at in place.statements)
    calls = ", ".join(str(line(at)) for at in place.callers)
    return f"{lines} called in {calls}" if calls else lines


def statements_of(state: RestState, structure: Structure) -> str:
    """Return the first statement of each place of a state."""
    return " | ".join(structure.statements[min(place.statements)].text for place in state)


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
