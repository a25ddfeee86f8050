"""Checks of single axes: bounds and ends of motion planned from their settings."""

from __future__ import annotations

from math import inf, isfinite

from motionlang.kernel import Axis
from tests.proof.checker import SLACK, BoundUses, Proof
from tests.proof.order import Order
from tests.proof.segments import Span, derivatives, spans
from tests.proof.stretches import stretches, unavoidable_speed

# Kinds that are planned from the settings of the axis, and so observe its rates.
PLANNED = frozenset({"move", "step", "jog", "stop"})


def check_profile(proof: Proof, a: Axis, i: int, order: Order, earlier: Order, length: float) -> None:
    """Check a profile planned from the settings, and the continuity of its pieces.

    The bounds are speed, rates and jerk. The previous profile was planned by the order `earlier`.
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
    where = f"axis {a.index} from {a.starts[i]:.6f} s"
    check_bounds(proof, order, segments, taken_over(a, i), where)
    if order.kind in ("move", "step"):
        if not isfinite(profile.duration):
            proof.breaks(order.line, f"{where}: it never reaches its end")
    elif abs(profile.end_velocity - order.goal) > SLACK * max(1.0, abs(order.goal)):
        words = f"it reaches {profile.end_velocity:g} counts/s, commanded {order.goal:g}"
        proof.breaks(order.line, f"{where}: {words}")


def check_bounds(
    proof: Proof, order: Order, segments: list[Span], entry: tuple[float, float], where: str
) -> None:
    """Check speed, rates and jerk of a motion that takes over a velocity and an acceleration."""
    came, carried = unavoidable_speed(order, *entry), abs(entry[1]) if order.bends else 0.0
    still = SLACK * max(1.0, abs(entry[0]), order.speed if order.speed < inf else 0.0)
    uses = BoundUses(proof)
    for each in stretches(segments):
        speed = each.speed
        uses.compare("speed", speed, max(order.speed, came if each.slows else 0.0))
        # At rest within rounding, the side is not known.
        rate = max(order.rates) if speed <= still else order.rates[each.side]
        # As the ends of the stretch are, and the velocities there.
        end = each.begin + each.length
        rounded = 4e-16 * (end * each.jerk + speed / each.length) if each.length else inf
        name = ("acceleration", "deceleration")[each.side]
        uses.compare(name, each.rate, max(rate, carried if each.eases else 0.0) + rounded)
        if order.jerks[0] < inf:
            # A motion that reverses eases out at the jerk that it began with.
            jerk = max(order.jerks) if each.reverses else order.jerks[each.side]
            uses.compare("jerk", each.jerk, jerk)
    uses.report(order.line, where, " counts")


def taken_over(a: Axis, i: int) -> tuple[float, float]:
    """Return the velocity and the acceleration that profile i takes over from the one before."""
    entry = a.profiles[i].at(0.0)
    before = a.profiles[i - 1].at(a.starts[i] - a.starts[i - 1]).acceleration if i else 0.0
    carried = min(entry.acceleration, before, key=abs) if entry.acceleration * before > 0.0 else 0.0
    return entry.velocity, carried


def _check_edges(proof: Proof, a: Axis, i: int, order: Order) -> None:
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
    proof: Proof, a: Axis, i: int, order: Order, segments: list[Span], completes_trapezoid: bool = False
) -> None:
    """Check continuity of pieces: position, planned velocity, S-ramp acceleration.

    If it `completes_trapezoid`, the acceleration may jump up to the first standstill.
    """
    profile = a.profiles[i]
    is_planned = order.kind in (*PLANNED, "path")
    bends = order.bends
    names = ("position", "velocity", "acceleration")[: 1 + is_planned + (is_planned and bends)]
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


def _counts(a: Axis, order: Order) -> float:
    """Return the counts per unit of the rates; the rates of a path are in user units."""
    path = order.path
    return 1.0 if path is None else abs(path.scales[path.members.index(a.index)])
