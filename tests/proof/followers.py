"""Checks of following: slaves against masters, curves and splines against tables."""

from __future__ import annotations

from bisect import bisect_right
from itertools import pairwise
from math import fsum, isfinite

from motionlang.kernel import Axis
from motionlang.kernel.planners import Profile
from tests.proof.checker import SLACK, BoundUses, Proof, RunRecords, position
from tests.proof.order import Order, Tie
from tests.proof.segments import derivatives

# Fractions of a segment at which two motions are compared: two cubics that agree at four of them are equal.
FOUR = (0.05, 0.35, 0.65, 0.95)
# Stretches, beyond which only the ends of each are compared.
MANY = 24


def check_tie(proof: Proof, run: RunRecords, a: Axis, i: int, order: Order, end: float) -> None:
    """Check that the position of a slave matches its ratio or table.

    Until it has caught up, it accelerates at its rates.
    """
    tie = order.tie
    assert tie is not None
    track, begin = tie.master, a.starts[i]
    where = f"axis {a.index} from {begin:.6f} s"
    if tie.curve is None and tie.locked > begin:
        earlier = run.expected_motion.of[a.index][i - 1]
        if not tie.ramp and earlier.kind != "stop" and tie.takes_up(earlier.tie):
            proof.breaks(order.line, f"{where}: it ramps to its ratio, commanded to engage at once")
        _check_chase(proof, run, a, i, order, end)
        begin = tie.locked
    if tie.curve is not None and tie.table is not None:
        _check_table(proof, run, a, i, order, tie.curve)
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
            wanted = _wanted(tie, tie.curve, along)
            base = done - wanted if base is None else base
            wanted += base
        size = max(1.0, abs(done), abs(wanted))
        speed = abs(a.profiles[i].velocity(time - a.starts[i]))
        if abs(done - wanted) > SLACK * size + 8e-16 * (1.0 + time) * speed:
            proof.breaks(
                order.line, f"{where}: at {time:.6f} s it is at {done:g}, its master requires {wanted:g}"
            )
            return


def _check_chase(proof: Proof, run: RunRecords, a: Axis, i: int, order: Order, end: float) -> None:
    """Check that a slave changes velocity at its rates until it reaches the ratio's."""
    tie = order.tie
    assert tie is not None
    if _offset_moves(run, a, a.starts[i]):
        return
    until = min(end, tie.locked)
    uses = BoundUses(proof)
    for share in FOUR:
        time = a.starts[i] + share * (until - a.starts[i])
        state = a.profiles[i].at(time - a.starts[i])
        side = 0 if state.velocity * state.acceleration > 0.0 else 1
        uses.compare("rate of a slave", abs(state.acceleration), order.rates[side])
        if abs(state.acceleration) < order.rates[side] * (1.0 - SLACK):
            words = f"its rate while ramping to its ratio is {abs(state.acceleration):g} counts/s²"
            where = f"axis {a.index} at {time:.6f} s"
            proof.breaks(order.line, f"{where}: {words}, commanded {order.rates[side]:g}")
            return
    uses.report(order.line, f"axis {a.index} from {a.starts[i]:.6f} s", " counts")


def _moments(a: Axis, master: Axis, begin: float, end: float) -> list[float]:
    """Return the ends of stretches on which master and slave have a single piece each.

    For the first stretches four times in between are added.
    """
    knots = {begin, end}
    for track in (a, master):
        k = track.index_at(begin)
        while k < len(track.starts) and track.starts[k] < end:
            knots.update(t for t in (track.starts[k] + x for x in track.profiles[k].knots) if begin < t < end)
            k += 1
    ordered = sorted(t for t in knots if isfinite(t))
    inside = [x + share * (y - x) for x, y in list(pairwise(ordered))[:MANY] for share in FOUR]
    return sorted((*ordered[1:], *inside))


def _check_table(proof: Proof, run: RunRecords, a: Axis, i: int, order: Order, curve: Profile) -> None:
    """Check that the curve passes through its table.

    In between it is straight, or has a linearly changing slope.
    """
    tie = order.tie
    assert tie is not None
    assert tie.table is not None
    positions, values, kind = tie.table
    where = f"axis {a.index} from {a.starts[i]:.6f} s"
    first = _on(curve, 0.0)
    size = SLACK * max(1.0, *(abs(value) for value in values))
    for along, value in zip(positions, values, strict=True):
        travelled, wanted = _on(curve, along) - first, value - values[0]
        if abs(travelled - wanted) > size:
            proof.breaks(
                order.line,
                f"{where}: its curve has {travelled:g} at {along:g} of its master, commanded {wanted:g}",
            )
            return
    if abs(curve.end - curve.start - values[-1] + values[0]) > size:
        words = f"its curve rises by {curve.end - curve.start:g}, commanded {values[-1] - values[0]:g}"
        proof.breaks(order.line, f"{where}: {words}")
    if curve.duration != positions[-1]:
        proof.breaks(
            order.line, f"{where}: its curve is {curve.duration:g} long, commanded {positions[-1]:g}"
        )
    slopes = [derivatives(curve.pieces[0], 0.0)[1]]
    slopes.append(derivatives(curve.pieces[-1], curve.knots[-1] - curve.knots[-2])[1])
    for stated, slope in zip((curve.start_velocity, curve.end_velocity), slopes, strict=True):
        if abs(stated - slope) * positions[-1] > size:
            words = f"its curve has a slope of {slope:g} at one end, and is run on at {stated:g}"
            proof.breaks(order.line, f"{where}: {words}")
    for (left, right), (low, high) in zip(pairwise(positions), pairwise(values), strict=True):
        if (
            kind == "linear"
            and abs(_on(curve, 0.5 * (left + right)) - first - 0.5 * (low + high) + values[0]) > size
        ):
            proof.breaks(
                order.line, f"{where}: its curve is not straight from {left:g} to {right:g} of its master"
            )
            return
    if kind == "even":
        _check_segment(proof, run, a, i, order, curve)


