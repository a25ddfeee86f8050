"""Loops that only poll, as the program runs: many turns at once where all are the same.

A turn that did nothing and left every variable as it was will be repeated until something happens: the next event, or
the moment at which something that it read changes by itself. So many whole turns as fit before it are paid for at
once. While other tasks can run that ends with the task's time slice. Where none can, and none could for as long as the
task has polled, it goes on to the moment at which the first of them may go on.

A loop whose turns are looked at in vain is left alone for one turn, for two, for four and so on; its readings take no
notes meanwhile.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.lang.statement_time import UNITS, units
from motionlang.lang.task import INFINITY, WATCH

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.lang.attention import Note
    from motionlang.mint.runtime.environment import Environment
    from motionlang.mint.runtime.task import MintTask

    State = tuple[object, ...]

# The largest Integer.
LARGEST = 2147483647
# So many turns pass unlooked at, one call being made for so many: small numbers are counted down without new objects.
MOST_ALONE, AT_ONCE = 4096, 256


class Look:
    """What a turn began with: how the turn before it left things, when, and which notes there were; its counters."""

    __slots__ = ("alone", "base", "before", "began", "counters", "first", "notes", "others", "since")

    alone: int
    before: State | None
    counters: tuple[float, ...]
    began: float
    since: float
    base: float
    others: int
    notes: list[Note]
    first: int


class Site:
    """A loop of the text: `asks` whether it looks at anything, `carries` whether its last turn has to be carried out.

    `left` is for how many turns it is left alone.
    """

    __slots__ = ("_environment", "_skipper", "asks", "carries", "left")

    def __init__(self, environment: Environment, asks: bool, carries: bool) -> None:
        self._environment, self.asks, self.carries = environment, asks, carries
        self._skipper = environment.part(Skipper)
        self.left = 0

    def turn(
        self, t: float, horizon: float, look: Look | None, state: State, counters: tuple[float, ...] = ()
    ) -> tuple[float, float, Look, int]:
        """The end of a turn: the end of the last one that can be no different, and how many pass unlooked at.

        Both ends and the horizon are numbers of statements; `state` is what every turn leaves behind, after the count
        of what the program did. What `counters` count decides nothing; `Look.counters` is where they have come to.
        """
        if look is not None and look.alone:
            look.alone, look.counters = look.alone - AT_ONCE, counters
            return t, horizon, look, AT_ONCE
        if look is None or look.before is None:
            return t, horizon, self.begin(t, look, state, counters), 0
        if look.before == state:
            steps = [now - before for now, before in zip(counters, look.counters, strict=True)]
            found = self._skipper.skip(t, horizon, look, state, self, _most(counters, steps))
            if found is not None:
                self.left = 0
                t, horizon, turns = found
                counted = tuple([n + turns * step for n, step in zip(counters, steps, strict=True)])
                return t, horizon, self.begin(t, look, state, counted), 0
        self._environment.task.look = None
        left, self.left = self.left, min(2 * self.left or 1, MOST_ALONE)
        if not left:
            return t, horizon, self.begin(t, look, state, counters), 0
        look.before, look.counters = None, counters
        self._environment.attention.notes = None
        look.alone = max(left - AT_ONCE, 0)
        return t, horizon, look, left - look.alone

    def begin(self, t: float, look: Look | None, state: State, counters: tuple[float, ...] = ()) -> Look:
        """A turn begins that will be looked at."""
        environment = self._environment
        look = look or Look()
        look.alone, look.before, look.since, look.counters = 0, state, t, counters
        look.began = environment.statements.at(t)
        look.base = environment.statements.base
        look.others = environment.resumed
        look.notes, look.first = environment.attention.begin()
        return look


def _most(counters: Sequence[float], steps: Sequence[float]) -> float:
    """How many turns counters can count on before they leave whole numbers or those that an Integer can be."""
    if any(n != int(n) for n in (*counters, *steps)):
        return 0
    return min(
        [(LARGEST - abs(n)) // abs(step) for n, step in zip(counters, steps, strict=True) if step],
        default=INFINITY,
    )


class Skipper:
    """What tasks poll, and since when."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._clock, self._machine = environment.clock, environment.machine
        # The task that polled last, from when to when without a break.
        self._task: MintTask | None = None
        self._first, self._last = 0.0, -1.0

    def skip(
        self, t: float, horizon: float, look: Look, state: State, site: Site, most: float
    ) -> tuple[float, float, int] | None:
        """A turn that ends at `t` was as the one before: the end of the last that can be no different, the horizon, and
        how many turns lie between, at `most` so many.

        None where it was not in everything that it read. A turn in which other tasks ran is no more than remembered.
        """
        environment, task, attention = self._environment, self._environment.task, self._environment.attention
        statements = environment.statements
        if attention.notes is not look.notes:
            return None
        now, level = statements.at(t), INFINITY
        if len(look.notes) > look.first:
            level = attention.sure_until(look.began, look.notes[look.first :])
            if level <= now:
                return None
        task.look, task.looked, task.level = (environment.acts, state[1:], site.asks), now, level
        if site.carries and len(self._machine.scheduler.tasks) > 1:  # type: ignore[union-attr]
            task.look = None  # periods of several tasks know nothing of counters
        if environment.resumed != look.others:
            return t, horizon, 0
        if look.began != self._last or task is not self._task:
            self._task, self._first = task, look.began
        until = min(self._horizon(now, statements.until), level)
        if until == most == INFINITY:
            raise Refusal("never", "the loop looks for something that can no longer happen", "")
        if site.asks and now - look.began <= WATCH:
            self._note_vain(until, level)
        environment.task = task  # what others wait for may have been looked at with their eyes
        turns = max(0, int(min(self._turns(t, look, until) - site.carries, most)))
        if turns and statements.base == look.base:
            t += turns * (t - look.since)
        elif turns:
            statements.leave(t)
            t, horizon = statements.repeat(look.base, t, turns), statements.limit(statements.until)
        self._last = task.looked = statements.at(t)
        return t, horizon, turns

    def _turns(self, t: float, look: Look, until: float) -> float:
        """How many turns like the last one end by `until`."""
        statements = self._environment.statements
        if statements.base == look.base:
            return (statements.first(until) - t) // (t - look.since)
        if t != look.since or units(look.base) / UNITS != look.base:
            return 0  # it waited, but not as it did in the turn before
        return (until - statements.at(t)) / (statements.base - look.base)

    def _horizon(self, t: float, horizon: float) -> float:
        """The end of the time slice, or what lies beyond it where nobody else can run."""
        scheduler = self._machine.scheduler
        assert scheduler is not None
        if t >= horizon or self._first > scheduler.began:
            return horizon
        self._clock.now = t
        return max(horizon, scheduler.reach())

    def _note_vain(self, horizon: float, level: float) -> None:
        """Note since when the task looks for what nothing will bring about."""
        scheduler = self._machine.scheduler
        assert scheduler is not None
        if horizon >= scheduler.until and level == scheduler.next_change() == INFINITY:
            task = self._task
            assert task is not None
            task.in_vain = self._first if task.in_vain is None else task.in_vain
