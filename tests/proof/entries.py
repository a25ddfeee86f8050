"""Checks of the log's entries in sequence: together they are the axis's motion.

Each entry ends for the reason that it states and before the run does; the last one ends where its axis is.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import fsum, isfinite

from motionlang.kernel import Axis
from motionlang.kernel.log import CONTINUED, MAX_PIECES, LoggedMove
from motionlang.kernel.planners import Profile
from tests.proof.checker import ROUNDED, SLACK, Proof, RunRecords, position
from tests.proof.offsets import check_offset
from tests.proof.order import Order

# The fraction of a time by which a sum of times may differ.
LATE = 4.0 * ROUNDED
# The reasons of entries that another one follows at once.
FOLLOWED = ("retarget", CONTINUED)
# Kinds of motion that come to rest by themselves, or never.
RESTING = ("move", "jog")


class Ends:
    """The ends of one axis's entries: `going` end after the run, `last` began last.

    `until` is the latest end of all entries, and `next_index` the index of the profile of the track that
    follows it. `begun` are the start times of motion that no entry has yet, `instant` those of entries
    without duration. `stated` are the stops, by time and keyword, that entries state as their ends. `unsaid`
    are stops at the edge of an entry that does not state them, with its line and the message; an adjacent
    entry has to state them.
    """

    __slots__ = ("begun", "going", "instant", "last", "next_index", "stated", "unsaid", "until")

    def __init__(self, begun: Iterable[float] = ()) -> None:
        self.begun, self.instant = set(begun), set[float]()
        self.going: list[LoggedMove] = []
        self.last: LoggedMove | None = None
        self.until = 0.0
        self.next_index = 0
        self.stated: set[tuple[float, str]] = set()
        self.unsaid: list[tuple[tuple[float, str], int, str]] = []


def take_entry(proof: Proof, ends: dict[int, Ends], run: RunRecords, move: LoggedMove) -> None:
    """Check an entry against the previous one; superposed ones are checked elsewhere."""
    profile = move.profile
    if profile is None:
        return
    if move.overlaid:
        check_offset(proof, run, move, profile)
        return
    found = ends.get(move.axis)
    if found is None:
        found = ends[move.axis] = Ends(run.expected_motion.begun[move.axis])
    if not run.expected_motion.was_cut:
        _check_entry(proof, run, found, move, profile)
    found.last, found.until = move, max(found.until, move.start_time + profile.duration)
    if move.start_time + profile.duration > run.until * (1.0 + ROUNDED):
        found.going.append(move)


def _check_entry(proof: Proof, run: RunRecords, found: Ends, move: LoggedMove, profile: Profile) -> None:
    a, start, before = run.axes[move.axis], move.start_time, found.last
    where, late = f"axis {move.axis} from {start:.6f} s", LATE * (1.0 + start)
    order, scale = run.order_of(move), run.expected_motion.scale(move.axis, start)
    first = run.rest_of(move) is None
    if first and order.kind != "rest" and move.line not in _lines(run, a, start):
        proof.breaks(move.line, f"{where}: it is commanded by line {order.line}")
    if profile.duration <= late:
        found.instant.add(start)
    elif start in found.begun:
        found.begun.remove(start)
    elif first:  # a path that is blended onto continues unseen
        proof.breaks(move.line, f"{where}: no motion without another entry begins then")
    if scale and (move.scale, move.zero) not in scale:
        words = f"it has {move.scale:g} counts per unit from {move.zero:g}, unlike its axis"
        proof.breaks(move.line, f"{where}: {words}")
    if start < found.until - late and order.kind != "path":
        proof.breaks(move.line, f"{where}: the previous entry ends at {found.until:.6f} s")
    if before is not None and before.profile is not None and before.ended in FOLLOWED:
        end = before.start_time + before.profile.duration
        if abs(start - end) > late and not (order.path is not None and run.is_continued(before)):
            words = f"it does not start at {end:.6f} s, when the previous one ends"
            proof.breaks(before.line, f"{where}: {words}")
    _check_gap(proof, run, a, found, start - late)
    if start + profile.duration <= run.until * (1.0 + ROUNDED):
        _check_ended(proof, run, a, found, move, where)


def _lines(run: RunRecords, a: Axis, start: float) -> set[int]:
    """Return the lines of motion that begins on an axis at a time."""
    i, records = a.index_at(start), run.expected_motion.of[a.index]
    found = {records[i].line}
    while i > 0 and a.starts[i] == start:
        i -= 1
        found.add(records[i + 1].line)
    return found


def _check_gap(proof: Proof, run: RunRecords, a: Axis, found: Ends, until: float) -> None:
    """Check that the axis was at rest between the entries so far and a time."""
    records = run.expected_motion.of[a.index]
    while found.next_index < len(a.starts) and a.starts[found.next_index] < until:
        i = found.next_index
        begin, over = run.span(a, i)
        begin, end = max(begin, found.until), min(over, until)
        if end - begin > LATE * (1.0 + begin) and records[i].kind != "rest":
            first = a.profiles[i].position(begin - a.starts[i])
            middle, last = (a.profiles[i].position(each - a.starts[i]) for each in (0.5 * (begin + end), end))
            if max(abs(middle - first), abs(last - first)) > SLACK * max(1.0, abs(first)):
                where = f"axis {a.index} from {begin:.6f} s"
                proof.breaks(records[i].line, f"{where}: it moves without an entry in the log")
                return
        if over > until:
            return
        found.next_index += 1


def _is_full(run: RunRecords, move: LoggedMove, last: Order) -> bool:
    """True if an entry, or another one of its path, has more than `MAX_PIECES`."""
    entries = [move] if last.path is None else run.members(last.path)
    return any(each.profile is not None and len(each.profile.knots) > MAX_PIECES for each in entries)


def _check_ended(proof: Proof, run: RunRecords, a: Axis, found: Ends, move: LoggedMove, where: str) -> None:
    """Check that an entry has ended for its stated reason.

    The reasons are a commanded stop, another entry, or its own end.
    """
    assert move.profile is not None
    expected_motion, start = run.expected_motion, move.start_time
    end = start + move.profile.duration
    late = LATE * (1.0 + end)
    stops = expected_motion.stopped(a.index, start - late, end + late)
    i = _last(a, start, end)
    last, over = expected_motion.of[a.index][i], run.span(a, i)[1]
    if move.profile.duration > late and last.kind != "path" and abs(over - end) > late:
        proof.breaks(move.line, f"{where}: it ends at {end:.6f} s, its motion at {over:.6f} s")
    if move.ended == CONTINUED and not _is_full(run, move, last):
        proof.breaks(move.line, f"{where}: it is logged as continued, but its entry is not full")
    elif move.ended == "retarget" and _is_at_end(run, a, i, end, late):
        proof.breaks(move.line, f"{where}: it is logged as replaced, but reaches its end")
    found.stated.update(stop for stop in stops if stop[1] == move.ended)
    if move.ended in ("stop", "cancel", "fault"):
        # A stop may lead through the end of one path into the next.
        earlier = last.path is not None and last.path.comes_to_rest
        ordered = expected_motion.was_stopped(a.index, move.ended, end + late) if earlier else False
        if ordered:
            found.stated.update(stop for stop, *_ in found.unsaid if stop[1] == move.ended)
        if not ordered and all(word != move.ended for _, word in stops):
            proof.breaks(
                move.line, f"{where}: it is logged as ended by a {move.ended} that was not commanded"
            )
    elif not move.ended and move.profile.duration:
        is_resting = last.kind in RESTING
        if is_resting and abs(move.profile.end_velocity) > SLACK * max(1.0, move.profile.peak_speed):
            proof.breaks(move.line, f"{where}: it is logged as complete, but is still moving")
        points = None if last.points is None or move.offset else last.points[0]
        if points is not None and abs(move.profile.end - points[-1]) > SLACK * max(1.0, abs(points[-1])):
            proof.breaks(move.line, f"{where}: it is logged as complete, but its end is {points[-1]:g}")
        for time, word in stops:
            if (
                time < end + (late if last.tie is not None else -late)
                and _order_before(run, a, time).kind != "stop"
            ):
                words = f"{where}: a {word} was commanded at {time:.6f} s, but is not logged"
                # A stop that leads on is logged on the path on which it comes to rest.
                leads_on = last.path is not None and last.path.leads_on
                if start + late < time < end - late and not leads_on:
                    proof.breaks(move.line, words)
                else:
                    found.unsaid.append(((time, word), move.line, words))
                return


def _is_at_end(run: RunRecords, a: Axis, i: int, end: float, late: float) -> bool:
    """True if the last profile of an entry reaches its own end at `end`.

    An endless or stopped profile has no end of its own.
    """
    order = run.expected_motion.of[a.index][i]
    if order.tie is not None and order.tie.table is not None and order.tie.table[2] == "even":
        travelled = position(order.tie.master, end) - order.tie.origin
        length = order.tie.table[0][-1]
        return abs(travelled * order.tie.direction - length) <= SLACK * max(1.0, length)
    if order.kind in ("jog", "stop", "Gear"):
        return False
    # The clock does not round: a profile that begins one digit before the end has replaced it.
    over = a.starts[i + 1] if i + 1 < len(a.starts) else end + late
    return a.starts[i] + a.profiles[i].duration <= (over if abs(over - end) <= late else end + late)


def _order_before(run: RunRecords, a: Axis, time: float) -> Order:
    i = a.index_at(time)
    while i > 0 and a.starts[i] >= time:
        i -= 1
    return run.expected_motion.of[a.index][i]


def _last(a: Axis, start: float, end: float) -> int:
    """Return the index of the last profile of an entry."""
    i = a.index_at(end)
    while i > 0 and a.starts[i] >= end - LATE * (1.0 + end) and a.starts[i] > start:
        i -= 1
    return i


def check_ends(proof: Proof, run: RunRecords, ends: dict[int, Ends]) -> None:
    """Check the last entry of each axis: it ends where its axis is.

    An entry may end after the run only if its axis still follows it, at its speed.
    """
    for number, a in run.axes.items():
        found = ends.get(number)
        if found is None:
            found = Ends(run.expected_motion.begun[number])
        if run.expected_motion.was_cut:
            found.begun.clear()
        else:
            _check_gap(proof, run, a, found, run.until)
            _check_waiting(proof, run, a)
        for time in sorted(found.begun - found.instant):
            line = run.expected_motion.of[number][a.index_at(time)].line
            proof.breaks(line, f"axis {number} from {time:.6f} s: it has no entry in the log")
        for stop, line, words in found.unsaid:
            if stop not in found.stated:
                proof.breaks(line, words)
        if found.last is not None and found.last.ended in FOLLOWED and not run.expected_motion.was_cut:
            where = f"axis {number} from {found.last.start_time:.6f} s"
            proof.breaks(found.last.line, f"{where}: nothing follows the replaced move")
        if found.going:
            _check_going(proof, run, a, found.going)
        elif found.last is not None:
            _check_last(proof, run, a, found.last)


def _check_waiting(proof: Proof, run: RunRecords, a: Axis) -> None:
    """Check that no released move waits at the end of the run without a reason.

    The reasons are another move in progress, and an error that ends the run. It is not checked after an
    interrupt, which may come between the release of a move and its start.
    """
    offsets = run.offsets.get(a.index)
    follows = run.expected_motion.of[a.index][-1].tie is not None
    waiting = [] if a.suspended else a.buffer
    found = [move for move in waiting[:1] if move.action is None and a.move is None]
    if follows and (offsets is None or not offsets.is_active_at(run.until)):
        found += [move for move in waiting if move.action is not None and move.action.lies_on_top]
    for move in found:
        if not move.released or _is_refused(run, a):
            continue
        proof.breaks(
            move.line, f"axis {a.index}: its move is waiting at the end of the run, but nothing is in motion"
        )


def _is_refused(run: RunRecords, a: Axis) -> bool:
    """True if an axis's next move was rejected at the end of the run.

    Also true if it was due at the instant at which another axis's move was rejected.
    """
    times = [run.expected_motion.refused.get(a.index, -1.0)]
    if a.starts[-1] == run.until:
        times += run.expected_motion.refused.values()
    return run.until in times


def _check_going(proof: Proof, run: RunRecords, a: Axis, going: list[LoggedMove]) -> None:
    present = a.move
    first = going[0]
    where = f"axis {a.index} from {first.start_time:.6f} s"
    if present is None:
        assert first.profile is not None
        end = first.start_time + first.profile.duration
        proof.breaks(first.line, f"{where}: its entry ends at {end:g} s, the run at {run.until:g} s")
        return
    if a.index in run.offsets:
        return
    k = a.index_at(run.until)
    done = a.profiles[k].velocity(run.until - a.starts[k])
    # A step at the end of the run is later, in the time of an entry, by rounding.
    for late in (0.0, ROUNDED * (1.0 + run.until)):
        now = run.until + late
        speeds = [each.profile.velocity(now - each.start_time) for each in going if each.profile is not None]
        if abs(fsum(speeds) - done) <= SLACK * max(1.0, abs(done), *map(abs, speeds)):
            return
    words = f"its entries run at {fsum(speeds):g} counts/s at the end of the run, the axis at {done:g}"
    proof.breaks(first.line, f"{where}: {words}")


def _check_last(proof: Proof, run: RunRecords, a: Axis, last: LoggedMove) -> None:
    profile = last.profile
    assert profile is not None
    if (
        a.feedback is not None
        or a.index in run.offsets
        or not isfinite(profile.end)
        or run.expected_motion.was_cut
    ):
        return
    data, done = run.expected_motion.data[a.index], position(a, run.until)
    # Its shift since it began: another zero may have been set at that time.
    i = a.index_at(last.start_time)
    shifts = [data[-1] - data[i]]
    while i > 0 and a.starts[i] >= last.start_time - ROUNDED * (1.0 + last.start_time):
        i -= 1
        shifts.append(data[-1] - data[i])
    end = min((profile.end + shift for shift in shifts), key=lambda each: abs(each - done))
    if abs(end - done) > SLACK * max(1.0, abs(end), abs(done)):
        where = f"axis {a.index} from {last.start_time:.6f} s"
        proof.breaks(last.line, f"{where}: the last entry ends at {end:g}, the axis is at {done:g}")
