"""A run of servo samples, step by step, from trajectory points to columns."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from motionlang.servo.steps import MEMORY, empty_columns, put, stepper

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    from motionlang.servo.loop import Loop
    from motionlang.servo.plant import Drive, Motor
    from motionlang.servo.steps import State

    Array = NDArray[np.float64]
    Floats = Sequence[float] | Array

MARKED = 64
"""Plain steps between two stored states, if any are stored."""
# Samples stepped at once: lists are four times as large as arrays.
_CHUNK = 1 << 13
# Modes in which the integral does not depend on the command.
_STEADFAST = frozenset(("always", "never"))
_STILL = 1e-9
_ROUNDING = 1e-15
_TOTAL = MEMORY.index("total") - len(MEMORY)


class Stretch:
    """Consecutive samples: their requested columns, and the trajectory points used.

    `marks` are intermediate states, each with the number of samples before it.
    """

    __slots__ = ("columns", "marks", "offset", "points", "ratio", "shifts")

    def __init__(
        self,
        points: Floats,
        offset: int,
        ratio: int,
        columns: Sequence[Floats],
        marks: Sequence[tuple[int, State]] = (),
    ) -> None:
        self.points, self.offset, self.ratio, self.columns, self.marks = points, offset, ratio, columns, marks
        # Samples of the run from which the program's zero is moved, with the distance.
        self.shifts: list[tuple[int, float]] = [(0, 0.0)]

    def demand(self, count: int) -> Array:
        """Return the commanded positions of the first `count` samples, interpolated."""
        import numpy as np

        points = np.asarray(self.points, dtype=np.float64)
        if self.ratio == 1:
            return points[self.offset : self.offset + count]
        every = np.multiply.outer(np.diff(points), np.arange(self.ratio) / self.ratio)
        every += points[:-1, None]
        flat: Array = every.reshape(-1)
        return flat[self.offset : self.offset + count]

    def mark_before(self, sample: int) -> tuple[int, State, list[float]] | None:
        """Return the last mark before a sample, or None.

        It is a tuple of the number of samples, the state, and the points around it.
        """
        for done, state in reversed(self.marks):
            cycle = (self.offset + done) // self.ratio
            if done < sample and cycle:
                return done, state, [float(point) for point in self.points[cycle - 1 : cycle + 2]]
        return None

    def last_demand(self, count: int) -> float:
        """Return the commanded position of sample `count` - 1."""
        cycle, k = divmod(self.offset + count - 1, self.ratio)
        here, there = float(self.points[cycle]), float(self.points[cycle + 1])
        return here + k * ((there - here) / self.ratio)


def run_stretch(
    loop: Loop,
    plant: Motor | Drive,
    columns: tuple[str, ...],
    points: Floats,
    offset: int,
    count: int,
    state: State,
) -> tuple[Stretch, State]:
    """Run `count` samples; the first has the number `offset` in its trajectory cycle.

    `points` are the trajectory points: the one before the first cycle, its beginning, and the end of every
    cycle.
    """
    if count <= _CHUNK:
        return run_steps(loop, plant, columns, points, offset, count, state)
    import numpy as np

    at = np.asarray(points, dtype=np.float64)
    out = np.empty((len(columns), count))
    for begin in range(0, count, _CHUNK):
        end = min(begin + _CHUNK, count)
        cycle, inside = divmod(offset + begin, loop.ratio)
        last = -(-(offset + end) // loop.ratio)
        chunk, state = run_steps(loop, plant, columns, at[cycle : last + 2], inside, end - begin, state)
        for row, values in zip(out, chunk.columns, strict=True):
            put(values, row[begin:end])
    return Stretch(at[1:], offset, loop.ratio, list(out)), state


def run_steps(
    loop: Loop,
    plant: Motor | Drive,
    columns: tuple[str, ...],
    points: Floats,
    offset: int,
    count: int,
    state: State,
) -> tuple[Stretch, State]:
    """Run samples like `run_stretch`, but step by step, in lists and with marks."""
    samples = slice(offset, offset + count)
    if isinstance(points, list):
        demand, feed = _given(loop, points, samples)
    else:
        demand, feed = _given_at_once(loop, points, samples)  # type: ignore[arg-type]
    acting, out, marks = _acting(loop, points), empty_columns(columns), []
    for begin, end, integrating, clears in _spans(loop, acting, offset, count):
        state = _cleared(state) if clears else state
        step = stepper(loop, plant, columns, integrating)
        for first in range(begin, end, MARKED):
            marks.append((first, state))
            until = min(first + MARKED, end)
            state = step(demand[first:until], feed[first:until], state, out)
    return Stretch(points[1:], offset, loop.ratio, out, marks), state


def _given(loop: Loop, points: Sequence[float], samples: slice) -> tuple[list[float], list[float]]:
    """Return command and feed-forward of a slice of samples, from trajectory points.

    The feed-forward is empty if the loop has none.
    """
    ratio = loop.ratio
    feed = _feed(loop, points) if loop.has_feed_forward else []
    if ratio == 1:
        return list(points[1:-1])[samples], feed[samples]
    demand = []
    for here, there in pairwise(points[1:]):
        slope = (there - here) / ratio
        demand += [here + k * slope for k in range(ratio)]
    steady = [feed[i // ratio] for i in range(samples.start, samples.stop)] if feed else []
    return demand[samples], steady


def _given_at_once(loop: Loop, points: Array, samples: slice) -> tuple[list[float], list[float]]:
    """Return the same as `_given`, to the last bit, from points in an array."""
    import numpy as np

    ratio = loop.ratio
    moved = points[1:] - points[:-1]
    feed = _feeds(loop, moved)
    if ratio == 1:
        return points[1:-1][samples].tolist(), feed[samples].tolist()
    demand = np.multiply.outer(moved[1:] / ratio, np.arange(ratio))
    demand += points[1:-1, None]
    return demand.reshape(-1)[samples].tolist(), np.repeat(feed, ratio)[samples].tolist()


# ------------------------------------------------------------------------------------- effects of the command


def _feed(loop: Loop, points: Sequence[float]) -> list[float]:
    """Return the feed-forward volts of each cycle.

    They depend on the points at both ends of the cycle and the point before.
    """
    rate = loop.trajectory_rate
    steady, accel, decel = loop.velocity_ff * rate, loop.accel_ff * rate * rate, loop.decel_ff * rate * rate
    moved = pairwise([there - here for here, there in pairwise(points)])
    if accel == decel:
        return [steady * now + accel * (now - last) for last, now in moved]
    return [
        steady * now + (decel if (now - last) * (now + last) < 0.0 else accel) * (now - last)
        for last, now in moved
    ]


def _feeds(loop: Loop, speed: Array) -> Array:
    import numpy as np

    if not loop.has_feed_forward:
        return np.zeros(0)
    rate, last, now = loop.trajectory_rate, speed[:-1], speed[1:]
    change = now - last
    accel, decel = loop.accel_ff * rate * rate, loop.decel_ff * rate * rate
    gain = accel if accel == decel else np.where(change * (now + last) < 0.0, decel, accel)
    made: Array = (loop.velocity_ff * rate) * now + gain * change
    return made


def _acting(loop: Loop, points: Floats) -> list[bool]:
    """Return for each cycle if the integral acts; one value if that never changes."""
    mode = loop.integral_mode
    if mode in _STEADFAST:
        return [True]
    near = points if isinstance(points, list) else points.tolist()  # type: ignore[union-attr]
    return [_acts(mode, *each) for each in zip(near, near[1:], near[2:], strict=False)]


def _acts(mode: str, before: float, here: float, there: float) -> bool:
    """True if the integral acts in a cycle, according to `loop.INTEGRAL_MODES`."""
    change = there - 2.0 * here + before if mode == "steady" else there - here
    return abs(change) <= _STILL + 4.0 * _ROUNDING * abs(here)


def _spans(loop: Loop, acting: Sequence[bool], offset: int, count: int) -> list[tuple[int, int, bool, bool]]:
    """Return the runs of samples in which the integral acts, or does not.

    Each is begin, end, true if the integral acts, and true if it is cleared first.
    """
    ratio = loop.ratio
    changes = [i for i in range(1, len(acting)) if acting[i] != acting[i - 1]]
    edges = [0, *(min(max(i * ratio - offset, 0), count) for i in changes), count]
    found = []
    for (begin, end), i in zip(pairwise(edges), [0, *changes], strict=True):
        clears = loop.integral_mode == "zeroed" and not acting[i]
        if end > begin:
            found.append((begin, end, acting[i], clears))
    return found


def _cleared(state: State) -> State:
    made = list(state)
    made[_TOTAL] = 0.0
    return tuple(made)
