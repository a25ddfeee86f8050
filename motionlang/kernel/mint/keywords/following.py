"""Following a master: choice of master, gearing, flying shears, cams, offsets."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword, constant
from motionlang.kernel.mint.keywords.buffer import loads
from motionlang.kernel.mint.keywords.following_masters import MASTER_SETTING, Masters, distance
from motionlang.kernel.mint.keywords.motion import finite
from motionlang.kernel.mint.runtime.binding import Operation, by_axis, of, of_word, scale_of
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

RAMPED = 1


def _follow(masters: Masters, axis: int, line: int) -> None:
    """Follow the master at the ratio that is set; a ratio of 0 ends following."""
    controller, ratio = masters.controller, masters.ratios.get(axis, 0.0)
    ratio *= masters.setting("FOLLOWNUMERATOR", axis) / masters.setting("FOLLOWDENOM", axis)
    if not ratio:
        if controller.master_of(axis) is not None:
            controller.come_to_rest(axis, "stop")
        return
    found = masters.of(axis)
    controller.gear(
        axis,
        found.number,
        ratio * masters.scale(axis).counts / found.per_unit,
        masters.setting("FOLLOWMODE", axis) == RAMPED,
        found.encoder,
        "FOLLOW",
        line,
    )


def read_follow(masters: Masters, axis: int) -> float:
    """FOLLOW: return the ratio, 0 if the axis does not follow."""
    return masters.ratios.get(axis, 0.0) if masters.controller.master_of(axis) is not None else 0.0


def write_follow(masters: Masters, axis: int, ratio: float, line: int) -> None:
    """FOLLOW: set the ratio of follower to master; 0 brings the follower to rest."""
    masters.ratios[axis] = ratio
    _follow(masters, axis, line)


def write_factor(masters: Masters, row: Keyword, axis: int, value: float, line: int) -> None:
    """Set one factor of the ratio; an axis that already follows uses it at once."""
    masters.set(row.name, axis, value)
    if masters.controller.master_of(axis) is not None and masters.ratios.get(axis):
        _follow(masters, axis, line)


def put_fly(environment: Environment, row: Keyword, axis: int, value: float, line: int) -> None:
    """FLY: travel a distance in user units while the master travels MASTERDISTANCE."""
    found, over = distance(environment, axis, row.name)
    found.refuse(environment, axis)
    counts = scale_of(environment, axis).to_counts(value)
    environment.controller.load_fly(axis, found.number, counts, over, found.encoder, row.name, line)


def put_offset(masters: Masters, row: Keyword, axis: int, value: float, line: int) -> None:
    """OFFSET: superpose a distance in user units over OFFSETDISTANCE of the master."""
    finite(row, value)
    mode = int(masters.setting("OFFSETMODE", axis))
    over = masters.setting("OFFSETDISTANCE", axis) * masters.of(axis).per_unit
    counts = masters.scale(axis).to_counts(value)
    masters.controller.load_offset(axis, counts, mode, over, row.name, line)


@by_axis
def read_offset(environment: Environment, row: Keyword, axis: int) -> Operation:
    """Return the remaining distance of a follower's offset.

    For an axis that does not follow, this is the remaining distance of its move.
    """
    return environment.controller.reader("offset_remaining", axis, row.unit, environment)


# ------------------------------------------------------------------------------------------------- keywords

_FACTOR = Actions(
    read=of_word(Masters, lambda masters, row, axis: masters.setting(row.name, axis)),
    write=repeatable(of_word(Masters, write_factor)),
)

_MAX_VALUE = 8388607.0
_READY = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMASTERCHANNEL(1) = 0\n"
_FLY = (
    _READY
    + "MASTERDISTANCE(1) = 10\nFLY(1) = 5\nFLY(1) = 5\nGO(1)\nMOVER(0) = 20\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(1)"
)
_OFFSET = (
    _READY
    + "FOLLOW(1) = 1\nJOG(0) = 50\n{}WAIT = 1000\nOFFSET(1) = 10\nGO(1)\nWAIT = 2000\nPRINT POS(1) - POS(0)\nCANCELALL"
)
_SOURCES = (
    ("POS", "the position of an axis"),
    ("ENCODER", "an encoder"),
    ("AUXENCODER", "an auxiliary encoder"),
)
_OFFSET_MODES = (
    ("STANDARD", "ACCEL and DECEL, SPEED on top of the base speed"),
    ("SPEED_LIMIT", "the same within MAXSPEED and without reversing"),
    ("ACCEL_MOD", "over OFFSETDISTANCE of the master, half of it speeding up"),
    ("SPEED_MOD", "over OFFSETDISTANCE of the master at constant speed between ACCEL and DECEL"),
)
_STATUS = (
    ("MAXSPEED", "MAXSPEED was reached"),
    ("MINSPEED", "the axis came to rest"),
    ("MAXACCEL", "not done, it needs a higher acceleration"),
    ("MAXDECEL", "not done, it needs a higher deceleration"),
    ("PROFILEERROR", "not done, it needs an infinite acceleration"),
    ("ZEROACCEL", "not done, the acceleration is zero or less"),
)


ROWS = (
    *(constant(f"_ms{name}", n, f"MASTERSOURCE: {help}.") for n, (name, help) in enumerate(_SOURCES)),
    *(constant(f"_of{name}", n, f"OFFSETMODE: {help}.") for n, (name, help) in enumerate(_OFFSET_MODES)),
    *(constant(f"_os{name}", 1 << n, f"OFFSETSTATUS: {help}.") for n, (name, help) in enumerate(_STATUS)),
    Keyword("FOLLOW", "FL", "setting", "RW", "axis", "number",
            Actions(read=of(Masters, read_follow), write=of(Masters, write_follow)),
            "Follow the master: units of this axis for each unit of the master. 0 ends it; no GO is needed.",
            _READY + "FOLLOW(1) = 0.5\nMOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(1)",
            default=0.0, low=-_MAX_VALUE, high=_MAX_VALUE, group="motion", effect="act follows"),
    Keyword("FOLLOWNUMERATOR", "", "setting", "RW", "axis", "number", _FACTOR,
            "FOLLOW is multiplied by this and divided by FOLLOWDENOM: 1 and 3 make an exact third.",
            _READY + "FOLLOWDENOM(1) = 3\nFOLLOWNUMERATOR(1) = 2\nFOLLOW(1) = 1\nMOVER(0) = 99\nGO(0)\n"
            "PAUSE IDLE(0)\nPRINT POS(1)", default=1.0, low=-_MAX_VALUE, high=_MAX_VALUE, group="motion"),
    Keyword("FOLLOWDENOM", "", "setting", "RW", "axis", "number", _FACTOR,
            "Divisor of FOLLOW.",
            _READY + "FOLLOWDENOM(1) = 3\nFOLLOW(1) = 1\nMOVER(0) = 99\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(1)",
            default=1.0, low=1e-9, high=_MAX_VALUE, group="motion"),
    Keyword("FLY", "", "move", "W", "axis", "uu", Actions(load=loads(Environment, put_fly)),
            "Load a segment of a flying shear: go this distance while the master goes MASTERDISTANCE. Its ratio to the "
            "master changes evenly from that of the segment before, so two equal segments end at a ratio of 0.",
            _FLY, group="motion", effect="course follows"),
    Keyword("OFFSET", "", "move", "RW", "axis", "uu", Actions(read=read_offset, load=loads(Masters, put_offset)),
            "Load a distance on top of following; an axis without a master moves by it. Reading it gives the "
            "distance still to go, of a move too.",
            _OFFSET.format(""), group="motion", effect="course follows", solved=True),
    Keyword("OFFSETMODE", "", "setting", "RW", "axis", "integer", MASTER_SETTING,
            "Mode of OFFSET: _ofSTANDARD, _ofSPEED_LIMIT, _ofACCEL_MOD or _ofSPEED_MOD.",
            _OFFSET.format("OFFSETMODE(1) = _ofSPEED_MOD : OFFSETDISTANCE(1) = 50\n"),
            default=0.0, low=0, high=3, group="following", family="offset modes"),
    Keyword("OFFSETSTATUS", "OFS", "reading", "R", "axis", "bits", "offset_status",
            "Result of the last OFFSET: an _os constant, 0 for success.",
            _OFFSET.format("") + "\nPRINT OFFSETSTATUS(1)", default=0.0, group="following"),
)  # fmt: skip
