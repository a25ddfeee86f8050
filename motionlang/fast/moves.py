"""Fast-path moves: an unobserved move from rest to rest is a tuple of numbers.

Replaces: for each move, the engine makes a `Move` in the buffer, the move's two profiles on the track, and the event
of its end. Here a move in the buffer is an `Entry`. A started one is a `Row` (log/plain_moves.py), in the log and
alongside the track of its axis, and the event is reused.

Hook: `Accelerators.axes` creates the axes of a controller. `GO` calls `start_loaded` before it reads the
buffer, `move_to` calls `start_at_once`, and a language that loads moves repeatedly requests a `loader`; all
three are no-ops on an `Axis` of the engine.

Gain: a shift with its report 3.0 times, its run alone 3.8 times (`shift` and `shift_run` of benchmarks/shift.py).

Equality is tested by: tests/fast/test_plain_moves.py with random programs that read the axes at any time;
tests/log/test_interrupted.py ends a run at each line of this file.

A read of the move, the buffer, the arrival event or the track of the axis materialises them: the tuples become the
`Move`, the profiles and the rests that the engine would have made by then. So no other module knows of fast-path
moves. The conditions that rule out a fast-path move (a motor, a follower, another shape, a limit or a watch in its
range) are checked only when it begins: a later change of one of them reads the move first. The interval in which an
axis passes no watch is computed once (`Watches.free`), until the watches change. The end of such a move wakes no task
while there is no listener for rest, so a wait that knows when its axes will be at rest is not checked again
(`Scheduler.comes_to_rest`).
"""

from __future__ import annotations

from motionlang.controller import triggers
from motionlang.controller.axis import Axis
from motionlang.log.plain_moves import entry_of, move_of, profile_of
from motionlang.planners import hold
from motionlang.planners.trapezoid import from_rest

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.clock import Event
    from motionlang.controller.core import Core
    from motionlang.controller.move import Move
    from motionlang.controller.readers import Loader
    from motionlang.log.moves import Moves
    from motionlang.log.plain_moves import Entry, Row
    from motionlang.planners import Profile

    # Distance, speed, acceleration and deceleration, and their result: duration and recipe of the profile.
    Plan = tuple[float, float, float, float, tuple[float, tuple[float, ...]]]

# A plan that matches no move.
_NO_PLAN: Plan = (float("nan"), 0.0, 0.0, 0.0, (0.0, ()))


