"""A region of an axis's travel, such as a home switch, with exact change times."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.watch import Watch, begin, end


class Region:
    """A region from `low` to `high` counts of an axis; calls `change(inside)`.

    Either end may be infinite. The region stays at its position on the machine when the program gives the axis a new
    zero.
    """

    def __init__(
        self,
        a: Axis,
        low: float,
        high: float,
        change: Callable[[bool], None],
    ) -> None:
        self.a, self.change = a, change
        self._watches: list[Watch] = []
        self.inside = False
        self.place(low, high)

    def place(self, low: float, high: float) -> None:
        """Move the region, and notify of a change that this causes."""
        self.remove()
        self.low, self.high = low, high
        for position, inwards in ((low, 1), (high, -1)):
            if abs(position) < INFINITY:
                watch = Watch(position, self._pass, physical=True)
                begin(self.a, watch)
                watch.side = watch.side or inwards  # at an end is inside: to leave it is a pass
                self._watches.append(watch)
        self._set(low <= self._here() <= high)

    def remove(self) -> None:
        """Stop watching."""
        for watch in self._watches:
            end(self.a, watch)
        self._watches.clear()

    def _here(self) -> float:
        return self.a.actual_position - self.a.datum

    def _pass(self, direction: int) -> None:
        """Handle a pass of an end; inside is above the low end and below the high one."""
        sides = [watch.side for watch in self._watches]
        if len(sides) == 2:
            self._set(sides[0] >= 0 >= sides[1])
        else:
            self._set(direction > 0 if abs(self.low) < INFINITY else direction < 0)

    def _set(self, inside: bool) -> None:
        if inside != self.inside:
            self.inside = inside
            self.change(inside)
