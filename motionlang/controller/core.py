"""The virtual controller: axes that move in closed form on a virtual clock.

The life of a move: a language loads it (`load_to`, `load_by`) and starts it (`go`), or does both at once
(`move_to`, `move_by`); `_start` plans a `Profile` from the axis's state and settings, appends it to the axis's
track and sets one event for its end; `_arrive` starts the next move of the buffer, if it was released.
"""

from __future__ import annotations

from motionlang.controller import buffer, feedrate, halt
from motionlang.controller.clock import INFINITY
from motionlang.controller.faults import Refusal, names
from motionlang.controller.move import Move
from motionlang.controller.readings import Readings
from motionlang.controller.watch import arm
from motionlang.profile import hold, plan

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from motionlang.controller.axis import Axis
    from motionlang.profile import Profile

# The log of one run; beyond it the run ends with a diagnostic rather than with the machine's memory.
MAX_MOVES = 2_000_000

SETTINGS = frozenset(
    {
        "speed",
        "accel",
        "decel",
        "accel_time",
        "decel_time",
        "accel_jerk",
        "decel_jerk",
        "accel_jerk_time",
        "decel_jerk_time",
        "s_ramp",
        "own_rates",
        "error_decel",
        "ramp",
        "shape",
        "buffer_size",
        "buffer_low",
        "move_id",
        "live_speed",
        "feedrate_mode",
        "override",
        "suspend_time",
        "max_speed",
        "max_accel",
        "max_decel",
        "contour_mode",
        "contour_angle",
        "blend_mode",
        "blend_distance",
    }
)


