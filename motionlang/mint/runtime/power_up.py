"""What settings are at power-up where the machine file's `[readings]` say so: written as a program would."""

from __future__ import annotations

from motionlang.mint.keywords import table
from motionlang.mint.keywords.switchable import word_of
from motionlang.mint.runtime.binding import Row, bind

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from motionlang.mint.runtime.environment import Environment


class PowerUp:
    """The settings whose default is another one here; `set` gives them to an axis, at the start and after DEFAULT."""

    def __init__(self, environment: Environment, readings: Mapping[str, object]) -> None:
        self._writers: list[tuple[Callable[..., object], object]] = []
        for name, value in readings.items():
            row = table().get(word_of(name))
            if row is not None:
                wanted = Row(row.verb, row.name, row.unit, row.index, row.low, row.high)
                self._writers.append((bind(environment, "write", wanted), value))

    def set(self, axis: int) -> None:
        """Write them all."""
        for write, value in self._writers:
            write(axis, value)
