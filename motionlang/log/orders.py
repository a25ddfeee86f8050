"""What was ordered while an axis moved: the settings in force for each profile of its track, and steps on purpose.

A run that is to be proved keeps these records; others pay nothing for them. They hold what the program has asked for,
never what a planner made of it.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from copy import copy
from operator import itemgetter
from typing import TYPE_CHECKING

from motionlang.controller.motion.follow import Gear
from motionlang.controller.motion.halt import Stopping
from motionlang.controller.motion.jog import Jog
from motionlang.controller.motion.profile_playback import Played
from motionlang.controller.motion.reference import PositionReference, SpeedReference
from motionlang.controller.moves.cam import CurveFollow
from motionlang.controller.moves.geometry import Line
from motionlang.controller.moves.path import PathMove
from motionlang.log.order import ENDLESS, INFINITY, Order, PathOrder, Tie
from motionlang.log.track import WholeTrack

if TYPE_CHECKING:
    from typing import Any

    from motionlang.controller.axis import Axis
    from motionlang.controller.controller import Controller
    from motionlang.controller.move import Move
    from motionlang.controller.moves.path_run import PathRun

REST = Order("rest", 0)
# Kinds of which what is left goes on unchanged at a new zero, as they say nothing of places.
SHIFTED = frozenset(("move", "jog", "stop", "Gear"))
# Profiles of a run that are kept to be proved; so many that are ordered alike, as in a loop, count as one.
MOST, MANY_ALIKE = 200_000, 50
# The corner, degrees, that is none: guided paths join where they go on in the same direction, to a thousandth an axis.
STRAIGHT = 0.1
_TIME = itemgetter(0)


class Orders:
    """The records of a controller: `of` by axis, as many as its track has profiles, and `data` likewise.

    A datum is how far the zero of the axis has been moved. `stands` has the axes and times at which an axis was told
    to stand at once, with the word for it. Orders that are alike are one. Beyond `MOST` profiles it `is_full`, and
    holds nothing more. `unheeded` has, by axis and time, what settings ask of a profile that they have not replaced.
    `offsets` has, by axis and time, the line and the distance of an OFFSET.
    `begun` has, by axis, when its motions began that have an entry of their own.
    `stops` has, by axis, the times at which its motion was told to come to rest or to stand, with the word for it.
    `refused` has, by axis, when an entry of its buffer was last refused as it was to begin.
    """

    def __init__(self, controller: Controller) -> None:
        self.is_full = self.was_cut = False
        self._count = 0
        axes = controller.axes
        self.of: dict[int, list[Order]] = {number: [REST] * len(a.profiles) for number, a in axes.items()}
        self.data: dict[int, list[float]] = {
            number: [a.datum] * len(a.profiles) for number, a in axes.items()
        }
        self.stands: dict[tuple[int, float], str] = {}
        self.unheeded: dict[tuple[int, float], Order] = {}
        self._scales: dict[int, list[tuple[float, float, float]]] = {number: [] for number in axes}
        self.offsets: dict[tuple[int, float], tuple[int, float]] = {}
        self.begun: dict[int, set[float]] = {number: set() for number in axes}
        self.stops: dict[int, list[tuple[float, str]]] = {number: [] for number in axes}
        self.prompts: dict[int, list[tuple[float, str]]] = {number: [] for number in axes}
        self.refused: dict[int, float] = {}
        # When each axis was first stopped with each word.
        self._first_stops: dict[tuple[int, str], float] = {}
        # The number of each path among those that its master began at one moment.
        self._nth: dict[PathMove, int] = {}
        # The angle up to which each path may be entered, by the settings when another one was planned into it.
        self._angles: dict[PathMove, float] = {}
        # What each path, under way or ahead, was last planned by: settings that led to no other plan do not act.
        self._plans: dict[PathMove, Order] = {}
        # The paths that each axis is the master of, as far as they are under way, and what was last ordered for them.
        self._under_way: dict[int, dict[PathMove, Order]] = {}
        self._counts: dict[tuple[int, float], int] = {}
        # When the log entry of a path began, and its number in the log: a long one goes on as another entry.
        self._entries: dict[Move, tuple[float, int]] = {}
        # What is left of a stepper's move at a new zero is not planned anew: what held when it began still does.
        self._steps: dict[Move, Order] = {}
        # The stop that each axis was last told to make: it goes on as it was planned, whatever settings come since.
        self._halts: dict[int, tuple[Stopping, Order]] = {}
        self._known = {REST: REST}  # those that further profiles may be ordered by
        self._controller = controller
        controller.orders = self

    def add(self, a: Axis) -> None:
        """The track of an axis gets another profile."""
        if self._controller.axes.get(a.index) is a:
            move = a.move
            path = move is not None and isinstance(move.action, PathMove)
            order = self._path(a) if path else _order(a)
            if move is not None and order.kind == "step":
                order = self._steps.setdefault(move, order)
            elif move is not None and isinstance(move.action, Stopping):
                halt = self._halts.get(a.index)
                order = halt[1] if halt is not None and halt[0] is move.action else order
                self._halts[a.index] = move.action, order
            elif order.kind in SHIFTED and a.datum != self.data[a.index][-1]:
                # The same motion at a new zero: settings that came since do not act.
                order = self.of[a.index][-1]
            self._append(a, order)
            if order.path is not None and order.path.members[0] == a.index:
                self.heed(a)  # a path that was planned ahead keeps settings that have come since
            if move is not None and not self.is_full:
                self.begun[a.index].add(move.start_time)

    def add_plain(self, a: Axis, line: int, speed: float) -> None:
        """An axis begins a move from rest to rest at a speed."""
        self._append(a, Order("move", line, speed, a.rates(speed), ENDLESS, a.shape, ramp=a.ramp))
        if not self.is_full:
            self.begun[a.index].add(self._controller.clock.now)

    def _append(self, a: Axis, order: Order) -> None:
        """One that is like another is that one; where there is no room the run goes on as one without a proof."""
        now, scales = self._controller.clock.now, self._scales[a.index]
        self.unheeded.pop((a.index, now), None)
        if not scales or scales[-1][1:] != (a.scale.counts, a.scale.zero):
            scales.append((now, a.scale.counts, a.scale.zero))
        if order.path is None and order.tie is None and order.points is None:
            known = self._known.get(order)
            self._count += MANY_ALIKE if known is None else 1
            order = self._known.setdefault(order, order)
        else:
            self._count += MANY_ALIKE
        if self._count <= MANY_ALIKE * MOST:
            self.of[a.index].append(order)
            self.data[a.index].append(a.datum)
            return
        self.is_full, self._controller.orders = True, None
        for kept in (
            self.of,
            self.data,
            self.stands,
            self._nth,
            self._angles,
            self._plans,
            self._counts,
            self._entries,
            self._steps,
            self._halts,
        ):
            kept.clear()
        for more in (
            self.unheeded,
            self.offsets,
            self.begun,
            self.stops,
            self._first_stops,
            self.prompts,
            self.refused,
            self._scales,
        ):
            more.clear()
        self._known.clear()

    def keep_whole(self) -> None:
        """Forget orders of profiles that did not come onto their track, as somebody ended the run at that moment.

        What came onto it without an order is not judged.
        """
        self.was_cut = True
        for number, a in self._controller.axes.items():
            count = min(len(WholeTrack(a).starts), len(self.of[number]), len(self.data[number]))
            del self.of[number][count:]
            del self.data[number][count:]

    def _path(self, a: Axis) -> Order:
        """That of a path; those that begin at one moment are numbered."""
        move = a.move
        assert move is not None
        action = move.action
        assert isinstance(action, PathMove)
        if action not in self._nth:
            key = action.axes[0].index, move.start_time
            self._nth[action] = self._counts[key] = self._counts.get(key, -1) + 1
        began, entry = self._entries.get(move, (-1.0, -1))
        if began != move.start_time:
            entry = self._controller.log.moves.number(move)
            self._entries[move] = move.start_time, entry
        order = self._planned_by(a, action) or self._planned(action, move, entry)
        assert order.path is not None
        for each in _paths_ahead(action):
            self._angles.setdefault(each, _angle_through(each))
        order = order._replace(path=order.path._replace(angle_into=self._angles.get(action, 0.0)))
        if a is action.axes[0] and order.path is not None:
            running = self._under_way.setdefault(a.index, {})
            tails = self._tails(running, action, order.path.rests)
            order = running[action] = order._replace(path=order.path._replace(tails=tails))
        return order

    def _tails(self, running: dict[PathMove, Order], action: PathMove, rests: bool) -> tuple[Order, ...]:
        """The orders of the paths that are still run, but for the last one; a rate that came too late waits."""
        found = []
        for each, before in list(running.items()):
            move = each.moves[0]
            if each is action or move.profile is None:
                continue
            if move.start_time + move.profile.duration <= self._controller.clock.now:
                del running[each]
                continue
            order = _path(each, move, self._nth[each], self._entries[move][1])
            assert order.path is not None
            order = order._replace(path=order.path._replace(rests=order.path.rests or rests))
            running[each] = order if self._is_planned_now(each) else _gentler(order, before)
            found.append(running[each])
        return tuple(found)

    def _planned_by(self, a: Axis, action: PathMove) -> Order | None:
        """The order of a path that goes on as it was planned, where only the one that it is blended with changes."""
        run, key = action.run, (action.moves[0].start_time, self._nth[action])
        if run is None or len(run.courses) < 2 or run.present.began == self._controller.clock.now:
            return None
        return next(
            order
            for order in reversed(self.of[a.index])
            if order.path is not None and (order.path.begun, order.path.nth) == key
        )

    def _planned(self, action: PathMove, move: Move, entry: int) -> Order:
        """The order of the newest path by the settings that it was last planned by, perhaps in another path's plan."""
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
        if not _own_speed(action.axes[0], action.moves[0]) > 0.0:  # it is refused, and the plan stays
            order = order._replace(speed=planned.speed)
        return order._replace(shape=planned.shape, ramp=planned.ramp)

    def _is_planned_now(self, action: PathMove) -> bool:
        """Whether a path under way has just been planned."""
        courses = () if action.run is None else action.run.courses
        return any(each.here is action and each.planned_at == self._controller.clock.now for each in courses)

    def displace(self, action: PathMove) -> None:
        """A path has begun elsewhere, since the one that it is blended with was cut short: its orders go with it."""
        if action not in self._nth:
            return
        begun, nth = action.moves[0].start_time, self._nth[action]
        for a in action.axes:
            records = self.of[a.index]
            for back, start in enumerate(reversed(a.starts), 1):
                order = records[-back]
                if start < begun:
                    break
                if order.path is not None and (order.path.begun, order.path.nth) == (begun, nth):
                    path = order.path._replace(**_places(action))
                    records[-back] = order._replace(path=path)

    def scale(self, axis: int, time: float) -> set[tuple[float, float]]:
        """Counts a unit and the zero of an axis at a time; several if they changed just then."""
        scales = self._scales[axis]
        last = bisect_right(scales, time, key=_TIME)
        first = bisect_left(scales, time, key=_TIME)
        return {(counts, zero) for _, counts, zero in scales[max(0, min(first, last - 1)) : last]}

    def stopped(self, axis: int, first: float, last: float) -> list[tuple[float, str]]:
        """The stops of an axis from one time to another, with the word for each."""
        stops = self.stops[axis]
        return stops[bisect_left(stops, first, key=_TIME) : bisect_right(stops, last, key=_TIME)]

    def was_stopped(self, axis: int, word: str, time: float) -> bool:
        """Whether an axis was stopped up to a time, with that word."""
        return self._first_stops.get((axis, word), INFINITY) <= time

    def heed(self, a: Axis) -> None:
        """A setting that acts at once was written: note what it asks for if the motion goes on as it was planned."""
        move = a.move
        if move is None:
            return
        action = move.action
        if isinstance(action, PathMove):
            a = action.axes[0]
            began = self._entries.get(action.moves[0])
            leader = action.moves[0]
            if action.guide is not None or began is None or not _own_speed(a, leader) > 0.0:
                return  # while a speed is not above zero every plan is refused
            wanted = _path(action, leader, self._nth[action], began[1])
            assert wanted.path is not None
            wanted = wanted._replace(path=wanted.path._replace(ahead=_ahead(action)))
            move = leader
        elif isinstance(action, Stopping) or self.of[a.index][-1].kind == "step":
            return
        elif action is not None or _own_speed(a, move) > 0.0:
            wanted = _order(a)
        else:
            return
        if move.speed is not None:  # a move that was loaded with its speed keeps its rates, too
            wanted = wanted._replace(rates=self.of[a.index][-1].rates)
        key = a.index, self._controller.clock.now
        if wanted.asks == self.of[a.index][-1].asks:
            self.unheeded.pop(key, None)
        else:
            self.unheeded[key] = wanted

    def jogs(self, a: Axis, velocity: float) -> None:
        """A jog was ordered: note its velocity if the axis does not go to it."""
        move = a.move
        if move is None or a.suspended or not isinstance(move.action, Jog):
            return
        goal, last = max(-a.max_speed, min(velocity, a.max_speed)), self.of[a.index][-1]
        if last.kind == "jog" and last.goal != goal:
            key = a.index, self._controller.clock.now
            self.unheeded[key] = last._replace(speed=abs(goal), goal=goal)

    def prompt(self, a: Axis, word: str) -> None:
        """What may begin a blend: a release, BLEND, a setting of blends, a dropped entry, the end of a suspension."""
        self.prompts[a.index].append((self._controller.clock.now, word))

    def prompted(self, axis: int, first: float, last: float) -> list[tuple[float, str]]:
        """What may have begun a blend of an axis from one time to another."""
        prompts = self.prompts[axis]
        return prompts[bisect_left(prompts, first, key=_TIME) : bisect_right(prompts, last, key=_TIME)]

    def refuse(self, a: Axis) -> None:
        """Note that an entry of the buffer of an axis is refused as it begins."""
        self.refused[a.index] = self._controller.clock.now

    def gears(self, a: Axis, ratio: float) -> None:
        """A ratio of a slave to its master was ordered: note it if the axis follows at another one."""
        key, last = (a.index, self._controller.clock.now), self.of[a.index][-1]
        if last.tie is None or last.tie.curve is not None or a.suspended:
            return
        if last.tie.ratio == ratio:
            self.unheeded.pop(key, None)
        else:
            self.unheeded[key] = last._replace(tie=last.tie._replace(ratio=ratio))

    def offset(self, a: Axis, distance: float, line: int) -> None:
        """An offset begins; what one before it has left is added to it."""
        self.offsets[a.index, self._controller.clock.now] = line, distance

    def refuse_offset(self, a: Axis) -> None:
        """The offset that was to begin now does not, as the limits of its axis leave no room for it."""
        self.offsets.pop((a.index, self._controller.clock.now), None)

    def stop(self, a: Axis, ended: str) -> None:
        """An axis is about to be told to decelerate to rest, and those that move together with it."""
        if a.move is not None:
            action = a.move.action
            for each in (a,) if action is None else action.together_with(a):
                self._stop(each, ended)

    def freeze(self, a: Axis, ended: str) -> None:
        """An axis is about to be told to stand at once."""
        self.stands[a.index, self._controller.clock.now] = ended
        if a.move is not None:
            self._stop(a, ended)

    def _stop(self, a: Axis, ended: str) -> None:
        now = self._controller.clock.now
        self.stops[a.index].append((now, ended))
        self._first_stops.setdefault((a.index, ended), now)


