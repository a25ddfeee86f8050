"""Feedback of a simulated motor: encoder readings, and the events that they cause.

Problem. A motor under servo is a sampled system: thousands of samples a second, each computed from the one
before. The rest of the controller is solved in closed form and jumps from event to event. A program may read
the position at any time. A limit, a switch or a wait must act at the sample at which the motor reaches it,
even if no program reads it.

Idea. The servo is simulated ahead of the clock, in blocks, on the assumption that no further command affects
the axis. A reading is a lookup in the block. Everything that waits for the motor is searched for in the block
and becomes an event of the clock, at the time of its sample. A new profile or gain makes the rest of the block
wrong. Then the block is dropped and the simulation continues from the present sample.

    samples ─────────┬──────────────┬──────────────────┬───────────
             dropped │ searched     │ to come          │ not computed
                  scanned          now            end of the block

Data. `_servo` is the simulation. `_samples` has the samples that are still needed: encoder, velocity, following
error, output and current. Sample k is taken at the time k / servo rate. `changes` lists all changes to the
loop, by time, so that a report or a trace can run the servo again. Three things are searched for:
- positions that watches wait for, such as switches, latches and limits,
- a following error beyond its limit or its warning level,
- windows: the motor has settled within an error, and a speed, for long enough.

The simulation has coordinates of its own. `offset` converts them to those of the program, which change when
the program gives the axis another zero.

Invariants.
- A sample does not depend on where a block begins or ends, nor on the readings and their times.
- All events found up to `scanned` have happened. `_next_check` is the sample at which the search continues.
- The present sample and those before it never change.
- The simulation assumes that the axis rests at the end of a move, so that rest drops no samples.
- A future time is exact, or, if the block does not show it, the time at which to check again.

Cost. Nothing is computed before the first command that moves the motor; then the samples since power-up are
computed at once. After a change the blocks are short and become longer, up to `LONG` seconds: frequent changes waste
little, and undisturbed motion has little overhead. Standstill is detected by the long blocks, whose ends depend on the
time of the change alone. A change drops the rest of a block and repeats its samples up to the present one, from the
servo as it was before the block. A motor that has come to a standstill for good (`StandstillDetector`) costs nothing
until something affects it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY, TimedCall
from motionlang.kernel.controller.faults import FOLLOWING_ERROR
from motionlang.kernel.controller.queue.stop import freeze
from motionlang.kernel.controller.queue.track import extend_track
from motionlang.kernel.controller.watch import Watch, margin, watched_position
from motionlang.kernel.errors import Rejected
from motionlang.kernel.planners import hold
from motionlang.kernel.servo.axis_loop import Chosen, axis_loop
from motionlang.kernel.servo.gains import Gains
from motionlang.kernel.servo.loop import Loop
from motionlang.kernel.servo.replay import Change, apply, rests_until, run_to
from motionlang.kernel.servo.samples import (
    REST_ERROR,
    REST_TIME,
    SampleBlock,
    SettlingWindow,
    crossing,
    next_other_side,
    next_side,
    rests_as_seen,
)
from motionlang.kernel.servo.servo import Servo, sample_at
from motionlang.kernel.servo.settings import make_plant
from motionlang.kernel.servo.standstill import StandstillDetector, extent, is_still

Section = Mapping[str, object]

# The longest block, seconds, and the sizes of the first ones after a change.
LONG = 0.5
FIRST = (64, 192)
_NEVER = 1 << 62
# Counts: a smaller error is rounding.
_ROUNDING = 1e-9


class Feedback:
    """The simulated motor of one axis and its servo loop.

    `model` is one of `gains.MODELS` if the program's gains are MCCL's. `plant` and `section` are the machine
    file's `[axis.N.plant]` and `[axis.N.servo]`; an invalid entry of the plant raises ValueError. `tripped` is
    called if the following error exceeds `error_limit` (counts).
    """

    # The attributes that `cut` restores.
    GROWING = ("changes",)

    def __init__(self, axis: Axis, plant: Section, section: Section) -> None:
        self._axis, self._clock = axis, axis.clock
        self.plant, self.section, self.model = make_plant(plant), dict(section), ""
        self.error_limit = INFINITY
        self.tripped: Callable[[], None] = lambda: None
        self.closed = True
        self.demand_shift = 0.0  # total distance by which the demand was moved to the motor, counts
        # The changes to the loop since `origin`, by time, as a replay needs them.
        self.changes: list[Change] = []
        self.chosen: Chosen | None = None
        self.windows = {
            "rest": SettlingWindow(error=REST_ERROR, hold=REST_TIME, announced=False),
            "program": SettlingWindow(error=0.5, announced=False),
        }
        self._gains: Gains = {}
        # The servo with which a replay begins, and the one with which it will begin once older history is dropped; the
        # numbers of changes and profiles that there were then.
        self._origin: Servo | None = None
        self._next_origin: Servo | None = None
        self._past = 0, 0
        # The servo after the last sample computed, and as it was before the last block.
        self._servo: Servo | None = None
        self._before: Servo | None = None
        self._samples: SampleBlock | None = None
        # The sizes of the blocks after a change, of which the last repeats, and the number of the next one.
        self._sizes: tuple[int, ...] = ()
        self._block = 0
        # The event of the next check, and its sample.
        self._event: TimedCall | None = None
        self._next_check = _NEVER
        self._standstill = StandstillDetector()
        # The last sample that was searched for events, which have all run.
        self.scanned = 0

    # ----------------------------------------------------------------------------------------------- readings

    @property
    def position(self) -> float:
        """Measured position, counts, from the program's zero."""
        if self._servo is None:
            return self._axis.position(self._clock.now)
        k = self._here()
        assert self._samples is not None
        return float(self._samples.encoder[k]) - self._servo.offset

    def known_position(self, time: float) -> float | None:
        """Return the measured position at a time, counts, if it has been computed already."""
        samples = self._samples
        if self._servo is None or samples is None:
            return None
        number = sample_at(time, self._rate)
        if not samples.first <= number < samples.end:
            return None
        return float(samples.encoder[number - samples.first]) - self._servo.offset

    @property
    def velocity(self) -> float:
        """Velocity of the motor, counts/s."""
        return self._read("velocity")

    @property
    def error(self) -> float:
        """Following error: commanded minus measured position, counts."""
        error = self._read("error")
        return error if abs(error) > _ROUNDING else 0.0

    @property
    def output(self) -> float:
        """The controller's output, volts."""
        return self._read("output")

    @property
    def current(self) -> float:
        """Motor current, A."""
        return self._read("current")

    def _read(self, column: str) -> float:
        if self._servo is None:
            return 0.0
        k = self._here()
        return float(getattr(self._samples, column)[k])

    # ---------------------------------------------------------------------------------------- predictions

    def crossing_time(self, position: float) -> float:
        """Return when the motor reaches a position, counts.

        If the samples computed so far do not show that, return when to check again; inf if never.
        """
        if self._servo is None:
            return INFINITY
        k, samples = self._ahead()
        return self._sample_time(samples, k, crossing(samples.encoder[k:], position + self._servo.offset))

    def error_crossing_time(self, error: float) -> float:
        """Return when the following error reaches `error`, counts.

        A sample so close to `error` that rounding decides which is larger counts as well.
        """
        if self._servo is None:
            return INFINITY
        k, samples = self._ahead()
        return self._sample_time(samples, k, next_other_side(samples.error[k:], error))

    def _sample_time(self, samples: SampleBlock, k: int, found: int | None) -> float:
        return self._horizon(samples) if found is None else (samples.first + k + found) / self._rate

    def settled_time(self, name: str = "rest") -> float:
        """Return when the motor has been within a window for long enough; now if it has.

        If the samples computed so far do not show that, return when to check again; inf if never.
        """
        if self._servo is None:
            return self._clock.now
        k, samples = self._ahead()
        found = self.windows[name].settled(samples, self._target, samples.first + k, self._rate)
        if found < INFINITY:
            return max(found / self._rate, self._clock.now) if found > samples.first + k else self._clock.now
        return self._horizon(samples)

    @property
    def at_standstill(self) -> bool:
        """True if the motor is at rest and stays there unless something affects it."""
        return self._standstill.at_standstill

    @property
    def resting(self) -> bool:
        """True if the motor is settled, at standstill elsewhere, or not under control."""
        if self._servo is None or not self.closed or self.at_standstill:
            return True
        return self.settled_time() <= self._clock.now

    def _horizon(self, samples: SampleBlock) -> float:
        return INFINITY if self.at_standstill else max((samples.end - 1) / self._rate, self._clock.now)

    # -------------------------------------------------------------------------------------- commands

    def tune(self, gains: Gains) -> None:
        """Set the program's gains; raise Rejected if they are invalid."""
        self._gains = dict(gains)
        if self._servo is None:
            return
        before = self.chosen
        chosen = self._choose()
        assert before is not None
        if chosen.loop == before.loop:
            return
        try:
            self._do(chosen.loop)
        except ValueError as problem:
            raise Rejected("range", f"axis {self._axis.index}: {problem}") from None
        self.chosen = chosen

    def open(self, volts: float) -> None:
        """Open the loop and set a constant output, volts."""
        if not self.closed and self.changes and self.changes[-1][1] == volts:
            return
        self.closed = False
        if volts:
            self._wake()
        self._do(float(volts))

    def take_over(self) -> None:
        """Close an open loop; the motor's position becomes target and commanded position."""
        if self.closed:
            return
        axis, here = self._axis, self.position
        freeze(axis, "cancel")
        self.demand_shift += here - axis.position(self._clock.now)
        axis.target = here
        extend_track(axis, hold(here))
        self.closed = True
        self._do(len(axis.starts) - 1)

    def changed(self) -> None:
        """Handle a new profile of the axis."""
        if self._servo is None:
            if self._axis.profiles[-1].shape == "hold":
                return
            self._wake()
        meet = self.search_again if rests_as_seen(self._axis) else self._forget
        meet()
        for watch in self._axis.watches:
            self._take_side(watch)

    def settle_within(self, error: float, speed: float, hold: float, at_target: bool = False) -> None:
        """Set the window in which the motor counts as settled for the program."""
        window = SettlingWindow(error, speed, hold, at_target)
        if window.same(self.windows.get("program")):
            return
        self.windows["program"] = window
        if self._servo is not None:
            assert self._samples is not None
            self.search_again()
            self._samples.keep(self.scanned, self._samples.end)

    def set_error_limit(self, limit: float) -> None:
        """Set the following error, counts, at which the axis trips; inf for none."""
        self.error_limit = limit
        self.search_again()

    def search_again(self) -> None:
        """Search the samples again after a change of a limit or watch, or a cleared fault."""
        if self._servo is None:
            return
        now = self._now
        next_check, self._next_check = self._next_check, _NEVER
        if self.scanned < next_check <= now:  # time passed it in one step
            self._happen(next_check)
        self.scanned = max(self.scanned, now)
        self._standstill.disturb()
        self._await(now)

    def arm(self, watch: Watch) -> None:
        """Begin to watch a position."""
        self._take_side(watch)
        self.search_again()

    def _take_side(self, watch: Watch) -> None:
        off = self.position - watched_position(self._axis, watch)
        if abs(off) > margin(off):
            watch.side = 1 if off > 0.0 else -1

    def _do(self, what: Loop | float | int) -> None:
        if self._servo is not None:
            self._forget()
            apply(self._servo, (self._clock.now, what))
        self.changes.append((self._clock.now, what))

    # ------------------------------------------------------------------------------------------------ history

    def origin(self) -> Servo:
        """Return a servo for a replay: as it was at power-up, or when older history was dropped."""
        assert self._origin is not None
        return self._origin.replayed()

    def forget(self, retained: int) -> int:
        """Return how many of the oldest profiles no replay needs any more, and drop the changes of their time.

        After `retained` profiles the servo of the present moment is stored. It is the origin of replays after
        `retained` further ones.
        """
        profiles = len(self._axis.starts)
        if self._servo is None or profiles - self._past[1] < retained:
            return 0
        self._forget()
        origin, (changes, _) = self._next_origin, self._past
        self._next_origin, self._past = self._servo.replayed(), (len(self.changes), profiles)
        if origin is None:
            return 0
        self._origin = origin
        count = max(origin.in_force_at(origin.time) - 1, 0)
        for servo in (origin, self._next_origin, self._servo):
            servo.drop(count)
        self.changes = [
            (time, what - count if isinstance(what, int) else what) for time, what in self.changes[changes:]
        ]
        self._past = len(self.changes), profiles - count
        return count

    def extent(self) -> int:
        """Return what `cut` needs to drop all changes that are added from now on."""
        return len(self.changes)

    def cut(self, extent: int) -> None:
        """Drop the changes since `extent` was taken."""
        del self.changes[extent:]

    # ------------------------------------------------------------------------------------------------- inside

    @property
    def _rate(self) -> float:
        assert self._servo is not None
        return self._servo.loop.servo_rate

    @property
    def _target(self) -> float:
        assert self._servo is not None
        return self._axis.target + self._servo.offset

    @property
    def _now(self) -> int:
        return sample_at(self._clock.now, self._rate)

    def _choose(self) -> Chosen:
        try:
            return axis_loop(self.section, self._gains, self.plant, self.model, self._axis.scale.counts)
        except ValueError as problem:
            raise Rejected("range", f"the servo of axis {self._axis.index}: {problem}") from None

    def _wake(self) -> None:
        """Start the servo and simulate it since power-up, with the present gains."""
        if self._servo is not None:
            return
        self.chosen = self._choose()
        servo = Servo(self.chosen.loop, self.plant, self._axis)
        self._servo, self._origin = servo, servo.replayed()
        last = None
        for change in self.changes:
            last = run_to(servo, sample_at(change[0], self._rate)) or last
            apply(servo, change)
        last = run_to(servo, self._now) or last
        assert last is not None
        self._sizes = _sizes(max(round(LONG * self._rate), 1))
        self._samples = SampleBlock(servo.sample - len(last), last.columns)
        self._samples.keep(self._now, servo.sample)
        self.scanned = self._now

    def _here(self) -> int:
        """Return the index of the present sample in `_samples`."""
        assert self._samples is not None
        samples, now = self._samples, self._now
        while now >= samples.end:
            self._extend(now)
        return max(now - samples.first, 0)

    def _ahead(self) -> tuple[int, SampleBlock]:
        """Return the index of the present sample, and the samples with some after it.

        There may be none after it if the motor is at standstill for good.
        """
        assert self._samples is not None
        k, samples = self._here(), self._samples
        if k + 1 >= len(samples) and not self.at_standstill:
            self._extend(samples.first + k)
            k = self._here()
        return k, samples

    def _extend(self, now: int) -> None:
        """Compute one more block; drop past samples that have been searched."""
        servo, samples = self._servo, self._samples
        assert servo is not None
        assert samples is not None
        if self._next_check > now:
            self.scanned = max(self.scanned, min(now, samples.end - 1))
        first = min(self.scanned, samples.end - 1)
        for window in self.windows.values():
            window.pass_by(samples, self._target, first + 1)
        samples.keep(first, samples.end)
        self._before = servo.copy()
        samples.extend(servo.run(self._sizes[self._block]).columns)
        if self._block + 1 < len(self._sizes):
            self._block += 1
        else:
            self._check_standstill(samples, now)

    def _check_standstill(self, samples: SampleBlock, now: int) -> None:
        """Decide whether the motor is at standstill for good.

        It is if its commanded position rests and the last block reached no new state.
        """
        servo, before, was_at_standstill = self._servo, self._before, self.at_standstill
        assert servo is not None
        assert before is not None
        long = self._sizes[-1]
        reach = extent(samples.encoder[-long:], samples.output[-long:])
        rests = rests_until(servo, long, servo.sample) == servo.sample
        self._standstill.check(reach if rests else None, LONG)
        if self.at_standstill and now > servo.sample and is_still(reach, before.state, servo.state):
            samples.keep(samples.end - 1, samples.end)
            samples.first = now - 1
            servo.skip(now - servo.sample)
        if was_at_standstill and not self.at_standstill:
            self._await(now)

    def _forget(self) -> None:
        """Drop the samples after the present one, which are now invalid."""
        samples = self._samples
        assert samples is not None
        here = self._here()  # may drop past samples, so that `_samples` begins later
        until = samples.first + here + 1
        if until < samples.end:
            assert self._before is not None
            self._servo = self._before
            self._servo.advance((until - 1) / self._rate)
            samples.keep(samples.first, until)
        self._block = 0
        self.search_again()

    # ------------------------------------------------------------------------------------------------- events

    def _await(self, sample: int) -> None:
        """Schedule a check at a sample, unless an earlier one is due."""
        if self._event is not None:
            if self._next_check <= sample:
                return
            self._event.cancel()
        self._next_check = sample
        self._event = self._clock.at(max(sample / self._rate, self._clock.now), self._run_check)

    def _run_check(self) -> None:
        """Run the events that are due, and schedule the next one."""
        self._event, self._next_check = None, _NEVER
        while self._event is None:
            sample = self._next_at_end()
            _, samples = self._ahead()
            if sample is None:
                sample = self._next(samples)
            if sample is None and not self.at_standstill:
                self._await(samples.end - 1)
            if sample is None:
                return
            if sample > self._now:
                self._await(sample)
            else:
                self._happen(sample)

    def _next_at_end(self) -> int | None:
        """Return the present sample if it is the last of its block and has an event.

        A search of the next block would miss it, because that begins after it.
        """
        now, k, samples = self._now, self._here(), self._samples
        assert samples is not None
        return now if k + 1 == len(samples) and self._next(samples) == now else None

    def _next(self, samples: SampleBlock) -> int | None:
        assert self._servo is not None
        found = [sample for _, sample, _ in self._passes(samples) if sample is not None]
        lo = self.scanned + 1 - samples.first
        if self._is_armed:
            beyond = np.flatnonzero(np.abs(samples.error[lo:]) > self.error_limit)
            found += [samples.first + lo + int(k) for k in beyond[:1]]
        for window in self.windows.values():
            if window.announced:
                onsets = window.onsets(samples, self._target, self._rate)
                found += [sample for sample, _ in onsets if self.scanned < sample < samples.end][:1]
        return min(found, default=None)

    def _passes(self, samples: SampleBlock) -> list[tuple[Watch, int | None, int]]:
        """Return the next sample past each watched position (or None), and the side then."""
        assert self._servo is not None
        found = []
        seen = samples.encoder[self.scanned - samples.first :]
        for watch in self._axis.watches:
            k, side = next_side(seen, watched_position(self._axis, watch) + self._servo.offset, watch.side)
            found.append((watch, None if k is None else self.scanned + k, side))
        return found

    @property
    def _is_armed(self) -> bool:
        return self.closed and self.error_limit < INFINITY and not self._axis.faults & FOLLOWING_ERROR

    def _happen(self, sample: int) -> None:
        """Run the events of a sample: positions passed, excessive following error."""
        samples = self._samples
        assert samples is not None
        passed = [(watch, side) for watch, at, side in self._passes(samples) if at == sample]
        trips = self._is_armed and abs(samples.error[sample - samples.first]) > self.error_limit
        self.scanned = sample
        for watch, side in passed:
            before, watch.side = watch.side, side
            if before and watch in self._axis.watches:
                watch.call(side)
        if trips and self._is_armed:
            self.tripped()


def _sizes(longest: int) -> tuple[int, ...]:
    """Return the sizes of the blocks after a change, up to the longest, which repeats."""
    sizes = list(FIRST)
    size = 4 * sum(sizes)
    while size < longest:
        sizes.append(size)
        size *= 4
    return (*sizes, longest)
