"""Following a master: gearing, and the basis of cams and flying shears.

Problem. A slave follows an axis or an encoder, at a ratio or on a curve over the master's position. The
master may be a slave itself, and may change its motion at any time. An OFFSET may add a motion of its own on
top.

Idea. Nothing is sampled. The master's motion is a profile, so the slave's is known exactly: the master's
times the ratio, or the curve at the master's position. Each new profile of the master calls its slaves, and
each computes its own profile from that time on (`renew`). An offset is a profile as well, and is added.

    master's profile ── × ratio, or curve(master) ──▶ base ──┐
                                                             + ──▶ slave's profile ──▶ its own slaves
    offset's profile ────────────────────────────────────────┘

A gear with a `ramp` first ramps linearly, at the slave's own rates, until its velocity equals ratio × master's
velocity (`_chased`). `locked` is the time at which it does.

Data. `Follow` ties a slave to its master. It is the action of the slave's move in progress. `Gear` and the
cams and shears of `cam.py` are its subclasses. Each defines in `base` how the slave moves for the master's
future motion, `coming`. `FollowMove` is the slave's entry in the log. It stores the profiles that the slave has
followed, and joins them when it is read.

A suspended gear ramps to rest, and its offset with it. The rest of that offset waits in `paused`; offsets
commanded meanwhile wait in the buffer. A cam or a shear cannot be suspended. An input that would suspend it
holds its axis once the cam or shear is over, and delays new offsets until the input is released.

Invariants.
- The base of a gear begins at the slave's position, less the part of the offset already done, so no position
  jumps. A curve is always read at the master's position.
- One offset is in progress at a time. A new one adds the remaining distance of the one before; the distance
  already done becomes part of the base (`fold`).
- No axis follows itself, directly or through others (`check_chain`).
- `renew` acts only while the tie is in force (`tied`). A stop replaces the tie and keeps the move.
- A slave that leaves its master completes the profile in force (`leave_master`).

Cost. One profile for each new profile of the master, for each slave along a chain. An entry of the log with
more than `MAX_FOLLOWED` profiles continues as a further entry. The cycles of a cam share its curve, so a
cycle takes as much memory as any other profile; a cycle with a changed table counts as many.
"""

from __future__ import annotations

from itertools import pairwise

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.motion.profile_playback import Playback
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.controller.queue.buffer import take
from motionlang.kernel.controller.queue.life import append_profile, go_on
from motionlang.kernel.controller.queue.plan import plan_distance, rates, to_rest, with_standstill
from motionlang.kernel.controller.queue.stop import give_up
from motionlang.kernel.controller.queue.track import end_move, extend_track, log_move
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.log import Log
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile, hold, plan_velocity
from motionlang.kernel.planners.curve import relabelled
from motionlang.kernel.planners.dwell import rest, with_rest
from motionlang.kernel.planners.sequence import ProfileSequence
from motionlang.kernel.planners.superposition import added

# A smaller difference of velocities, counts/s, counts as zero.
_STILL = 1e-9
# Profiles of a slave after which its move continues as a new entry of the log: ten seconds at one per
# millisecond.
MAX_FOLLOWED = 10_000


