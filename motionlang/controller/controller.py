"""The virtual controller: everything a language may ask of it.

The verbs of single axes are `AxisVerbs`', those that only tell something `Readings`'; here are those of several axes at
once and of what goes on beside motion. Each is a thin door to the module of its family, brought in when first needed.
"""

from __future__ import annotations

from motionlang.controller import readers
from motionlang.controller.accelerators import NO_ACCELERATORS, Accelerators
from motionlang.controller.axis_verbs import SETTINGS, AxisVerbs
from motionlang.controller.clock import INFINITY, Clock
from motionlang.controller.faults import Refusal
from motionlang.controller.readers import UNHEARD
from motionlang.log.log import Log
from motionlang.log.moves import power_up

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from motionlang.controller.axis import Axis
    from motionlang.controller.motion.sampled_velocity import Track
    from motionlang.controller.moves.entries import Make, Table
    from motionlang.controller.moves.geometry import Arc, Line
    from motionlang.controller.moves.guide import Guide
    from motionlang.controller.readers import Hearing, Loader, Reader, Writer
    from motionlang.controller.triggers.latch import Compare, Latch
    from motionlang.controller.triggers.limit import Limit
    from motionlang.log.trace import Trace
    from motionlang.planners import Profile
    from motionlang.planners.reference import Slope


