"""Bounds along one path: its speed and rates, and the limits of its axes.

Each check has the order of the path, its layout and its segments of motion, and knows nothing of the run around it.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import inf, isfinite

from motionlang.kernel.planners import Profile
from tests.proof.checker import SLACK, BoundUses, Proof
from tests.proof.order import Order
from tests.proof.path_layout import PathLayout
from tests.proof.segments import Span, combined, spans
from tests.proof.stretches import Stretch, stopping_distance, stretches, unavoidable_speed

# Fraction of the clock's time that distinguishes one path from the next.
ROUNDED = 1e-12


def spans_along(rows: Sequence[tuple[Profile, float]], layout: PathLayout, length: float) -> list[Span]:
    """Return the distance along the path over time, from the profiles in force.

    Empty if it cannot be determined.
    """
    found: list[Span] = []
    covered = 0.0
    while length > 0.0:
        profiles = [_profile_at(profile, begin + covered) for profile, begin in rows]
        span = min(length, *(left for _, _, left in profiles))
        some = _spans_along([(profile, at) for profile, at, _ in profiles], layout, span)
        if some is None:
            return []
        offset = found[-1].begin + found[-1].length if found else 0.0
        for each in some:
            each.begin += offset
        found += some
        covered, length = covered + span, length - span
        if span <= 0.0 or not isfinite(length):
            break
    return found


def _profile_at(profile: Profile, time: float) -> tuple[Profile, float, float]:
    """Return the profile of a sequence that is in force at a time.

    Also return for how long it has been in force, and for how long it will be, s.
    """
    profiles = getattr(profile, "segments", None)
    if profiles is None:
        left = profile.duration - time
        return profile, time, left if left > 0.0 else inf
    for begin, each in zip(profile.begins, profiles, strict=True):  # type: ignore[attr-defined]
        if time < begin + each.duration:
            return _profile_at(each, time - begin)
    return profiles[-1], time - profile.begins[-1], inf  # type: ignore[attr-defined]


def _spans_along(
    profiles: Sequence[tuple[Profile, float]], layout: PathLayout, length: float
) -> list[Span] | None:
    for profile, begin in profiles:
        travelled = getattr(profile, "along", None)
        if travelled is not None:
            return spans(travelled, begin, length) if travelled.pieced else None
    if not all(profile.pieced for profile, _ in profiles):
        return None
    if layout.unit is None:  # an arc whose axes are all linear is none, or at rest
        return []
    # Axes that the path moves: a path with a length and no distance (user defined) moves none.
    moving = [
        (spans(profile, begin, length), u / k / layout.stretch)
        for (profile, begin), u, k in zip(profiles, layout.unit, layout.path.scales, strict=True)
        if u
    ]
    if not moving or len({len(row) for row, _ in moving}) != 1:
        return None
    weights = [w for _, w in moving]
    return [combined([row[n] for row, _ in moving], weights, layout.origin) for n in range(len(moving[0][0]))]


def could_stop(order: Order, layout: PathLayout, along: list[Span]) -> bool:
    """True if a path certainly has room for a stop by an order; on arcs this is not known."""
    path = order.path
    assert path is not None
    slopes = zip(layout.slopes(0.0, layout.length), path.scales, path.most_decel, strict=True)
    hardest = min((limit / (slope * abs(k)) for slope, k, limit in slopes if slope), default=inf)
    order = order._replace(rates=(order.rates[0], min(order.rates[1], hardest)))
    travelled, v0, a0, _ = along[0].at(0.0)
    room = (layout.length - travelled) * (1.0 - SLACK)
    return layout.unit is not None and stopping_distance(order, v0, a0) < room


def check_along(
    proof: Proof,
    order: Order,
    plan: Order,
    layout: PathLayout,
    along: list[Span],
    where: str,
    fresh: bool = False,
) -> None:
    """Check the bounds along a path; a `fresh` path may not begin above them.

    `plan` is the order with the rates of the plans that it may continue. A path that comes to rest on itself may only
    slow down.
    """
    path = order.path
    assert path is not None
    smooth, late = plan.jerks[0] < inf, ROUNDED * (1.0 + path.begun)
    _, v0, a0, _ = along[0].at(0.0)
    came, carried = unavoidable_speed(order, v0, a0), abs(a0) if plan.bends else 0.0
    most = 0.0 if path.comes_to_rest and not path.leads_on else order.speed
    still = SLACK * max(1.0, v0)
    # A stop that would pass its rest, because the jerk was lowered, reduces its deceleration to zero there.
    stops = path.comes_to_rest or plan is not order
    least_jerk = 0.5 * a0 * a0 / v0 if smooth and stops and a0 < 0.0 < v0 else 0.0
    uses = BoundUses(proof)
    for each in stretches(along, not fresh):
        if each.length <= late:  # the time of a join is rounded
            continue
        back = min(each.left[1], each.right[1])
        if back < -still:
            proof.breaks(order.line, f"{where}: it runs back along the path, at {-back:g}")
            return
        if each.speed > still or most:  # at rest within rounding
            uses.compare("path speed", each.speed, max(most, came if each.slows else 0.0))
        if each.speed <= still:
            continue
        name, eased = ("path acceleration", "path deceleration")[each.side], carried if each.eases else 0.0
        uses.compare(name, each.rate, max(plan.rates[each.side], eased))
        if smooth:
            # Rounding at the end of a ramp does not show its side.
            jerk = plan.jerks[each.side] if each.rate > SLACK * max(plan.rates) else max(plan.jerks)
            uses.compare("path jerk", each.jerk, max(jerk, least_jerk))
        _check_axes(uses, plan, layout, each, eased)
    uses.report(order.line, where, "")
    # At the end of a profile, rounding may add a moment of the next one.
    whole = along[:-1] if along[-1].length <= late else along
    _check_joins(proof, plan, whole, v0, where)


def _check_axes(uses: BoundUses, order: Order, layout: PathLayout, stretch: Stretch, eased: float) -> None:
    """Check the limits of each axis on a stretch of its path.

    A path that slows down because it began above them has no speed limit yet, nor one of its curvature. `eased` is the
    acceleration along it with which it began.
    """
    path = order.path
    assert path is not None
    ends, speed = (stretch.left[0], stretch.right[0]), 0.0 if stretch.slows else stretch.speed
    scales = [abs(k) for k in path.scales]
    for number, k, slope, most in zip(path.members, scales, layout.slopes(*ends), path.most, strict=True):
        uses.compare(f"speed on paths of axis {number}", speed * slope * k, most)
    limits = path.most_decel if stretch.side else path.most_accel
    rates, taken_over = layout.rates(*ends, stretch.rate, speed), layout.rates(*ends, eased, 0.0)
    for number, k, rate, most, other in zip(path.members, scales, rates, limits, taken_over, strict=True):
        uses.compare(f"rate on paths of axis {number}", rate * k, max(most, other * k))


def _check_joins(proof: Proof, order: Order, along: list[Span], came: float, where: str) -> None:
    """Check that the speed along a path is continuous.

    Its acceleration is checked too if its jerk is limited. The time of a join is rounded, so the acceleration has
    changed by its jerk meanwhile: with one that builds it up at once, such as a jerk time of 0, it jumps.
    """
    names = ("speed", "acceleration")[: 2 if order.jerks[0] < inf else 1]
    slack = SLACK * max(1.0, came, *(r for r in (order.speed, *order.rates) if r < inf))
    for before, after in pairwise(along):
        left, right = before.at(before.length), after.at(0.0)
        side = 0 if left[2] + right[2] > 0.0 else 1
        rounded = 4e-16 * (1.0 + after.begin) * order.jerks[side]
        for which, name in enumerate(names, 1):
            gap = abs(right[which] - left[which])
            if gap > slack + (rounded if name == "acceleration" else 0.0):
                proof.breaks(order.line, f"{where}: the {name} along it jumps by {gap:g}")
