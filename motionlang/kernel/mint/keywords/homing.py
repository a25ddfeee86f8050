"""HOME: its types, its speeds and its results."""

from __future__ import annotations

from motionlang.kernel.controller.faults import LIMIT_FORWARD, LIMIT_REVERSE
from motionlang.kernel.controller.triggers.homing import HOME, LIMIT, STATES, Homing
from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.keyword import Actions, Keyword, constant
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.defaults import HOME_BACKOFF, HOME_SPEED, HOME_TYPES
from motionlang.kernel.mint.keywords.limits_switches import HOME_SWITCH, NONE, SWITCH_INPUT, SwitchInputs
from motionlang.kernel.mint.runtime.binding import of, scale_of, unchecked
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

_DEFAULTS = {"HOMESPEED": HOME_SPEED, "HOMEBACKOFF": HOME_BACKOFF}


class Homes(StoredSettings):
    """The homing of every axis: settings in counts, present state and results."""

    defaults = _DEFAULTS
    in_counts = True

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self._active: dict[int, Homing] = {}
        self.types: dict[int, int] = {}
        self.found: dict[int, bool] = {}
        # The position of the datum in the coordinates before homing.
        self._before: dict[int, float] = {}

    def setting(self, name: str, axis: int) -> float:
        """Return a setting or, until it is written, the value used in its place."""
        if (name, axis) not in self._settings:
            if name == "HOMECREEPSPEED":
                return self.setting("HOMESPEED", axis) / self.setting("HOMEBACKOFF", axis)
            if name in ("HOMEACCEL", "HOMEDECEL"):
                a = self.controller.axes[axis]
                return a.rates(a.speed)[name == "HOMEDECEL"]
        return super().setting(name, axis)

    def position_before(self, axis: int) -> float:
        """HOMEPOS: return POS at the datum, before homing set it to a new value."""
        before = self._before.get(axis)
        return 0.0 if before is None else scale_of(self.environment, axis).shown_position(before)

    def phase(self, axis: int) -> int:
        """Return the state of the homing as its index in `STATES`."""
        homing = self._active.get(axis)
        return 0 if homing is None else STATES.index(homing.state)

    def begin(self, axis: int, kind: int, line: int) -> None:
        """HOME: start homing of a type."""
        self.controller.require_idle(axis, "HOME")
        _, direction, switch, index = HOME_TYPES[kind]
        self.types[axis], self.found[axis] = kind, False
        provided = self._provided(axis, direction, switch, index, line)
        speed = self.setting("HOMESPEED", axis)
        self._active[axis] = Homing(
            self.controller.axes[axis],
            direction,
            speed,
            speed / self.setting("HOMEBACKOFF", axis),
            self.setting("HOMECREEPSPEED", axis),
            switch=switch,
            index=index,
            datum=self.setting("HOMEREFPOS", axis),
            offset=self.setting("HOMEOFFSET", axis),
            rates=(self._settings.get(("HOMEACCEL", axis)), self._settings.get(("HOMEDECEL", axis))),
            provided=provided,
            ended=self._ended,
            line=line,
        )

    def _ended(self, homing: Homing) -> None:
        axis = homing.a.index
        self._active.pop(axis, None)
        self.found[axis] = homing.found
        if homing.found:
            self._before[axis] = homing.before

    def _provided(self, axis: int, direction: int, switch: str, index: bool, line: int) -> bool:
        """True if the machine has all switches and marks that HOME searches for.

        Warns of those that are missing.
        """
        a = self.controller.axes[axis]
        missing = []
        if switch == HOME and not self._has_switch(axis):
            missing.append(f"a home switch on axis {axis}")
        end = LIMIT_FORWARD if direction > 0 else LIMIT_REVERSE
        if switch == LIMIT and all(limit.bit != end for limit in a.limits):
            missing.append(f"a limit switch on axis {axis}")
        if index and not a.index_every > 0:
            missing.append(f"index marks on axis {axis}")
        if missing:
            hint = f"the machine file sets them: axis.{axis}.home_switch, travel and index_every"
            message = f"HOME looks for {' and '.join(missing)}, which nothing provides"
            diagnostic = Diagnostic("never", message, line, hint=hint, severity="warning")
            self.environment.machine.complain(diagnostic)
        return not missing

    def _has_switch(self, axis: int) -> bool:
        machine = self.environment.machine
        if machine.settings.get(f"axis.{axis}.home_switch") is not None:
            return True

        channel = self.environment.component(SwitchInputs).channel("HOMEINPUT", axis)
        return channel != NONE and machine.world is not None and channel in machine.world.driven


# ----------------------------------------------------------------------------------------------- operations


def write_type(homes: Homes, axis: int, kind: int) -> None:
    homes.types[axis] = kind


def write_status(homes: Homes, axis: int, value: int) -> None:
    """HOMESTATUS: let the program set whether the axis is homed."""
    homes.found[axis] = bool(value)


_TYPE = of(Homes, lambda homes, axis: homes.types.get(axis, 0))


