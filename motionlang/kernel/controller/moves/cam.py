"""Cams and flying shears: a slave on a curve over its master's distance.

Cycles or segments follow one another.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from math import ulp

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY, TimedCall
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.motion.follow import Follow, FollowMove, check_chain, follows
from motionlang.kernel.controller.queue import buffer
from motionlang.kernel.controller.queue.action import Action
from motionlang.kernel.controller.queue.buffer import take
from motionlang.kernel.controller.queue.life import go_on
from motionlang.kernel.controller.queue.stop import decelerate
from motionlang.kernel.controller.queue.track import extend_track
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.planners import Profile, hold
from motionlang.kernel.planners.curve import from_curve
from motionlang.kernel.planners.dwell import rest
from motionlang.kernel.planners.reparametrised import travelled
from motionlang.kernel.planners.table_motion import table_curve

Points = tuple[Sequence[float], Sequence[float]]
Table = Callable[[float], Points]
Ordered = tuple[tuple[float, ...], tuple[float, ...], str]

# Fraction of a cycle by which the master must at least reverse to leave it, and may fall short of its end.
# The reversal is larger if the rounding of the clock is, and `_UNKNOWN` if the speed has no bound.
_NEAR = 1e-11
_UNKNOWN = 1e-9
_AT_END = 1e-13
# Pieces of a curve that take as much memory as a profile of an axis.
_PIECES = 8
# A shorter cycle, in counts of the master, would be over before anything could be done.
MIN_CYCLE = 1.0


class CurveFollow(Follow):
    """A slave on `curve` (counts over counts of the master).

    `direction` is the master's direction of travel. `origin` is the master's position at which the curve
    begins. `origin` moves with the master's zero, and when the master's commanded position is set to that of its
    motor: the slave follows neither change. `lift` is added to the positions of the curve, so that the cycles of a
    cam share one curve. `ordered` is the source of the curve: master positions, the slave's values there, and how
    they are joined.
    """

    __slots__ = ("_event", "curve", "datum", "direction", "lift", "ordered", "origin")

    def __init__(self, a: Axis, master: Axis, move: FollowMove, curve: Profile, direction: int) -> None:
        super().__init__(a, master, move)
        self.curve, self.direction, self.lift = curve, direction, 0.0
        self.ordered: Ordered | None = None
        self.origin, self.datum = master.position(a.clock.now), _datum(master)
        self._event: TimedCall | None = None

    def over(self, forward: bool) -> bool:
        """Handle the end of the curve, or in reverse its beginning; True to continue."""
        raise NotImplementedError

    # -- the tie

    def base(self, coming: Profile, position: float) -> Profile:
        """Return the slave's motion on the curve for the master's motion `coming`.

        `position`, where it begins, is already on the curve.
        """
        along = self._along(coming)
        if along.shape == "hold":
            return rest(self.move.shape, self._at(along.start), INFINITY)
        return travelled(along, self.curve, self.move.shape, self.lift)

    def table_position(self) -> float:
        """Return the master's distance along the curve, counts."""
        return self._along(self.coming()).start

    def arm(self, coming: Profile) -> None:
        """Schedule when the master leaves the curve, at either end if it may reverse."""
        along, clock = self._along(coming), self.a.clock
        length = self.curve.duration
        times: list[tuple[float, bool]] = []
        time: float | None
        if along.start < length * (1.0 - _AT_END):
            time = along.crossing(length)
        else:
            back = _runs_back(along, length, self._reversal(along)) if self.goes_back else None
            time = 0.0 if back is None else along.crossing(length, back)
        if time is not None:
            times.append((time, True))
        if self.goes_back and (time := _beginning(along, 2.0 * self._reversal(along))) is not None:
            times.append((time, False))
        if times:
            time, forward = min(times)
            self._event = clock.at(clock.now + time, lambda: self._passed(forward))

    goes_back = False

    def disarm(self) -> None:
        if self._event is not None:
            self._event.cancel()
            self._event = None

    def shift(self, a: Axis, shift: float) -> None:
        self.lift += shift

    def resume(self, a: Axis) -> None:
        """Start the waiting offsets; the curve itself was never suspended."""
        self.more(a)

    def fold(self, distance: float) -> None:
        self.lift += distance
        if abs(self.move.target) < INFINITY:
            self.a.target = self.move.target = self.end

    @property
    def end(self) -> float:
        """The slave's position at the end of the curve, counts."""
        return self.curve.end + self.lift

    def next_curve(self, curve: Profile, forward: bool) -> None:
        """Continue on another curve after the end of this one, or before its beginning."""
        if forward:
            self.lift += self.curve.end - curve.start
            self.origin += self.direction * self.curve.duration
        else:
            self.lift += self.curve.start - curve.end
            self.origin -= self.direction * curve.duration
        if curve is not self.curve:  # the history of the slave stores it
            size = len(curve.pieces) // _PIECES
            self.move.size += size
            self.curve = curve

    def finish(self) -> None:
        """End the curve: the slave stops, at once if it is slow enough."""
        a = self.a
        self.end_offset("stop")
        self.detach()
        if abs(a.velocity(a.clock.now)) > 1e-6:
            decelerate(a, "")
            return
        end = self._at(self.curve.duration)
        move = self.move
        move.profile = move.until(a.clock.now)
        a.move = None
        a.target = move.target = end
        extend_track(a, hold(end))
        go_on(a)

    # -- inside

    def _passed(self, forward: bool) -> None:
        self._event = None
        try:
            goes_on = self.over(forward)
        except Rejected as rejected:
            rejected.line = rejected.line or self.move.line
            self.a.controller.run_time_fault(rejected)
            goes_on = False
        if goes_on:
            self.renew(BY_DESIGN)
        else:
            self.finish()

    def _reversal(self, along: Profile) -> float:
        """Return how far the master must reverse to re-enter the previous cycle.

        The distance exceeds rounding errors. Up to it the slave is on the straight continuation of this cycle.
        """
        length, late = self.curve.duration, 4.0 * along.speed_bound * ulp(self.a.clock.now)
        return max(late, _NEAR * length) if late < INFINITY else _UNKNOWN * length

    def _along(self, coming: Profile) -> Profile:
        """Return the master's motion as a distance along the curve."""
        datum = _datum(self.master)
        self.origin += datum - self.datum
        self.datum = datum
        return coming.scaled((coming.start - self.origin) * self.direction, float(self.direction))

    def _at(self, along: float) -> float:
        curve = self.curve
        if along < 0.0:
            return curve.start + curve.start_velocity * along + self.lift
        return curve.position(along) + self.lift


