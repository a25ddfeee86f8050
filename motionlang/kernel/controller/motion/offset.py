"""OFFSET: a superposed distance, in the four modes of the MN1274 page.

The calculation uses the master's speed at the start of the offset. Later changes affect the base, not the
offset.
"""

from __future__ import annotations

from math import sqrt

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.motion.follow import Follow, tie_of
from motionlang.kernel.controller.queue.life import move_by, permit_motion
from motionlang.kernel.controller.queue.plan import plan_distance, rates
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile

# Bits of the status of the last offset (Mint's _os constants).
MAX_SPEED, MIN_SPEED, MAX_ACCEL, MAX_DECEL, PROFILE_ERROR, ZERO_ACCEL = (1 << bit for bit in range(6))
STANDARD, SPEED_LIMIT, ACCEL_MODE, SPEED_MODE = range(4)


class OffsetMove(LoggedMove):
    """The log entry of an offset; positions are relative to the slave without offset."""

    __slots__ = ()
    overlaid = True


def offset(a: Axis, distance: float, mode: int, over: float, command: str, line: int) -> None:
    """Superpose `distance` on a slave's motion; move any other axis by `distance`.

    Modes 2 and 3 spread it over `over` counts of the master.
    """
    tie = tie_of(a)
    a.offset_status = 0
    if tie is None:
        permit_motion(a)
        move_by(a, distance, command, line)
        return
    left, velocity = tie.offset_left()
    total = left + distance
    if not total and not velocity:
        a.controller.motion_listener.offset(a, distance, line)
        return
    limits = _limits(a, tie, total, mode, over)
    if limits is None:
        return
    speed, accel, decel, bound = limits
    shape = a.shape if mode < ACCEL_MODE else "trapezoid"
    jerks = a.accel_jerk, a.decel_jerk
    profile = plan_distance(a, shape, 0.0, total, (speed, accel, decel), jerks, velocity)
    a.controller.motion_listener.offset(a, distance, line)
    entry = OffsetMove(a.index, command, line, profile.end)
    entry.profile, entry.start_time, entry.scale = profile, a.clock.now, a.scale.counts
    entry.chain = a.controller.log.chain()
    a.controller.log.moves.add(entry)
    tie.start_offset(profile, entry)
    tie.offset_limits = None if mode == STANDARD else (speed, accel, decel)
    if bound:
        _await_bound(a, profile, speed, bound)


def _await_bound(a: Axis, profile: Profile, speed: float, bound: int) -> None:
    """Set the status bit `bound` at the time when the offset reaches `speed`."""

    def reached() -> None:
        if (tie := tie_of(a)) is not None and tie.offset is profile:
            a.offset_status |= bound

    full = speed * (1.0 - 1e-9)
    time = next((knot for knot in profile.knots if abs(profile.velocity(knot)) >= full), None)
    if time is not None:
        a.clock.at(a.clock.now + time, reached)


def crossing_time(a: Axis, left: float) -> float:
    """Return when `left` counts of the present offset remain; infinite if never."""
    tie = tie_of(a)
    if tie is None or tie.offset is None:
        return INFINITY
    found = tie.offset.crossing(tie.offset.end + tie.paused - left, a.clock.now - tie.offset_began)
    return INFINITY if found is None else tie.offset_began + found


def _limits(
    a: Axis, tie: Follow, distance: float, mode: int, over: float
) -> tuple[float, float, float, int] | None:
    """Return speed and rates relative to the base, and the status bit of the speed.

    None if it is impossible; the status gives the reason.
    """
    accel, decel = rates(a, a.speed)
    if mode == STANDARD:
        return a.speed, accel, decel, 0
    base = a.velocity(a.clock.now) - tie.offset_left()[1]
    slower = base * distance < 0.0
    most = abs(base) if slower else a.max_speed - abs(base)
    if most <= 0.0:
        a.offset_status |= MIN_SPEED if slower else MAX_SPEED
        return None
    if mode == SPEED_LIMIT:
        return min(a.speed, most), accel, decel, _bound(a.speed, most, slower)
    pace = abs(tie.master.velocity(a.clock.now))
    if not pace or not over:
        a.offset_status |= PROFILE_ERROR
        return None
    time = abs(over) / pace
    if mode == ACCEL_MODE:
        return _triangle(a, abs(distance), time, most, slower)
    share = 0.5 / accel + 0.5 / decel
    root = time * time - 4.0 * share * abs(distance)
    if root < 0.0:
        a.offset_status |= MAX_ACCEL | MAX_DECEL
        return None
    speed = 2.0 * abs(distance) / (time + sqrt(root))
    return min(speed, most), accel, decel, _bound(speed, most, slower)


def _triangle(
    a: Axis, distance: float, time: float, most: float, slower: bool
) -> tuple[float, float, float, int] | None:
    """Return speed, rates and status bit of a triangle that takes `time`.

    It speeds up for half the time and slows down for the other half. If its peak is too fast, the profile is a
    trapezoid. None if that is impossible; the status gives the reason.
    """
    peak = 2.0 * distance / time
    speed, bound = min(peak, most), _bound(peak, most, slower)
    ramp = time - distance / speed
    if ramp <= 0.0:
        a.offset_status |= PROFILE_ERROR | bound
        return None
    rate = speed / ramp
    if rate > a.max_accel or rate > a.max_decel:
        too_steep = (MAX_ACCEL if rate > a.max_accel else 0) | (MAX_DECEL if rate > a.max_decel else 0)
        a.offset_status |= too_steep | bound
        return None
    return speed, rate, rate, bound


def _bound(speed: float, most: float, slower: bool) -> int:
    """Return the status bit of an offset that is clipped to `most`; 0 if it is slower."""
    if speed < most:
        return 0
    return MIN_SPEED if slower else MAX_SPEED
