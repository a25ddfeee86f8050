"""The track of an axis since power-up, the older profiles included, read like two lists."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.axis import Axis

# Older profiles that are cached as objects once they have been read.
_MAX_CACHED = 1024


class Joined:
    """The starts (column 0) or the profiles (column 1) of an axis, as one list.

    An item that has been dropped reads as the oldest one stored.
    """

    __slots__ = ("_axis", "_cached", "_column")

    def __init__(self, axis: Axis, column: int) -> None:
        self._axis, self._column = axis, column
        # Older profiles by number: a reader of the track needs each a few times.
        self._cached: dict[int, Profile] = {}

    def __len__(self) -> int:
        older = self._axis.older
        return (0 if older is None else older.count) + len(self._axis.starts)

    def __iter__(self) -> Iterator[Any]:
        column = self._column
        older = self._axis.older
        for pair in () if older is None else older.between(older.first, older.count):
            yield pair[column]
        yield from self._now()

    def __getitem__(self, index: int | slice) -> Any:
        if isinstance(index, slice):
            return self._range(*index.indices(len(self)))
        index += len(self) if index < 0 else 0
        older = self._axis.older
        behind = index if older is None else index - older.count
        if behind >= 0:
            return self._now()[behind]
        assert older is not None
        index = max(index, older.first)
        if index == older.count:
            return self._now()[0]
        if not self._column:
            return older.start(index)
        found = self._cached.get(index)
        if found is None:
            if len(self._cached) >= _MAX_CACHED:
                self._cached.clear()
            found = self._cached[index] = older.profile(index)
        return found

    def _range(self, first: int, past: int, step: int) -> list[Any]:
        """Return the items of a slice; consecutive older ones are read in one go."""
        older = self._axis.older
        count = 0 if older is None else older.count
        if step != 1 or older is None or not older.first <= first < min(past, count):
            return [self[i] for i in range(first, past, step)]
        found = list(older.between(first, min(past, count)))
        now = self._now()[: max(past - count, 0)]
        if not self._column:
            return [*(start for start, _ in found), *now]
        known = self._cached
        if len(found) > _MAX_CACHED:
            return [*(profile for _, profile in found), *now]
        if len(known) + len(found) > _MAX_CACHED:
            known.clear()
        for number, (_, profile) in enumerate(found, first):
            known.setdefault(number, profile)
        return [*(known[number] for number in range(first, first + len(found))), *now]

    def _now(self) -> Sequence[Any]:
        return self._axis.profiles if self._column else self._axis.starts


class Followed:
    """The track of an axis, for a reader that follows it while it grows and is packed."""

    __slots__ = ("profiles", "starts")

    def __init__(self, axis: Axis) -> None:
        self.starts: Sequence[float] = Joined(axis, 0)  # type: ignore[assignment]
        self.profiles: Sequence[Profile] = Joined(axis, 1)  # type: ignore[assignment]