class Controller(AxisVerbs):
    """`axes` axes numbered from `first`, a clock, and the log of all that happens.

    Where nothing else is said positions and distances are counts, times seconds, and what cannot be done is a Refusal.
    """

    def __init__(
        self,
        axes: int = 8,
        first: int = 0,
        clock: Clock | None = None,
        log: Log | None = None,
        accelerators: Accelerators = NO_ACCELERATORS,
    ) -> None:
        super().__init__(axes, first, clock or Clock(), log or Log(), accelerators)
        power_up(self.log, self.axes)

    # ----------------------------------------------------------------------------------- bound to an axis

    def reader(self, name: str, axis: int, unit: str = "", hearing: Hearing = UNHEARD) -> Reader:
        """What reads a setting, or asks a verb that takes an axis, again and again; it answers in `unit`.

        "place" is the unit of positions, "" that of counts and of what has none. `hearing` is told of each reading.
        """
        return readers.reader(self, name, axis, unit, hearing)

    def writer(self, name: str, axis: int, unit: str = "") -> Writer:
        """What sets one of `SETTINGS` again and again, to values in `unit`."""
        return readers.writer(self, name, axis, unit)

    def loader(self, axis: int, relative: bool, command: str) -> Loader:
        """What loads a move quickly, to a place or by a distance, user units, for a line; false: it cannot."""
        return self.axes[axis].loader(self, relative, command)

    # ------------------------------------------------------------------------------- hearing of an axis

    def follow_profiles(self, axis: int, call: Callable[[Profile], None]) -> Callable[[], None]:
        """Call `call(profile)` with each profile that an axis begins; what is answered ends that."""
        followers = self.axes[axis].followers
        followers.append(call)
        return lambda: followers.remove(call)

    def warn_of_error(self, axis: int, limit: float, call: Callable[[], None]) -> None:
        """Call `call()` when the following error of a simulated motor has passed `limit`; infinite: never."""
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.warned = call
            feedback.set_warn_limit(limit)

    def take_mishaps(self, handles: Callable[[Refusal], bool]) -> None:
        """Have `handles(refusal)` hear of what goes wrong between statements; it answers whether that was all."""
        self.handles_mishap = handles

    def add_limit(self, axis: int, sign: int, bit: int, action: str, physical: bool = False) -> Limit:
        """A further limit of an axis at the end `sign` of its travel, with no position yet; `bit` is its fault."""
        from motionlang.controller.triggers.limit import Limit

        limit = Limit(self, axis, sign, bit, action, physical)
        self.axes[axis].limits.append(limit)
        return limit

    def forget_history(self, most: int) -> None:
        """Drop all but about the last `most` records of each kind in the log, and ten times as many profiles."""
        self.log.forget(most, self.axes.values())

    # --------------------------------------------------------------------------------------------- paths

    def load_line(
        self, axes: Sequence[int], targets: Sequence[float], command: str = "", line: int = 0
    ) -> None:
        """Put a straight line of several axes to `targets` into their buffers; the first axis is the master."""
        from motionlang.controller.moves import path

        path.load_line(self, axes, targets, command, line)

    def load_line_by(
        self, axes: Sequence[int], distances: Sequence[float], command: str = "", line: int = 0
    ) -> None:
        """Put a straight line of several axes by `distances` into their buffers."""
        from motionlang.controller.moves import path

        path.load_line_by(self, axes, distances, command, line)

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
        """Put an arc by `angle` degrees into the buffers of its axes, a helix where further axes go to `rest`."""
        from motionlang.controller.moves import path

        path.load_arc(self, axes, centre, angle, rest, relative, command, line)

    def load_guided(
        self,
        axes: Sequence[int],
        geometry: Line | Arc,
        guide: Guide,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Put a path into the buffers of its axes that goes by what its guide says of its pace and of what it joins."""
        from motionlang.controller.moves import path

        path.load_guided(self, axes, geometry, guide, command, line)

    def replan_path(self, axis: int) -> None:
        """Go on along the path that the axis is on at the pace that its guide says now."""
        from motionlang.controller.moves.path import run_of

        run = run_of(self.axes[axis])
        if run is not None:
            run.replan()

    def blend(self, axis: int) -> None:
        """Begin the next path of the axis now, on top of what remains of the present one."""
        from motionlang.controller.moves.path import run_of

        if self.orders is not None:
            self.orders.prompt(self.axes[axis], "blend")
        run = run_of(self.axes[axis])
        if run is not None:
            run.blend()

    def path_speed(self, axis: int) -> float:
        """The speed along the path that the axis is on, user units/s."""
        from motionlang.controller.moves.path import run_of

        run = run_of(self.axes[axis])
        return run.present.speed if run is not None else 0.0

    def path_remaining(self, axis: int) -> float:
        """The distance along the path that the axis is on still to go, user units."""
        from motionlang.controller.moves.path import run_of

        run = run_of(self.axes[axis])
        return run.present.remaining if run is not None else 0.0

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
        """Ramp to a speed reference, counts/s, by `slopes`, up and down; an error brakes at `error_rate`."""
        from motionlang.controller.motion.reference import refer_speed

        refer_speed(self, self.movable(axis), velocity, slopes, error_rate, command, line)

    def refer_position(self, axis: int, position: float, command: str = "", line: int = 0) -> None:
        """Follow a position reference: be there within a period of the profiler."""
        from motionlang.controller.motion.reference import refer_position

        refer_position(self, self.movable(axis), position, command, line)

    def track(
        self, axis: int, decide: Callable[[], tuple[float, bool]], command: str = "", line: int = 0
    ) -> Track:
        """Have the velocity of an axis, counts/s, decided anew at every tick of the profiler."""
        from motionlang.controller.motion.sampled_velocity import track

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
        """Follow a master, an axis or an encoder channel, at `ratio` counts a count; with `ramp` not at once."""
        from motionlang.controller.motion.follow import gear

        a = self.movable(axis)
        gear(self, a, self._master(master, encoder), ratio, ramp, command, line)
        if self.orders is not None:
            self.orders.gears(a, ratio)

    def set_ratio(self, axis: int, ratio: float) -> None:
        """Let an axis that follows a master at a ratio do so at another one; no-op for an axis that does not."""
        from motionlang.controller.motion.follow import set_ratio

        a = self.axes[axis]
        set_ratio(a, ratio)
        if self.orders is not None:
            self.orders.gears(a, ratio)

    def leave_master(self, axis: int) -> None:
        """Follow no master any more: what the axis does it goes on doing to its end."""
        from motionlang.controller.motion.follow import leave_master

        leave_master(self, self.axes[axis])

    def cam(
        self,
        axis: int,
        master: int,
        places: Sequence[float],
        values: Sequence[float],
        *,
        kind: str = "linear",
        cyclic: bool = False,
        first: int = 0,
        last: int | None = None,
        amplitude: float = 1.0,
        encoder: bool = False,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Follow a table of `values` over a master's `places`, both in counts, from where both are now."""
        from motionlang.controller.moves.cam import start_cam

        start_cam(
            self,
            self.movable(axis),
            self._master(master, encoder),
            places,
            values,
            kind=kind,
            cyclic=cyclic,
            first=first,
            last=last,
            amplitude=amplitude,
            command=command,
            line=line,
        )

    def cam_index(self, axis: int) -> int:
        """The segment of its table that a cam is in; -1 where there is no cam."""
        from motionlang.controller.moves.cam import Cam

        move = self.axes[axis].move
        return move.action.index if move is not None and isinstance(move.action, Cam) else -1

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
        """Put a segment into the buffer: `distance` while the master goes `over` counts."""
        from motionlang.controller.moves.cam import load_fly

        load_fly(self, self.movable(axis), self._master(master, encoder), distance, over, command, line)

    def offset(
        self,
        axis: int,
        distance: float,
        mode: int = 0,
        over: float = 0.0,
        command: str = "",
        line: int = 0,
    ) -> None:
        """Add a distance on top of following, in one of the modes of OFFSETMODE; at rest move by it."""
        from motionlang.controller.motion.offset import offset

        offset(self, self.movable(axis), distance, mode, over, command, line)

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
        """Put a cam into the buffer; `table` gives its points for where the slave then is, anew for every cycle."""
        from motionlang.controller.moves.entries import load_cam

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
        """Put an offset on top of following into the buffer; GO begins it while the axis goes on following."""
        from motionlang.controller.moves.entries import load_offset

        load_offset(self, self.movable(axis), distance, mode, over, command, line)

    def load_points(
        self, axis: int, make: Make, again: Make | None = None, command: str = "", line: int = 0
    ) -> None:
        """Put points at times into the buffer, made from where the axis then is; `again` follows them for ever."""
        from motionlang.controller.moves.entries import load_points

        load_points(self, self.movable(axis), make, again, command, line)

    def offset_remaining(self, axis: int) -> float:
        """What the offset of a slave, or the move of another axis, still has to do, counts."""
        from motionlang.controller.motion.follow import tie_of

        tie = tie_of(self.axes[axis])
        return tie.offset_left()[0] if tie is not None else self.remaining(axis)

    def offset_crossing_time(self, axis: int, left: float) -> float:
        """When so much is still to go of the offset of a slave, or of the move of another axis."""
        if abs(left) == INFINITY or self.master_of(axis) is None:
            return self.remaining_crossing_time(axis, left)
        from motionlang.controller.motion.offset import crossing_time

        return crossing_time(self, self.axes[axis], left)

    def offset_status(self, axis: int) -> int:
        """How the last offset went, as the bits of OFFSETSTATUS."""
        return self.offset_statuses.get(axis, 0)

    def master_of(self, axis: int) -> int | None:
        """The axis or encoder channel that an axis follows; None while it follows none."""
        from motionlang.controller.motion.follow import tie_of

        tie = tie_of(self.axes[axis])
        return tie.master.index if tie is not None else None

    def drive_encoder(self, channel: int, velocity: float, accel: float = 0.0) -> None:
        """Let the world turn an encoder channel: to `velocity`, counts/s, at `accel`, or at once where that is 0."""
        from motionlang.controller.io.encoder import turn

        turn(self, self.encoder(channel), velocity, accel)

    def _master(self, number: int, encoder: bool) -> Axis:
        if encoder:
            return self.encoder(number)
        if number not in self.axes:
            raise Refusal("axis", f"there is no axis {number} to follow")
        return self.axes[number]

    # ---------------------------------------------------------------------------------- capturing and comparing

    def latch(self, number: int) -> Latch:
        """A latch channel."""
        from motionlang.controller.triggers.latch import Latch

        found = self.latches.get(number)
        if found is None:
            found = self.latches[number] = Latch(self, number)
        return found

    def latch_on_input(
        self, number: int, axis: int, channel: int, edge: int = 1, encoder: bool = False
    ) -> None:
        """Let a latch capture a position at an edge (1 rising, -1 falling, 0 both) of a digital input."""
        self.latch(number).on_input(self._master(axis, encoder), channel, edge)

    def latch_on_index(self, number: int, axis: int) -> None:
        """Let a latch capture the position of an axis at the index marks of its encoder."""
        self.latch(number).on_index(self._master(axis, False))

    def compare(self, axis: int, output: int, low: float, high: float) -> Compare:
        """Keep a digital output on while an axis is between two positions."""
        from motionlang.controller.triggers.latch import Compare

        return Compare(self, axis, output, low, high)

    # --------------------------------------------------------------------------------------- simulated motors

    def set_servo_model(self, axis: int, model: str) -> None:
        """Say by which of `gains.MODELS` the gains of a simulated motor are meant."""
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.model = model

    def set_gain(self, axis: int, quantity: str, value: float, word: str) -> None:
        """Set a gain of the servo loop, in the unit of a language's word; a simulated motor's loop has it at once."""
        self.set_gains(axis, {**self.axes[axis].gains, quantity: (value, word)})

    def gain(self, axis: int, quantity: str, default: float) -> float:
        """A gain as the program has set it."""
        return self.axes[axis].gains.get(quantity, (default,))[0]

    def set_gains(self, axis: int, gains: Mapping[str, tuple[float, str]]) -> None:
        """The same for all gains at once, values and words: what is not named is as the program found it."""
        a = self.axes[axis]
        if a.feedback is not None:
            a.feedback.tune(gains)
        a.gains = dict(gains)

    def set_error_limit(self, axis: int, counts: float) -> None:
        """The following error, counts, beyond which an axis with a simulated motor trips; infinite for none."""
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.set_error_limit(counts)

    def settle_within(
        self, axis: int, error: float, speed: float, hold: float, at_target: bool = False
    ) -> None:
        """Say what `settled_time` goes by: following error (or distance to the target), speed, and for how long.

        Counts, counts/s and seconds.
        """
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.settle_within(error, speed, hold, at_target)

    def recall(self, axis: int, quantity: str, times: Sequence[float]) -> list[float]:
        """What was "actual" (counts), the "output" (volts) and the like of `history.COLUMNS` at rising past times."""
        a = self.axes[axis]
        if a.feedback is None:
            return [a.position(time) if quantity == "actual" else 0.0 for time in times]
        from motionlang.log.history import recall

        return recall(a, self.clock.now, quantity, times)

    def open_loop(self, axis: int, volts: float) -> None:
        """Give a simulated motor so many volts whatever it does; motion ends, and the demand stands where it is."""
        a = self.axes[axis]
        if a.feedback is None:
            raise Refusal(
                "not-simulated",
                f"axis {axis} has no simulated motor that a torque could turn",
                f"the machine file gives it one with [axis.{axis}.plant]",
            )
        if a.feedback.closed:
            self.movable(axis)
        self.freeze(a, "cancel")
        a.feedback.open(volts)

    def close_loop(self, axis: int) -> None:
        """Let an axis hold its position again, where its motor is now."""
        feedback = self.axes[axis].feedback
        if feedback is not None:
            feedback.take_over(self)

    @property
    def trace(self) -> Trace:
        """The motion so far, to be sampled; brings in numpy."""
        from motionlang.log.trace import Trace

        return Trace(self)


__all__ = ["SETTINGS", "Controller"]
