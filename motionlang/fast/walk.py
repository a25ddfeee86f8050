"""A walk along transitions, its rounds and its pace, for `polled_ticks.py`."""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter

from motionlang.fast.transitions import TICK, Due, Transition
from motionlang.lang.statement_time import UNITS, StatementTime, units

# Base, count, ticks and ends, and the number of the next tick.
Reached = tuple[float, float, list[Due], int]
# The number of a transition that switches outputs, its base, its origin, and what its base is (`Mark.source`).
Switching = tuple[int, float, float, tuple[int, int] | None]

# The number of a transition in which a WAIT ends, its state, the end, how many such WAITs end one after another, and
# how many units apart.
Ended = tuple[int, int, Due, int, int]

# Ticks of whole units are less than half a unit from them up to this time, s.
LATEST_TICK = 3e4


class Pace:
    """The times of ticks, every `period` s since `started`, and of statements."""

    def __init__(self, started: float, period: float, statements: StatementTime) -> None:
        self.started, self.period, self.statements = started, period, statements
        self.cost = statements.cost
        # True if each tick is nearest to a whole unit.
        is_whole = units(started) / UNITS == started and units(period) / UNITS == period
        self.is_whole = is_whole and statements.base < LATEST_TICK

    def tick(self, number: int) -> float:
        """Return the time of a tick."""
        return self.started + number * self.period


class Shift:
    """How far a round advances.

    `statements` are those since a base that stays; `ends` are the units of each end, by index.
    """

    __slots__ = ("ends", "statements", "ticks")

    def __init__(self, statements: float, ticks: int, ends: dict[int, int]) -> None:
        self.statements, self.ticks, self.ends = statements, ticks, ends

    def base(self, base: float, source: tuple[int, int] | None, times: int, pace: Pace) -> float:
        """Return a base of statements some rounds later."""
        if source is None:
            return base
        index, number = source
        if index == TICK:
            return pace.tick(number + times * self.ticks)
        return (units(base) + times * self.ends[index]) / UNITS


class Round:
    """Transitions of a walk that repeat.

    Those from `first` to `past` follow `times` more often. Each time advances by `shift`. `switching` are those of the
    walk between `first` and `past`.
    """

    __slots__ = ("first", "past", "shift", "switching", "times")

    def __init__(self, first: int, past: int, times: int, shift: Shift, switching: list[Switching]) -> None:
        self.first, self.past, self.times, self.shift, self.switching = first, past, times, shift, switching

    @property
    def total(self) -> int:
        """The number of repeated transitions."""
        return (self.past - self.first) * self.times

    def repeated(self, pace: Pace) -> list[Switching]:
        """Return the transitions that switch outputs in the repetitions."""
        return [
            (
                number,
                self.shift.base(base, source, k, pace),
                origin + k * self.shift.statements,
                source,
            )
            for k in range(1, self.times + 1)
            for number, base, origin, source in self.switching
        ]


class Walk:
    """Transitions in a row; the first `good` ones lead to the present state.

    `rounds` are those that repeat, `switching` those that switch outputs, and `ended` the WAITs. `polling` has the
    number of each before whose origin a task polls, the task and the statements of that. `reached` is where the good
    ones lead.
    """

    __slots__ = ("ended", "good", "origins", "polling", "reached", "rounds", "steps", "switching")

    def __init__(self) -> None:
        self.steps: list[Transition] = []
        # The statement from which each transition counts; those of a walk along ticks alone are not needed.
        self.origins: list[float] = []
        self.rounds: list[Round] = []
        self.switching: list[Switching] = []
        self.ended: list[Ended] = []
        self.polling: list[tuple[int, str, float]] = []
        self.good = 0
        self.reached: Reached = 0.0, 0.0, [], 0

    def add(self, step: Transition, origin: float, times: int = 1) -> None:
        """Add a transition, so many times in a row."""
        self.steps += [step] * times
        self.origins += [origin] * times

    def end_wait(self, state: int, due: Due) -> None:
        """Note that a WAIT, if it is one, ends in the next transition."""
        if due[1] != TICK:
            self.ended.append((len(self.steps), state, due, 1, 0))

    def times(self) -> Counter[Transition]:
        """Return how often each transition passes."""
        times = Counter(self.steps[: self.good])
        for each in self.rounds:
            for step in self.steps[each.first : each.past]:
                times[step] += each.times
        return times

    def ended_between(self, first: int, past: int) -> list[Ended]:
        """Return the WAITs that end in some transitions."""
        return self.ended[bisect_left(self.ended, (first,)) : bisect_left(self.ended, (past,))]

    def switching_between(self, first: int, past: int) -> list[Switching]:
        """Return some transitions that switch outputs."""
        return self.switching[bisect_left(self.switching, (first,)) : bisect_left(self.switching, (past,))]

    def polled(self, first: int) -> list[tuple[str, float]]:
        """Return the tasks that poll, from one on, and their statements."""
        return [(task, count) for _, task, count in self.polling[first:]]
