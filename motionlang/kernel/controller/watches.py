"""The watches of an axis, in order of creation and by position."""

from __future__ import annotations

from bisect import bisect_left, insort_right
from collections.abc import Iterator
from typing import TYPE_CHECKING

from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.triggers.watch import Watch

# Position and order of a watch: the sort key.
Key = tuple[float, int, "Watch"]


class Watches:
    """`all` watches in order of creation; `program` and `machine` sorted by position.

    `program` has those with a position of the program, `machine` those with a machine position. `loose` are those that
    have been solved since the axis's profile began, `seen` the positions, in both coordinates, at which the sides of
    all others were right. `count` is the number of watches ever set.
    """

    __slots__ = ("all", "count", "crossed", "loose", "machine", "program", "seen")

    def __init__(self) -> None:
        self.all: dict[Watch, None] = {}
        self.loose: dict[Watch, None] = {}
        self.program: list[Key] = []
        self.machine: list[Key] = []
        self.seen = [0.0, 0.0]
        self.count = 0
        # When the axis was last known to be exactly at a position, that position, and its profile.
        self.crossed: tuple[float, float, Profile] | None = None

    def __iter__(self) -> Iterator[Watch]:
        return iter(self.all)

    def __contains__(self, watch: Watch) -> bool:
        return watch in self.all

    def __len__(self) -> int:
        return len(self.all)

    def append(self, watch: Watch) -> None:
        """Add a watch; the caller solves it."""
        self.count += 1
        watch.order = self.count
        self.all[watch] = self.loose[watch] = None
        insort_right(self.machine if watch.physical else self.program, (watch.position, watch.order, watch))

    def remove(self, watch: Watch) -> None:
        """Remove a watch and cancel its event."""
        del self.all[watch]
        self.loose.pop(watch, None)
        keys = self.machine if watch.physical else self.program
        del keys[bisect_left(keys, (watch.position, watch.order))]
        if watch.event is not None:
            watch.event.cancel()
            watch.event = None
        if watch.front is not None:
            watch.front.leave(watch)
