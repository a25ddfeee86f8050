"""What was ordered while an axis moved: the settings in force for each profile of its track, and steps on purpose.

A run that is to be proved keeps these records; others pay nothing for them. They hold what the program has asked for,
never what a planner made of it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from motionlang.controller.motion.halt import Stopping
from motionlang.controller.motion.jog import Jog
from motionlang.controller.moves.path import PathMove

if TYPE_CHECKING:
    from motionlang.controller.axis import Axis
    from motionlang.controller.controller import Controller
    from motionlang.controller.move import Move
    from motionlang.profile import Profile

INFINITY = float("inf")


class Order(NamedTuple):
    """What holds for one profile: its kind, the line it comes from, and its bounds in counts and seconds.

    `kind` is "rest", "move", "jog", "stop", "path", or the name of the action that makes the profile; of the last the
    bounds are infinite. `members` are the axes of a path, its master first, `most` their limits of speed,
    `angle` is up to which corners are run through. `jerk` is infinite but for S-ramps.
    """

    kind: str
    line: int
    speed: float = INFINITY
    accel: float = INFINITY
    decel: float = INFINITY
    jerk: float = INFINITY
    members: tuple[int, ...] = ()
    most: tuple[float, ...] = ()
    angle: float = 0.0


REST = Order("rest", 0)
# The corner, degrees, that is none: guided paths join where they go on in the same direction.
STRAIGHT = 1e-4


class Orders:
    """The records of a controller: `of` by axis, as many as its track has profiles, and `data` likewise.

    A datum is how far the zero of the axis has been moved. `stands` has the axes and times at which an axis was told
    to stand at once, with the word for it.
    """

    def __init__(self, controller: Controller) -> None:
        axes = controller.axes
        self.of: dict[int, list[Order]] = {number: [REST] * len(a.profiles) for number, a in axes.items()}
        self.data: dict[int, list[float]] = {
            number: [a.datum] * len(a.profiles) for number, a in axes.items()
        }
        self.stands: dict[tuple[int, float], str] = {}
        self._controller = controller
        self._extend, self._freeze = controller.extend_track, controller.freeze
        controller.extend_track = self._extended  # type: ignore[method-assign]
        controller.freeze = self._frozen  # type: ignore[method-assign]

    def _extended(self, a: Axis, profile: Profile) -> None:
        if self._controller.axes.get(a.index) is a:
            self.of[a.index].append(_order(a))
            self.data[a.index].append(a.datum)
        self._extend(a, profile)

    def _frozen(self, a: Axis, ended: str) -> None:
        self.stands[a.index, self._controller.clock.now] = ended
        self._freeze(a, ended)


def _order(a: Axis) -> Order:
    move = a.move
    if move is None:
        return REST
    action = move.action
    if action is not None and not isinstance(action, (Stopping, Jog, PathMove)):
        return Order(type(action).__name__, move.line)
    if isinstance(action, PathMove):
        master, leader = action.axes[0], action.moves[0]
        members = tuple(each.index for each in action.axes)
        most = tuple(each.max_speed for each in action.axes)
        if action.guide is not None:
            return Order("path", move.line, *_guided(action), members, most, STRAIGHT)
        return Order("path", move.line, *_bounds(master, leader), members, most, master.contour_angle)
    kind = "move" if action is None else "jog" if isinstance(action, Jog) else "stop"
    speed, accel, decel, jerk = _bounds(a, move)
    if isinstance(action, Jog):
        speed = abs(action.velocity)
    elif isinstance(action, Stopping):
        speed = INFINITY
    elif a.suspended:
        kind = "stop"
    speed = min(speed, a.max_speed) if kind != "stop" else INFINITY
    return Order(kind, move.line, speed, accel, decel, jerk)


def _guided(path: PathMove) -> tuple[float, float, float, float]:
    """The same of a path that goes by its guide; the speeds are those in space, whatever its length counts as."""
    assert path.guide is not None
    pace = path.guide.pace()
    k = abs(path.axes[0].scale.counts) * (path.run.segment.stretch if path.run is not None else 1.0)
    return pace.speed * k, pace.accel * k, pace.decel * k, INFINITY


def _bounds(a: Axis, move: Move) -> tuple[float, float, float, float]:
    """Speed, rates and jerk of a move: its own where it has some, those of the axis otherwise, within its limits."""
    speed = a.speed if move.speed is None else move.speed
    accel, decel = a.rates(speed)
    if move.rates is not None:
        accel, decel = move.rates[0] or accel, move.rates[1] or decel
    if move.overridden:
        speed *= a.override
    accel, decel = min(accel, a.max_accel), min(decel, a.max_decel)
    if move.ended == "fault" or (isinstance(move.action, Stopping) and move.action.hard):
        decel = max(decel, a.error_decel)
    jerk = max(a.accel_jerk, a.decel_jerk) if a.shape == "scurve" else INFINITY
    return speed, accel, decel, jerk
