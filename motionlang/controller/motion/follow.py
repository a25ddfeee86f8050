"""Following a master: gearing, and the basis of cams and flying shears.

Problem. A slave follows an axis or an encoder, at a ratio or on a curve over the master's position. The master may be
a slave itself, and may change its motion at any moment. An OFFSET may add a motion of its own on top.

Idea. Nothing is sampled. The master's motion is a profile, so the slave's is known exactly: the master's times the
ratio, or the curve at the master's position. Each new profile of the master calls its slaves, and each computes its own
from that moment on (`renew`). An offset is a profile as well, and is added.

    master's profile ── × ratio, or curve(master) ──▶ base ──┐
                                                             + ──▶ slave's profile ──▶ its own slaves
    offset's profile ────────────────────────────────────────┘

A gear with a `ramp` first comes to its velocity at the slave's own rates: a straight ramp, up to the moment at which it
meets ratio × master's velocity (`_chased`). `locked` is that moment.

Data. `Follow` ties a slave to its master. It is the action of the slave's move in progress. `Gear` and the cams and
shears of `cam.py` are its subclasses. Each says in `base` what the slave does while the master does what is `coming`.
`FollowMove` is the slave's entry in the log. It stores the profiles that the slave has followed, and joins them when it
is read.

A suspended gear ramps to rest, and its offset with it. The rest of that offset waits in `_paused`, offsets that are
ordered meanwhile wait in `_later`. A cam or a shear cannot be suspended.

Invariants.
- The base of a gear begins at the slave's position, less the offset done so far, so no position jumps. A curve is
  always read at the master's position.
- One offset is in progress at a time. A new one adds what the one before has left; what that has done becomes part of
  the base (`fold`).
- No axis follows itself, directly or through others (`check_chain`).
- `renew` acts only while the tie is in force (`tied`). A stop replaces the tie and keeps the move.
- A slave that leaves its master completes the profile in force (`leave_master`).

Cost. One profile for each new profile of the master, for each slave along a chain. An entry of the log with more than
`MOST_PARTS` profiles continues as a further entry.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.controller.faults import Refusal
from motionlang.controller.motion import halt
from motionlang.controller.motion.profile_playback import Played
from motionlang.controller.move import Action, Move
from motionlang.planners import hold, plan, plan_velocity
from motionlang.planners.curve import relabelled
from motionlang.planners.dwell import halted, rest
from motionlang.planners.sequence import Chain
from motionlang.planners.superposition import added

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.axis import Axis
    from motionlang.controller.core import Core
    from motionlang.planners import Profile

# A difference of velocities, counts/s, that is none.
_STILL = 1e-9
# Profiles that a slave has followed after which its move goes on as another entry of the log: ten seconds of one a
# millisecond.
MOST_PARTS = 10_000


class FollowMove(Move):
    """The log entry of a slave: its profile is put together from all that it did when somebody asks."""

    __slots__ = ("parts", "shape")

    def __init__(self, axis: int, command: str, line: int, shape: str, target: float = INFINITY) -> None:
        self.parts: list[tuple[float, Profile]] = []
        self.shape = shape
        super().__init__(axis, command, line, target)

    def add(self, time: float, profile: Profile) -> None:
        """It follows `profile` from `time` on."""
        if self.parts and self.parts[-1][0] == time:
            self.parts.pop()
        self.parts.append((time, profile.shifted(-self.offset) if self.offset else profile))

    def begin_anew(self, controller: Core, now: float) -> None:
        """Be another entry of the log from now on, where this one has become long."""
        if len(self.parts) > MOST_PARTS and self.profile is not None:
            controller.log.moves.split(self, self.profile.cut(now - self.start_time), now)
            self.parts = []

    @property
    def profile(self) -> Profile | None:
        """Everything in a row."""
        if not self.parts:
            return None
        starts = [time for time, _ in self.parts]
        cuts = [
            profile.cut(finish - start)
            for (start, profile), finish in zip(self.parts, starts[1:], strict=False)
        ]
        return Chain(self.shape, [*cuts, self.parts[-1][1]], self.shape)

    @profile.setter
    def profile(self, profile: Profile | None) -> None:
        self.parts = [] if profile is None else [(self.start_time, profile)]


class Follow(Action):
    """A slave's tie to the axis, or the encoder, that it follows; a subclass says how in `base`."""

    __slots__ = ("_callback", "a", "controller", "master", "move", "offset", "offset_began", "offset_entry")

    def __init__(self, controller: Core, a: Axis, master: Axis, move: FollowMove) -> None:
        self.controller, self.a, self.master, self.move = controller, a, master, move
        # The offset under way, from 0 to its distance, and when it began.
        self.offset: Profile | None = None
        self.offset_began = 0.0
        self.offset_entry: Move | None = None  # that of the log
        self._callback = lambda _: self.renew()
        move.action = self

    keeps_rates = False

    # -- what a subclass says

    def base(self, coming: Profile, position: float) -> Profile:
        """What the slave does from `position` on while the master does what is `coming`."""
        raise NotImplementedError

    def arm(self, coming: Profile) -> None:
        """Set the events that the tie itself needs."""

    def disarm(self) -> None:
        """Cancel them."""

    # -- the tie

    def engage(self) -> None:
        """Take up the master's motion; the axis has been left by what it did before."""
        self.controller.log_move(self.a, self.move, rest(self.move.shape, self._here(), 0.0))
        if self.a.arrival is not None:
            self.a.arrival.cancel()
            self.a.arrival = None
        self.move.parts.clear()
        self.master.followers.append(self._callback)
        self.renew()
        self.more(self.controller, self.a)

    def renew(self) -> None:
        """Work the slave's motion out anew from now on."""
        if not self.tied:
            return
        self.disarm()
        coming = self.coming()
        profile = self._with_offset(coming)
        now = self.controller.clock.now
        self.move.begin_anew(self.controller, now)
        self.move.add(now, profile)
        self.controller.extend_track(self.a, profile)
        if self.tied:
            self.arm(coming)

    @property
    def tied(self) -> bool:
        """Whether the tie still holds: a slave that is stopping has the same move, but not this tie."""
        return self.a.move is self.move and self.move.action is self

    def coming(self) -> Profile:
        """What the master does from now on."""
        return self.master.profiles[-1].after(self.controller.clock.now - self.master.starts[-1])

    def detach(self) -> None:
        """Cut the tie; the slave's profile stays as it is until something else is said."""
        self.disarm()
        if self._callback in self.master.followers:
            self.master.followers.remove(self._callback)

    @property
    def resting(self) -> bool:
        """Whether the slave stands still, and will unless its master moves."""
        return self.a.profiles[-1].end == self.a.profiles[-1].start and not self.a.profiles[-1].peak_speed

    def leave(self, controller: Core, a: Axis, ended: str) -> None:
        self.end_offset(ended)
        self.detach()

    def replan(self, controller: Core, a: Axis) -> None:
        self.renew()

    def suspend(self, controller: Core, a: Axis) -> bool:
        raise Refusal(
            "moving",
            f"axis {a.index} follows axis {self.master.index} and cannot be suspended",
            "suspend the master, or stop the slave",
        )

    def more(self, controller: Core, a: Axis) -> None:
        """Entries that lie on top begin while the axis goes on following, each when the one before it is done."""
        while a.buffer and tie_of(a) is self and self.offset is None and not a.suspended:
            move = next((m for m in a.buffer if m.released and m.action and m.action.lies_on_top), None)
            if move is None:
                return
            action = move.action
            assert action is not None
            controller.take_entry(a, a.buffer.index(move))
            action.begin_on_top(controller, a, move)

    def put_off(self, begin: Callable[[], None]) -> bool:
        """Whether an offset has to wait, and will `begin` later: what cannot be suspended knows no wait."""
        return False

    def start_offset(self, profile: Profile, entry: Move | None = None) -> None:
        """Lay an offset, which begins at 0, on top from now on; it takes the place of one under way."""
        now = self.controller.clock.now
        if self.offset is not None:
            self.fold(self.offset.position(now - self.offset_began))
            self.end_offset("retarget")
        self.carry(profile, now, entry)
        self.renew()

    def end_offset(self, ended: str) -> None:
        """Close the log entry of an offset that does not come to its end."""
        entry, self.offset_entry = self.offset_entry, None
        if entry is not None and entry.profile is not None:
            entry.profile = entry.profile.cut(self.controller.clock.now - entry.start_time)
            entry.ended = ended

    def carry(self, profile: Profile, began: float, entry: Move | None = None) -> None:
        """Have an offset on top that began then, and be told of its end."""
        self.offset, self.offset_began, self.offset_entry = profile, began, entry
        self.controller.clock.at(began + profile.duration, lambda: self._offset_done(profile))

    def fold(self, distance: float) -> None:
        """What an offset has done is now a part of the base."""

    def offset_left(self) -> tuple[float, float]:
        """What the offset under way still has to do, and its velocity."""
        if self.offset is None:
            return 0.0, 0.0
        elapsed = self.controller.clock.now - self.offset_began
        return self.offset.end - self.offset.position(elapsed), self.offset.velocity(elapsed)

    # -- inside

    def _here(self) -> float:
        return self.a.position(self.controller.clock.now)

    def _with_offset(self, coming: Profile) -> Profile:
        here, offset = self._here(), self.offset
        if offset is None:
            return self.base(coming, here)
        left = offset.after(self.controller.clock.now - self.offset_began)
        return added(self.base(coming, here - left.start), left, self.move.shape)

    def _offset_done(self, profile: Profile) -> None:
        if self.offset is profile and self.tied:
            self.offset = self.offset_entry = None
            self.fold(profile.end)
            self.renew()
            self.more(self.controller, self.a)


