"""Lines, arcs and helices of several axes, and what becomes of their corners."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.keywords.motion_operations import refuse_stopping
from motionlang.mint.runtime.binding import axis_of, of, of_word, on_axes, scale_of
from motionlang.mint.runtime.changes import moving, repeatable
from motionlang.mint.runtime.environment import Environment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.mint.runtime.binding import Maker, Operation, Row


def _ready(environment: Environment, row: Row, axes: Sequence[int], values: Sequence[float]) -> bool:
    """Whether all axes have room; refuses what the row does not take, such as with axes that AXES named."""
    units = row.unit.split(", ")
    wanted, count = (units.count("uu"), len(units)) if len(units) > 1 else (max(2, len(axes)), len(axes))
    if len(axes) != wanted or len(values) != count:
        words = f"{row.name} is given {len(axes)} axes and {len(values)} values"
        raise Refusal("values", words, f"it takes {wanted} axes and {count} values")
    for axis in axes:
        scale_of(environment, axis)
        refuse_stopping(environment, axis)
    return all(environment.controller.room(axis) > 0 for axis in axes)


def loads(put: Callable[..., None]) -> Maker:
    """What loads a path: true while a buffer of its axes is full; `put` is given the row, axes, values and line."""

    def made(environment: Environment, row: Row) -> Operation:
        def load(axes: Sequence[int], values: Sequence[float], line: int) -> bool:
            if not _ready(environment, row, axes, values):
                return True
            put(environment, row, axes, values, line)
            if environment.loaded is not None:
                environment.loaded(axes[0])
            return False

        return load

    return made


def put_line(
    environment: Environment, row: Row, axes: Sequence[int], values: Sequence[float], line: int
) -> None:
    """VECTORA and VECTORR: a line, user units of each axis."""
    controller, counts = environment.controller, []
    relative = row.name.endswith("R")
    for axis, value in zip(axes, values, strict=True):
        scale = scale_of(environment, axis)
        place = (
            scale.to_counts(value) if relative else scale.position_to_counts(value + environment.turn(axis))
        )
        counts.append(place)
    (controller.load_line_by if relative else controller.load_line)(axes, counts, row.name, line)


def put_arc(
    environment: Environment, row: Row, axes: Sequence[int], values: Sequence[float], line: int
) -> None:
    """CIRCLEA, CIRCLER, HELIXA and HELIXR: the centre in user units, the angle in degrees."""
    relative, counts = row.name.endswith("R"), []
    x, y, angle, *rest = values
    if environment.machine.readings.get("mint.circle-sense") == "clockwise":
        angle = -angle
    for axis, value in zip(axes, (x, y, *rest), strict=True):
        scale = scale_of(environment, axis)
        counts.append(scale.to_counts(value) if relative else scale.position_to_counts(value))
    environment.controller.load_arc(axes, counts[:2], angle, counts[2:], relative, row.name, line)


_MODES = {"CONTOURMODE": "contour_mode", "BLENDMODE": "blend_mode"}


def set_mode(environment: Environment, name: str, axis: int, on: bool) -> None:
    """A path is either run through or blended: Mint's error 158."""
    controller, other = environment.controller, next(each for each in _MODES if each != name)
    if on and controller.setting(axis, _MODES[other]):
        raise Refusal("contour-and-blend", f"{name} cannot be set while {other} is",
                      f"write {other}({axis}) = 0 first")  # fmt: skip
    controller.configure(axis, _MODES[name], on)


def read_angle(environment: Environment, x: int, y: int) -> float:
    return environment.controller.vector_angle(x, axis_of(environment, y))


_MODE = repeatable(of_word(Environment, lambda e, row, axis, mode: set_mode(e, row.name, axis, bool(mode))))
OPERATIONS = {
    "paths.line": {"load": loads(put_line)},
    "paths.arc": {"load": loads(put_arc)},
    "contour_mode": {"write": _MODE},
    "blend_mode": {"write": _MODE},
    "paths.blend": {"do": on_axes(lambda e, axis: e.controller.blend(axis))},
    "paths.angle": {"read": moving(of(Environment, read_angle))},
}