def _datum(master: Axis) -> float:
    """Return how far a master's positions have been shifted without motion."""
    return master.datum + (master.feedback.demand_shift if master.feedback is not None else 0.0)


class Cam(CurveFollow):
    """Following a cam table, once or repeatedly. It is read again in every cycle, so a program may change it.

    Its curve begins at 0. The curve is reused as long as `table` returns the same `points`.
    """

    __slots__ = ("cyclic", "first", "points", "table")

    table: Table
    points: Points

    def __init__(
        self,
        a: Axis,
        master: Axis,
        move: FollowMove,
        curve: Profile,
        cyclic: bool,
        first: int,
    ) -> None:
        super().__init__(a, master, move, curve, 1)
        self.cyclic, self.first = cyclic, first

    @property
    def goes_back(self) -> bool:  # type: ignore[override]
        return self.cyclic

    def over(self, forward: bool) -> bool:
        """Continue with the next cycle or the previous one, whose table is read now."""
        points = self.table(self.end) if self.cyclic and forward else self.points
        if points is not self.points:
            self.next_curve(curve_of(self.a, points), True)
            self.use(points)
        elif self.cyclic:
            self.next_curve(self.curve, forward)
        return self.cyclic

    def use(self, points: Points) -> None:
        """Store the points of the curve."""
        self.points = points
        self.ordered = tuple(points[0]), tuple(points[1]), "linear"

    @property
    def index(self) -> int:
        """The segment of the table at the master's position."""
        return self.first + self._segment(self.table_position())

    def index_time(self, index: int | None) -> float:
        """Return when the master may enter or leave a segment of the table.

        The segment is by default the present one. INFINITY if the master never does in this cycle.
        """
        along, knots = self._along(self.coming()), self.curve.knots
        segment = self._segment(along.start) if index is None else index - self.first
        if along.shape == "hold" or not 0 <= segment < len(knots) - 1:
            return INFINITY
        times = map(along.crossing, knots[segment : segment + 2])
        return self.a.clock.now + min((time for time in times if time is not None), default=INFINITY)

    def _segment(self, along: float) -> int:
        return bisect_right(self.curve.knots, along, 1, len(self.curve.knots) - 1) - 1


def curve_of(a: Axis, points: Points) -> Profile:
    """Return the curve through a table, which begins at 0."""
    positions, values = points
    try:
        curve = table_curve(positions, [value - values[0] for value in values])
    except ValueError as problem:
        raise Rejected("range", f"axis {a.index} cannot follow the table: {problem}") from None
    if curve.duration < MIN_CYCLE:
        raise Rejected("range", f"a cam of {curve.duration:.10g} counts of the master is too short")
    return curve