class FollowMove(LoggedMove):
    """The log entry of a slave, whose profile is joined from its history on demand."""

    __slots__ = ("segments", "shape", "size")
    follows = True

    def __init__(self, axis: int, command: str, line: int, shape: str, target: float = INFINITY) -> None:
        self.segments: list[tuple[float, Profile]] = []
        self.shape = shape
        self.size = 0  # the number of profiles; a long curve counts as several
        super().__init__(axis, command, line, target)

    def add(self, time: float, profile: Profile) -> None:
        """Append `profile`, which begins at `time`."""
        if self.segments and self.segments[-1][0] == time:
            self.segments.pop()
        self.segments.append((time, profile.shifted(-self.offset) if self.offset else profile))
        self.size += 1

    def begin_new_entry(self, log: Log, now: float) -> None:
        """Split the log entry if it has become long: this one continues as a new entry."""
        if self.size > MAX_FOLLOWED and self.profile is not None:
            log.moves.split(self, self.until(now), now)
            self.segments, self.size = [], 0

    @property
    def profile(self) -> Profile | None:
        """All profiles of the entry, joined in sequence."""
        return self._sequence(self.segments) if self.segments else None

    @profile.setter
    def profile(self, profile: Profile | None) -> None:
        self.segments = [] if profile is None else [(self.start_time, profile)]

    def until(self, time: float) -> Profile:
        # A profile that begins at `time` has not moved the axis, although rounding may leave a moment of it.
        is_late = len(self.segments) > 1 and self.segments[-1][0] >= time
        begun = self.segments[:-1] if is_late else self.segments
        return self._sequence(begun).cut(time - self.start_time)

    def _sequence(self, segments: list[tuple[float, Profile]]) -> Profile:
        cuts = [profile.cut(finish - start) for (start, profile), (finish, _) in pairwise(segments)]
        return ProfileSequence(self.shape, [*cuts, segments[-1][1]])


