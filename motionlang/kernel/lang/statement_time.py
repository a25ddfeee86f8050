"""Machine time in whole statements: a base plus their number times their duration.

The time is never a running sum. Therefore the result is the same, to the last bit, however often the clock
was read in between, and whether iterations of a loop were executed or skipped. A WAIT ends on a multiple of
the time unit, so sums of such times are exact, too.
"""

from __future__ import annotations

from math import ceil

from motionlang.kernel.controller.clock import INFINITY

# 10 ps: decimal, like durations and waits, and coarse enough that a day of them fits a float.
UNITS = 1e11


class StatementTime:
    """The time of the running task: the `base` of statement 0 plus `cost` for each.

    Both are in seconds. `count` is the statement at which the last task stopped, `reached` its time: a task that
    continues from there continues the count. `until` is the horizon of the running task. `cost_units` is `cost` in
    units, 0 if that is no integer.
    """

    __slots__ = ("base", "cost", "cost_units", "count", "reached", "until")

    def __init__(self, cost: float) -> None:
        self.cost = cost
        whole = round(cost * UNITS)
        self.cost_units = whole if abs(cost * UNITS - whole) < 1e-6 else 0
        self.base = self.count = 0.0
        self.reached, self.until = -1.0, INFINITY

    def at(self, count: float) -> float:
        """Return the time of a statement."""
        return self.base + count * self.cost

    def go_on(self, now: float, horizon: float) -> float:
        """Resume a task at `now`; return its statement."""
        self.until = horizon
        if now == self.reached:
            return self.count
        self.base = now
        return 0.0

    def start(self, now: float) -> float:
        """Restart the count at 0."""
        self.base = now
        return 0.0

    def leave(self, count: float) -> float:
        """Stop the running task at a statement, and return its time."""
        self.count = count
        self.reached = self.base + count * self.cost
        return self.reached

    def first(self, moment: float) -> float:
        """Return the first statement at or after a time."""
        if moment == INFINITY:
            return INFINITY
        base, cost = self.base, self.cost
        count = float(ceil((moment - base) / cost))
        if base + count * cost < moment:
            return count + 1.0
        return count - 1.0 if base + (count - 1.0) * cost >= moment else count

    def periods(self, base: float, count: float, here: float, until: float) -> float:
        """Return how many times the progress since `base` and `count` fits before `until`.

        The running task is now at statement `here`. After a wait, the result is 0 unless `here` equals
        `count` and `base` is a whole number of units.
        """
        if until == INFINITY:
            return INFINITY
        if base == self.base:
            return (self.first(until) - here) // (here - count)
        if here != count or units(base) / UNITS != base:
            return 0
        return (until - self.at(here)) // (self.base - base)


def units(moment: float) -> int:
    """Return a time in whole units, rounded."""
    nearest = round(moment * UNITS)
    if nearest / UNITS == moment:
        return nearest
    if (nearest - 1) / UNITS == moment:
        return nearest - 1
    return nearest + 1 if (nearest + 1) / UNITS == moment else nearest
