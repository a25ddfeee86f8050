"""Search for an index mark or a home edge.

The position is caught at the exact time, whatever the program does at that moment. The search does not move
the axis: the program must do so, usually in velocity mode.
"""

from __future__ import annotations

from collections.abc import Callable
from math import floor
from typing import TYPE_CHECKING

from motionlang.kernel.controller.watch import Watch
from motionlang.kernel.mccl.axis import flags
from motionlang.kernel.mccl.axis.axis import AxisState
from motionlang.kernel.mccl.axis.inputs import is_active

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.board import Board

# A mark nearer than this, in counts, is the mark that the axis is on: the search is for the next one.
_ON = 1e-6


class Seek:
    """One search on one axis.

    `caught` is the position of the mark or edge in counts, once known, and `value` the position to be
    assigned to it.
    """

    def __init__(self, board: Board, axis: AxisState, kind: str, value: float) -> None:
        self._board, self._axis, self.kind, self.value = board, axis, kind, value
        self.caught: float | None = None
        self._watches: list[Watch] = []
        self._looking = flags.LOOKING_FOR_INDEX if kind == "index" else flags.LOOKING_FOR_EDGE
        axis.flags |= self._looking
        if kind == "index":
            axis.index_found = False
            self._watch_marks()
        else:
            axis.edge_found = False
            self.check()

    @property
    def done(self) -> bool:
        """True if the position has been caught."""
        return self.caught is not None

    def check(self) -> None:
        """Check the home input after a possible change."""
        if self.kind == "edge" and not self.done and is_active(self._board, self._axis, "home"):
            self._catch()

    def cancel(self) -> None:
        """Cancel the search."""
        for watch in self._watches:
            self._board.controller.unwatch(self._axis.number, watch)
        self._watches.clear()
        self._axis.flags &= ~self._looking

    def withdraw(self) -> None:
        """Cancel the search and forget it, because its command was abandoned."""
        self.cancel()
        seeks = self._board.seeks
        if seeks.get(self._axis.number) is self:
            del seeks[self._axis.number]

    def apply(self) -> None:
        """Assign the value to the caught position and shift everything else.

        The axis is then homed.
        """
        assert self.caught is not None
        here = self._board.controller.position(self._axis.number)
        self._board.define_position(self._axis, here + self.value - self.caught)
        self.caught = self.value
        if self.kind == "index":
            self._axis.index_position = self.value
        self._board.controller.axes[self._axis.number].set_home()
        self._axis.flags |= flags.HOMED

    def _watch_marks(self) -> None:
        """Watch the marks on both sides of the axis, which must pass one of them first."""
        controller, number = self._board.controller, self._axis.number
        a = controller.axes[number]
        every = a.index_pitch
        if every <= 0.0:
            return
        here = controller.position(number) - a.datum - a.index_origin
        below = floor((here - _ON) / every)
        above = floor((here + _ON) / every) + 1
        caught: Callable[[int], None] = lambda direction: self._catch()  # noqa: E731
        for mark in (below, above):
            at = mark * every + a.index_origin
            self._watches.append(controller.watch(number, at, caught, physical=True))

    def _catch(self) -> None:
        if self.done:
            return
        axis = self._axis
        self.caught = self._board.controller.position(axis.number)
        self.cancel()
        if self.kind == "index":
            axis.index_found, axis.index_position = True, self.caught
        else:
            axis.edge_found = True
