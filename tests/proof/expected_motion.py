"""The orders of an axis: the settings in force for each profile, commanded steps.

Only a run that is to be proved stores these records; other runs have no cost. They contain the commands of
the program, never a planner's result.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from operator import itemgetter
from typing import Any

from motionlang.kernel import INFINITY, Axis, Controller, Run
from motionlang.kernel.controller import (
    CurveFollow,
    Gear,
    Jog,
    MotionListener,
    PathMove,
    PathRun,
    Playback,
    Stopping,
    StraightLine,
)
from motionlang.kernel.log import LoggedMove
from tests.proof.order import ENDLESS, Order, PathOrder, Tie

REST = Order("rest", 0)
# Kinds whose rest continues unchanged at a new zero, because they do not depend on positions.
SHIFTED = frozenset(("move", "jog", "stop", "Gear"))
# Profiles of a run that are recorded for its proof; so many equal orders, as in a loop, count as one.
MAX_PROFILES, MANY_EQUAL = 200_000, 50
# The corner, degrees, that counts as straight: guided paths join if they continue in the same direction, to a
# thousandth per axis.
STRAIGHT = 0.1
_TIME = itemgetter(0)


class ExpectedMotion(MotionListener):
    """The records of a controller: `of` and `data` by axis, one per profile.

    A datum is the distance by which the zero of the axis has been moved. Equal orders are one object. Beyond
    `MAX_PROFILES` profiles it `is_full`, and stores nothing more.

    - `standstills` has the axes and times at which an axis was commanded to stop at once, with the keyword.
    - `unheeded` has, by axis and time, the effect of settings that have not replaced a profile.
    - `late` has, by axis and time, an order whose rates came too late: the profile keeps those in force.
    - `offsets` has, by axis and time, the line and the distance of an OFFSET.
    - `begun` has, by axis, the start times of motions with a log entry of their own.
    - `stops` has, by axis, when its motion was commanded to come to rest or to halt, with the keyword.
    - `refused` has, by axis, the time at which a buffered move or a homing was last rejected as it began.
    """

    def __init__(self, controller: Controller) -> None:
        self.is_full = self.was_cut = False
        self._count = 0
        axes = controller.axes
        self.of: dict[int, list[Order]] = {number: [REST] * len(a.profiles) for number, a in axes.items()}
        self.data: dict[int, list[float]] = {
            number: [a.datum] * len(a.profiles) for number, a in axes.items()
        }
        self.standstills: dict[tuple[int, float], str] = {}
        self.unheeded: dict[tuple[int, float], Order] = {}
        self.late: dict[tuple[int, float], Order] = {}
        self._scales: dict[int, list[tuple[float, float, float]]] = {number: [] for number in axes}
        self.offsets: dict[tuple[int, float], tuple[int, float]] = {}
        self.begun: dict[int, set[float]] = {number: set() for number in axes}
        self.stops: dict[int, list[tuple[float, str]]] = {number: [] for number in axes}
        self.refused: dict[int, float] = {}
        # When each axis was first stopped with each keyword.
        self._first_stops: dict[tuple[int, str], float] = {}
        # The number of each path: several may begin at one time.
        self._nth: dict[PathMove, int] = {}
        # The angle up to which each path may be entered, by the settings when another one was planned into
        # it.
        self._angles: dict[PathMove, float] = {}
        # The order of the last plan of each path, in progress or ahead: settings that led to no other plan do
        # not act.
        self._plans: dict[PathMove, Order] = {}
        # When the log entry of a path began, and its number in the log: a long one continues as another
        # entry.
        self._entries: dict[LoggedMove, tuple[float, int]] = {}
        # The rest of a stepper's move at a new zero is not planned again: the bounds at its start still
        # apply.
        self._steps: dict[LoggedMove, Order] = {}
        # The settings that `heed` last recorded for each axis, and the number of its profiles then.
        self._last_settings: dict[int, tuple[int, tuple[object, ...]]] = {}
        # The last stop commanded for each axis: it continues as planned, whatever settings follow.
        self._halts: dict[int, tuple[Stopping, Order]] = {}
        self._known = {REST: REST}  # those that further profiles may refer to
        self._controller = controller

    @classmethod
    def of_run(cls, run: Run) -> ExpectedMotion:
        """Return the expected motion that a run has recorded; ValueError if there is none."""
        listener = run.controller.motion_listener
        found = listener.expected if isinstance(listener, _Full) else listener
        if not isinstance(found, cls):
            raise ValueError("no motion is expected of the run")
        return found

    def add(self, a: Axis) -> None:
        """Record the order of the newest profile of an axis's track."""
        if self._controller.axes.get(a.index) is a:
            move = a.move
            path = move is not None and isinstance(move.action, PathMove)
            order = self._path(a) if path else _order(a)
            if move is not None and order.kind == "step":
                order = self._steps.setdefault(move, order)
            elif move is not None and isinstance(move.action, Stopping):
                halt = self._halts.get(a.index)
                if halt is not None and halt[0] is move.action:
                    order = halt[1]
                elif a.datum != self.data[a.index][-1]:
                    order = self.of[a.index][-1]  # a table that comes to rest on itself, at a new zero
                self._halts[a.index] = move.action, order
            elif order.kind in SHIFTED and a.datum != self.data[a.index][-1]:
                # The same motion at a new zero: settings that were written since do not act.
                order = self.of[a.index][-1]
            elif move is not None and move.action is None and order.rates != move.rates_in_force:
                assert move.rates_in_force is not None
                self.late[a.index, self._controller.clock.now] = order
                order = order._replace(rates=move.rates_in_force)
            self._append(a, order)
            if order.path is not None and order.path.members[0] == a.index:
                self.heed(a)  # a path that was planned ahead keeps settings written since
            if move is not None and not self.is_full:
                self.begun[a.index].add(move.start_time)

    def _append(self, a: Axis, order: Order) -> None:
        """Append an order, sharing equal ones; if full, stop recording."""
        now, scales = self._controller.clock.now, self._scales[a.index]
        self.unheeded.pop((a.index, now), None)
        if not scales or scales[-1][1:] != (a.scale.counts, a.scale.zero):
            scales.append((now, a.scale.counts, a.scale.zero))
        if order.path is None and order.tie is None and order.points is None:
            known = self._known.get(order)
            self._count += MANY_EQUAL if known is None else 1
            order = self._known.setdefault(order, order)
        else:
            self._count += MANY_EQUAL
        if self._count <= MANY_EQUAL * MAX_PROFILES:
            count = len(a.starts)  # a rest before it is no longer on the track
            del self.of[a.index][count:], self.data[a.index][count:]
            self.of[a.index].append(order)
            self.data[a.index].append(a.datum)
            return
        self.is_full, self._controller.motion_listener = True, _Full(self)
        for each in (
            self.of,
            self.data,
            self.standstills,
            self._nth,
            self._angles,
            self._plans,
            self._entries,
            self._steps,
            self._halts,
            self._last_settings,
        ):
            each.clear()
        for more in (
            self.unheeded,
            self.late,
            self.offsets,
            self.begun,
            self.stops,
            self._first_stops,
            self.refused,
            self._scales,
        ):
            more.clear()
        self._known.clear()

    def finish_updates(self) -> None:
        """Drop orders whose profiles were prevented by an interrupt.

        A profile on the track without an order is not checked.
        """
        self.was_cut = True
        for number, a in self._controller.axes.items():
            count = min(len(a.starts), len(self.of[number]), len(self.data[number]))
            del self.of[number][count:]
            del self.data[number][count:]

    def _path(self, a: Axis) -> Order:
        """Return the order of a path; all paths are numbered."""
        move = a.move
        assert move is not None
        action = move.action
        assert isinstance(action, PathMove)
        if action not in self._nth:
            self._nth[action] = len(self._nth)
        order = self._planned(action, move, self._entry(move))
        assert order.path is not None
        for each in _paths_ahead(action):
            self._angles.setdefault(each, _angle_through(each))
        return order._replace(path=order.path._replace(angle_into=self._angles.get(action, 0.0)))

    def _entry(self, move: LoggedMove) -> int:
        """Return the log number of a path's entry; for a long path, of the last entry."""
        began, entry = self._entries.get(move, (-1.0, -1))
        if began != move.start_time:
            moves = self._controller.log.moves
            entry = len(moves) - 1 - next(k for k, each in enumerate(reversed(moves)) if each is move)
            self._entries[move] = move.start_time, entry
        return entry

    def _planned(self, action: PathMove, move: LoggedMove, entry: int) -> Order:
        """Return the order of the newest path, with the settings of its last plan.

        It may have been planned together with an earlier path.
        """
        order, run = _path(action, move, self._nth[action], entry), action.run
        assert order.path is not None
        planned = self._plans.get(action)
        if run is None or planned is None or self._is_planned_now(action):
            self._plans[action] = order
            for each in _paths_ahead(action):
                self._plans[each] = _path(each, each.moves[0], 0, -1, run)
            return order
        assert planned.path is not None
        path = order.path._replace(most_accel=planned.path.most_accel, most_decel=planned.path.most_decel)
        order = order._replace(rates=planned.rates, jerks=planned.jerks, path=path)
        return order._replace(shape=planned.shape, ramp=planned.ramp)

    def _is_planned_now(self, action: PathMove) -> bool:
        course = None if action.run is None else action.run.course
        return (
            course is not None and course.here is action and course.planned_at == self._controller.clock.now
        )

    def scale(self, axis: int, time: float) -> set[tuple[float, float]]:
        """Return counts per unit and zero of an axis at a time.

        There are several pairs if they changed at that time.
        """
        scales = self._scales[axis]
        last = bisect_right(scales, time, key=_TIME)
        first = bisect_left(scales, time, key=_TIME)
        return {(counts, zero) for _, counts, zero in scales[max(0, min(first, last - 1)) : last]}

    def stopped(self, axis: int, first: float, last: float) -> list[tuple[float, str]]:
        """Return the stops of an axis between two times, with the keyword of each."""
        stops = self.stops[axis]
        return stops[bisect_left(stops, first, key=_TIME) : bisect_right(stops, last, key=_TIME)]

    def was_stopped(self, axis: int, word: str, time: float) -> bool:
        """True if an axis was stopped at or before a time by a keyword."""
        return self._first_stops.get((axis, word), INFINITY) <= time

    def heed(self, a: Axis) -> None:
        """Record a setting that acts at once although the motion continues as planned."""
        move = a.move
        if move is None:
            return
        action = move.action
        if isinstance(action, PathMove):
            a = action.axes[0]
            began = self._entries.get(action.moves[0])
            leader = action.moves[0]
            if action.policy is not None or began is None:
                return
            wanted = _path(action, leader, self._nth[action], began[1])
            move = leader
        elif isinstance(action, Stopping) or self.of[a.index][-1].kind == "step":
            return
        else:
            wanted = _order(a)
        if move.speed is not None:  # a move that was loaded with its speed keeps its rates, too
            wanted = wanted._replace(rates=self.of[a.index][-1].rates)
        settings = len(self.of[a.index]), wanted.settings
        if self._last_settings.get(a.index) == settings:
            return
        self._last_settings[a.index] = settings
        key = a.index, self._controller.clock.now
        if wanted.settings == self.of[a.index][-1].settings:
            self.unheeded.pop(key, None)
        else:
            self.unheeded[key] = wanted

    def jogs(self, a: Axis, velocity: float) -> None:
        """Record the commanded velocity of a jog if the axis has not adopted it."""
        move = a.move
        if move is None or a.suspended or not isinstance(move.action, Jog):
            return
        goal, last = max(-a.max_speed, min(velocity, a.max_speed)), self.of[a.index][-1]
        if last.kind == "jog" and last.goal != goal:
            key = a.index, self._controller.clock.now
            self.unheeded[key] = last._replace(speed=abs(goal), goal=goal)

    def refuse(self, a: Axis) -> None:
        """Record that a buffered move, or a step of a homing, is rejected as it begins."""
        self.refused[a.index] = self._controller.clock.now

    def gears(self, a: Axis, ratio: float) -> None:
        """Record a commanded ratio if the axis follows with a different one."""
        key, last = (a.index, self._controller.clock.now), self.of[a.index][-1]
        if last.tie is None or last.tie.curve is not None or a.suspended:
            return
        if last.tie.ratio == ratio:
            self.unheeded.pop(key, None)
        else:
            self.unheeded[key] = last._replace(tie=last.tie._replace(ratio=ratio))

    def offset(self, a: Axis, distance: float, line: int) -> None:
        """Record the start of an offset, to which the rest of the previous one is added."""
        self.offsets[a.index, self._controller.clock.now] = line, distance

    def stop(self, a: Axis, ended: str) -> None:
        """Record a decelerated stop of an axis and of the axes that move together with it."""
        if a.move is not None:
            action = a.move.action
            for each in (a,) if action is None else action.together_with(a):
                self._stop(each, ended)

    def freeze(self, a: Axis, ended: str) -> None:
        """Record an immediate stop of an axis."""
        self.standstills[a.index, self._controller.clock.now] = ended
        if a.move is not None:
            self._stop(a, ended)

    def _stop(self, a: Axis, ended: str) -> None:
        now = self._controller.clock.now
        self.stops[a.index].append((now, ended))
        self._first_stops.setdefault((a.index, ended), now)


