"""Moves of several axes along one path, and how consecutive paths join."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.motion import refuse_stopping
from motionlang.kernel.mint.runtime.binding import Maker, Operation, scale_of
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.tools import count_of


def _ready(
    environment: Environment, name: str, units: Sequence[str], axes: Sequence[int], values: Sequence[float]
) -> bool:
    """True if the buffers of all axes have space for a path with values in `units`.

    Raises Rejected if the number of axes or values is wrong, which is possible if AXES names the axes.
    """
    several = max(2, len(axes))
    wanted, count = (units.count("uu"), len(units)) if len(units) > 1 else (several, several)
    if len(axes) != wanted or len(values) != count:
        given = f"{count_of(len(axes), 'axis', 'axes')} and {count_of(len(values), 'value')}"
        raise Rejected(
            "values", f"{name} is given {given}", f"it takes {wanted} axes and {count_of(count, 'value')}"
        )
    for axis in axes:
        scale_of(environment, axis)
        refuse_stopping(environment, axis)
    room = environment.controller.room
    return all(room(axis) > 0 for axis in axes)


def loads(put: Callable[..., None]) -> Maker:
    """Make an operation that loads a path; it returns True while a buffer is full.

    `put` receives the environment, the row, the axes, the values and the line.
    """

    def made(environment: Environment, row: Keyword) -> Operation:
        units = row.unit.split(", ")

        def load(axes: Sequence[int], values: Sequence[float], line: int) -> bool:
            if not _ready(environment, row.name, units, axes, values):
                return True
            put(environment, row, axes, values, line)
            if environment.loaded is not None:
                environment.loaded(axes[0])
            return False

        return load

    return made


def put_line(
    environment: Environment, row: Keyword, axes: Sequence[int], values: Sequence[float], line: int
) -> None:
    """VECTORA and VECTORR: load a line in user units of each axis."""
    controller, relative = environment.controller, row.name.endswith("R")
    counts = _in_counts(environment, relative, axes, values)
    (controller.load_line_by if relative else controller.load_line)(axes, counts, row.name, line)


def put_arc(
    environment: Environment, row: Keyword, axes: Sequence[int], values: Sequence[float], line: int
) -> None:
    """CIRCLEA, CIRCLER, HELIXA and HELIXR: load an arc or helix.

    The centre is in user units, the angle in degrees.
    """
    controller, relative = environment.controller, row.name.endswith("R")
    x, y, angle, *rest = values
    if environment.machine.assumptions.get("mint.circle-sense") == "clockwise":
        angle = -angle
    counts = _in_counts(environment, relative, axes, (x, y, *rest))
    controller.load_arc(axes, counts[:2], angle, counts[2:], relative, row.name, line)


def _in_counts(
    environment: Environment, relative: bool, axes: Sequence[int], values: Sequence[float]
) -> list[float]:
    """Return distances or positions of axes in counts; `values` are in user units."""
    if not relative:
        return [environment.absolute_counts(axis, value) for axis, value in zip(axes, values, strict=True)]
    scales = [environment.controller.axes[axis].scale for axis in axes]
    return [scale.to_counts(value) for scale, value in zip(scales, values, strict=True)]


# ------------------------------------------------------------------------------------------------- keywords

_LINE = Actions(load=loads(put_line))
_ARC = Actions(load=loads(put_arc))

_READY = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
_END = '\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0), " ", POS(1)'
_TWO = "VECTORR(0, 1) = 60, 0\nVECTORR(0, 1) = 0, 60\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(1)"


def _path(name: str, unit: str, help: str, example: str, effect: str = "path") -> Keyword:
    short = "".join(name[at] for at in (0, -1)) if name[:5] != "HELIX" else ""  # VA, VR, CA, CR
    return Keyword(name, short, "move", "W", "axes", unit, _ARC if "degrees" in unit else _LINE, help,
                   example + _END, group="motion", effect=effect)  # fmt: skip


def _setting(
    name: str, unit: str, actions: str | Actions, help: str, example: str, high: float, topic: str = ""
) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, actions, help, _READY + example, default=0.0, low=0.0,
                   high=high, group="paths", topic=topic)  # fmt: skip


_RULE = "SPEED, ACCEL and DECEL of the first axis are those along the path, and GO of it starts all"


ROWS = (
    _path("VECTORA", "uu", f"Load a straight line of several axes to a position; {_RULE}.",
          "VECTORA(0, 1) = 30, 40", effect="path line"),
    _path("VECTORR", "uu", f"Load a straight line of several axes by distances; {_RULE}.",
          "VECTORR(0, 1) = 30, 40", effect="path line relative"),
    _path("CIRCLEA", "uu, uu, degrees",
          f"Load an arc of two axes: absolute centre and angle, positive from the first axis to the second; {_RULE}.",
          "CIRCLEA(0, 1) = 50, 0, 180"),
    _path("CIRCLER", "uu, uu, degrees",
          f"Load an arc of two axes: centre counted from its start, and angle; {_RULE}.",
          "CIRCLER(0, 1) = 50, 0, 180"),
    _path("HELIXA", "uu, uu, degrees, uu",
          f"Load a helix of three axes: absolute centre, angle, and where the third axis ends; {_RULE}.",
          "HELIXA(0, 1, 2) = 50, 0, 720, 20"),
    _path("HELIXR", "uu, uu, degrees, uu",
          f"Load a helix of three axes: centre counted from its start, angle, and the third axis's distance; {_RULE}.",
          "HELIXR(0, 1, 2) = 50, 0, 720, 20"),
    _setting("CONTOURMODE", "integer", "contour_mode",
             "1: paths of the same axes are run through without slowing down, where their directions differ by no more "
             "than CONTOURANGLE.", "CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 90\n" + _TWO, 1),
    _setting("CONTOURANGLE", "number", "contour_angle",
             "Degrees by which the direction may change between two paths that are run through.",
             "CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 90\n" + _TWO, 180),
    Keyword("VELDEMANDPATH", "", "reading", "R", "axis", "number", "path_speed",
            "Speed along the path that the axis is on, in user units a second.",
            _READY + "VECTORR(0, 1) = 30, 40\nGO(0)\nWAIT = 200\nPRINT VELDEMANDPATH(0)", default=0.0, group="paths"),
)  # fmt: skip
