"""The part of a run that a picture shows: time, axes, and curves or path."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple


class Window(NamedTuple):
    """A selection of times (s) and axes.

    `end` is None for the end of the run, `axes` None for all that moved. `path` has two or three axes whose path is
    drawn instead of curves over time.
    """

    begin: float = 0.0
    end: float | None = None
    axes: tuple[int, ...] | None = None
    path: tuple[int, ...] | None = None

    def span(self, last: float) -> tuple[float, float]:
        """Return begin and end (s) in a run that ended at `last`.

        Raises ValueError if the window is empty.
        """
        end = last if self.end is None else min(self.end, last)
        if self.begin >= end and self.begin > 0.0:
            raise ValueError(f"the run ended after {last:.10g} s, before --from {self.begin:.10g} s")
        return self.begin, end

    def of(self, axes: Sequence[int]) -> tuple[int, ...]:
        """Return those of `axes` that are selected.

        Raises ValueError if a requested axis is not among them.
        """
        if self.axes is None:
            return tuple(axes)
        for axis in self.axes:
            if axis not in axes:
                moved = ", ".join(map(str, axes)) or "none"
                raise ValueError(f"axis {axis} did not move in this run: {moved} did")
        return tuple(axis for axis in axes if axis in self.axes)


WHOLE = Window()
