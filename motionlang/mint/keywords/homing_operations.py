"""HOME: its types, its speeds, and what it leaves behind."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.controller.triggers.homing import HOME, LIMIT, STATES, Homing
from motionlang.mint.keywords.axis_settings import Settings, reading, writing
from motionlang.mint.keywords.defaults import HOME_BACKOFF, HOME_SPEED, HOME_TYPES
from motionlang.mint.keywords.limits_switches import NONE, Switches
from motionlang.mint.runtime.binding import of, unchecked
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment

_DEFAULTS = {"HOMESPEED": HOME_SPEED, "HOMEBACKOFF": HOME_BACKOFF}


class Homes(Settings):
    """The homing of every axis: settings in counts, what is going on, what was found."""

    defaults = _DEFAULTS
    in_counts = True

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self._active: dict[int, Homing] = {}
        self.types: dict[int, int] = {}
        self.found: dict[int, bool] = {}
        # Where the datum was found, as the axis counted until then.
        self._before: dict[int, float] = {}

    def setting(self, name: str, axis: int) -> float:
        """A setting, or what stands for it while it has not been written."""
        if (name, axis) not in self._settings:
            if name == "HOMECREEPSPEED":
                return self.setting("HOMESPEED", axis) / self.setting("HOMEBACKOFF", axis)
            if name in ("HOMEACCEL", "HOMEDECEL"):
                a = self.controller.axes[axis]
                return a.rates(a.speed)[name == "HOMEDECEL"]
        return super().setting(name, axis)

    def position_before(self, axis: int) -> float:
        """HOMEPOS: what POS was at the datum before homing gave it another value."""
        return self.environment.place(axis, self._before[axis]) if axis in self._before else 0.0

    def phase(self, axis: int) -> int:
        """Where the homing is, as the place among `STATES`."""
        homing = self._active.get(axis)
        return 0 if homing is None else STATES.index(homing.state)

    def begin(self, axis: int, kind: int, line: int) -> None:
        """HOME(axis) = kind."""
        if not self.controller.is_idle(axis):
            raise Refusal("moving", f"axis {axis} is moving", "HOME needs the axis at rest")
        _, direction, switch, index = HOME_TYPES[kind]
        self.types[axis], self.found[axis] = kind, False
        provided = self._provided(axis, switch, index, line)
        self._borrow(axis)
        speed = self.setting("HOMESPEED", axis)
        try:
            self._active[axis] = Homing(
                self.controller,
                axis,
                direction,
                speed,
                speed / self.setting("HOMEBACKOFF", axis),
                self.setting("HOMECREEPSPEED", axis),
                switch=switch,
                index=index,
                datum=self.setting("HOMEREFPOS", axis),
                offset=self.setting("HOMEOFFSET", axis),
                provided=provided,
                ended=self._ended,
                line=line,
            )
        except Refusal:
            self._give_back(axis)
            raise

    def _ended(self, homing: Homing) -> None:
        self._active.pop(homing.axis, None)
        self._give_back(homing.axis)
        self.found[homing.axis] = homing.found
        if homing.found:
            self._before[homing.axis] = homing.before

    def _borrow(self, axis: int) -> None:
        """HOMEACCEL and HOMEDECEL stand in for ACCEL and DECEL for as long as the homing lasts."""
        accel, decel = (self._settings.get((name, axis)) for name in ("HOMEACCEL", "HOMEDECEL"))
        self.controller.lend_rates(axis, accel, decel)

    def _give_back(self, axis: int) -> None:
        self.controller.return_rates(axis)

    def _provided(self, axis: int, switch: str, index: bool, line: int) -> bool:
        """Whether the machine has all that is looked for; says beforehand what it lacks."""
        a = self.controller.axes[axis]
        missing = []
        if switch == HOME and not self._has_switch(axis):
            missing.append(f"a home switch on axis {axis}")
        if switch == LIMIT and not a.limits:
            missing.append(f"a limit switch on axis {axis}")
        if index and not a.index_every > 0:
            missing.append(f"index marks on axis {axis}")
        if missing:
            from motionlang.errors import Diagnostic

            hint = f"the machine file sets them: axis.{axis}.home_switch, travel and index_every"
            message = f"HOME looks for {' and '.join(missing)}, which nothing provides"
            diagnostic = Diagnostic("never", message, line, hint=hint, severity="warning")
            self.environment.machine.complain(diagnostic)
        return not missing

    def _has_switch(self, axis: int) -> bool:
        machine = self.environment.machine
        if machine.settings.get(f"axis.{axis}.home_switch") is not None:
            return True

        channel = self.environment.part(Switches).channel("HOMEINPUT", axis)
        return channel != NONE and machine.world is not None and channel in machine.world.driven


# ----------------------------------------------------------------------------------------------- operations


def write_type(homes: Homes, axis: int, kind: int) -> None:
    homes.types[axis] = kind


def write_status(homes: Homes, axis: int, value: int) -> None:
    """HOMESTATUS: the program says itself whether the axis is homed."""
    homes.found[axis] = bool(value)


_TYPE = of(Homes, lambda homes, axis: homes.types.get(axis, 0))
OPERATIONS = {
    "homing.home": {"read": _TYPE, "write": of(Homes, Homes.begin)},
    "homing.type": {"read": _TYPE, "write": of(Homes, write_type)},
    "homing.setting": {"read": reading(Homes), "write": repeatable(writing(Homes))},
    "homing.position": {"read": of(Homes, Homes.position_before)},
    "homing.status": {
        "read": of(Homes, lambda homes, axis: int(homes.found.get(axis, False))),
        "write": unchecked(of(Homes, write_status)),
    },
    "homing.phase": {"read": of(Homes, Homes.phase)},
}