class Gear(Follow):
    """`ratio` times the master's motion; with `ramp` the slave ramps to that velocity at its own rates first."""

    __slots__ = ("_chased_at", "_halt", "_later", "_locks_at", "_paused", "ramp", "ratio")

    def __init__(
        self, controller: Core, a: Axis, master: Axis, move: FollowMove, ratio: float, ramp: bool
    ) -> None:
        super().__init__(controller, a, master, move)
        self.ratio, self.ramp = ratio, ramp
        # When the slave will have, or has, the velocity that the ratio wants.
        self._locks_at = INFINITY if ramp else 0.0
        # What the offset under way still has to do when the slave is suspended no longer, and those that wait for it.
        self._paused = 0.0
        # What the offset does as it comes to rest in a suspension, and from when on.
        self._halt: tuple[Profile, float] | None = None
        self._later: list[Callable[[], None]] = []
        # The rates of the ramp to that velocity.
        self._chased_at = (0.0, 0.0)

    @property
    def locked(self) -> float:
        """The time from which the slave has, or will have, the velocity that the ratio wants."""
        return self._locks_at

    def set_ratio(self, ratio: float, ramp: bool) -> None:
        """Another ratio from now on; the one in force changes nothing."""
        if ratio == self.ratio and ramp == self.ramp:
            locked = self._locks_at <= self.controller.clock.now
            if locked or self._chased_at == self.controller.rates(self.a, self.a.speed):
                return
        self.ratio, self.ramp = ratio, ramp
        self._locks_at = INFINITY if ramp else 0.0
        self.renew()

    def suspend(self, controller: Core, a: Axis) -> bool:
        self._pause_offset()
        self.renew()
        return True

    def resume(self, controller: Core, a: Axis) -> None:
        """Ramp to the ratio again, and do what an offset still has to; others that came meanwhile follow it."""
        self._locks_at = INFINITY
        (left, velocity), now = self.offset_left(), controller.clock.now
        if self._halt is not None:  # it may not have come to rest yet
            stop, began = self._halt
            left, velocity = left + stop.end - stop.position(now - began), stop.velocity(now - began)
        self._paused, self._halt = 0.0, None
        if left or velocity:
            accel, decel = controller.rates(a, a.speed)
            jerks = a.accel_jerk, a.decel_jerk
            profile = plan(a.shape, 0.0, left, a.speed, accel, decel, velocity, a.ramp, *jerks)
            self._log_offset(profile)
            self.carry(profile, now, self.offset_entry)
        self.renew()
        later, self._later = self._later, []
        for begin in later:
            begin()
        self.more(controller, a)

    def put_off(self, begin: Callable[[], None]) -> bool:
        """Whether an offset has to wait until the slave is suspended no longer."""
        if self.a.suspended:
            self._later.append(begin)
        return self.a.suspended

    def offset_left(self) -> tuple[float, float]:
        """The same; an offset that waits while the slave is suspended stands."""
        return (self._paused, 0.0) if self._paused else super().offset_left()

    def _pause_offset(self) -> None:
        """The offset slows down with the slave, in the same time; what it has not done then waits with it."""
        left, velocity = self.offset_left()
        if self.offset is None:
            return
        stop = halt.to_rest(self.controller, self.a)
        share = velocity / stop.start_velocity if stop.start_velocity else 0.0
        done = stop.scaled(self.offset.end - left, share)
        self._log_offset(halted(done, "suspend"))
        self._paused, self.offset = left - done.distance, None
        self._halt = done, self.controller.clock.now

    def _log_offset(self, profile: Profile) -> None:
        """The log entry of the offset goes on with a profile from now on."""
        entry = self.offset_entry
        if entry is None or entry.profile is None:
            return
        before = entry.profile.cut(self.controller.clock.now - entry.start_time)
        entry.profile = before.then(profile.scaled(before.end, 1.0))

    def base(self, coming: Profile, position: float) -> Profile:
        if self.a.suspended:
            return halt.standing(self.controller, self.a)
        if self._locks_at > self.controller.clock.now:
            return self._chased(coming, position)
        return self._geared(coming, position)

    def _geared(self, coming: Profile, position: float) -> Profile:
        if coming.shape == "hold" or not self.ratio:
            return rest(self.move.shape, position, INFINITY)
        return relabelled(coming.scaled(position, self.ratio), self.move.shape)

    def _chased(self, coming: Profile, position: float) -> Profile:
        """A straight ramp until the slave is as fast as the ratio wants it, then geared."""
        now = self.controller.clock.now
        wanted = coming.scaled(0.0, self.ratio)
        have = self.a.velocity(now) - self.offset_left()[1]
        want = wanted.velocity(0.0)
        accel, decel = self._chased_at = self.controller.rates(self.a, self.a.speed)
        if abs(want - have) <= _STILL * (1.0 + abs(want)):
            self._locks_at = now
            return self._geared(coming, position)
        sign = 1.0 if want > have else -1.0
        chase = _ramp(position, have, sign, accel, decel)
        gap = added(wanted, chase.scaled(0.0, -1.0), "gap")
        meets = gap.velocity_crossing(0.0)
        if meets is None:
            words = f"axis {self.a.index} cannot ramp to {want:g} counts/s, the speed of its master"
            raise Refusal("range", words, "raise its rates, or lower the ratio")
        self._locks_at = now + meets
        head = chase.cut(meets)
        return relabelled(head.then(self._geared(coming.after(meets), head.end)), self.move.shape)


