"""Buffer entries that are neither moves nor paths: cams, offsets, timed points.

Each begins when it is first in its buffer and released. An offset on an axis that follows a master does not
wait for the following to end: it begins as soon as it is released and the previous offset is done.
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.motion.follow import FollowMove, check_chain
from motionlang.kernel.controller.motion.offset import offset
from motionlang.kernel.controller.motion.profile_playback import Playback, Timed
from motionlang.kernel.controller.moves.cam import Cam, Table, curve_of
from motionlang.kernel.controller.queue import buffer
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.controller.queue.life import run_profile, start_move
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.pvt.motion import plan_pvt

Make = Callable[[float], Timed]

# ------------------------------------------------------------------------------------------------------ cams


class CamEntry(Action):
    """Follow a table from both axes' positions at its start.

    `first` is the number of its first segment.
    """

    __slots__ = ("cyclic", "first", "master", "table")
    can_stand = False

    def __init__(self, master: Axis, table: Table, cyclic: bool, first: int) -> None:
        self.master, self.table, self.cyclic, self.first = master, table, cyclic, first

    def begin(self, a: Axis, move: LoggedMove) -> None:
        """Tie the axis to its master on a table read now.

        Raises Rejected if the table cannot be followed.
        """
        check_chain(a, self.master)
        here = a.position(a.clock.now)
        points = self.table(here)
        curve = curve_of(a, points)
        target = INFINITY if self.cyclic else here + curve.end
        entry = FollowMove(a.index, move.command, move.line, "cam", target)
        entry.id = move.id
        cam = Cam(a, self.master, entry, curve, self.cyclic, self.first)
        cam.table, cam.lift = self.table, here
        cam.use(points)
        cam.engage()


def load_cam(
    a: Axis,
    master: Axis,
    table: Table,
    cyclic: bool,
    first: int,
    command: str,
    line: int,
) -> None:
    """Load a cam; `table` returns its points for the slave's position at its start.

    Only differences between the slave's positions count. If `table` returns the same object, the curve is the same.
    """
    start = _start(a)
    curve = curve_of(a, table(start))
    move = LoggedMove(a.index, command, line, INFINITY if cyclic else start + curve.end)
    move.base = None if cyclic else start
    move.action = CamEntry(master, table, cyclic, first)
    buffer.put(a, move)


def _start(a: Axis) -> float:
    """Return where an entry will begin, if that is known at loading."""
    end = buffer.end(a)
    return end if abs(end) < INFINITY else a.position(a.clock.now)


# --------------------------------------------------------------------------------------------------- offsets


class OffsetEntry(Action):
    """Superposition of a distance on a slave's motion; another axis moves by it."""

    __slots__ = ("distance", "mode", "over")
    lies_on_top = True

    def __init__(self, distance: float, mode: int, over: float) -> None:
        self.distance, self.mode, self.over = distance, mode, over

    def begin_on_top(self, a: Axis, move: LoggedMove) -> None:
        offset(a, self.distance, self.mode, self.over, move.command, move.line)

    def begin(self, a: Axis, move: LoggedMove) -> None:
        move.action = None
        move.target = a.position(a.clock.now) + self.distance
        start_move(a, move)


def load_offset(
    a: Axis, distance: float, mode: int = 0, over: float = 0.0, command: str = "", line: int = 0
) -> None:
    """Load an offset to be superposed on following; GO starts it during following.

    `mode` is one of the modes of OFFSETMODE.
    """
    move = buffer.counted(a, distance, command, line)
    move.action = OffsetEntry(distance, mode, over)
    buffer.put(a, move)


# ------------------------------------------------------------------------------------------------------ points


class PointsEntry(Action):
    """Motion through points made from the axis's position at the start.

    If `again` is set, it repeats with new points.
    """

    __slots__ = ("again", "make")

    def __init__(self, make: Make, again: Make | None) -> None:
        self.make, self.again = make, again

    @property
    def is_sequel(self) -> bool:
        return self.again is not None and self.make is self.again

    def prolong(self, end: float) -> Profile | None:
        return plan_pvt(*self.make(end)) if self.again is not None else None

    def begin(self, a: Axis, move: LoggedMove) -> None:
        """Make the profile and play it; with `again` the next entry waits in the buffer."""
        points = self.make(a.position(a.clock.now))
        profile = through(a, points)
        if self.again is not None:
            following = LoggedMove(a.index, move.command, move.line, profile.end)
            following.action = PointsEntry(self.again, self.again)
            following.id, following.chain, following.released = move.id, move.chain, True
            a.buffer.insert(0, following)
        playback = Playback(on_path=True)
        playback.ordered = points
        move.target, move.action = profile.end, playback
        profile = playback.waiting(profile) if a.suspended else profile
        run_profile(a, move, profile, BY_DESIGN)


def through(a: Axis, points: Timed) -> Profile:
    """Return the profile through timed points; raise Rejected if it is impossible."""
    try:
        return plan_pvt(*points)
    except ValueError as problem:
        raise Rejected("range", f"axis {a.index} cannot follow the spline: {problem}") from None


def load_points(a: Axis, make: Make, again: Make | None = None, command: str = "", line: int = 0) -> None:
    """Load timed points, which `make` returns for the axis's position at their start.

    `again` returns further points each time, endlessly.
    """
    start = _start(a)
    move = LoggedMove(a.index, command, line, through(a, make(start)).end)
    move.base = start
    move.action = PointsEntry(make, again)
    buffer.put(a, move)
