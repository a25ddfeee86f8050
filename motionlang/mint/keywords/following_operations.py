"""FOLLOW, FLY and OFFSET: a slave's distances in its units, its master's in the master's."""

from __future__ import annotations

from motionlang.mint.keywords.buffer_operations import loader
from motionlang.mint.keywords.following_masters import Masters, distance
from motionlang.mint.keywords.motion_operations import finite
from motionlang.mint.runtime.binding import axis_of, scale_of
from motionlang.mint.runtime.changes import Changes, repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

RAMPED = 1


def _follow(environment: Environment, axis: int, line: int) -> None:
    """Follow at the ratio that is set; 0 ends following."""
    masters, controller = environment.part(Masters), environment.controller
    ratio = masters.ratios.get(axis, 0.0)
    ratio *= masters.setting("FOLLOWNUMERATOR", axis) / masters.setting("FOLLOWDENOM", axis)
    scale = scale_of(environment, axis)
    if not ratio:
        if controller.master_of(axis) is not None:
            controller.come_to_rest(axis, "stop")
        return
    found = masters.of(axis)
    controller.gear(
        axis,
        found.number,
        ratio * scale.counts / found.per_unit,
        masters.setting("FOLLOWMODE", axis) == RAMPED,
        found.encoder,
        "FOLLOW",
        line,
    )


def read_follow(environment: Environment, row: Row) -> Operation:
    """The ratio while the axis follows, 0 otherwise."""
    masters, controller = environment.part(Masters), environment.controller

    def read(axis: int) -> float:
        follows = controller.master_of(axis_of(environment, axis)) is not None
        return masters.ratios.get(axis, 0.0) if follows else 0.0

    return read


def write_follow(environment: Environment, row: Row) -> Operation:
    """FOLLOW: the ratio of slave to master from now on; 0 brings the slave to rest."""
    masters = environment.part(Masters)

    def write(axis: int, ratio: float, line: int) -> None:
        row.check(ratio)
        masters.ratios[axis_of(environment, axis)] = ratio
        _follow(environment, axis, line)

    return write


def read_part(environment: Environment, row: Row) -> Operation:
    masters, name = environment.part(Masters), row.name
    return lambda axis: masters.setting(name, axis_of(environment, axis))


@repeatable
def write_part(environment: Environment, row: Row) -> Operation:
    """An axis that follows already takes the new ratio."""
    masters, controller, name = environment.part(Masters), environment.controller, row.name

    def write(axis: int, value: float, line: int) -> None:
        row.check(value)
        masters.set(name, axis_of(environment, axis), value)
        if controller.master_of(axis) is not None and masters.ratios.get(axis):
            _follow(environment, axis, line)

    return write


def load_fly(environment: Environment, row: Row) -> Operation:
    """FLY: user units of the slave while the master goes MASTERDISTANCE."""
    load = environment.controller.load_fly

    def put(axis: int, value: float, line: int) -> None:
        found, over = distance(environment, axis, row.name)
        found.refuse(environment, axis)
        load(
            axis,
            found.number,
            scale_of(environment, axis).to_counts(value),
            over,
            found.encoder,
            row.name,
            line,
        )

    return loader(environment, put)


def load_offset(environment: Environment, row: Row) -> Operation:
    """OFFSET: user units on top of what the axis follows, over OFFSETDISTANCE of the master."""
    controller, masters = environment.controller, environment.part(Masters)

    def put(axis: int, value: float, line: int) -> None:
        finite(row, value)
        mode = int(masters.setting("OFFSETMODE", axis))
        over = masters.setting("OFFSETDISTANCE", axis) * masters.of(axis).per_unit
        controller.load_offset(axis, scale_of(environment, axis).to_counts(value), mode, over, row.name, line)

    return loader(environment, put)


def read_offset(environment: Environment, row: Row) -> Operation:
    """What is still to go: of the offset of a slave, of the move of another axis."""
    controller = environment.controller

    def read(axis: int) -> float:
        scale = scale_of(environment, axis)
        slave = controller.master_of(axis) is not None
        return scale.to_user(controller.offset_remaining(axis) if slave else controller.remaining(axis))

    changes = environment.part(Changes)
    return changes.comparable(read, changes.passing("following.offset"))


OPERATIONS = {
    "following.follow": {"read": read_follow, "write": write_follow},
    "following.part": {"read": read_part, "write": write_part},
    "following.fly": {"load": load_fly},
    "following.offset": {"read": read_offset, "load": load_offset},
}