class Fly(Action):
    """A buffer entry: `distance` of the slave while the master travels `over`, counts."""

    __slots__ = ("distance", "master", "over")
    can_stand = False

    def __init__(self, master: Axis, distance: float, over: float) -> None:
        self.master, self.distance, self.over = master, distance, over

    def begin(self, a: Axis, move: LoggedMove) -> None:
        """Tie the axis to its master; a Rejected carries the line of the entry."""
        try:
            check_chain(a, self.master)
            self.follow(a, move, 0.0).engage()
        except Rejected as rejected:
            rejected.line = move.line
            raise

    def follow(self, a: Axis, move: LoggedMove, ratio: float) -> Shear:
        """Return the tie of this segment, with `ratio` of slave to master at its start."""
        here = a.position(a.clock.now)
        entry = FollowMove(a.index, move.command, move.line, "fly", here + self.distance)
        entry.id = move.id
        curve = _segment(here, self.distance, abs(self.over), ratio)
        tie = Shear(a, self.master, entry, curve, 1 if self.over > 0.0 else -1)
        tie.ordered = (0.0, self.over), (0.0, self.distance), "even"
        return tie


class Shear(CurveFollow):
    """One segment of a flying shear; at its end the next one in the buffer continues."""

    __slots__ = ()

    def over(self, forward: bool) -> bool:
        """Continue with the next segment of the buffer at the present ratio.

        False if there is none.
        """
        a = self.a
        head = self._next_entry()
        if head is None or not isinstance(head.action, Fly):
            return False
        following = head.action
        if follows(following.master, a):
            return False  # it is rejected when it begins by itself
        take(a)
        ratio = self.curve.end_velocity
        if (following.over > 0.0) is not (self.direction > 0) or following.master is not self.master:
            ratio = 0.0
        self._close()
        tie = following.follow(a, head, ratio)
        tie.curve = tie.curve.shifted(self.end - tie.curve.start)
        if following.master is self.master:
            tie.origin = self.origin + self.direction * self.curve.duration
        if self.offset is not None:
            tie.carry(self.offset, self.offset_began, self.offset_entry)
        tie.move.target = tie.curve.end
        tie.engage()
        return True

    def _next_entry(self) -> LoggedMove | None:
        """Return the next entry of the buffer, and execute the outputs before it."""
        buffered = self.a.buffer
        while buffered and buffered[0].released:
            head = buffered[0]
            if head.action is None or not head.action.is_instant:
                return head
            take(self.a)
            head.action.begin(self.a, head)
        return None

    def _close(self) -> None:
        """Close this segment's entry of the log."""
        self.detach()
        move, now = self.move, self.a.clock.now
        move.profile = move.until(now)
        self.a.move = None


def _runs_back(along: Profile, edge: float, least: float) -> float | None:
    """Return when a master near `edge` reaches `least` before it, running backwards.

    None if it first reaches `least` beyond it, or never does.
    """
    if along.start < edge - least:
        return 0.0
    if along.extrema()[0] >= edge - least or (time := along.crossing(edge - least)) is None:
        return None
    ahead = along.crossing(edge + least)
    return time if ahead is None or time < ahead else None


def _beginning(along: Profile, least: float) -> float | None:
    """Return when a master passes the beginning of a cycle backwards.

    None if it never goes back by more than `least`: the previous cycle is entered only if it does not end again at
    once. So `least` exceeds the distance that counts as a reversal at the end of that cycle.
    """
    if along.extrema()[0] >= -least:
        return None
    if along.start > least:
        return along.crossing(0.0)
    # At the beginning within rounding, its first direction decides, as at the end of the cycle before.
    back = _runs_back(along, 0.0, least)
    if back is not None:
        time = along.crossing(0.0) if along.start > 0.0 else 0.0
        return time if time is not None and time <= back else 0.0  # an arc that begins there may not pass it
    ahead = along.crossing(least)
    return along.crossing(0.0, ahead) if ahead is not None else None


def _segment(start: float, distance: float, over: float, ratio: float) -> Profile:
    """Return a curve whose ratio begins at `ratio` and changes linearly.

    The slave travels `distance` while the master travels `over`.
    """
    last = 2.0 * distance / over - ratio
    piece = (start, ratio, 0.5 * (last - ratio) / over, 0.0, 0.0, 0.0, 0.0)
    return from_curve("fly", start, start + distance, ((0.0, over), (piece,), (("fly", 0),)), ratio, last)


def load_fly(a: Axis, master: Axis, distance: float, over: float, command: str, line: int) -> None:
    """Load a segment of a flying shear into the buffer."""
    if not (MIN_CYCLE <= abs(over) < 1e300 and abs(distance) < 1e300):
        raise Rejected(
            "range",
            f"a segment cannot go {distance:.10g} counts while its master goes {over:.10g}",
            "set its distance first",
        )
    check_chain(a, master)
    move = buffer.counted(a, distance, command, line)
    move.action = Fly(master, distance, over)
    buffer.put(a, move)
