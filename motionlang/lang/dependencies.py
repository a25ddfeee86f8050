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
- Loops of steps, in MCCL (`loops.py`): like loops of Mint, for one task or several.
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

from motionlang.controller.clock import INFINITY

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any

    from motionlang.controller.clock import Clock

    Note = tuple[Callable[..., float], tuple[Any, ...]]

# This close to a solved time, s, a reading is not relied upon: the solution and the reading are rounded.
CLOSE = 1e-7
# An iteration that reads more than this is not worth remembering.
MAX_NOTES = 500
_NO_DEPENDENCY = (-INFINITY,)
# The level of a value without a comparison, and that of a running maximum.
_OF_LOOPS = (_NO_DEPENDENCY, (INFINITY,))


class Dependencies:
    """The dependencies of the running task; `notes` is None without a subscriber.

    `read` has the dependencies of all tasks since a subscriber to all readings began, None while there is no
    such subscriber. While it is set, `notes` is not None. `longest` is the same set while a subscriber from
    `begin_longest` needs all readings; any other subscriber then shares the set.
    """

    __slots__ = ("clock", "longest", "notes", "read")

    def __init__(self, clock: Clock) -> None:
        self.clock = clock
        self.notes: list[Note] | None = None
        self.read: set[Note] | None = None
        self.longest: set[Note] | None = None

    def note(self, until: Callable[..., float], *about: object) -> None:
        """Record that a value just read may change at `until(*about)` without an event.

        A value compared with -INFINITY is only stored, so it is not a dependency.
        """
        notes, read = self.notes, self.read
        if read is not None:
            # Only a loop that executes its last iteration can use these levels instead of the exact value.
            read.add((self.at_once, ()) if about[-1:] in _OF_LOOPS else (until, about))
            if len(read) > MAX_NOTES:
                self.read = self.longest = None
        if notes is not None and about[-1:] != _NO_DEPENDENCY:
            notes.append((until, about))
            if len(notes) > MAX_NOTES:
                self.rest()  # a client then finds a list other than its own

    def begin_all(self) -> set[Note]:
        """Start collecting the readings of all tasks; return the set that collects them."""
        self.read = set() if self.longest is None else self.longest
        return self.read

    def end_all(self) -> None:
        """Stop collecting the readings of all tasks, unless `longest` continues."""
        self.read = self.longest

    def begin_longest(self) -> set[Note]:
        """Start collecting like `begin_all`; other subscribers do not end it."""
        self.longest = None
        self.longest = self.begin_all()
        return self.longest

    def end_longest(self, read: set[Note]) -> None:
        """Stop the collection that `begin_longest` started."""
        if self.longest is read:
            self.longest = self.read = None

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
        earliest = INFINITY
        try:
            for until, about in set(notes):
                moment = until(*about)
                if moment < earliest:
                    earliest = moment
        finally:
            clock.now = now
        return earliest

    def stable_until(self, notes: list[Note], first: int, since: float) -> float:
        """Return the time until which all readings from index `first` on stay unchanged.

        The result is in the past if another list has been begun since.
        """
        return self.until(since - CLOSE, notes[first:]) - CLOSE if self.notes is notes else -INFINITY

    def at_once(self, *about: object) -> float:
        """Return the present time, for a value that may change at any time."""
        return self.clock.now
