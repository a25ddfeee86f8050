"""The verbs of single axes: settings, switches, loading and starting moves, stops.

A language loads a move (`load_to`, `load_by`) and starts it (`go`), or does both at once (`move_to` and
`move_by`, which are in `core`, together with the life cycle of a move).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from motionlang.kernel.controller import events, settings
from motionlang.kernel.controller.axis import BY_WORD, LIVE, Axis
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.motion.jog import jog
from motionlang.kernel.controller.queue import buffer, stop
from motionlang.kernel.controller.queue.life import Core
from motionlang.kernel.controller.triggers import conditions
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import Move
from motionlang.kernel.planners import Profile, hold

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


class AxisVerbs(Core):
    """The commands of a language for one axis, in counts and seconds.

    They raise Rejected if the axis cannot execute them.
    """

    # ------------------------------------------------------------------------------------------- settings

    def configure(self, axis: int, name: str, value: object) -> None:
        """Set one of `SETTINGS`; a rate replaces its ramp time, and vice versa."""
        assert name in SETTINGS, name
        a = self.axes[axis]
        if a.move is not None and name in LIVE and settings.unchanged(a, name, value):
            return
        if name == "override" and a.move is not None:
            events.note(self, "override", a, float(value))  # type: ignore[arg-type]
        if getattr(a, name) != value:
            self.log.settings.add((self.clock.now, axis, name, value))
        setattr(a, name, value)
        if name == "speed" and not value:
            self.zeroed[axis] = self.log.where()
        if name == "accel":
            a.accel_time = None
        elif name == "decel":
            a.decel_time = None
        if a.move is not None and name in LIVE:
            settings.changed(self, a, name)
            self.motion_listener.heed(a)

    def restore(self, axis: int) -> None:
        """Reset all `SETTINGS` of an axis at rest to their values at power-up."""
        new = Axis(axis)
        for name in sorted(SETTINGS):
            self.configure(axis, name, getattr(new, name))

    def setting(self, axis: int, name: str) -> float | str | None:
        """Return the value of one of `SETTINGS`."""
        value: float | str | None = getattr(self.axes[axis], name)
        return value

    def set_scale(self, axis: int, counts: float, rate: float = 1.0, zero: float = 0.0) -> None:
        """Set the conversion between user units and counts."""
        self.axes[axis].scale.set(counts, rate, zero)
        self.notify("scale", axis)

    def set_wrap(self, axis: int, wrap: float) -> None:
        """Set the range in which the language counts positions, user units; 0 for none."""
        self.axes[axis].scale.wrap = wrap

    def set_units(self, axis: int, speed: float | None, acceleration: float | None) -> None:
        """Set the units of speed and of acceleration, each as a number of counts.

        None selects the unit of positions.
        """
        self.axes[axis].scale.set_units(speed, acceleration)

    def set_time_unit(self, axis: int, seconds: float) -> None:
        """Set the unit of time, as a number of seconds."""
        self.axes[axis].scale.set_rate(seconds)

    # ------------------------------------------------------------------------------ switches and limits

    def set_home_switch(self, axis: int, on: bool) -> None:
        """Close or open the home switch of an axis from outside."""
        (self.at_home.add if on else self.at_home.discard)(axis)
        self.notify("home", axis)

    def set_limit_action(self, axis: int, bit: int, action: str) -> None:
        """Set the action of those limits of an axis that raise the fault `bit`."""
        for limit in self.axes[axis].limits:
            if limit.bit == bit:
                limit.action = action

    def lock(self, axis: int, faults: int) -> None:
        """Set the faults that prevent motion of an axis."""
        self.axes[axis].locks = faults

    def set_brake(self, axis: int, on: bool) -> None:
        """Apply or release the brake of an axis without informing its drive."""
        (self.braked.add if on else self.braked.discard)(axis)

    # ---------------------------------------------------------------------------------------- on and off

    def enable(self, axis: int) -> None:
        """Enable an axis where it is.

        Target, commanded and actual position become equal; faults are cleared.
        """
        a = self.axes[axis]
        if not self.may_enable(axis):
            words = f"the enable input of axis {axis}, input {self.interlocks[axis]}, is off"
            raise Rejected("enable-input", words, "the drive can be enabled while it is on")
        a.enabled = True
        self._forget_faults(a)
        if a.feedback is not None:
            a.feedback.take_over(self)
            a.feedback.search_again()
        if a.move is None:
            a.target = a.position(self.clock.now)
        self.notify("switched", axis)

    def disable(self, axis: int) -> None:
        """Disable an axis.

        Its commanded position stays, and so does the axis itself unless a simulated motor coasts.
        """
        a = self.axes[axis]
        self.freeze(a, "fault" if a.faults else "cancel")
        a.enabled = False
        if a.feedback is not None:
            a.feedback.open(0.0)
        self.notify("switched", axis)

    def clear_faults(self, axis: int) -> None:
        """Clear the faults of an axis."""
        a = self.axes[axis]
        self._forget_faults(a)
        if a.feedback is not None:
            a.feedback.search_again()
        self.notify("cleared", axis)

    def _forget_faults(self, a: Axis) -> None:
        if a.faults:
            events.cleared(self, a)
        a.faults = 0

    def define_position(self, axis: int, position: float) -> None:
        """Give the present position a new value; the rest of a move shifts with it."""
        a, now = self.axes[axis], self.clock.now
        here = a.here(now)
        shift = position - self.position(axis)
        if not shift:
            return
        rest = a.profiles[-1].after(now - a.starts[-1]) if a.move is not None else hold(here)
        if a.move is not None and a.move.action is not None:
            a.move.action.shift(self, a, shift)
        a.datum += shift
        a.target += shift
        if a.move is not None:
            a.move.offset += shift
            a.move.target += shift
        self.extend_track(a, rest.shifted(shift))
        a.cross(now, here + shift if a.feedback is not None else position)

    # -------------------------------------------------------------------------------------------- moving

    def room(self, axis: int) -> int:
        """Return how many more moves fit into the buffer; the present move is not in it."""
        a = self.axes[axis]
        return a.buffer_size - len(a.buffer)

    def load_to(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Load a move to `position` into the move buffer."""
        buffer.put(self.movable(axis), Move(axis, command, line, position))

    def load_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Load a move by `distance`, counted from the position at which it starts."""
        a = self.movable(axis)
        buffer.known_end(a)
        buffer.put(a, buffer.counted(a, distance, command, line))

    def load_dwell(self, axis: int, duration: float, command: str = "", line: int = 0) -> None:
        """Load a dwell of `duration` seconds into the move buffer."""
        buffer.put_action(self.movable(axis), buffer.Dwell(duration), command, line)

    def load_output(self, axis: int, values: Mapping[int, float], command: str = "", line: int = 0) -> None:
        """Load a change of outputs into the buffer; it takes no time.

        `values` maps channels to their new values.
        """
        buffer.put_action(self.movable(axis), buffer.Outputs(dict(values)), command, line)

    def load_pulse(self, axis: int, channel: int, duration: float, command: str = "", line: int = 0) -> None:
        """Load a pulse of an output for `duration` seconds; later entries do not wait."""
        buffer.put_action(self.movable(axis), buffer.Pulse(channel, duration), command, line)

    def go(self, axes: Iterable[int]) -> None:
        """Release all moves in the buffers of `axes`; idle axes start now, together."""
        for axis in axes:
            a = self.movable(axis)
            for move in a.buffer:
                if move.action is None:
                    move.released = True
                else:
                    move.action.release(move)
            if a.move is None:
                self.start_next(a)
            elif a.move.action is not None:
                a.move.action.more(self, a)

    def retarget_to(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Change the end of the move in progress to `position`.

        An axis at rest starts at once. Loaded moves keep their ends.
        """
        a = self.movable(axis)
        before = a.target
        stop.retarget(self, a, position, command, line)
        buffer.keep_ends(a, position - before)

    def retarget_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Shift the end of the move in progress by `distance`; at rest start a move."""
        self.retarget_to(axis, self.movable(axis).target + distance, command, line)

    def jog(
        self,
        axis: int,
        velocity: float,
        command: str = "",
        line: int = 0,
        rates: tuple[float | None, float | None] | None = None,
        ends: bool = False,
    ) -> None:
        """Ramp to `velocity`, counts/s, and keep it.

        With `ends`, a jog to velocity 0 is over when the axis is at rest.
        """
        a = self.movable(axis)
        jog(self, a, velocity, command, line, rates, ends)
        self.motion_listener.jogs(a, velocity)

    def play(
        self,
        axis: int,
        profile: Profile,
        command: str = "",
        line: int = 0,
        on_path: bool = False,
        step: float = 0.0,
    ) -> None:
        """Play a profile that begins at the axis's position.

        With `on_path`, a stop comes to rest on the profile. `step` is the velocity, counts/s, at which a stepper
        starts and stops abruptly; above it the rates of the axis apply.
        """
        from motionlang.kernel.controller.motion.profile_playback import Playback

        a = self.movable(axis)
        move = Move(axis, command, line, profile.end)
        move.action = playback = Playback(on_path, step)
        self.end_move(a, "retarget")
        profile = playback.waiting(self, profile) if a.suspended else profile
        self.run_profile(a, move, profile, BY_DESIGN if step else "")

    def stop(self, axis: int, ended: str = "stop", hard: bool = False) -> None:
        """Decelerate to rest at the set rate and empty the move buffer.

        A `hard` stop uses `error_decel`.
        """
        a = self.axes[axis]
        if not hard:
            stop.check_stop(self, a)
        if ended == "stop":
            events.stopped(self, a, ended, hard)
        self.motion_listener.stop(a, ended)
        self._hold(a)
        freed = conditions.release(self, a)
        if axis in self.homings:
            self.homings[axis].cancel()
        if a.move is None or a.move.action is None or not a.move.action.stop(self, a, ended, hard):
            self.empty(a, ended)
            stop.stop(self, a, ended, hard)
        self.motion_listener.heed(a)
        for each in freed:
            if each is not a and not each.suspended:
                self.start_next(each)

    def come_to_rest(self, axis: int, ended: str = "") -> None:
        """Decelerate to rest at the set rate; the move buffer stays and runs next."""
        a = self.axes[axis]
        if ended == "stop" and not a.is_at_standstill:
            events.stopped(self, a, ended)
        if ended:
            self.motion_listener.stop(a, ended)
        stop.stop(self, a, ended)

    def suspend(self, axis: int, reason: int = BY_WORD) -> None:
        """Ramp to rest and keep the moves until every reason has been removed by `resume`."""
        stop.suspend(self, self.axes[axis], reason)
        self.motion_listener.heed(self.axes[axis])

    def resume(self, axis: int, reason: int = BY_WORD) -> None:
        """Remove a reason for suspension; continue if none remains."""
        a = self.axes[axis]
        stop.resume(self, a, reason)
        if not a.suspended and a.move is None and a.buffer:
            self.start_next(a)

    def is_suspended(self, axis: int) -> bool:
        """True if the axis is suspended for any reason."""
        return self.axes[axis].suspended

    def abort(self, axis: int, ended: str = "cancel") -> None:
        """Halt at once, without a ramp, and empty the move buffer."""
        a = self.axes[axis]
        if ended == "cancel":
            events.stopped(self, a, ended)
        self.freeze(a, ended)
        self._hold(a)

    def fault(self, axis: int, bit: int, action: str) -> None:
        """Raise a fault on an axis and take `action` (one of `conditions.ACTIONS`).

        The action is taken each time; a fault that is still pending does not count as a new error.
        """
        a = self.axes[axis]
        is_new = not a.faults & bit
        if action != "ignore":
            events.raised(self, a, bit, action)
        a.faults |= bit
        if action in ("stop", "error-stop"):
            self.stop(axis, "fault", hard=action == "error-stop")
        elif action == "abort":
            self.abort(axis, "fault")
        elif action == "off":
            self.disable(axis)
        if action != "ignore":
            self.notify("fault", axis)
            if is_new:
                self.notify("error", axis)