class _Full(MotionListener):
    """What listens in place of an expected motion that is full."""

    def __init__(self, expected: ExpectedMotion) -> None:
        self.expected = expected


def _paths_ahead(action: PathMove) -> list[PathMove]:
    """Return the paths that a path continues into."""
    course = None if action.run is None else action.run.course
    return [each for each, _ in course.ahead] if course is not None and course.here is action else []


def _angle_through(action: PathMove) -> float:
    """Return the largest angle at which a path may now be entered without a stop."""
    master = action.axes[0]
    if action.policy is not None:
        return STRAIGHT
    return master.contour_angle if master.contour_mode else 0.0


def _order(a: Axis) -> Order:
    move = a.move
    if move is None:
        return REST
    action = move.action
    # A cam or a shear cannot be suspended: an input that holds its axis acts when it is over.
    if isinstance(action, CurveFollow) or (isinstance(action, Gear) and not a.suspended):
        return Order(type(action).__name__, move.line, rates=_rates(a, move), tie=_tie(action))
    if isinstance(action, Gear):
        return _stopped(a, move)
    if isinstance(action, Playback) and action.step:
        return Order("step", move.line, *_bounds(a, move), a.shape, step=action.step)
    if isinstance(action, Playback):
        return Order("Playback", move.line, points=action.ordered)
    if action is not None and not isinstance(action, (Stopping, Jog)):
        return Order(type(action).__name__, move.line)
    speed, rates, jerks = _bounds(a, move)
    if isinstance(action, Stopping) or a.suspended:
        return _stopped(a, move)
    if isinstance(action, Jog):
        goal = max(-a.max_speed, min(action.velocity, a.max_speed))
        return Order("jog", move.line, abs(goal), rates, jerks, a.shape, goal, a.ramp)
    if not speed:
        return _stopped(a, move)
    return Order("move", move.line, min(speed, a.max_speed), rates, jerks, a.shape, ramp=a.ramp)


