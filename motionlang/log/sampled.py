"""Samples of a moving axis, as a template that is read like a list.

A sensor on an axis is sampled every millisecond, which gives 100 million records in 28 hours of motion. They follow
from the profile of the axis, so the log stores the profile, and a record is computed when it is read. The sensor
computes the samples that a program reads with the same function, so they are equal to the last bit.

A record is written only if its value differs from the last one. The number of records must be known before they are
computed, so only samples that certainly differ become a template (`is_distinct`). Samples near standstill, at both
ends of the motion, are ordinary records before and after it.
"""

from __future__ import annotations

from motionlang.controller.scale import in_unit
from motionlang.planners.packed import unpacked

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from typing import Any

    from motionlang.planners import Profile

    # Time, channel and value.
    Row = tuple[float, int, float]
    # The value at the origin, the value of a length unit, the origin, the machine's zero, and the factors of lengths
    # in the scale of the axis.
    Conversion = tuple[float, float, float, float, tuple[float, float]]
    # The rows before, those after, the number of samples, the first tick, and the arguments of `Sampling`, with a
    # packed profile.
    Template = tuple[list[Row], list[Row], int, int, tuple[Any, ...]]

# Records that are made at once.
_BATCH = 1024
# Samples of positions differ if they are this much apart, as a fraction of the numbers in their computation.
_MARGIN = 1e-9


class Sampling:
    """The samples of a channel along a profile, one every `period` seconds.

    The profile begins at `start`, in seconds of machine time.
    """

    __slots__ = ("channel", "conversion", "period", "profile", "start")

    def __init__(
        self, channel: int, period: float, start: float, conversion: Conversion, profile: Profile
    ) -> None:
        self.channel, self.period, self.start = channel, period, start
        self.conversion, self.profile = conversion, profile

    def value_at(self, position: float) -> float:
        """Return the value at a position, in counts."""
        value, per_unit, origin, datum, factors = self.conversion
        return value + per_unit * (in_unit(position - datum, factors) - origin)

    def value(self, number: int) -> float:
        """Return the sample at a tick, given by its number."""
        return self.value_at(self.profile.position(number * self.period - self.start))

    def rows(self, numbers: Sequence[int]) -> list[Row]:
        """Return the samples at successive ticks."""
        channel, value_at = self.channel, self.value_at
        times = [number * self.period for number in numbers]
        positions = self.profile.positions([time - self.start for time in times])
        return [(time, channel, value_at(position)) for time, position in zip(times, positions, strict=True)]

    def is_distinct(self, first: int, last: int) -> bool:
        """True if successive samples from one tick to another certainly differ.

        The axis must not reverse, and must be fast enough at both ticks and at all knots between them.
        """
        profile = self.profile
        begin, finish = first * self.period - self.start, last * self.period - self.start
        if not profile.direction or not 0.0 <= begin < finish < profile.duration:
            return False
        value, per_unit, origin, datum, factors = self.conversion
        speed = min(abs(profile.velocity(begin)), abs(profile.velocity(finish)))
        for knot in profile.knots:
            if begin < knot < finish:
                speed = min(speed, abs(profile.velocity(knot)))
        farthest = abs(profile.position(begin)) + abs(profile.position(finish)) + abs(datum)
        factor = abs(in_unit(1.0, factors))
        size = abs(value) + abs(per_unit) * (farthest * factor + abs(origin))
        return speed * self.period * factor * abs(per_unit) > _MARGIN * size

    def template(self, before: list[Row], after: list[Row], first: int, count: int) -> Template:
        """Return the template of `count` samples from a tick on, with rows around them."""
        profile = self.profile
        recipe = profile.start_velocity, profile.end_velocity
        packed = profile.shape, profile.start, profile.end, profile.duration, recipe, profile.curve
        return before, after, count, first, (self.channel, self.period, self.start, self.conversion, packed)


class SampledRecords:
    """The records of a template, in order; `make` converts plain tuples to records."""

    __slots__ = ("_after", "_before", "_count", "_first", "_make", "_sampling")

    def __init__(self, template: Template, make: Callable[[list[Any]], list[Any]]) -> None:
        self._before, self._after, self._count, self._first, details = template
        channel, period, start, conversion, profile = details
        self._sampling = Sampling(channel, period, start, conversion, unpacked(profile))
        self._make = make

    def __len__(self) -> int:
        return len(self._before) + self._count + len(self._after)

    def __iter__(self) -> Iterator[Any]:
        for first in range(0, len(self), _BATCH):
            yield from self[first : first + _BATCH]

    def __reversed__(self) -> Iterator[Any]:
        for past in range(len(self), 0, -_BATCH):
            yield from reversed(self[max(past - _BATCH, 0) : past])

    def __getitem__(self, index: int | slice) -> Any:
        numbers = range(len(self))[index]
        if not isinstance(numbers, range):
            return self._records(range(numbers, numbers + 1))[0]
        if not numbers:
            return []
        low, high = min(numbers[0], numbers[-1]), max(numbers[0], numbers[-1])
        found = self._records(range(low, high + 1))
        return found[:: numbers.step] if numbers.step > 0 else found[::-1][:: -numbers.step]

    def _records(self, numbers: range) -> list[Any]:
        """Return the records with successive numbers."""
        begin, finish = len(self._before), len(self._before) + self._count
        first, past = max(numbers.start, begin), min(numbers.stop, finish)
        rows = self._before[numbers.start : numbers.stop]
        if first < past:
            rows += self._sampling.rows(range(self._first + first - begin, self._first + past - begin))
        rows += self._after[max(numbers.start - finish, 0) : max(numbers.stop - finish, 0)]
        return self._make(rows)


def length(template: Template) -> int:
    """Return the number of records of a template."""
    before, after, count, *_ = template
    return len(before) + count + len(after)
