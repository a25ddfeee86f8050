"""The divergence of the motion of two runs: the first time at which they differ."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.planners.evaluate import piece_values
from motionlang.kernel.planners.sample import PieceTable
from motionlang.kernel.result import Run
from motionlang.kernel.tracks.track import WholeTrack

Array = NDArray[np.float64]

# Times in each stretch between two profiles of either run at which they are compared, and bisections to find
# the time.
SAMPLES, HALVINGS = 8, 40
# The relative rounding of a position; and a hundredth of it, by which a table of pieces may differ in
# addition.
ROUNDING, TABLE = 1e-9, 1e-11
# Stretches that are compared at once.
TOGETHER = 50_000


@dataclass(eq=False, slots=True)
class Divergence:
    """The machine `time` at which `axis` first differs, and the largest distance, uu.

    The time of the largest distance is included.
    """

    axis: int
    time: float
    max_difference: float
    max_difference_at: float


def divergence(old: Run, new: Run, tolerance: float = 0.0) -> Divergence | None:
    """Return the first divergence of all common axes; None if there is none.

    Only the time before the first end of the two runs is compared.
    """
    end = min(old.time, new.time)
    found = [
        diverged
        for number, a in old.controller.axes.items()
        if number in new.controller.axes
        and (diverged := _of_axis(a, new.controller.axes[number], end, tolerance)) is not None
    ]
    return min(found, key=lambda each: (each.time, each.axis), default=None)


def _of_axis(a: Axis, b: Axis, end: float, tolerance: float) -> Divergence | None:
    def apart(time: float) -> float:
        one, other = a.scale.position_to_user(a.position(time)), b.scale.position_to_user(b.position(time))
        return max(abs(one - other) - ROUNDING * max(abs(one), abs(other), 1.0), 0.0)

    first: float | None = None
    largest = (0.0, 0.0)
    before = 0.0
    for times in _sample_times(a, b, end):
        far, apart_enough = _candidates(a, b, times, tolerance)
        if first is None:
            for k in apart_enough:
                if apart(times[k]) > tolerance:
                    first = _moment(apart, times[k - 1] if k else before, times[k], tolerance)
                    break
        for k in far:
            distance = apart(times[k])
            if distance > largest[0]:
                largest = (distance, times[k])
        before = times[-1]
    return None if first is None else Divergence(a.index, first, *largest)


def _sample_times(a: Axis, b: Axis, end: float) -> Iterator[list[float]]:
    """Yield the times at which two axes are compared, in batches."""
    edges = np.fromiter(_edges(a, b, end), dtype=np.float64)
    for first in range(0, len(edges) - 1, TOGETHER):
        some = edges[first : first + TOGETHER + 1]
        begins, lengths = some[:-1, None], np.diff(some)[:, None]
        yield (begins + lengths * np.arange(1, SAMPLES + 1) / SAMPLES).ravel().tolist()


def _candidates(
    a: Axis, b: Axis, times: Sequence[float], tolerance: float
) -> tuple[list[int], Sequence[int]]:
    """Return the times at which two axes may be farthest apart, or beyond tolerance.

    The positions come from tables that are nearly exact; a margin covers their error.
    """
    one, other = _positions(a, times), _positions(b, times)
    if one is None or other is None:
        return list(range(len(times))), range(len(times))
    size = np.maximum(np.maximum(np.abs(one), np.abs(other)), 1.0)
    zeros = max(abs(each.scale.zero / each.scale.counts) for each in (a, b))
    distance, doubt = np.abs(one - other) - ROUNDING * size, TABLE * (size + zeros)
    far = np.flatnonzero((distance + 2.0 * doubt >= np.max(distance)) & (distance + doubt > 0.0))
    first_such: dict[tuple[float, float], int] = {}  # a cycle reaches the same positions repeatedly
    for k, positions in zip(
        far.tolist(), zip(one[far].tolist(), other[far].tolist(), strict=True), strict=True
    ):
        first_such.setdefault(positions, k)
    return list(first_such.values()), np.flatnonzero(distance + doubt > tolerance).tolist()


def _positions(axis: Axis, times: Sequence[float]) -> Array | None:
    """Return the positions of an axis, user units; None if it is not all in pieces."""
    track = WholeTrack(axis)
    some = slice(max(track.index_at(times[0]) - 1, 0), track.index_at(times[-1]) + 1)
    table = PieceTable(track.starts[some], track.profiles[some])
    if not table.is_exact:
        return None
    piece = np.clip(np.searchsorted(table.origins, times, "right") - 1, 0, None)
    values = piece_values(table.columns, piece, np.asarray(times) - table.origins[piece], 0)
    return (values - axis.scale.zero) / axis.scale.counts


def _edges(a: Axis, b: Axis, end: float) -> list[float]:
    """Return the start times of both axes' profiles after their common beginning.

    Only starts up to `end` are included, and `end` itself.
    """
    tracks = WholeTrack(a), WholeTrack(b)
    same = 0
    pairs = zip(tracks[0].starts, tracks[0].profiles, tracks[1].starts, tracks[1].profiles, strict=False)
    for start, profile, other_start, other in pairs:
        if (start, profile.start, profile.end, profile.duration, profile._recipe) != (
            other_start, other.start, other.end, other.duration, other._recipe
        ):  # fmt: skip
            break
        same += 1
    same = max(same - 1, 0)
    starts = sorted({*list(tracks[0].starts)[same:], *list(tracks[1].starts)[same:], end})
    return starts[: bisect_right(starts, end)]


def _moment(apart: Callable[[float], float], low: float, high: float, tolerance: float) -> float:
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if apart(middle) > tolerance:
            high = middle
        else:
            low = middle
    return high
