"""Errors of an axis: what brings them about, what the axis does about each, and how they are cleared.

The modes are the same for every error: 0 nothing, 1 a crash stop, 2 a crash stop and the drive off, 3 a stop at
ERRORDECEL, 4 the same and then the drive off, 5 only the event ONERROR. Their numbers are from memory, and so are the
defaults (docs/fidelity.md).
"""

from __future__ import annotations

from motionlang.controller.faults import (
    ABORT,
    ANALOGUE_LIMIT,
    ERROR_INPUT,
    FOLLOWING_ERROR,
    LIMIT_FORWARD,
    LIMIT_REVERSE,
    SOFT_LIMIT_FORWARD,
    SOFT_LIMIT_REVERSE,
)
from motionlang.controller.triggers.conditions import Undirected
from motionlang.controller.triggers.limit import Limit
from motionlang.mint.keywords.defaults import MODES
from motionlang.mint.runtime.binding import axis_of, scale_of
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.controller import Controller
    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

ACTIONS = ("ignore", "abort", "off", "error-stop", "error-stop", "event")
STOP_THEN_OFF = 4
# Keyword -> the errors it is about.
ERRORS: dict[str, tuple[int, ...]] = {
    "LIMITMODE": (LIMIT_FORWARD, LIMIT_REVERSE),
    "SOFTLIMITMODE": (SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE),
    "FOLERRORMODE": (FOLLOWING_ERROR,),
    "ERRORINPUTMODE": (ERROR_INPUT,),
    "ABORTMODE": (ABORT,),
    "ADCERRORMODE": (ANALOGUE_LIMIT,),
}
SIGNS = {SOFT_LIMIT_FORWARD: 1, SOFT_LIMIT_REVERSE: -1, LIMIT_FORWARD: 1, LIMIT_REVERSE: -1}


class AxisErrors:
    """The modes of every axis, its software limits, and the switches that keywords assign to it."""

    def __init__(self, environment: Environment) -> None:
        self._controller: Controller = environment.controller
        self._world = environment.machine.world
        self._modes: dict[tuple[str, int], int] = {}
        self._soft: dict[tuple[int, int], tuple[Limit, float]] = {}
        self._inputs: dict[tuple[int, int, int], Undirected] = {}
        self._going_off: set[int] = set()
        self._controller.listeners.append(self._heard, "fault", "idle")

    # ---------------------------------------------------------------------------------------------- modes

    def mode(self, name: str, axis: int) -> int:
        return self._modes.get((name, axis), MODES[name])

    def set_mode(self, name: str, axis: int, mode: int) -> None:
        """Say what an axis does about a kind of error."""
        self._modes[name, axis] = mode
        for bit in ERRORS[name]:
            if self._world is not None:
                self._world.actions[axis, bit] = ACTIONS[mode]
            self._controller.set_limit_action(axis, bit, ACTIONS[mode])
            for (number, about, _), condition in self._inputs.items():
                if (number, about) == (axis, bit):
                    condition.action = ACTIONS[mode]

    def action(self, axis: int, bit: int) -> str:
        """What an axis does about an error."""
        return ACTIONS[self._mode_of(axis, bit)]

    def _mode_of(self, axis: int, bit: int) -> int:
        return next(self.mode(name, axis) for name, bits in ERRORS.items() if bit in bits)

    def _heard(self, what: str, axis: int) -> None:
        if what == "fault":
            bits = self._controller.faults(axis)
            found = [name for name, group in ERRORS.items() if any(bits & bit for bit in group)]
            if any(self.mode(name, axis) == STOP_THEN_OFF for name in found):
                self._off_at_rest(axis)
        elif what == "idle" and axis in self._going_off:
            self._going_off.discard(axis)
            self._controller.disable(axis)

    def _off_at_rest(self, axis: int) -> None:
        if self._controller.is_idle(axis):
            self._controller.disable(axis)
        else:
            self._going_off.add(axis)

    # --------------------------------------------------------------------------------------------- limits

    def limit(self, axis: int, bit: int) -> Limit:
        """The limit of an axis for an error: the machine's own switch, or one that is made now."""
        for limit in self._controller.axes[axis].limits:
            if limit.bit == bit:
                return limit
        physical = bit in (LIMIT_FORWARD, LIMIT_REVERSE)
        return self._controller.add_limit(axis, SIGNS[bit], bit, self.action(axis, bit), physical)

    def set_input(self, axis: int, bit: int, active: bool, channel: int = 0) -> None:
        """An input of an axis that is an error in every direction has come to be so, or is so no longer.

        `channel` tells apart several inputs that are the same error, each of which is one by itself.
        """
        found = self._inputs.get((axis, bit, channel))
        if found is None:
            if not active:
                return
            found = Undirected(self._controller, axis, 0, bit, self.action(axis, bit))
            self._inputs[axis, bit, channel] = found
        found.set_active(active)

    def is_active(self, axis: int, bit: int) -> bool:
        return any(limit.active for limit in self._controller.axes[axis].limits if limit.bit == bit)

    def soft_limit(self, axis: int, bit: int) -> float:
        """The position of a software limit in counts."""
        return self._soft[axis, bit][1] if (axis, bit) in self._soft else 0.0

    def set_soft_limit(self, axis: int, bit: int, position: float) -> None:
        """Set a software limit, counts; two of 0 are none."""
        self._soft[axis, bit] = (self.limit(axis, bit), position)
        for each in (SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE):
            limit, where = self._soft.setdefault((axis, each), (self.limit(axis, each), 0.0))
            none = self.soft_limit(axis, SOFT_LIMIT_FORWARD) == self.soft_limit(axis, SOFT_LIMIT_REVERSE) == 0
            limit.place(None if none else where)

    def default(self, axis: int) -> None:
        """DEFAULT: modes and limits as at power-up."""
        for name in MODES:
            if (name, axis) in self._modes:
                self.set_mode(name, axis, MODES[name])
        if (axis, SOFT_LIMIT_FORWARD) in self._soft:
            for bit in (SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE):
                self.set_soft_limit(axis, bit, 0.0)


