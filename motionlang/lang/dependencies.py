"""Dependencies: the time until which the values read by a task stay unchanged.

Problem. Programs poll, as in `While POS(0) < 50 : End While`. An iteration takes 10 µs of machine time, so
eight hours of waiting are some 3 × 10⁹ iterations. Most values change only by an event, such as an input or
the end of a move. But positions, velocities and times change by themselves, without an event.

Idea. A value that changes by itself records a dependency as it is read: `(until, about)`. The call
`until(*about)` returns the first time, from the clock's on, at which the value may differ. If the program
compares the value with a level, that is the time at which the value passes the level, solved from the profile
of the motion. Up to that time, or the next event if it comes first, an iteration takes the same branches as
the one before.

    position      _____
                 /
     50 ......../             `POS(0) < 50` stays true until 1.25 s,
               /:             so all iterations before that are alike
        ______/ :
        ────────|─────── time
             1.25 s

The clients, which need the earliest of these times:
- Loops of Mint (`loop_skipping.py`): an iteration that did nothing and left every variable unchanged repeats
  until then, in one step.
- Conditions of PAUSE (`Condition` of `waits.py`): the wait sleeps until then.
- Loops of MCCL (`poll.py`): like loops of Mint, with the accumulator as the variable.
- Periods of several polling tasks, for which `read` collects the dependencies of all tasks.

Data. `notes` is the list of dependencies of the running task, None if no client needs any. Nested loops share
the list, and each remembers how long it was when its iteration began. Two levels are special. -infinity: the
loop only stores the value without a comparison, so there is no dependency. +infinity: the loop keeps the
largest value so far, and its iterations stay equal until the value has an extremum. In `read` a value with
either level counts as changing at once.

Invariants.
- A dependency may be too early, never too late. Too early costs a check; too late would change the result.
  Solutions are rounded, so a value is relied on only until `CLOSE` before the solved time.
- It is valid for the motion in force and stores no result: each check solves it again. Events are left to the
  client, which also stops at the next one.
- `until` is called with the clock set to the time in question; the clock is set back afterwards.
- A value that cannot be solved may change at once. A PAUSE on it is tested every millisecond, at the
  profiler's ticks.
- `POS > 50` is false at the exact time of 50, so a PAUSE is also tested just after a solved time.

Cost. One test for each value read, plus one append while there is a client. A check solves each distinct
dependency once. An iteration that reads more than `MAX_NOTES` values is never skipped. Checks that fail cost
little, by exponential back-off in the clients: after a failed check a loop runs unchecked for 1, 2, 4, …
iterations, and records nothing.
"""

from __future__ import annotations

from motionlang.lang.task import CLOSE, INFINITY, Wait

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any

    from motionlang.controller.clock import Clock

    Note = tuple[Callable[..., float], tuple[Any, ...]]

# An iteration that reads more than this is not worth remembering.
MAX_NOTES = 500
# The profiler's period: how often a condition is checked if its readings cannot be solved.
TICK = 1e-3
# How long after a solved time a condition is checked: `POS > 50` is false at the exact time of 50.
_AFTER = (0.0, 1e-12, 1e-10, 1e-8)
_NO_DEPENDENCY = (-INFINITY,)
# The level of a value without a comparison, and that of a running maximum.
_OF_LOOPS = (_NO_DEPENDENCY, (INFINITY,))


