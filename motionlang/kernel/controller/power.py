"""Enabling and disabling an axis, and its faults."""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.events import cleared, raised
from motionlang.kernel.controller.queue.stop import abort, freeze, stop
from motionlang.kernel.errors import Rejected


def may_enable(a: Axis) -> bool:
    """True if the axis has no enable input, or the input is on."""
    return a.enable_input is None or a.controller.inputs.inverted(a.enable_input)


def enable(a: Axis) -> None:
    """Enable an axis where it is.

    Target, commanded and actual position become equal; faults are cleared.
    """
    if not may_enable(a):
        words = f"the enable input of axis {a.index}, input {a.enable_input}, is off"
        raise Rejected("enable-input", words, "the drive can be enabled while it is on")
    a.enabled = True
    _forget_faults(a)
    if a.feedback is not None:
        a.feedback.take_over()
        a.feedback.search_again()
    if a.move is None:
        a.target = a.position(a.clock.now)
    a.controller.notify("switched", a.index)


def disable(a: Axis) -> None:
    """Disable an axis.

    Its commanded position stays, and so does the axis itself unless a simulated motor coasts.
    """
    freeze(a, "fault" if a.faults else "cancel")
    a.enabled = False
    if a.feedback is not None:
        a.feedback.open(0.0)
    a.controller.notify("switched", a.index)


def clear_faults(a: Axis) -> None:
    """Clear the faults of an axis."""
    _forget_faults(a)
    if a.feedback is not None:
        a.feedback.search_again()
    a.controller.notify("cleared", a.index)


def _forget_faults(a: Axis) -> None:
    if a.faults:
        cleared(a)
    a.faults = 0


def fault(a: Axis, bit: int, action: str) -> None:
    """Raise a fault on an axis and take `action` (one of `conditions.ACTIONS`).

    The action is taken each time; a fault that is still pending does not count as a new error.
    """
    is_new = not a.faults & bit
    if action != "ignore":
        raised(a, bit, action)
    a.faults |= bit
    if action in ("stop", "error-stop"):
        stop(a, "fault", hard=action == "error-stop")
    elif action == "abort":
        abort(a, "fault")
    elif action == "off":
        disable(a)
    if action != "ignore":
        a.controller.notify("fault", a.index)
        if is_new:
            a.controller.notify("error", a.index)
