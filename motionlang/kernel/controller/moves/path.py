"""Paths in the move buffer: one entry per axis, begun together.

They begin when all of them are first in their buffers. The first axis of a path is its master: its speed and
rates are those of the path, and GO on it releases all entries.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from motionlang.kernel import controller, planners
from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.moves.geometry import Arc, PathSegment, StraightLine, corner, limits
from motionlang.kernel.controller.queue import buffer
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.controller.queue.life import permit_motion
from motionlang.kernel.controller.queue.plan import checked_speed_and_rates
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.moves.path_policy import PathPolicy
    from motionlang.kernel.controller.moves.path_run import PathRun
    from motionlang.kernel.planners.lookahead import PathPace


class PathMove(Action):
    """One path: its `moves`, one per axis, its geometry, and its `run` once started.

    The geometry of a `relative` path counts from the positions of its axes at its start. A `policy` replaces the
    settings of the axes. `scales` are the counts per user unit of each axis when the path was loaded.
    """

    __slots__ = ("axes", "geometry", "moves", "policy", "relative", "run", "scales")

    def __init__(
        self,
        axes: Sequence[Axis],
        moves: Sequence[LoggedMove],
        geometry: StraightLine | Arc,
        relative: bool,
        policy: PathPolicy | None = None,
    ) -> None:
        self.axes, self.moves, self.geometry, self.relative = tuple(axes), tuple(moves), geometry, relative
        self.policy = policy
        self.scales = [a.scale.counts for a in axes] if policy is None else policy.scales
        self.run: PathRun | None = None

    @property
    def live(self) -> bool:
        return self.policy is None

    @property
    def may_join(self) -> bool:
        """True if the path may continue into the next one without a stop."""
        return self.policy is not None or self.axes[0].contour_mode

    def joins(self, own: PathSegment, following: PathMove, its: PathSegment) -> bool:
        """True if the path continues into the next one without a stop; both are laid out."""
        if not its.length or self.scales != following.scales:
            return False
        if self.policy is None or following.policy is None:
            return self.policy is following.policy and corner(own, its) <= self.axes[0].contour_angle
        return self.policy.joins(own, following.policy, its)

    def lay(self, starts: Sequence[float]) -> PathSegment:
        """Lay out the path from `starts`, the positions of its axes."""
        geometry = self.geometry.moved(starts) if self.relative else self.geometry
        return geometry.lay(starts, self.scales)

    def pace(self, segment: PathSegment) -> PathPace:
        """Return speed and rates along the path in user units.

        They are those of the master, within the limits of each axis.
        """
        if self.policy is not None:
            return self.policy.pace()
        master, move = self.axes[0], self.moves[0]
        speed, accel, decel = checked_speed_and_rates(master, move)
        k = abs(self.scales[0])
        most = self._limits(segment)
        jerks = master.jerks(speed, accel, decel)
        factor = master.override if move.overridden else 1.0
        return planners.PathPace(
            master.shape,
            min(speed * factor / k, most[0]),
            min(accel / k, most[1]),
            min(decel / k, most[2]),
            master.ramp,
            jerks[0] / k,
            jerks[1] / k,
        )

    def max_decel(self, segment: PathSegment) -> float:
        """Return the highest deceleration along the path within the limits of its axes."""
        return INFINITY if self.policy is not None else self._limits(segment)[2]

    def _limits(self, segment: PathSegment) -> tuple[float, float, float]:
        axes = self.axes
        if not any(a.limited for a in axes):
            return INFINITY, INFINITY, INFINITY
        speeds, accels = [a.max_speed for a in axes], [a.max_accel for a in axes]
        return limits(segment, speeds, accels, [a.max_decel for a in axes])

    # -- as an entry of the buffer

    def release(self, move: LoggedMove) -> None:
        if move is self.moves[0]:
            for each in self.moves:
                each.released = True

    def keep_end(self, a: Axis, move: LoggedMove, shift: float) -> bool:
        """True for a line, which keeps its end; an arc keeps its shape and is displaced."""
        if not isinstance(self.geometry, StraightLine) or move.base is None:
            return False
        move.base += shift
        targets = zip(self.axes, self.geometry.targets, strict=True)
        self.geometry = StraightLine([target - shift if each is a else target for each, target in targets])
        return True

    def purge(self, a: Axis) -> list[LoggedMove]:
        """Remove the path from the buffers of its other axes once one has discarded it."""
        dropped = []
        for other, move in zip(self.axes, self.moves, strict=True):
            if move in other.buffer:
                other.buffer.remove(move)
                dropped.append(move)
        return dropped

    def is_next_at(self, index: int) -> bool:
        """True if it is released and has `index` in every buffer, not counting outputs."""
        return all(
            move.released and buffer.motion_at(a, index) is move
            for a, move in zip(self.axes, self.moves, strict=True)
        )

    def ready(self, a: Axis, move: LoggedMove) -> bool:
        return all(each.move is None for each in self.axes) and self.is_next_at(0)

    def begin(self, a: Axis, move: LoggedMove) -> None:
        """Take the entry out of every axis's buffer and run the path."""
        for other, each in zip(self.axes, self.moves, strict=True):
            if other is not a:
                buffer.reach(other, each)
        controller.PathRun(self, [each.target for each in self.axes]).start()

    # -- in motion

    def entries(self, a: Axis, move: LoggedMove) -> tuple[LoggedMove, ...]:
        return (move,) if self.run is None else self.run.entries(a)

    def replan(self, a: Axis) -> None:
        if self.run is not None and (a is self.axes[0] or a.limited):
            self.run.replan()

    def more(self, a: Axis) -> None:
        if self.run is not None:
            self.run.more()

    def stops_itself(self, ended: str, hard: bool) -> bool:
        return self.run is not None

    def stop(self, a: Axis, ended: str, hard: bool) -> None:
        assert self.run is not None
        self.run.stop(a, ended, hard)

    def is_stopping(self, hard: bool) -> bool:
        return self.run is not None and self.run.ended != "" and (self.run.hard or not hard)

    def together_with(self, a: Axis) -> tuple[Axis, ...]:
        return self.axes

    def suspend(self, a: Axis) -> bool:
        if self.run is not None:
            self.run.suspend()
        return True

    def resume(self, a: Axis) -> None:
        if self.run is not None:
            self.run.resume()

    def leave(self, a: Axis, ended: str) -> None:
        """Abandon the path on all axes; a new target for one of them is rejected."""
        if self.run is None:
            return
        if ended == "retarget":
            raise Rejected(
                "moving",
                f"axis {a.index} is on a path with other axes",
                "wait until the path has ended, or stop it",
            )
        self.run.abandon(a, ended)

    def shift(self, a: Axis, shift: float) -> None:
        """Shift the positions of a path with a policy for a new zero of the axis.

        Raises Rejected on other paths.
        """
        if self.policy is not None and self.run is not None:
            self.run.shift(a, shift)
            return
        raise Rejected(
            "moving",
            f"axis {a.index} is on a path: its position cannot be set",
            "wait until the path has ended",
        )

    def plan(self, a: Axis) -> Profile:
        raise AssertionError("a path is planned by its run")