def _stopped(a: Axis, move: LoggedMove) -> Order:
    return Order("stop", move.line, INFINITY, *_bounds(a, move)[1:], a.shape, ramp=a.ramp)


def _tie(action: Gear | CurveFollow) -> Tie:
    if isinstance(action, Gear):
        return Tie(action.master, action.ratio, action.locked, ramp=action.ramp)
    origin, direction, table = action.origin, action.direction, action.ordered
    if table is not None and table[2] == "even":  # the master's distance has the sign that was commanded
        over = table[0][-1]
        direction, table = (1 if over > 0.0 else -1), ((0.0, abs(over)), *table[1:])
    return Tie(action.master, 0.0, INFINITY, action.curve, origin, direction, table)


def _rates(a: Axis, move: LoggedMove) -> tuple[float, float]:
    """Return the rates of a move: its own or, if it has none, those of the axis."""
    accel, decel = a.rates(a.speed if move.speed is None else move.speed)
    if move.rates is not None:
        accel, decel = move.rates[0] or accel, move.rates[1] or decel
    return accel, decel


def _bounds(a: Axis, move: LoggedMove) -> tuple[float, tuple[float, float], tuple[float, float]]:
    """Return speed, rates and jerks of a move, within the limits of its axis.

    They are those of the move itself or, if it has none, of the axis.
    """
    accel, decel = _rates(a, move)
    accel, decel = min(accel, a.max_accel), min(decel, a.max_decel)
    if isinstance(move.action, Stopping) and move.action.rate:
        decel = move.action.rate
    elif isinstance(move.action, Stopping) and move.action.hard:
        decel = a.error_decel if move.ended == "fault" else min(a.error_decel, a.max_decel)
    return _speed(a, move), (accel, decel), _jerks(a, move)


