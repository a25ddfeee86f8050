"""Checks of single axes: bounds and times of motion planned from their settings."""

from __future__ import annotations

from math import copysign, inf, isfinite

from motionlang.analysis.proof.checker import SLACK, Proof, Uses
from motionlang.analysis.proof.flanks import Begin, begin, last_change
from motionlang.analysis.proof.segments import Span, derivatives, spans
from motionlang.analysis.proof.slowing import LATE, Slowing, slowing
from motionlang.analysis.proof.time_bounds import ends_together, law, lead, move_times, rounding, top_speed
from motionlang.log.order import Order
from motionlang.log.track import WholeTrack
from motionlang.planners import Profile

# Kinds that are planned from the settings of the axis, and so observe its rates.
PLANNED = frozenset({"move", "step", "jog", "stop"})


def rounded_positions(a: WholeTrack, i: int, shifted: bool, earlier: float) -> float:
    """Return the size of the positions that round the distance of profile i, counts.

    It is the largest position at which a profile has begun since the axis rested: what is left of a move from
    20 to 0 is rounded as 20 is. Each new zero rounds it once more, by the position before or after, whichever is
    larger. If `shifted`, profile i begins with a new zero. `earlier` is the size of profile i - 1.
    """
    entry = a.profiles[i].at(0.0)
    before = abs(a.profiles[i - 1].position(a.starts[i] - a.starts[i - 1])) if i else 0.0
    begins = max(before, abs(entry.position))
    if not (entry.velocity or entry.acceleration):
        return begins
    return earlier + begins if shifted else max(earlier, begins)


def check_profile(
    proof: Proof,
    a: WholeTrack,
    i: int,
    order: Order,
    earlier: Order,
    shifted: bool,
    length: float,
    size: float,
) -> None:
    """Check a profile planned from the settings, and the continuity of its pieces.

    The bounds are speed, rates, jerk and time. If `shifted`, the profile is a copy of the previous one at a
    new zero; the previous one was planned by the order `earlier`. `size` is that of the positions
    whose rounding is in its distance (`rounded_positions`).
    """
    profile = a.profiles[i]
    proof.counts["profiles"] += order.kind != "rest"
    _check_edges(proof, a, i, order)
    if not profile.pieced or order.kind == "rest":
        return
    segments = spans(profile, 0.0, min(length, 1e300))
    _check_knots(proof, a, i, order, segments, _completes_trapezoid(order, earlier))
    if order.kind not in PLANNED:
        return
    # An axis that comes in too fast, or with too much acceleration, is excused until it has slowed down.
    begun = begin(a, i, order, earlier, shifted)
    slow = _slowing(profile, order, begun)
    still = SLACK * max(1.0, abs(profile.start_velocity), order.speed if order.speed < inf else 0.0)
    uses = Uses(proof)
    eased = abs(begun.acceleration_before)
    for span in slow.cuts(segments):
        middle = span.begin + 0.5 * span.length
        uses.compare("speed", span.peak(1), slow.bound(middle))
        sides = list(span.sides())
        for power, left, right in sides:
            side = 0 if power > 0.0 else 1
            rate, jerk = order.rates[side], order.jerks[side]
            if max(abs(left[1]), abs(right[1])) <= still:  # at rest within rounding
                rate = max(order.rates)
            if len(sides) > 1:  # a motion that reverses eases out at the jerk that it began with
                jerk = max(order.jerks)
            name = ("acceleration", "deceleration")[side]
            steep = max(abs(left[3]), abs(right[3]))
            # As the ends of the span are, and the velocities there.
            rounded = 4e-16 * (
                (span.begin + span.length) * steep + max(abs(left[1]), abs(right[1])) / span.length
            )
            bound = max(rate, eased if middle < slow.eased else 0.0) + rounded
            uses.compare(name, max(abs(left[2]), abs(right[2])), bound)
            if order.jerks[0] < inf:
                uses.compare("jerk", steep, jerk)
    where = f"axis {a.index} from {a.starts[i]:.6f} s"
    uses.report(order.line, where, " counts")
    if isfinite(length):
        reached, expected = abs(profile.velocity(length)), slow.expected(length)
        if reached > expected + still + 4e-15 * (1.0 + a.starts[i]) * max(order.rates):
            words = f"it does not slow down: {reached:g} counts/s after {length:g} s, expected {expected:g}"
            proof.breaks(order.line, f"{where}: {words}")
    _check_time(proof, profile, order, begun, size, where)


def _check_time(proof: Proof, profile: Profile, order: Order, begun: Begin, size: float, where: str) -> None:
    """Check that a planned profile takes as long as its bounds require, and its end.

    This applies from any initial state. `size` is that of the positions whose rounding is in its distance.
    """
    by = law(order.shape, order.rates, order.jerks, order.ramp)
    v0, a0 = begun.velocity, begun.acceleration
    if order.kind in ("move", "step"):
        if not isfinite(profile.duration):
            return
        distance, late = _to_go(profile, order, begun)
        least, most = move_times(v0, a0, distance, order.speed, by, rounding(distance, size, profile.end))
        least, most, took = least - late, most - late, profile.duration
    else:
        least = most = lead(v0, a0, order.goal, by)[0]
        if not order.goal:
            least = min(least, ends_together(v0, a0, by))
        took = last_change(profile)
        if abs(profile.end_velocity - order.goal) > SLACK * max(1.0, abs(order.goal)):
            words = f"it reaches {profile.end_velocity:g} counts/s, commanded {order.goal:g}"
            proof.breaks(order.line, f"{where}: {words}")
    least, most = least + begun.time, most + begun.time
    if begun.left is not None:  # it may continue as planned
        least, most = min(least, begun.left), max(most, begun.left)
    least = min(least, begun.planned)
    slack = 1e-9 + 4e-16 * abs(profile.start)
    if took > most * (1.0 + SLACK) + slack:
        proof.breaks(order.line, f"{where}: it takes {took:g} s, expected at most {most:g} s")
    elif took < least * (1.0 - SLACK) - slack:
        proof.breaks(order.line, f"{where}: it takes {took:g} s, expected at least {least:g} s")