def load_line(axes: Sequence[Axis], targets: Sequence[float], command: str = "", line: int = 0) -> None:
    """Load a straight line of several axes to `targets`; the first axis is the master."""
    _permit(axes)
    _put(axes, StraightLine(list(targets)), list(targets), command, line)


def load_line_by(axes: Sequence[Axis], distances: Sequence[float], command: str = "", line: int = 0) -> None:
    """Load a straight line by `distances` from the ends of the moves before it."""
    _permit(axes)
    starts = _starts(axes)
    targets = [start + distance for start, distance in zip(starts, distances, strict=True)]
    _put(axes, StraightLine(list(distances)), targets, command, line, starts)


def load_arc(
    axes: Sequence[Axis],
    centre: Sequence[float],
    angle: float,
    rest: Sequence[float] = (),
    relative: bool = False,
    command: str = "",
    line: int = 0,
) -> None:
    """Load an arc by `angle` degrees, or a helix if further axes move to `rest`.

    If it is `relative`, centre and rest count from its start.
    """
    _permit(axes)
    starts = _starts(axes)
    if not all(abs(value) < 1e300 for value in (*centre, angle, *rest)):
        raise Rejected("range", "the centre and the angle of an arc must be finite numbers")
    geometry = Arc((centre[0], centre[1]), angle, list(rest))
    laid = geometry.moved(starts) if relative else geometry
    ends = laid.ends(starts, [a.scale.counts for a in axes])
    _put(axes, geometry, ends, command, line, starts if relative else None)


def load_guided(
    axes: Sequence[Axis],
    geometry: StraightLine | Arc,
    policy: PathPolicy,
    command: str = "",
    line: int = 0,
) -> None:
    """Load a path whose speed, rates and joins are set by its policy; geometry in counts."""
    for a in axes:
        permit_motion(a)
    ends = geometry.ends(_starts(axes), policy.scales)
    _put(axes, geometry, ends, command, line, policy=policy)


def _permit(axes: Sequence[Axis]) -> None:
    if len(set(axes)) != len(axes) or len(axes) < 2:
        raise Rejected("axis", "a path needs two or more different axes", "use MOVEA or MOVER for one axis")
    for a in axes:
        permit_motion(a)


def _starts(members: Sequence[Axis]) -> list[float]:
    """Return the positions of the axes when the path begins."""
    return [buffer.known_end(a, "a path cannot start from there") for a in members]


def _put(
    members: Sequence[Axis],
    geometry: StraightLine | Arc,
    targets: Sequence[float],
    command: str,
    line: int,
    bases: Sequence[float] | None = None,
    policy: PathPolicy | None = None,
) -> None:
    """Load a path into the buffers of its axes.

    `targets` are its ends. Those of a relative path count from `bases`, the ends of the entries before.
    """
    for a, target in zip(members, targets, strict=True):
        if len(a.buffer) >= a.buffer_size:
            raise Rejected("buffer-full", f"the move buffer of axis {a.index} is full")
        if not abs(target) < 1e300:
            raise Rejected("range", f"axis {a.index} cannot move to {target:.10g}")
    moves = [LoggedMove(a.index, command, line, target) for a, target in zip(members, targets, strict=True)]
    action = PathMove(members, moves, geometry, bases is not None, policy)
    for k, (a, move) in enumerate(zip(members, moves, strict=True)):
        move.action = action
        move.base = None if bases is None else bases[k]
        a.buffer.append(buffer.stamped(a, move))


def run_of(a: Axis) -> PathRun | None:
    """Return the run of paths that an axis is on."""
    action = a.move.action if a.move is not None else None
    return action.run if isinstance(action, PathMove) else None
