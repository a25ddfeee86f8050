"""The rests of a trial: where each task waits, or repeats a loop while no axis is on its way to an end."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from math import inf
from typing import NamedTuple

from motionlang.commands.explore.trials import GAP, HANDLERS, Begun, Motion, Trial

# What begins so soon after the first statement of a loop belongs to it, s.
BODY = 0.1
# A statement of a loop repeats more often than this.
MIN_REPEATS = 1


class RestState(NamedTuple):
    """The place where a task rests: the statements that it repeats or waits at, and the calls that lead there."""

    task: str
    statements: frozenset[int]
    callers: tuple[int, ...] = ()


class Rest(NamedTuple):
    """A stay in a rest state: its times, s; `end` is infinite if only a change of the world ends it."""

    begin: float
    end: float
    state: RestState


def rests(trial: Trial) -> list[Rest]:
    """Return the rests of all tasks from `trial.since` on, in the order of their begin."""
    moves = trial.motions
    found = [*_waits(trial, moves), *_loops(trial, moves)]
    return sorted(
        found, key=lambda rest: (rest.begin, rest.end, rest.state.task, sorted(rest.state.statements))
    )


def _waits(trial: Trial, moves: Sequence[Motion]) -> Iterator[Rest]:
    """Yield the waits for anything but a time that last, without the motion that goes on meanwhile."""
    for wait in trial.waits:
        end = wait.until
        if end <= trial.since or (wait.cause == "time" and end < inf):
            continue
        known = max(trial.time, wait.since + 1.0) if trial.is_stuck and end == inf else min(end, trial.time)
        begin = _at_rest(max(wait.since, trial.since), known, moves)
        if known - begin > GAP:
            yield Rest(begin, end, RestState(wait.task, frozenset((wait.at,)), wait.callers))


class _Stretch:
    """Statements of a task that may be a loop: those that begin within `BODY` of the first one, and repeat."""

    def __init__(self, first: Begun) -> None:
        self.begin = first.time
        self.callers = first.callers
        self.counts = Counter((first.at,))
        # When each statement began last.
        self.body = {first.at: first.time}
        self.is_known = False

    def take(self, begun: Begun) -> bool:
        """Take a statement that belongs to the loop; False if it does not."""
        if not self.is_known and begun.time - self.begin >= BODY:
            self.is_known, self.callers = True, begun.callers
            middle = self.begin + BODY / 3.0  # what began only before it led to the loop
            self.body = {at: time for at, time in self.body.items() if time >= middle} or self.body
        if self.is_known and begun.at not in self.body:
            return False
        self.body[begun.at] = begun.time
        self.counts[begun.at] += 1
        # Calls of the loop come and go; those that all of its statements have in common lead to it.
        self.callers = _common(self.callers, begun.callers)
        return True


def _loops(trial: Trial, moves: Sequence[Motion]) -> Iterator[Rest]:
    """Yield the loops that repeat the same statements while nothing moves to an end."""
    for name, statements in trial.statements.items():
        if name == HANDLERS:
            continue
        stretches = list(_stretches(statements))
        ends = [*(each.begin for each in stretches[1:]), statements[-1].time if trial.has_ended else inf]
        for stretch, end in zip(stretches, ends, strict=True):
            repeated = frozenset(at for at in stretch.body if stretch.counts[at] > MIN_REPEATS)
            known = min(end, trial.time)
            begin = _at_rest(stretch.begin, known, moves)
            if repeated and stretch.is_known and known - begin >= GAP:
                yield Rest(begin, end, RestState(name, repeated, stretch.callers))


def _stretches(statements: Iterable[Begun]) -> Iterator[_Stretch]:
    stretch: _Stretch | None = None
    for begun in statements:
        if stretch is None or not stretch.take(begun):
            if stretch is not None:
                yield stretch
            stretch = _Stretch(begun)
    if stretch is not None:
        yield stretch


def _common(one: tuple[int, ...], other: tuple[int, ...]) -> tuple[int, ...]:
    """Return the calls that two statements have in common, the outermost first."""
    if one is other:
        return one
    count = next(
        (k for k, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other))
    )
    return one[:count]


def _at_rest(begin: float, end: float, moves: Sequence[Motion]) -> float:
    """Return when the motion between two times that goes on last has ended, at most `end`."""
    return max([begin, *(min(each.end, end) for each in moves if each.begin < end and each.end > begin)])


def by_task(found: Iterable[Rest]) -> dict[str, list[Rest]]:
    """Return rests by the name of their task."""
    made: dict[str, list[Rest]] = defaultdict(list)
    for rest in found:
        made[rest.state.task].append(rest)
    return made