class Follow(Action):
    """A slave's tie to its master, an axis or encoder; `base` defines the relation."""

    __slots__ = ("a", "master", "move", "offset", "offset_began", "offset_entry", "offset_limits", "paused")

    def __init__(self, a: Axis, master: Axis, move: FollowMove) -> None:
        self.a, self.master, self.move = a, master, move
        # The offset in progress, from 0 to its distance, and its start time.
        self.offset: Profile | None = None
        self.offset_began = 0.0
        self.offset_entry: LoggedMove | None = None  # its log entry
        # The distance that it leaves out, as it comes to rest with a suspended slave.
        self.paused = 0.0
        # Speed and rates that OFFSETMODE gave it; None for those of the axis.
        self.offset_limits: tuple[float, float, float] | None = None
        move.action = self

    keeps_rates = False

    # -- defined by a subclass

    def base(self, coming: Profile, position: float) -> Profile:
        """Return the slave's motion from `position` on for the master's motion `coming`."""
        raise NotImplementedError

    def arm(self, coming: Profile) -> None:
        """Schedule the events of the tie itself."""

    def disarm(self) -> None:
        """Cancel the events that `arm` scheduled."""

    # -- the tie

    def engage(self) -> None:
        """Start to follow; the axis's previous motion has been left."""
        log_move(self.a, self.move, rest(self.move.shape, self._here(), 0.0))
        if self.a.arrival is not None:
            self.a.arrival.cancel()
            self.a.arrival = None
        self.move.segments.clear()
        self.master.followers.append(self._master_changed)
        self.renew(f"{self.move.command} at once")
        self.more(self.a)

    def renew(self, cause: str = "") -> None:
        """Plan the slave's motion again from now on; `cause` is of a jump of its velocity."""
        if not self.tied:
            return
        self.disarm()
        coming = self.coming()
        profile = self._with_offset(coming)
        now = self.a.clock.now
        self.move.begin_new_entry(self.a.controller.log, now)
        self.move.add(now, profile)
        extend_track(self.a, profile, cause)
        if self.tied:
            self.arm(coming)

    @property
    def tied(self) -> bool:
        """True while the tie is in force; a slave that stops has only the move left."""
        return self.a.move is self.move and self.move.action is self

    def coming(self) -> Profile:
        """Return the master's motion from now on."""
        return self.master.profiles[-1].after(self.a.clock.now - self.master.starts[-1])

    def detach(self) -> None:
        """End the tie; the slave's profile stays until another motion replaces it."""
        self.disarm()
        if self._master_changed in self.master.followers:
            self.master.followers.remove(self._master_changed)

    @property
    def resting(self) -> bool:
        """True if the slave is at rest until its master moves."""
        return self.a.profiles[-1].end == self.a.profiles[-1].start and not self.a.profiles[-1].peak_speed

    def leave(self, a: Axis, ended: str) -> None:
        self.end_offset(ended)
        self.detach()

    def replan(self, a: Axis) -> None:
        self.renew()

    def suspend(self, a: Axis) -> bool:
        raise Rejected(
            "moving",
            f"axis {a.index} follows axis {self.master.index} and cannot be suspended",
            "suspend the master, or stop the slave",
        )

    def more(self, a: Axis) -> None:
        """Start released offsets during following, one after the other."""
        while a.buffer and tie_of(a) is self and self.offset is None and not a.suspended:
            move = next((m for m in a.buffer if m.released and m.action and m.action.lies_on_top), None)
            if move is None:
                return
            action = move.action
            assert action is not None
            take(a, a.buffer.index(move))
            try:
                action.begin_on_top(a, move)
            except Rejected as rejected:
                rejected.line = rejected.line or move.line
                raise

    def start_offset(self, profile: Profile, entry: LoggedMove | None = None) -> None:
        """Superpose an offset, whose profile begins at 0; it replaces the one in progress."""
        now = self.a.clock.now
        if self.offset is not None:
            self.fold(self.offset.position(now - self.offset_began))
            self.end_offset("retarget")
        self.carry(profile, now, entry)
        self.renew()

    def end_offset(self, ended: str) -> None:
        """Close the log entry of an offset that ends early."""
        entry, self.offset_entry = self.offset_entry, None
        if entry is not None and entry.profile is not None:
            entry.profile = entry.until(self.a.clock.now)
            entry.ended = ended

    def carry(self, profile: Profile, began: float, entry: LoggedMove | None) -> None:
        """Superpose an offset that began at the time `began`, and schedule its end."""
        self.offset, self.offset_began, self.offset_entry = profile, began, entry
        self.a.clock.at(began + profile.duration, lambda: self._offset_done(profile))

    def fold(self, distance: float) -> None:
        """Add a distance that an offset has covered to the base."""

    def offset_left(self) -> tuple[float, float]:
        """Return the remaining distance of the offset in progress, and its velocity."""
        if self.offset is None:
            return 0.0, 0.0
        elapsed = self.a.clock.now - self.offset_began
        return self.paused + self.offset.end - self.offset.position(elapsed), self.offset.velocity(elapsed)

    # -- inside

    def _master_changed(self, _: Profile) -> None:
        self._renew_or_rest("a jump of its master")

    def _renew_or_rest(self, cause: str = "") -> None:
        """Renew the slave's motion, or come to rest with a run-time fault."""
        try:
            self.renew(cause)
        except Rejected as rejected:
            give_up(self.a, rejected)

    def _start_waiting(self) -> None:
        """Start released offsets like `more`; each rejected one is a run-time fault."""
        while True:
            try:
                self.more(self.a)
                return
            except Rejected as rejected:
                self.a.controller.run_time_fault(rejected)

    def _here(self) -> float:
        return self.a.position(self.a.clock.now)

    def _with_offset(self, coming: Profile) -> Profile:
        here, offset = self._here(), self.offset
        if offset is None or offset.duration == INFINITY:  # a suspended slave comes to rest with its offset
            return self.base(coming, here)
        left = offset.after(self.a.clock.now - self.offset_began)
        return added(self.base(coming, here - left.start), left, self.move.shape)

    def _offset_done(self, profile: Profile) -> None:
        if self.offset is not profile:
            return
        self.offset = self.offset_entry = None
        if self.tied:
            self.fold(profile.end)
            self._renew_or_rest()
            self._start_waiting()


class _Leaving(Playback):
    """The rest of the motion of a slave that has left its master, with its offset."""

    __slots__ = ("_tie",)

    def __init__(self, tie: Follow) -> None:
        super().__init__()
        self._tie = tie

    def suspend(self, a: Axis) -> bool:
        super().suspend(a)
        self._tie.end_offset("stop")
        return True

    def leave(self, a: Axis, ended: str) -> None:
        self._tie.end_offset(ended)


def tie_of(a: Axis) -> Follow | None:
    """Return the tie of an axis to its master, None if it follows none."""
    action = a.move.action if a.move is not None else None
    return action if isinstance(action, Follow) else None


