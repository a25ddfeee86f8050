"""Jogging: an axis ramps to a velocity and keeps it until another command."""

from __future__ import annotations

from math import isclose

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import clamped
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.controller.queue.life import run_profile
from motionlang.kernel.controller.queue.plan import rates
from motionlang.kernel.controller.queue.track import end_move
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove, keeps_rates
from motionlang.kernel.planners import Profile, plan_velocity
from motionlang.kernel.planners.curve import relabelled
from motionlang.kernel.planners.ramp_down import admitted, onset

Rates = tuple[float | None, float | None]

# The relative rounding of a velocity.
_ROUNDING = 1e-12


class Jog(Action):
    """Motion at a velocity, counts/s; with `ends` a velocity of 0 ends the jog."""

    __slots__ = ("_ramp_settings", "ends", "velocity")
    live_limits = ("max_speed", "max_accel", "max_decel")

    def __init__(self, velocity: float, ends: bool) -> None:
        self.velocity, self.ends = velocity, ends
        # The settings on which the ramp to the velocity depends.
        self._ramp_settings: tuple[object, ...] = ()

    def plan(self, a: Axis) -> Profile:
        return self.planned(a, a.move.rates if a.move is not None else None)

    def replan(self, a: Axis) -> None:
        assert a.move is not None
        clamped(a, a.move.line, abs(self.velocity), a.max_speed)
        super().replan(a)
        self.aim(a)

    def aim(self, a: Axis) -> None:
        """Set the target of a jog that comes to an end, now that its end is known."""
        end = a.profiles[-1].end
        if self.ends and abs(end) < INFINITY and a.move is not None:
            a.target = a.move.target = end

    def planned(self, a: Axis, own: Rates | None) -> Profile:
        """Return the motion from the state of the axis to the velocity."""
        self._ramp_settings = settings = _ramp_settings(a, own)
        accel, decel, jerks = settings[:3]
        keeps = keeps_rates(a.move)
        eased, position, velocity, acceleration = onset(
            a.profiles[-1], a.clock.now - a.starts[-1], a.shape, jerks[0], keeps
        )
        if not keeps:
            acceleration = admitted(acceleration, velocity, accel, decel)
        wanted = _wanted(a, self.velocity)
        if eased is not None and isclose(velocity, wanted, rel_tol=_ROUNDING):
            velocity = wanted  # the flank leads to it, and no ramp remains
        try:
            made = plan_velocity(
                a.shape,
                position,
                velocity,
                wanted,
                accel,
                decel,
                a.ramp,
                *jerks,
                acceleration,
            )
            if eased is not None:
                made = relabelled(eased.then(made), made.shape)
        except ValueError as problem:
            raise Rejected("range", f"axis {a.index} cannot jog: {problem}") from None
        if self.ends and not self.velocity and not a.suspended:
            return relabelled(made.cut(made.knots[-2]), made.shape)
        return made

    def goes_on(self, a: Axis, velocity: float, own: Rates | None) -> bool:
        """True if the axis already jogs at this velocity, or is on the same ramp to it."""
        if velocity != self.velocity:
            return False
        wanted, state = _wanted(a, velocity), a.at(a.clock.now)
        at_speed = state.velocity == wanted == a.profiles[-1].end_velocity and not state.acceleration
        return at_speed or self._ramp_settings == _ramp_settings(a, own)


def jog(
    a: Axis,
    velocity: float,
    command: str = "",
    line: int = 0,
    rates: Rates | None = None,
    ends: bool = False,
) -> None:
    """Ramp to `velocity`, counts/s, and keep it, at `rates` or those of the axis.

    With `ends`, a jog to velocity 0 is over when the axis is at rest. Repeating the command, as the loop of a jog panel
    does, changes neither profile nor log.
    """
    begin_jog(a, velocity, command, line, rates, ends)
    a.controller.motion_listener.jogs(a, velocity)


def begin_jog(a: Axis, velocity: float, command: str, line: int, own: Rates | None, ends: bool) -> None:
    """Begin or change a jog."""
    present = a.move
    if present is None:
        if ends and not velocity:
            return
    elif isinstance(present.action, Jog) and present.command == command:
        same = present.action.goes_on(a, velocity, own)
        if same:
            return
    move = LoggedMove(a.index, command, line, INFINITY)
    move.rates = own
    action = move.action = Jog(velocity, ends)
    move.commanded_speed = abs(velocity)
    clamped(a, line, move.commanded_speed, a.max_speed)
    profile = action.planned(a, own)
    end_move(a, "retarget")
    run_profile(a, move, profile)
    action.aim(a)


def _wanted(a: Axis, velocity: float) -> float:
    return 0.0 if a.suspended else max(-a.max_speed, min(velocity, a.max_speed))


def _ramp_settings(
    a: Axis, own: Rates | None
) -> tuple[float, float, tuple[float, float], object, object, object]:
    """Return acceleration, deceleration, jerks and the other settings of the ramps."""
    accel, decel = own or (None, None)
    if accel is None or decel is None:
        its = rates(a, a.speed)
        accel, decel = accel or its[0], decel or its[1]
    jerks = a.jerks(a.speed, accel, decel)
    return min(accel, a.max_accel), min(decel, a.max_decel), jerks, a.shape, a.ramp, _wanted(a, INFINITY)
