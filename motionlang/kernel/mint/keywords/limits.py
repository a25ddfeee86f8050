"""Errors of an axis: their causes, the reactions to them, and clearing them.

Every error has the same modes: 0 ignores it; 1 is a crash stop; 2 is a crash stop, then the drive is disabled;
3 is a stop at ERRORDECEL; 4 is a stop at ERRORDECEL, then the drive is disabled; 5 only raises the event ONERROR.
The numbers and the defaults are from memory (docs/contributing/assumptions.md).
"""

from __future__ import annotations

from motionlang.kernel.controller.faults import (
    ABORT,
    ERROR_INPUT,
    FOLLOWING_ERROR,
    LIMIT_FORWARD,
    LIMIT_REVERSE,
    SOFT_LIMIT_FORWARD,
    SOFT_LIMIT_REVERSE,
)
from motionlang.kernel.controller.triggers.conditions import Undirected
from motionlang.kernel.controller.triggers.limit import Limit
from motionlang.kernel.lang.keyword import Actions, Keyword, constant
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.defaults import MODES
from motionlang.kernel.mint.runtime.binding import Maker, Operation, of, of_word
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

ACTIONS = ("ignore", "abort", "off", "error-stop", "error-stop", "event")
STOP_THEN_OFF = 4
# The errors that each keyword concerns.
ERRORS: dict[str, tuple[int, ...]] = {
    "LIMITMODE": (LIMIT_FORWARD, LIMIT_REVERSE),
    "SOFTLIMITMODE": (SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE),
    "FOLERRORMODE": (FOLLOWING_ERROR,),
    "ERRORINPUTMODE": (ERROR_INPUT,),
    "ABORTMODE": (ABORT,),
}
SIGNS = {SOFT_LIMIT_FORWARD: 1, SOFT_LIMIT_REVERSE: -1, LIMIT_FORWARD: 1, LIMIT_REVERSE: -1}


class AxisErrors(StoredSettings):
    """The error modes of every axis, its software limits, and its assigned switches."""

    defaults = MODES

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self._world = environment.machine.world
        self._soft: dict[tuple[int, int], tuple[Limit, float]] = {}
        self._inputs: dict[tuple[int, int], Undirected] = {}
        self._going_off: set[int] = set()
        self.controller.listeners.append(self._on_event, "fault", "idle")

    # ---------------------------------------------------------------------------------------------- modes

    def set(self, name: str, axis: int, value: float) -> None:
        """Set the reaction of an axis to a kind of error."""
        super().set(name, axis, value)
        mode = int(value)
        for bit in ERRORS[name]:
            if self._world is not None:
                self._world.actions[axis, bit] = ACTIONS[mode]
            self.controller.set_limit_action(axis, bit, ACTIONS[mode])
            for (number, about), condition in self._inputs.items():
                if (number, about) == (axis, bit):
                    condition.action = ACTIONS[mode]

    def action(self, axis: int, bit: int) -> str:
        """Return the reaction of an axis to an error."""
        return ACTIONS[self._mode_of(axis, bit)]

    def _mode_of(self, axis: int, bit: int) -> int:
        return next(int(self.setting(name, axis)) for name, bits in ERRORS.items() if bit in bits)

    def _on_event(self, what: str, axis: int) -> None:
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
        """Return the limit of an axis for an error; create one if it has no switch."""
        for limit in self.controller.axes[axis].limits:
            if limit.bit == bit:
                return limit
        physical = bit in (LIMIT_FORWARD, LIMIT_REVERSE)
        return self.controller.add_limit(axis, SIGNS[bit], bit, self.action(axis, bit), physical)

    def set_input(self, axis: int, bit: int, active: bool) -> None:
        """Set or clear an error that an input causes in both directions of motion."""
        found = self._inputs.get((axis, bit))
        if found is None:
            if not active:
                return
            found = Undirected(self.controller.axes[axis], bit, self.action(axis, bit))
            self._inputs[axis, bit] = found
        found.set_active(active)

    def is_active(self, axis: int, bit: int) -> bool:
        return any(limit.active for limit in self.controller.axes[axis].limits if limit.bit == bit)

    def soft_limit(self, axis: int, bit: int) -> float:
        """Return the position of a software limit in counts."""
        return self._soft[axis, bit][1] if (axis, bit) in self._soft else 0.0

    def set_soft_limit(self, axis: int, bit: int, position: float) -> None:
        """Set a software limit in counts; the limits are off if both are 0."""
        self._soft[axis, bit] = (self.limit(axis, bit), position)
        for each in (SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE):
            limit, where = self._soft.setdefault((axis, each), (self.limit(axis, each), 0.0))
            none = self.soft_limit(axis, SOFT_LIMIT_FORWARD) == self.soft_limit(axis, SOFT_LIMIT_REVERSE) == 0
            limit.set_position(None if none else where)

    def default(self, axis: int) -> None:
        """Reset modes and limits to their power-up values (DEFAULT)."""
        for name in MODES:
            if (name, axis) in self._settings:
                self.set(name, axis, MODES[name])
        if (axis, SOFT_LIMIT_FORWARD) in self._soft:
            for bit in (SOFT_LIMIT_FORWARD, SOFT_LIMIT_REVERSE):
                self.set_soft_limit(axis, bit, 0.0)


