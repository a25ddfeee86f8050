"""HOME: its types, its speeds, and what it leaves behind."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.controller.triggers.homing import HOME, LIMIT, STATES, Homing
from motionlang.mint.keywords.axis_settings import forget
from motionlang.mint.keywords.defaults import HOME_BACKOFF, HOME_SPEED, HOME_TYPES
from motionlang.mint.keywords.limits_switches import NONE, Switches
from motionlang.mint.runtime.binding import axis_of, scale_of
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]


class Homes:
    """The homing of every axis: settings in counts, what is going on, what was found."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._settings: dict[tuple[str, int], float] = {}
        self._active: dict[int, Homing] = {}
        self.types: dict[int, int] = {}
        self.found: dict[int, bool] = {}
        # Where the datum was found, as the axis counted until then.
        self.before: dict[int, float] = {}

    def setting(self, name: str, axis: int) -> float:
        """A setting, or what stands for it while it has not been written."""
        value = self._settings.get((name, axis))
        if value is not None:
            return value
        if name == "HOMECREEPSPEED":
            return self.setting("HOMESPEED", axis) / self.setting("HOMEBACKOFF", axis)
        if name in ("HOMEACCEL", "HOMEDECEL"):
            a = self._environment.controller.axes[axis]
            return a.rates(a.speed)[name == "HOMEDECEL"]
        return {"HOMESPEED": HOME_SPEED, "HOMEBACKOFF": HOME_BACKOFF}.get(name, 0.0)

    def set(self, name: str, axis: int, value: float) -> None:
        self._settings[name, axis] = value

    def phase(self, axis: int) -> int:
        """Where the homing is, as the place among `STATES`."""
        homing = self._active.get(axis)
        return 0 if homing is None else STATES.index(homing.state)

    def begin(self, axis: int, kind: int, line: int) -> None:
        """HOME(axis) = kind."""
        controller = self._environment.controller
        if not controller.is_idle(axis):
            raise Refusal("moving", f"axis {axis} is moving", "HOME needs the axis at rest")
        _, direction, switch, index = HOME_TYPES[kind]
        self.types[axis], self.found[axis] = kind, False
        provided = self._provided(axis, switch, index, line)
        self._borrow(axis)
        speed = self.setting("HOMESPEED", axis)
        try:
            self._active[axis] = Homing(
                controller,
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
            self.before[homing.axis] = homing.before

    def _borrow(self, axis: int) -> None:
        """HOMEACCEL and HOMEDECEL stand in for ACCEL and DECEL for as long as the homing lasts."""
        accel, decel = (self._settings.get((name, axis)) for name in ("HOMEACCEL", "HOMEDECEL"))
        self._environment.controller.lend_rates(axis, accel, decel)

    def _give_back(self, axis: int) -> None:
        self._environment.controller.return_rates(axis)

    def _provided(self, axis: int, switch: str, index: bool, line: int) -> bool:
        """Whether the machine has all that is looked for; says beforehand what it lacks."""
        environment = self._environment
        a = environment.controller.axes[axis]
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
            environment.machine.complain(Diagnostic("never", message, line, hint=hint, severity="warning"))
        return not missing

    def _has_switch(self, axis: int) -> bool:
        machine = self._environment.machine
        if machine.settings.get(f"axis.{axis}.home_switch") is not None:
            return True

        channel = self._environment.part(Switches).channel("HOMEINPUT", axis)
        return channel != NONE and machine.world is not None and channel in machine.world.driven

    def default(self, axis: int) -> None:
        """DEFAULT."""
        forget(self._settings, axis)


# ----------------------------------------------------------------------------------------------- operations


def write_home(environment: Environment, row: Row) -> Operation:
    """HOME: begin a search of the type given."""
    homes = environment.part(Homes)

    def write(axis: int, kind: int, line: int) -> None:
        row.check(kind)
        homes.begin(axis_of(environment, axis), kind, line)

    return write


def read_home(environment: Environment, row: Row) -> Operation:
    types = environment.part(Homes).types
    return lambda axis: types.get(axis_of(environment, axis), 0)


def write_type(environment: Environment, row: Row) -> Operation:
    """HOMETYPE."""
    types = environment.part(Homes).types

    def write(axis: int, kind: int) -> None:
        row.check(kind)
        types[axis_of(environment, axis)] = kind

    return write


read_type = read_home


def read_setting(environment: Environment, row: Row) -> Operation:
    homes, name, unit = environment.part(Homes), row.name, row.unit
    return lambda axis: scale_of(environment, axis).to_user(homes.setting(name, axis), unit)


@repeatable
def write_setting(environment: Environment, row: Row) -> Operation:
    """HOMESPEED, HOMEOFFSET and the like, user units of the axis."""
    homes, name, unit = environment.part(Homes), row.name, row.unit

    def write(axis: int, value: float) -> None:
        row.check(value)
        homes.set(name, axis, scale_of(environment, axis).to_counts(value, unit))

    return write


def read_phase(environment: Environment, row: Row) -> Operation:
    homes = environment.part(Homes)
    return lambda axis: homes.phase(axis_of(environment, axis))


def read_status(environment: Environment, row: Row) -> Operation:
    found = environment.part(Homes).found
    return lambda axis: int(found.get(axis_of(environment, axis), False))


def write_status(environment: Environment, row: Row) -> Operation:
    """HOMESTATUS: the program says itself whether the axis is homed."""
    found = environment.part(Homes).found

    def write(axis: int, value: int) -> None:
        found[axis_of(environment, axis)] = bool(value)

    return write


def read_position(environment: Environment, row: Row) -> Operation:
    """HOMEPOS: what POS was at the datum before homing gave it another value."""
    before, wraps = environment.part(Homes).before, environment.wraps

    def read(axis: int) -> float:
        scale = scale_of(environment, axis)
        if axis not in before:
            return 0.0
        found, wrap = scale.position_to_user(before[axis]), wraps.get(axis)
        return found % wrap if wrap else found

    return read


OPERATIONS = {
    "homing.home": {"read": read_home, "write": write_home},
    "homing.type": {"read": read_type, "write": write_type},
    "homing.setting": {"read": read_setting, "write": write_setting},
    "homing.position": {"read": read_position},
    "homing.status": {"read": read_status, "write": write_status},
    "homing.phase": {"read": read_phase},
}
