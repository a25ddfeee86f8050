"""The watches of an axis: in the order in which they were set, and by place."""

from __future__ import annotations

from bisect import bisect_left, insort_right

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from motionlang.controller.triggers.watch import Watch
    from motionlang.planners import Profile

    # Position and order of a watch: what those of an axis are sorted by.
    Key = tuple[float, int, Watch]


class Watches:
    """`all` as they were set; `program` and `machine` by position, as the program counts and as the machine does.

    `loose` are those that have been solved since the axis's profile began, `seen` the positions, in both ways to
    count, at which the sides of all others were right. `count` is how many were ever set.
    """

    __slots__ = ("all", "count", "crossed", "free", "loose", "machine", "program", "seen")

    def __init__(self) -> None:
        self.all: dict[Watch, None] = {}
        self.loose: dict[Watch, None] = {}
        self.program: list[Key] = []
        self.machine: list[Key] = []
        self.seen = [0.0, 0.0]
        self.count = 0
        # From where to where the axis may go and pass none, nor meet a limit; None where that is not known.
        self.free: tuple[float, float] | None = None
        # When the axis was last known to be exactly at a position, which, and on which profile.
        self.crossed: tuple[float, float, Profile] | None = None

    def __iter__(self) -> Iterator[Watch]:
        return iter(self.all)

    def __contains__(self, watch: Watch) -> bool:
        return watch in self.all

    def __len__(self) -> int:
        return len(self.all)

    def append(self, watch: Watch) -> None:
        """Set one more; who does so solves it."""
        self.count += 1
        self.free = None
        watch.order = self.count
        self.all[watch] = self.loose[watch] = None
        insort_right(self.machine if watch.physical else self.program, (watch.position, watch.order, watch))

    def remove(self, watch: Watch) -> None:
        """End one, and what it waits for."""
        del self.all[watch]
        self.free = None
        self.loose.pop(watch, None)
        keys = self.machine if watch.physical else self.program
        del keys[bisect_left(keys, (watch.position, watch.order))]
        if watch.event is not None:
            watch.event.cancel()
            watch.event = None
        if watch.front is not None:
            watch.front.leave(watch)
