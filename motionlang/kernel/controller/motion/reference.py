"""References: a program writes the velocity or position of an axis repeatedly.

A speed reference ramps to the new velocity; a position reference moves there in a straight line within one
period of the profiler. All writes until another motion form one entry of the log.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.motion.follow import FollowMove
from motionlang.kernel.controller.queue import stop
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import Action, keeps_rates
from motionlang.kernel.planners import Profile, hold
from motionlang.kernel.planners.curve import relabelled
from motionlang.kernel.planners.ramp_down import admitted
from motionlang.kernel.planners.reference import Slope, plan_reference

if TYPE_CHECKING:
    from motionlang.kernel.controller.queue.life import Core

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

    def engage(self, controller: Core, a: Axis, profile: Profile) -> None:
        """Begin with a profile, or continue a reference in progress with it."""
        if a.move is not self.move:
            controller.end_move(a, "retarget")
            controller.log_move(a, self.move, profile)
            self.move.segments.clear()
        self.move.begin_new_entry(controller, controller.clock.now)
        self.move.add(controller.clock.now, profile)
        a.target = self.move.target = profile.end
        controller.append_profile(a, profile, BY_DESIGN)

    def replan(self, controller: Core, a: Axis) -> None:
        self.engage(controller, a, self.plan(controller, a))


class SpeedReference(Reference):
    """A velocity, counts/s, reached with the slopes `up` and `down`.

    `error_rate` is the deceleration after an error; 0 for none.
    """

    __slots__ = ("error_rate", "slopes", "velocity")
    live_limits = ("max_speed",)

    def __init__(self, move: FollowMove, velocity: float, slopes: Slopes, error_rate: float) -> None:
        super().__init__(move)
        self.velocity, self.slopes, self.error_rate = velocity, slopes, error_rate

    def plan(self, controller: Core, a: Axis) -> Profile:
        """Return the ramp from the state of the axis; at a velocity of 0 it ends at rest."""
        if a.suspended:
            return stop.with_standstill(controller, a)
        wanted = max(-a.max_speed, min(self.velocity, a.max_speed))
        s = a.at(controller.clock.now)
        try:
            acceleration, (up, down) = s.acceleration, self.slopes
            if a.move is not self.move and not keeps_rates(a.move):
                acceleration = admitted(acceleration, s.velocity, up.rate, down.rate)
            made = plan_reference(s.position, s.velocity, wanted, up, down, acceleration)
        except ValueError as problem:
            raise Rejected("range", f"axis {a.index} cannot follow its reference: {problem}") from None
        return made if wanted else relabelled(made.cut(made.knots[-2]), made.shape)

    def stop(self, controller: Core, a: Axis, ended: str, hard: bool) -> bool:
        """Brake at `error_rate`, counts/s², after an error.

        False, without effect, if that is 0, and for other stops.
        """
        if ended != "fault" or not hard or not self.error_rate:
            return False
        controller.empty(a, ended)
        profile = stop.braking(controller, a, self.error_rate)
        self.move.action = stop.Stopping(True, self.error_rate)
        controller.continue_with(a, profile, ended)
        a.target = self.move.target = profile.end
        return True


def refer_speed(
    controller: Core,
    a: Axis,
    velocity: float,
    slopes: Slopes,
    error_rate: float,
    command: str,
    line: int,
) -> None:
    """Ramp an axis to a velocity; writing the current one is a no-op."""
    action = a.move.action if a.move is not None and a.move.command == command else None
    if isinstance(action, SpeedReference):
        action.error_rate = error_rate
        same = [slope.key() for slope in slopes] == [slope.key() for slope in action.slopes]
        if velocity == action.velocity and (same or _steady(controller, a)):
            return
        action.velocity, action.slopes = velocity, slopes
        action.replan(controller, a)
        return
    if not velocity and a.move is None:
        return
    move = FollowMove(a.index, command, line, "jog")
    made = SpeedReference(move, velocity, slopes, error_rate)
    made.engage(controller, a, made.plan(controller, a))


def _steady(controller: Core, a: Axis) -> bool:
    state = a.at(controller.clock.now)
    return state.velocity == a.profiles[-1].end_velocity and not state.acceleration


class PositionReference(Reference):
    """A position, counts, reached in a straight line within a period of the profiler."""

    __slots__ = ("position",)

    def __init__(self, move: FollowMove, position: float) -> None:
        super().__init__(move)
        self.position = position

    def plan(self, controller: Core, a: Axis) -> Profile:
        if a.suspended:
            return stop.with_standstill(controller, a)
        here = a.position(controller.clock.now)
        velocity = (self.position - here) / PERIOD
        return Profile("reference", here, self.position, PERIOD, (velocity, PERIOD, 0.0, velocity))

    def shift(self, controller: Core, a: Axis, shift: float) -> None:
        self.position += shift


def refer_position(controller: Core, a: Axis, position: float, command: str, line: int) -> None:
    """Move an axis to a position within a period; a no-op if it is there already."""
    if not abs(position) < INFINITY:
        raise Rejected("range", f"axis {a.index} cannot go to {position:.10g}")
    action = a.move.action if a.move is not None else None
    if isinstance(action, PositionReference):
        if position != action.position:
            action.position = position
            action.replan(controller, a)
        return
    if a.move is None and position == a.position(controller.clock.now):
        return
    move = _last(controller, a, command)
    if move is None:
        made = PositionReference(FollowMove(a.index, command, line, "reference"), position)
        made.engage(controller, a, made.plan(controller, a))
        return
    made = PositionReference(move, position)
    begin, done = move.segments[-1]
    move.add(begin + done.duration, hold(done.end))
    a.move = move
    made.engage(controller, a, made.plan(controller, a))


def _last(controller: Core, a: Axis, command: str) -> FollowMove | None:
    """Return the axis's last log entry, to be extended, if no other motion followed."""
    if a.move is not None:
        return None
    for move in reversed(controller.log.moves[-len(controller.axes) :]):
        if move.axis == a.index:
            goes_on = isinstance(move, FollowMove) and move.command == command and not move.ended
            return move if goes_on and not move.offset else None  # type: ignore[return-value]
    return None
