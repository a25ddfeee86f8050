"""The operations of a controller: all that a language may say to its axes, in counts and seconds.

Each finds the axis by its number and calls one function with it: `go` starts moves (`queue/life.py`), `stop` cuts them
(`queue/stop.py`), `load_line` loads a path (`moves/path.py`). If that is all, `on_axis` and its like make the operation
of the function, whose parameters and docstring it has. A rejected command raises Rejected. What can be read is in
`Readings`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from typing import Concatenate, ParamSpec, TypeVar

from motionlang.kernel.controller import power, readers, settings
from motionlang.kernel.controller import watch as watches
from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import Clock
from motionlang.kernel.controller.motion import encoder as encoders
from motionlang.kernel.controller.motion import follow, profile_playback, sampled_velocity
from motionlang.kernel.controller.motion import jog as jogging
from motionlang.kernel.controller.moves import cam, entries, path
from motionlang.kernel.controller.queue import buffer, life
from motionlang.kernel.controller.queue import stop as stopping
from motionlang.kernel.controller.queue import track as tracks
from motionlang.kernel.controller.queue.action import put_action
from motionlang.kernel.controller.queue.dwell import Dwell, Outputs, Pulse
from motionlang.kernel.controller.readers import NO_SUBSCRIBER, Reader, Subscriber, Writer
from motionlang.kernel.controller.readings import Readings
from motionlang.kernel.controller.state import ControllerState
from motionlang.kernel.controller.triggers.limit import Limit
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.log import Log
from motionlang.kernel.log.move import LoggedMove

P = ParamSpec("P")
R = TypeVar("R")
Operation = Callable[Concatenate[ControllerState, int, P], R]


def on_axis(function: Callable[Concatenate[Axis, P], R]) -> Operation[P, R]:
    """Make the operation that calls `function` with the axis of a number."""

    @wraps(function)
    def operation(self: ControllerState, axis: int, /, *values: P.args, **named: P.kwargs) -> R:
        return function(self.axes[axis], *values, **named)

    return operation


def on_movable(function: Callable[Concatenate[Axis, P], R]) -> Operation[P, R]:
    """Make the operation that calls `function` with an axis that is free to get a motion."""

    @wraps(function)
    def operation(self: ControllerState, axis: int, /, *values: P.args, **named: P.kwargs) -> R:
        a = self.axes[axis]
        life.permit_motion(a)
        return function(a, *values, **named)

    return operation


def on_axes(
    function: Callable[Concatenate[Sequence[Axis], P], R],
) -> Callable[Concatenate[ControllerState, Sequence[int], P], R]:
    """Make the operation that calls `function` with the axes of several numbers; the first is the master."""

    @wraps(function)
    def operation(self: ControllerState, axes: Sequence[int], /, *values: P.args, **named: P.kwargs) -> R:
        return function([self.axes[axis] for axis in axes], *values, **named)

    return operation


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

    # ------------------------------------------------------------------------------------------- settings

    require_idle = on_axis(life.require_idle)
    configure = on_axis(settings.configure)
    restore = on_axis(settings.restore)

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
        self.axes[axis].set_scale(counts, rate, zero)
        self.notify("scale", axis)

    def set_wrap(self, axis: int, wrap: float) -> None:
        """Set the range in which the language counts positions, user units; 0 for none."""
        self.axes[axis].scale.wrap = wrap

    define_position = on_axis(tracks.define_position)

    # ---------------------------------------------------------------------------------------- on and off

    enable = on_axis(power.enable)
    disable = on_axis(power.disable)

    fault = on_axis(power.fault)
    clear_faults = on_axis(power.clear_faults)

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

    def watch(
        self, axis: int, position: float, call: Callable[[int], None], physical: bool = False
    ) -> watches.Watch:
        """Call `call(direction)` whenever the axis passes `position`, until `unwatch`."""
        made = watches.Watch(position, call, physical)
        watches.begin(self.axes[axis], made)
        return made

    unwatch = on_axis(watches.end)

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

    load_line = on_axes(path.load_line)
    load_line_by = on_axes(path.load_line_by)
    load_arc = on_axes(path.load_arc)
    load_guided = on_axes(path.load_guided)

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
        table: cam.Table,
        cyclic: bool = False,
        first: int = 0,
        encoder: bool = False,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Load a cam; for every cycle `table` returns its points for the slave's position."""
        a = self._movable(axis)
        entries.load_cam(a, self._master(master, encoder), table, cyclic, first, command, line)

    load_offset = on_movable(entries.load_offset)
    load_points = on_movable(entries.load_points)

    def drop(self, axes: Iterable[int], command: str, line: int, ended: str) -> None:
        """Log a motion that a language had deferred and will not execute."""
        for a in [self.axes[axis] for axis in axes]:
            move = LoggedMove(a.index, command, line, a.target)
            move.ended = ended
            tracks.log_dropped(a, move)

    # ---------------------------------------------------------------------------------------------- moving

    def go(self, axes: Iterable[int]) -> None:
        """Release all moves in the buffers of `axes`; idle axes start now, together.

        If one of them cannot be moved, none starts.
        """
        for a in [self._movable(axis) for axis in axes]:
            life.go(a)

    move_to = on_movable(life.move_to)
    move_by = on_movable(life.move_by)
    retarget_to = on_movable(stopping.retarget)

    def retarget_by(self, axis: int, distance: float, command: str = "", line: int = 0) -> None:
        """Shift the end of the move in progress by `distance`; at rest start a move."""
        a = self._movable(axis)
        stopping.retarget(a, a.target + distance, command, line)

    jog = on_movable(jogging.jog)
    play = on_movable(profile_playback.play)

    def replan_path(self, axis: int) -> None:
        """Replan the present path of the axis with the present pace of its policy."""
        run = path.run_of(self.axes[axis])
        if run is not None:
            run.replan()

    track = on_movable(sampled_velocity.track)

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

    set_ratio = on_axis(follow.set_ratio)
    leave_master = on_axis(follow.leave_master)

    def _master(self, number: int, encoder: bool) -> Axis:
        if encoder:
            return self.encoder(number)
        if number not in self.axes:
            raise Rejected("axis", f"there is no axis {number} to follow")
        return self.axes[number]

    # -------------------------------------------------------------------------------------------- stopping

    stop = on_axis(stopping.stop)
    come_to_rest = on_axis(stopping.come_to_rest)
    abort = on_axis(stopping.abort)
    suspend = on_axis(stopping.suspend)
    resume = on_axis(stopping.resume)

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
        stopping.freeze(a, "cancel")
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

    def forget_text(self) -> None:
        """Forget where a text has set speeds to 0, which another one replaces."""
        for a in self.axes.values():
            a.zeroed_at = -1
