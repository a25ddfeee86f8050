"""BACKLASH and PRECISION keywords: motion of the motor in addition to POS.

ENCODER shows this motion. A change of a setting does not move the motor: ENCODER continues from its last
value.
"""

from __future__ import annotations

from motionlang.kernel.controller.motion.takeup import Takeup
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword, constant
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.defaults import LOOP_TIME, PERIOD
from motionlang.kernel.mint.keywords.sensing import Encoders
from motionlang.kernel.mint.keywords.table_motion_cams import elements
from motionlang.kernel.mint.runtime.binding import of_word, scale_of
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.planners.leadscrew import Leadscrew

Array = list[float]


SINGLE, DUAL = 1, 2
_AT_REST = ("BACKLASH", "BACKLASHINTERVAL")


class Compensation(StoredSettings):
    """The compensation settings of each axis in user units, and the offset in counts."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.tables: dict[int, tuple[Array, Array | None]] = {}
        self._screws: dict[int, tuple[Leadscrew, Leadscrew]] = {}
        self._takeups: dict[int, Takeup] = {}
        # Offsets that keep ENCODER continuous when a setting changes.
        self._bases: dict[int, float] = {}
        environment.component(Encoders).compensation = self

    def set(self, name: str, axis: int, value: float) -> None:
        """Write a setting.

        Raises Rejected for a mode that lacks its data, and for a backlash setting while the axis moves. After a write
        to BACKLASH the motor is assumed to be at one end of the play, which the sign selects.
        """
        if name in _AT_REST:
            self.controller.require_idle(axis, name)
        before, previous = self.shift(axis), self._settings.get((name, axis))
        self._settings[name, axis] = value
        try:
            self._renew(axis)
        except Rejected:
            self._settings[name, axis] = previous or 0.0
            raise
        if name == "BACKLASH":
            self._takeup(axis).taken = 0.0
        self._bases[axis] = self._bases.get(axis, 0.0) + before - self.shift(axis)

    def default(self, axis: int) -> None:
        """Do nothing on DEFAULT: the screw and its backlash are properties of the machine."""

    def attach(self, axis: int, forward: Array, reverse: Array | None) -> None:
        """PRECISIONTABLE: set the tables; an active mode uses them at once."""
        before = self.shift(axis)
        self.tables[axis] = forward, reverse
        self._renew(axis)
        self._bases[axis] = self._bases.get(axis, 0.0) + before - self.shift(axis)

    def shift(self, axis: int) -> float:
        """Return the offset of the motor from POS in counts."""
        return self._bases.get(axis, 0.0) + self._advance(axis) + self._screwed(axis)[0]

    def rate(self, axis: int) -> float:
        """Return the rate of change of the offset in counts/s."""
        self._advance(axis)
        takeup = self._takeup(axis)
        slope = self._screwed(axis)[1]
        velocity = self.environment.controller.velocity(axis)
        return (slope - 1.0) * velocity + (takeup.rate() if self.setting("BACKLASHMODE", axis) else 0.0)

    def _advance(self, axis: int) -> float:
        now = self.environment.controller.clock.now
        return self._takeup(axis).advance(now, bool(self.setting("BACKLASHMODE", axis)))

    def _takeup(self, axis: int) -> Takeup:
        found = self._takeups.get(axis)
        if found is None:
            controller = self.environment.controller
            found = self._takeups[axis] = Takeup(controller.axes[axis], controller.clock.now)
        return found

    def _screwed(self, axis: int) -> tuple[float, float]:
        """Return the correction from the table in counts, and its slope there."""
        screws = self._screws.get(axis)
        if screws is None:
            return 0.0, 1.0
        screw = screws[self._takeup(axis).heading < 0]
        scale = scale_of(self.environment, axis)
        nut = scale.position_to_user(self.environment.controller.position(axis))
        return scale.to_counts(screw.motor(nut) - nut), screw.slope(nut)

    def _renew(self, axis: int) -> None:
        """Apply the settings of an axis to its compensation."""
        environment, takeup = self.environment, self._takeup(axis)
        mode = self.setting("PRECISIONMODE", axis)
        if mode == DUAL and self.setting("BACKLASHMODE", axis):
            raise Rejected("range", f"axis {axis} cannot have two tables and BACKLASHMODE 1",
                          "the two tables already include the backlash: set BACKLASHMODE(axis) = 0")  # fmt: skip
        screws = self._made(axis, mode == DUAL) if mode else None
        loop = environment.controller.gain(axis, PERIOD, LOOP_TIME)
        takeup.size = scale_of(environment, axis).to_counts(self.setting("BACKLASH", axis))
        takeup.ramp = self.setting("BACKLASHINTERVAL", axis) * loop * 1e-6
        if screws is None:
            self._screws.pop(axis, None)
        else:
            self._screws[axis] = screws

    def _made(self, axis: int, dual: bool) -> tuple[Leadscrew, Leadscrew]:
        if axis not in self.tables:
            raise Rejected(
                "range", f"axis {axis} has no precision table", f"PRECISIONTABLE({axis}, positions, NULL)"
            )
        start, step = self.setting("PRECISIONOFFSET", axis), self.setting("PRECISIONINCREMENT", axis)
        forward, reverse = self.tables[axis]
        try:
            screw = Leadscrew(start, step, elements(forward, "PRECISIONTABLE"))
            if not dual or reverse is None:
                return screw, screw
            return screw, Leadscrew(start, step, elements(reverse, "PRECISIONTABLE"))
        except ValueError as problem:
            raise Rejected("range", f"axis {axis}: {problem}") from None


# ----------------------------------------------------------------------------------------------- operations


def do_table(
    compensation: Compensation, row: Keyword, axis: int, forward: Array | None, reverse: Array | None
) -> None:
    """PRECISIONTABLE: set the tables of nut positions, forward and reverse."""
    if forward is None:
        raise Rejected("range", f"{row.word}: no forward table", "only the reverse table may be NULL")
    elements(forward, row.name)
    compensation.attach(axis, forward, reverse)


# ------------------------------------------------------------------------------------------------- keywords

_SETTING = Actions(read=setting_reader(Compensation), write=setting_writer(Compensation))

_MAX_VALUE = 8388607.0
_PLAY = (
    "BACKLASH(0) = 2 : BACKLASHINTERVAL(0) = 200 : BACKLASHMODE(0) = 1\n"
    "MOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0), ENCODER(0)"
)
_TABLE = (
    "Dim nut(4) As Float = 3, 0, 101, 199\nPRECISIONTABLE(0, nut, NULL)\nPRECISIONINCREMENT(0) = 100\n"
    "PRECISIONOFFSET(0) = 0\n"
    "PRECISIONMODE(0) = _lsSINGLE_TABLE\nMOVEA(0) = 101\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0), ENCODER(0)"
)


def _setting(name: str, short: str, unit: str, help: str, example: str, low: float, high: float) -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", unit, _SETTING, help, example, default=0.0,
                   low=low, high=high, group="compensation")  # fmt: skip


ROWS = (
    _setting("BACKLASH", "", "uu",
             "The play of the axis. Its sign is the direction in which homing took the play up: positive, the motor "
             "needs the whole of it to go forward and nothing to go in reverse; negative, the other way round. The "
             "axis must be idle.", _PLAY, -_MAX_VALUE, _MAX_VALUE),
    _setting("BACKLASHINTERVAL", "BLI", "integer",
             "Servo cycles of LOOPTIME over which the play is taken up, while the axis moves; 0 at once. The axis must "
             "be idle.", _PLAY, 0, _MAX_VALUE),
    _setting("BACKLASHMODE", "BLM", "integer", "1: play is compensated. Not with _lsDUAL_TABLE.",
             _PLAY, 0, 1),
    constant("_blOFF", 0, "BACKLASHMODE: off."),
    Keyword("PRECISIONTABLE", "", "command", "C", "axis, array, array", "",
            Actions(do=of_word(Compensation, do_table)),
            "Attach arrays to an axis: the positions of the nut at steps of PRECISIONINCREMENT, going forward, and in "
            "reverse (NULL: as forward). Element 1 is the number of positions.", _TABLE, group="compensation"),
    _setting("PRECISIONINCREMENT", "", "uu", "Distance between the positions of PRECISIONTABLE.", _TABLE,
             0, _MAX_VALUE),
    _setting("PRECISIONOFFSET", "PCO", "uu", "Start position of PRECISIONTABLE, from the axis's zero.", _TABLE,
             -_MAX_VALUE, _MAX_VALUE),
    _setting("PRECISIONMODE", "", "integer",
             "Compensation of the leadscrew: _lsOFF, _lsSINGLE_TABLE for both directions, _lsDUAL_TABLE for one each.",
             _TABLE, 0, 2),
    constant("_lsOFF", 0, "PRECISIONMODE: leadscrew compensation off."),
    constant("_lsSINGLE_TABLE", 1, "PRECISIONMODE: leadscrew compensation by one table."),
    constant("_lsDUAL_TABLE", 2, "PRECISIONMODE: leadscrew compensation by two tables."),
)  # fmt: skip
