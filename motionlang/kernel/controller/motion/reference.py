"""References: a program writes the velocity or position of an axis repeatedly.

A speed reference ramps to the new velocity; a position reference moves there in a straight line within one
period of the profiler. All writes until another motion form one entry of the log.
"""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import BY_DESIGN, clamped
from motionlang.kernel.controller.motion.follow import FollowMove
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.controller.queue.life import append_profile, continue_with, empty
from motionlang.kernel.controller.queue.plan import braking, with_standstill
from motionlang.kernel.controller.queue.stop import Stopping
from motionlang.kernel.controller.queue.track import end_move, log_move
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import keeps_rates
from motionlang.kernel.planners import Profile, hold
from motionlang.kernel.planners.curve import relabelled
from motionlang.kernel.planners.ramp_down import admitted
from motionlang.kernel.planners.reference import Slope, plan_reference

Slopes = tuple[Slope, Slope]

# The period of the profiler, seconds: a reference without a ramp is reached within one.
PERIOD = 1e-3


class Reference(Action):
    """Motion to a reference; a new reference replaces the rest of its profile."""

    __slots__ = ("move",)
    keeps_rates = False

    def __init__(self, move: FollowMove) -> None:
        self.move = move
        move.action = self

    def engage(self, a: Axis, profile: Profile) -> None:
        """Begin with a profile, or continue a reference in progress with it."""
        if a.move is not self.move:
            end_move(a, "retarget")
            log_move(a, self.move, profile)
            self.move.segments.clear()
        self.move.begin_new_entry(a.controller.log, a.clock.now)
        self.move.add(a.clock.now, profile)
        a.target = self.move.target = profile.end
        append_profile(a, profile, BY_DESIGN)

    def replan(self, a: Axis) -> None:
        self.engage(a, self.plan(a))


class SpeedReference(Reference):
    """A velocity, counts/s, at most `most`, reached with the slopes `up` and `down`.

    `error_rate` is the deceleration after an error; 0 for none.
    """

    __slots__ = ("error_rate", "most", "slopes", "velocity")
    live_limits = ("max_speed",)

    def __init__(
        self, move: FollowMove, velocity: float, slopes: Slopes, error_rate: float, most: float
    ) -> None:
        super().__init__(move)
        self.velocity, self.slopes, self.error_rate, self.most = velocity, slopes, error_rate, most

    def plan(self, a: Axis) -> Profile:
        """Return the ramp from the state of the axis; at a velocity of 0 it ends at rest."""
        if a.suspended:
            return with_standstill(a)
        most = min(self.most, a.max_speed)
        clamped(a, self.move.line, abs(self.velocity), most)
        wanted = max(-most, min(self.velocity, most))
        s = a.at(a.clock.now)
        try:
            acceleration, (up, down) = s.acceleration, self.slopes
            if a.move is not self.move and not keeps_rates(a.move):
                acceleration = admitted(acceleration, s.velocity, up.rate, down.rate)
            made = plan_reference(s.position, s.velocity, wanted, up, down, acceleration)
        except ValueError as problem:
            raise Rejected("range", f"axis {a.index} cannot follow its reference: {problem}") from None
        return made if wanted else relabelled(made.cut(made.knots[-2]), made.shape)

    def stops_itself(self, ended: str, hard: bool) -> bool:
        return ended == "fault" and hard and self.error_rate != 0.0

    def stop(self, a: Axis, ended: str, hard: bool) -> None:
        """Brake at `error_rate`, counts/s², after an error."""
        empty(a, ended)
        profile = braking(a, self.error_rate)
        self.move.action = Stopping(True, self.error_rate)
        continue_with(a, profile, ended)
        a.target = self.move.target = profile.end


def refer_speed(
    a: Axis,
    velocity: float,
    slopes: Slopes,
    error_rate: float = 0.0,
    command: str = "",
    line: int = 0,
    most: float = INFINITY,
) -> None:
    """Ramp to a speed reference, counts/s, at most `most`, with `slopes` for speeding up and down.

    An error brakes the axis at `error_rate`. Writing the current velocity is a no-op.
    """
    action = a.move.action if a.move is not None and a.move.command == command else None
    if isinstance(action, SpeedReference):
        action.error_rate = error_rate
        same = [slope.key() for slope in slopes] == [slope.key() for slope in action.slopes]
        if velocity == action.velocity and most == action.most and (same or _steady(a)):
            return
        action.velocity, action.slopes, action.most = velocity, slopes, most
        action.replan(a)
        return
    if not velocity and a.move is None:
        return
    move = FollowMove(a.index, command, line, "jog")
    made = SpeedReference(move, velocity, slopes, error_rate, most)
    made.engage(a, made.plan(a))


def _steady(a: Axis) -> bool:
    state = a.at(a.clock.now)
    return state.velocity == a.profiles[-1].end_velocity and not state.acceleration


class PositionReference(Reference):
    """A position, counts, reached in a straight line within a period of the profiler."""

    __slots__ = ("position",)

    def __init__(self, move: FollowMove, position: float) -> None:
        super().__init__(move)
        self.position = position

    def plan(self, a: Axis) -> Profile:
        if a.suspended:
            return with_standstill(a)
        here = a.position(a.clock.now)
        velocity = (self.position - here) / PERIOD
        return Profile("reference", here, self.position, PERIOD, (velocity, PERIOD, 0.0, velocity))

    def shift(self, a: Axis, shift: float) -> None:
        self.position += shift


def refer_position(a: Axis, position: float, command: str = "", line: int = 0) -> None:
    """Follow a position reference, reached within a period of the profiler; a no-op if it is there already."""
    if not abs(position) < INFINITY:
        raise Rejected("range", f"axis {a.index} cannot go to {position:.10g}")
    action = a.move.action if a.move is not None else None
    if isinstance(action, PositionReference):
        if position != action.position:
            action.position = position
            action.replan(a)
        return
    if a.move is None and position == a.position(a.clock.now):
        return
    move = _last(a, command)
    if move is None:
        made = PositionReference(FollowMove(a.index, command, line, "reference"), position)
        made.engage(a, made.plan(a))
        return
    made = PositionReference(move, position)
    begin, done = move.segments[-1]
    move.add(begin + done.duration, hold(done.end))
    a.move = move
    made.engage(a, made.plan(a))


def _last(a: Axis, command: str) -> FollowMove | None:
    """Return the axis's last log entry, to be extended, if no other motion followed."""
    if a.move is not None:
        return None
    for move in reversed(a.controller.log.moves[-len(a.controller.axes) :]):
        if move.axis == a.index:
            goes_on = isinstance(move, FollowMove) and move.command == command and not move.ended
            return move if goes_on and not move.offset else None  # type: ignore[return-value]
    return None
