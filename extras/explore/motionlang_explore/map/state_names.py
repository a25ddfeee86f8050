"""The states of a machine as a reader tells them apart: by where it waits, and by what it remembers there.

Problem. A program that asks all its inputs in every scan waits in the same loop whatever it does. Its states differ by
a branch of the loop, or by the variable of its step alone.

Idea. What is repeated in most states is said once. States at the same place are one, but for the step: the variable
with the most values of those that are read there. A state is called by what is left of its place, and by what few
others remember.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Collection, Hashable, Iterable, Iterator, Sequence

from motionlang.kernel.lang import ACTS, READ, Statement, Structure
from motionlang_explore.exploration import (
    RestState,
    StateNode,
    TaskRest,
    lines_of,
    statements_of,
    without_memory,
)

# So many variables are in a name, and a step has so many values at least.
MAX_NAMED, STEPS = 3, 3
# A state with more ranges of lines is called by the first and the last one.
MAX_RANGES = 4


class StateNames:
    """The names of the states of an exploration; `groups` are the states with the same name, in order."""

    def __init__(self, nodes: Sequence[StateNode], structure: Structure) -> None:
        self._structure = structure
        # The variables that each statement reads.
        self._reads = defaultdict[int, set[int]](set)
        for point, uses in zip(structure.points, structure.graph.uses, strict=False):
            self._reads[point.at] |= uses.reads if uses is not None else set()
        # What is repeated in more than half of the states, of a machine with several.
        self._usual: list[TaskRest] = []
        places = list(dict.fromkeys(self._asking(node.state) for node in nodes if node.state is not None))
        often = defaultdict[TaskRest, Counter[int]](Counter)
        for each in (each for place in places for each in place or ()):
            often[each._replace(statements=frozenset())].update(each.statements)
        for task, counts in often.items() if len(places) > 2 else ():
            usual = frozenset(at for at, count in counts.items() if 2 * count > len(places))
            self._usual += [task._replace(statements=usual)] if usual else []
        self.groups = list(self._grouped(nodes))
        self._names: dict[RestState | None, str] = {}
        # The variables in the name of each state.
        self._named: dict[RestState | None, set[int]] = {}
        lines = [lines_of(self.shown(group[0].state), structure.line, MAX_RANGES) for group in self.groups]
        known = [dict(each) for each in self._remembered()]
        told = [" and ".join(self._told(*pair) for pair in each.items()) for each in known]
        count = Counter(zip(lines, told, strict=True))
        for group, line, few, more in zip(self.groups, lines, known, told, strict=True):
            is_one = count[line, more] == 1
            text = ", ".join(filter(None, [more, "" if is_one else self.statement(group[0].state)]))
            for node in group:
                self._names[node.state] = f"{line} ({text})" if text else line
                self._named[node.state] = set(few)

    def __getitem__(self, state: RestState | None) -> str:
        return self._names[state]

    def shown(self, state: RestState | None) -> RestState | None:
        """Return a state without what is repeated in most states; all of it if nothing is left."""
        place, left = self._asking(state), []
        for each in place or ():
            same = (one for one in self._usual if (one.task, one.callers) == (each.task, each.callers))
            own = each.statements.difference(*(one.statements for one in same))
            left += [each._replace(statements=own)] if own else []
        return tuple(left) or place

    def _asking(self, state: RestState | None) -> RestState | None:
        """Return the place of a state without the statements that only set something, unless all are such."""
        left = []
        for each in without_memory(state) or ():
            asking = frozenset(at for at in each.statements if _asks(self._structure.statements[at]))
            left.append(each._replace(statements=asking or each.statements))
        return None if state is None else tuple(left)

    def statement(self, state: RestState | None) -> str:
        """Return the first statement of each place of a state, without what is repeated in most states."""
        return statements_of(self.shown(state) or (), self._structure)

    def remarks(self) -> Iterator[str]:
        """Yield what is repeated in most states."""
        tasks = {each.task for state in self._names for each in state or ()}
        for each in self._usual:
            who = each.task if len(tasks) > 1 else "the program"
            lines = lines_of((each,), self._structure.line)
            yield f"in most states {who} waits in {lines}: {statements_of((each,), self._structure)}"

    def deciding(self, states: Iterable[RestState | None], others: Iterable[RestState | None]) -> list[str]:
        """Return the variables that some states have with other values than others, such as "good = 0"."""
        mine, theirs = (list(map(_memory, some)) for some in (states, others))
        found = []
        for number in mine[0]:
            values = dict.fromkeys(each.get(number) for each in mine)
            if None in values:
                continue  # not all of these states remember it
            if not values.keys() & {each.get(number) for each in theirs}:
                found.append(self._told(number, *values))
        return found

    def changed(self, source: RestState | None, target: RestState | None) -> list[str]:
        """Return the variables that have other values in a later state, but for those in its name."""
        before, after = _memory(source), _memory(target)
        others = after.keys() & before.keys() - self._named.get(target, set())
        return [self._told(n, after[n]) for n in sorted(others) if after[n] != before[n]]

    def _told(self, number: int, *values: object) -> str:
        name = self._structure.variables.get(number, "?")
        shown = [f"{each:.6g}" if isinstance(each, (bool, float)) else str(each) for each in values]
        # A state remembers only if an answer is 0.
        is_any = any(each is True for each in values)
        return f"{name} is not 0" if is_any else f"{name} = {' or '.join(shown)}"

    def _grouped(self, nodes: Collection[StateNode]) -> Iterator[list[StateNode]]:
        """Yield the states at one place, those of each step by themselves."""
        places = defaultdict[Hashable, list[StateNode]](list)
        for node in nodes:
            place = self._asking(node.state)
            places[lines_of(place, self._structure.line), self.statement(node.state)].append(node)
        values = _values(nodes)
        for group in places.values():
            place = self._asking(group[0].state)
            read = set[int]().union(*(self._reads[at] for each in place or () for at in each.statements))
            own = {n: many for n, many in _values(group).items() if len(values[n]) >= STEPS and n in read}
            step = max(own, key=lambda n: len(own[n]), default=-1)
            step = step if len(own.get(step, ())) > 1 else -1
            steps = defaultdict[object, list[StateNode]](list)
            for node in group:
                steps[_memory(node.state).get(step)].append(node)
            yield from steps.values()

    def _remembered(self) -> Iterator[list[tuple[int, object]]]:
        """Yield for each group the variables with values that few groups have, those with the most values first."""
        known = [{pair for node in group for pair in _memory(node.state).items()} for group in self.groups]
        often = Counter(pair for pairs in known for pair in pairs)
        having = Counter(number for pairs in known for number in {number for number, _ in pairs})
        values = Counter(number for number, _ in often)
        for pairs in known:
            own = Counter(number for number, _ in pairs)
            few = [
                (number, value)
                for number, value in pairs
                if own[number] == 1 and 2 * often[number, value] <= having[number]
            ]
            few.sort(key=lambda pair: (-values[pair[0]], pair[0]))
            yield few[:MAX_NAMED]


def _asks(statement: Statement) -> bool:
    """True if a statement waits, decides, reads a channel, or leads elsewhere."""
    reads = any(use.access == READ for use in statement.channels)
    return bool(statement.condition or statement.waits) or reads or statement.effect != ACTS


def _memory(state: RestState | None) -> dict[int, object]:
    """Return the values of the variables that a program remembers in a state, by their numbers."""
    return dict(pair for place in state or () for pair in place.memory)


def _values(nodes: Iterable[StateNode]) -> dict[int, set[object]]:
    """Return the values of each variable that a program remembers in some states."""
    values = defaultdict[int, set[object]](set)
    for number, value in (pair for node in nodes for pair in _memory(node.state).items()):
        values[number].add(value)
    return values