def _ahead(action: PathMove) -> tuple[Order, ...]:
    """The orders of the paths that a path goes on into."""
    return tuple(_path(each, each.moves[0], 0, -1) for each in _paths_ahead(action))


def _paths_ahead(action: PathMove) -> list[PathMove]:
    """The paths that a path goes on into."""
    courses = () if action.run is None else action.run.courses
    return [each for course in courses if course.here is action for each, _ in course.ahead]


def _angle_through(action: PathMove) -> float:
    """The angle up to which a path may be entered without a rest, by the settings of now."""
    master = action.axes[0]
    if action.guide is not None:
        return STRAIGHT
    return master.contour_angle if master.contour_mode else 0.0


def _gentler(order: Order, before: Order) -> Order:
    """What is ordered now for a path that another one is on top of and that goes on by the plan that it had.

    New rates may have come too late for it, and another shape counts from its next plan on.
    """
    path, old = order.path, before.path
    assert path is not None
    assert old is not None
    path = path._replace(
        most_accel=tuple(map(max, path.most_accel, old.most_accel)),
        most_decel=tuple(map(max, path.most_decel, old.most_decel)),
    )
    rates = max(order.rates[0], before.rates[0]), max(order.rates[1], before.rates[1])
    order = order._replace(rates=rates, jerks=before.jerks, path=path)
    return order._replace(shape=before.shape, ramp=before.ramp)