def _ramp(position: float, velocity: float, sign: float, accel: float, decel: float) -> Profile:
    """Ever faster in a direction, without end; what runs the other way is slowed down first."""
    far = plan_velocity("trapezoid", position, velocity, sign * (abs(velocity) + accel * 1e6), accel, decel)
    return far.cut(far.knots[-2] * 0.999)


def gear(controller: Core, a: Axis, master: Axis, ratio: float, ramp: bool, command: str, line: int) -> None:
    """Let an axis follow a master, or change the ratio at which it does."""
    _check_ratio(ratio)
    tie = tie_of(a)
    if isinstance(tie, Gear) and tie.master is master:
        tie.set_ratio(ratio, ramp)
        return
    check_chain(a, master)
    if ramp:
        controller.rates(a, a.speed)
    move = FollowMove(a.index, command, line, "gear")
    controller.end_move(a, "retarget")
    Gear(controller, a, master, move, ratio, ramp).engage()


def set_ratio(a: Axis, ratio: float) -> None:
    """Let an axis that follows a master at a ratio do so at another one, at once."""
    tie = tie_of(a)
    if isinstance(tie, Gear):
        _check_ratio(ratio)
        tie.set_ratio(ratio, False)


def _check_ratio(ratio: float) -> None:
    if not abs(ratio) < 1e12:
        raise Refusal("range", f"an axis cannot follow at a ratio of {ratio:g}")


