"""Loops that only poll, as the program runs: many turns at once where all are the same.

A turn that did nothing and left every variable as it was will be repeated until something happens: the next event, or
the moment at which something that it read changes by itself. So many whole turns as fit before it are paid for at
once. While other tasks can run that ends with the task's time slice. Where none can, and none could since the turn
began, it goes on to the moment at which the first of them may go on.

A loop whose turns are looked at in vain is left alone for one turn, for two, for four and so on; its readings take no
notes meanwhile.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.lang.task import INFINITY, WATCH

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.attention import Note
    from motionlang.mint.runtime.environment import Environment

    State = tuple[object, ...]
    Counters = tuple[float, ...]
    # What a turn began with: how the one before it left things, where counters stood; its statement, the moment from
    # which those count, its time; how often others had run; the notes, and how many there were.
    Look = tuple[State | None, Counters, float, float, float, int, list[Note], int]
    # Its statement and horizon as it goes on, what that turn begins with, how many pass unlooked at or up to which
    # statement they do, and the counters.
    Turned = tuple[float, float, Look | None, float, Counters]

# So many turns pass unlooked at, and more where arrays are to be compared. They are counted in floats, as Python has
# no whole number of that size ready.
MOST_ALONE = 4096.0
# So many statements stand for a turn where turns are not counted.
STATEMENTS = 4.0


class Site:
    """A loop of the text: `asks` whether it looks at anything, `carries` whether its last turn has to be carried out.

    `alters`: a turn may give a variable that others wait for another value, and give it back its own. `looks_at` names
    what it reads.
    `left` is for how many turns it is left alone, or up to statement `due`, in one that counts no turns.
    """

    __slots__ = (
        "_base",
        "_due",
        "_environment",
        "_statements",
        "alters",
        "asks",
        "carries",
        "left",
        "looks_at",
    )

    def __init__(
        self, environment: Environment, asks: bool, carries: bool, alters: bool, looks_at: str = ""
    ) -> None:
        self._environment, self.asks, self.carries, self.alters = environment, asks, carries, alters
        self.looks_at = looks_at
        self.left = self._due = 0.0
        self._statements = environment.statements
        self._base = self._statements.base

    @property
    def due(self) -> float:
        """The statement from which on it is to be looked at; at once, where these count from another moment by now."""
        return self._due if self._statements.base is self._base else 0.0

    def turn_at(
        self, t: float, horizon: float, look: Look | None, state: State, counters: Counters
    ) -> Turned:
        """The same as `turn`, with the statement up to which turns pass unlooked at in the place of their number."""
        t, horizon, look, left, counters = self.turn(t, horizon, look, state, counters)
        self._due, self._base = t + STATEMENTS * left, self._statements.base
        return t, horizon, look, self._due, counters

    def turn(self, t: float, horizon: float, look: Look | None, state: State, counters: Counters) -> Turned:
        """The end of a turn at statement `t`: the loop goes on at the end of the last one that can be no different.

        `state` is what every turn leaves behind, after the count of what the program did. What `counters` count decides
        nothing.
        """
        attention, statements = self._environment.attention, self._environment.statements
        if look is not None:
            found = self.skip(t, horizon, look, state, counters) if look[0] == state else None
            if found is None:
                self._environment.task.look = None
                elements = sum([len(each) for each in state if isinstance(each, tuple)])
                left, self.left = self.left, min(2.0 * self.left or 1.0, MOST_ALONE + 4 * elements)
                if left:
                    attention.rest()
                    return t, horizon, None, left, counters
            else:
                self.left = 0.0
                t, horizon, counters = found
        since = t, statements.base, statements.at(t), self._environment.resumed
        return t, horizon, (state, counters, *since, *attention.begin()), 0.0, counters

    def skip(
        self, t: float, horizon: float, look: Look, state: State, counters: Counters
    ) -> tuple[float, float, Counters] | None:
        """A turn that ends at `t` was as the one before: the end of the last that can be no different.

        None where it was not in everything that it read. A turn in which other tasks ran is no more than remembered.
        """
        environment = self._environment
        statements, task = environment.statements, environment.task
        _, before, since, base, began, others, notes, first = look
        scheduler = environment.machine.scheduler
        assert scheduler is not None
        now, level = statements.at(t), environment.attention.held(notes, first, began)
        if level <= now:
            return None
        several = len(scheduler.tasks) > 1
        # Periods of several tasks know nothing of counters.
        task.look = None if several and self.carries else (environment.acts, self.asks)
        task.looks_at = self.looks_at
        if environment.resumed != others:
            return t, horizon, counters
        until = statements.until
        if began <= scheduler.began and now < until and not (several and self.alters):
            # It has done nothing since the others were asked.
            environment.clock.now = now
            until = max(until, scheduler.reach())
        until = min(until, level)
        steps = [n - m for n, m in zip(counters, before, strict=True)]
        most = INFINITY
        if any(steps):
            counted = environment.machine.accelerators.counted
            if counted is None:
                return None
            most = counted(counters, steps)
        if until == most == INFINITY:
            raise Refusal("never", "the loop looks for something that can no longer happen", "")
        if self.asks and now - began <= WATCH and task.in_vain is None and until >= scheduler.until:
            task.in_vain = began if level == scheduler.next_change() == INFINITY else None
        environment.task = task  # what others wait for may have been looked at with their eyes
        turns = max(0, int(min(statements.periods(base, since, t, until) - self.carries, most)))
        if turns:
            statements.leave(t)
            t = statements.repeat(base, since, turns)
            horizon = statements.limit(statements.until)
        return t, horizon, tuple([n + turns * step for n, step in zip(counters, steps, strict=True)])