def _order(a: Axis) -> Order:
    move = a.move
    if move is None:
        return REST
    action = move.action
    if isinstance(action, (Gear, CurveFollow)) and not a.suspended:
        return Order(type(action).__name__, move.line, rates=_rates(a, move), tie=_tie(action))
    if isinstance(action, Gear):
        return _stopped(a, move)
    if isinstance(action, Played) and action.step:
        return Order("step", move.line, *_bounds(a, move), a.shape, step=action.step)
    if isinstance(action, Played):
        return Order("Played", move.line, points=action.ordered)
    if isinstance(action, SpeedReference) and not a.suspended:
        up, down = action.slopes
        goal = max(-a.max_speed, min(action.velocity, a.max_speed))
        slopes = up.key(), down.key()
        return Order("reference", move.line, abs(goal), (up.rate, down.rate), goal=goal, slopes=slopes)
    if isinstance(action, PositionReference) and not a.suspended:
        return Order("reference", move.line, goal=action.place)
    if action is not None and not isinstance(action, (Stopping, Jog)):
        return Order(type(action).__name__, move.line)
    speed, rates, jerks = _bounds(a, move)
    if isinstance(action, Stopping) or a.suspended:
        return _stopped(a, move)
    if isinstance(action, Jog):
        goal = max(-a.max_speed, min(action.velocity, a.max_speed))
        return Order("jog", move.line, abs(goal), rates, jerks, a.shape, goal, a.ramp)
    if not speed:  # an override of 0
        return _stopped(a, move)
    return Order("move", move.line, min(speed, a.max_speed), rates, jerks, a.shape, ramp=a.ramp)


