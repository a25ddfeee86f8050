"""The time until which the values read by a task stay unchanged.

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
- Loops (`loops.py`): iterations that change nothing, or each number by the same amount, repeat until then, in one step.
- Conditions of PAUSE (`Condition` of `waits.py`): the wait sleeps until then.

Data. `notes` is the list of dependencies of the running task, None if no client needs any. A client that finds another
list than its own knows that some are missing.

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

from collections.abc import Callable, Iterable
from typing import Any

from motionlang.kernel.controller.clock import INFINITY, Clock

Note = tuple[Callable[..., float], tuple[Any, ...]]

# This close to a solved time, s, a reading is not relied upon: the solution and the reading are rounded.
CLOSE = 1e-7
# An iteration that reads more than this is not worth remembering.
MAX_NOTES = 500


def _levels(about: tuple[Any, ...]) -> tuple[tuple[Any, ...], ...]:
    """Return what a note is about, once for each side if its level is a distance from a centre."""
    if not about or not isinstance(about[-1], tuple):
        return (about,)
    *where, (distance, centre) = about
    return (*where, centre + distance), (*where, centre - distance)


class Dependencies:
    """The dependencies of the running task; `notes` is None without a client."""

    __slots__ = ("clock", "notes")

    def __init__(self, clock: Clock) -> None:
        self.clock = clock
        self.notes: list[Note] | None = None

    def note(self, until: Callable[..., float], *about: object) -> None:
        """Record that a value just read may change at `until(*about)` without an event."""
        notes = self.notes
        if notes is not None:
            notes.append((until, about))
            if len(notes) > MAX_NOTES:
                self.rest()  # a client then finds a list other than its own

    def rest(self) -> None:
        """Stop recording for the running task."""
        self.notes = None

    def until(self, since: float, notes: Iterable[Note]) -> float:
        """Return the first time from `since` on at which one of `notes` may change.

        Events are not taken into account.
        """
        clock = self.clock
        now, clock.now = clock.now, since
        earliest = INFINITY
        try:
            for until, about in set(notes):
                for level in _levels(about):
                    moment = until(*level)
                    if moment < earliest:
                        earliest = moment
        finally:
            clock.now = now
        return earliest

    def at_once(self, *about: object) -> float:
        """Return the present time, for a value that may change at any time."""
        return self.clock.now

    def ticks(self, base: float, until: Callable[..., float]) -> float:
        """Return the present time, for the milliseconds since `base`, which pass a level at `until(base, level)`."""
        return self.clock.now
