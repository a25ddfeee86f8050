"""The log of a run: all records in order, by kind.

Report, trace and proof read nothing else. The log only grows. Records are columns (`stream.py`), in memory and then in
an unnamed file, so the memory of a run does not depend on its length.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.log.moves import LoggedMoves
from motionlang.kernel.log.profiles import Profiles
from motionlang.kernel.log.records import (
    Changed,
    ChangedSetting,
    Event,
    Looped,
    Printed,
    Sampled,
    Switched,
    Waited,
    Zeroed,
)
from motionlang.kernel.log.stream import DISK, Store, Stream
from motionlang.kernel.log.time_slices import Mark as SliceMark
from motionlang.kernel.log.time_slices import TimeSliceStream

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis

# How many waits and time slices there are.
Mark = tuple[int, SliceMark]

# Profiles of all axes together that are not packed; fewer if motors follow some, whose pieces exist; and
# those of each axis that are never packed.
MAX_PROFILES, MAX_FOLLOWED, LEFT_PROFILES = 40_960, 10_240, 512
# The number of profiles after which a loop that starts motion after motion is detected: more than one in half
# a millisecond, from no more than a few lines.
FIRST_CHECK, HURRY, FEW_LINES = 1024, 5e-4, 4


def _most(axes: Collection[Axis]) -> int:
    return MAX_PROFILES if all(a.feedback is None for a in axes) else MAX_FOLLOWED


def nowhere() -> int:
    """Return the source offset of events without a program."""
    return -1


def by_none() -> tuple[int, ...]:
    """Return the calls that led to where no program is."""
    return ()


def no_origin() -> tuple[int, int]:
    """Return the origin of what no program does, as `Log.origin` does."""
    return -1, 0


class Log:
    """The streams of a run, all of them in one store.

    moves      every `LoggedMove` that was started, in order of start; updated until it is over
    dropped    moves that were loaded into a buffer and discarded: `ended` is the cause
    inputs, analogue_inputs: `Changed`
    outputs, analogue_outputs: `Switched`
    sampled    `Sampled`, from which `analogue_inputs` has the samples of sensors on moving axes
    settings   `ChangedSetting`, written if the value has changed
    zeros      `Zeroed`, each new zero of an axis
    waits      `Waited`, each when it is over
    loops      `Looped`, each loop of more than a hundred statements, when it is over
    slices     `TimeSlices`, if there is more than one task
    prints     `Printed`, lines of the console
    events     `Event`: limits, faults, clamps, stops and the like

    The profiles of an axis are in `Axis.starts` and `profiles`, the older ones packed in `Axis.older`.
    `WholeTrack` of `kernel/tracks/track.py` reads them as one sequence.
    """

    def __init__(self, disk: int = DISK) -> None:
        self.store = store = Store(disk=disk)
        self.moves, self.dropped = LoggedMoves(store), LoggedMoves(store)
        self.inputs: Stream[Changed] = Stream(store, Changed)
        self.outputs: Stream[Switched] = Stream(store, Switched)
        self.changes_of_analogue_inputs: Stream[Changed] = Stream(store, Changed)
        self.sampled: Stream[Sampled] = Stream(store, Sampled)
        # The changes of analogue inputs with the samples, which the controller computes.
        self.analogue_inputs: Iterable[Changed] = self.changes_of_analogue_inputs
        self.analogue_outputs: Stream[Switched] = Stream(store, Switched)
        self.settings: Stream[ChangedSetting] = Stream(store, ChangedSetting)
        self.zeros: Stream[Zeroed] = Stream(store, Zeroed)
        self.waits: Stream[Waited] = Stream(store, Waited)
        self.loops: Stream[Looped] = Stream(store, Looped)
        self.slices = TimeSliceStream(store)
        self.prints: Stream[Printed] = Stream(store, Printed)
        self.events: Stream[Event] = Stream(store, Event)
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
        # How many profiles may be made before some are packed.
        self.room = FIRST_CHECK
        self._is_checked = False
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
        self.events.add((time, kind, axis, value, limit, self.where(), ordered, text))

    def repeat_waits(self, task: str, began: float, period: float, count: int) -> None:
        """Log that the waits of a task since `began` repeat, each `period` later.

        They are the waits of an iteration whose repetitions are skipped.
        """
        mine: list[Waited] = []
        for wait in reversed(self.waits):
            if wait.until < began or wait.task != task or wait.since < began:
                break
            mine.append(wait)
        self.waits.repeat(len(self.waits) - len(mine), count, period)
        if mine:
            self.slices.rested(count, mine)

    def mark_period(self) -> Mark:
        """Return how much has been recorded of waits and time slices, for `repeat_period`."""
        return len(self.waits), self.slices.mark()

    def repeat_period(self, mark: Mark, began: float, now: float, until: float, times: int) -> None:
        """Log that the waits and time slices since `mark` repeat so many times.

        The period took from `began` to `now`, and its repetitions take up to `until`.
        """
        waits, slices = mark
        self.waits.repeat(waits, times, now - began)
        self.slices.repeat_since(slices, now, until, times)

    def new_prints(self) -> Stream[Printed]:
        """Create another stream of printed lines, such as those of another terminal."""
        made: Stream[Printed] = Stream(self.store, Printed)
        self.others.append(made)
        return made

    def make_room(self, axes: Collection[Axis]) -> None:
        """Pack profiles; the first call only checks how quickly moves follow each other."""
        self._check_hurry()
        if not self._is_checked:
            self._is_checked, self.room = True, _most(axes) - FIRST_CHECK
            return
        self.pack(axes)

    def pack(self, axes: Collection[Axis]) -> None:
        """Pack the profiles of axes except the newest, after packing their moves."""
        self.moves.pack(max(len(self.moves) - self.moves.packed - LEFT_PROFILES, 0))
        retained = 0
        for a in axes:
            self._pack_profiles(a, len(a.starts) - LEFT_PROFILES)
            retained += len(a.starts)
        self.room = max(_most(axes) - retained, LEFT_PROFILES)

    def _pack_profiles(self, a: Axis, count: int) -> None:
        """Pack the `count` oldest profiles of an axis."""
        if count > 0:
            a.older = a.older or Profiles(self.store)
            a.older.take_from(a, count)

    def _check_hurry(self) -> None:
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
            if len(a.starts) > 20 * retained:
                self._pack_profiles(a, len(a.starts) - 10 * retained)
            if a.older is not None and self.moves:
                a.older.forget_before(self.moves[self.moves.first].start_time)

    def finish_updates(self, axes: Iterable[Axis]) -> None:
        """Complete or drop what an interrupt has left half done."""
        for stream in self.streams():
            stream.finish_updates()
        for a in axes:
            if a.older is not None:
                a.older.complete(a)
                a.older = a.older if a.older.count else None

    def streams(self) -> tuple[Stream[Any] | LoggedMoves, ...]:
        """Return all streams except the profiles."""
        return (self.moves, self.dropped, self.inputs, self.outputs, self.changes_of_analogue_inputs, self.sampled,
                self.analogue_outputs, self.settings, self.zeros, self.waits, self.loops, self.slices, self.prints,
                self.events, *self.others)  # fmt: skip
