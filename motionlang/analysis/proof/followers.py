"""Checks of following: slaves against masters, curves and splines against tables."""

from __future__ import annotations

from bisect import bisect_right
from itertools import pairwise
from math import fsum, isfinite, sqrt

from motionlang.analysis.proof.axes import PLANNED
from motionlang.analysis.proof.checker import SLACK, Proof, Run, Uses, position
from motionlang.analysis.proof.flanks import last_change
from motionlang.analysis.proof.segments import Span, derivatives
from motionlang.log.order import Order, Tie
from motionlang.log.track import WholeTrack
from motionlang.planners import Profile

Slopes = tuple[tuple[float, float, float], tuple[float, float, float]]

# Fractions of a segment at which two motions are compared: two cubics that agree at four of them are equal.
FOUR = (0.05, 0.35, 0.65, 0.95)
# Stretches, beyond which only the ends of each are compared.
MANY = 24


def check_tie(proof: Proof, run: Run, a: WholeTrack, i: int, order: Order, end: float) -> None:
    """Check that the position of a slave matches its ratio or table.

    Until it has caught up, it accelerates at its rates.
    """
    tie = order.tie
    assert tie is not None
    track, begin = run.track(tie.master), a.starts[i]
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


def _check_chase(proof: Proof, run: Run, a: WholeTrack, i: int, order: Order, end: float) -> None:
    """Check that a slave changes velocity at its rates until it reaches the ratio's."""
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
        uses.compare("rate of a slave", abs(state.acceleration), order.rates[side])
        if abs(state.acceleration) < order.rates[side] * (1.0 - SLACK):
            words = f"its rate while ramping to its ratio is {abs(state.acceleration):g} counts/s²"
            where = f"axis {a.index} at {time:.6f} s"
            proof.breaks(order.line, f"{where}: {words}, commanded {order.rates[side]:g}")
            return
    uses.report(order.line, f"axis {a.index} from {a.starts[i]:.6f} s", " counts")


def _moments(a: WholeTrack, master: WholeTrack, begin: float, end: float) -> list[float]:
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


def _check_table(proof: Proof, run: Run, a: WholeTrack, i: int, order: Order, curve: Profile) -> None:
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


def _check_segment(proof: Proof, run: Run, a: WholeTrack, i: int, order: Order, curve: Profile) -> None:
    """Check a flying shear's ratio: linear, from the previous ratio or 0."""
    tie = order.tie
    assert tie is not None
    before = run.expected_motion.of[a.index][i - 1].tie if i else None
    begins, bends = derivatives(curve.pieces[0], 0.0)[1], curve.pieces[0][3]
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


def check_points(proof: Proof, a: WholeTrack, i: int, order: Order) -> None:
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


def check_reference(proof: Proof, run: Run, a: WholeTrack, i: int, order: Order, shifted: bool) -> None:
    """Check that a reference ends at its position, or reaches its speed in its time.

    A speed is reached by its slopes. If `shifted`, the profile is a copy of the previous one at a new zero.
    """
    profile, where = a.profiles[i], f"axis {a.index} from {a.starts[i]:.6f} s"
    if order.slopes is None:
        if abs(profile.end - order.goal) > SLACK * max(1.0, abs(order.goal)):
            proof.breaks(order.line, f"{where}: it ends at {profile.end:g}, commanded {order.goal:g}")
        return
    if not profile.pieced:
        return
    entry, endless = profile.at(0.0), not isfinite(profile.duration)
    if endless and not order.goal:
        proof.breaks(order.line, f"{where}: it never reaches its end")
    uses = Uses(proof)
    a0 = _carried(run, a, i, order)
    fading = _fading(entry.velocity, a0, order.slopes)
    eased = abs(a0) if fading else 0.0
    came = max(abs(entry.velocity), abs(entry.velocity + 0.5 * a0 * fading))
    for piece, begin, finish in zip(profile.pieces, profile.knots, profile.knots[1:], strict=False):
        span = Span(begin, finish - begin if isfinite(finish) else 1.0, piece)
        uses.compare("speed", span.peak(1), max(order.speed, came))
        for power, left, right in span.sides():
            rate = order.rates[0 if power > 0.0 else 1] if abs(power) > SLACK else max(order.rates)
            uses.compare("rate of a reference", max(abs(left[2]), abs(right[2])), max(rate, eased))
    uses.report(order.line, where, " counts")
    took = profile.knots[-2] if endless else profile.knots[-1]
    if shifted and order == run.expected_motion.of[a.index][i - 1]:
        before = a.profiles[i - 1]
        wanted = max(0.0, last_change(before) - (a.starts[i] - a.starts[i - 1]))
    else:
        wanted = _reference_time(entry.velocity, a0, order.goal, order.slopes)
    if abs(took - wanted) > wanted * SLACK + 1e-9:
        proof.breaks(order.line, f"{where}: it takes {took:g} s, expected {wanted:g} s")
    if abs(profile.end_velocity - order.goal) > SLACK * max(1.0, abs(order.goal)):
        words = f"it reaches {profile.end_velocity:g} counts/s, commanded {order.goal:g}"
        proof.breaks(order.line, f"{where}: {words}")