def _to_go(profile: Profile, order: Order, begun: Begin) -> tuple[float, float]:
    """Return the distance of a move after its initial flank, and a stepper's gain, s.

    A stepper stops at once at the velocity of its step, as if it came to rest that much later and farther on.
    """
    late = order.step / order.rates[1]
    return profile.distance + copysign(0.5 * order.step * late, profile.distance) - begun.distance, late


def _slowing(profile: Profile, order: Order, begun: Begin) -> Slowing:
    """Return how a profile that begins too fast reaches its speed.

    If the distance does not suffice for this and a stop, the speed is higher.
    """
    by = law(order.shape, order.rates, order.jerks, order.ramp)
    v0, a0, speed = begun.velocity, begun.acceleration, order.speed
    if order.kind in ("move", "step") and isfinite(profile.duration):
        speed = max(speed, top_speed(v0, a0, _to_go(profile, order, begun)[0], speed, by))
    if order.jerks[0] < inf or not begun.acceleration_before:
        return slowing(v0, a0, speed, by)
    slow = slowing(v0, a0, speed, by, begun.time)
    over = max(begun.time, begun.left or 0.0) * (1.0 + SLACK) + LATE
    came, until = max(slow.came, begun.came), max(slow.until, over if begun.came > speed else 0.0)
    return slow._replace(came=came, until=until, eased=over)


def _check_edges(proof: Proof, a: WholeTrack, i: int, order: Order) -> None:
    """Check that a profile begins and ends like its pieces, which checks of joins use."""
    profile = a.profiles[i]
    duration = profile.duration
    if not isfinite(duration) or not duration:
        return
    if profile.pieced:
        first, speed = derivatives(profile.pieces[0], 0.0)[:2]
        last = derivatives(profile.pieces[-1], profile.knots[-1] - profile.knots[-2])[0]
    else:  # just before its end, on its last piece
        early = min(1e-9 * duration, 0.5 * (profile.knots[-1] - profile.knots[-2]))
        state = profile.at(duration - early)
        first, speed = profile.at(0.0).position, state.velocity
        last = state.position + early * (speed + 0.5 * early * state.acceleration)
    size = SLACK * max(1.0, abs(profile.start), abs(profile.end))
    late = 4e-16 * (1.0 + a.starts[i] + duration)
    for name, stated, done in (("begins", profile.start, first), ("ends", profile.end, last)):
        if abs(stated - done) > size + 4.0 * late * abs(speed):
            where = f"axis {a.index} from {a.starts[i]:.6f} s"
            proof.breaks(order.line, f"{where}: it {name} at {stated:g}, its pieces at {done:g}")


def _completes_trapezoid(order: Order, earlier: Order) -> bool:
    """True if a path resumed by another shape first completes a trapezoidal stop."""
    path, before = order.path, earlier.path
    if path is None or before is None or before.entry != path.entry:
        return False
    return before.comes_to_rest and not path.comes_to_rest and not earlier.bends


def _check_knots(
    proof: Proof, a: WholeTrack, i: int, order: Order, segments: list[Span], completes_trapezoid: bool = False
) -> None:
    """Check continuity of pieces: position, planned velocity, S-ramp acceleration.

    If it `completes_trapezoid`, the acceleration may jump up to the first standstill.
    """
    profile = a.profiles[i]
    names = ("position", "velocity", "acceleration")[
        : 1 if order.kind not in (*PLANNED, "path") else 3 if order.bends and profile.shape != "blend" else 2
    ]
    sizes = [max(1.0, abs(profile.start))]
    # A ramp between velocities that differ by rounding takes no time, whatever its rate: its change of
    # velocity counts.
    if not segments:
        return
    left, changed = segments[0], [0.0, 0.0, 0.0]
    steepest = max((jerk for jerk in order.jerks if jerk < inf), default=0.0)
    for right in segments[1:]:
        if right.length <= 4e-16 * (1.0 + a.starts[i] + right.begin):
            first, last = right.at(0.0), right.at(right.length)
            changed = [before + abs(y - x) for before, x, y in zip(changed, first, last, strict=False)]
            continue
        before, after = left.at(left.length), right.at(0.0)
        if len(sizes) == 1:
            rate = _counts(a, order) * max((r for r in order.rates if r < inf), default=0.0)
            sizes += [max(1.0, profile.peak_speed), max(1.0, rate)]
        late = 4e-16 * (1.0 + a.starts[i] + right.begin)
        slopes = (abs(before[1]), abs(before[2]), max(abs(before[3]), steepest))
        for which, name in enumerate(names[: 2 if completes_trapezoid else 3]):
            gap = abs(after[which] - before[which])
            if gap > SLACK * sizes[which] + 4.0 * late * slopes[which] + changed[which]:
                where = f"axis {a.index} at {a.starts[i] + right.begin:.6f} s"
                proof.breaks(order.line, f"{where}: the {name} jumps by {gap:g} counts within a profile")
        left, changed = right, [0.0, 0.0, 0.0]
        completes_trapezoid = completes_trapezoid and abs(after[1]) > SLACK * sizes[1]


def _counts(a: WholeTrack, order: Order) -> float:
    """Return the counts per unit of the rates; the rates of a path are in user units."""
    path = order.path
    return 1.0 if path is None else abs(path.scales[path.members.index(a.index)])