class Dependencies:
    """The dependencies of the running task; `notes` is None without a subscriber.

    `read` has the dependencies of all tasks since a subscriber to all readings began, None while there is no
    such subscriber. While it is set, `notes` is not None. `longest` is the same set while a subscriber from
    `begin_longest` needs all readings; any other subscriber then shares the set.
    """

    __slots__ = ("clock", "notes", "read")

    def __init__(self, clock: Clock) -> None:
        self.clock = clock
        self.notes: list[Note] | None = None
        self.read: set[Note] | None = None

    def note(self, until: Callable[..., float], *about: object) -> None:
        """Record that a value just read may change at `until(*about)` without an event.

        A value compared with -INFINITY is only stored, so it is not a dependency.
        """
        notes, read = self.notes, self.read
        if read is not None:
            # Only a loop that executes its last iteration can use these levels instead of the exact value.
            read.add((self.at_once, ()) if about[-1:] in _OF_LOOPS else (until, about))
            if len(read) > MAX_NOTES:
                self.read = None
        if notes is not None and about[-1:] != _NO_DEPENDENCY:
            notes.append((until, about))
            if len(notes) > MAX_NOTES:
                self.rest()  # a client then finds another list than the one it began with

    def rest(self) -> None:
        """Stop recording for the running task."""
        self.notes = None if self.read is None else []

    def begin(self) -> tuple[list[Note], int]:
        """Start recording; return the list and its present length."""
        if self.notes is None:
            self.notes = []
        return self.notes, len(self.notes)

    def until(self, since: float, notes: Iterable[Note]) -> float:
        """Return the first time from `since` on at which one of `notes` may change.

        Events are not taken into account.
        """
        clock = self.clock
        now, clock.now = clock.now, since
        try:
            return min((until(*about) for until, about in set(notes)), default=INFINITY)
        finally:
            clock.now = now

    def held(self, notes: list[Note], first: int, since: float) -> float:
        """Return until when all readings from index `first` on stay unchanged.

        The result is in the past if another list has been begun since.
        """
        return self.until(since - CLOSE, notes[first:]) - CLOSE if self.notes is notes else -INFINITY

    def at_once(self, *about: object) -> float:
        """Return the present time, for a value that may change at any time."""
        return self.clock.now


class Condition(Wait):
    """A wait for a condition: checked at solved times, events, or ticks if unsolvable.

    `solved` is the time that `due` returned last.
    """

    __slots__ = ("_dependencies", "_looked", "_notes", "_test", "ignores_data", "solved")

    cause = "condition"
    what = ()
    ends = None

    def __init__(
        self,
        dependencies: Dependencies,
        test: Callable[[], object],
        since: float,
        why: str,
        ignores_data: bool = False,
    ) -> None:
        self.ignores_data = ignores_data
        self._dependencies, self._test, self.since, self.why = dependencies, test, since, why
        self._notes: list[Note] = []
        # When the dependencies were recorded, after how many events, and the time for which they were last
        # solved.
        self._looked, self.solved = (-1.0, -1), -1.0

    def ready(self) -> bool:
        """Return if the condition is true now, or immediately after."""
        clock = self._dependencies.clock
        now = clock.now
        self._looked = now, clock.fired
        looks = _AFTER if now == self.solved else _AFTER[:1]
        try:
            return any(self._evaluate(now + after * max(1.0, now)) for after in looks)
        finally:
            clock.now = now

    def due(self) -> float:
        """Return the next time at which the condition may change by itself."""
        clock = self._dependencies.clock
        now = clock.now
        if self._looked != (now, clock.fired):
            self.ready()  # other tasks have run since
        # After the time that was just checked.
        begin = now + 1e-7 * max(1.0, now) if now == self.solved else now
        moments = [self._dependencies.until(begin, [each]) for each in set(self._notes)]
        moment = min((each if each > begin else next_tick(now) for each in moments), default=INFINITY)
        self.solved = moment if moment > now else now + TICK
        return self.solved

    def _evaluate(self, moment: float) -> bool:
        """Evaluate the condition at a time, and store its dependencies."""
        dependencies = self._dependencies
        notes: list[Note] = []
        before, dependencies.notes = dependencies.notes, notes
        dependencies.clock.now = moment
        try:
            return bool(self._test())
        finally:
            self._notes = notes if dependencies.notes is notes else [(dependencies.at_once, ())]
            dependencies.notes = before


def next_tick(now: float) -> float:
    """Return the first tick of the profiler after a time."""
    return (int(now / TICK + 1e-6) + 1) * TICK