def _carried(run: Run, a: WholeTrack, i: int, order: Order) -> float:
    """Return the initial acceleration of a reference's profile i, carried over.

    It comes from the previous profile. A profile may begin with another acceleration if a slope has no edge.
    After a table, a master or another reference, at most the rate of its slope is carried over.
    """
    before, elapsed = a.profiles[i - 1], a.starts[i] - a.starts[i - 1]
    if not i or elapsed >= last_change(before):
        return 0.0
    state, kind = before.at(elapsed), run.expected_motion.of[a.index][i - 1].kind
    if kind in (*PLANNED, "rest", "path") or a.starts[i] not in run.expected_motion.begun[a.index]:
        return state.acceleration
    rate = order.rates[0 if state.acceleration * state.velocity >= 0.0 else 1]
    return max(-rate, min(state.acceleration, rate))


def _fading(v0: float, a0: float, slopes: Slopes) -> float:
    """Return how long an acceleration takes to ramp down, s; 0 without an edge."""
    rate, _, end = slopes[0 if a0 * v0 >= 0.0 else 1]
    return abs(a0) * end / rate


def _reference_time(v0: float, a0: float, v1: float, slopes: Slopes) -> float:
    """Return the time between two velocities; an initial acceleration decays first."""
    up, down = slopes
    fading = _fading(v0, a0, slopes)
    if fading:
        return fading + _reference_time(v0 + 0.5 * a0 * fading, 0.0, v1, slopes)
    if v0 * v1 < 0.0:
        return _slope_time(abs(v0), down) + _slope_time(abs(v1), up)
    return _slope_time(abs(v1 - v0), down if abs(v1) < abs(v0) else up)


def _slope_time(change: float, slope: tuple[float, float, float]) -> float:
    """Return the time of a change of speed, s: T = dv/A + (T_begin + T_end)/2.

    If the change is too small to reach the rate, the two edges meet earlier.
    """
    rate, begin, end = slope
    edges = begin + end
    return change / rate + 0.5 * edges if 2.0 * change >= rate * edges else sqrt(2.0 * change * edges / rate)


def _on(curve: Profile, along: float) -> float:
    """Return the value of a curve at a distance, extrapolated linearly at its ends."""
    knots = curve.knots
    x = min(max(along, 0.0), knots[-1])
    k = max(0, min(bisect_right(knots, x), len(curve.pieces)) - 1)
    p, slope, _, _ = derivatives(curve.pieces[k], x - knots[k])
    return p + slope * (along - x)


def _offset(run: Run, a: WholeTrack, time: float) -> float:
    """Return the total of superposed offsets at a time."""
    offsets = run.offsets.get(a.index)
    return 0.0 if offsets is None else offsets.travelled(time)


def _offset_moves(run: Run, a: WholeTrack, time: float) -> bool:
    offsets = run.offsets.get(a.index)
    return offsets is not None and offsets.is_active_at(time)
