"""OFFSET: a distance added on top of following, by the four modes of the MN1274 page (mint-2 §7.5).

The master's speed when the offset begins is the one it reckons with; what the master does later the base follows, the
offset does not.
"""

from __future__ import annotations

from math import sqrt

from motionlang.controller.clock import INFINITY
from motionlang.controller.motion.follow import tie_of
from motionlang.controller.move import Move
from motionlang.planners import plan

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.controller.core import Core
    from motionlang.controller.motion.follow import Follow

# Bits of the answer to how the last offset went (Mint's _os constants).
MAX_SPEED, MIN_SPEED, MAX_ACCEL, MAX_DECEL, PROFILE_ERROR, ZERO_ACCEL = (1 << bit for bit in range(6))
STANDARD, SPEED_LIMIT, ACCEL_MODE, SPEED_MODE = range(4)


class OffsetMove(Move):
    """The log entry of an offset on top of following: its positions count from where the slave would else be."""

    __slots__ = ()
    overlaid = True


def offset(
    controller: Core, a: Axis, distance: float, mode: int, over: float, command: str, line: int
) -> None:
    """Add `distance` to what a slave does; an axis that follows nobody moves by it.

    Modes 2 and 3 spread it over `over` counts of the master.
    """
    tie = tie_of(a)
    controller.offset_statuses[a.index] = 0
    if tie is None:
        controller.move_by(a.index, distance, command, line)
        return
    if tie.put_off(lambda: offset(controller, a, distance, mode, over, command, line)):
        return
    left, velocity = tie.offset_left()
    if controller.orders is not None:
        controller.orders.offset(a, distance, line)
    total = left + distance
    if not total and not velocity:
        return
    limits = _limits(controller, a, tie, total, mode, over)
    if limits is None:
        if controller.orders is not None:
            controller.orders.refuse_offset(a)
        return
    speed, accel, decel = limits
    profile = plan(a.shape if mode < ACCEL_MODE else "trapezoid", 0.0, total, speed, accel, decel, velocity, a.ramp,
                   a.accel_jerk, a.decel_jerk)  # fmt: skip
    entry = OffsetMove(a.index, command, line, profile.end)
    entry.profile, entry.start_time, entry.scale = profile, controller.clock.now, a.scale.counts
    controller.log.moves.add(entry)
    tie.start_offset(profile, entry)


def crossing_time(controller: Core, a: Axis, left: float) -> float:
    """The time at which so much is left of the offset under way, infinite where that never comes."""
    tie = tie_of(a)
    if tie is None or tie.offset is None:
        return INFINITY
    found = tie.offset.crossing(tie.offset.end - left, controller.clock.now - tie.offset_began)
    return INFINITY if found is None else tie.offset_began + found


def _limits(
    controller: Core, a: Axis, tie: Follow, distance: float, mode: int, over: float
) -> tuple[float, float, float] | None:
    """Speed and rates of the offset relative to the base; None where it cannot be done, and the status says why."""
    accel, decel = controller.rates(a, a.speed)
    if mode == STANDARD:
        return a.speed, accel, decel
    base = a.velocity(controller.clock.now) - tie.offset_left()[1]
    slower = base * distance < 0.0
    most = abs(base) if slower else a.max_speed - abs(base)
    if most <= 0.0:
        controller.offset_statuses[a.index] |= MIN_SPEED if slower else MAX_SPEED
        return None
    if mode == SPEED_LIMIT:
        return _clipped(controller, a, a.speed, most, slower), accel, decel
    pace = abs(tie.master.velocity(controller.clock.now))
    if not pace or not over:
        controller.offset_statuses[a.index] |= PROFILE_ERROR
        return None
    time = abs(over) / pace
    if mode == ACCEL_MODE:
        return _triangle(controller, a, abs(distance), time, most, slower)
    share = 0.5 / accel + 0.5 / decel
    root = time * time - 4.0 * share * abs(distance)
    if root < 0.0:
        controller.offset_statuses[a.index] |= MAX_ACCEL | MAX_DECEL
        return None
    speed = 2.0 * abs(distance) / (time + sqrt(root))
    return _clipped(controller, a, speed, most, slower), accel, decel


def _triangle(
    controller: Core, a: Axis, distance: float, time: float, most: float, slower: bool
) -> tuple[float, float, float] | None:
    """Half the time speeding up, half slowing down; where that is too fast a plateau at what is allowed."""
    peak = 2.0 * distance / time
    speed = _clipped(controller, a, peak, most, slower)
    ramp = time - distance / speed
    if ramp <= 0.0:
        controller.offset_statuses[a.index] |= PROFILE_ERROR
        return None
    rate = speed / ramp
    if rate > a.max_accel or rate > a.max_decel:
        too_steep = (MAX_ACCEL if rate > a.max_accel else 0) | (MAX_DECEL if rate > a.max_decel else 0)
        controller.offset_statuses[a.index] |= too_steep
        return None
    return speed, rate, rate


def _clipped(controller: Core, a: Axis, speed: float, most: float, slower: bool) -> float:
    if speed < most:
        return speed
    controller.offset_statuses[a.index] |= MIN_SPEED if slower else MAX_SPEED
    return most
