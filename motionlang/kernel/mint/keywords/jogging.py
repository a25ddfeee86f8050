"""JOG, and jogging by command at a preset speed.

The commands are JOGCOMMAND, JOGSPEED, JOGMODE and JOGDURATION.
"""

from __future__ import annotations

from motionlang.kernel.controller.clock import TimedCall
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.drives import top_speed
from motionlang.kernel.mint.runtime.binding import of, of_word
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

Rates = tuple[float | None, float | None]


CONTINUOUS, TIMED = range(2)
COMMAND = "JOGCOMMAND"
_RAMPS = ("JOGACCELTIMEMAX", "JOGDECELTIMEMAX")


class Jogs(StoredSettings):
    """The settings of jogs, by keyword and axis, and the commands in force.

    Speeds are in counts/s, times in ms.
    """

    in_counts = unsigned = True

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.commands: dict[int, int] = {}
        # The start time of a commanded jog, and the end event of one with limited time.
        self._began: dict[int, float] = {}
        self._ends: dict[int, TimedCall] = {}

    def set(self, name: str, axis: int, value: float) -> None:
        """Write a setting; a new JOGSPEED also changes a JOGCOMMAND jog in progress."""
        super().set(name, axis, value)
        if name == "JOGSPEED" and self.commanded(axis):
            self._jog(axis, self.commands[axis], self.controller.axes[axis].move.line)  # type: ignore[union-attr]

    def rates(self, axis: int) -> Rates | None:
        """Return acceleration and deceleration of jogs, None if moves' rates apply."""
        times = [self.setting(name, axis) for name in _RAMPS]
        if not any(times):
            return None

        top = top_speed(self.environment, axis)
        accel, decel = (top / time * 1000.0 if time else None for time in times)
        return accel, decel

    def jog(self, axis: int, velocity: float, command: str, line: int) -> None:
        """Ramp to a velocity in counts/s and hold it; 0 brings the axis to rest."""
        rates = self.rates(axis) if self._settings else None
        more = (rates, True) if rates is not None or not velocity else ()
        self.controller.jog(axis, velocity, command, line, *more)

    def command(self, axis: int, direction: int, line: int) -> None:
        """JOGCOMMAND: jog forward (1), in reverse (-1), or ramp to rest (0).

        With JOGMODE 1 the jog ends after JOGDURATION, once per command.
        """
        timed, before = self.setting("JOGMODE", axis) == TIMED, self.commands.get(axis, 0)
        if timed and direction and direction == before:
            return
        self._jog(axis, direction, line)
        self.commands[axis] = direction
        if not direction or direction != before:
            self._began[axis] = self.environment.clock.now
            self._limit(axis, self.setting("JOGDURATION", axis) / 1000.0 if timed and direction else None)

    def commanded(self, axis: int) -> bool:
        """True if a JOGCOMMAND jog is in progress."""
        move = self.controller.axes[axis].move
        return (
            move is not None and move.command == COMMAND and not move.ended and bool(self.commands.get(axis))
        )

    def elapsed(self, axis: int, level: float | None = None) -> int:
        """Return the ms since the start of a JOGCOMMAND jog, 0 without one."""
        return self.environment.elapsed(self._began[axis], level) if self.commanded(axis) else 0

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        super().default(axis)
        self.commands.pop(axis, None)

    def _jog(self, axis: int, direction: int, line: int) -> None:
        speed = self.setting("JOGSPEED", axis)
        if direction and not speed:
            raise Rejected("zero-speed", f"axis {axis} cannot jog: its JOGSPEED is 0", "set JOGSPEED first")
        self.jog(axis, direction * speed, COMMAND, line)

    def _limit(self, axis: int, seconds: float | None) -> None:
        event = self._ends.pop(axis, None)
        if event is not None:
            event.cancel()
        if seconds is not None:
            clock = self.environment.clock
            self._ends[axis] = clock.at(clock.now + seconds, lambda: self._over(axis))

    def _over(self, axis: int) -> None:
        if self.commanded(axis):
            move = self.controller.axes[axis].move
            assert move is not None
            self.jog(axis, 0.0, COMMAND, move.line)


# ----------------------------------------------------------------------------------------------- operations