# ----------------------------------------------------------------------------------------------- operations


def _soft_bit(row: Keyword) -> int:
    return SOFT_LIMIT_FORWARD if row.name.endswith("FORWARD") else SOFT_LIMIT_REVERSE


def read_soft(errors: AxisErrors, row: Keyword, axis: int) -> float:
    """SOFTLIMITFORWARD and SOFTLIMITREVERSE: return a limit in user units."""
    return errors.scale(axis).to_user(errors.soft_limit(axis, _soft_bit(row)))


def write_soft(errors: AxisErrors, row: Keyword, axis: int, value: float) -> None:
    """SOFTLIMITFORWARD and SOFTLIMITREVERSE: set a limit in user units."""
    errors.set_soft_limit(axis, _soft_bit(row), errors.scale(axis).to_counts(value))


def is_at(*bits: int) -> Maker:
    """Make an operation that returns 1 while an axis is at one of these limits."""
    return of(AxisErrors, lambda errors, axis: int(any(errors.is_active(axis, bit) for bit in bits)))


def do_abort(errors: AxisErrors) -> None:
    """ABORT: make every axis react according to its ABORTMODE."""
    for axis in errors.controller.axes:
        action = errors.action(axis, ABORT)
        if action != "ignore":
            errors.controller.fault(axis, ABORT, action)


def do_line(environment: Environment, row: Keyword) -> Operation:
    """Return the operation that reports reaching a line that triggers a fault.

    The machine file names the line and the fault.
    """
    world = environment.machine.world
    assert world is not None
    return world.reach


# ------------------------------------------------------------------------------------------------- keywords

_MODE = Actions(read=setting_reader(AxisErrors), write=repeatable(setting_writer(AxisErrors)))
_SOFT = Actions(read=of_word(AxisErrors, read_soft), write=repeatable(of_word(AxisErrors, write_soft)))
_ERROR = Actions(
    read=of(Environment, lambda e, axis: e.controller.faults(axis)),
    write=of(Environment, lambda e, axis, value: e.controller.clear_faults(axis)),
)

_CLEAR = "JOG(0) = 100\nWAIT = 100\nABORT\nPRINT AXISERROR(0)\nCANCEL(0)\nPRINT AXISERROR(0)"


def _mode(name: str, help: str) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", "integer", _MODE,
                   f"{help}: one of _emIGNORE, _emCRASH_STOP, _emCRASH_STOP_DISABLE, _emERROR_DECEL, "
                   "_emERROR_DECEL_DISABLE, _emCALL_EVENT.",
                   f"{name}(0) = _emERROR_DECEL\nPRINT {name}(0)", default=float(MODES[name]), low=0, high=5,
                   group="limits")  # fmt: skip


