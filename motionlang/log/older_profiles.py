"""The profiles of an axis that are long over, packed."""

from __future__ import annotations

from bisect import bisect_right

from motionlang.log import stream
from motionlang.log.stream import Parts
from motionlang.planners.packed import packed, unpacked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from motionlang.controller.axis import Axis
    from motionlang.log.stream import Store
    from motionlang.planners import Profile


class Profiles(Parts):
    """The older profiles of an axis, packed: `count` of them, each with the time at which it began."""

    __slots__ = ("_begins",)

    def __init__(self, store: Store) -> None:
        super().__init__(store, lambda rows, _: rows)
        # When the first profile of each part began.
        self._begins: list[float] = []

    def take_from(self, a: Axis, most: int) -> int:
        """Pack a part of the axis's profiles, the oldest ones, at most so many of them: how many those were."""
        count = min(stream.PART, most)
        starts = a.starts[:count]
        rows = list(zip(starts, map(packed, a.profiles[:count]), strict=True))
        self.pack(rows, a.starts, a.profiles)
        self._begins.append(starts[0])
        return count

    def complete(self, a: Axis) -> None:
        """Keep it and the track of its axis whole, as somebody ended the run at any moment."""
        self.keep_whole(a.starts, a.profiles)
        del self._begins[len(self) :]
        if len(self._begins) < len(self):
            self._begins.append(self.start(self.firsts[-1]))

    def __iter__(self) -> Iterator[tuple[float, Profile]]:
        for number in range(len(self)):
            for start, row in self.part(number):
                yield start, unpacked(row)

    def start(self, number: int) -> float:
        """When a profile began."""
        return self.record(number)[0]  # type: ignore[no-any-return]

    def profile(self, number: int) -> Profile:
        """A profile."""
        return unpacked(self.record(number)[1])

    def forget_before(self, time: float) -> None:
        """Forget what was over at a time; the numbers of the others stay what they are."""
        while len(self._begins) > 1 and self._begins[1] <= time:
            self.forget()
            del self._begins[0]

    def in_force(self, time: float) -> int:
        """The number of the profile that was in force at a time; that of the first one where none was."""
        part = max(bisect_right(self._begins, time) - 1, 0)
        rows = self.part(part)
        return max(self.firsts[part] + bisect_right(rows, time, key=_start) - 1, 0)


def _start(row: tuple[float, object]) -> float:
    return row[0]
