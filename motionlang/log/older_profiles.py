"""The profiles of an axis that are long over, packed."""

from __future__ import annotations

from bisect import bisect_right

from motionlang.log import stream
from motionlang.log.stream import Parts
from motionlang.planners.packed import packed, unpacked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from motionlang.controller.axis import Axis
    from motionlang.log.stream import Store
    from motionlang.planners import Profile


class Profiles:
    """The older profiles of an axis, packed: `count` of them, each with the time at which it began."""

    __slots__ = ("_begins", "_parts", "_total")

    def __init__(self, store: Store) -> None:
        self._total = 0  # how many profiles the axis has, while a packed part takes the place of some
        self._parts = Parts(store, lambda rows, _: rows)
        # When the first profile of each part began.
        self._begins: list[float] = []

    @property
    def count(self) -> int:
        """How many there are."""
        return self._parts.count

    @property
    def first(self) -> int:
        """The number of the oldest that is kept."""
        return self._parts.first

    def take_from(self, a: Axis, most: int) -> int:
        """Pack a part of the axis's profiles, the oldest ones, at most so many of them: how many those were."""
        count = min(stream.PART, most)
        starts, profiles = a.starts[:count], a.profiles[:count]
        place = self._parts.pack(list(zip(starts, map(packed, profiles), strict=True)))
        self._total = self.count + len(a.starts)
        self._parts.append(place, len(starts))
        self._begins.append(starts[0])
        del a.starts[:count]
        del a.profiles[:count]
        self._total = 0
        return count

    def keep_whole(self, a: Axis) -> None:
        """Complete what was half packed, or forget that part, as somebody ended the run at that moment."""
        self._parts.keep_whole()
        del self._begins[len(self._parts) :]
        if len(self._begins) < len(self._parts):
            self._begins.append(self.start(self._parts.firsts[-1]))
        if self._total:
            for track in a.starts, a.profiles:
                del track[: self.count + len(track) - self._total]
            self._total = 0

    def __iter__(self) -> Iterator[tuple[float, Profile]]:
        for number in range(len(self._parts)):
            for start, row in self._parts.part(number):
                yield start, unpacked(row)

    def rows(self, first: int, past: int) -> list[tuple[float, Any]]:
        """The starts and the packed profiles from number `first` to `past`, not included."""
        return self._parts.records(first, past)

    def start(self, number: int) -> float:
        """When a profile began."""
        start: float = self._parts.record(number)[0]
        return start

    def profile(self, number: int) -> Profile:
        """A profile."""
        return unpacked(self._parts.record(number)[1])

    def forget(self, time: float) -> None:
        """Forget what was over at a time; the numbers of the others stay what they are."""
        while len(self._begins) > 1 and self._begins[1] <= time:
            self._parts.forget()
            del self._begins[0]

    def in_force(self, time: float) -> int:
        """The number of the profile that was in force at a time; that of the first one where none was."""
        part = max(bisect_right(self._begins, time) - 1, 0)
        rows = self._parts.part(part)
        return max(self._parts.firsts[part] + bisect_right(rows, time, key=_start) - 1, 0)


def _start(row: tuple[float, object]) -> float:
    return row[0]