class Gear(Follow):
    """Following at `ratio` times the master's motion.

    With `ramp` the slave first ramps to that velocity at its own rates.
    """

    __slots__ = ("_chased_at", "_locks_at", "keeps_rates", "ramp", "ratio")

    def __init__(self, a: Axis, master: Axis, move: FollowMove, ratio: float, ramp: bool) -> None:
        super().__init__(a, master, move)
        self.ratio, self.ramp = ratio, ramp
        # The time at which the slave has the velocity of the ratio.
        self._locks_at = INFINITY if ramp else 0.0
        # True once a suspension has planned its rest, at its own rates.
        self.keeps_rates = False
        # The rates of the ramp to that velocity.
        self._chased_at = (0.0, 0.0)

    @property
    def locked(self) -> float:
        """The time at which the slave reaches the velocity that the ratio requires."""
        return self._locks_at

    def set_ratio(self, ratio: float, ramp: bool) -> None:
        """Set another ratio from now on; setting the present one is a no-op."""
        if ratio == self.ratio and ramp == self.ramp:
            locked = self._locks_at <= self.a.clock.now
            if locked or self._chased_at == rates(self.a, self.a.speed):
                return
        self.ratio, self.ramp = ratio, ramp
        self._locks_at = INFINITY if ramp else 0.0
        self.renew("a new ratio")

    def renew(self, cause: str = "") -> None:
        # A suspended slave comes to rest whatever its master does.
        if not (self.a.suspended and self.keeps_rates):
            super().renew(cause)

    def suspend(self, a: Axis) -> bool:
        self.keeps_rates = False
        self._pause_offset()
        self.renew()
        return True

    def resume(self, a: Axis) -> None:
        """Ramp to the ratio again and complete the offset; then start the waiting offsets."""
        self._locks_at = INFINITY
        left, velocity = self.offset_left()  # it may not be at rest yet
        self.offset, self.paused = None, 0.0
        if left or velocity:
            self._complete_offset(left, velocity)
        self.renew()
        self.more(a)

    def _pause_offset(self) -> None:
        """Ramp the offset down together with the slave; the rest of it waits."""
        left, velocity = self.offset_left()
        if self.offset is None:
            return
        stop = to_rest(self.a)
        share = velocity / stop.start_velocity if stop.start_velocity else 0.0
        done = with_rest(stop.scaled(self.offset.end - left, share))
        self._log_offset(done)
        self.offset, self.offset_began, self.paused = done, self.a.clock.now, left - done.distance

    def _complete_offset(self, left: float, velocity: float) -> None:
        """Superpose the rest of a suspended offset, or drop it with a run-time fault."""
        a, entry = self.a, self.offset_entry
        try:
            limits = self.offset_limits or (a.speed, *rates(a, a.speed))
            profile = plan_distance(a, a.shape, 0.0, left, limits, a.jerks(a.speed, *limits[1:]), velocity)
        except Rejected as rejected:
            self.end_offset("stop")
            rejected.line = rejected.line or (self.move if entry is None else entry).line
            a.controller.run_time_fault_later(rejected)
            return
        self._log_offset(profile)
        self.carry(profile, a.clock.now, entry)

    def _log_offset(self, profile: Profile) -> None:
        entry = self.offset_entry
        if entry is None or entry.profile is None:
            return
        before = entry.until(self.a.clock.now)
        entry.profile = before.then(profile.scaled(before.end, 1.0))

    def base(self, coming: Profile, position: float) -> Profile:
        """Return the geared motion, or the ramp to rest of a suspended slave."""
        if self.a.suspended:
            rest_of = with_standstill(self.a)
            self.keeps_rates = True
            return rest_of
        self.keeps_rates = False
        if self._locks_at > self.a.clock.now:
            return self._chased(coming, position)
        return self._geared(coming, position)

    def _geared(self, coming: Profile, position: float) -> Profile:
        if coming.shape == "hold" or not self.ratio:
            return rest(self.move.shape, position, INFINITY)
        return relabelled(coming.scaled(position, self.ratio), self.move.shape)

    def _chased(self, coming: Profile, position: float) -> Profile:
        """Return a linear ramp to the velocity that the ratio requires, then gearing."""
        now = self.a.clock.now
        wanted = coming.scaled(0.0, self.ratio)
        have = self.a.velocity(now) - self.offset_left()[1]
        want = wanted.velocity(0.0)
        accel, decel = self._chased_at = rates(self.a, self.a.speed)
        if abs(want - have) <= _STILL * (1.0 + abs(want)):
            self._locks_at = now
            return self._geared(coming, position)
        sign = 1.0 if want > have else -1.0
        chase = _ramp(position, have, sign, accel, decel)
        gap = added(wanted, chase.scaled(0.0, -1.0), "gap")
        # The velocity of a master may also jump past that of its slave, at a knot.
        found = [knot for knot in gap.knots[1:-1] if gap.velocity(knot) * sign < 0.0]
        meets = min((time for time in (gap.velocity_crossing(0.0), *found) if time is not None), default=None)
        if meets is None:
            words = f"axis {self.a.index} cannot ramp to {want:.10g} counts/s, the speed of its master"
            raise Rejected("range", words, "raise its rates, or lower the ratio")
        self._locks_at = now + meets
        head = chase.cut(meets)
        return relabelled(head.then(self._geared(coming.after(meets), head.end)), self.move.shape)