# ------------------------------------------------------------------------------------------------- keywords

_SETTING = Actions(read=setting_reader(Homes), write=repeatable(setting_writer(Homes)))
_STATUS = Actions(
    read=of(Homes, lambda homes, axis: int(homes.found.get(axis, False))),
    write=unchecked(of(Homes, write_status)),
)

_HOMED = "If HOMEINPUT(0) >= 0 Then HOME(0) = _hmNEGATIVE_SWITCH\nPAUSE IDLE(0)\nPRINT {}(0)"


def _setting(
    name: str, unit: str, value: str, help: str, default: float | None, low: float, high: float
) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, _SETTING, help,
                   f"{name}(0) = {value}\nPRINT {name}(0)", default=default, low=low, high=high,
                   group="homing")  # fmt: skip


def _what(direction: int, switch: str, index: bool) -> str:
    towards = "forward" if direction > 0 else "in reverse"
    where = {"home": "the home switch", "limit": "the limit switch", "index": "the encoder's index"}[switch]
    return f"HOME: {towards} to {where}{', then to the index' if index and switch != 'index' else ''}."


ROWS = (
    Keyword("HOME", "HM", "setting", "RW", "axis", "integer", Actions(read=_TYPE, write=of(Homes, Homes.begin)),
            "Find the datum of the axis: run to the switch, leave it slowly, go on to the index; one of the _hm types.",
            _HOMED.format("HOME"), low=0, high=len(HOME_TYPES) - 1, group="motion", effect="act datum"),
    Keyword("HOMETYPE", "", "setting", "RW", "axis", "integer", Actions(read=_TYPE, write=of(Homes, write_type)),
            "The type of homing, as HOME was given it last.",
            "HOMETYPE(0) = _hmPOSITIVE_SWITCH\nPRINT HOMETYPE(0)",
            default=0.0, low=0, high=len(HOME_TYPES) - 1, group="homing"),
    _setting("HOMESPEED", "uu/s", "50", "Speed of the search for the switch.", HOME_SPEED, 1e-6, 8388607.0),
    _setting("HOMEBACKOFF", "number", "20", "Divisor of HOMESPEED while the axis leaves the switch.",
             HOME_BACKOFF,
             1.0, 1e6),
    _setting("HOMECREEPSPEED", "uu/s", "2", "Speed of the search for the index after the switch, and of the way to "
             "HOMEOFFSET; HOMESPEED / HOMEBACKOFF until it is set.", None, 1e-6, 8388607.0),
    _setting("HOMEACCEL", "uu/s2", "1000", "Acceleration while homing; ACCEL until it is set.", None, 1e-6, 1e12),
    _setting("HOMEDECEL", "uu/s2", "1000", "Deceleration while homing; DECEL until it is set.", None, 1e-6, 1e12),
    _setting("HOMEOFFSET", "uu", "5", "Distance of the end of homing from the datum.", 0.0, -8388607.0, 8388607.0),
    _setting("HOMEREFPOS", "uu", "100", "Position that homing gives the datum.", 0.0, -8388607.0, 8388607.0),
    Keyword("HOMEPOS", "HPS", "reading", "R", "axis", "uu", Actions(read=of(Homes, Homes.position_before)),
            "The position that the axis had at its datum before homing set it: POS(0) = HOMEPOS(0) afterwards counts "
            "as if the axis had not been homed, and after a second homing it shows slip or lost steps.",
            _HOMED.format("HOMEPOS"), default=0.0, low=-8388607.0, high=8388607.0, group="homing"),
    Keyword("HOMESTATUS", "", "setting", "RW", "axis", "bool", _STATUS,
            "1 when the axis has found its datum.",
            _HOMED.format("HOMESTATUS"), default=0.0, low=0, high=1, group="homing"),
    Keyword("HOMEPHASE", "", "reading", "R", "axis", "integer", Actions(read=of(Homes, Homes.phase)),
            "Phase of homing: 0 complete, 1 search, 2 stopping on the switch, 3 leaving it, 4 looking "
            "for the index, 5 stopping behind the datum, 6 moving to HOMEOFFSET.",
            _HOMED.format("HOMEPHASE"), default=0.0, group="homing"),
    Keyword("HOMEINPUT", "hi", "setting", "RW", "axis", "integer", SWITCH_INPUT,
            "The input that is the home switch of the axis; -1 for none.",
            "HOMEINPUT(0) = 2\nPRINT HOMEINPUT(0)", default=-1.0, low=-1, high=999, group="homing", selects="input"),
    Keyword("HOMESWITCH", "hsw", "reading", "R", "axis", "bool", HOME_SWITCH,
            "1 while the axis is on its home switch.",
            "PRINT HOMESWITCH(0)", default=0.0, group="homing", driven="input"),
    *(
        constant(name, value, _what(direction, switch, index))
        for value, (name, direction, switch, index) in enumerate(HOME_TYPES)
    ),
)  # fmt: skip
