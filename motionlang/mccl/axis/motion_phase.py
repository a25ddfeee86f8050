"""What can be read off the motion under way: its phase, when it turns, when it came near its end."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.controller import Controller
    from motionlang.mccl.axis.axis import AxisState

INFINITY = float("inf")


def phase(controller: Controller, axis: int) -> tuple[str, float]:
    """The name of the present phase of motion, and when it ends."""
    a, now = controller.axes[axis], controller.clock.now
    profile, start = a.profiles[-1], a.starts[-1]
    end = start
    for each in profile.phases:
        end += each.duration
        if now < end:
            return each.name, end
    return "hold", INFINITY


def next_turn(controller: Controller, axis: int) -> float:
    """The earliest time at which the velocity may change its sign: a turn is always at a knot."""
    a, now = controller.axes[axis], controller.clock.now
    start = a.starts[-1]
    for knot in a.profiles[-1].knots:
        if start + knot > now:
            return start + knot
    return INFINITY


def heading(controller: Controller, axis: int) -> int:
    """+1 or -1: the direction in which the axis moves, or moved last."""
    velocity = controller.demand_velocity(axis)
    if velocity:
        return 1 if velocity > 0 else -1
    for profile in reversed(controller.axes[axis].profiles[-4:]):
        if profile.shape != "hold" and profile.distance:
            return 1 if profile.distance > 0 else -1
    return 1


def band_entry(controller: Controller, axis: int, band: float) -> float:
    """When the motion under way comes within `band` of its target: past or to come; infinite if never."""
    a = controller.axes[axis]
    profile, start = a.profiles[-1], a.starts[-1]
    target = controller.target(axis)
    if abs(target) == INFINITY:
        return INFINITY
    if abs(profile.start - target) <= band:
        return start
    edge = target - band if profile.start < target else target + band
    found = profile.crossing(edge, 0.0)
    return INFINITY if found is None else start + found


def at_target_time(controller: Controller, axis: AxisState) -> float:
    """When the axis is, was or will be at target if nothing else happens: within DB of it for DT."""
    number = axis.number
    if controller.axes[number].feedback is not None:
        return controller.settled_time(number)
    if controller.stands(number):
        # A slave stands since its master does.
        since = axis.rested if controller.is_idle(number) else controller.axes[number].starts[-1]
        return since + axis.deadband_delay
    if axis.deadband <= 0.0:
        return controller.standing_time(number) + axis.deadband_delay
    return band_entry(controller, number, axis.deadband) + axis.deadband_delay