class FastAxis(Axis):
    """An axis that stores moves as tuples until they are read."""

    __slots__ = (
        "_arrival",
        "_buffer",
        "_move",
        "_profiles",
        "_starts",
        "arrival_event",
        "ends",
        "in_motion",
        "loaded",
        "logged",
        "plan",
        "plan_before",
        "rows",
        "writing",
    )

    def __init__(self, index: int) -> None:
        # The move in the buffer, and those that were started since the track was last written. True if the
        # last of them is in motion, its end time, and the event of its end.
        self.loaded: Entry | None = None
        self.rows: list[Row] = []
        self.in_motion = False
        self.ends = 0.0
        self.arrival_event: Event | None = None
        # Of the last move, and of the one before: cycles alternate between two.
        self.plan = self.plan_before = _NO_PLAN
        # While rows are written on the track: its previous length, the rows, and the visible `Move` of the
        # last one.
        self.writing: tuple[int, list[Row], Move | None] | None = None
        self.logged: Moves | None = None  # the log of moves, from the first loader on
        super().__init__(index)

    # ------------------------------------------------------------------------------------- materialising rows

    @property
    def move(self) -> Move | None:
        """The move in progress."""
        if self.in_motion:
            self._write()
        return self._move

    @move.setter
    def move(self, move: Move | None) -> None:
        if self.in_motion:
            self._write()
        self._move = move

    @property
    def arrival(self) -> Event | None:
        """The event of the end of the move in progress."""
        if self.in_motion:
            self._write()
        return self._arrival

    @arrival.setter
    def arrival(self, event: Event | None) -> None:
        if self.in_motion:
            self._write()
        self._arrival = event

    @property
    def buffer(self) -> list[Move]:
        """The waiting moves, in order of execution."""
        if self.in_motion:
            self._write()
        if self.loaded is not None:
            entry, self.loaded = self.loaded, None
            self._buffer.append(entry_of(self.index, entry))
        return self._buffer

    @buffer.setter
    def buffer(self, entries: list[Move]) -> None:
        self.loaded, self._buffer = None, entries

    @property
    def starts(self) -> list[float]:
        """The start times of `profiles`."""
        if self.rows:
            self._write()
        return self._starts

    @starts.setter
    def starts(self, starts: list[float]) -> None:
        self._starts = starts

    @property
    def profiles(self) -> list[Profile]:
        """The profiles of the axis's track."""
        if self.rows:
            self._write()
        return self._profiles

    @profiles.setter
    def profiles(self, profiles: list[Profile]) -> None:
        self._profiles = profiles

    def _write(self) -> None:
        """Write the rows to the track; the one in motion becomes a visible `Move`."""
        rows = self.rows[:]
        self.writing = len(self._profiles), rows, move_of(rows[-1]) if self.in_motion else None
        self._go_on_writing()

    def _go_on_writing(self) -> None:
        """Execute `writing`; after an interrupt repeat it from the start."""
        assert self.writing is not None
        first, rows, move = self.writing
        self._starts[first:], self._profiles[first:] = written(rows, move is not None)
        self.rows.clear()
        self.present = self._profiles[-1]
        if move is not None:
            assert self.logged is not None
            move.profile = self.present
            self._move = move
            self._arrival, self.arrival_event = self.arrival_event or self._arrival, None
            self.logged.show(rows[-1], move)
            self.in_motion = False
        self.writing = None

    def finish_updates(self, now: float) -> None:
        """After an interrupt, complete partial writes and roll back an unlogged move."""
        if self.writing is not None:
            self._go_on_writing()
        row = self.rows[-1] if self.rows else None
        if row is not None and row[1] == now and self.logged is not None and not self.logged.has(row):
            self.rows.pop()
            self.in_motion, self.loaded = False, row[-1]
            self.ends = self.rows[-1][1] + self.rows[-1][4] if self.rows else now
            self.present = None if self.rows else self._profiles[-1]

    # --------------------------------------------------------------------------------- answered from rows

    @property
    def moves(self) -> bool:
        """True if a move is in progress."""
        return self.in_motion or self._move is not None

    @property
    def is_at_standstill(self) -> bool:
        """True if the axis is idle, or at rest until another axis moves."""
        return not self.in_motion and super().is_at_standstill

    def position(self, time: float) -> float:
        """The commanded position at `time`; without a simulated motor also the actual one."""
        if self.rows and not self.in_motion and time > self.ends:
            return self.rows[-1][3] + 0.0
        return super().position(time)

    def velocity(self, time: float) -> float:
        """Return the commanded velocity at `time`, counts/s."""
        if self.rows and not self.in_motion and time > self.ends:
            return 0.0
        return super().velocity(time)

    def end_of_motion(self) -> float:
        """Return the end time of the present profile; infinite while jogging."""
        return self.ends if self.rows else super().end_of_motion()

    def end_of_move(self) -> float:
        """Return when the axis will be idle if nothing else happens; -1 if it is now."""
        return self.ends if self.in_motion else -1.0 if self._move is None else self.end_of_motion()

    def idle_reader(self) -> Callable[[], bool]:
        """Return a function that is true if no move is in progress."""
        return lambda: not self.in_motion and self._move is None

    # ----------------------------------------------------------------------------- loading and starting moves

    def loader(self, controller: Core, relative: bool, command: str) -> Loader:
        """Return a fast function that loads moves to a position or by a distance.

        It takes the position or distance in user units, and a line. It returns false if the move must be a `Move`.
        """
        braked, scale, axis = controller.braked, self.scale, self.index
        self.logged = controller.log.moves

        def load(value: float, line: int) -> bool:
            if (
                self.in_motion
                or self._move is not None
                or self.loaded is not None
                or self._buffer
                or self.own_rates is not None
                or self.feedrate_mode > 1
                or self.buffer_size < 1
                or self.feedback is not None
                or self.faults & self.locks
                or not self.enabled
                or axis in braked
                or not -1e300 < value < 1e300
            ):
                return False
            base = None
            if relative:
                base = self.target
                if not -1e300 < base < 1e300:
                    return False
                value = base + value * scale.counts
            else:
                value = scale.position_to_counts(value)
            self.loaded = value, base, command, line, self.speed if self.feedrate_mode else None, self.move_id
            return True

        return load

    def start_loaded(self, controller: Core) -> bool:
        """Start the move that `loader` has loaded; false if there is none.

        False also if the move must be a `Move`.
        """
        entry = self.loaded
        if entry is None or (
            self._move is not None
            or self.faults & self.locks
            or not self.enabled
            or self.index in controller.braked
            or self.suspend_reasons
            or self.shape != "trapezoid"
            or self.index in controller.homings
            or self.feedback is not None
            or self.followers
            or self.buffer_low >= 0
        ):
            return False
        target, base, _, line, speed, mark = entry
        if speed is None:
            speed = self.speed
        accel = self.accel if self.accel_time is None else speed / self.accel_time
        decel = self.decel if self.decel_time is None else speed / self.decel_time
        if speed > self.max_speed or accel > self.max_accel or decel > self.max_decel:
            return False
        rows = self.rows
        if rows:
            start = rows[-1][3]
        else:
            last = self._profiles[-1]
            if last.shape != "hold":
                return False
            start = last.end
        if base is not None and base != self.target:
            target += self.target - base
        watches = self.watches
        if watches.all or self.limits:
            low, high = watches.free or triggers.next_watches.free_interval(self, start)
            if not (low < start < high and low < target < high):
                return False
        distance = target - start
        plan = self.plan_before
        if distance == plan[0] and speed == plan[1] and accel == plan[2] and decel == plan[3]:
            self.plan_before, self.plan = self.plan, plan
        else:
            ramps = from_rest(distance, speed, accel, decel)
            if ramps is None:
                return False
            self.plan_before, self.plan = self.plan, (distance, speed, accel, decel, ramps)
        duration, recipe = self.plan[4]
        scale, log, clock = self.scale, controller.log, controller.clock
        now = clock.now
        row = self.index, now, start, target, duration, recipe, speed, scale.counts, scale.zero, entry
        rows.append(row)
        self.loaded, self.target, self.last_id, self.in_motion = None, target, mark, True
        self.ends = end = now + duration
        self.present = None
        if self.arrival_event is None:
            self.arrival_event = clock.at(end, self._arrival_of(controller))
        else:
            clock.again(self.arrival_event, end)
        if controller.expected_motion is not None:
            controller.expected_motion.add_plain(self, line, speed)
        log.moves.append(row)  # type: ignore[arg-type]
        log.room -= 1
        if log.room < 0:
            controller.make_room()
        return True

    def start_at_once(self, controller: Core, target: float, command: str, line: int) -> bool:
        """Start a move to `target`, counts, without a `Move`; false if it needs one."""
        if (
            self.in_motion
            or self._move is not None
            or self.loaded is not None
            or self._buffer
            or self.own_rates is not None
            or self.feedrate_mode > 1
            or not -1e300 < target < 1e300
        ):
            return False
        if self.logged is None:
            self.logged = controller.log.moves
        last_id = self.last_id
        self.loaded = target, None, command, line, self.speed if self.feedrate_mode else None, self.move_id
        if self.start_loaded(controller):
            self.last_id = last_id  # that of the last entry of the buffer
            return True
        self.loaded = None
        return False

    def _arrival_of(self, controller: Core) -> Callable[[], bool]:
        """Return the handler for the end of every fast-path move.

        The handler returns true if it woke no task.
        """
        clock, log, listeners = controller.clock, controller.log, controller.listeners

        def arrive() -> bool:
            if not self.in_motion or clock.now != self.ends or self.followers:
                controller.arrive(self)
                return False
            self.in_motion = False
            if controller.expected_motion is not None:
                controller.expected_motion.add(self)
            log.room -= 1
            if log.room < 0:
                controller.make_room()
            if listeners.of_rest:
                controller.notify("idle", self.index)
                return False
            return True

        return arrive


def written(rows: list[Row], in_motion: bool) -> tuple[list[float], list[Profile]]:
    """Return the starts and profiles of consecutive moves and of the rests after them.

    If `in_motion`, the last move has no rest yet.
    """
    starts: list[float] = []
    profiles: list[Profile] = []
    for row in rows:
        starts += row[1], row[1] + row[4]
        profiles += profile_of(row), hold(row[3])
    if in_motion:
        del starts[-1], profiles[-1]
    return starts, profiles
