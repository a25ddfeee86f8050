"""The log of a run: all records in order, by kind.

Report, trace and proof read nothing else. The log only grows.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from motionlang.kernel.log.move import CONTINUED, LoggedMove
from motionlang.kernel.log.records import (
    Changed,
    ChangedSetting,
    Event,
    Looped,
    Printed,
    Sampled,
    Switched,
    Waited,
    Written,
    Zeroed,
)
from motionlang.kernel.log.stream import Budget, Stream, records_of
from motionlang.kernel.log.time_slices import Mark as SliceMark
from motionlang.kernel.log.time_slices import TimeSliceStream

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis
    from motionlang.kernel.planners import Profile

# How many waits and time slices there are.
Mark = tuple[int, SliceMark]

# A loop that starts motion after motion is detected after so many profiles, and at intervals: more than one in half a
# millisecond, from no more than a few lines.
FIRST_CHECK, INTERVAL, HURRY, FEW_LINES = 1024, 40_960, 5e-4, 4
# The memory of a profile with its start, and of its pieces or its formula and those of its move, bytes: measured,
# rounded up.
PROFILE, CURVE = 420, 1400


def nowhere() -> int:
    """Return the source offset of events without a program."""
    return -1


def by_none() -> tuple[int, ...]:
    """Return the calls that led to where no program is."""
    return ()


def no_origin() -> tuple[int, int]:
    """Return the origin of what no program does, as `Log.origin` does."""
    return -1, 0


def _size(profile: Profile) -> int:
    return PROFILE + CURVE if profile.is_large else PROFILE


class LoggedMoves(Stream[LoggedMove]):
    """All moves in order of start."""

    size = 260

    def __init__(self, budget: Budget) -> None:
        super().__init__(budget)
        # The axes of the moves; none before power-up.
        self.axes: Mapping[int, Axis] = {}

    def split(self, move: LoggedMove, done: Profile, now: float) -> None:
        """Continue a move as another entry; the old one ends now, with the profile `done`."""
        sealed = LoggedMove(move.axis, move.command, move.line, move.target)
        sealed.commanded_speed, sealed.chain, sealed.action = move.commanded_speed, move.chain, move.action
        sealed.scale, sealed.zero, sealed.offset = move.scale, move.zero, move.offset
        sealed.start_time, sealed.profile, sealed.ended = move.start_time, done, CONTINUED
        # It is no longer there if it began before the oldest one left.
        k = next((k for k in reversed(range(len(self.rows))) if self.rows[k] is move), None)
        if k is not None:
            self.rows[k] = sealed
        move.start_time, move.offset = now, 0.0
        self.add(move)

    def extent(self) -> tuple[int, dict[int, LoggedMove]]:
        """Return the number of moves, and those in progress by their places."""
        moves = [move for a in self.axes.values() for move in a.entries]
        on_top = [getattr(move.action, "offset_entry", None) for move in moves]
        live = {id(move) for move in (*moves, *on_top)}
        return len(self.rows), {k: move for k, move in enumerate(self.rows) if id(move) in live}

    def cut(self, extent: tuple[int, dict[int, LoggedMove]]) -> None:
        """Drop later moves; those that were in progress are in progress again, as the same objects."""
        count, live = extent
        del self.rows[count:]
        for k, move in live.items():
            self.rows[k] = move


class Log:
    """The streams of a run.

    moves      every `LoggedMove` that was started, in order of start; updated until it is over
    dropped    moves that were loaded into a buffer and discarded: `ended` is the cause
    inputs, analogue_inputs: `Changed`
    outputs, analogue_outputs: `Switched`
    writes     `Written`, each change of a value for the host or in another device
    sampled    `Sampled`, from which `analogue_inputs` has the samples of sensors on moving axes
    settings   `ChangedSetting`, written if the value has changed
    zeros      `Zeroed`, each new zero of an axis
    waits      `Waited`, each when it is over
    loops      `Looped`, each loop of more than a hundred statements, when it is over
    slices     `TimeSlices`, if there is more than one task
    prints     `Printed`, lines of the console
    events     `Event`: limits, faults, clamps, stops and the like

    The profiles of an axis are in `Axis.starts` and `profiles`.
    """

    def __init__(self) -> None:
        self.budget = Budget()
        self.moves, self.dropped = LoggedMoves(self.budget), LoggedMoves(self.budget)
        self.inputs: Stream[Changed] = Stream(self.budget)
        self.outputs: Stream[Switched] = Stream(self.budget)
        self.changes_of_analogue_inputs: Stream[Changed] = Stream(self.budget)
        self.sampled: Stream[Sampled] = Stream(self.budget)
        # The changes of analogue inputs with the samples, which the controller computes.
        self.analogue_inputs: Iterable[Changed] = self.changes_of_analogue_inputs
        self.analogue_outputs: Stream[Switched] = Stream(self.budget)
        self.writes: Stream[Written] = Stream(self.budget)
        self.settings: Stream[ChangedSetting] = Stream(self.budget)
        self.zeros: Stream[Zeroed] = Stream(self.budget)
        self.waits: Stream[Waited] = Stream(self.budget)
        self.loops: Stream[Looped] = Stream(self.budget)
        self.slices = TimeSliceStream(self.budget)
        self.prints: Stream[Printed] = Stream(self.budget)
        self.events: Stream[Event] = Stream(self.budget)
        # The last clamp or late rate of each axis and quantity, which is reported once, and the source offset of the
        # program.
        self.clamped: dict[tuple[int, str], tuple[int, float, float]] = {}
        # The move and the cause of the last velocity jump of each axis, with the number of its event; and how often
        # events have occurred, those that did more than once.
        self.jumps: dict[int, tuple[tuple[LoggedMove | None, str], int]] = {}
        self.repeated: dict[int, int] = {}
        self.where: Callable[[], int] = nowhere
        self.calls: Callable[[], tuple[int, ...]] = by_none
        # The distinct calls that led to a statement, by number; most have none.
        self._chains: dict[tuple[int, ...], int] = {(): 0}
        self.callers: list[tuple[int, ...]] = [()]
        self.others: list[Stream[Printed]] = []
        # The number of profiles so far.
        self.profiles = 0
        # Called with a move, the number of those before it and the time from the first of them to it.
        self.hurried: Callable[[LoggedMove, int, float], object] | None = None

    def power_up(self, axes: Mapping[int, Axis]) -> None:
        """Connect the axes of a controller."""
        self.moves.axes = self.dropped.axes = axes

    def locate_by(self, where: Callable[[], int], calls: Callable[[], tuple[int, ...]] = by_none) -> None:
        """Set the functions that return the source offset of an event, and those of the calls that led there."""
        self.where, self.calls = where, calls

    def chain(self) -> int:
        """Return the number of the calls that led to where the program is, which `callers` has."""
        calls = self.calls()
        found = self._chains.get(calls)
        if found is None:
            found = self._chains[calls] = len(self.callers)
            self.callers.append(calls)
        return found

    def origin(self) -> tuple[int, int]:
        """Return the source offset of the program, -1 without one, and the number of the calls that led there."""
        return self.where(), self.chain()

    def note(
        self,
        time: float,
        kind: str,
        axis: int | None = None,
        value: float | None = None,
        limit: float | None = None,
        ordered: int = 0,
        text: str = "",
    ) -> None:
        """Write an event with the current source offset."""
        self.events.add(Event(time, kind, axis, value, limit, self.where(), ordered, text))

    def write(self, time: float, target: str, value: float, is_output: bool = False) -> None:
        """Log that the program wrote another value into a place that others read."""
        self.writes.add(Written(time, target, value, *self.origin(), is_output))

    def repeat_waits(self, task: str, began: float, period: float, count: int) -> None:
        """Log that the waits of a task since `began` repeat, each `period` later.

        They are the waits of an iteration whose repetitions are skipped.
        """
        mine: list[Any] = []
        for row in reversed(self.waits.rows):
            wait: Waited = next(records_of((row,)))
            if wait.until < began or wait.task != task or wait.since < began:
                break
            mine.append(row)
        self.waits.repeat(self.waits.past - len(mine), count, period)
        if mine:
            self.slices.rested(count, records_of(mine))

    def mark_period(self) -> Mark:
        """Return how much has been recorded of waits and time slices, for `repeat_period`."""
        return self.waits.past, self.slices.mark()

    def repeat_period(self, mark: Mark, began: float, now: float, until: float, times: int) -> None:
        """Log that the waits and time slices since `mark` repeat so many times.

        The period took from `began` to `now`, and its repetitions take up to `until`.
        """
        waits, slices = mark
        self.waits.repeat(waits, times, now - began)
        self.slices.repeat_since(slices, now, until, times)

    def new_prints(self) -> Stream[Printed]:
        """Create another stream of printed lines, such as those of another terminal."""
        made: Stream[Printed] = Stream(self.budget)
        self.others.append(made)
        return made

    def count_profile(self, before: Profile) -> None:
        """Count a new profile on a track; the one before it has the pieces that were computed of it."""
        self.budget.take(_size(before))
        self.profiles += 1
        if self.profiles % INTERVAL == FIRST_CHECK + 1:
            self.check_hurry()

    def check_hurry(self) -> None:
        """Report a loop that starts one motion after another without time to execute them."""
        moves, count = self.moves, min(len(self.moves), FIRST_CHECK)
        if count < FIRST_CHECK // 2 or self.hurried is None:
            return
        last = moves[-1]
        span = last.start_time - moves[-count].start_time
        if span < HURRY * count and len({move.line for move in moves[-count:]}) <= FEW_LINES:
            self.hurried(last, count, span)

    def forget(self, retained: int, axes: Iterable[Axis]) -> None:
        """Drop all but about `retained` records per kind, and ten times as many profiles."""
        for stream in self.streams():
            stream.forget(retained)
        for a in axes:
            self.budget.take(-sum(map(_size, a.forget(10 * retained))))
        self.repeated = {
            number: count for number, count in self.repeated.items() if number >= self.events.first
        }

    def streams(self) -> tuple[Stream[Any], ...]:
        """Return all streams except the profiles."""
        return (self.moves, self.dropped, self.inputs, self.outputs, self.changes_of_analogue_inputs, self.sampled,
                self.analogue_outputs, self.writes, self.settings, self.zeros, self.waits, self.loops, self.slices,
                self.prints, self.events, *self.others)  # fmt: skip