def write_velocity(environment: Environment, row: Keyword, axis: int, value: float, line: int) -> None:
    """JOG: run at a velocity in user units per second until the next command.

    The sign is the direction.
    """
    velocity = environment.controller.axes[axis].scale.to_counts(value, row.unit)
    environment.component(Jogs).jog(axis, velocity, row.name, line)
    environment.jogs[axis] = value


# ------------------------------------------------------------------------------------------------- keywords

_SETTING = Actions(read=setting_reader(Jogs), write=repeatable(setting_writer(Jogs)))
_COMMAND = Actions(read=of(Jogs, lambda jogs, axis: jogs.commands.get(axis, 0)), write=of(Jogs, Jogs.command))
_JOG = Actions(
    read=of(Environment, lambda e, axis: float(e.jogs.get(axis, 0.0))),
    write=repeatable(of_word(Environment, write_velocity)),
)

_MAX_VALUE = 8388607.0
_MAX_TIME = 2147483647.0
_PANEL = "JOGSPEED(0) = 100 : JOGMODE(0) = 1 : JOGDURATION(0) = 300\nJOGCOMMAND(0) = 1\nWAIT = 100\n"


def _setting(
    name: str, short: str, unit: str, help: str, example: str, high: float, low: float = 0.0
) -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", unit, _SETTING, help, example, default=0.0, low=low,
                   high=high, group="axis")  # fmt: skip


ROWS = (
    Keyword("JOG", "JG", "setting", "RW", "axis", "uu/s", _JOG,
            "Run at a constant speed, its sign the direction, until stopped or given another speed; 0 brings the axis "
            "to rest and ends it.",
            "JOG(0) = 100\nWAIT = 500\nPRINT VEL(0)\nSTOP(0)\nPAUSE IDLE(0)",
            default=0.0, low=-8388607.0, high=8388607.0, group="motion", effect="act endless"),
    _setting("JOGSPEED", "jgs", "uu/s", "The speed at which JOGCOMMAND jogs; a new one acts at once.",
             "JOGSPEED(0) = 100\nJOGCOMMAND(0) = -1\nWAIT = 100\nPRINT VEL(0)\nJOGCOMMAND(0) = 0", _MAX_VALUE),
    Keyword("JOGCOMMAND", "jgc", "setting", "RW", "axis", "integer", _COMMAND,
            "Jog at JOGSPEED: 1 forwards, -1 in reverse; 0 brings the axis to rest. It keeps its value until it is "
            "written again, also when JOGDURATION has ended the jog.",
            _PANEL + "PRINT VEL(0)\nPAUSE IDLE(0)\nPRINT POS(0)", default=0.0, low=-1, high=1,
            group="motion", effect="act"),
    _setting("JOGMODE", "", "integer",
             "End of a jog by JOGCOMMAND: 0 when JOGCOMMAND is 0, 1 after JOGDURATION, once for each new command.",
             "JOGMODE(0) = 1\nPRINT JOGMODE(0)", 1),
    _setting("JOGDURATION", "", "ms",
             "After how many milliseconds a jog of JOGMODE 1 begins to come to rest.",
             "JOGDURATION(0) = 500\nPRINT JOGDURATION(0)", _MAX_TIME),
    Keyword("JOGTIME", "", "reading", "R", "axis", "integer", Actions(read=of(Jogs, Jogs.elapsed)),
            "Milliseconds since the start of the jog by JOGCOMMAND; 0 without a jog.",
            _PANEL + "PRINT JOGTIME(0)\nPAUSE IDLE(0)", default=0.0, group="state", solved=True),
    _setting("JOGACCELTIMEMAX", "", "ms",
             "Acceleration of jogs, given as the time from rest to DRIVESPEEDMAX or, where that is not set, MAXSPEED "
             "or SPEED; 0 for ACCEL.",
             "MAXSPEED(0) = 200 : JOGACCELTIMEMAX(0) = 1000\nJOG(0) = 100\nWAIT = 250\nPRINT VEL(0)\nCANCEL(0)",
             _MAX_TIME),
    _setting("JOGDECELTIMEMAX", "", "ms",
             "Deceleration of jogs, given as the time from that speed to rest; 0 for DECEL.",
             "MAXSPEED(0) = 200 : JOGDECELTIMEMAX(0) = 1000\nJOG(0) = 100\nWAIT = 250\nSTOP(0)\nPAUSE IDLE(0)\n"
             "PRINT POS(0)", _MAX_TIME),
)  # fmt: skip
