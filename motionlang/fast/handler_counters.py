"""Variables that a handler or polling loops only count.

They may advance until one passes a constant with which it is compared. The compiler names them
(`mint/compile/handler_counters.py`). A counter is no part of a state that recurs.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import CellType, FunctionType
from typing import Any

from motionlang.fast.loop_counters import counted
from motionlang.mint.runtime.events import Events


class HandlerCounters:
    """The counters of the handler of one kind of event."""

    def __init__(self, events: Events, kind: str, beside_loops: bool = False) -> None:
        """Find the counters.

        `beside_loops` omits those that a polling loop may use, and adds those that polling loops count.
        """
        self._environment = environment = events.environment
        functions = {kind: events.handler(kind)}
        if beside_loops:
            functions.update(environment.blocks)
        found = [
            (cells[name], levels, is_set, key != kind)
            for key, function in functions.items()
            for cells in (_cells(function),)
            for name, (levels, (is_polled, is_set)) in environment.handler_counters.get(key, {}).items()
            if name in cells and not (beside_loops and is_polled)
        ]
        self._cells = [cell for cell, *_ in found]
        for cell in self._cells:
            if cell.cell_contents is None:  # of a task that has not been started
                cell.cell_contents = 0.0
        self._levels = [levels for _, levels, _, _ in found]
        self._are_set = [is_set for _, _, is_set, _ in found]
        self._are_of_loops = [is_of_loop for *_, is_of_loop in found]
        self.count = len(self._cells)

    def values(self) -> tuple[float, ...]:
        """Return the present values."""
        return tuple([cell.cell_contents for cell in self._cells])

    def hide(self) -> tuple[float, ...]:
        """Set all counters to 0, so that they are no part of a state; return their values."""
        values = self.values()
        for cell in self._cells:
            cell.cell_contents = 0.0
        return values

    def set(self, values: Sequence[float]) -> None:
        """Give the counters some values."""
        for cell, value in zip(self._cells, values, strict=True):
            cell.cell_contents = value

    def steps_of_set(self, steps: Sequence[float]) -> list[float]:
        """Return the steps of the counters that the handler also sets; no steps are zeros."""
        given = steps or [0.0] * len(self._cells)
        return [step for step, is_set in zip(given, self._are_set, strict=True) if is_set]

    def sides(self) -> list[int]:
        """Return the signs of the counters less the constants that they are compared with."""
        return [
            (value > level) - (value < level)
            for value, levels in zip(self.values(), self._levels, strict=True)
            for level in levels
        ]

    def loops_count(self, steps: Sequence[float]) -> bool:
        """True if a counter of a loop advances."""
        return any(step and of_loop for step, of_loop in zip(steps, self._are_of_loops, strict=False))

    def most_in(self, range: tuple[Sequence[float], Sequence[float]], values: Sequence[float]) -> int:
        """Return how often the counters may advance by any step of a range.

        The range has the least and the greatest step of each. Each stays on its side of a level until then.
        """
        return int(min(*[counted(values, steps, self._levels) for steps in range], 1e9))

    def most(self, steps: Sequence[float]) -> float:
        """Return how often the counters may advance by `steps` before one passes a level."""
        return counted(self.values(), steps, self._levels)

    def advance(self, steps: Sequence[float], count: int) -> None:
        """Advance the counters `count` times."""
        for cell, step in zip(self._cells, steps, strict=True):
            cell.cell_contents += count * step


def _cells(function: Any) -> Mapping[str, CellType]:
    """Return the variables that a function shares, by name."""
    if function.__class__ is not FunctionType:
        return getattr(function, "cells", {})
    return dict(zip(function.__code__.co_freevars, function.__closure__ or (), strict=True))
