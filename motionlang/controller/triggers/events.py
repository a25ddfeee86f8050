"""What happened to an axis that a person wants to be told of: limits, faults, clamps, jumps of its velocity, stops.

Each is written into the log where it happens, as an `Event` in user units by the scale of that moment.
"""

from __future__ import annotations

from motionlang.controller.faults import (
    ABORT,
    ERROR_INPUT,
    FOLLOWING_ERROR,
    LIMIT_FORWARD,
    LIMIT_REVERSE,
    SOFT_LIMIT_FORWARD,
    SOFT_LIMIT_REVERSE,
    names,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.controller.core import Core

# What a fault of each bit is called; the others are "fault".
KINDS = {
    ABORT: "abort",
    ERROR_INPUT: "e-stop",
    LIMIT_FORWARD: "limit",
    LIMIT_REVERSE: "limit",
    SOFT_LIMIT_FORWARD: "soft limit",
    SOFT_LIMIT_REVERSE: "soft limit",
    FOLLOWING_ERROR: "following error",
}
# What is said of a limit that a homing has looked for.
HOMING = "homing"


def note(
    controller: Core,
    kind: str,
    a: Axis,
    value: float | None = None,
    limit: float | None = None,
    text: str = "",
) -> None:
    """Write an event of an axis; `value` and `limit` are in user units."""
    line = 0 if a.move is None else a.move.line
    controller.log.note(controller.clock.now, kind, a.index, value, limit, line, text)


def raised(controller: Core, a: Axis, bit: int, action: str) -> None:
    """A fault is about to be raised, and `action` to be taken."""
    kind, value, limit = KINDS.get(bit, "fault"), None, None
    if kind in ("limit", "soft limit"):
        value = a.scale.position_to_user(a.here(controller.clock.now))
        places = [each.watch.position for each in a.limits if each.bit == bit and each.watch is not None]
        limit = a.scale.position_to_user(places[0]) if places else None
    elif a.feedback is not None and bit == FOLLOWING_ERROR:
        size = abs(a.scale.counts or 1.0)
        value, limit = abs(a.feedback.error) / size, a.feedback.error_limit / size
    homing = a.index in controller.homings
    note(controller, kind, a, value, limit, HOMING if homing else f"{names(bit)}, {action}")


def cleared(controller: Core, a: Axis) -> None:
    """The faults of an axis are about to be forgotten."""
    if a.faults:
        note(controller, "cleared", a, text=names(a.faults))


def jumped(controller: Core, a: Axis, ended: str) -> None:
    """An axis is about to stand at once: with a velocity that is an infinite acceleration."""
    velocity = a.velocity(controller.clock.now)
    if velocity:
        note(controller, "velocity jump", a, _speed(a, velocity), 0.0, f"{ended}, an infinite acceleration")


def stopped(controller: Core, a: Axis, kind: str) -> None:
    """A word stops an axis: "stop" by decelerating, "cancel" at once."""
    if a.move is not None:
        note(controller, kind, a, _speed(a, a.velocity(controller.clock.now)))


def clamped(controller: Core, a: Axis, line: int, speed: float) -> None:
    """A motion that a line ordered asks for more speed, counts/s, than its axis may have; told once."""
    _clamped(controller, a, "speed", line, _speed(a, speed), _speed(a, a.max_speed))


def clamped_blend(controller: Core, a: Axis, line: int, asked: float, got: float) -> None:
    """A path of the master `a` is blended over less than the distance asked for, user units; reported once."""
    _clamped(controller, a, "blend distance", line, asked, got)


def _clamped(controller: Core, a: Axis, what: str, line: int, asked: float, got: float) -> None:
    about = line, asked, got
    if controller.log.clamped.get((a.index, what)) != about:
        controller.log.clamped[a.index, what] = about
        controller.log.note(controller.clock.now, "clamp", a.index, asked, got, line, what)


def _speed(a: Axis, speed: float) -> float:
    return speed / (a.scale.counts or 1.0)
