"""Variables that a handler only counts, and how often they may advance.

The compiler names them (`mint/compile/handler_counters.py`). A counter is no part of a state that recurs.
"""

from __future__ import annotations

from types import FunctionType

from motionlang.fast.loop_counters import counted
from motionlang.mint.runtime.task_state import of_values

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import CellType
    from typing import Any

    from motionlang.mint.runtime.events import Events


class HandlerCounters:
    """The counters of the handler of one kind of event."""

    def __init__(self, events: Events, kind: str, beside_loops: bool = False) -> None:
        """Find the counters; `beside_loops` without those that a polling loop may use."""
        self._environment = events.environment
        cells = _cells(events.handler(kind))
        found = [
            (cells[name], levels, is_set)
            for name, (levels, (is_polled, is_set)) in events.environment.handler_counters.get(
                kind, {}
            ).items()
            if name in cells and not (beside_loops and is_polled)
        ]
        self._cells = [cell for cell, _, _ in found]
        self._levels = [levels for _, levels, _ in found]
        self._are_set = [is_set for _, _, is_set in found]

    def values(self) -> tuple[float, ...]:
        """Return the present values."""
        return tuple([cell.cell_contents for cell in self._cells])

    def other_variables(self, alive: dict[int, object]) -> bytes:
        """Return the variables that functions share, without the counters."""
        values = self.values()
        for cell in self._cells:
            cell.cell_contents = 0.0
        try:
            return of_values(self._environment.variables(), alive)
        finally:
            for cell, value in zip(self._cells, values, strict=True):
                cell.cell_contents = value

    def is_proved(self, steps: Sequence[float]) -> bool:
        """True if what advanced by `steps` was counted, since it is never set."""
        return not any(step and is_set for step, is_set in zip(steps, self._are_set, strict=True))

    def sides(self) -> list[int]:
        """Return the signs of the counters less the constants that they are compared with."""
        return [
            (value > level) - (value < level)
            for value, levels in zip(self.values(), self._levels, strict=True)
            for level in levels
        ]

    def most(self, steps: Sequence[float]) -> float:
        """Return how often the counters may advance by `steps` before one passes a level."""
        return counted(self.values(), steps, self._levels)

    def advance(self, steps: Sequence[float], count: int) -> None:
        """Advance the counters `count` times."""
        for cell, step in zip(self._cells, steps, strict=True):
            cell.cell_contents += count * step


def _cells(function: Any) -> dict[str, CellType]:
    """Return the variables that a function shares, by name."""
    if function.__class__ is not FunctionType:
        return {}
    return dict(zip(function.__code__.co_freevars, function.__closure__ or (), strict=True))