def switch_row(name: str, short: str, actions: Actions, help: str) -> Keyword:
    return Keyword(name, short, "reading", "R", "axis", "bool", actions, help, f"PRINT {name}(0)", default=0.0,
                   group="limits", driven="input")  # fmt: skip


def _soft(name: str, effect: str, help: str) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", "uu", _SOFT, help,
                   "SOFTLIMITFORWARD(0) = 250\nSOFTLIMITREVERSE(0) = -5\nPRINT SOFTLIMITFORWARD(0)",
                   default=0.0, low=-8388607.0, high=8388607.0, group="limits", effect=effect)  # fmt: skip


_MODES = (
    ("IGNORE", "nothing is done"),
    ("CRASH_STOP", "stop at once"),
    ("CRASH_STOP_DISABLE", "stop at once and switch the drive off"),
    ("ERROR_DECEL", "stop at ERRORDECEL"),
    ("ERROR_DECEL_DISABLE", "stop at ERRORDECEL, then switch the drive off"),
    ("CALL_EVENT", "only the event ONERROR"),
)
_CONSTANTS = tuple(
    constant(f"_em{name}", value, f"Modes of errors: {help}.")
    for value, (name, help) in enumerate(_MODES)
)  # fmt: skip


ROWS = (
    *_CONSTANTS,
    _soft("SOFTLIMITFORWARD", "upper", "Software limit of forward travel; two limits of 0 are none."),
    _soft("SOFTLIMITREVERSE", "lower", "Software limit of reverse travel; two limits of 0 are none."),
    _mode("SOFTLIMITMODE", "Reaction of the axis to a software limit"),
    _mode("LIMITMODE", "Reaction of the axis to a limit switch"),
    switch_row("LIMITFORWARD", "lf", Actions(read=is_at(LIMIT_FORWARD)), "1 while the forward limit switch is active."),
    switch_row("LIMITREVERSE", "lr", Actions(read=is_at(LIMIT_REVERSE)), "1 while the reverse limit switch is active."),
    switch_row("LIMIT", "", Actions(read=is_at(LIMIT_FORWARD, LIMIT_REVERSE)),
            "1 while one of the two limit switches is active."),
    _mode("FOLERRORMODE", "Reaction of the axis to a fatal following error"),
    _mode("ERRORINPUTMODE", "Reaction of the axis when its error input becomes active"),
    Keyword("AXISERROR", "", "setting", "RW", "axis", "bits", _ERROR,
            "Errors of the axis: bit 0 abort, 1 error input, 2 forward limit, 3 reverse limit, 4 forward soft limit, "
            "5 reverse soft limit, 6 following error, 7 analogue limit, 8 drive. Writing 0 clears them; until then the "
            "axis takes no motion.",
            _CLEAR, default=0.0, low=0, high=0, group="limits"),
    Keyword("ERRORDECEL", "", "setting", "RW", "axis", "uu/s2", "error_decel",
            "Deceleration of stops because of an error or of the stop input.",
            "ERRORDECEL(0) = 5000\nPRINT ERRORDECEL(0)", default=100000.0, low=0.0, high=1e12, group="limits"),
    _mode("ABORTMODE", "Reaction of the axis to ABORT"),
    Keyword("ABORT", "", "command", "C", "none", "", Actions(do=of(AxisErrors, do_abort)),
            "Stop every axis as its ABORTMODE says, and note the error on it.",
            _CLEAR, group="stopping", effect="stop abrupt all"),
)  # fmt: skip
HIDDEN = (
    Keyword("(line)", "", "command", "C", "line", "", Actions(do=do_line),
            "The program has come to a line.", group="limits"),
)  # fmt: skip
