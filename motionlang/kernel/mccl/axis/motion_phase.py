"""Queries on the current motion: phase, next reversal, arrival near the target."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.mccl.axis.axis import AxisState

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.board import Board


def phase(controller: Controller, axis: int) -> tuple[str, float]:
    """Return the name of the current phase of motion, and its end time."""
    a, now = controller.axes[axis], controller.clock.now
    profile, start = a.profiles[-1], a.starts[-1]
    end = start
    for each in profile.phases:
        end += each.duration
        if now < end:
            return each.name, end
    return "hold", INFINITY


def next_reversal(controller: Controller, axis: int) -> float:
    """Return the earliest time at which the velocity may change sign.

    A reversal is always at a knot.
    """
    a, now = controller.axes[axis], controller.clock.now
    start = a.starts[-1]
    for knot in a.profiles[-1].knots:
        if start + knot > now:
            return start + knot
    return INFINITY


def is_backward(controller: Controller, axis: int) -> bool:
    """True if the current or last motion is in the negative direction."""
    a = controller.axes[axis]
    velocity = a.velocity(controller.clock.now)
    if velocity:
        return velocity < 0.0
    profiles = reversed(a.profiles[-4:])
    return next((each.distance < 0.0 for each in profiles if each.distance), False)


def band_entry(controller: Controller, axis: int, band: float) -> float:
    """Return when the current motion comes within `band` of its target.

    The time may be in the past; it is infinite if this never happens.
    """
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


def at_target_time(board: Board, axis: AxisState) -> float:
    """Return when the axis was or will be at target, if nothing else happens.

    At target means within DB of it for DT. The time is infinite before the last contour path of the axis.
    """
    contour = board.contour_including(axis)
    if board.awaits_path(axis) or (contour is not None and contour.continues(axis.number)):
        return INFINITY
    controller, number = board.controller, axis.number
    a = controller.axes[number]
    if a.feedback is not None:
        return controller.settled_time(number)
    if a.is_at_standstill:
        # A slave is at rest from the moment its master is.
        since = axis.rested if controller.is_idle(number) else a.starts[-1]
        return since + axis.deadband_delay
    if axis.deadband <= 0.0:
        return a.end_of_motion() + axis.deadband_delay
    return band_entry(controller, number, axis.deadband) + axis.deadband_delay
