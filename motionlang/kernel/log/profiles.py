"""The older profiles of an axis, as rows."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from motionlang.kernel.log.records import ProfileRow
from motionlang.kernel.log.stream import CHUNK, Store, Stream
from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.packed import packed, unpacked

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis


class Profiles:
    """The older profiles of an axis: `count` of them, with start times."""

    def __init__(self, store: Store) -> None:
        self._rows: Stream[ProfileRow] = Stream(store, ProfileRow)
        # The starts of every `CHUNK`th profile.
        self._begins: list[float] = []
        # The number of all profiles of the axis, while some of them become rows.
        self._total = 0

    @property
    def count(self) -> int:
        """The number of profiles, those that were dropped included."""
        return len(self._rows)

    @property
    def first(self) -> int:
        """The number of the oldest profile that is left."""
        return self._rows.first

    def take_from(self, a: Axis, count: int) -> None:
        """Make rows of the oldest profiles of the axis."""
        self._total = self.count + len(a.starts)
        for start, profile in zip(a.starts[:count], a.profiles[:count], strict=True):
            if not self.count % CHUNK:
                self._begins.append(start)
            self._rows.add(ProfileRow(start, *parted(profile)))
        del a.starts[:count]
        del a.profiles[:count]
        self._total = 0

    def complete(self, a: Axis) -> None:
        """Complete `take_from` after an interrupt."""
        self._rows.finish_updates()
        if self._total:
            del a.starts[: self.count + len(a.starts) - self._total]
            del a.profiles[: self.count + len(a.profiles) - self._total]
            self._total = 0
        del self._begins[-(-self.count // CHUNK) :]

    def cut_track(self, a: Axis, count: int) -> None:
        """Cut the track of the axis to `count` profiles if these are all rows; the last one is then none."""
        if count <= self.count:
            ((start, profile),) = self.between(count - 1, count)
            a.starts[:], a.profiles[:] = [start], [profile]
            self._rows.cut(count - 1)
            del self._begins[-(-self.count // CHUNK) :]

    def between(self, first: int, past: int) -> Iterator[tuple[float, Profile]]:
        """Yield the starts and profiles from number `first` to `past` (exclusive)."""
        for row in self._rows.between(first, past):
            profile = joined(row.form, row.numbers)
            assert profile is not None
            yield row.start, profile

    def start(self, number: int) -> float:
        """Return the start time of a profile."""
        return self._rows[number].start

    def profile(self, number: int) -> Profile:
        return next(self.between(number, number + 1))[1]

    def forget_before(self, time: float) -> None:
        """Drop profiles that ended before a time; the others retain their numbers."""
        self._rows.forget((self.count - self.in_force(time)) // 2 + CHUNK)

    def in_force(self, time: float) -> int:
        """Return the number of the profile in force at a time, or the first one's."""
        first = max(bisect_right(self._begins, time) - 1, 0) * CHUNK
        numbers = range(max(first, self.first), min(first + CHUNK, self.count))
        return max(numbers.start + bisect_right(numbers, time, key=self.start) - 1, self.first)


def parted(profile: Profile | None) -> tuple[object, tuple[float, ...]]:
    """Return a profile as its form, which many have in common, and its numbers; `joined` puts them together."""
    if profile is None:
        return None, ()
    numbers: list[float] = []
    return _form(packed(profile), numbers), tuple(numbers)


def _form(value: object, numbers: list[float]) -> object:
    if isinstance(value, tuple):
        return tuple([_form(each, numbers) for each in value])
    if isinstance(value, float):
        numbers.append(value)
        return float
    return value


def joined(form: Any, numbers: tuple[float, ...]) -> Profile | None:
    """Return the profile of a form and its numbers."""
    return None if form is None else unpacked(_filled(form, iter(numbers)))


def _filled(form: Any, numbers: Iterator[float]) -> Any:
    if form is float:
        return next(numbers)
    return tuple([_filled(each, numbers) for each in form]) if isinstance(form, tuple) else form