def _stopped(a: Axis, move: Move) -> Order:
    return Order("stop", move.line, INFINITY, *_bounds(a, move)[1:], a.shape, ramp=a.ramp)


def _tie(action: Gear | CurveFollow) -> Tie:
    if isinstance(action, Gear):
        return Tie(action.master, action.ratio, action.locked, ramp=action.ramp)
    origin, direction, table = action.origin, action.direction, action.ordered
    if table is not None and table[2] == "even":  # the master's way has the sign that was ordered
        over = table[0][-1]
        direction, table = (1 if over > 0.0 else -1), ((0.0, abs(over)), *table[1:])
    return Tie(action.master, 0.0, INFINITY, action.curve, origin, direction, table)


def _rates(a: Axis, move: Move) -> tuple[float, float]:
    """The rates of a move: its own where it has some, those of the axis otherwise."""
    accel, decel = a.rates(a.speed if move.speed is None else move.speed)
    if move.rates is not None:
        accel, decel = move.rates[0] or accel, move.rates[1] or decel
    return accel, decel


def _bounds(a: Axis, move: Move) -> tuple[float, tuple[float, float], tuple[float, float]]:
    """Speed, rates and jerks of a move: its own where it has some, those of the axis otherwise, within its limits."""
    accel, decel = _rates(a, move)
    accel, decel = min(accel, a.max_accel), min(decel, a.max_decel)
    if isinstance(move.action, Stopping) and move.action.rate:
        decel = move.action.rate
    elif isinstance(move.action, Stopping) and move.action.hard:
        decel = a.error_decel if move.ended == "fault" else min(a.error_decel, a.max_decel)
    return _speed(a, move), (accel, decel), _jerks(a)


