"""The virtual controller, with every command that a language may give it.

The verbs of single axes are in `AxisVerbs`, the verbs that only read are in `Readings`. The verbs of several
axes at once, and of functions alongside motion, are here. Each delegates to the module of its family, which
is imported when first needed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.controller import moves, readers
from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.axis_verbs import AxisVerbs
from motionlang.kernel.controller.clock import INFINITY, Clock
from motionlang.kernel.controller.motion.encoder import turn
from motionlang.kernel.controller.moves.geometry import Arc, Line
from motionlang.kernel.controller.moves.path_policy import PathPolicy
from motionlang.kernel.controller.readers import NO_SUBSCRIBER, Reader, Subscriber, Writer
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.log import Log
from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.reference import Slope

if TYPE_CHECKING:
    from motionlang.kernel.controller.motion.sampled_velocity import Track
    from motionlang.kernel.controller.moves.entries import Make, Table
    from motionlang.kernel.controller.triggers.limit import Limit


class Controller(AxisVerbs):
    """`axes` axes numbered from `first`, a clock, and the log of all events.

    Unless stated, positions and distances are in counts and times in seconds. A rejected command raises
    Rejected.
    """

    def __init__(
        self,
        axes: int = 8,
        first: int = 0,
        clock: Clock | None = None,
        log: Log | None = None,
    ) -> None:
        super().__init__(axes, first, clock or Clock(), log or Log())
        self.log.power_up(self.axes)

    # ----------------------------------------------------------------------------------- bound to an axis

    def reader(self, name: str, axis: int, unit: str = "", subscriber: Subscriber = NO_SUBSCRIBER) -> Reader:
        """Return a reader of a setting or of a verb of an axis, for repeated use.

        It returns values in `unit`: "place" is the unit of positions, "" means counts or a quantity without a unit.
        `subscriber` is notified of each reading.
        """
        return readers.reader(self, name, axis, unit, subscriber)

    def writer(self, name: str, axis: int, unit: str = "") -> Writer:
        """Return a writer of one of `SETTINGS`, for repeated use, in `unit`."""
        return readers.writer(self, name, axis, unit)

    # ------------------------------------------------------------------------------- notifications of an axis

    def follow_profiles(self, axis: int, call: Callable[[Profile], None]) -> Callable[[], None]:
        """Call `call(profile)` with each profile that an axis begins.

        The returned function ends the subscription.
        """
        followers = self.axes[axis].followers
        followers.append(call)
        return lambda: followers.remove(call)

    def warn_of_error(self, axis: int, limit: float, call: Callable[[], None]) -> None:
        """Call `call()` if the following error of a simulated motor exceeds `limit`.

        An infinite limit disables it.
        """
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.warned = call
            feedback.set_warn_limit(limit)

    def set_fault_handler(self, handles: Callable[[Rejected], bool]) -> None:
        """Set the handler of run-time faults between statements.

        `handles(rejected)` returns true if it has handled the fault.
        """
        self.fault_handler = handles

    def add_limit(self, axis: int, sign: int, bit: int, action: str, physical: bool = False) -> Limit:
        """Add a limit of an axis at the end `sign` of its travel, with no position yet.

        `bit` is the fault that it raises.
        """
        from motionlang.kernel.controller.triggers.limit import Limit

        limit = Limit(self, axis, sign, bit, action, physical)
        self.axes[axis].limits.append(limit)
        return limit

    def forget_history(self, most: int) -> None:
        """Drop all but about the last `most` log records of each kind.

        Ten times as many profiles are retained.
        """
        self.log.forget(most, self.axes.values())

    # --------------------------------------------------------------------------------------------- paths

    def load_line(
        self, axes: Sequence[int], targets: Sequence[float], command: str = "", line: int = 0
    ) -> None:
        """Load a straight line of several axes to `targets`; the first axis is the master."""
        moves.path.load_line(self, axes, targets, command, line)

    def load_line_by(
        self, axes: Sequence[int], distances: Sequence[float], command: str = "", line: int = 0
    ) -> None:
        """Load a straight line of several axes by `distances`."""
        moves.path.load_line_by(self, axes, distances, command, line)

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
        moves.path.load_arc(self, axes, centre, angle, rest, relative, command, line)

    def load_guided(
        self,
        axes: Sequence[int],
        geometry: Line | Arc,
        policy: PathPolicy,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Load a path whose speed, rates and joins are set by its policy."""
        moves.path.load_guided(self, axes, geometry, policy, command, line)

    def replan_path(self, axis: int) -> None:
        """Replan the present path of the axis with the present pace of its policy."""
        run = moves.path.run_of(self.axes[axis])
        if run is not None:
            run.replan()

    def blend(self, axis: int) -> None:
        """Begin the next path of the axis now, superposed on the rest of the present one."""
        run = moves.path.run_of(self.axes[axis])
        if run is not None:
            run.blend()

    def path_speed(self, axis: int) -> float:
        """Return the speed along the present path of the axis, user units/s."""
        run = moves.path.run_of(self.axes[axis])
        return run.present.speed if run is not None else 0.0

    # ------------------------------------------------------------------------------------------------ references

    def refer_speed(
        self,
        axis: int,
        velocity: float,
        slopes: tuple[Slope, Slope],
        error_rate: float = 0.0,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Ramp to a speed reference, counts/s, with `slopes` for speeding up and down.

        An error brakes the axis at `error_rate`.
        """
        from motionlang.kernel.controller.motion.reference import refer_speed

        refer_speed(self, self.movable(axis), velocity, slopes, error_rate, command, line)

    def refer_position(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Follow a position reference, reached within one period of the profiler."""
        from motionlang.kernel.controller.motion.reference import refer_position

        refer_position(self, self.movable(axis), position, command, line)

    def track(
        self, axis: int, decide: Callable[[], tuple[float, bool]], command: str = "", line: int = 0
    ) -> Track:
        """Let a function set the velocity of an axis, counts/s, at every profiler tick."""
        from motionlang.kernel.controller.motion.sampled_velocity import track

        return track(self, self.movable(axis), decide, command, line)

    # -------------------------------------------------------------------------------------- following a master

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
        from motionlang.kernel.controller.motion.follow import gear

        a = self.movable(axis)
        gear(self, a, self._master(master, encoder), ratio, ramp, command, line)
        self.motion_listener.gears(a, ratio)

    def set_ratio(self, axis: int, ratio: float) -> None:
        """Change the ratio of an axis that follows a master; a no-op for any other axis."""
        from motionlang.kernel.controller.motion.follow import set_ratio

        a = self.axes[axis]
        set_ratio(a, ratio)
        self.motion_listener.gears(a, ratio)

    def leave_master(self, axis: int) -> None:
        """Stop following a master; the present profile continues to its end."""
        from motionlang.kernel.controller.motion.follow import leave_master

        leave_master(self, self.axes[axis])

    def cam_index(self, axis: int) -> int:
        """Return the segment of the cam table that the axis is in; -1 if there is no cam."""
        from motionlang.kernel.controller.moves.cam import Cam

        move = self.axes[axis].move
        return move.action.index if move is not None and isinstance(move.action, Cam) else -1

    def cam_index_time(self, axis: int, index: int | None = None) -> float:
        """Return when the axis may enter or leave a segment of its cam table.

        The segment is by default the present one. INFINITY if only an event can change that.
        """
        from motionlang.kernel.controller.moves.cam import Cam

        move = self.axes[axis].move
        return (
            move.action.index_time(index) if move is not None and isinstance(move.action, Cam) else INFINITY
        )

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
        from motionlang.kernel.controller.moves.cam import load_fly

        load_fly(self, self.movable(axis), self._master(master, encoder), distance, over, command, line)

    def load_cam(
        self,
        axis: int,
        master: int,
        table: Table,
        cyclic: bool = False,
        first: int = 0,
        encoder: bool = False,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Load a cam; for every cycle `table` returns its points for the slave's position."""
        from motionlang.kernel.controller.moves.entries import load_cam

        load_cam(self, self.movable(axis), self._master(master, encoder), table, cyclic, first, command, line)

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
        from motionlang.kernel.controller.moves.entries import load_offset

        load_offset(self, self.movable(axis), distance, mode, over, command, line)

    def load_points(
        self, axis: int, make: Make, again: Make | None = None, command: str = "", line: int = 0
    ) -> None:
        """Load timed points, which `make` returns for the axis's position at their start.

        `again` returns further points each time, endlessly.
        """
        from motionlang.kernel.controller.moves.entries import load_points

        load_points(self, self.movable(axis), make, again, command, line)

    def offset_remaining(self, axis: int) -> float:
        """The remaining distance, counts, of a slave's offset or of another axis's move."""
        tie = self.axes[axis].tie
        return tie.offset_left()[0] if tie is not None else self.remaining(axis)

    def offset_crossing_time(self, axis: int, left: float) -> float:
        """Return when the remaining distance of `offset_remaining` is `left`, counts."""
        if abs(left) == INFINITY or self.master_of(axis) is None:
            return self.remaining_crossing_time(axis, left)
        from motionlang.kernel.controller.motion.offset import crossing_time

        return crossing_time(self, self.axes[axis], left)

    def offset_status(self, axis: int) -> int:
        """Return the status of the last offset, as the bits of OFFSETSTATUS."""
        return self.offset_statuses.get(axis, 0)

    def master_of(self, axis: int) -> int | None:
        """Return the axis or encoder channel that an axis follows, or None."""
        tie = self.axes[axis].tie
        return tie.master.index if tie is not None else None

    def drive_encoder(self, channel: int, velocity: float, accel: float = 0.0) -> None:
        """Ramp an encoder channel to `velocity`, counts/s, at `accel`; 0 means no ramp."""
        turn(self, self.encoder(channel), velocity, accel)

    def _master(self, number: int, encoder: bool) -> Axis:
        if encoder:
            return self.encoder(number)
        if number not in self.axes:
            raise Rejected("axis", f"there is no axis {number} to follow")
        return self.axes[number]

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

    def gain(self, axis: int, quantity: str, default: float) -> float:
        """Return a gain set by the program, or `default`."""
        return self.axes[axis].gains.get(quantity, (default,))[0]

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
            self.movable(axis)
        self.freeze(a, "cancel")
        a.feedback.open(volts)

    def close_loop(self, axis: int) -> None:
        """Resume position control of an axis at the present position of its motor."""
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.take_over(self)