class Core(Readings):
    """The verbs of single axes, and what becomes of a move."""

    # ------------------------------------------------------------------------------------------- settings

    def configure(self, axis: int, name: str, value: object) -> None:
        """Set one of `SETTINGS`; a rate and the time for it replace each other."""
        assert name in SETTINGS, name
        a = self.axes[axis]
        if a.move is not None and name in feedrate.LIVE and feedrate.unchanged(a, name, value):
            return
        setattr(a, name, value)
        if name == "accel":
            a.accel_time = None
        elif name == "decel":
            a.decel_time = None
        if a.move is not None and name in feedrate.LIVE:
            feedrate.changed(self, a, name)

    def setting(self, axis: int, name: str) -> float | str | None:
        """Read one of `SETTINGS` back."""
        value: float | str | None = getattr(self.axes[axis], name)
        return value

    def set_scale(self, axis: int, counts: float, rate: float = 1.0, zero: float = 0.0) -> None:
        """Set the door between user units and counts."""
        self.axes[axis].scale.set(counts, rate, zero)
        self.tell("scale", axis)

    # ---------------------------------------------------------------------------------------- on and off

    def enable(self, axis: int) -> None:
        """Switch an axis on where it stands: target, demanded and actual position become one; faults are forgotten."""
        a = self.axes[axis]
        if not self.may_enable(axis):
            words = f"the enable input of axis {axis}, input {self.interlocks[axis]}, is off"
            raise Refusal("enable-input", words, "the drive can be enabled while it is on")
        a.enabled = True
        a.faults = 0
        if a.feedback is not None:
            a.feedback.take_over(self)
        if a.move is None:
            a.target = a.position(self.clock.now)
        self.tell("switched", axis)

    def disable(self, axis: int) -> None:
        """Switch an axis off: its demand stands where it is, and so does the axis unless a simulated motor coasts."""
        a = self.axes[axis]
        self._freeze(a, "fault" if a.faults else "cancel")
        a.enabled = False
        if a.feedback is not None:
            a.feedback.open(0.0)
        self.tell("switched", axis)

    def clear_faults(self, axis: int) -> None:
        """Forget an axis's faults."""
        a = self.axes[axis]
        a.faults = 0
        if a.feedback is not None:
            a.feedback.look_again()
        self.tell("cleared", axis)

    def define_position(self, axis: int, position: float) -> None:
        """Give the present position a new value, also in motion: the rest of the move shifts with it."""
        a, now = self.axes[axis], self.clock.now
        here = a.position(now)
        shift = position - self.position(axis)
        if not shift:
            return
        rest = a.profiles[-1].after(now - a.starts[-1]) if a.move is not None else hold(here)
        if a.move is not None and a.move.action is not None:
            a.move.action.shift(self, a, shift)
        a.datum += shift
        a.target += shift
        self._follow(a, rest.shifted(shift))
        if a.move is not None:
            a.move.offset += shift
            a.move.target += shift

    # -------------------------------------------------------------------------------------------- moving

    def room(self, axis: int) -> int:
        """How many moves the buffer can still take, the one being executed not counted."""
        a = self.axes[axis]
        return a.buffer_size - len(a.buffer)

    def load_to(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Put a move to `position` into the buffer."""
        buffer.put(self._ready(axis), Move(axis, command, line, position))

    def load_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Put a move by `distance` into the buffer, counted from the end of the move before it."""
        a = self._ready(axis)
        buffer.put(a, Move(axis, command, line, buffer.known_end(a) + distance))

    def load_dwell(self, axis: int, duration: float, command: str = "", line: int = 0) -> None:
        """Put a rest of `duration` seconds into the buffer."""
        buffer.put_action(self._ready(axis), buffer.Dwell(duration), command, line)

    def load_output(self, axis: int, values: Mapping[int, float], command: str = "", line: int = 0) -> None:
        """Put a change of outputs, channel to value, into the buffer; it takes no time."""
        buffer.put_action(self._ready(axis), buffer.Outputs(dict(values)), command, line)

    def load_pulse(self, axis: int, channel: int, duration: float, command: str = "", line: int = 0) -> None:
        """Put a pulse of an output, `duration` seconds long, into the buffer; what follows does not wait for it."""
        buffer.put_action(self._ready(axis), buffer.Pulse(channel, duration), command, line)

    def go(self, axes: Iterable[int]) -> None:
        """Release all moves in the buffers of `axes`; those of idle axes start now, together."""
        for axis in axes:
            a = self._ready(axis)
            for move in a.buffer:
                if move.action is None:
                    move.released = True
                else:
                    move.action.release(move)
            if a.move is None:
                self._next(a)
            elif a.move.action is not None:
                a.move.action.more(self, a)

    def move_to(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Move to `position` now, from whatever the axis is doing."""
        a = self._ready(axis)
        move = buffer.stamped(a, Move(axis, command, line, position))
        profile = self._plan(a, move)
        self._end_move(a, "retarget")
        self._run(a, move, profile)

    def move_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Move by `distance` from the present target now, from where the axis is where it has none."""
        a = self.axes[axis]
        base = a.target if abs(a.target) < INFINITY else a.position(self.clock.now)
        self.move_to(axis, base + distance, command, line)

    def retarget_to(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Let the move in progress end at `position`; an axis at rest starts at once."""
        halt.retarget(self, self._ready(axis), position, command, line)

    def retarget_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Let the move in progress end `distance` further on; an axis at rest starts at once."""
        self.retarget_to(axis, self.axes[axis].target + distance, command, line)

    def jog(
        self,
        axis: int,
        velocity: float,
        command: str = "",
        line: int = 0,
        rates: tuple[float | None, float | None] | None = None,
        ends: bool = False,
    ) -> None:
        """Ramp to `velocity`, counts/s, and keep it; with `ends` a jog to 0 is over when the axis stands."""
        from motionlang.controller.jog import jog

        jog(self, self._ready(axis), velocity, command, line, rates, ends)

    def play(
        self, axis: int, profile: Profile, command: str = "", line: int = 0, on_path: bool = False
    ) -> None:
        """Follow a ready-made profile that begins where the axis is; with `on_path` a stop does not leave it."""
        from motionlang.controller.played import Played

        a = self._ready(axis)
        move = Move(axis, command, line, profile.end)
        move.action = Played(on_path)
        self._end_move(a, "retarget")
        self._run(a, move, profile)

    def redirect(self, axis: int, profile: Profile, ended: str = "") -> None:
        """Replace the rest of the present move by a ready-made profile, such as a path that grew or was stopped."""
        a = self.axes[axis]
        if a.move is not None:
            self._continue(a, profile, ended)
            a.target = a.move.target = profile.end

    def stop(self, axis: int, ended: str = "stop") -> None:
        """Decelerate to rest at the set rate (at `error_decel` for a fault) and empty the buffer."""
        a = self.axes[axis]
        self._hold(a)
        a.suspended = False
        if a.move is None or a.move.action is None or not a.move.action.stop(self, a, ended):
            self.empty(a)
            halt.stop(self, a, ended)

    def suspend(self, axis: int) -> None:
        """Ramp to rest and keep the move, and those of the buffer, until `resume`."""
        halt.suspend(self, self.axes[axis])

    def resume(self, axis: int) -> None:
        """Go on with what `suspend` held."""
        halt.resume(self, self.axes[axis])

    def is_suspended(self, axis: int) -> bool:
        """Whether `suspend` holds the axis."""
        return self.axes[axis].suspended

    def abort(self, axis: int, ended: str = "cancel") -> None:
        """Come to rest at once and empty the buffer."""
        a = self.axes[axis]
        self._freeze(a, ended)
        self._hold(a)

    def fault(self, axis: int, bit: int, action: str) -> None:
        """Raise a fault on an axis and do what `action` (one of `limit.ACTIONS`) says about it."""
        self.axes[axis].faults |= bit
        if action == "stop":
            self.stop(axis)
        elif action == "error-stop":
            self.stop(axis, "fault")
        elif action == "abort":
            self.abort(axis, "fault")
        elif action == "off":
            self.disable(axis)
        if action != "ignore":
            self.tell("fault", axis)

    # ------------------------------------------------------------------------------------ the life of a move

    def _ready(self, axis: int) -> Axis:
        a = self.axes[axis]
        if a.faults & a.locks:
            what = names(a.faults)
            raise Refusal(
                "axis-error", f"axis {axis} has an error: {what}", "clear the error before it moves"
            )
        if not a.enabled:
            raise Refusal("disabled-axis", f"axis {axis} is off", "switch the axis on before it moves")
        if axis in self.braked:
            raise Refusal("brake", f"the brake of axis {axis} is set", "lift the brake before it moves")
        self._hold(a)
        return a

    def _hold(self, a: Axis) -> None:
        """A simulated motor whose output was set by hand is its loop's again."""
        if a.feedback is not None and a.enabled:
            a.feedback.take_over(self)

    def rates(self, a: Axis, speed: float) -> tuple[float, float]:
        """The rates in force for a move at `speed`, or the refusal of one that is not above zero."""
        accel, decel = a.rates(speed)
        for rate, what in ((accel, "acceleration"), (decel, "deceleration")):
            if not rate > 0:
                raise Refusal(
                    "zero-acceleration",
                    f"axis {a.index} cannot move: its {what} is {rate:g}",
                    f"a move needs an {what} above zero"
                    if what[0] == "a"
                    else f"a move needs a {what} above zero",
                )
        return accel, decel

    def _plan(self, a: Axis, move: Move) -> Profile:
        """From the state of the axis to the end of the move."""
        speed = a.speed if move.speed is None else move.speed
        if not speed > 0:
            raise Refusal(
                "zero-speed",
                f"axis {a.index} cannot move: its speed is {speed:g}",
                "a move needs a speed above zero, else it would start and never end",
            )
        accel, decel = self.rates(a, speed)
        if move.rates is not None:
            accel, decel = move.rates[0] or accel, move.rates[1] or decel
        if move.overridden:
            speed *= a.override
        if a.limited:
            speed, accel, decel = min(speed, a.max_speed), min(accel, a.max_accel), min(decel, a.max_decel)
        if a.suspended or not speed:
            return halt.standing(self, a)
        last, shape = a.profiles[-1], a.shape
        try:
            if last.shape == "hold" and shape == "trapezoid":  # nearly every move there is
                return plan(shape, last.end, move.target, speed, accel, decel)
            jerks = (a.accel_jerk, a.decel_jerk) if shape == "scurve" else (INFINITY, INFINITY)
            s = last.at(self.clock.now - a.starts[-1])
            return plan(
                shape,
                s.position,
                move.target,
                speed,
                accel,
                decel,
                s.velocity,
                a.ramp,
                *jerks,
                s.acceleration,
            )
        except ValueError as problem:
            raise Refusal("range", f"axis {a.index} cannot move: {problem}") from None

    def _start(self, a: Axis, move: Move) -> None:
        self._run(a, move, self._plan(a, move))

    def _run(self, a: Axis, move: Move, profile: Profile) -> None:
        self._record(a, move, profile)
        self._append(a, profile)
        if a.limits:
            self._check_limits(a)

    def _record(self, a: Axis, move: Move, profile: Profile) -> None:
        """Write a move that begins into the log; it is the axis's own from now on."""
        if len(self.moves) >= MAX_MOVES:
            raise Refusal(
                "limit", f"more than {MAX_MOVES} moves were started", "shorten the run with --until"
            )
        move.profile, move.start_time = profile, self.clock.now
        move.scale, move.zero = a.scale.counts, a.scale.zero
        self.moves.append(move)
        a.move = move
        a.target = move.target

    def _check_limits(self, a: Axis) -> None:
        """A move into a limit that is active already has passed it."""
        for limit in a.limits:
            if limit.active and self.heading(a.index) == limit.sign:
                limit.trip()

    def _append(self, a: Axis, profile: Profile) -> None:
        """Follow `profile` from now on, and be told when it is done."""
        if a.arrival is not None:
            a.arrival.cancel()
        end = self.clock.now + profile.duration
        a.arrival = self.clock.at(end, lambda: self._arrive(a)) if end < INFINITY else None
        self._follow(a, profile)

    def _follow(self, a: Axis, profile: Profile) -> None:
        now = self.clock.now
        a.starts.append(now)
        a.profiles.append(profile)
        if a.feedback is not None:
            a.feedback.changed()
        else:
            for watch in tuple(a.watches):
                if watch in a.watches:  # what is passed in this very moment may end others
                    arm(a, watch, self.clock, now)
        for follower in a.followers:
            follower(profile)

    def _arrive(self, a: Axis) -> None:
        a.arrival = None
        a.move = None
        self._follow(a, hold(a.profiles[-1].end))
        self.go_on(a)

    def go_on(self, a: Axis) -> None:
        """Start what the buffer holds next, now that the axis is at rest; an entry that cannot begin is left out."""
        while True:
            try:
                self._next(a)
                break
            except Refusal as refusal:
                self.mishap(refusal)
        if a.move is None:
            self.tell("idle", a.index)

    def _next(self, a: Axis) -> None:
        """Start what the buffer holds next, as far as it is released."""
        while a.move is None and a.buffer and a.buffer[0].released:
            move = a.buffer[0]
            if move.action is not None and not move.action.ready(self, a, move):
                return
            self._take(a)
            try:
                if move.action is None:
                    self._start(a, move)
                else:
                    move.action.begin(self, a, move)
            except Refusal as refusal:
                refusal.line = refusal.line or move.line
                raise

    def _take(self, a: Axis, place: int = 0) -> None:
        """An entry, the first one unless said otherwise, leaves the buffer."""
        a.last_id = a.buffer.pop(place).id
        if a.buffer_low >= 0:
            buffer.taken(self, a)

    def empty(self, a: Axis) -> None:
        """Throw away what the buffer holds, and what belongs to it in the buffers of other axes."""
        entries, a.buffer = a.buffer, []
        for move in entries:
            if move.action is not None:
                move.action.purge(a)

    def _replan(self, a: Axis) -> None:
        """Go on to the same target with the settings as they are now."""
        assert a.move is not None
        if a.move.action is None:
            self._continue(a, self._plan(a, a.move), "")
        else:
            a.move.action.replan(self, a)

    def _continue(self, a: Axis, profile: Profile, ended: str) -> None:
        """Replace what is left of the present move by `profile`."""
        self._amend(a, profile, ended)
        self._append(a, profile)

    def _amend(self, a: Axis, profile: Profile, ended: str) -> None:
        """The same in the log only."""
        move = a.move
        assert move is not None
        assert move.profile is not None
        done = move.profile.cut(self.clock.now - move.start_time)
        # Where a new zero has come between them, the two differ by it, and by its rounding.
        move.profile = done.then(profile.scaled(done.end, 1.0) if move.offset else profile)
        move.ended = ended or move.ended

    def _end_move(self, a: Axis, ended: str) -> None:
        """Close the log entry of a move that is about to be replaced; the motion itself goes on."""
        move = a.move
        if move is not None and move.profile is not None:
            if move.action is not None:
                move.action.leave(self, a, ended)
            move.profile = move.profile.cut(self.clock.now - move.start_time)
            move.ended = ended
            a.move = None

    def _freeze(self, a: Axis, ended: str) -> None:
        """Stand still at once where the axis is."""
        a.suspended = False
        self.empty(a)
        if a.arrival is not None:
            a.arrival.cancel()
            a.arrival = None
        if a.move is None:
            return
        self._end_move(a, ended)
        a.target = a.position(self.clock.now)
        self._follow(a, hold(a.target))
        self.tell("idle", a.index)
