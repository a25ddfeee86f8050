"""Settings of axes that are kept by keyword and axis: read, written, and taken back by DEFAULT."""

from __future__ import annotations

from motionlang.mint.runtime.binding import axis_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import TypeVar

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]
    Value = TypeVar("Value")


def reading(environment: Environment, row: Row, setting: Callable[[str, int], float]) -> Operation:
    """What reads a setting as its word shows it: a whole number where that is what it is."""
    name, whole = row.name, row.unit in ("integer", "bool")

    def read(axis: int) -> float:
        value = setting(name, axis_of(environment, axis))
        return int(value) if whole else value

    return read


def writing(environment: Environment, row: Row, give: Callable[..., None]) -> Operation:
    """What writes a setting, in the range of its word; `give` takes the word, the axis and the value."""
    name = row.name

    def write(axis: int, value: float) -> None:
        row.check(value)
        give(name, axis_of(environment, axis), value)

    return write


def forget(settings: dict[tuple[str, int], Value], axis: int) -> None:
    """What was set for an axis is as it was before any program."""
    for key in [key for key in settings if key[1] == axis]:
        del settings[key]
