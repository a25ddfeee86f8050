"""The changes of analogue inputs, with the samples of sensors on moving axes.

A sensor on an axis is sampled every millisecond, which gives 100 million values in 28 hours of motion. They follow from
the track of the axis, so the log only has when a sensor was sampled, and a sample is computed when it is read. The
sensor computes the samples that a program reads with the same function, so they are equal to the last bit.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from heapq import merge
from operator import attrgetter

from motionlang.kernel.controller.scale import in_unit
from motionlang.kernel.log.log import Log
from motionlang.kernel.log.records import Changed, Sampled
from motionlang.kernel.planners import Profile

# The period of the profiler, seconds.
PERIOD = 1e-3


def value_at(sampled: Sampled, position: float) -> float:
    """Return what a sensor measures at a position, in counts."""
    distance = in_unit(position - sampled.datum, sampled.factors) - sampled.origin
    return sampled.value + sampled.per_unit * distance


def sample(sampled: Sampled, start: float, profile: Profile, tick: int) -> float:
    """Return the sample at a tick of the profiler, from the profile that began at `start`."""
    return value_at(sampled, profile.position(tick * PERIOD - start))


class AnalogueChanges(Iterable[Changed]):
    """The changes of analogue inputs in order of time; a sample that equals the one before it is none.

    `settle` logs the samples up to now.
    """

    def __init__(self, log: Log, settle: Callable[[], None]) -> None:
        self._log, self._settle = log, settle

    def __iter__(self) -> Iterator[Changed]:
        self._settle()
        log = self._log
        samples = [self._samples(channel) for channel in sorted({each.channel for each in log.sampled})]
        levels: dict[int, float] = {}
        for each in merge(*samples, log.changes_of_analogue_inputs, key=attrgetter("time")):
            if levels.get(each.channel, 0) != each.value:
                levels[each.channel] = each.value
                yield each

    def _samples(self, channel: int) -> Iterator[Changed]:
        for each in self._log.sampled:
            if each.channel == channel:
                start, profile = self._log.moves.axes[each.axis].in_force(each.start)
                for tick in range(each.first, each.past):
                    yield Changed(tick * PERIOD, channel, sample(each, start, profile, tick))
