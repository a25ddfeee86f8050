"""An axis: its settings, its move buffer, and its motion as a list of profiles.

The motion is never sampled while the machine runs. `starts[i]` is the time at which `profiles[i]` began. The
last profile never ends (it rests at its end position, or continues at its end velocity), so position and
velocity are known exactly at any time.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from operator import itemgetter
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY, TimedCall
from motionlang.kernel.controller.scale import Scale
from motionlang.kernel.controller.watch import Thresholds, Watch
from motionlang.kernel.planners import MotionState, Profile, hold
from motionlang.kernel.planners.limits import LARGEST

if TYPE_CHECKING:
    from motionlang.kernel.controller.feedback import Feedback
    from motionlang.kernel.controller.state import ControllerState
    from motionlang.kernel.controller.triggers.homing import Homing
    from motionlang.kernel.controller.triggers.limit import Limit
    from motionlang.kernel.log.move import LoggedMove

# The initial settings of an axis; a dialect's table may override them (Mint's SPEED is 40000).
DEFAULTS: dict[str, float] = {
    "speed": 40_000.0,
    "accel": 100_000.0,
    "decel": 100_000.0,
    "accel_jerk": 1_000_000.0,
    "decel_jerk": 1_000_000.0,
    "ramp": 0.1,
    "buffer_size": 2.0,
}
# The reasons to suspend an axis: a keyword of the program, or an input. It resumes when none remains.
BY_WORD, BY_INPUT = 1, 2

# The jerk of a rate that takes effect at once.
_AT_ONCE = LARGEST


class Axis:
    """Settings, state and history of one axis of a controller."""

    __slots__ = (
        "_accel_jerk",
        "_decel_jerk",
        "accel",
        "accel_jerk_time",
        "accel_time",
        "arrival",
        "barriers",
        "buffer",
        "buffer_low",
        "buffer_size",
        "clock",
        "contour_angle",
        "contour_mode",
        "controller",
        "crossed",
        "datum",
        "decel",
        "decel_jerk_time",
        "decel_time",
        "enable_input",
        "enabled",
        "error_decel",
        "faults",
        "feedback",
        "feedrate_mode",
        "followers",
        "gains",
        "home",
        "homing",
        "index",
        "index_every",
        "index_origin",
        "is_at_home",
        "last_id",
        "limits",
        "locks",
        "max_accel",
        "max_decel",
        "max_speed",
        "move",
        "move_id",
        "offset_status",
        "override",
        "present",
        "profiles",
        "ramp",
        "s_ramp",
        "scale",
        "scales",
        "shape",
        "speed",
        "starts",
        "suspend_reasons",
        "suspend_time",
        "suspended_with",
        "target",
        "thresholds",
        "watches",
        "zeroed_at",
    )

    # The attributes that `cut` restores.
    GROWING = ("starts", "profiles")

    def __init__(self, index: int, controller: ControllerState) -> None:
        self.index, self.controller, self.clock = index, controller, controller.clock
        self.scale = Scale()
        # The scales of its motion in order: since when (s), counts of a user unit, zero in counts.
        self.scales = [(0.0, 1.0, 0.0)]
        self.enabled = True
        self.faults = 0
        self.locks = 0  # faults that must be cleared before the axis accepts a motion
        self.enable_input: int | None = None  # the input that must be on before the drive can be enabled
        self.is_at_home = False  # its home switch is closed
        self.shape = "trapezoid"
        self.speed = DEFAULTS["speed"]
        self.accel = DEFAULTS["accel"]
        self.decel = DEFAULTS["decel"]
        # Seconds from rest to `speed`; None while a rate is in force (the last one written takes effect).
        self.accel_time: float | None = None
        self.decel_time: float | None = None
        self._accel_jerk = DEFAULTS["accel_jerk"]
        self._decel_jerk = DEFAULTS["decel_jerk"]
        # Seconds in which a rate builds up, and the fraction of a ramp to `speed` in which it does. None
        # while a jerk, or the other one of the two, is in force.
        self.accel_jerk_time: float | None = None
        self.decel_jerk_time: float | None = None
        self.s_ramp: float | None = None
        self.error_decel = DEFAULTS["decel"]
        self.ramp = DEFAULTS["ramp"]
        # Mint's FEEDRATEMODE: with bit 0 a move keeps the speed it was loaded with; with bit 1 `override`
        # multiplies speeds.
        self.feedrate_mode = 1
        self.override = 1.0
        self.zeroed_at = -1  # where the program last set the speed to 0, a source offset
        self.suspend_reasons = 0  # reasons for its suspension: `BY_WORD`, `BY_INPUT` or both
        self.suspended_with: tuple[Axis, ...] = ()  # the axes suspended together with it by one keyword
        self.suspend_time = 0.1  # seconds in which the playback of a profile comes to rest
        # The highest speed and rates of its moves and paths, whatever a program commands.
        self.max_speed = self.max_accel = self.max_decel = INFINITY
        # True if paths are run without slowing down at corners up to an angle, degrees.
        self.contour_mode = False
        self.contour_angle = 0.0
        self.buffer_size = int(DEFAULTS["buffer_size"])
        self.buffer_low = -1  # free entries above which the listeners are notified; -1: never
        self.buffer: list[LoggedMove] = []
        self.move_id = 0  # the identifier of moves loaded from now on
        self.last_id = 0  # the identifier of the last move that left the buffer
        self.move: LoggedMove | None = None
        self.arrival: TimedCall | None = None
        self.target = 0.0
        # The position at the zero of power-up, and how far from there the last homing put the zero; counts.
        self.datum = 0.0
        self.home: float | None = None
        self.starts = [0.0]
        self.profiles: list[Profile] = [hold(0.0)]
        # The last profile, by which readers know that their cache is valid. None if it is not on the track
        # yet.
        self.present: Profile | None = self.profiles[-1]
        # In order of creation.
        self.watches: dict[Watch, None] = {}
        self.thresholds = Thresholds()
        # When the axis was last known to be exactly at a position, that position, and its profile.
        self.crossed: tuple[float, float, Profile] | None = None
        # Called with each new profile when it begins, such as by an axis that is geared to this one.
        self.followers: list[Callable[[Profile], None]] = []
        self.limits: list[Limit] = []
        # Those that a motion can meet: they have a position, or their switch is closed.
        self.barriers: list[Limit] = []
        # The homing in progress, which controls the axis alone; its buffer waits for the end.
        self.homing: Homing | None = None
        self.offset_status = 0  # the status of its last offset, bits (`motion/offset.py`)
        # The simulated motor, if there is one, and the gains that the program has set, by keyword.
        self.feedback: Feedback | None = None
        self.gains: dict[str, tuple[float, str]] = {}
        # The distance between the encoder's index marks in user units (0: there are none).
        self.index_every = 0.0
        self.index_origin = 0.0  # one of the marks, in counts of the machine

    @property
    def entries(self) -> tuple[LoggedMove, ...]:
        """The log entries that may still change, oldest first."""
        move = self.move
        if move is None or move.action is None:
            return () if move is None else (move,)
        return move.action.entries(self, move)

    @property
    def is_moving(self) -> bool:
        """True if a move is in progress."""
        return self.move is not None

    def extent(self) -> tuple[int, float, Profile]:
        """Return what `cut` needs to drop all profiles that are added from now on."""
        return len(self.starts), self.starts[-1], self.profiles[-1]

    def cut(self, extent: tuple[int, float, Profile]) -> None:
        """Drop the profiles since `extent` was taken.

        The last one is then the same object as before, by which readers and moves know it.
        """
        count, start, last = extent
        del self.starts[count:], self.profiles[count:]
        self.starts[-1], self.profiles[-1] = start, last

    def forget(self, retained: int) -> list[Profile]:
        """Drop all but about `retained` profiles, and those that the replay of a motor needs; return those dropped."""
        count = len(self.starts) - retained
        if count <= retained:
            return []
        if self.feedback is not None:
            count = self.feedback.forget(retained)
        dropped = self.profiles[:count]
        del self.starts[:count], self.profiles[:count]
        return dropped

    def set_scale(self, counts: float, rate: float, zero: float) -> None:
        """Set the conversion between user units and counts; the first one applies from power-up."""
        self.scale.set(counts, rate, zero)
        if len(self.starts) == 1 or self.scales[-1][0] == self.clock.now:
            since = self.scales.pop()[0]
            self.scales.append((since, counts, zero))
        elif self.scales[-1][1:] != (counts, zero):
            self.scales.append((self.clock.now, counts, zero))

    def scale_at(self, time: float) -> tuple[float, float]:
        """Return the counts of a user unit and the zero, in counts, at a time."""
        scales = self.scales
        return scales[max(bisect_right(scales, time, key=itemgetter(0)) - 1, 0)][1:]

    def place_at(self, time: float) -> float:
        """Return the commanded position at a time, in the user units of that time."""
        counts, zero = self.scale_at(time)
        return (self.position(time) - zero) / counts

    def index_at(self, time: float) -> int:
        """Return the index of the profile in force at a time; -1 before power-up."""
        return bisect_right(self.starts, time) - 1

    def idle_reader(self) -> Callable[[], bool]:
        """Return a function that is true if no move is in progress."""
        return lambda: self.move is None

    # ---------------------------------------------------------------------------------------- state at a time

    def at(self, time: float) -> MotionState:
        """Position, velocity, acceleration and jerk at `time`, counts and seconds."""
        start, profile = self.in_force(time)
        return profile.at(time - start)

    def position(self, time: float) -> float:
        """The commanded position at `time`; without a simulated motor also the actual one."""
        began = self.starts[-1]
        if time >= began:
            return self.profiles[-1].position(time - began)
        start, profile = self.in_force(time)
        return profile.position(time - start)

    def cross(self, now: float, position: float) -> None:
        """Record that the axis is exactly at `position` now.

        The time of a crossing is rounded, so the profile's position at that time is inexact.
        """
        self.crossed = now, position, self.profiles[-1]

    def here(self, now: float) -> float:
        """Return the commanded position now, exact if the axis is just crossing a watch."""
        crossed = self.crossed
        if crossed is not None and crossed[0] == now and crossed[2] is self.profiles[-1]:
            return crossed[1]
        return self.position(now)

    @property
    def actual_position(self) -> float:
        """The actual position now: the simulated motor's, or the commanded one."""
        return self.here(self.clock.now) if self.feedback is None else self.feedback.position

    def velocity(self, time: float) -> float:
        """Return the commanded velocity at `time`, counts/s."""
        began = self.starts[-1]
        if time >= began:
            return self.profiles[-1].velocity(time - began)
        start, profile = self.in_force(time)
        return profile.velocity(time - start)

    def in_force(self, time: float) -> tuple[float, Profile]:
        """Return the profile in force at `time`, and the time at which it began."""
        starts = self.starts
        if time >= starts[-1]:
            return starts[-1], self.profiles[-1]
        i = max(self.index_at(time), 0)
        return starts[i], self.profiles[i]

    def next_start(self, time: float) -> float:
        """The start of the profile after the one at `time`; infinite for the last one."""
        starts = self.starts
        if time >= starts[-1]:
            return INFINITY
        return starts[bisect_right(starts, time)]

    def end_of_motion(self) -> float:
        """Return the end time of the present profile; infinite while jogging."""
        last = self.profiles[-1]
        return self.starts[-1] if last.shape == "hold" else self.starts[-1] + last.duration

    def end_of_move(self) -> float:
        """Return when the axis will be idle if nothing else happens; -1 if it is now."""
        return -1.0 if self.move is None else self.end_of_motion()

    @property
    def is_at_standstill(self) -> bool:
        """True if the axis is idle, or at rest until another axis moves.

        The latter is the case while it follows a master at rest.
        """
        move = self.move
        return move is None or (move.action is not None and move.action.resting)

    @property
    def is_still(self) -> bool:
        """True if the axis and its simulated motor, if any, are at standstill for good."""
        return self.is_at_standstill and (self.feedback is None or self.feedback.at_standstill)

    @property
    def suspended(self) -> bool:
        """True if the axis has a reason for suspension: it stops and keeps its moves."""
        return self.suspend_reasons != 0

    def set_home(self) -> None:
        """Record the present zero as the one that a homing gave the axis."""
        self.home = self.scale.zero - self.datum

    @property
    def index_pitch(self) -> float:
        """Counts from one index mark to the next; 0 if the encoder has none."""
        return abs(self.scale.to_counts(self.index_every))

    @property
    def limited(self) -> bool:
        """True if the axis limits the speed or the rates of its moves."""
        return not self.max_speed == self.max_accel == self.max_decel == INFINITY

    def rates(self, speed: float) -> tuple[float, float]:
        """Return acceleration and deceleration in force, counts/s².

        If a ramp time is set, the rate is `speed` divided by that time.
        """
        accel = self.accel if self.accel_time is None else speed / self.accel_time
        decel = self.decel if self.decel_time is None else speed / self.decel_time
        return accel, decel

    def speed_and_rates(self, move: LoggedMove | None) -> tuple[float, float, float]:
        """Return speed and rates of a move: its own, or else those of the axis."""
        speed = self.speed if move is None or move.speed is None else move.speed
        accel, decel = self.rates(speed)
        if move is not None and move.rates is not None:
            accel, decel = move.rates[0] or accel, move.rates[1] or decel
        return speed, accel, decel

    def jerks(self, speed: float, accel: float, decel: float) -> tuple[float, float]:
        """Return the jerks of a move by its own speed and rates, counts/s³.

        If a jerk time is set, a jerk is the rate divided by that time.
        """
        accel_time, decel_time = self.accel_jerk_time, self.decel_jerk_time
        return (
            self._jerk(self._accel_jerk, accel_time, speed, accel),
            self._jerk(self._decel_jerk, decel_time, speed, decel),
        )

    @property
    def accel_jerk(self) -> float:
        """The jerk in force while speeding up to SPEED, counts/s³."""
        return self.jerks(self.speed, *self.rates(self.speed))[0]

    @accel_jerk.setter
    def accel_jerk(self, jerk: float) -> None:
        self._accel_jerk, self.accel_jerk_time, self.s_ramp = jerk, None, None

    @property
    def decel_jerk(self) -> float:
        """The jerk in force while slowing down from SPEED, counts/s³."""
        return self.jerks(self.speed, *self.rates(self.speed))[1]

    @decel_jerk.setter
    def decel_jerk(self, jerk: float) -> None:
        self._decel_jerk, self.decel_jerk_time, self.s_ramp = jerk, None, None

    def _jerk(self, jerk: float, time: float | None, speed: float, rate: float) -> float:
        if time is None and self.s_ramp is None:
            return jerk
        if time is None:
            time = self.s_ramp * speed / rate if rate else 0.0  # type: ignore[operator]
        return rate / time if time else _AT_ONCE

    @property
    def live_speed(self) -> bool:
        """True if a new speed acts at once on a move in progress.

        This is the inverse of bit 0 of the feed rate mode.
        """
        return not self.feedrate_mode & 1

    @live_speed.setter
    def live_speed(self, live: bool) -> None:
        self.feedrate_mode = self.feedrate_mode & ~1 | (not live)
