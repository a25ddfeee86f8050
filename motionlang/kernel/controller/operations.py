"""The operations of a controller: all that a language may say to its axes, in counts and seconds.

Each finds the axis by its number and calls one function with it: `go` starts moves (`queue/life.py`), `stop` cuts them
(`queue/stop.py`), `load_line` loads a path (`moves/path.py`). A rejected command raises Rejected. What can be read is
in `Readings`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from motionlang.kernel.controller import power, readers, settings
from motionlang.kernel.controller.axis import BY_WORD, Axis
from motionlang.kernel.controller.clock import INFINITY, Clock
from motionlang.kernel.controller.motion import encoder as encoders
from motionlang.kernel.controller.motion import follow, jog, profile_playback, reference, sampled_velocity
from motionlang.kernel.controller.moves import cam, entries, path
from motionlang.kernel.controller.moves.geometry import Arc, StraightLine
from motionlang.kernel.controller.moves.path_policy import PathPolicy
from motionlang.kernel.controller.queue import buffer, life, stop
from motionlang.kernel.controller.queue.action import put_action
from motionlang.kernel.controller.queue.dwell import Dwell, Outputs, Pulse
from motionlang.kernel.controller.queue.track import define_position, log_dropped
from motionlang.kernel.controller.readers import NO_SUBSCRIBER, Reader, Subscriber, Writer
from motionlang.kernel.controller.readings import Readings
from motionlang.kernel.controller.triggers.limit import Limit
from motionlang.kernel.controller.watch import Watch, begin, end
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.log import Log
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.reference import Slope


class Controller(Readings):
    """`axes` axes numbered from `first`, a clock, and the log of all events."""

    def __init__(
        self, axes: int = 8, first: int = 0, clock: Clock | None = None, log: Log | None = None
    ) -> None:
        super().__init__(axes, first, clock or Clock(), log or Log())
        self.log.power_up(self.axes)

    def _movable(self, axis: int) -> Axis:
        a = self.axes[axis]
        life.permit_motion(a)
        return a

    def require_idle(self, axis: int, command: str) -> None:
        """Raise Rejected for a command that needs the axis idle while it has a motion."""
        life.require_idle(self.axes[axis], command)

    def _all(self, axes: Iterable[int]) -> list[Axis]:
        return [self.axes[axis] for axis in axes]

    # ------------------------------------------------------------------------------------------- settings

    def configure(self, axis: int, name: str, value: object) -> None:
        """Set one of `SETTINGS`; a rate replaces its ramp time, and vice versa."""
        settings.configure(self.axes[axis], name, value)

    def restore(self, axis: int) -> None:
        """Reset all `SETTINGS` of an axis at rest to their values at power-up."""
        settings.restore(self.axes[axis])

    def reader(self, name: str, axis: int, unit: str = "", subscriber: Subscriber = NO_SUBSCRIBER) -> Reader:
        """Return a reader of a setting or of an operation of an axis, for repeated use.

        It returns values in `unit`: "place" is the unit of positions, "" means counts or a quantity without a unit.
        `subscriber` is notified of each reading.
        """
        return readers.reader(self, name, axis, unit, subscriber)

    def writer(self, name: str, axis: int, unit: str = "") -> Writer:
        """Return a writer of one of `SETTINGS`, for repeated use, in `unit`."""
        return readers.writer(self.axes[axis], name, unit)

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

    def define_position(self, axis: int, position: float) -> None:
        """Give the present position a new value; the rest of a move shifts with it."""
        define_position(self.axes[axis], position)

    # ---------------------------------------------------------------------------------------- on and off

    def enable(self, axis: int) -> None:
        """Enable an axis where it is.

        Target, commanded and actual position become equal; faults are cleared.
        """
        power.enable(self.axes[axis])

    def disable(self, axis: int) -> None:
        """Disable an axis.

        Its commanded position stays, and so does the axis itself unless a simulated motor coasts.
        """
        power.disable(self.axes[axis])

    def set_brake(self, axis: int, on: bool) -> None:
        """Apply or release the brake of an axis without informing its drive."""
        self.axes[axis].is_braked = on

    def fault(self, axis: int, bit: int, action: str) -> None:
        """Raise a fault on an axis and take `action` (one of `conditions.ACTIONS`).

        The action is taken each time; a fault that is still pending does not count as a new error.
        """
        power.fault(self.axes[axis], bit, action)

    def clear_faults(self, axis: int) -> None:
        power.clear_faults(self.axes[axis])

    def lock(self, axis: int, faults: int) -> None:
        """Set the faults that prevent motion of an axis."""
        self.axes[axis].locks = faults

    # -------------------------------------------------------------------------- switches, limits, positions

    def set_home_switch(self, axis: int, on: bool) -> None:
        """Close or open the home switch of an axis from outside."""
        self.axes[axis].is_at_home = on
        self.notify("home", axis)

    def add_limit(self, axis: int, sign: int, bit: int, action: str, physical: bool = False) -> Limit:
        """Add a limit of an axis at the end `sign` of its travel, with no position yet.

        `bit` is the fault that it raises.
        """
        limit = Limit(self.axes[axis], sign, bit, action, physical)
        self.axes[axis].limits.append(limit)
        return limit

    def set_limit_action(self, axis: int, bit: int, action: str) -> None:
        """Set the action of those limits of an axis that raise the fault `bit`."""
        for limit in self.axes[axis].limits:
            if limit.bit == bit:
                limit.action = action

    def watch(self, axis: int, position: float, call: Callable[[int], None], physical: bool = False) -> Watch:
        """Call `call(direction)` whenever the axis passes `position`, until `unwatch`."""
        made = Watch(position, call, physical)
        begin(self.axes[axis], made)
        return made

    def unwatch(self, axis: int, watch: Watch) -> None:
        """End a watch."""
        end(self.axes[axis], watch)

    # --------------------------------------------------------------------------------------------- loading

    def load_to(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Load a move to `position` into the move buffer."""
        buffer.put(self._movable(axis), LoggedMove(axis, command, line, position))

    def load_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Load a move by `distance`, counted from the position at which it starts."""
        a = self._movable(axis)
        buffer.known_end(a)
        buffer.put(a, buffer.counted(a, distance, command, line))

    def load_dwell(self, axis: int, duration: float, command: str = "", line: int = 0) -> None:
        """Load a dwell of `duration` seconds into the move buffer."""
        put_action(self._movable(axis), Dwell(duration), command, line)

    def load_output(self, axis: int, values: Mapping[int, float], command: str = "", line: int = 0) -> None:
        """Load a change of outputs into the buffer; it takes no time.

        `values` maps channels to their new values.
        """
        put_action(self._movable(axis), Outputs(dict(values)), command, line)

    def load_pulse(self, axis: int, channel: int, duration: float, command: str = "", line: int = 0) -> None:
        """Load a pulse of an output for `duration` seconds; later entries do not wait."""
        put_action(self._movable(axis), Pulse(channel, duration), command, line)

    def load_line(
        self, axes: Sequence[int], targets: Sequence[float], command: str = "", line: int = 0
    ) -> None:
        """Load a straight line of several axes to `targets`; the first axis is the master."""
        path.load_line(self._all(axes), targets, command, line)

    def load_line_by(
        self, axes: Sequence[int], distances: Sequence[float], command: str = "", line: int = 0
    ) -> None:
        """Load a straight line of several axes by `distances`."""
        path.load_line_by(self._all(axes), distances, command, line)

    def load_arc(
        self,
        axes: Sequence[int],
        centre: Sequence[float],
        angle: float,
        rest: Sequence[float] = (),
        relative: bool = False,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Load an arc by `angle` degrees, or a helix if further axes move to `rest`."""
        path.load_arc(self._all(axes), centre, angle, rest, relative, command, line)

    def load_guided(
        self,
        axes: Sequence[int],
        geometry: StraightLine | Arc,
        policy: PathPolicy,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Load a path whose speed, rates and joins are set by its policy."""
        path.load_guided(self._all(axes), geometry, policy, command, line)

    def load_fly(
        self,
        axis: int,
        master: int,
        distance: float,
        over: float,
        encoder: bool = False,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Load a fly segment: `distance` while the master travels `over` counts."""
        cam.load_fly(self._movable(axis), self._master(master, encoder), distance, over, command, line)

    def load_cam(
        self,
        axis: int,
        master: int,
        table: entries.Table,
        cyclic: bool = False,
        first: int = 0,
        encoder: bool = False,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Load a cam; for every cycle `table` returns its points for the slave's position."""
        a = self._movable(axis)
        entries.load_cam(a, self._master(master, encoder), table, cyclic, first, command, line)

    def load_offset(
        self,
        axis: int,
        distance: float,
        mode: int = 0,
        over: float = 0.0,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Load an offset to be superposed on following; GO starts it during following."""
        entries.load_offset(self._movable(axis), distance, mode, over, command, line)

    def load_points(
        self,
        axis: int,
        make: entries.Make,
        again: entries.Make | None = None,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Load timed points, which `make` returns for the axis's position at their start.

        `again` returns further points each time, endlessly.
        """
        entries.load_points(self._movable(axis), make, again, command, line)

    def drop(self, axes: Iterable[int], command: str, line: int, ended: str) -> None:
        """Log a motion that a language had deferred and will not execute."""
        for a in self._all(axes):
            move = LoggedMove(a.index, command, line, a.target)
            move.ended = ended
            log_dropped(a, move)

    # ---------------------------------------------------------------------------------------------- moving

    def go(self, axes: Iterable[int]) -> None:
        """Release all moves in the buffers of `axes`; idle axes start now, together.

        If one of them cannot be moved, none starts.
        """
        for a in [self._movable(axis) for axis in axes]:
            life.go(a)

    def move_to(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Move to `position` now, from any state of motion."""
        life.move_to(self._movable(axis), position, command, line)

    def move_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Move by `distance` now, from the present target, if any, or from the position."""
        life.move_by(self._movable(axis), distance, command, line)

    def retarget_to(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Change the end of the move in progress to `position`.

        An axis at rest starts at once. Loaded moves keep their ends.
        """
        stop.retarget(self._movable(axis), position, command, line)

    def retarget_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Shift the end of the move in progress by `distance`; at rest start a move."""
        a = self._movable(axis)
        stop.retarget(a, a.target + distance, command, line)

    def jog(
        self,
        axis: int,
        velocity: float,
        command: str = "",
        line: int = 0,
        rates: jog.Rates | None = None,
        ends: bool = False,
    ) -> None:
        """Ramp to `velocity`, counts/s, and keep it.

        With `ends`, a jog to velocity 0 is over when the axis is at rest.
        """
        jog.jog(self._movable(axis), velocity, command, line, rates, ends)

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
        profile_playback.play(self._movable(axis), profile, command, line, on_path, step)

    def replan_path(self, axis: int) -> None:
        """Replan the present path of the axis with the present pace of its policy."""
        run = path.run_of(self.axes[axis])
        if run is not None:
            run.replan()

    def blend(self, axis: int) -> None:
        """Begin the next path of the axis now, superposed on the rest of the present one."""
        run = path.run_of(self.axes[axis])
        if run is not None:
            run.blend()

    def refer_speed(
        self,
        axis: int,
        velocity: float,
        slopes: tuple[Slope, Slope],
        error_rate: float = 0.0,
        command: str = "",
        line: int = 0,
        most: float = INFINITY,
    ) -> None:
        """Ramp to a speed reference, counts/s, at most `most`, with `slopes` for speeding up and down.

        An error brakes the axis at `error_rate`.
        """
        reference.refer_speed(self._movable(axis), velocity, slopes, error_rate, command, line, most)

    def refer_position(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Follow a position reference, reached within one period of the profiler."""
        reference.refer_position(self._movable(axis), position, command, line)

    def track(
        self, axis: int, decide: Callable[[], tuple[float, bool]], command: str = "", line: int = 0
    ) -> sampled_velocity.SampledVelocity:
        """Let a function set the velocity of an axis, counts/s, at every profiler tick."""
        return sampled_velocity.track(self._movable(axis), decide, command, line)

    def gear(
        self,
        axis: int,
        master: int,
        ratio: float,
        ramp: bool = False,
        encoder: bool = False,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Follow a master, an axis or an encoder channel, at `ratio` counts per count.

        With `ramp` the slave first ramps to the velocity of the master times `ratio`.
        """
        follow.gear(self._movable(axis), self._master(master, encoder), ratio, ramp, command, line)

    def set_ratio(self, axis: int, ratio: float) -> None:
        """Change the ratio of an axis that follows a master; a no-op for any other axis."""
        follow.set_ratio(self.axes[axis], ratio)

    def leave_master(self, axis: int) -> None:
        """Stop following a master; the present profile continues to its end."""
        follow.leave_master(self.axes[axis])

    def _master(self, number: int, encoder: bool) -> Axis:
        if encoder:
            return self.encoder(number)
        if number not in self.axes:
            raise Rejected("axis", f"there is no axis {number} to follow")
        return self.axes[number]

    # -------------------------------------------------------------------------------------------- stopping

    def stop(self, axis: int, ended: str = "stop", hard: bool = False) -> None:
        """Decelerate to rest at the set rate and empty the move buffer.

        A `hard` stop uses `error_decel`.
        """
        stop.stop(self.axes[axis], ended, hard)

    def come_to_rest(self, axis: int, ended: str = "") -> None:
        """Decelerate to rest at the set rate; the move buffer stays and runs next."""
        stop.come_to_rest(self.axes[axis], ended)

    def abort(self, axis: int, ended: str = "cancel") -> None:
        """Halt at once, without a ramp, and empty the move buffer."""
        stop.abort(self.axes[axis], ended)

    def suspend(self, axis: int, reason: int = BY_WORD) -> None:
        """Ramp to rest and keep the moves until every reason has been removed by `resume`."""
        stop.suspend(self.axes[axis], reason)

    def resume(self, axis: int, reason: int = BY_WORD) -> None:
        """Remove a reason for suspension; continue if none remains."""
        stop.resume(self.axes[axis], reason)

    # -------------------------------------------------------------------------------------------- channels

    def set_output(self, channel: int, value: float) -> bool:
        """Set an output; return True if that changed it."""
        return self.outputs.set(channel, value)

    def set_analogue_output(self, channel: int, value: float) -> None:
        self.analogue_outputs[channel] = value

    def drive_encoder(self, channel: int, velocity: float, accel: float = 0.0) -> None:
        """Ramp an encoder channel to `velocity`, counts/s, at `accel`; 0 means no ramp."""
        encoders.turn(self.encoder(channel), velocity, accel)

    # --------------------------------------------------------------------------------------- simulated motors

    def set_servo_model(self, axis: int, model: str) -> None:
        """Select the entry of `gains.MODELS` that defines the gains of a simulated motor."""
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.model = model

    def set_gain(self, axis: int, quantity: str, value: float, word: str) -> None:
        """Set a gain of the servo loop, in the unit of a language's keyword, at once.

        `word` is that keyword.
        """
        self.set_gains(axis, {**self.axes[axis].gains, quantity: (value, word)})

    def set_gains(self, axis: int, gains: Mapping[str, tuple[float, str]]) -> None:
        """Set all gains at once; omitted ones are reset.

        `gains` maps each quantity to its value and keyword.
        """
        a = self.axes[axis]
        if a.feedback is not None:
            a.feedback.tune(gains)
        a.gains = dict(gains)

    def set_error_limit(self, axis: int, counts: float) -> None:
        """Set the following error, counts, that trips an axis with a simulated motor.

        Infinity disables it.
        """
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.set_error_limit(counts)

    def settle_within(
        self, axis: int, error: float, speed: float, hold: float, at_target: bool = False
    ) -> None:
        """Set the window in which an axis counts as settled, for `settled_time`.

        `error` is the following error, or with `at_target` the distance to the target, in counts; `speed` is in
        counts/s, and `hold` in seconds.
        """
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.settle_within(error, speed, hold, at_target)

    def open_loop(self, axis: int, volts: float) -> None:
        """Apply a voltage to a simulated motor; motion ends at the commanded position."""
        a = self.axes[axis]
        if a.feedback is None:
            raise Rejected(
                "not-simulated",
                f"axis {axis} has no simulated motor that a torque could turn",
                f"the machine file gives it one with [axis.{axis}.plant]",
            )
        if a.feedback.closed:
            life.permit_motion(a)
        stop.freeze(a, "cancel")
        a.feedback.open(volts)

    def close_loop(self, axis: int) -> None:
        """Resume position control of an axis at the present position of its motor."""
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.take_over()

    # -------------------------------------------------------------------------------------- subscriptions

    def set_fault_handler(self, handles: Callable[[Rejected], bool]) -> None:
        """Set the handler of run-time faults between statements.

        `handles(rejected)` returns true if it has handled the fault.
        """
        self.fault_handler = handles

    def forget_history(self, most: int) -> None:
        """Drop all but about the last `most` log records of each kind.

        Ten times as many profiles are retained.
        """
        self.log.forget(most, self.axes.values())