def _check_segment(proof: Proof, run: RunRecords, a: Axis, i: int, order: Order, curve: Profile) -> None:
    """Check a flying shear's ratio: linear, from the previous ratio or 0."""
    tie = order.tie
    assert tie is not None
    before = run.expected_motion.of[a.index][i - 1].tie if i else None
    begins, bends = derivatives(curve.pieces[0], 0.0)[1], curve.drawn[1][0][3]
    wanted = 0.0
    if before is not None and before.curve is not None and before.table is not None:
        last = before.curve
        if before.table == tie.table and (before.origin == tie.origin or last.start == curve.start):
            return  # the same segment, checked again
        on = before.master is tie.master and before.direction == tie.direction
        if on and before.table[2] == "even":
            wanted = derivatives(last.pieces[-1], last.knots[-1] - last.knots[-2])[1]
    if abs(begins - wanted) > SLACK * max(1.0, abs(wanted)) or bends or len(curve.pieces) != 1:
        where = f"axis {a.index} from {a.starts[i]:.6f} s"
        proof.breaks(order.line, f"{where}: its segment begins at a ratio of {begins:g}, expected {wanted:g}")


def _wanted(tie: Tie, curve: Profile, along: float) -> float:
    """Return the slave's position on its curve; linear tables use the table's numbers."""
    if tie.table is None or tie.table[2] != "linear":
        return _on(curve, along)
    positions, values, _ = tie.table
    k = min(max(bisect_right(positions, along) - 1, 0), len(positions) - 2)
    slope = (values[k + 1] - values[k]) / (positions[k + 1] - positions[k])
    return values[k] + slope * (along - positions[k])


def check_points(proof: Proof, a: Axis, i: int, order: Order) -> None:
    """Check that a profile through points has the given position and velocity at each.

    Between two points it is one cubic.
    """
    assert order.points is not None
    points, velocities, times = order.points
    profile, where = a.profiles[i], f"axis {a.index} from {a.starts[i]:.6f} s"
    ends = abs(profile.end - points[-1]) <= SLACK * max(1.0, abs(points[-1]))
    if isfinite(profile.duration) and not ends:
        proof.breaks(order.line, f"{where}: it ends at {profile.end:g}, commanded {points[-1]:g}")
    if not profile.pieced or abs(profile.duration - fsum(times)) > SLACK:
        return  # it is suspended, or stops in between
    if len(profile.pieces) != len(times):
        proof.breaks(order.line, f"{where}: it has {len(profile.pieces)} segments, commanded {len(times)}")
        return
    size = max(1.0, *(abs(point) for point in points))
    fast = max(1.0, *(abs(velocity) for velocity in velocities))
    for k, (piece, time) in enumerate(zip(profile.pieces, times, strict=True)):
        for at, n in ((0.0, k), (time, k + 1)):
            reached, speed, _, _ = derivatives(piece, at)
            if abs(reached - points[n]) > SLACK * size or abs(speed - velocities[n]) > SLACK * fast:
                words = f"point {n} is {points[n]:g} at {velocities[n]:g} counts/s"
                proof.breaks(order.line, f"{where}: {words}, it is at {reached:g} at {speed:g} counts/s")
                return


def _on(curve: Profile, along: float) -> float:
    """Return the value of a curve at a distance, extrapolated linearly at its ends."""
    knots = curve.knots
    x = min(max(along, 0.0), knots[-1])
    k = max(0, min(bisect_right(knots, x), len(curve.pieces)) - 1)
    p, slope, _, _ = derivatives(curve.pieces[k], x - knots[k])
    return p + slope * (along - x)


def _offset(run: RunRecords, a: Axis, time: float) -> float:
    offsets = run.offsets.get(a.index)
    return 0.0 if offsets is None else offsets.travelled(time)


def _offset_moves(run: RunRecords, a: Axis, time: float) -> bool:
    offsets = run.offsets.get(a.index)
    return offsets is not None and offsets.is_active_at(time)