# ----------------------------------------------------------------------------------------------- operations


def read_mode(environment: Environment, row: Row) -> Operation:
    errors, name = environment.part(AxisErrors), row.name
    return lambda axis: errors.mode(name, axis_of(environment, axis))


@repeatable
def write_mode(environment: Environment, row: Row) -> Operation:
    """What an axis does about one kind of error."""
    errors, name = environment.part(AxisErrors), row.name

    def write(axis: int, mode: int) -> None:
        row.check(mode)
        errors.set_mode(name, axis_of(environment, axis), mode)

    return write


def _soft_bit(row: Row) -> int:
    return SOFT_LIMIT_FORWARD if row.name.endswith("FORWARD") else SOFT_LIMIT_REVERSE


def read_soft(environment: Environment, row: Row) -> Operation:
    errors, bit = environment.part(AxisErrors), _soft_bit(row)
    return lambda axis: scale_of(environment, axis).to_user(errors.soft_limit(axis, bit))


@repeatable
def write_soft(environment: Environment, row: Row) -> Operation:
    """SOFTLIMITFORWARD and SOFTLIMITREVERSE, user units."""
    errors, bit = environment.part(AxisErrors), _soft_bit(row)

    def write(axis: int, value: float) -> None:
        row.check(value)
        errors.set_soft_limit(axis, bit, scale_of(environment, axis).to_counts(value))

    return write


def read_forward(environment: Environment, row: Row) -> Operation:
    errors = environment.part(AxisErrors)
    return lambda axis: int(errors.is_active(axis_of(environment, axis), LIMIT_FORWARD))


def read_reverse(environment: Environment, row: Row) -> Operation:
    errors = environment.part(AxisErrors)
    return lambda axis: int(errors.is_active(axis_of(environment, axis), LIMIT_REVERSE))


def read_either(environment: Environment, row: Row) -> Operation:
    forward, reverse = read_forward(environment, row), read_reverse(environment, row)
    return lambda axis: forward(axis) or reverse(axis)


def read_error(environment: Environment, row: Row) -> Operation:
    controller = environment.controller
    return lambda axis: controller.faults(axis_of(environment, axis))


def write_error(environment: Environment, row: Row) -> Operation:
    def write(axis: int, value: int) -> None:
        row.check(value)
        environment.controller.clear_faults(axis_of(environment, axis))

    return write


def do_abort(environment: Environment, row: Row) -> Operation:
    """ABORT: every axis does what its ABORTMODE says."""
    errors, controller = environment.part(AxisErrors), environment.controller

    def abort() -> None:
        for axis in controller.axes:
            action = errors.action(axis, ABORT)
            if action != "ignore":
                controller.fault(axis, ABORT, action)

    return abort


def do_line(environment: Environment, row: Row) -> Operation:
    """The program has come to a line at which the machine file lets something happen."""
    world = environment.machine.world
    assert world is not None
    return world.reach


OPERATIONS = {
    "limits.mode": {"read": read_mode, "write": write_mode},
    "limits.soft": {"read": read_soft, "write": write_soft},
    "limits.forward": {"read": read_forward},
    "limits.reverse": {"read": read_reverse},
    "limits.either": {"read": read_either},
    "limits.error": {"read": read_error, "write": write_error},
    "limits.abort": {"do": do_abort},
    "limits.line": {"do": do_line},
}
