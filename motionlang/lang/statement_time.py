"""Machine time in whole statements: a base plus their number times their duration.

The time is never a running sum. Therefore the result is the same, to the last bit, however often the clock
was read in between, and whether iterations of a loop were executed or skipped. A WAIT ends on a multiple of
the time unit, so sums of such times are exact, too.
"""

from __future__ import annotations

from math import ceil

from motionlang.controller.clock import INFINITY

# 10 ps: decimal, like durations and waits, and coarse enough that a day of them fits a float.
UNITS = 1e11
# Up to this many units, every number of units is a distinct float.
EXACT = 2.0**52
# That limit in seconds.
LATEST = EXACT / UNITS
NEVER = -INFINITY


class StatementTime:
    """The time of the running task: the `base` of statement 0 plus `cost` for each.

    Both are in seconds. `count` is the statement at which the last task stopped, `reached` its time: a task
    that continues from there continues the count. `until` is the horizon of the running task. Up to `free` no
    other task can act and the time is a whole number of units; it is `NEVER` if the task is not `alone`. `repeated`
    is the first progress that was repeated since it was set to None: its base, its first statement and its last one.
    `cost_units` is `cost` in units, 0 if that is no integer.
    """

    __slots__ = ("alone", "base", "cost", "cost_units", "count", "free", "reached", "repeated", "until")

    def __init__(self, cost: float) -> None:
        self.cost = cost
        whole = round(cost * UNITS)
        self.cost_units = whole if abs(cost * UNITS - whole) < 1e-6 else 0
        self.base = self.count = 0.0
        self.reached, self.until = -1.0, INFINITY
        self.alone, self.free = False, NEVER
        self.repeated: tuple[float, float, float] | None = None

    def at(self, count: float) -> float:
        """Return the time of a statement."""
        return self.base + count * self.cost

    def share(self) -> None:
        """Record that other tasks may act while the running task waits."""
        self.alone, self.free = False, NEVER

    def go_on(self, now: float, horizon: float) -> tuple[float, float]:
        """Resume a task at `now`; return its statement, and the first one at the horizon.

        The latter is computed as in `limit`.
        """
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
        """Restart the count at 0."""
        self.base = now
        return 0.0

    def leave(self, count: float) -> float:
        """Stop the running task at a statement, and return its time."""
        self.count = count
        self.reached = self.base + count * self.cost
        return self.reached

    def limit(self, horizon: float) -> float:
        """Set the horizon of the running task; return the first statement at or after it."""
        self.until = horizon
        if self.alone:
            self.free = horizon if horizon < LATEST else LATEST
        return self.first(horizon)

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

    def repeat(self, base: float, count: float, times: float) -> float:
        """Repeat the progress since `base` and `count`; return the new statement."""
        if self.repeated is None:
            self.repeated = base, count, self.count
        if base != self.base:
            here = units(self.base)
            self.base = (here + int(times) * (here - units(base))) / UNITS
        self.count += times * (self.count - count)
        self.reached = self.at(self.count)
        return self.count


def units(moment: float) -> int:
    """Return a time in whole units, rounded."""
    nearest = round(moment * UNITS)
    if nearest / UNITS == moment:
        return nearest
    if (nearest - 1) / UNITS == moment:
        return nearest - 1
    return nearest + 1 if (nearest + 1) / UNITS == moment else nearest
