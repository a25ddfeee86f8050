"""The cycles of a machine: transitions that return to a state, work that repeats without a rest, runs that end.

A person names the cycle that makes the piece: it has the most moves that the machine does not make at power-up, and
needs the fewest changes of the world, each at the state that waits for it. What comes by itself, such as a time-out,
counts against it, and a handler or a fault much more.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Collection, Hashable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import fsum
from typing import NamedTuple

from motionlang_explore.exploration.changes import Channel
from motionlang_explore.exploration.rests import RestState
from motionlang_explore.exploration.states import StateNode, Transition, Visit, Work
from motionlang_explore.exploration.words import is_right, speaks, wrong

# The longest cycle, in transitions, and the largest number of cycles that are compared.
MAX_LENGTH, MAX_CYCLES = 8, 20_000
# What counts for a cycle: each line that moves an axis in it, and not before the first change, less if its moves never
# end by themselves, and each output that is switched on. Against it: each change of the world, less for an answer, as
# the program asks for it; one at the same time as another, one on the way there, a transition that comes by itself, one
# that is cut off, and a cycle that is one run.
MOVE, PART, OUTPUT = 3.0, 2.0, 0.5
CHANGE, ANSWER, TOGETHER, BEFORE, BY_ITSELF, CUT, WHOLE_RUN, STATE = 1.0, 0.25, 0.6, 0.1, 10.0, 20.0, 5.0, 0.5
# A transition by itself that says what is right or moves to a target is what a change before has led to, such as a part
# on a belt.
LATER = 2.0
# A person names the cycle that carries out most of a program: so much for all of its statements.
WHOLE = 0.4
# What a person does that only jogs, and work of one line without a rest, may be no work if it neither switches nor
# prints anything.
JOGGING = 10.0
# A cycle that says something in words, and nothing of what is wrong, makes a piece, and the more so if it says what is
# right; the more of it is wrong, the less it counts.
SAID, RIGHT, WRONG = 2.0, 0.5, 20.0
# A cycle that says nothing is part of one that says something, does more, and has less of a value by so much at most.
# So many of these, the likeliest, are compared.
PIECE, PIECES = 5.0, 20
# Of cycles that are alike otherwise the one counts more that keeps fewer inputs, switches fewer outputs, and takes less
# time, s.
KEPT, SWITCHED, SECOND = 0.0001, 0.001, 0.001
# States that a person leaves by something that is right: what ends such a stay by itself is a time-out.
Left = Collection[RestState | None]
# Work is faster than other work if it takes this share of its time.
FASTER = 0.95


@dataclass(frozen=True)
class MachineCycle:
    """A repetition of a machine: its transitions, none for work without a rest.

    `visit` leads there, `lines` are those that move an axis in it, `work` those that do more than a homing; `done` are
    those of them with a move that ends by itself, and `outputs` are switched on. The likelier a person names it, the
    larger is its `value`.
    """

    transitions: tuple[Transition, ...]
    visit: Visit
    lines: tuple[int, ...]
    work: frozenset[int]
    done: frozenset[int]
    outputs: frozenset[int]
    value: float

    @property
    def states(self) -> tuple[RestState | None, ...]:
        """The states of the cycle, in order."""
        return tuple(each.source for each in self.transitions)

    @property
    def begun(self) -> frozenset[int]:
        """The source offsets of the statements that begin in its transitions."""
        return frozenset[int]().union(*(each.begun for each in self.transitions))

    @property
    def asked(self) -> list[RestState | None]:
        """Its states that ask a question."""
        return [each.source for each in self.transitions if any(one.table == "answer" for one in each.causes)]

    @property
    def said(self) -> list[str]:
        """The lines printed in it, in order."""
        return _said(self.transitions)

    @property
    def does_work(self) -> bool:
        """True if it moves an axis, and does not only jog."""
        return bool(self.work) and bool(self.done or self.outputs or self.said)

    @property
    def repeats(self) -> bool:
        """True if it returns to its first state; False if it is one run of the program."""
        return not self.transitions or self.transitions[-1].target is not None


class _Known(NamedTuple):
    """The number of `statements` of a program, and the lines that move an axis `at_start`, before any change.

    `left` are the states that a person leaves, `alarms` the outputs of alarms. `stops` is True if the program says at
    power-up that the machine has stopped: it says so whenever it waits for work.
    """

    statements: int
    at_start: frozenset[int]
    left: Left
    alarms: frozenset[int]
    stops: bool


def cycles(
    nodes: Mapping[RestState | None, StateNode],
    work: Iterable[Work],
    statements: int,
    alarms: frozenset[int],
) -> list[MachineCycle]:
    """Return the cycles of an exploration, the likeliest first and those without motion, or that only jog, last.

    Of those of the same states it is the best. What switches on one of the outputs `alarms` counts less.
    """
    moved = (node.first.moved for node in nodes.values() if not node.first.timeline)
    # The states that a person leaves, and those that only end by themselves.
    left = {state for state, node in nodes.items() if any(map(_is_done, node.transitions))}
    stops = any(each.stops for node in nodes.values() if node.state is None for each in node.transitions)
    known = _Known(statements, frozenset[int]().union(*moved), left, alarms, stops)
    found = [*_loops(nodes, known), *_runs(nodes, known), *_without_rest(work, known)]
    best: dict[object, MachineCycle] = {}
    for each in sorted(
        found, key=lambda cycle: (not cycle.does_work, -cycle.value, len(cycle.visit.timeline), cycle.lines)
    ):
        best.setdefault((each.repeats, frozenset(each.states) if each.states else each.work), each)
    menus = {each.transitions[-1].source for each in best.values() if _ends_menu(each)}
    left_over = [each for each in best.values() if not (each.repeats and menus.intersection(each.asked))]
    pieces = [each for each in left_over if each.repeats and each.said and not wrong(each.said)]
    return sorted(left_over, key=lambda each: _is_part(each, pieces[:PIECES]))


def _is_part(one: MachineCycle, pieces: Iterable[MachineCycle]) -> bool:
    """True if a cycle says nothing, and another one that does makes the same moves and more."""
    return not one.said and any(one.work < each.work and one.value - each.value < PIECE for each in pieces)


def _ends_menu(cycle: MachineCycle) -> bool:
    """True if a run ends by the answer to a question that has several others: each is given once."""
    *others, last = cycle.asked or [None]
    return not cycle.repeats and others.count(last) > 1 and last == cycle.transitions[-1].source


def _is_done(each: Transition) -> bool:
    """True if a person does something that leads on, and to nothing that is wrong."""
    return _is_right(each) and each.target != each.source


def _is_right(each: Transition) -> bool:
    """True if a person does something, and nothing that is wrong follows."""
    return not (each.is_by_itself or each.is_cut or each.faults)


def _loops(nodes: Mapping[RestState | None, StateNode], known: _Known) -> Iterator[MachineCycle]:
    count = 0
    before: dict[RestState | None, list[RestState]] = defaultdict(list)
    for state, node in nodes.items():
        if state is not None:
            for each in node.transitions:
                before[each.target].append(state)
    for start, node in nodes.items():
        if start is None:
            continue
        left = _distances(start, before)
        paths: deque[tuple[Transition, ...]] = deque([()])
        while paths and count < MAX_CYCLES:
            path = paths.popleft()
            here = path[-1].target if path else start
            on_path = {each.source for each in path} | {start, here}
            for each in nodes[here].transitions if here in nodes else ():
                if each.target == start:
                    count += 1
                    yield from _loop((*path, each), node, known)
                elif (
                    each.target not in on_path and len(path) + left.get(each.target, MAX_LENGTH) < MAX_LENGTH
                ):
                    paths.append((*path, each))


def _distances(
    start: RestState, before: Mapping[RestState | None, Iterable[RestState]]
) -> dict[RestState | None, int]:
    """Return the fewest transitions by which states return to one, below the length of a cycle.

    `before` are the states that lead to each state.
    """
    found: dict[RestState | None, int] = {start: 0}
    waiting = deque([start])
    while waiting:
        here = waiting.popleft()
        for each in before.get(here, ()) if found[here] + 1 < MAX_LENGTH else ():
            if each not in found:
                found[each] = found[here] + 1
                waiting.append(each)
    return found


def _loop(transitions: tuple[Transition, ...], node: StateNode, known: _Known) -> Iterator[MachineCycle]:
    """Yield a loop with changes; what is only known of a later visit is a loop that begins there."""
    first, is_later = transitions[0], any(each.is_later for each in transitions)
    is_refused = len(transitions) == 1 and first.causes in node.refused
    if is_refused or (is_later and not first.is_later):
        return
    visit = first.visit if is_later else node.first
    if any(each.causes for each in transitions):
        lines = tuple(line for each in transitions for line in each.lines)
        work, done, outputs = _work(transitions), _done(transitions), _outputs(transitions)
        value = _value(transitions, visit, work - known.at_start, done, outputs, known)
        value -= JOGGING * (not (done or outputs or _said(transitions)))
        yield MachineCycle(transitions, visit, lines, work, done, outputs, value)


def _runs(nodes: Mapping[RestState | None, StateNode], known: _Known) -> Iterator[MachineCycle]:
    """Yield the runs that end after a piece; all changes that lead there are changes of the cycle.

    Where a run ends by a choice, each other choice is made once before.
    """
    for node in nodes.values():
        for each in node.transitions:
            if each.target is None:
                is_choice = any(one.table != "input" for one in each.causes)
                path = (*(_others(node, each) if is_choice else ()), each)
                lines = dict.fromkeys((*sorted(node.moved), *(line for one in path for line in one.lines)))
                work, done, outputs = _work(path) | each.visit.moved, _done(path), _outputs(path)
                changes = sum(change.table != "answer" for _, change in each.visit.timeline)
                value = _value(path, each.visit, work - known.at_start, done, outputs, known)
                value -= CHANGE * changes + WHOLE_RUN
                yield MachineCycle(path, each.visit, tuple(lines), work, done, outputs, value)


def _others(node: StateNode, last: Transition) -> Iterator[Transition]:
    """Yield the transitions back to a state that do what no one before did, but for what ends the run."""
    known = {last.does}
    for each in node.transitions:
        is_choice = each.causes and each.visit is last.visit and each.target == node.state
        is_new = _is_right(each) and each.acts and each.does not in known
        if is_choice and is_new and each.causes not in node.refused:
            known.add(each.does)
            yield each


def _without_rest(works: Iterable[Work], known: _Known) -> Iterator[MachineCycle]:
    """Yield work without a rest; what does the same says less of what is wrong, and is faster than time-outs."""

    def faults(work: Work) -> tuple[bool, int]:
        return bool(work.said) and all(wrong([each]) for each in work.said), wrong(work.said)

    fastest: dict[Hashable, Work] = {}
    for work in works:
        does = work.lines, work.outputs
        other = fastest.setdefault(does, work)
        if (faults(work), work.period) < (faults(other), FASTER * other.period):
            fastest[does] = work
    for work in fastest.values():
        value = MOVE * len(work.done) + PART * len(work.lines - work.done)
        value += OUTPUT * bool(work.outputs) - BEFORE * len(work.timeline)
        value -= WRONG if wrong(work.said) else -_praise(work.said)
        value += WHOLE * len(work.begun) / known.statements - WRONG * bool(work.outputs & known.alarms)
        value -= JOGGING * (len(work.lines) == 1 and not work.outputs and not work.said)
        begin = max((time for time, _ in work.timeline), default=0.0)
        visit, lines = Visit(work.timeline, begin), tuple(sorted(work.lines))
        yield MachineCycle((), visit, lines, work.lines, work.done, work.outputs, value)


def _work(transitions: Iterable[Transition]) -> frozenset[int]:
    return frozenset[int]().union(*(each.work for each in transitions))


def _done(transitions: Iterable[Transition]) -> frozenset[int]:
    return frozenset[int]().union(*(each.done for each in transitions))


def _outputs(transitions: Iterable[Transition]) -> frozenset[int]:
    return frozenset[int]().union(*(each.outputs for each in transitions))


def _said(transitions: Iterable[Transition]) -> list[str]:
    return [text for each in transitions for text in each.said]


def _praise(said: Iterable[str]) -> float:
    words = list(filter(speaks, said))
    return SAID * bool(words) + RIGHT * any(map(is_right, words))


def _value(
    transitions: tuple[Transition, ...],
    visit: Visit,
    work: frozenset[int],
    done: frozenset[int],
    outputs: frozenset[int],
    known: _Known,
) -> float:
    """Return the likelihood that a person names a cycle.

    An input that has one level in all of the cycle is no change that anybody makes.
    """
    value = MOVE * len(work & done) + PART * len(work - done)
    begun = frozenset[int]().union(*(each.begun for each in transitions))
    value += WHOLE * len(begun) / known.statements
    value += OUTPUT * bool(outputs) - BEFORE * len(visit.timeline) - WRONG * bool(outputs & known.alarms)
    levels: dict[Channel, set[object]] = {}
    for each in transitions:
        for one in each.causes:
            levels.setdefault(one.channel, set()).add(one.value)
    for each in transitions:
        made = [one for one in each.causes if one.table != "input" or len(levels[one.channel]) > 1]
        answers = sum(one.table == "answer" for one in made)
        value -= CHANGE * (len(made) - answers) + ANSWER * answers
        value -= TOGETHER * max(len(each.causes) - answers - 1, 0) + KEPT * (len(each.causes) - len(made))
        if each.is_by_itself and each.source in known.left:
            value -= BY_ITSELF if each.faults or not (each.said or each.done) else LATER
        value -= CUT * each.is_cut + SECOND * each.seconds
        value -= STATE * (not answers)
    said = _said(transitions)
    faults = fsum(each.faults + (0 if known.stops else each.stops) for each in transitions)
    value -= WRONG * (1.0 + faults / len(said)) if faults else -_praise(said)
    return value + STATE - SWITCHED * len(outputs)
