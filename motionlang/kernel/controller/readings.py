"""State of a controller, its readings, and watches of motion."""

from __future__ import annotations

from collections.abc import Callable
from math import atan2, degrees
from typing import TYPE_CHECKING

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY, Clock, Event
from motionlang.kernel.controller.io.channels import AnalogueInputs, Channels
from motionlang.kernel.controller.listeners import Listeners
from motionlang.kernel.controller.motion_listener import MotionListener
from motionlang.kernel.controller.watch import Watch, begin, end
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.log import Log

if TYPE_CHECKING:
    from motionlang.kernel.controller.triggers.conditions import Condition
    from motionlang.kernel.controller.triggers.homing import Homing


class Readings:
    """The readable state: `axes` axes numbered from `first`, channels, clock, and log.

    Positions are counts, velocities counts/s, times seconds of the clock. An axis that does not exist raises
    KeyError.
    """

    def __init__(self, axes: int, first: int, clock: Clock, log: Log) -> None:
        self.clock = clock
        self.axes: dict[int, Axis] = {number: Axis(number) for number in range(first, first + axes)}
        self.log = log
        self.inputs = Channels(clock, log.inputs)
        self.outputs = Channels(clock, log.outputs, log.here)
        self.analogue_inputs = AnalogueInputs(clock, log)
        self.analogue_outputs = Channels(clock, log.analogue_outputs, log.here)
        # The events at which pulses of outputs end.
        self._pulses: dict[int, Event] = {}
        # Encoder channels driven from outside, such as that of a conveyor; they have tracks like axes.
        self.encoders: dict[int, Axis] = {}
        # The homings in progress by axis. They control their axis alone; its buffer waits for their end.
        self.homings: dict[int, Homing] = {}
        # The inputs that must be on before the drives of axes can be enabled.
        self.interlocks: dict[int, int] = {}
        # The axes whose brakes were set by hand, and those whose home switches are closed.
        self.braked: set[int] = set()
        self.at_home: set[int] = set()
        # The axes suspended together by one keyword, by axis.
        self.suspended_with: dict[int, tuple[Axis, ...]] = {}
        # Where the program last set the speed of an axis to 0, source offsets.
        self.zeroed: dict[int, int] = {}
        # The status of the last offset of an axis, bits (`motion/offset.py`).
        self.offset_statuses: dict[int, int] = {}
        self.listeners = Listeners()
        # The conditions to check once all axes of a motion have their profiles; None to check at once.
        self.deferred_checks: list[Condition] | None = None
        # It is notified of verbs, profiles and settings as they happen.
        self.motion_listener = MotionListener()
        # The handler of run-time faults outside a statement; it returns true if it has handled the fault.
        self.fault_handler: Callable[[Rejected], bool] | None = None

    def moving(self) -> list[int]:
        """Return the axes that are not idle; slaves only while they move."""
        found = []
        for number, axis in self.axes.items():
            if not axis.is_at_standstill:
                found.append(number)
        return found

    def settling(self) -> list[int]:
        """Return the idle axes whose simulated motors have not come to rest yet."""
        motors = [(number, a.feedback) for number, a in self.axes.items() if a.move is None]
        return [number for number, feedback in motors if feedback is not None and not feedback.resting]

    def rest_time(self, axis: int) -> float:
        """Return when the motor of an idle axis will be at rest, or when to check again."""
        feedback = self.axes[axis].feedback
        return self.clock.now if feedback is None else feedback.settled_time()

    # ------------------------------------------------------------------------------------------- reading

    def position(self, axis: int) -> float:
        """Return the actual position: the simulated motor's, or the commanded one."""
        a = self.axes[axis]
        return a.here(self.clock.now) if a.feedback is None else a.feedback.position

    def velocity(self, axis: int) -> float:
        """Return the actual velocity: the simulated motor's, or the commanded one."""
        a = self.axes[axis]
        return a.velocity(self.clock.now) if a.feedback is None else a.feedback.velocity

    def demand(self, axis: int) -> float:
        """Return the commanded position."""
        return self.axes[axis].here(self.clock.now)

    def demand_velocity(self, axis: int) -> float:
        """Return the commanded velocity."""
        return self.axes[axis].velocity(self.clock.now)

    def following_error(self, axis: int) -> float:
        """Return commanded minus actual position: 0 without a simulated motor."""
        feedback = self.axes[axis].feedback
        return 0.0 if feedback is None else feedback.error

    def servo_output(self, axis: int) -> float:
        """Return the output to a simulated motor, volts; 0 without one."""
        feedback = self.axes[axis].feedback
        return 0.0 if feedback is None else feedback.output

    def motor_current(self, axis: int) -> float:
        """Return the current of a simulated motor, A; 0 without one."""
        feedback = self.axes[axis].feedback
        return 0.0 if feedback is None else feedback.current

    def settled_time(self, axis: int) -> float:
        """Return when an axis has settled by `settle_within`, or when to check again.

        It is infinite if the axis never settles.
        """
        feedback = self.axes[axis].feedback
        return self.clock.now if feedback is None else feedback.settled_time("program")

    def settled_since(self, axis: int) -> float:
        """Return since when an axis has been within the window of `settle_within`.

        It is infinite while the axis is outside.
        """
        feedback = self.axes[axis].feedback
        return 0.0 if feedback is None else feedback.settled_since()

    def has_motor(self, axis: int) -> bool:
        """True if the axis has a simulated motor."""
        return self.axes[axis].feedback is not None

    def is_open(self, axis: int) -> bool:
        """True if a simulated motor runs in open loop."""
        feedback = self.axes[axis].feedback
        return feedback is not None and not feedback.closed

    def is_still(self, axis: int) -> bool:
        """True if the axis and its simulated motor, if any, are at standstill for good."""
        a = self.axes[axis]
        return a.is_at_standstill and (a.feedback is None or a.feedback.at_standstill)

    def target(self, axis: int) -> float:
        return self.axes[axis].target

    def remaining(self, axis: int) -> float:
        """Return the remaining distance of the present move, signed; 0 at rest."""
        a = self.axes[axis]
        if a.move is None or a.target == INFINITY:
            return 0.0
        return a.target - a.position(self.clock.now)

    def move_id(self, axis: int) -> int:
        """Return the identifier of the move in progress, or of the last one."""
        return self.axes[axis].last_id

    def vector_angle(self, x: int, y: int) -> float:
        """Return the direction of motion of two axes in their plane, degrees; 0 at rest.

        The direction is that of the velocities in user units.
        """
        now = self.clock.now
        across = [a.velocity(now) / a.scale.counts for a in (self.axes[x], self.axes[y])]
        return degrees(atan2(across[1], across[0])) if any(across) else 0.0

    def is_enabled(self, axis: int) -> bool:
        return self.axes[axis].enabled

    def may_enable(self, axis: int) -> bool:
        """True if the axis has no enable input, or the input is on."""
        channel = self.interlocks.get(axis)
        return channel is None or self.inputs.inverted(channel)

    def is_idle(self, axis: int) -> bool:
        return not self.axes[axis].moves

    def is_on_home_switch(self, axis: int) -> bool:
        return axis in self.at_home

    def faults(self, axis: int) -> int:
        return self.axes[axis].faults

    def idle_time(self, axis: int) -> float:
        """Return when the axis will be idle if nothing else happens; infinite in a jog."""
        a = self.axes[axis]
        return a.end_of_motion() if a.moves else self.clock.now

    def end_of_moves(self, axes: tuple[int, ...]) -> Callable[[], float]:
        """Return a reader of the time when all given axes will be idle; -1 if they are."""
        ends = [self.axes[axis].end_of_move for axis in axes]
        return ends[0] if len(ends) == 1 else lambda: max([end() for end in ends], default=-1.0)

    def is_at_standstill(self, axis: int) -> bool:
        """True if the axis is idle, or follows a master that is at standstill."""
        return self.axes[axis].is_at_standstill

    def standstill_time(self, axis: int) -> float:
        """Return when the axis will be at rest, idle or not, if nothing else happens."""
        a = self.axes[axis]
        return self.clock.now if a.is_at_standstill else a.end_of_motion()

    def crossing_time(self, axis: int, position: float) -> float:
        """Return when the axis will pass `position`; infinite if this motion never does.

        For a simulated motor the prediction is limited; beyond it the result is the time to check again.
        """
        a = self.axes[axis]
        feedback = a.feedback
        if feedback is None or abs(position) == INFINITY:
            return self._crossing_time(a, position)
        return feedback.crossing_time(position)

    def error_crossing_time(self, axis: int, error: float) -> float:
        """Return when the following error of an axis passes `error`, like `crossing_time`."""
        feedback = self.axes[axis].feedback
        if feedback is None or abs(error) == INFINITY:
            return INFINITY
        return feedback.error_crossing_time(error)

    def demand_crossing_time(self, axis: int, position: float) -> float:
        """Return when the commanded position passes `position`, like `crossing_time`."""
        return self._crossing_time(self.axes[axis], position)

    def encoder_crossing_time(self, channel: int, position: float) -> float:
        """Return when an encoder channel passes `position`, like `crossing_time`."""
        return self._crossing_time(self.encoder(channel), position)

    def _crossing_time(self, a: Axis, position: float) -> float:
        start, profile = a.starts[-1], a.profiles[-1]
        elapsed = self.clock.now - start
        if abs(position) == INFINITY:
            return INFINITY
        if profile.duration == INFINITY and profile.start == profile.end and not profile.peak_speed:
            return INFINITY  # at rest, like a slave whose master rests: it passes not even its own position
        found = profile.crossing(position, elapsed)
        return INFINITY if found is None else start + found

    def remaining_crossing_time(self, axis: int, left: float) -> float:
        """Return when the remaining distance will be `left`."""
        if abs(left) == INFINITY:
            return INFINITY
        return self.demand_crossing_time(axis, self.target(axis) - left)

    def velocity_crossing_time(self, axis: int, velocity: float) -> float:
        """Return when the velocity will next be `velocity`; now for a simulated motor.

        See `demand_velocity_crossing_time`.
        """
        if self.has_motor(axis):
            return self.clock.now
        return self.demand_velocity_crossing_time(axis, velocity)

    def demand_velocity_crossing_time(self, axis: int, velocity: float) -> float:
        """Return when the commanded velocity will be `velocity`, or when to check again.

        The result is at most the end of the profile. Unless the profile consists of ramps, whose velocity does not
        jump, it is also at most the next knot.
        """
        a, now = self.axes[axis], self.clock.now
        start, profile = a.starts[-1], a.profiles[-1]
        elapsed = now - start
        if elapsed >= profile.duration or abs(velocity) == INFINITY:
            return INFINITY
        if not profile.has_ramps and profile.cubic(elapsed) is None:
            return start + profile.velocity_check(velocity, elapsed)
        found = profile.velocity_crossing(velocity, elapsed)
        if profile.has_ramps and (found is None or found > elapsed):
            return start + (profile.duration if found is None else found)
        piece = profile.cubic(elapsed)
        if piece is None:
            return now
        since, until, (_, _, c2, c3) = piece
        if not c2 and not c3:
            return start + until
        if c3 and elapsed < since - c2 / (3.0 * c3) < until:
            until = since - c2 / (3.0 * c3)
        return start + (until if found is None else min(found, until))

    def turns(self, channel: int) -> bool:
        """True if an encoder channel moves, or begins to."""
        a = self.encoder(channel)
        profile, elapsed = a.profiles[-1], self.clock.now - a.starts[-1]
        if elapsed >= profile.duration:
            return bool(profile.end_velocity)
        piece = profile.cubic(elapsed)
        return piece is None or any(piece[2][1:])

    def watch(self, axis: int, position: float, call: Callable[[int], None], physical: bool = False) -> Watch:
        """Call `call(direction)` whenever the axis passes `position`, until `unwatch`."""
        a = self.axes[axis]
        watch = Watch(position, call, physical)
        begin(a, watch, self.clock)
        return watch

    def unwatch(self, axis: int, watch: Watch) -> None:
        """End a watch."""
        end(self.axes[axis], watch)

    def input(self, channel: int) -> float:
        return self.inputs[channel]

    def output(self, channel: int) -> float:
        return self.outputs[channel]

    def encoder(self, channel: int) -> Axis:
        """Return the track of an encoder channel driven from outside."""
        found = self.encoders.get(channel)
        if found is None:
            found = self.encoders[channel] = Axis(channel)
        return found

    def encoder_position(self, channel: int) -> float:
        """Return the position of an encoder channel, counts."""
        return self.encoder(channel).position(self.clock.now)

    def encoder_velocity(self, channel: int) -> float:
        """Return the velocity of an encoder channel, counts/s."""
        return self.encoder(channel).velocity(self.clock.now)

    def set_output(self, channel: int, value: float) -> bool:
        """Set an output; return True if that changed it."""
        return self.outputs.set(channel, value)

    def pulse(self, channel: int, duration: float) -> None:
        """Turn a digital output on for `duration` seconds; another pulse prolongs it."""
        pending = self._pulses.get(channel)
        if pending is not None:
            pending.cancel()
        self.outputs[channel] = 1
        end = self.clock.now + duration
        self._pulses[channel] = self.clock.at(end, lambda: self.outputs.__setitem__(channel, 0))

    def analogue_input(self, channel: int) -> float:
        return self.analogue_inputs[channel]

    def set_analogue_output(self, channel: int, value: float) -> None:
        self.analogue_outputs[channel] = value

    def run_time_fault(self, rejected: Rejected) -> None:
        """Raise a run-time fault outside a statement; unless handled, it ends the program."""
        if self.fault_handler is None or not self.fault_handler(rejected):
            raise rejected

    def notify(self, what: str, axis: int) -> None:
        """Notify the listeners of a kind; they may unsubscribe meanwhile."""
        self.listeners.notify(what, axis)
