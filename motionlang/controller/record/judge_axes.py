"""The judge of single axes: bounds and times of what was planned from their settings; slaves beside their masters."""

from __future__ import annotations

from bisect import bisect_right
from itertools import pairwise
from math import inf, isfinite
from typing import TYPE_CHECKING

from motionlang.controller.record.judge import SLACK, Uses, position
from motionlang.controller.record.spans import derivatives, due, due_from_rest, spans

if TYPE_CHECKING:
    from motionlang.controller.record.judge import Proof, Run
    from motionlang.controller.record.orders import Order
    from motionlang.controller.record.spans import Span
    from motionlang.controller.record.track import WholeTrack
    from motionlang.profile import Profile

# Kinds that are planned from the settings of the axis, and so keep its rates.
PLANNED = frozenset({"move", "jog", "stop"})
# Places of a span at which two motions are compared: two cubics that agree at four of them are one.
FOUR = (0.05, 0.35, 0.65, 0.95)


def judge_profile(proof: Proof, a: WholeTrack, i: int, order: Order, length: float) -> None:
    """Speed, rates, jerk and time of what was planned from the settings of the axis; continuity of all in pieces."""
    profile = a.profiles[i]
    proof.counts["profiles"] += order.kind != "rest"
    if not profile.pieced or order.kind == "rest":
        return
    parts = spans(profile, 0.0, min(length, 1e300))
    _judge_knots(proof, a, i, order, parts)
    if order.kind not in PLANNED:
        return
    entry = profile.at(0.0)
    # An axis that comes in too fast, or with too much acceleration, is excused until it has slowed down.
    came = abs(entry.velocity)
    if order.jerks[0] < inf and entry.acceleration * entry.velocity > 0.0:
        came += 0.5 * entry.acceleration**2 / order.jerks[0]
    fastest = max(order.speed, came)
    still = SLACK * max(1.0, abs(profile.start_velocity), order.speed if order.speed < inf else 0.0)
    uses = Uses(proof)
    eased = abs(entry.acceleration) if order.jerks[0] < inf else 0.0
    for span in parts:
        uses.look("speed", span.peak(1), fastest)
        sides = list(span.sides())
        for power, left, right in sides:
            side = 0 if power > 0.0 else 1
            rate, jerk = order.rates[side], order.jerks[side]
            if max(abs(left[1]), abs(right[1])) <= still:  # at rest but for rounding
                rate = max(order.rates)
            if len(sides) > 1:  # what turns round eases out at the jerk that it came with
                jerk = max(order.jerks)
            name = ("acceleration", "deceleration")[side]
            uses.look(name, max(abs(left[2]), abs(right[2])), max(rate, eased))
            if order.jerks[0] < inf:
                uses.look("jerk", max(abs(left[3]), abs(right[3])), jerk)
    where = f"axis {a.index} from {a.starts[i]:.6f} s"
    uses.tell(order.line, where, " counts")
    _judge_time(proof, profile, order, where)


def _judge_time(proof: Proof, profile: Profile, order: Order, where: str) -> None:
    """What was planned takes no longer than its bounds ask for: stops and jogs from any state, moves from rest."""
    smooth = order.jerks[0] < inf
    if order.shape != "trapezoid" and not smooth:
        return  # PMC's S-curves have a shape instead of a jerk
    entry = profile.at(0.0)
    v0, a0 = entry.velocity, entry.acceleration if smooth else 0.0
    if order.kind == "move":
        if v0 or a0 or not isfinite(profile.duration):
            return
        wanted = due_from_rest(abs(profile.distance), order.speed, order.rates, order.jerks)
        took = profile.duration
    else:
        wanted = due(v0, a0, order.goal, order.rates, order.jerks)
        took = profile.knots[-1] if isfinite(profile.knots[-1]) else profile.knots[-2]
    if took > wanted * (1.0 + SLACK) + 1e-9 + 4e-16 * abs(profile.start):
        proof.breaks(order.line, f"{where}: it takes {took:g} s where {wanted:g} s are due")