def _own_speed(a: Axis, move: Move) -> float:
    return a.speed if move.speed is None else move.speed


def _speed(a: Axis, move: Move) -> float:
    speed = _own_speed(a, move)
    return speed * a.override if move.overridden else speed


def _jerks(a: Axis) -> tuple[float, float]:
    return (a.accel_jerk, a.decel_jerk) if a.shape == "scurve" else ENDLESS


def _path(action: PathMove, move: Move, nth: int, entry: int, run: PathRun | None = None) -> Order:
    """The order of a path by the settings as they are now; one that is still ahead is given the `run` it belongs to."""
    run = run or action.run
    master, leader, axes, guide = action.axes[0], action.moves[0], action.axes, action.guide
    shape, k, ramp = master.shape, abs(action.scales[0]), master.ramp
    if guide is None:
        speed, rates, jerks = _speed(master, leader), _rates(master, leader), _jerks(master)
    else:
        pace = guide.pace()
        shape, k, ramp = pace.shape, 1.0, pace.ramp
        speed, rates, jerks = pace.speed, (pace.accel, pace.decel), ENDLESS
    most_decel = tuple(each.max_decel for each in axes)
    if guide is None and run is not None and run.ended and run.hard:
        rates = rates[0], master.error_decel
        most_decel = (INFINITY,) * len(axes) if run.ended == "fault" else most_decel
    rests = any(each.suspended for each in axes) or (run is not None and run.ended != "")
    geometry = action.geometry
    straight = isinstance(geometry, Line)
    path = PathOrder(
        tuple(each.index for each in axes),
        tuple(action.scales),
        move.start_time,
        nth,
        action.relative,
        **_places(action),
        angle=0.0 if straight else geometry.angle,  # type: ignore[union-attr]
        plane=(0, 1) if straight else geometry.plane,  # type: ignore[union-attr]
        length=geometry.length,
        most=tuple(each.max_speed for each in axes),
        most_accel=tuple(each.max_accel for each in axes),
        most_decel=most_decel,
        angle_into=0.0,
        blend=master.blend_distance if master.blend_mode else 0.0,
        rests=rests,
        ahead=_ahead(action) if rests else (),
        entry=entry,
    )
    bounds = speed / k, (rates[0] / k, rates[1] / k), (jerks[0] / k, jerks[1] / k)
    return Order("path", move.line, *bounds, shape, path=path, ramp=ramp)


def _places(action: PathMove) -> dict[str, Any]:
    """The fields of a `PathOrder` that count from the zeros of the axes, unless it is relative."""
    geometry = action.geometry
    if action.displaced and not action.relative:
        geometry = copy(geometry)
        for k, by in enumerate(action.displaced):
            geometry.shift(k, by)
    if isinstance(geometry, Line):
        return {"line": tuple(geometry.targets), "centre": (0.0, 0.0), "rest": ()}
    return {"line": (), "centre": tuple(geometry.centre), "rest": tuple(geometry.rest)}
