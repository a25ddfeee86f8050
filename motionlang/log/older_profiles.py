"""The older profiles of an axis, packed."""

from __future__ import annotations

from bisect import bisect_right

from motionlang.log import stream
from motionlang.log.stream import Chunks
from motionlang.planners.packed import packed, unpacked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator

    from motionlang.controller.axis import Axis
    from motionlang.log.stream import Store
    from motionlang.planners import Profile


class Profiles(Chunks):
    """The older profiles of an axis, packed: `count` of them, with start times."""

    __slots__ = ("_begins",)

    def __init__(self, store: Store) -> None:
        super().__init__(store, lambda rows, _: rows)
        # The start of the first profile of each chunk.
        self._begins: list[float] = []

    def take_from(self, a: Axis, most: int) -> int:
        """Pack up to `most` of the oldest profiles of the axis; return their number."""
        count = min(stream.CHUNK_SIZE, most)
        starts = a.starts[:count]
        rows = list(zip(starts, map(packed, a.profiles[:count]), strict=True))
        self.pack(rows, a.starts, a.profiles)
        self._begins.append(starts[0])
        return count

    def complete(self, a: Axis) -> None:
        """Complete partial packing of an axis's track after an interrupt."""
        self.finish_updates(a.starts, a.profiles)
        del self._begins[len(self) :]
        if len(self._begins) < len(self):
            self._begins.append(self.start(self.firsts[-1]))

    def cut_track(self, a: Axis, count: int) -> None:
        """Cut the track of the axis to `count` profiles if these have all been packed."""
        if count > self.count:
            return
        number = bisect_right(self.firsts, count - 1) - 1
        rows = self.records(self.firsts[number], count)
        a.starts[:], a.profiles[:] = [start for start, _ in rows], [unpacked(row) for _, row in rows]
        self.cut(number)
        del self._begins[number:]

    def __iter__(self) -> Iterator[tuple[float, Profile]]:
        for number in range(len(self)):
            for start, row in self.chunk(number):
                yield start, unpacked(row)

    def start(self, number: int) -> float:
        """Return the start time of a profile."""
        return self.record(number)[0]  # type: ignore[no-any-return]

    def profile(self, number: int) -> Profile:
        """Return a profile by its number."""
        return unpacked(self.record(number)[1])

    def forget_before(self, time: float) -> None:
        """Drop profiles that ended before a time; the others retain their numbers."""
        while len(self._begins) > 1 and self._begins[1] <= time:
            self.forget()
            del self._begins[0]

    def in_force(self, time: float) -> int:
        """Return the number of the profile in force at a time, or the first one's."""
        number = max(bisect_right(self._begins, time) - 1, 0)
        rows = self.chunk(number)
        return max(self.firsts[number] + bisect_right(rows, time, key=_start) - 1, self.first)


def _start(row: tuple[float, object]) -> float:
    return row[0]