def _ramp(position: float, velocity: float, sign: float, accel: float, decel: float) -> Profile:
    """Return an endless acceleration in the direction `sign`.

    Opposite motion slows down to rest first.
    """
    far = plan_velocity("trapezoid", position, velocity, sign * (abs(velocity) + accel * 1e6), accel, decel)
    return far.cut(far.knots[-2] * 0.999)


def gear(a: Axis, master: Axis, ratio: float, ramp: bool, command: str, line: int) -> None:
    """Make an axis follow a master, or change its ratio.

    With `ramp` the slave first ramps to the velocity of the master times `ratio`.
    """
    begin_gear(a, master, ratio, ramp, command, line)
    a.controller.motion_listener.gears(a, ratio)


def begin_gear(a: Axis, master: Axis, ratio: float, ramp: bool, command: str, line: int) -> None:
    """Begin to follow, or change the ratio."""
    _check_ratio(ratio)
    tie = tie_of(a)
    if isinstance(tie, Gear) and tie.master is master:
        tie.set_ratio(ratio, ramp)
        return
    check_chain(a, master)
    if ramp:
        rates(a, a.speed)
    move = FollowMove(a.index, command, line, "gear")
    end_move(a, "retarget")
    Gear(a, master, move, ratio, ramp).engage()


def set_ratio(a: Axis, ratio: float) -> None:
    """Change the ratio of an axis that follows a master; a no-op for any other axis."""
    tie = tie_of(a)
    if isinstance(tie, Gear):
        _check_ratio(ratio)
        tie.set_ratio(ratio, False)
    a.controller.motion_listener.gears(a, ratio)


def _check_ratio(ratio: float) -> None:
    if not abs(ratio) < 1e12:
        raise Rejected("range", f"an axis cannot follow at a ratio of {ratio:.10g}")


def leave_master(a: Axis) -> None:
    """Stop following a master; the present profile continues to its end.

    An axis at rest becomes idle.
    """
    tie = tie_of(a)
    if tie is None:
        return
    now = a.clock.now
    if tie.resting:
        end_move(a, "")
        a.target = a.position(now)
        extend_track(a, hold(a.target))
        go_on(a)
        return
    if tie.offset is None or tie.offset.duration == INFINITY:
        tie.end_offset("")  # one that is suspended
    tie.detach()
    rest_of = a.profiles[-1].after(now - a.starts[-1])
    tie.move.action = _Leaving(tie)
    tie.move.add(now, rest_of)
    a.target = tie.move.target = rest_of.end
    append_profile(a, rest_of)


def follows(link: Axis | None, a: Axis) -> bool:
    """True if `link` is the axis `a`, or follows it, directly or through others."""
    while link is not None and link is not a:
        tie = tie_of(link)
        link = tie.master if tie is not None else None
    return link is a


def check_chain(a: Axis, master: Axis) -> None:
    """Reject a master that follows the slave itself."""
    if follows(master, a):
        raise Rejected("axis", f"axis {a.index} cannot follow axis {master.index}: it would follow itself")