def _own_speed(a: Axis, move: LoggedMove) -> float:
    return a.speed if move.speed is None else move.speed


def _speed(a: Axis, move: LoggedMove) -> float:
    speed = _own_speed(a, move)
    return speed * a.override if move.overridden else speed


def _jerks(a: Axis, move: LoggedMove) -> tuple[float, float]:
    return a.jerks(_own_speed(a, move), *_rates(a, move)) if a.shape == "scurve" else ENDLESS


def _path(action: PathMove, move: LoggedMove, nth: int, entry: int, run: PathRun | None = None) -> Order:
    """Return the order of a path by the present settings.

    A path that has not begun gets the `run` to which it belongs.
    """
    run = run or action.run
    master, leader, axes, policy = action.axes[0], action.moves[0], action.axes, action.policy
    shape, k, ramp = master.shape, abs(action.scales[0]), master.ramp
    if policy is None:
        speed, rates, jerks = _speed(master, leader), _rates(master, leader), _jerks(master, leader)
    else:
        pace = policy.pace()
        shape, k, ramp = pace.shape, 1.0, pace.ramp
        speed, rates, jerks = pace.speed, (pace.accel, pace.decel), ENDLESS
    most_decel = tuple(each.max_decel for each in axes)
    if policy is None and run is not None and run.ended and run.hard:
        rates = rates[0], master.error_decel
        most_decel = (INFINITY,) * len(axes) if run.ended == "fault" else most_decel
    comes_to_rest = any(each.suspended for each in axes) or (run is not None and run.ended != "")
    geometry = action.geometry
    straight = isinstance(geometry, StraightLine)
    path = PathOrder(
        tuple(each.index for each in axes),
        tuple(action.scales),
        move.start_time,
        nth,
        action.relative,
        **_geometry_fields(action),
        angle=0.0 if straight else geometry.angle,  # type: ignore[union-attr]
        plane=(0, 1) if straight else geometry.plane,  # type: ignore[union-attr]
        length=geometry.length,
        most=tuple(each.max_speed for each in axes),
        most_accel=tuple(each.max_accel for each in axes),
        most_decel=most_decel,
        angle_into=0.0,
        comes_to_rest=comes_to_rest,
        leads_on=comes_to_rest and bool(_paths_ahead(action)),
        entry=entry,
    )
    bounds = speed / k, (rates[0] / k, rates[1] / k), (jerks[0] / k, jerks[1] / k)
    return Order("path", move.line, *bounds, shape, path=path, ramp=ramp)


def _geometry_fields(action: PathMove) -> dict[str, Any]:
    """Return the fields of a `PathOrder` that depend on the zeros of the axes.

    A relative path has none.
    """
    geometry = action.geometry
    if isinstance(geometry, StraightLine):
        return {"line": tuple(geometry.targets), "centre": (0.0, 0.0), "rest": ()}
    return {"line": (), "centre": tuple(geometry.centre), "rest": tuple(geometry.rest)}