def leave_master(controller: Core, a: Axis) -> None:
    """Follow no master any more: what the axis does it goes on doing to its end; at rest it is idle."""
    tie = tie_of(a)
    if tie is None:
        return
    now = controller.clock.now
    if tie.resting:
        controller.end_move(a, "")
        a.target = a.position(now)
        controller.extend_track(a, hold(a.target))
        controller.go_on(a)
        return
    tie.leave(controller, a, "")
    rest_of = a.profiles[-1].after(now - a.starts[-1])
    tie.move.action = Played()
    tie.move.add(now, rest_of)
    a.target = tie.move.target = rest_of.end
    controller.append_profile(a, rest_of)


def tie_of(a: Axis) -> Follow | None:
    """What ties an axis to its master, None while it follows none."""
    action = a.move.action if a.move is not None else None
    return action if isinstance(action, Follow) else None


def follows(link: Axis | None, a: Axis) -> bool:
    """Whether `link` is the axis `a`, or follows it, directly or through others."""
    while link is not None and link is not a:
        tie = tie_of(link)
        link = tie.master if tie is not None else None
    return link is a


def check_chain(a: Axis, master: Axis) -> None:
    """Refuse a master that follows the slave itself."""
    if follows(master, a):
        raise Refusal("axis", f"axis {a.index} cannot follow axis {master.index}: it would follow itself")
