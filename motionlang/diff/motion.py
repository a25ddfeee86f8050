"""Where the motion of two runs parts: the first moment at which an axis stands elsewhere."""

from __future__ import annotations

from motionlang.controller.record.track import WholeTrack

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from motionlang.controller.axis import Axis
    from motionlang.result import Run

# Places in each stretch between two profiles of either run at which they are compared, and halvings to find the moment.
LOOKS, HALVINGS = 8, 40
# What rounding makes of a position, as a part of it.
ROUNDING = 1e-9


class Parting:
    """The machine `time` at which `axis` is first elsewhere, and the largest distance, user units, with its time."""

    __slots__ = ("axis", "largest", "largest_at", "time")

    def __init__(self, axis: int, time: float, largest: float, largest_at: float) -> None:
        self.axis, self.time, self.largest, self.largest_at = axis, time, largest, largest_at


def parting(old: Run, new: Run, tolerance: float = 0.0) -> Parting | None:
    """The first parting of all axes that both have; None where all stand together as long as both run."""
    end = min(old.time, new.time)
    found = [
        parted
        for number, a in old.controller.axes.items()
        if number in new.controller.axes
        and (parted := _of_axis(a, new.controller.axes[number], end, tolerance)) is not None
    ]
    return min(found, key=lambda each: (each.time, each.axis), default=None)


def _of_axis(a: Axis, b: Axis, end: float, tolerance: float) -> Parting | None:
    def apart(time: float) -> float:
        one, other = a.scale.position_to_user(a.position(time)), b.scale.position_to_user(b.position(time))
        return max(abs(one - other) - ROUNDING * max(abs(one), abs(other), 1.0), 0.0)

    first: float | None = None
    largest = (0.0, 0.0)
    before = 0.0
    for begin, finish in _stretches(a, b, end):
        for n in range(1, LOOKS + 1):
            time = begin + (finish - begin) * n / LOOKS
            distance = apart(time)
            if distance > tolerance and first is None:
                first = _moment(apart, before, time, tolerance)
            if distance > largest[0]:
                largest = (distance, time)
            before = time
    return None if first is None else Parting(a.index, first, *largest)


def _stretches(a: Axis, b: Axis, end: float) -> Iterator[tuple[float, float]]:
    """The times between two profiles of either, without those in which both do the same."""
    tracks = WholeTrack(a), WholeTrack(b)
    same, pairs = (
        0,
        zip(tracks[0].starts, tracks[0].profiles, tracks[1].starts, tracks[1].profiles, strict=False),
    )
    for start, profile, other_start, other in pairs:
        if (start, profile.start, profile.end, profile.duration, profile._recipe) != (
            other_start, other.start, other.end, other.duration, other._recipe
        ):  # fmt: skip
            break
        same += 1
    same = max(same - 1, 0)
    starts = sorted({*list(tracks[0].starts)[same:], *list(tracks[1].starts)[same:], end})
    begin = starts[0]
    for start in starts[1:]:
        if start > end:
            break
        yield begin, start
        begin = start


def _moment(apart: Callable[[float], float], low: float, high: float, tolerance: float) -> float:
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if apart(middle) > tolerance:
            high = middle
        else:
            low = middle
    return high
