"""An exploration as text: a row for each transition, and the cycles."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence

from motionlang.commands.explore.cycles import Cycle
from motionlang.commands.explore.rests import RestState, TaskRest
from motionlang.commands.explore.search import Node, Transition
from motionlang.commands.explore.world import World
from motionlang.kernel import Program
from motionlang.kernel.tools import count_of

# So many cycles are shown, and so many acts of a transition.
MAX_CYCLES, MAX_ACTS = 3, 8


def exploration_text(
    program: Program, nodes: Sequence[Node], trials: int, cycles: Sequence[Cycle], world: World
) -> str:
    """Return the states of a program with their transitions, its likeliest cycles and a world."""
    source, names = program.source, _Names(program.structure.line)
    states = count_of(len(nodes) - 1, "state")
    lines = [f"{source.name}: {states}, {count_of(trials, 'trial')}"]
    for node in nodes:
        lines += ["", names.head(node, source.line), *names.rows(node)]
    if cycles:
        lines += ["", "cycles", *(f"  {names.cycle(each)}" for each in cycles[:MAX_CYCLES])]
        lines += ["", *_world(world)]
    return "\n".join(lines) + "\n"


def _world(world: World) -> Iterator[str]:
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


class _Names:
    """Names of states by their lines."""

    def __init__(self, line: Callable[[int], int]) -> None:
        self._line = line

    def of(self, state: RestState | None) -> str:
        """Return the lines of a state, with those of the calls that lead there."""
        if state is None:
            return "power-up"
        return " and ".join(map(self._place, state))

    def _place(self, place: TaskRest) -> str:
        lines = ", ".join(map(str, sorted({self._line(at) for at in place.statements})))
        calls = ", ".join(str(self._line(at)) for at in place.callers)
        return f"{lines} called in {calls}" if calls else lines

    def head(self, node: Node, text: Callable[[int], str]) -> str:
        if node.state is None:
            return "power-up"
        heads = (text(min(map(self._line, place.statements))).strip() for place in node.state)
        return f"waits in {self.of(node.state)}: {' | '.join(heads)}"

    def rows(self, node: Node) -> Iterator[str]:
        for each in node.transitions:
            acts = ", ".join((*each.acts[:MAX_ACTS], *(["…"] if len(each.acts) > MAX_ACTS else [])))
            target = "end" if each.target is None else self.of(each.target)
            yield f"  {_causes(each)} → {target}, {each.seconds:.2f} s{': ' if acts else ''}{acts}"

    def cycle(self, cycle: Cycle) -> str:
        lines = ", ".join(map(str, dict.fromkeys(cycle.lines)))
        steps = " → ".join(f"{self.of(each.source)} ({_causes(each)})" for each in cycle.transitions)
        return f"{steps or 'work without a rest'}; lines {lines} move axes"


def _causes(transition: Transition) -> str:
    if not transition.causes:
        return f"by itself after {transition.seconds:.2f} s" if transition.source is not None else "by itself"
    return " and ".join(map(str, transition.causes))
