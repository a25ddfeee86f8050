"""Rounds: transitions of a walk that repeat, for `walker.py`.

A loop with WAIT(5) next to a tick every millisecond repeats after 5.02 ms: five ticks, then the end of the WAIT. The
end falls 20 µs later between the ticks each time, until a tick overtakes it after some 50 rounds.

All times advance equally in each round. Whatever is decided by comparing two of them is therefore decided alike in all
rounds if it is in the first one and in the last one. So only these two are walked. Their number is estimated, and the
last one shows whether the estimate was right.

Times are whole units, so they advance by the same amount to the last bit. Where that is not so, rounding may decide
differently each time, and `Rounds.unsure` is set: a tick between two statements (`first_statement` compares products),
a tick at which a WAIT ends, and a WAIT that begins at a tick whose time is no whole unit.
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.fast.transitions import TICK, Due, Transition
from motionlang.fast.walk import Pace, Reached, Round, Shift, Walk
from motionlang.lang.statement_time import UNITS, units

# How many returns to a state are compared, how far a round may move the ticks and ends, as a part of the shortest WAIT
# or period, and how often it must repeat.
LOOK_BACK, DRIFT, LEAST = 32, 0.1, 3
# A round that moves an end by less than this against the ticks, s, does not move it.
STILL = 1e-12


class Mark:
    """A return of a walk to the present state.

    `steps`, `switched` and `polled` are how many transitions, switches and polls the walk has before it. `source` is
    what `base` is: the index of the WAIT whose end it is, or `TICK`, and the number of the tick. `distance` is how far
    the next tick or end is from it.
    """

    __slots__ = (
        "base", "count", "distance", "dues", "now", "number", "polled", "source", "steps", "switched",
    )  # fmt: skip

    def __init__(self, walk: Walk, source: tuple[int, int] | None, cost: float) -> None:
        self.base, self.count, self.dues, self.number = walk.reached
        self.source, self.now = source, self.base + self.count * cost
        self.distance = self.dues[0][0] - self.now
        self.steps, self.switched, self.polled = len(walk.steps), len(walk.switching), len(walk.polling)


class Rounds:
    """The search of a walk for rounds.

    `again` walks a number of transitions from a given place. No round ends after `end`.
    """

    def __init__(
        self, walk: Walk, pace: Pace, end: float, again: Callable[[Reached, int], Walk | None]
    ) -> None:
        self._walk, self._pace, self._end, self._again = walk, pace, end, again
        self._marks: list[Mark] = []
        # How many returns are still compared, so that a walk without rounds costs little.
        self.left = LOOK_BACK
        # The number of transitions before which the returns cannot be compared.
        self.unsure = 0

    def found(self, source: tuple[int, int] | None, most: int) -> bool:
        """Add rounds of at most so many transitions to the walk; False if there are none.

        Called at each return to the present state.
        """
        self.left -= 1
        mark = Mark(self._walk, source, self._pace.cost)
        if self._marks and self._marks[-1].steps < self.unsure:
            self._marks.clear()
        before = self._similar(mark) if self._marks else None
        self._marks.append(mark)
        if before is None:
            return False
        self._marks.clear()
        shift = _shift(before, mark)
        steps = self._walk.steps[before.steps :]
        if shift is None or (len(set(steps)) == 1 and not steps[0].switches):
            return False  # a single transition that repeats has been repeated already
        polls, origins = self._walk.polled(before.polled), self._walk.origins[before.steps :]
        times = int(self._estimate(steps, before, mark, shift, most))
        for count in (times, times - 1, times // 2, times // 4):
            if count < LEAST:
                break
            last = self._again(self._after(mark, shift, count), len(steps))
            # The same transition may count from a tick in one round and from the end of a WAIT in another.
            if last is None or last.steps != steps or last.origins != origins or last.polled(0) != polls:
                continue
            if _times(last.reached) == _times(self._after(mark, shift, count + 1)):
                return self._repeat(before, mark, shift, count + 1, last.reached)
        return False

    def _similar(self, mark: Mark) -> Mark | None:
        """Return the last mark at the same distances from ticks and ends."""
        waits = [end - since for end, index, since in mark.dues if index != TICK]
        most = min([self._pace.period, *waits]) * DRIFT
        for one in reversed(self._marks):
            if not -most < one.distance - mark.distance < most:
                continue
            later = mark.now - one.now
            # An end that stays must be far enough for some rounds.
            last = mark.now + (LEAST + 1) * later
            if all(
                due[1] == other[1] and (-most < due[0] - other[0] - later < most or last < due[0] == other[0])
                for due, other in zip(mark.dues, one.dues, strict=False)
            ):
                return one
        return None

    def _estimate(self, steps: list[Transition], one: Mark, two: Mark, shift: Shift, most: int) -> float:
        """Return about how many rounds follow.

        They end where a tick and the ends of WAITs change their order.
        """
        period, length = self._pace.period, two.now - one.now
        found = min((self._end - two.now) / length, float(most // len(steps)))
        tick = self._pace.tick(two.number)
        for moment, index, _ in two.dues:
            moved = shift.ticks if index == TICK else shift.ends[index]
            if not moved:
                found = min(found, (moment - two.now) / length)
            elif index != TICK:
                later = moved / UNITS - shift.ticks * period
                ends = sum(task == index for step in steps for task, _, _ in step.waits)
                apart = min(period, moved / UNITS / ends) if ends else period
                phase = (moment - tick) % period % apart
                if abs(later) > STILL:
                    found = min(found, (apart - phase if later > 0.0 else -phase) / later)
        return found - 1.0

    def _after(self, mark: Mark, shift: Shift, times: int) -> Reached:
        """Return where some rounds after a mark lead."""
        number = mark.number + times * shift.ticks
        dues: list[Due] = [
            (self._pace.tick(number), TICK, 0.0)
            if index == TICK
            else ((units(end) + times * shift.ends[index]) / UNITS, index, since)
            for end, index, since in mark.dues
        ]
        base = shift.base(mark.base, mark.source, times, self._pace)
        return base, mark.count + times * shift.statements, dues, number

    def _repeat(self, one: Mark, two: Mark, shift: Shift, times: int, reached: Reached) -> bool:
        """Add rounds to the walk, if each switch of outputs has a base that is known."""
        walk = self._walk
        switching = walk.switching[one.switched :]
        if any(source is not None and source[0] not in shift.ends for *_, source in switching):
            return False
        walk.rounds.append(Round(one.steps, two.steps, times, shift, switching))
        walk.polling += [(number, task, times * count) for number, task, count in walk.polling[one.polled :]]
        walk.reached = reached
        self.left = LOOK_BACK
        return True


def _shift(one: Mark, two: Mark) -> Shift | None:
    """Return the shift from one mark to another; None if more than times differs."""
    ticks, statements = two.number - one.number, two.count - one.count
    ends = {
        index: units(end) - units(before)
        for (end, index, _), (before, _, _) in zip(two.dues, one.dues, strict=True)
    }
    ends[TICK] = 0
    if two.source is None or one.source is None:
        return Shift(statements, ticks, ends) if two.source is one.source else None
    index, number = two.source
    if statements or one.source[0] != index or (index == TICK and number - one.source[1] != ticks):
        return None
    if index != TICK:
        moved = units(two.base) - units(one.base)
        if ends.setdefault(index, moved) != moved:
            return None
    return Shift(0.0, ticks, ends)


def _times(reached: Reached) -> tuple[object, ...]:
    """Return what a walk has reached without the beginnings of WAITs."""
    base, count, dues, number = reached
    return base, count, [due[:2] for due in dues], number
