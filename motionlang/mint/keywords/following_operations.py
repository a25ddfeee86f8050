"""FOLLOW, FLY and OFFSET: a slave's distances in its units, its master's in the master's."""

from __future__ import annotations

from motionlang.mint.keywords.buffer_operations import loads
from motionlang.mint.keywords.following_masters import Masters, distance
from motionlang.mint.keywords.motion_operations import finite
from motionlang.mint.runtime.binding import by_axis, of, of_word, scale_of
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row

RAMPED = 1


def _follow(masters: Masters, axis: int, line: int) -> None:
    """Follow at the ratio that is set; 0 ends following."""
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
    """The ratio while the axis follows, 0 otherwise."""
    return masters.ratios.get(axis, 0.0) if masters.controller.master_of(axis) is not None else 0.0


def write_follow(masters: Masters, axis: int, ratio: float, line: int) -> None:
    """FOLLOW: the ratio of slave to master from now on; 0 brings the slave to rest."""
    masters.ratios[axis] = ratio
    _follow(masters, axis, line)


def write_part(masters: Masters, row: Row, axis: int, value: float, line: int) -> None:
    """An axis that follows already takes the new ratio."""
    masters.set(row.name, axis, value)
    if masters.controller.master_of(axis) is not None and masters.ratios.get(axis):
        _follow(masters, axis, line)


def put_fly(environment: Environment, row: Row, axis: int, value: float, line: int) -> None:
    """FLY: user units of the slave while the master goes MASTERDISTANCE."""
    found, over = distance(environment, axis, row.name)
    found.refuse(environment, axis)
    counts = scale_of(environment, axis).to_counts(value)
    environment.controller.load_fly(axis, found.number, counts, over, found.encoder, row.name, line)


def put_offset(masters: Masters, row: Row, axis: int, value: float, line: int) -> None:
    """OFFSET: user units on top of what the axis follows, over OFFSETDISTANCE of the master."""
    finite(row, value)
    mode = int(masters.setting("OFFSETMODE", axis))
    over = masters.setting("OFFSETDISTANCE", axis) * masters.of(axis).per_unit
    counts = masters.scale(axis).to_counts(value)
    masters.controller.load_offset(axis, counts, mode, over, row.name, line)


@by_axis
def read_offset(environment: Environment, row: Row, axis: int) -> Operation:
    """What is still to go: of the offset of a slave, of the move of another axis."""
    return environment.controller.reader("offset_remaining", axis, row.unit, environment)


OPERATIONS = {
    "following.follow": {"read": of(Masters, read_follow), "write": of(Masters, write_follow)},
    "following.part": {
        "read": of_word(Masters, lambda masters, row, axis: masters.setting(row.name, axis)),
        "write": repeatable(of_word(Masters, write_part)),
    },
    "following.fly": {"load": loads(Environment, put_fly)},
    "following.offset": {"read": read_offset, "load": loads(Masters, put_offset)},
}
