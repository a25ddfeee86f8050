"""Machine time in whole statements: a base plus their number times their cost, never a running sum.

So it makes no difference to the last bit at how many moments between the clock was looked at, nor whether turns of a
loop were carried out or skipped. A WAIT ends on a whole number of units, so that sums of such moments are exact, too.
"""

from __future__ import annotations

from math import ceil

INFINITY = float("inf")
# 10 ps: decimal, as costs and waits are, and coarse enough that a day of them fits a float.
UNITS = 1e11
# So many units and fewer are each a float of its own.
EXACT = 2.0**52
# The same in seconds.
LATEST = EXACT / UNITS
NEVER = -INFINITY


class StatementTime:
    """The time of the task that runs; `base` is the machine time, s, of its statement 0, `cost` what one takes, s.

    `count` is the statement at which the last task stopped, `reached` its time: whoever goes on there counts on.
    `until` is the horizon of the one that runs, and `free`, up to which nobody but that one can act and the time is a
    whole number of units; `NEVER` where it is not `alone`.
    """

    __slots__ = ("alone", "base", "cost", "count", "free", "reached", "until")

    def __init__(self, cost: float) -> None:
        self.cost = cost
        self.base = self.count = 0.0
        self.reached, self.until = -1.0, INFINITY
        self.alone, self.free = False, NEVER

    def at(self, count: float) -> float:
        """The time of a statement."""
        return self.base + count * self.cost

    def share(self) -> None:
        """Others may act while the task that runs waits."""
        self.alone, self.free = False, NEVER

    def go_on(self, now: float, horizon: float) -> tuple[float, float]:
        """A task goes on at `now`: at which statement, and the first one not before `horizon`, as `limit` finds it."""
        if now != self.reached:
            self.base, base, count = now, now, 0.0
        else:
            base, count = self.base, self.count
        self.until = horizon
        if self.alone:
            self.free = horizon if horizon < LATEST else LATEST
        if horizon == INFINITY:
            return count, INFINITY
        cost = self.cost
        last = -((base - horizon) / cost // 1.0)
        if base + last * cost < horizon:
            return count, last + 1.0
        return count, last - 1.0 if base + (last - 1.0) * cost >= horizon else last

    def start(self, now: float) -> float:
        """Count from 0 again."""
        self.base = now
        return 0.0

    def leave(self, count: float) -> float:
        """The running task stops at a statement: its time."""
        self.count = count
        self.reached = self.base + count * self.cost
        return self.reached

    def limit(self, horizon: float) -> float:
        """The first statement that is not before `horizon`, up to which the running task may go."""
        self.until = horizon
        if self.alone:
            self.free = horizon if horizon < LATEST else LATEST
        return self.first(horizon)

    def first(self, moment: float) -> float:
        """The first statement that is not before a moment."""
        if moment == INFINITY:
            return INFINITY
        base, cost = self.base, self.cost
        count = float(ceil((moment - base) / cost))
        if base + count * cost < moment:
            return count + 1.0
        return count - 1.0 if base + (count - 1.0) * cost >= moment else count

    def periods(self, base: float, count: float, here: float, until: float) -> float:
        """How often by `until` the running task, now at `here`, can come as far as it has since `base` and `count`.

        Not at all where it has waited, and did so neither for a whole turn nor to a whole unit.
        """
        if until == INFINITY:
            return INFINITY
        if base == self.base:
            return (self.first(until) - here) // (here - count)
        if here != count or units(base) / UNITS != base:
            return 0
        return (until - self.at(here)) // (self.base - base)

    def repeat(self, base: float, count: float, times: float) -> float:
        """The running task goes on as far as it has come since `base` and `count`, so many times: its statement."""
        if base != self.base:
            here = units(self.base)
            self.base = (here + int(times) * (here - units(base))) / UNITS
        self.count += times * (self.count - count)
        self.reached = self.at(self.count)
        return self.count


def units(moment: float) -> int:
    """A moment in whole units, the nearest ones where it is none."""
    nearest = round(moment * UNITS)
    if nearest / UNITS == moment:
        return nearest
    if (nearest - 1) / UNITS == moment:
        return nearest - 1
    return nearest + 1 if (nearest + 1) / UNITS == moment else nearest
