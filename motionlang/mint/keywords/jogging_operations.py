"""JOG, and jogging by a command at a preset speed: JOGCOMMAND, JOGSPEED, JOGMODE, JOGDURATION."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.keywords.axis_settings import forget
from motionlang.mint.keywords.drives_operations import top_speed
from motionlang.mint.runtime.binding import axis_of, scale_of
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.clock import Event
    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]
    Rates = tuple[float | None, float | None]

INFINITY = float("inf")
CONTINUOUS, TIMED = range(2)
COMMAND = "JOGCOMMAND"
_RAMPS = ("JOGACCELTIMEMAX", "JOGDECELTIMEMAX")


class Jogs:
    """What jogs go by, by keyword and axis (speeds in counts/s, times in ms), and the commands in force."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._controller = environment.controller
        self._settings: dict[tuple[str, int], float] = {}
        self.commands: dict[int, int] = {}
        # When the jog of a command began, and the end of one whose time is limited.
        self._began: dict[int, float] = {}
        self._ends: dict[int, Event] = {}

    def setting(self, name: str, axis: int) -> float:
        return self._settings.get((name, axis), 0.0)

    def set(self, name: str, axis: int, value: float) -> None:
        """Set a value; a new JOGSPEED acts at once on a jog that JOGCOMMAND keeps going."""
        self._settings[name, axis] = value
        if name == "JOGSPEED" and self.commanded(axis):
            self._jog(axis, self.commands[axis], self._controller.axes[axis].move.line)  # type: ignore[union-attr]

    def rates(self, axis: int) -> Rates | None:
        """Acceleration and deceleration of jogs, None where they are those of moves."""
        times = [self.setting(name, axis) for name in _RAMPS]
        if not any(times):
            return None

        top = top_speed(self._environment, axis)
        accel, decel = (top / time * 1000.0 if time else None for time in times)
        return accel, decel

    def jog(self, axis: int, velocity: float, command: str, line: int) -> None:
        """Ramp to a velocity, counts/s, and keep it; 0 brings the axis to rest, which is the end of it."""
        rates = self.rates(axis) if self._settings else None
        more = (rates, True) if rates is not None or not velocity else ()
        self._controller.jog(axis, velocity, command, line, *more)

    def command(self, axis: int, direction: int, line: int) -> None:
        """Jog by JOGCOMMAND: 1 forwards, -1 in reverse, 0 to rest; with JOGMODE 1 for a time, once a command."""
        timed, before = self.setting("JOGMODE", axis) == TIMED, self.commands.get(axis, 0)
        if timed and direction and direction == before:
            return
        self._jog(axis, direction, line)
        self.commands[axis] = direction
        if not direction or direction != before:
            self._began[axis] = self._environment.clock.now
            self._limit(axis, self.setting("JOGDURATION", axis) / 1000.0 if timed and direction else None)

    def commanded(self, axis: int) -> bool:
        """Whether the axis jogs by a command now."""
        move = self._controller.axes[axis].move
        return (
            move is not None and move.command == COMMAND and not move.ended and bool(self.commands.get(axis))
        )

    def elapsed(self, axis: int, level: float | None = None) -> int:
        """Milliseconds since the jog of a command began, 0 while there is none."""
        return self._environment.elapsed(self._began[axis], level) if self.commanded(axis) else 0

    def default(self, axis: int) -> None:
        """DEFAULT."""
        forget(self._settings, axis)
        self.commands.pop(axis, None)

    def _jog(self, axis: int, direction: int, line: int) -> None:
        speed = self.setting("JOGSPEED", axis)
        if direction and not speed:
            raise Refusal("zero-speed", f"axis {axis} cannot jog: its JOGSPEED is 0", "set JOGSPEED first")
        self.jog(axis, direction * speed, COMMAND, line)

    def _limit(self, axis: int, seconds: float | None) -> None:
        event = self._ends.pop(axis, None)
        if event is not None:
            event.cancel()
        if seconds is not None:
            clock = self._environment.clock
            self._ends[axis] = clock.at(clock.now + seconds, lambda: self._over(axis))

    def _over(self, axis: int) -> None:
        if self.commanded(axis):
            move = self._controller.axes[axis].move
            assert move is not None
            self.jog(axis, 0.0, COMMAND, move.line)


# ----------------------------------------------------------------------------------------------- operations


@repeatable
def write_velocity(environment: Environment, row: Row) -> Operation:
    """JOG: user units a second, the sign the direction, kept until something else is said."""
    jogs = environment.part(Jogs)

    def write(axis: int, value: float, line: int) -> None:
        row.check(value)
        jogs.jog(axis, scale_of(environment, axis).to_counts(value, row.unit), row.name, line)
        environment.jogs[axis] = value

    return write


def read_velocity(environment: Environment, row: Row) -> Operation:
    return lambda axis: float(environment.jogs.get(axis_of(environment, axis), 0.0))


def read_setting(environment: Environment, row: Row) -> Operation:
    """JOGSPEED in user units a second, JOGMODE, and times in ms."""
    jogs, name, unit = environment.part(Jogs), row.name, row.unit

    def read(axis: int) -> float:
        value = scale_of(environment, axis).to_user(jogs.setting(name, axis), unit)
        return value if unit.startswith("uu") else int(value)

    return read


@repeatable
def write_setting(environment: Environment, row: Row) -> Operation:
    """JOGSPEED in user units a second, JOGMODE, and times in ms."""
    jogs, name, unit = environment.part(Jogs), row.name, row.unit

    def write(axis: int, value: float) -> None:
        row.check(value)
        jogs.set(name, axis, abs(scale_of(environment, axis).to_counts(value, unit)))

    return write


def read_command(environment: Environment, row: Row) -> Operation:
    jogs = environment.part(Jogs)
    return lambda axis: jogs.commands.get(axis_of(environment, axis), 0)


def write_command(environment: Environment, row: Row) -> Operation:
    """JOGCOMMAND."""
    jogs = environment.part(Jogs)

    def write(axis: int, direction: int, line: int) -> None:
        row.check(direction)
        jogs.command(axis_of(environment, axis), direction, line)

    return write


def read_time(environment: Environment, row: Row) -> Operation:
    jogs = environment.part(Jogs)
    return lambda axis, level=None: jogs.elapsed(axis_of(environment, axis), level)


OPERATIONS = {
    "jogging.setting": {"read": read_setting, "write": write_setting},
    "jogging.command": {"read": read_command, "write": write_command},
    "jogging.time": {"read": read_time},
    "jogging.velocity": {"read": read_velocity, "write": write_velocity},
}