def _judge_knots(proof: Proof, a: WholeTrack, i: int, order: Order, parts: list[Span]) -> None:
    """Position goes on from piece to piece; the velocity of planned motion too, and the acceleration of S-ramps."""
    profile = a.profiles[i]
    names = ("position", "velocity", "acceleration")[
        : 1 if order.kind not in (*PLANNED, "path") else 3 if order.jerks[0] < inf else 2
    ]
    sizes = [max(1.0, abs(profile.start))]
    for left, right in pairwise(parts):
        before, after = left.at(left.length), right.at(0.0)
        if len(sizes) == 1:
            sizes += [max(1.0, profile.peak_speed), max(1.0, *(r for r in order.rates if r < inf), 1.0)]
        late = 4e-16 * (1.0 + a.starts[i] + right.begin)
        for which, name in enumerate(names):
            gap = abs(after[which] - before[which])
            if gap > SLACK * sizes[which] + 4.0 * late * abs(before[which + 1]):
                where = f"axis {a.index} at {a.starts[i] + right.begin:.6f} s"
                proof.breaks(order.line, f"{where}: the {name} jumps by {gap:g} counts within a profile")


# ------------------------------------------------------------------------------------------------- followers


def judge_tie(proof: Proof, run: Run, a: WholeTrack, i: int, order: Order, end: float) -> None:
    """A slave is where its ratio, or its table, has it wherever its master is; before that it ramps at its rates."""
    tie = order.tie
    assert tie is not None
    track, begin = run.track(tie.master), a.starts[i]
    where = f"axis {a.index} from {begin:.6f} s"
    if tie.curve is None and tie.locked > begin:
        _judge_chase(proof, run, a, i, order, end)
        begin = tie.locked
    times = [t for t in _moments(a, track, begin, end) if t < end]
    base: float | None = None
    for time in times:
        offset = _offset(run, a, time)
        done = position(a, time) - offset
        master = position(track, time)
        if tie.curve is None:
            wanted = done if base is None else base + tie.ratio * master
            base = done - tie.ratio * master if base is None else base
        else:
            along = tie.direction * (master - tie.origin)
            wanted = _on(tie.curve, along)
            base = done - wanted if base is None else base
            wanted += base
        size = max(1.0, abs(done), abs(wanted))
        speed = abs(a.profiles[i].velocity(time - a.starts[i]))
        if abs(done - wanted) > SLACK * size + 8e-16 * (1.0 + time) * speed:
            proof.breaks(
                order.line, f"{where}: at {time:.6f} s it is at {done:g}, its master has it at {wanted:g}"
            )
            return


def _judge_chase(proof: Proof, run: Run, a: WholeTrack, i: int, order: Order, end: float) -> None:
    """Until it has the velocity of its ratio a slave changes its own at its rates."""
    tie = order.tie
    assert tie is not None
    if _offset_moves(run, a, a.starts[i]):
        return
    until = min(end, tie.locked)
    uses = Uses(proof)
    for share in FOUR:
        time = a.starts[i] + share * (until - a.starts[i])
        state = a.profiles[i].at(time - a.starts[i])
        side = 0 if state.velocity * state.acceleration > 0.0 else 1
        uses.look("rate of a slave", abs(state.acceleration), order.rates[side])
    uses.tell(order.line, f"axis {a.index} from {a.starts[i]:.6f} s", " counts")


def _moments(a: WholeTrack, master: WholeTrack, begin: float, end: float) -> list[float]:
    """Four places of every stretch on which both master and slave are one piece; some of many."""
    knots = {begin, end}
    for track in (a, master):
        k = track.place(begin)
        while k < len(track.starts) and track.starts[k] < end:
            knots.update(t for t in (track.starts[k] + x for x in track.profiles[k].knots) if begin < t < end)
            k += 1
    ordered = sorted(t for t in knots if isfinite(t))
    stretches = list(pairwise(ordered))[:24]
    return [x + share * (y - x) for x, y in stretches for share in FOUR]


def _on(curve: Profile, along: float) -> float:
    """A curve over its distance; straight on before its beginning and beyond its end."""
    knots = curve.knots
    x = min(max(along, 0.0), knots[-1])
    k = max(0, min(bisect_right(knots, x), len(curve.pieces)) - 1)
    p, slope, _, _ = derivatives(curve.pieces[k], x - knots[k])
    return p + slope * (along - x)


def _offset(run: Run, a: WholeTrack, time: float) -> float:
    """What offsets on top of following have added up to a time."""
    total = 0.0
    for move in run.offsets.get(a.index, ()):
        if move.start_time <= time and move.profile is not None:
            total += move.profile.position(time - move.start_time) - move.profile.start
    return total


def _offset_moves(run: Run, a: WholeTrack, time: float) -> bool:
    return any(
        move.start_time <= time
        and move.profile is not None
        and time < move.start_time + move.profile.duration
        for move in run.offsets.get(a.index, ())
    )
