"""The cycles of a machine: transitions that return to a state, work that repeats without a rest, runs that end.

A person names the cycle that makes the piece: it has the most moves that the way there does not have (so neither
homing nor recovery), and needs the fewest changes of the world, each at the state that waits for it. What comes by
itself, such as a time-out, counts against it, and a handler or a fault much more.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from motionlang.commands.explore.rests import RestState
from motionlang.commands.explore.search import Node, Transition
from motionlang.commands.explore.trials import Timeline, Trial

# The longest cycle, in transitions, and the largest number of cycles that are compared.
MAX_LENGTH, MAX_CYCLES = 8, 20_000
# What counts for a cycle: each line that moves an axis in it, and not on the way there. Against it: each change of the
# world, one at the same time as another, one on the way there, a transition that comes by itself, one that is cut off,
# and a cycle that is one run of the program.
MOVE, CHANGE, TOGETHER, BEFORE, BY_ITSELF, CUT, WHOLE_RUN = 2.0, 1.0, 0.5, 0.5, 3.0, 20.0, 5.0
# Work without a rest repeats a line so often, and goes on for this share of a trial.
MIN_REPEATS, LAST_SHARE = 3, 0.6


@dataclass(frozen=True)
class Cycle:
    """A repetition of a machine: its transitions, none for work without a rest.

    `timeline` leads there, `lines` are those that move an axis in it. The likelier a person names it, the larger is
    its `value`.
    """

    transitions: tuple[Transition, ...]
    timeline: Timeline
    lines: tuple[int, ...]
    value: float

    @property
    def states(self) -> tuple[RestState | None, ...]:
        """The states of the cycle, in order."""
        return tuple(each.source for each in self.transitions)


def cycles(nodes: Mapping[RestState | None, Node], work: list[Cycle]) -> list[Cycle]:
    """Return the cycles of an exploration with motion, the likeliest first; of those of the same states the best."""
    found = [*_loops(nodes), *_runs(nodes), *work]
    best: dict[object, Cycle] = {}
    for each in sorted(found, key=lambda cycle: (-cycle.value, len(cycle.timeline), cycle.lines)):
        best.setdefault(frozenset(each.states) if each.states else each.lines, each)
    return list(best.values())


def _loops(nodes: Mapping[RestState | None, Node]) -> Iterator[Cycle]:
    count = 0
    for start, node in nodes.items():
        if start is None:
            continue
        paths: deque[tuple[Transition, ...]] = deque([()])
        while paths and count < MAX_CYCLES:
            path = paths.popleft()
            here = path[-1].target if path else start
            on_path = {each.source for each in path} | {start}
            for each in nodes[here].transitions if here in nodes else ():
                if each.target == start:
                    count += 1
                    whole = (*path, each)
                    if any(one.lines for one in whole) and any(one.causes for one in whole):
                        yield _cycle(whole, node)
                elif each.target is not None and each.target not in on_path and len(path) + 1 < MAX_LENGTH:
                    paths.append((*path, each))


def _runs(nodes: Mapping[RestState | None, Node]) -> Iterator[Cycle]:
    """Yield the runs that end after a piece."""
    for node in nodes.values():
        for each in node.transitions:
            if each.target is None and (each.lines or node.moved):
                lines = each.lines or tuple(sorted(node.moved))
                yield Cycle((each,), node.timeline, lines, _value((each,), node, lines) - WHOLE_RUN)


def _cycle(transitions: tuple[Transition, ...], node: Node) -> Cycle:
    lines = tuple(line for each in transitions for line in each.lines)
    return Cycle(transitions, node.timeline, lines, _value(transitions, node, lines))


def _value(transitions: tuple[Transition, ...], node: Node, lines: tuple[int, ...]) -> float:
    """Return the likelihood that a person names a cycle."""
    value = MOVE * len(set(lines) - node.moved) - BEFORE * len(node.timeline)
    for each in transitions:
        value -= CHANGE * len(each.causes) + TOGETHER * max(len(each.causes) - 1, 0)
        value -= BY_ITSELF * (not each.causes) + CUT * each.is_cut
    return value


def working(trial: Trial, node: Node) -> Cycle | None:
    """Return the work that a trial repeats to its end without a rest; None if it does not."""
    starts = [(move.begin, move.line) for move in trial.moves if move.begin >= trial.since]
    if trial.status != "until" or not starts:
        return None
    middle = 0.5 * (trial.since + starts[-1][0])  # what it does in the end, not the homing
    late = [(time, line) for time, line in starts if time > middle]
    counts = Counter(line for _, line in late)
    often = [line for _, line in late if counts[line] >= MIN_REPEATS]
    if not often or starts[-1][0] < trial.since + LAST_SHARE * (trial.time - trial.since):
        return None
    least = min(counts[line] for line in often)
    period = tuple(often[: max(1, len(often) // least)])
    first = next(time for time, line in late if line in often)
    before = {line for time, line in starts if time < first} - set(often)
    value = MOVE * len(set(period) - node.moved - before) - BEFORE * len(trial.timeline)
    return Cycle((), trial.timeline, period, value)
