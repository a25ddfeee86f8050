"""The virtual controller: axes that move in closed form on a virtual clock.

The life of a move: a language loads it (`load_to`, `load_by`) and starts it (`go`), or does both at once
(`move_to`, `move_by`); `_start` plans a `Profile` from the axis's state and settings, appends it to the axis's
track and sets one event for its end; `_arrive` starts the next move of the buffer, if it was released.
"""

from __future__ import annotations

from motionlang.controller.axis import Axis
from motionlang.controller.clock import INFINITY, Clock
from motionlang.controller.faults import Refusal
from motionlang.controller.inputs import Channels
from motionlang.controller.move import Move
from motionlang.controller.watch import Watch, arm
from motionlang.profile import hold, plan, plan_stop, plan_velocity

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from motionlang.controller.trace import Trace
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
        "error_decel",
        "ramp",
        "shape",
        "buffer_size",
        "live_speed",
    }
)


class Controller:
    """`axes` axes numbered from `first`, a clock, and the log of every move that was started."""

    def __init__(self, axes: int = 8, first: int = 0) -> None:
        self.clock = Clock()
        self.axes: dict[int, Axis] = {number: Axis(number) for number in range(first, first + axes)}
        self.moves: list[Move] = []
        self.inputs = Channels(self.clock)
        self.outputs = Channels(self.clock)
        self.analogue_inputs = Channels(self.clock)
        self.analogue_outputs = Channels(self.clock)
        # Told of ("idle", axis), ("fault", axis), ("scale", axis) and ("home", axis) as they happen.
        self.listeners: list[Callable[[str, int], None]] = []

    # ------------------------------------------------------------------------------------------- settings

    def configure(self, axis: int, name: str, value: float | str | None) -> None:
        """Set one of `SETTINGS`; a rate and the time for it replace each other."""
        assert name in SETTINGS, name
        a = self.axes[axis]
        setattr(a, name, value)
        if name == "accel":
            a.accel_time = None
        elif name == "decel":
            a.decel_time = None
        elif name == "speed" and a.live_speed and a.move is not None and a.move.target != INFINITY:
            self._replan(a)

    def setting(self, axis: int, name: str) -> float | str | None:
        """Read one of `SETTINGS` back."""
        value: float | str | None = getattr(self.axes[axis], name)
        return value

    def set_scale(self, axis: int, counts: float, rate: float = 1.0, zero: float = 0.0) -> None:
        """Set the door between user units and counts."""
        scale = self.axes[axis].scale
        scale.counts, scale.rate, scale.zero = counts, rate, zero
        self.tell("scale", axis)

    # ---------------------------------------------------------------------------------------- on and off

    def enable(self, axis: int) -> None:
        """Switch an axis on where it stands: target, demanded and actual position become one; faults are forgotten."""
        a = self.axes[axis]
        a.enabled = True
        a.faults = 0
        if a.move is None:
            a.target = a.position(self.clock.now)

    def disable(self, axis: int) -> None:
        """Switch an axis off. With no simulated motor there is no coasting: it stands where it is."""
        a = self.axes[axis]
        self._freeze(a, "fault" if a.faults else "cancel")
        a.enabled = False

    def clear_faults(self, axis: int) -> None:
        """Forget an axis's faults."""
        self.axes[axis].faults = 0

    def define_position(self, axis: int, position: float) -> None:
        """Give the present position a new value, also in motion: the rest of the move shifts with it."""
        a, now = self.axes[axis], self.clock.now
        here = a.position(now)
        shift = position - here
        rest = a.profiles[-1].after(now - a.starts[-1]) if a.move is not None else hold(here)
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
        a = self._ready(axis)
        if len(a.buffer) >= a.buffer_size:
            raise Refusal("buffer-full", f"the move buffer of axis {axis} is full")
        a.buffer.append(Move(axis, command, line, position))

    def load_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Put a move by `distance` into the buffer, counted from the end of the move before it."""
        a = self.axes[axis]
        base = a.buffer[-1].target if a.buffer else a.target
        self.load_to(axis, base + distance, command, line)

    def go(self, axes: Iterable[int]) -> None:
        """Release all moves in the buffers of `axes`; those of idle axes start now, together."""
        for axis in axes:
            a = self._ready(axis)
            for move in a.buffer:
                move.released = True
            if a.move is None:
                self._next(a)

    def move_to(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Move to `position` now, from whatever the axis is doing."""
        a = self._ready(axis)
        self._end_move(a, "retarget")
        self._start(a, Move(axis, command, line, position))

    def move_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Move by `distance` from the present target now."""
        self.move_to(axis, self.axes[axis].target + distance, command, line)

    def jog(self, axis: int, velocity: float, command: str = "", line: int = 0) -> None:
        """Ramp to `velocity`, counts/s, and keep it."""
        a = self._ready(axis)
        accel, decel = self._rates(a)
        move = Move(axis, command, line, INFINITY)
        self._end_move(a, "retarget")
        state = a.at(self.clock.now)
        try:
            profile = plan_velocity(
                a.shape,
                state.position,
                state.velocity,
                velocity,
                accel,
                decel,
                a.ramp,
                a.accel_jerk,
                a.decel_jerk,
            )
        except ValueError as problem:
            raise Refusal("range", f"axis {axis} cannot jog: {problem}") from None
        self._run(a, move, profile)

    def play(self, axis: int, profile: Profile, command: str = "", line: int = 0) -> None:
        """Follow a ready-made profile that begins where the axis is: a path, or the motion of a master."""
        a = self._ready(axis)
        self._end_move(a, "retarget")
        self._run(a, Move(axis, command, line, profile.end), profile)

    def stop(self, axis: int, ended: str = "stop") -> None:
        """Decelerate to rest at the set rate (at `error_decel` for a fault) and empty the buffer."""
        a = self.axes[axis]
        a.buffer.clear()
        if a.move is None:
            return
        decel = a.error_decel if ended == "fault" else self._rates(a)[1]
        state = a.at(self.clock.now)
        try:
            profile = plan_stop(a.shape, state.position, state.velocity, decel, a.ramp, a.decel_jerk)
        except ValueError as problem:
            raise Refusal("range", f"axis {axis} cannot stop: {problem}") from None
        self._continue(a, profile, ended)
        a.target = a.move.target = profile.end

    def abort(self, axis: int, ended: str = "cancel") -> None:
        """Come to rest at once and empty the buffer."""
        self._freeze(self.axes[axis], ended)

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

    def heading(self, axis: int) -> int:
        """+1 while the axis moves forward, -1 in reverse, 0 at rest: where the present profile is going."""
        a = self.axes[axis]
        if a.move is None:
            return 0
        velocity = a.velocity(self.clock.now) or a.profiles[-1].end_velocity or a.profiles[-1].distance
        return (velocity > 0) - (velocity < 0)

    # ------------------------------------------------------------------------------------------- reading

    def position(self, axis: int) -> float:
        return self.axes[axis].position(self.clock.now)

    def velocity(self, axis: int) -> float:
        return self.axes[axis].velocity(self.clock.now)

    def following_error(self, axis: int) -> float:
        """Demanded minus actual position: 0 until a motor is simulated."""
        return 0.0

    def target(self, axis: int) -> float:
        return self.axes[axis].target

    def remaining(self, axis: int) -> float:
        """The distance still to go in the present move, signed; 0 at rest."""
        a = self.axes[axis]
        if a.move is None or a.target == INFINITY:
            return 0.0
        return a.target - a.position(self.clock.now)

    def is_enabled(self, axis: int) -> bool:
        return self.axes[axis].enabled

    def is_idle(self, axis: int) -> bool:
        return self.axes[axis].move is None

    def faults(self, axis: int) -> int:
        return self.axes[axis].faults

    def idle_time(self, axis: int) -> float:
        """The time at which the axis will be idle if nothing else happens; infinite while it jogs."""
        a = self.axes[axis]
        return self.clock.now if a.move is None else a.end_of_motion()

    def crossing_time(self, axis: int, position: float) -> float:
        """The time at which the axis will pass `position`, infinite if the present motion never does."""
        a, now = self.axes[axis], self.clock.now
        start = a.starts[-1]
        found = a.profiles[-1].crossing(position, now - start)
        return INFINITY if found is None else start + found

    def watch(self, axis: int, position: float, call: Callable[[int], None], physical: bool = False) -> Watch:
        """Call `call(direction)` whenever the axis passes `position`, until `unwatch`."""
        a = self.axes[axis]
        watch = Watch(position, call, physical)
        a.watches.append(watch)
        arm(a, watch, self.clock, self.clock.now)
        return watch

    def unwatch(self, axis: int, watch: Watch) -> None:
        """End a watch."""
        self.axes[axis].watches.remove(watch)
        if watch.event is not None:
            watch.event.cancel()

    def input(self, channel: int) -> float:
        return self.inputs[channel]

    def output(self, channel: int) -> float:
        return self.outputs[channel]

    def set_output(self, channel: int, value: float) -> None:
        self.outputs[channel] = value

    def analogue_input(self, channel: int) -> float:
        return self.analogue_inputs[channel]

    def set_analogue_output(self, channel: int, value: float) -> None:
        self.analogue_outputs[channel] = value

    @property
    def trace(self) -> Trace:
        """The motion so far, to be sampled; brings in numpy."""
        from motionlang.controller.trace import Trace

        return Trace(self)

    # ------------------------------------------------------------------------------------ the life of a move

    def _ready(self, axis: int) -> Axis:
        a = self.axes[axis]
        if not a.enabled:
            raise Refusal("disabled-axis", f"axis {axis} is off", "switch the axis on before it moves")
        return a

    def _rates(self, a: Axis) -> tuple[float, float]:
        accel, decel = a.rates()
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

    def _plan(self, a: Axis, target: float) -> Profile:
        if not a.speed > 0:
            raise Refusal(
                "zero-speed",
                f"axis {a.index} cannot move: its speed is {a.speed:g}",
                "a move needs a speed above zero, else it would start and never end",
            )
        accel, decel = self._rates(a)
        last, now = a.profiles[-1], self.clock.now
        try:
            if last.shape == "hold":
                return plan(
                    a.shape, last.end, target, a.speed, accel, decel, 0.0, a.ramp, a.accel_jerk, a.decel_jerk
                )
            s = last.at(now - a.starts[-1])
            return plan(
                a.shape,
                s.position,
                target,
                a.speed,
                accel,
                decel,
                s.velocity,
                a.ramp,
                a.accel_jerk,
                a.decel_jerk,
                s.acceleration,
            )
        except ValueError as problem:
            raise Refusal("range", f"axis {a.index} cannot move: {problem}") from None

    def _start(self, a: Axis, move: Move) -> None:
        try:
            profile = self._plan(a, move.target)
        except Refusal as refusal:
            refusal.line = move.line
            raise
        self._run(a, move, profile)

    def _run(self, a: Axis, move: Move, profile: Profile) -> None:
        if len(self.moves) >= MAX_MOVES:
            raise Refusal(
                "limit", f"more than {MAX_MOVES} moves were started", "shorten the run with --until"
            )
        move.profile, move.start_time = profile, self.clock.now
        move.scale, move.zero = a.scale.counts, a.scale.zero
        self.moves.append(move)
        a.move = move
        a.target = move.target
        self._append(a, profile)
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
        for watch in a.watches:
            arm(a, watch, self.clock, now)
        for follower in a.followers:
            follower(profile)

    def _arrive(self, a: Axis) -> None:
        a.arrival = None
        a.move = None
        self._follow(a, hold(a.profiles[-1].end))
        self._next(a)
        if a.move is None:
            self.tell("idle", a.index)

    def tell(self, what: str, axis: int) -> None:
        """Let the listeners know; a listener may leave while it is told."""
        for listener in tuple(self.listeners):
            listener(what, axis)

    def _next(self, a: Axis) -> None:
        if a.buffer and a.buffer[0].released:
            self._start(a, a.buffer.pop(0))

    def _replan(self, a: Axis) -> None:
        """Go on to the same target with the settings as they are now."""
        assert a.move is not None
        self._continue(a, self._plan(a, a.move.target), "")

    def _continue(self, a: Axis, profile: Profile, ended: str) -> None:
        """Replace what is left of the present move by `profile`."""
        move = a.move
        assert move is not None
        assert move.profile is not None
        done = move.profile.cut(self.clock.now - move.start_time)
        move.profile = done.then(profile.shifted(-move.offset) if move.offset else profile)
        move.ended = ended or move.ended
        self._append(a, profile)

    def _end_move(self, a: Axis, ended: str) -> None:
        """Close the log entry of a move that is about to be replaced; the motion itself goes on."""
        move = a.move
        if move is not None and move.profile is not None:
            move.profile = move.profile.cut(self.clock.now - move.start_time)
            move.ended = ended
            a.move = None

    def _freeze(self, a: Axis, ended: str) -> None:
        """Stand still at once where the axis is."""
        a.buffer.clear()
        if a.arrival is not None:
            a.arrival.cancel()
            a.arrival = None
        if a.move is None:
            return
        self._end_move(a, ended)
        a.target = a.position(self.clock.now)
        self._follow(a, hold(a.target))
        self.tell("idle", a.index)
