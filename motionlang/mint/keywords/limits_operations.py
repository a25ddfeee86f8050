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
from motionlang.mint.keywords.axis_settings import Settings, reading, writing
from motionlang.mint.keywords.defaults import MODES
from motionlang.mint.runtime.binding import of, of_word
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Maker, Operation, Row

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


class AxisErrors(Settings):
    """The modes of every axis, its software limits, and the switches that keywords assign to it."""

    defaults = MODES

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self._world = environment.machine.world
        self._soft: dict[tuple[int, int], tuple[Limit, float]] = {}
        self._inputs: dict[tuple[int, int, int], Undirected] = {}
        self._going_off: set[int] = set()
        self.controller.listeners.append(self._heard, "fault", "idle")

    # ---------------------------------------------------------------------------------------------- modes

    def set(self, name: str, axis: int, value: float) -> None:
        """Say what an axis does about a kind of error."""
        super().set(name, axis, value)
        mode = int(value)
        for bit in ERRORS[name]:
            if self._world is not None:
                self._world.actions[axis, bit] = ACTIONS[mode]
            self.controller.set_limit_action(axis, bit, ACTIONS[mode])
            for (number, about, _), condition in self._inputs.items():
                if (number, about) == (axis, bit):
                    condition.action = ACTIONS[mode]

    def action(self, axis: int, bit: int) -> str:
        """What an axis does about an error."""
        return ACTIONS[self._mode_of(axis, bit)]

    def _mode_of(self, axis: int, bit: int) -> int:
        return next(int(self.setting(name, axis)) for name, bits in ERRORS.items() if bit in bits)

    def _heard(self, what: str, axis: int) -> None:
        if what == "fault":
            bits = self.controller.faults(axis)
            found = [name for name, group in ERRORS.items() if any(bits & bit for bit in group)]
            if any(self.setting(name, axis) == STOP_THEN_OFF for name in found):
                self._off_at_rest(axis)
        elif what == "idle" and axis in self._going_off:
            self._going_off.discard(axis)
            self.controller.disable(axis)

    def _off_at_rest(self, axis: int) -> None:
        if self.controller.is_idle(axis):
            self.controller.disable(axis)
        else:
            self._going_off.add(axis)

    # --------------------------------------------------------------------------------------------- limits

    def limit(self, axis: int, bit: int) -> Limit:
        """The limit of an axis for an error: the machine's own switch, or one that is made now."""
        for limit in self.controller.axes[axis].limits:
            if limit.bit == bit:
                return limit
        physical = bit in (LIMIT_FORWARD, LIMIT_REVERSE)
        return self.controller.add_limit(axis, SIGNS[bit], bit, self.action(axis, bit), physical)

    def set_input(self, axis: int, bit: int, active: bool, channel: int = 0) -> None:
        """An input of an axis that is an error in every direction has come to be so, or is so no longer.

        `channel` tells apart several inputs that are the same error, each of which is one by itself.
        """
        found = self._inputs.get((axis, bit, channel))
        if found is None:
            if not active:
                return
            found = Undirected(self.controller, axis, 0, bit, self.action(axis, bit))
            self._inputs[axis, bit, channel] = found
        found.set_active(active)

    def is_active(self, axis: int, bit: int) -> bool:
        return any(limit.active for limit in self.controller.axes[axis].limits if limit.bit == bit)

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
            if (name, axis) in self._settings:
                self.set(name, axis, MODES[name])
        if (axis, SOFT_LIMIT_FORWARD) in self._soft:
            for bit in (SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE):
                self.set_soft_limit(axis, bit, 0.0)


# ----------------------------------------------------------------------------------------------- operations


def _soft_bit(row: Row) -> int:
    return SOFT_LIMIT_FORWARD if row.name.endswith("FORWARD") else SOFT_LIMIT_REVERSE


def read_soft(errors: AxisErrors, row: Row, axis: int) -> float:
    """SOFTLIMITFORWARD and SOFTLIMITREVERSE, user units."""
    return errors.scale(axis).to_user(errors.soft_limit(axis, _soft_bit(row)))


def write_soft(errors: AxisErrors, row: Row, axis: int, value: float) -> None:
    """SOFTLIMITFORWARD and SOFTLIMITREVERSE, user units."""
    errors.set_soft_limit(axis, _soft_bit(row), errors.scale(axis).to_counts(value))


def is_at(*bits: int) -> Maker:
    """What tells whether an axis is at one of some limits."""
    return of(AxisErrors, lambda errors, axis: int(any(errors.is_active(axis, bit) for bit in bits)))


def do_abort(errors: AxisErrors) -> None:
    """ABORT: every axis does what its ABORTMODE says."""
    for axis in errors.controller.axes:
        action = errors.action(axis, ABORT)
        if action != "ignore":
            errors.controller.fault(axis, ABORT, action)


def do_line(environment: Environment, row: Row) -> Operation:
    """The program has come to a line at which the machine file lets something happen."""
    world = environment.machine.world
    assert world is not None
    return world.reach


OPERATIONS = {
    "limits.mode": {"read": reading(AxisErrors), "write": repeatable(writing(AxisErrors))},
    "limits.soft": {
        "read": of_word(AxisErrors, read_soft),
        "write": repeatable(of_word(AxisErrors, write_soft)),
    },
    "limits.forward": {"read": is_at(LIMIT_FORWARD)},
    "limits.reverse": {"read": is_at(LIMIT_REVERSE)},
    "limits.either": {"read": is_at(LIMIT_FORWARD, LIMIT_REVERSE)},
    "limits.error": {
        "read": of(Environment, lambda e, axis: e.controller.faults(axis)),
        "write": of(Environment, lambda e, axis, value: e.controller.clear_faults(axis)),
    },
    "limits.abort": {"do": of(AxisErrors, do_abort)},
    "limits.line": {"do": do_line},
}
