"""Values that can be read of a controller: positions, times at which they pass a value, channels."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.motion.follow import tie_of
from motionlang.kernel.controller.motion.offset import crossing_time
from motionlang.kernel.controller.moves.cam import Cam
from motionlang.kernel.controller.moves.path import run_of
from motionlang.kernel.controller.power import may_enable
from motionlang.kernel.controller.queue.plan import rates
from motionlang.kernel.controller.state import ControllerState


class Readings(ControllerState):
    """The readings of a controller, by the number of an axis or channel.

    Positions are counts, velocities counts/s, times seconds of the clock. An axis that does not exist raises
    KeyError.
    """

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
        return self.axes[axis].actual_position

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

    def settled_time(self, axis: int) -> float:
        """Return when an axis has settled by `settle_within`, or when to check again.

        It is infinite if the axis never settles.
        """
        feedback = self.axes[axis].feedback
        return self.clock.now if feedback is None else feedback.settled_time("program")

    def has_motor(self, axis: int) -> bool:
        """True if the axis has a simulated motor."""
        return self.axes[axis].feedback is not None

    def is_open(self, axis: int) -> bool:
        """True if a simulated motor runs in open loop."""
        feedback = self.axes[axis].feedback
        return feedback is not None and not feedback.closed

    def is_still(self, axis: int) -> bool:
        """True if the axis and its simulated motor, if any, are at standstill for good."""
        return self.axes[axis].is_still

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

    def is_enabled(self, axis: int) -> bool:
        return self.axes[axis].enabled

    def may_enable(self, axis: int) -> bool:
        """True if the axis has no enable input, or the input is on."""
        return may_enable(self.axes[axis])

    def is_idle(self, axis: int) -> bool:
        return not self.axes[axis].is_moving

    def is_on_home_switch(self, axis: int) -> bool:
        return self.axes[axis].is_at_home

    def faults(self, axis: int) -> int:
        return self.axes[axis].faults

    def idle_time(self, axis: int) -> float:
        """Return when the axis will be idle if nothing else happens; infinite in a jog."""
        a = self.axes[axis]
        return a.end_of_motion() if a.is_moving else self.clock.now

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

    def input(self, channel: int) -> float:
        return self.inputs[channel]

    def output(self, channel: int) -> float:
        return self.outputs[channel]

    def encoder_position(self, channel: int) -> float:
        """Return the position of an encoder channel, counts."""
        return self.encoder(channel).position(self.clock.now)

    def encoder_velocity(self, channel: int) -> float:
        """Return the velocity of an encoder channel, counts/s."""
        return self.encoder(channel).velocity(self.clock.now)

    def analogue_input(self, channel: int) -> float:
        return self.analogue_inputs[channel]

    # -------------------------------------------------------------------------- paths, masters, offsets, motors

    def path_speed(self, axis: int) -> float:
        """Return the speed along the present path of the axis, user units/s."""
        run = run_of(self.axes[axis])
        return run.course.speed if run is not None else 0.0

    def master_of(self, axis: int) -> int | None:
        """Return the axis or encoder channel that an axis follows, or None."""
        tie = tie_of(self.axes[axis])
        return tie.master.index if tie is not None else None

    def cam_index(self, axis: int) -> int:
        """Return the segment of the cam table that the axis is in; -1 if there is no cam."""
        move = self.axes[axis].move
        return move.action.index if move is not None and isinstance(move.action, Cam) else -1

    def cam_index_time(self, axis: int, index: int | None = None) -> float:
        """Return when the axis may enter or leave a segment of its cam table.

        The segment is by default the present one. INFINITY if only an event can change that.
        """
        move = self.axes[axis].move
        return (
            move.action.index_time(index) if move is not None and isinstance(move.action, Cam) else INFINITY
        )

    def offset_remaining(self, axis: int) -> float:
        """The remaining distance, counts, of a slave's offset or of another axis's move."""
        tie = tie_of(self.axes[axis])
        return tie.offset_left()[0] if tie is not None else self.remaining(axis)

    def offset_crossing_time(self, axis: int, left: float) -> float:
        """Return when the remaining distance of `offset_remaining` is `left`, counts."""
        if abs(left) == INFINITY or self.master_of(axis) is None:
            return self.remaining_crossing_time(axis, left)
        return crossing_time(self.axes[axis], left)

    def offset_status(self, axis: int) -> int:
        """Return the status of the last offset, as the bits of OFFSETSTATUS."""
        return self.axes[axis].offset_status

    def gain(self, axis: int, quantity: str, default: float) -> float:
        """Return a gain set by the program, or `default`."""
        return self.axes[axis].gains.get(quantity, (default,))[0]

    def setting(self, axis: int, name: str) -> float | str | None:
        """Return the value of one of `SETTINGS`."""
        value: float | str | None = getattr(self.axes[axis], name)
        return value

    def is_suspended(self, axis: int) -> bool:
        """True if the axis is suspended for any reason."""
        return self.axes[axis].suspended

    def room(self, axis: int) -> int:
        """Return how many more moves fit into the buffer; the present move is not in it."""
        a = self.axes[axis]
        return a.buffer_size - len(a.buffer)

    def rates(self, axis: int) -> tuple[float, float]:
        """Return the rates of an axis at its speed; raise Rejected unless both are positive."""
        a = self.axes[axis]
        return rates(a, a.speed)
