"""Bounds along one path: its speed and rates, limits of its axes, its time.

Each check has the order of the path, its layout and its segments of motion, and knows nothing of the run around it.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import cbrt, fsum, inf, isfinite, sqrt

from motionlang.analysis.proof.checker import SLACK, Proof, Uses
from motionlang.analysis.proof.path_layout import PathLayout
from motionlang.analysis.proof.segments import Span, combined, spans
from motionlang.analysis.proof.slowing import Slowing, slowing
from motionlang.analysis.proof.time_bounds import (
    Law,
    law,
    lead,
    move_time,
    move_times,
    ramp,
    reverses,
    rounding,
    top_speed,
)
from motionlang.log.order import Order, PathOrder
from motionlang.planners import Profile

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


def until_rest(along: list[Span]) -> tuple[list[Span], list[Span]]:
    """Return the segments up to the first standstill, and those after it."""
    for k, span in enumerate(along):
        if abs(span.at(span.length)[1]) <= SLACK * max(1.0, along[0].at(0.0)[1]):
            return along[: k + 1], along[k + 1 :]
    return along, []


def least_bounds(order: Order, layout: PathLayout) -> tuple[float, Law]:
    """Return the speed and law that are always allowed on a path by its axes' limits.

    On arcs the limits of an axis are shared equally between the change of direction and the change of speed.
    """
    path = order.path
    assert path is not None
    speed, rates = order.speed, list(order.rates)
    shares = [1.0] * len(path.members)
    for index, figure, share in layout.turning():
        shares[index] = share
        speed = min(speed, sqrt(share * min(path.most_accel[index], path.most_decel[index]) / figure))
    slopes = layout.slopes(0.0, layout.length)
    for slope, k, share, most, up, down in zip(
        slopes, path.scales, shares, path.most, path.most_accel, path.most_decel, strict=True
    ):
        steep = slope * abs(k)
        if steep:
            speed = min(speed, most / steep)
            rates = [min(rates[0], share * up / steep), min(rates[1], share * down / steep)]
    return speed, law(order.shape, (rates[0], rates[1]), order.jerks, order.ramp)


def gentlest_stop(order: Order, layout: PathLayout, rate: float) -> float:
    """Return the lowest deceleration of a stop on a path and its possible successors."""
    assert order.path is not None
    for each in order.path.ahead:
        assert each.path is not None
        layout = PathLayout(each.path, layout.ends)
        rate = min(rate, least_bounds(each, layout)[1].rates[1])
    return rate


def _hardest(path: PathOrder, layout: PathLayout) -> float:
    """Return the highest deceleration along a path within its axes' limits.

    Centripetal acceleration does not count.
    """
    slopes = zip(layout.slopes(0.0, layout.length), path.scales, path.most_decel, strict=True)
    return min((limit / (slope * abs(k)) for slope, k, limit in slopes if slope), default=inf)


def cannot_stop(order: Order, layout: PathLayout, along: list[Span], beyond: float) -> bool:
    """True if a path could not stop before its end by its rates.

    Also true if its deceleration could not be reduced to zero before it comes to rest.
    """
    travelled, v0, a0, _ = along[0].at(0.0)
    by = least_bounds(order, layout)[1]
    left = layout.length - travelled + beyond
    if reverses(v0, a0, by, -SLACK):
        return True
    return by.rates[1] > 0.0 and lead(v0, a0 if by.smooth else 0.0, 0.0, by)[1] > left * (1.0 + SLACK)


def enters_too_fast(order: Order, layout: PathLayout, along: list[Span]) -> bool:
    """True if a stop by the present rates would enter the next path above its speed.

    In that case the path continues as planned, and the stop begins on the next path.
    """
    assert order.path is not None
    travelled, v0, a0, _ = along[0].at(0.0)
    by, left, before = least_bounds(order, layout)[1], layout.length - travelled, layout
    a = a0 if by.smooth else 0.0
    for each in order.path.ahead:
        assert each.path is not None
        before = PathLayout(each.path, before.ends)
        most, own = least_bounds(each, before)
        by = by._replace(rates=(by.rates[0], min(by.rates[1], own.rates[1])))
        peak = v0 + 0.5 * a * abs(a) / by.jerks[0] if a > 0.0 else v0
        if peak > most and lead(v0, a, most, by)[1] > left * (1.0 - SLACK):
            return True
        left += before.length
    return False


def check_along(
    proof: Proof,
    order: Order,
    layout: PathLayout,
    along: list[Span],
    where: str,
    fresh: bool = False,
    beyond: float = 0.0,
    gentlest: float = inf,
    planned: float = 0.0,
) -> None:
    """Check the bounds along a path; after its end the axes continue for `beyond`.

    A `fresh` path may not begin above its bounds. A stop that began earlier may have a deceleration down to
    `gentlest`, and a path that was planned earlier the speed `planned`.
    """
    path = order.path
    assert path is not None
    smooth = order.jerks[0] < inf
    travelled, v0, a0, _ = along[0].at(0.0)
    slow = path_slowing(order, layout, v0, a0, layout.length - travelled + beyond, gentlest)
    slow = slow._replace(speed=max(slow.speed, planned))
    speed, rates, slow, carried = _permitted(order, layout, slow, fresh)
    # A stop that would pass its rest, because the jerk was lowered, reduces its deceleration to zero there.
    least_jerk = 0.5 * a0 * a0 / v0 if smooth and path.comes_to_rest and a0 < 0.0 < v0 else 0.0
    uses = Uses(proof)
    axes = list(zip(path.members, [abs(k) for k in path.scales], strict=True))
    late = ROUNDED * (1.0 + path.begun)
    # An axis that exceeds its limit in a curve has to brake for that, and both accelerations add up until it
    # has.
    braking = min(order.rates[1], _hardest(path, layout)) if layout.unit is None else 0.0
    for span in slow.cuts(along):
        if span.length <= late:  # the time of a join is rounded
            continue
        # A path that begins too fast, because a limit was lowered, is excused until it has slowed down.
        middle = span.begin + 0.5 * span.length
        excused = middle < max(slow.until, slow.eased)
        came, excused_rate = (
            (max(slow.came, carried), abs(a0) if smooth else 0.0) if excused else (carried, 0.0)
        )
        eased = excused_rate if middle < slow.eased else 0.0
        fastest, peak = 0.0 if path.comes_to_rest else max(speed, slow.speed), span.peak(1)
        if peak > SLACK or not path.comes_to_rest:  # at rest within rounding
            uses.compare("path speed", peak, max(fastest, came if middle < slow.until else 0.0))
        for power, left, right in span.sides():
            back = min(left[1], right[1])
            if back < -SLACK * max(1.0, slow.came):
                proof.breaks(order.line, f"{where}: it runs back along the path, at {-back:g}")
                return
            side = 0 if power > 0.0 else 1
            rate, fast = max(abs(left[2]), abs(right[2])), max(abs(left[1]), abs(right[1]))
            if fast <= SLACK * max(1.0, slow.came):  # at rest within rounding
                continue
            name = ("path acceleration", "path deceleration")[side]
            uses.compare(name, rate, max(rates[side], eased))
            if smooth:
                # Rounding at the end of a ramp does not show its side.
                jerk = order.jerks[side] if rate > SLACK * max(order.rates) else max(order.jerks)
                jerk = max(jerk, least_jerk)
                uses.compare("path jerk", max(abs(left[3]), abs(right[3])), jerk)
            came_with = max(excused_rate, braking) if side and excused else excused_rate
            _check_axes(uses, path, layout, axes, (left[0], right[0]), side, (fast, rate), (came, came_with))
    uses.report(order.line, where, "")
    _check_end(proof, order, along[-1], slow, late, where)
    # At the end of a profile, rounding may add a moment of the next one.
    whole = along[:-1] if along[-1].length <= late else along
    _check_joins(proof, order, whole, slow.came, where)


def _permitted(
    order: Order, layout: PathLayout, slow: Slowing, fresh: bool
) -> tuple[float, tuple[float, float], Slowing, float]:
    """Return speed and rates of a path, how it slows down, and the speed it carries."""
    speed, rates = order.speed, order.rates
    least, by = least_bounds(order, layout)
    if layout.unit is None:
        speed, rates = least, by.rates
    if fresh:
        return speed, rates, slow._replace(speed=speed, came=0.0, until=0.0, eased=0.0, stretches=()), 0.0
    return speed, rates, slow, slow.speed if slow.speed > least else 0.0  # without room to brake twice


def path_slowing(
    order: Order, layout: PathLayout, v0: float, a0: float, left: float, gentlest: float
) -> Slowing:
    """Return how a path that begins too fast slows down to its speed.

    It may be too fast for the path or for one of its axes. If the distance `left` does not suffice for this
    and a stop, the speed is higher, since two S-ramps need more distance than one.
    """
    assert order.path is not None
    speed, by = least_bounds(order, layout)
    extra = 0.0
    if a0 and order.shape != "trapezoid" and not by.smooth:
        # The flank of the ramp of PMC's S-curve, at most as long as a complete ramp to its speed.
        v0 *= 2.0
        extra = ramp(0.0, max(speed, v0), by)[0]
    if order.path.comes_to_rest:
        rate = min(gentlest, gentlest_stop(order, layout, by.rates[1]))
        speed, by = 0.0, by._replace(rates=(by.rates[0], rate))
    elif by.smooth:
        speed = max(speed, top_speed(v0, a0, left, speed, by))
    return slowing(v0, a0, speed, by, extra)


def _check_end(proof: Proof, order: Order, last: Span, slow: Slowing, late: float, where: str) -> None:
    """Check that a path that began too fast has slowed down by its end."""
    took = last.begin + last.length
    reached, expected = last.at(last.length)[1], slow.expected(took)
    if reached > expected + SLACK * max(1.0, slow.came) + 4.0 * late * max(order.rates):
        words = f"it does not slow down: {reached:g} after {took:g} s, expected {expected:g}"
        proof.breaks(order.line, f"{where}: {words}")


def _check_axes(
    uses: Uses,
    path: PathOrder,
    layout: PathLayout,
    axes: list[tuple[int, float]],
    ends: tuple[float, float],
    side: int,
    own: tuple[float, float],
    excused: tuple[float, float],
) -> None:
    """Check each axis between the `ends` of a stretch of a path.

    `own` are the speed and the acceleration along the path, `excused` those with which it began. `side` is 1
    where it slows down. `axes` have their counts per unit.
    """
    (fast, rate), (came, excused_rate) = own, excused
    slopes = layout.slopes(*ends)
    slowed = [max(x, came * s) for x, s in zip(path.most, _counts(slopes, axes), strict=True)]
    for (number, k), slope, most in zip(axes, slopes, slowed, strict=True):
        uses.compare(f"speed on paths of axis {number}", fast * slope * k, most)
    limits = path.most_decel if side else path.most_accel
    rates, came_with = layout.rates(*ends, rate, fast), layout.rates(*ends, excused_rate, came)
    for (number, k), figure, most, other in zip(axes, rates, limits, came_with, strict=True):
        uses.compare(f"rate on paths of axis {number}", figure * k, max(most, other * k))


def _counts(components: Sequence[float], axes: Sequence[tuple[int, float]]) -> list[float]:
    return [component * k for component, (_, k) in zip(components, axes, strict=True)]


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


def check_path_time(proof: Proof, order: Order, layout: PathLayout, along: list[Span], where: str) -> None:
    """Check that the last path takes no longer than a stop and a move from rest.

    That motion observes all bounds whatever follows, so a plan may only be faster.
    """
    if not order.speed or not min(order.rates) > 0.0:
        return
    first, last = along[0].at(0.0), along[-1].at(along[-1].length)
    speed, by = least_bounds(order, layout)
    a = first[2] if by.smooth else 0.0
    # The time of the gentlest stop and the distance of the hardest one: a path that begins too fast gains by
    # braking gently.
    hard = by._replace(rates=order.rates)
    time, travelled = lead(first[1], a, 0.0, by)[0], lead(first[1], a, 0.0, hard)[1]
    shaped = order.shape != "trapezoid" and not by.smooth and abs(first[2]) > SLACK * max(by.rates)
    if shaped:
        # The flank of the ramp of PMC's S-curve, which is no longer than a complete ramp to its speed.
        time += lead(2.0 * first[1], 0.0, 0.0, by)[0] + ramp(0.0, max(speed, first[1]), by)[0]
        travelled = 0.0
    rest = max(0.0, last[0] - first[0] - travelled)
    limit = time + move_time(0.0, 0.0, rest, speed, by)
    if order.shape != "trapezoid" and not by.smooth and last[2] > SLACK * max(by.rates):
        # A ramp of PMC's S-curve that goes on in the next path begins the more gently, the higher its speed. In
        # the time t of a ramp of length d and duration T it covers at least d (t/T)³.
        duration, length = ramp(0.0, speed, by)
        limit = max(limit, time + duration * min(1.0, cbrt(rest / length)))
    if layout.unit is not None and not last[1] > SLACK * speed and not shaped:
        left = last[0] - first[0]
        rounded = rounding(left, layout.origin + first[0], layout.origin + last[0])
        limit = min(limit, move_times(first[1], a, left, speed, by, rounded)[1])
    took = fsum(span.length for span in along if span.peak(1) > SLACK * speed)
    if took > limit * (1.0 + SLACK) + 1e-9:
        proof.breaks(order.line, f"{where}: it takes {took:g} s, expected at most {limit:g} s")
