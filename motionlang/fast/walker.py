"""Walks along known transitions, from a checkpoint on, for `polled_ticks.py`.

A walk computes times only: it has no effect on the program. It ends before a transition that is not known, and
at a given time.
"""

from __future__ import annotations

from bisect import insort
from functools import partial

from motionlang.fast.rounds import Rounds
from motionlang.fast.transitions import (
    APART,
    NO_DUE,
    ONE_TIME,
    TICK,
    Checkpoint,
    Due,
    Known,
    Transition,
    first_statement,
)
from motionlang.fast.walk import Pace, Reached, Walk
from motionlang.lang.statement_time import UNITS, units

# The most transitions of a walk, without those that are repeated in rounds.
MAX_WALK = 4096
# A part of a transition for which rounding does not decide whether one more fits.
CLOSE = 1e-6
# The transitions of a state from which none is known.
_NO_GAPS: dict[float, Transition] = {}


class Walker:
    """Walks along `known` transitions at the `pace` of a program."""

    def __init__(self, known: Known, pace: Pace) -> None:
        self._known, self._pace = known, pace

    def walk(self, own: Checkpoint, end: float, most: int) -> Walk | None:
        """Return the next transitions before `end`, at most so many.

        They end with the last one that leads to the present state; None if there is none.
        """
        by_tick = len(own.dues) == 1 and not self._known.are_idle[own.state]
        return (self.walk_ticks if by_tick else self.walk_all)(own, end, most)

    def walk_all(self, own: Checkpoint, end: float, most: int) -> Walk | None:
        """Return the same as `walk`, whatever the tasks do."""
        alone, pace, cost = self._known.alone, self._pace, self._pace.cost
        cost_units = pace.statements.cost_units
        state, base, count, number = own.state, own.base, own.count, own.number
        dues = [*own.dues, NO_DUE]
        # What `base` is, as in `Mark`; None if it is that of the checkpoint.
        source: tuple[int, int] | None = None
        walk = Walk()
        rounds = Rounds(walk, pace, end, partial(self._again, own.state, end))
        limit = min(most, MAX_WALK)
        while len(walk.steps) < limit:
            moment, index, _ = dues[0]
            step = alone.get((state, index))
            if (
                step is not None
                and moment > base + count * cost + APART
                and dues[1][0] > moment + step.length * cost + APART
            ):
                base, origin = moment, 0.0
                due = dues.pop(0)
                walk.end_wait(state, due)
                if step.state == state and step.is_proved and not step.switches:
                    left = min(dues[0][0], end) - moment
                    times = min(self._repetitions(step, left), limit - len(walk.steps) - 1)
                    if times > 0:
                        base = self._repeat(walk, step, due, number, times)
                        number += times if index == TICK else 0
                source = index, number
            else:
                known = self.next(state, base, count, dues)
                if known is None:
                    break
                step, since, origin, depth = known
                if since != base:
                    base, source = since, (index, number)
                elif origin > count:
                    walk.polling.append((len(walk.steps), self._known.polling[state], origin - count))
                passed, dues = dues[:depth], dues[depth:]
                if rounds.left and _rounding_decides([*passed, dues[0]], base):
                    rounds.unsure = len(walk.steps) + 1
                for due in passed:
                    if due[1] in step.open:
                        insort(dues, due)
                    else:
                        walk.end_wait(state, due)
            count = origin + step.length
            if not step.is_proved or base + count * cost >= end:
                break
            if step.switches:
                walk.switching.append((len(walk.steps), base, origin, source))
            walk.add(step, origin)
            for task, offset, wait_units in step.waits:
                time = (units(base) + int(origin) * cost_units + wait_units) / UNITS
                insort(dues, (time, task, base + (origin + offset) * cost))
                if source is not None and source[0] == TICK and not pace.is_whole:
                    rounds.unsure = len(walk.steps)
            if step.handler is not None:
                number += 1
                insort(dues, (pace.tick(number), TICK, 0.0))
            state = step.state
            if state == own.state and pace.tick(number) > base + count * cost:
                walk.good, walk.reached = len(walk.steps), (base, count, dues[:-1], number)
                if rounds.left and rounds.found(source, most - len(walk.steps)):
                    source = None if source is None else (source[0], source[1] + walk.reached[3] - number)
                    base, count, dues, number = walk.reached
                    dues = [*dues, NO_DUE]
                    most -= walk.rounds[-1].total
                    limit = min(most, MAX_WALK)
        return walk if walk.good else None

    def _again(self, state: int, end: float, reached: Reached, most: int) -> Walk | None:
        """Return the next transitions from where a walk leads."""
        return self.walk_all(Checkpoint(state, *reached, ()), end, most)

    def _repeat(self, walk: Walk, step: Transition, due: Due, number: int, times: int) -> float:
        """Add a transition to its own state so many times; return the base after them."""
        moment, index, _ = due
        walk.add(step, 0.0, times)
        if index == TICK:
            return self._pace.tick(number + times)
        _, offset, length = step.waits[0]
        first = (units(moment) + length) / UNITS, index, moment + offset * self._pace.cost
        walk.ended.append((len(walk.steps) - 1, step.state, first, times, length))
        return (units(moment) + times * length) / UNITS

    def _repetitions(self, step: Transition, left: float) -> int:
        """Return how often a transition to its own state fits before another tick or end."""
        length = step.waits[0][2] / UNITS if step.waits else self._pace.period
        return int((left - step.length * self._pace.cost - APART) / length - CLOSE)

    def walk_ticks(self, own: Checkpoint, end: float, most: int) -> Walk | None:
        """Return the same as `walk` while no task is in a WAIT, in less time."""
        known, statements = self._known.gaps, self._pace.statements
        base, cost, started, period = statements.base, statements.cost, self._pace.started, self._pace.period
        count, number, last = own.count, own.number, statements.first(end)
        state = present = own.state
        gaps = known.get(present)
        if gaps is None:
            return None
        walk = Walk()
        steps, switching, limit = walk.steps, walk.switching, min(most, MAX_WALK)
        good, ratio = count, float(round(period / cost))
        first = statements.first(own.dues[0][0]) - ratio
        for each in range(number, number + limit + 1):
            # The same statement as that of `StatementTime.first`, without a division: a tick is at most one statement
            # off the whole number of them in a period.
            moment = started + each * period
            first += ratio
            if base + first * cost < moment:
                first += 1.0
            elif base + (first - 1.0) * cost >= moment:
                first -= 1.0
            if first <= count:
                break  # the tick comes before the end of the handler has been seen
            if state == present:
                walk.good, good = len(steps), count
            step = gaps.get(first - count)
            if step is None or not step.is_proved or len(steps) == limit:
                break
            if step.switches:
                switching.append((len(steps), base, count, None))
            count += step.length
            if count >= last:
                break
            steps.append(step)
            state = step.state
            gaps = known.get(state, _NO_GAPS)
        if not walk.good:
            return None
        number += walk.good
        walk.reached = base, good, [(started + number * period, TICK, 0.0)], number
        return walk

    def origin(
        self, state: int, base: float, count: float, due: Due, by_tick: bool
    ) -> tuple[float, float, float] | None:
        """Return the origin of a transition, and the first statement after `due`.

        The origin is a base and the statement from which it counts. None if rounding might decide. `by_tick`: no task
        is in a WAIT, so the distances to the tick are few.
        """
        cost, known = self._pace.cost, self._known
        is_idle = known.are_idle[state]
        if is_idle:
            now = base + count * cost
            if due[0] > now + APART:
                return due[0], 0.0, 0.0
            if due[0] > now and (due[1] == TICK or due[0] > now + ONE_TIME):
                return None
        statement = first_statement(due, base, cost)
        if statement is None:
            return None
        period = None if is_idle or by_tick else known.periods.get(state)
        if period is None:
            return base, count, statement
        begin, length = period
        return base, count + max(0.0, (statement - count - begin) // length * length), statement

    def next(
        self, state: int, base: float, count: float, dues: list[Due]
    ) -> tuple[Transition, float, float, int] | None:
        """Return the transition that comes next, None if it is not known.

        The result has its base and its origin, and how many of the ticks and ends are in its path.
        """
        node, cost = self._known.trees.get(state), self._pace.cost
        if node is None:
            return None
        step, due = node.transition, dues[0]
        if step is not None and due[0] > base + (count + step.length) * cost + APART:
            return step, base, count, 0
        found = self.origin(state, base, count, due, len(dues) == 2)
        if found is None:
            return None
        base, origin, statement = found
        node = node.next.get((due[1], statement - origin))
        first, depth = statement - origin, 1
        while node is not None:
            step = node.transition
            if step is not None and dues[depth][0] > base + (origin + step.length) * cost + APART:
                # Nothing may happen before the iterations that are left out.
                return None if origin > count and step.earliest < first else (step, base, origin, depth)
            due = dues[depth]
            later = first_statement(due, base, cost)
            node = None if later is None else node.next.get((due[1], later - origin))
            depth += 1
        return None


def _rounding_decides(dues: list[Due], base: float) -> bool:
    """True if a tick comes between statements, or as a WAIT ends.

    All but the last of `dues` have come.
    """
    for number, due in enumerate(dues[:-1]):
        if due[1] == TICK and (due[0] != base or dues[number + 1][0] - due[0] < APART):
            return True
        if dues[number + 1][1] == TICK and dues[number + 1][0] - due[0] < APART:
            return True
    return False
