"""The complete motion of an axis since power-up, for proof, trace and pictures."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.joined import Joined
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.controller.scale import Scale
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import MotionState, Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.feedback import Feedback


class WholeTrack:
    """The motion of an axis since power-up: `starts[i]` is the start of `profiles[i]`."""

    def __init__(self, a: Axis) -> None:
        self._a, self.index = a, a.index
        older = a.older
        self.starts: Sequence[float] = a.starts
        self.profiles: Sequence[Profile] = a.profiles
        if older is not None:
            self.starts = Joined(a, 0)  # type: ignore[assignment]
            self.profiles = Joined(a, 1)  # type: ignore[assignment]

    @property
    def scale(self) -> Scale:
        """The current scale of the axis."""
        return self._a.scale

    @property
    def move(self) -> LoggedMove | None:
        """The move in progress."""
        return self._a.move

    @property
    def waiting(self) -> list[LoggedMove]:
        """The buffered moves of the axis; empty while the axis is suspended."""
        return [] if self._a.suspended else self._a.buffer

    @property
    def feedback(self) -> Feedback | None:
        """The simulated motor of the axis, or None."""
        return self._a.feedback

    def at(self, time: float) -> MotionState:
        """Return position, velocity, acceleration and jerk at a time, counts and seconds."""
        return self._a.at(time)

    def position(self, time: float) -> float:
        """Return the commanded position at a time, counts."""
        return self._a.position(time)

    def index_at(self, time: float) -> int:
        """Return the index of the profile in force at a time; -1 before power-up."""
        older = self._a.older
        if older is None or time >= self._a.starts[0]:
            return len(self.starts) - len(self._a.starts) + bisect_right(self._a.starts, time) - 1
        return older.in_force(time)

    def count(self, begin: float, end: float) -> int:
        """Return the number of profiles begun between two times; 0 if none are rows of the log."""
        return 0 if self._a.older is None else self.index_at(end) - self.index_at(begin)

    def between(self, begin: float, end: float) -> tuple[Sequence[float], Sequence[Profile]]:
        """Return starts and profiles in force from `begin` to `end`, with the one before.

        If none are rows of the log, all of them are returned.
        """
        if self._a.older is None:
            return self.starts, self.profiles
        some = slice(max(self.index_at(begin) - 1, 0), self.index_at(end) + 1)
        return self.starts[some], self.profiles[some]


def axes_of(controller: Controller) -> tuple[int, ...]:
    """Return the axes that ever moved or were given a position, or the first axis."""
    axes = controller.axes
    return tuple(axis.index for axis in axes.values() if len(axis.starts) > 1) or (next(iter(axes)),)


class Recorded:
    """A controller as recorded in its log: axes with their whole motion, and moves."""

    def __init__(self, controller: Controller) -> None:
        self.moves = controller.log.moves
        if self.moves.packed:  # of a long run all is, so that reading it takes no more memory than a chunk
            controller.log.pack((*controller.axes.values(), *controller.encoders.values()))
        self.axes = {number: WholeTrack(a) for number, a in controller.axes.items()}
