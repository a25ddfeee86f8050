"""The history of a controller's channels, one lane per channel."""

from __future__ import annotations

from typing import NamedTuple

from motionlang.kernel import Controller
from motionlang.kernel.log import Changed, Stream, Switched

# group -> (name in the log, prefix of a lane's name, True for digital channels)
GROUPS = {
    "inputs": ("inputs", "in", True),
    "outputs": ("outputs", "out", True),
    "analogue inputs": ("analogue_inputs", "ain", False),
    "analogue outputs": ("analogue_outputs", "aout", False),
}


class ChannelLane(NamedTuple):
    """One channel: `values[i]` holds from `times[i]` (seconds) on.

    The first value holds from time 0.
    """

    group: str
    number: int
    times: list[float]
    values: list[float]

    @property
    def name(self) -> str:
        """Its short name, such as "in3"."""
        return f"{GROUPS[self.group][1]}{self.number}"

    @property
    def is_digital(self) -> bool:
        """True if it is on or off."""
        return GROUPS[self.group][2]

    def spans(self, end: float) -> list[tuple[float, float]]:
        """Return the intervals in which a digital channel is on.

        The run ends at `end`.
        """
        found: list[tuple[float, float]] = []
        begin = None
        for time, value in zip(self.times, self.values, strict=True):
            if value and begin is None:
                begin = time
            elif not value and begin is not None:
                found.append((begin, time))
                begin = None
        return found if begin is None else [*found, (begin, end)]


def lanes(controller: Controller) -> list[ChannelLane]:
    """Return a lane for every channel that changed, by group and number."""
    made: list[ChannelLane] = []
    for group, (attribute, _, _) in GROUPS.items():
        changes: Stream[Changed] | Stream[Switched] = getattr(controller.log, attribute)
        found: dict[int, ChannelLane] = {}
        for time, channel, value, *_ in changes:
            lane = found.get(channel)
            if lane is None:
                lane = found[channel] = ChannelLane(group, channel, [0.0], [0.0])
            if time == 0.0:
                lane.values[0] = float(value)
            else:
                lane.times.append(time)
                lane.values.append(float(value))
        made += (found[channel] for channel in sorted(found))
    return made
