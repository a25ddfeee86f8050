"""What a controller has and what can be read off it: axes, channels, the clock, and watches that tell of motion."""

from __future__ import annotations

from math import atan2, degrees

from motionlang.controller import triggers
from motionlang.controller.axis import Axis
from motionlang.controller.clock import INFINITY, Clock
from motionlang.controller.io.inputs import Channels
from motionlang.controller.listeners import Listeners

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.accelerators import Accelerators
    from motionlang.controller.clock import Event
    from motionlang.controller.faults import Refusal
    from motionlang.controller.triggers.conditions import Condition
    from motionlang.controller.triggers.homing import Homing
    from motionlang.controller.triggers.latch import Latch
    from motionlang.controller.triggers.watch import Watch
    from motionlang.log.log import Log
    from motionlang.log.orders import Orders


class Readings:
    """`axes` axes numbered from `first`, channels, a clock, and the log of all that happens.

    Positions are counts, velocities counts/s, times seconds of the clock; KeyError for an axis that there is not.
    """

    def __init__(self, axes: int, first: int, clock: Clock, log: Log, accelerators: Accelerators) -> None:
        self.clock = clock
        self.accelerators = accelerators
        numbers = range(first, first + axes)
        made = (
            [Axis(number) for number in numbers] if accelerators.axes is None else accelerators.axes(numbers)
        )
        self.axes: dict[int, Axis] = dict(zip(numbers, made, strict=True))
        self.log = log
        self.inputs = Channels(clock, log.inputs)
        self.outputs = Channels(clock, log.outputs)
        self.analogue_inputs = Channels(clock, log.analogue_inputs)
        self.analogue_outputs = Channels(clock, log.analogue_outputs)
        # The events at which pulses of outputs end.
        self._pulses: dict[int, Event] = {}
        # Encoder channels that the world turns, such as that of a conveyor; they have tracks like axes.
        self.encoders: dict[int, Axis] = {}
        self.latches: dict[int, Latch] = {}
        # The homings in progress by axis: such an axis is theirs alone, and what its buffer holds waits for their end.
        self.homings: dict[int, Homing] = {}
        # The inputs without which the drives of axes cannot be enabled.
        self.interlocks: dict[int, int] = {}
        # The axes whose brakes somebody has set by hand, and those whose home switches are closed.
        self.braked: set[int] = set()
        self.at_home: set[int] = set()
        # The axes that one word has suspended together, by each of them.
        self.suspended_with: dict[int, tuple[Axis, ...]] = {}
        # How the last offset of an axis went, bits (`motion/offset.py`).
        self.offset_statuses: dict[int, int] = {}
        self.listeners = Listeners()
        # The conditions to be looked at when all axes of a motion have it; None where they are at once.
        self.looks_later: list[Condition] | None = None
        # What is kept of a run that is to be proved.
        self.orders: Orders | None = None
        # Told of what goes wrong while the program does something else; answers whether that was all.
        self.handles_mishap: Callable[[Refusal], bool] | None = None

    def moving(self) -> list[int]:
        """The axes that are not idle; of those that follow a master only the ones that move."""
        found = []
        for number, axis in self.axes.items():
            if not axis.stands:
                found.append(number)
        return found

    def settling(self) -> list[int]:
        """The idle axes whose simulated motors have not come to rest yet."""
        motors = [(number, a.feedback) for number, a in self.axes.items() if a.move is None]
        return [number for number, feedback in motors if feedback is not None and not feedback.resting]

    def rest_time(self, axis: int) -> float:
        """When the motor of an idle axis will be at rest, or when to look again."""
        feedback = self.axes[axis].feedback
        return self.clock.now if feedback is None else feedback.settled_time()

    # ------------------------------------------------------------------------------------------- reading

    def position(self, axis: int) -> float:
        """The actual position: that of the simulated motor, without one the demand."""
        a = self.axes[axis]
        return a.here(self.clock.now) if a.feedback is None else a.feedback.position

    def velocity(self, axis: int) -> float:
        """The actual velocity: that of the simulated motor, without one the demand."""
        a = self.axes[axis]
        return a.velocity(self.clock.now) if a.feedback is None else a.feedback.velocity

    def demand(self, axis: int) -> float:
        """The demanded position."""
        return self.axes[axis].here(self.clock.now)

    def demand_velocity(self, axis: int) -> float:
        """The demanded velocity."""
        return self.axes[axis].velocity(self.clock.now)

    def following_error(self, axis: int) -> float:
        """Demanded minus actual position: 0 without a simulated motor."""
        feedback = self.axes[axis].feedback
        return 0.0 if feedback is None else feedback.error

    def servo_output(self, axis: int) -> float:
        """The output to a simulated motor, volts; 0 without one."""
        feedback = self.axes[axis].feedback
        return 0.0 if feedback is None else feedback.output

    def motor_current(self, axis: int) -> float:
        """The current of a simulated motor, A; 0 without one."""
        feedback = self.axes[axis].feedback
        return 0.0 if feedback is None else feedback.current

    def settled_time(self, axis: int) -> float:
        """When an axis has settled as `settle_within` says, or when to look again; infinite where it never does."""
        feedback = self.axes[axis].feedback
        return self.clock.now if feedback is None else feedback.settled_time("program")

    def settled_since(self, axis: int) -> float:
        """The time from which on an axis has been as `settle_within` says; infinite where it is not."""
        feedback = self.axes[axis].feedback
        return 0.0 if feedback is None else feedback.settled_since()

    def has_motor(self, axis: int) -> bool:
        """Whether the axis has a simulated motor."""
        return self.axes[axis].feedback is not None

    def is_open(self, axis: int) -> bool:
        """Whether a simulated motor runs without its loop."""
        feedback = self.axes[axis].feedback
        return feedback is not None and not feedback.closed

    def is_still(self, axis: int) -> bool:
        """Whether the axis stands, and its motor, where one is simulated, for good."""
        a = self.axes[axis]
        return a.stands and (a.feedback is None or a.feedback.calm)

    def target(self, axis: int) -> float:
        return self.axes[axis].target

    def remaining(self, axis: int) -> float:
        """The distance still to go in the present move, signed; 0 at rest."""
        a = self.axes[axis]
        if a.move is None or a.target == INFINITY:
            return 0.0
        return a.target - a.position(self.clock.now)

    def move_id(self, axis: int) -> int:
        """The mark of the move in progress, or of the last one."""
        return self.axes[axis].last_id

    def vector_angle(self, x: int, y: int) -> float:
        """The direction, degrees, in which two axes are moving in their plane, in user units; 0 at rest."""
        now = self.clock.now
        across = [a.velocity(now) / a.scale.counts for a in (self.axes[x], self.axes[y])]
        return degrees(atan2(across[1], across[0])) if any(across) else 0.0

    def is_enabled(self, axis: int) -> bool:
        return self.axes[axis].enabled

    def may_enable(self, axis: int) -> bool:
        """Whether the enable input of the axis, where it has one, is on."""
        channel = self.interlocks.get(axis)
        return channel is None or self.inputs.inverted(channel)

    def is_idle(self, axis: int) -> bool:
        return not self.axes[axis].moves

    def is_on_home_switch(self, axis: int) -> bool:
        return axis in self.at_home

    def faults(self, axis: int) -> int:
        return self.axes[axis].faults

    def idle_time(self, axis: int) -> float:
        """The time at which the axis will be idle if nothing else happens; infinite while it jogs."""
        a = self.axes[axis]
        return a.end_of_motion() if a.moves else self.clock.now

    def end_of_moves(self, axes: tuple[int, ...]) -> Callable[[], float]:
        """The reader of the time at which all of some axes will be idle; it answers -1 where they are."""
        ends = [self.axes[axis].end_of_move for axis in axes]
        return ends[0] if len(ends) == 1 else lambda: max([end() for end in ends], default=-1.0)

    def stands(self, axis: int) -> bool:
        """Whether the axis is idle, or follows what stands."""
        return self.axes[axis].stands

    def standing_time(self, axis: int) -> float:
        """The time at which the axis will stand, be it idle or not, if nothing else happens."""
        a = self.axes[axis]
        return self.clock.now if a.stands else a.end_of_motion()

    def crossing_time(self, axis: int, position: float) -> float:
        """The time at which the axis will pass `position`, infinite if the present motion never does.

        Where `position` is infinite: the time at which it turns round, now where it stands.
        Of a simulated motor as far as can be seen; beyond that the time to look again.
        """
        feedback = self.axes[axis].feedback
        if feedback is None:
            return self.demand_crossing_time(axis, position)
        return self.clock.now if abs(position) == INFINITY else feedback.crossing_time(position)

    def error_crossing_time(self, axis: int, error: float) -> float:
        """The time at which the following error of an axis passes `error`, as `crossing_time`."""
        if abs(error) == INFINITY:
            return self.clock.now
        feedback = self.axes[axis].feedback
        return INFINITY if feedback is None else feedback.error_crossing_time(error)

    def demand_crossing_time(self, axis: int, position: float) -> float:
        """The same of the demanded position."""
        return self._crossing_time(self.axes[axis], position)

    def encoder_crossing_time(self, channel: int, position: float) -> float:
        """The same of an encoder channel that the world turns."""
        return self._crossing_time(self.encoder(channel), position)

    def _crossing_time(self, a: Axis, position: float) -> float:
        start, profile = a.starts[-1], a.profiles[-1]
        elapsed = self.clock.now - start
        if abs(position) == INFINITY:
            found = profile.velocity_crossing(0.0, elapsed) if a.velocity(self.clock.now) else elapsed
        elif profile.duration == INFINITY and profile.start == profile.end and not profile.peak_speed:
            return INFINITY  # it rests, as a slave whose master does: it passes nothing, not even where it is
        else:
            found = profile.crossing(position, elapsed)
        return INFINITY if found is None else start + found

    def remaining_crossing_time(self, axis: int, left: float) -> float:
        """When so much of the present move is still to go; now where `left` is infinite."""
        return (
            self.clock.now
            if abs(left) == INFINITY
            else self.demand_crossing_time(axis, self.target(axis) - left)
        )

    def velocity_crossing_time(self, axis: int, velocity: float) -> float:
        """When the velocity will next be `velocity`, as `demand_velocity_crossing_time`; now of a simulated motor."""
        if self.has_motor(axis):
            return self.clock.now
        return self.demand_velocity_crossing_time(axis, velocity)

    def demand_velocity_crossing_time(self, axis: int, velocity: float) -> float:
        """When the demanded velocity will next be `velocity`, or stop to rise or fall as it does; at knots the latest.

        Now where the profile is no cubic.
        """
        a, now = self.axes[axis], self.clock.now
        start, profile = a.starts[-1], a.profiles[-1]
        elapsed = now - start
        if elapsed >= profile.duration:
            return INFINITY
        piece = profile.cubic(elapsed)
        if piece is None:
            return now
        since, until, (_, _, c2, c3) = piece
        if not c2 and not c3:
            return now if abs(velocity) == INFINITY else start + until
        if c3 and elapsed < since - c2 / (3.0 * c3) < until:
            until = since - c2 / (3.0 * c3)
        found = profile.velocity_crossing(velocity, elapsed)
        return start + (until if found is None else min(found, until))

    def turns(self, channel: int) -> bool:
        """Whether an encoder channel is being turned."""
        a = self.encoder(channel)
        profile = a.profiles[-1]
        over = self.clock.now - a.starts[-1] >= profile.duration
        return bool(profile.end_velocity if over else profile.peak_speed)

    def watch(self, axis: int, position: float, call: Callable[[int], None], physical: bool = False) -> Watch:
        """Call `call(direction)` whenever the axis passes `position`, until `unwatch`."""
        a = self.axes[axis]
        watch = triggers.watch.Watch(position, call, physical)
        a.watches.append(watch)
        triggers.watch.arm(a, watch, self.clock, self.clock.now)
        return watch

    def unwatch(self, axis: int, watch: Watch) -> None:
        """End a watch."""
        self.axes[axis].watches.remove(watch)

    def input(self, channel: int) -> float:
        return self.inputs[channel]

    def output(self, channel: int) -> float:
        return self.outputs[channel]

    def encoder(self, channel: int) -> Axis:
        """The track of an encoder channel that the world turns."""
        found = self.encoders.get(channel)
        if found is None:
            found = self.encoders[channel] = Axis(channel)
        return found

    def encoder_position(self, channel: int) -> float:
        """The position of an encoder channel, counts."""
        return self.encoder(channel).position(self.clock.now)

    def encoder_velocity(self, channel: int) -> float:
        """The velocity of an encoder channel, counts/s."""
        return self.encoder(channel).velocity(self.clock.now)

    def set_output(self, channel: int, value: float) -> None:
        self.outputs[channel] = value

    def pulse(self, channel: int, duration: float) -> None:
        """Turn a digital output on, and off again after `duration` seconds; a second pulse meanwhile prolongs it."""
        due = self._pulses.get(channel)
        if due is not None:
            due.cancel()
        self.outputs[channel] = 1
        end = self.clock.now + duration
        self._pulses[channel] = self.clock.at(end, lambda: self.outputs.__setitem__(channel, 0))

    def analogue_input(self, channel: int) -> float:
        return self.analogue_inputs[channel]

    def set_analogue_output(self, channel: int, value: float) -> None:
        self.analogue_outputs[channel] = value

    def mishap(self, refusal: Refusal) -> None:
        """Something cannot be done that no statement asks for now: the program handles it, or ends with it."""
        if self.handles_mishap is None or not self.handles_mishap(refusal):
            raise refusal

    def tell(self, what: str, axis: int) -> None:
        """Let the listeners know; a listener may leave while it is told."""
        self.listeners.tell(what, axis)
