"""Checks of paths: geometry, speed and its changes, limits of every axis, and end."""

from __future__ import annotations

from itertools import pairwise
from math import cbrt, fsum, inf, isfinite, nextafter, sqrt
from typing import TYPE_CHECKING

from motionlang.analysis.proof.checker import SLACK, Uses
from motionlang.analysis.proof.path_layout import PathLayout, end_positions
from motionlang.analysis.proof.segments import combined, spans
from motionlang.analysis.proof.slowing import slowing
from motionlang.analysis.proof.time_bounds import (
    law,
    lead,
    move_time,
    move_times,
    ramp,
    reverses,
    rounding,
    top_speed,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.analysis.proof.checker import Proof, Run
    from motionlang.analysis.proof.segments import Span
    from motionlang.analysis.proof.slowing import Slowing
    from motionlang.analysis.proof.time_bounds import Law
    from motionlang.controller.move import Move
    from motionlang.log.order import Order, PathOrder
    from motionlang.log.track import WholeTrack
    from motionlang.planners import Profile


# Fraction of the clock's time that distinguishes one path from the next.
ROUNDED = 1e-12


def check_path(proof: Proof, run: Run, master: WholeTrack, i: int, order: Order, end: float) -> None:
    """Check geometry, speed, acceleration and axis limits of a path for one profile."""
    path = order.path
    assert path is not None
    proof.counts["paths"] += 1
    begin = master.starts[i]
    moves = run.members(path)
    if len(moves) != len(path.members):
        proof.breaks(order.line, f"path from {begin:.6f} s: the log lacks some of its axes")
        return
    profiles = [entry.profile for entry in moves if entry.profile is not None]
    layout = PathLayout(path, run.origins(path))
    blended = run.is_blended(master, begin)
    where = f"path from {begin:.6f} s"
    tracks: list[tuple[Profile, float]] = []
    if blended:
        proof.excuses("paths blended into each other")
        along = spans_along([(profile, begin - path.begun) for profile in profiles], layout, end - begin)
    else:
        axes = [run.axes[number] for number in path.members]
        indices = [a.index_at(begin) for a in axes]
        tracks = [(a.profiles[k], begin - a.starts[k]) for a, k in zip(axes, indices, strict=True)]
        along = spans_along(tracks, layout, end - begin)
    _check_path(proof, order, layout, profiles, along, (begin - path.begun, end - begin), where)
    if along:
        first = i > 0 and begin == path.begun and run.rest_of(moves[0]) is None
        fresh = first and not blended and _speeds_up(run, order, path, master, i)
        beyond, rest = _beyond(run, moves[0]), along
        before = run.expected_motion.of[master.index][i - 1] if i else order
        plan = plan_in_force(run, master, i, order)
        if plan is not order:
            _check_along(proof, plan, layout, along, where, beyond=beyond)
            rest = []
        follows_stop = plan is order and _follows_stop(before, order, layout, along, beyond)
        if follows_stop:
            stop, rest = _until_rest(along)
            _check_along(proof, before, layout, stop, where)
        if rest:
            gentlest = _gentlest_before(run, master, i, order)
            _check_along(proof, order, layout, rest, where, fresh, beyond, gentlest)
        reached = [profile.position(end - path.begun) for profile in profiles]
        if not blended:  # the plan applies, even if something else has preceded its end
            planned = min(profile.duration - time for profile, time in tracks)
            if (
                planned == inf
                and order.speed
                and min(order.rates)
                and layout.length
                and not path.comes_to_rest
            ):
                proof.breaks(order.line, f"{where}: it never reaches its end")
            if end - begin < planned < inf:
                along = spans_along(tracks, layout, planned)
                reached = [profile.position(time + planned) for profile, time in tracks]
        if not along:
            return
        # A full circle ends where it begins.
        travelled = layout.length if layout.unit is not None else along[-1].at(along[-1].length)[0]
        if travelled >= layout.length * (1.0 - SLACK) and all(
            abs(at - last) <= SLACK * max(1.0, abs(last))
            for at, last in zip(reached, layout.ends, strict=True)
        ):
            timed = (
                _until_rest(along)[1] if follows_stop else along
            )  # a stop by earlier rates takes its own time
            if timed:
                _check_path_time(proof, plan, layout, timed, where)


def _speeds_up(run: Run, order: Order, path: PathOrder, master: WholeTrack, i: int) -> bool:
    """True if the previous path was not slowing down for one that begins too fast."""
    earlier = run.expected_motion.of[master.index][i - 1].path
    if earlier is None or earlier.comes_to_rest or earlier.members != path.members:
        return False
    begin, end = master.starts[i - 1], master.starts[i]
    entries = [(run.axes[number], k) for number, k in zip(path.members, path.scales, strict=True)]
    first, last = 0.0, 0.0
    power = 0.0
    for a, k in entries:
        n = a.index_at(begin)
        profile, length = a.profiles[n], end - a.starts[n]
        state = profile.at(min(length, nextafter(profile.duration, 0.0)))
        first += (profile.velocity(begin - a.starts[n]) / k) ** 2
        last += (state.velocity / k) ** 2
        power += state.velocity * state.acceleration / k**2
    return power >= 0.0 and first < last * (1.0 - SLACK)


def stops_within(run: Run, wanted: Order, time: float) -> bool:
    """True if a path could stop in time by an order given at `time`.

    It has to stop before its end, or before the end of the paths that it continues into, and may not run back.
    """
    path = wanted.path
    assert path is not None
    profiles = [entry.profile for entry in run.members(path) if entry.profile is not None]
    layout, elapsed = PathLayout(path, run.origins(path)), time - path.begun
    along = spans_along(
        [(profile, elapsed) for profile in profiles], layout, max(0.0, profiles[0].duration - elapsed)
    )
    if not along:
        return True
    first = along[0].at(0.0)
    left, before = layout.length - first[0], layout  # even if something else has ended it before
    for each in path.ahead:
        assert each.path is not None
        before = PathLayout(each.path, before.ends)
        left += before.length
    by = _least(wanted, layout)[1]
    by = by._replace(rates=(by.rates[0], _gentlest(wanted, layout, by.rates[1])))
    velocity, acceleration = first[1], first[2] if by.smooth else 0.0
    if reverses(velocity, acceleration, by, -SLACK):
        if not path.comes_to_rest or velocity <= 0.0:
            return path.comes_to_rest
        # A stop takes its deceleration back just until it rests.
        by = by._replace(jerks=(by.jerks[0], 0.5 * acceleration**2 / velocity))
    # A path that does stop has just the distance left that it needs.
    return lead(velocity, acceleration, 0.0, by)[1] <= left * (1.0 + SLACK)


def check_tail(
    proof: Proof,
    run: Run,
    order: Order,
    begin: float,
    length: float,
    suspended: Order | None = None,
    planned_at: float | None = None,
) -> None:
    """Check the speed along a path and its changes while another is blended onto it.

    `planned_at` is when it was planned by `order`, if before `begin`: a path without room to slow down runs at the
    speed of that plan. `suspended` is the order of its motion before it was resumed then, if it was.
    """
    path = order.path
    assert path is not None
    profiles = [entry.profile for entry in run.members(path) if entry.profile is not None]
    layout = PathLayout(path, run.origins(path))
    along = spans_along([(profile, begin - path.begun) for profile in profiles], layout, length)
    where = f"path from {path.begun:.6f} s at {begin:.6f} s"
    if not along:
        return
    first, planned = along, 0.0
    if planned_at is not None and planned_at < begin and not path.comes_to_rest:
        rows = [(profile, planned_at - path.begun) for profile in profiles]
        first = spans_along(rows, layout, begin - planned_at)
        travelled, v0, a0, _ = first[0].at(0.0)
        planned = _slowing(order, layout, v0, a0, layout.length - travelled, inf).speed
    if suspended is not None and _cannot_stop(order, layout, first, 0.0):
        stop, along = _until_rest(along)
        _check_along(proof, suspended, layout, stop, where)
    if along:
        _check_along(proof, order, layout, along, where, planned=planned)


def _check_path(
    proof: Proof,
    order: Order,
    layout: PathLayout,
    profiles: Sequence[Profile],
    along: list[Span],
    time: tuple[float, float],
    where: str,
) -> None:
    """Check at four times that the axes are on the path; on an arc, at its distance.

    `time` is the start of the profile relative to the start of the path, and how long the profile is in
    force, s.
    """
    first, length = time
    slack = SLACK * max(
        1.0, layout.length, *(abs(s / k) for s, k in zip(layout.starts, layout.path.scales, strict=True))
    )
    for share in (0.0, 0.3, 0.7, 1.0):
        positions = [profile.position(first + share * length) for profile in profiles]
        off = layout.off(positions)
        if off > slack:
            proof.breaks(order.line, f"{where}: it is {off:g} off the commanded path")
            return
        if along and layout.unit is None:
            span = next((each for each in reversed(along) if each.begin <= share * length), along[0])
            along_it = span.at(min(share * length - span.begin, span.length))[0]
            apart = max(abs(p - w) for p, w in zip(positions, layout.at(along_it), strict=True))
            if apart > slack * max(map(abs, layout.path.scales)):
                proof.breaks(order.line, f"{where}: {along_it:g} along it is {apart:g} counts off")
                return


def _follows_stop(before: Order, order: Order, layout: PathLayout, along: list[Span], beyond: float) -> bool:
    """True if a resumed path has to come to rest first."""
    path, earlier = order.path, before.path
    assert path is not None
    if earlier is None or earlier.entry != path.entry or not earlier.comes_to_rest or path.comes_to_rest:
        return False
    return _cannot_stop(order, layout, along, beyond)


def _cannot_stop(order: Order, layout: PathLayout, along: list[Span], beyond: float) -> bool:
    """True if a path could not stop before its end by its rates.

    Also true if its deceleration could not be reduced to zero before it comes to rest.
    """
    travelled, v0, a0, _ = along[0].at(0.0)
    by = _least(order, layout)[1]
    left = layout.length - travelled + beyond
    if reverses(v0, a0, by, -SLACK):
        return True
    return by.rates[1] > 0.0 and lead(v0, a0 if by.smooth else 0.0, 0.0, by)[1] > left * (1.0 + SLACK)


def plan_in_force(run: Run, a: WholeTrack, i: int, order: Order) -> Order:
    """Return the order by which a path's profile on one of its axes was planned.

    If a stop would enter the next path too fast, the stop begins on the next path, and until then the earlier
    plan remains in force.
    """
    path = order.path
    if path is None or not path.comes_to_rest:
        return order
    master = run.axes[path.members[0]]
    i = master.index_at(a.starts[i])
    plan = _plan_before(run, master, i, run.expected_motion.of[master.index][i])
    moves = run.members(path)
    if plan is None or len(moves) != len(path.members):
        return order
    rows = [(move.profile, master.starts[i] - path.begun) for move in moves if move.profile is not None]
    layout = PathLayout(path, run.origins(path))
    along = spans_along(rows, layout, run.span(master, i)[1] - master.starts[i])
    return plan if along and _enters_too_fast(order, layout, along) else order


def _plan_before(run: Run, master: WholeTrack, i: int, order: Order) -> Order | None:
    """Return the order of a path before its stop or suspension, if any.

    Also None if its rates have not changed.
    """
    path, records = order.path, run.expected_motion.of[master.index]
    assert path is not None
    while path.comes_to_rest and i:
        i -= 1
        earlier = records[i].path
        if earlier is None or earlier.entry != path.entry:
            break
        if not earlier.comes_to_rest:
            return None if same_law(records[i], order) else records[i]
    return None


def same_law(one: Order, other: Order) -> bool:
    """True if two orders of a path have the same law of ramps."""
    laws = [
        (each.shape, each.rates, each.jerks, each.path.most_accel, each.path.most_decel)
        for each in (one, other)
        if each.path is not None
    ]
    return laws[0] == laws[1]


def _enters_too_fast(order: Order, layout: PathLayout, along: list[Span]) -> bool:
    """True if a stop by the present rates would enter the next path above its speed.

    In that case the path continues as planned, and the stop begins on the next path.
    """
    assert order.path is not None
    travelled, v0, a0, _ = along[0].at(0.0)
    by, left, before = _least(order, layout)[1], layout.length - travelled, layout
    a = a0 if by.smooth else 0.0
    for each in order.path.ahead:
        assert each.path is not None
        before = PathLayout(each.path, before.ends)
        most, own = _least(each, before)
        by = by._replace(rates=(by.rates[0], min(by.rates[1], own.rates[1])))
        peak = v0 + 0.5 * a * abs(a) / by.jerks[0] if a > 0.0 else v0
        if peak > most and lead(v0, a, most, by)[1] > left * (1.0 - SLACK):
            return True
        left += before.length
    return False


def _gentlest_before(run: Run, master: WholeTrack, i: int, order: Order) -> float:
    """Return the lowest deceleration of a stop begun earlier; infinite without one."""
    records, rate = run.expected_motion.of[master.index], inf
    while i and order.path is not None and order.path.comes_to_rest:
        i -= 1
        earlier, path = records[i], order.path
        if earlier.path is None or not earlier.path.comes_to_rest or earlier.path.members != path.members:
            break
        origins = run.origins(earlier.path)
        if len(origins) != len(path.members):
            break
        layout = PathLayout(earlier.path, origins)
        rate = min(rate, _gentlest(earlier, layout, _least(earlier, layout)[1].rates[1]))
        order = earlier
    return rate


def _until_rest(along: list[Span]) -> tuple[list[Span], list[Span]]:
    """Return the segments up to the first standstill, and those after it."""
    for k, span in enumerate(along):
        if abs(span.at(span.length)[1]) <= SLACK * max(1.0, along[0].at(0.0)[1]):
            return along[: k + 1], along[k + 1 :]
    return along, []


def _beyond(run: Run, move: Move) -> float:
    """Return the length of the following paths until the axes are at rest, user units.

    It is computed backwards from the last path, once for each path of a contour.
    """
    chain = []
    while id(move) not in run.beyond:
        after, length = _leads_to(run, move)
        chain.append((move, length))
        if after is None:
            break
        move = after
    beyond = run.beyond.get(id(move), 0.0)
    for before, length in reversed(chain):
        beyond += length
        run.beyond[id(before)] = beyond
    return beyond


def _leads_to(run: Run, move: Move) -> tuple[Move | None, float]:
    """Return the entry that follows a path without a standstill, and the added length.

    If there is none, the result is (None, 0.0).
    """
    after = run.path_after(move)
    if after is None or move.profile is None:
        return None, 0.0
    assert after.profile is not None
    end = move.start_time + move.profile.duration
    if not after.profile.velocity(0.0) or abs(after.start_time - end) > ROUNDED * (1.0 + end):
        return None, 0.0
    if run.rest_of(after) is not None:
        return after, 0.0
    path = run.order_of(after).path
    assert path is not None
    starts = run.origins(path)
    if len(starts) != len(path.members):
        return None, 0.0
    return after, PathLayout(path, starts).length


def _check_along(
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
    slow = _slowing(order, layout, v0, a0, layout.length - travelled + beyond, gentlest)
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
    least, by = _least(order, layout)
    if layout.unit is None:
        speed, rates = least, by.rates
    if fresh:
        return speed, rates, slow._replace(speed=speed, came=0.0, until=0.0, eased=0.0, stretches=()), 0.0
    return speed, rates, slow, slow.speed if slow.speed > least else 0.0  # without room to brake twice


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


def _slowing(order: Order, layout: PathLayout, v0: float, a0: float, left: float, gentlest: float) -> Slowing:
    """Return how a path that begins too fast slows down to its speed.

    It may be too fast for the path or for one of its axes. If the distance `left` does not suffice for this
    and a stop, the speed is higher, since two S-ramps need more distance than one.
    """
    assert order.path is not None
    speed, by = _least(order, layout)
    extra = 0.0
    if a0 and order.shape != "trapezoid" and not by.smooth:
        # The flank of the ramp of PMC's S-curve, at most as long as a complete ramp to its speed.
        v0 *= 2.0
        extra = ramp(0.0, max(speed, v0), by)[0]
    if order.path.comes_to_rest:
        rate = min(gentlest, _gentlest(order, layout, by.rates[1]))
        speed, by = 0.0, by._replace(rates=(by.rates[0], rate))
    elif by.smooth:
        speed = max(speed, top_speed(v0, a0, left, speed, by))
    return slowing(v0, a0, speed, by, extra)


def _hardest(path: PathOrder, layout: PathLayout) -> float:
    """Return the highest deceleration along a path within its axes' limits.

    Centripetal acceleration does not count.
    """
    slopes = zip(layout.slopes(0.0, layout.length), path.scales, path.most_decel, strict=True)
    return min((limit / (slope * abs(k)) for slope, k, limit in slopes if slope), default=inf)


def _gentlest(order: Order, layout: PathLayout, rate: float) -> float:
    """Return the lowest deceleration of a stop on a path and its possible successors."""
    assert order.path is not None
    for each in order.path.ahead:
        assert each.path is not None
        layout = PathLayout(each.path, layout.ends)
        rate = min(rate, _least(each, layout)[1].rates[1])
    return rate


def _check_path_time(proof: Proof, order: Order, layout: PathLayout, along: list[Span], where: str) -> None:
    """Check that the last path takes no longer than a stop and a move from rest.

    That motion observes all bounds whatever follows, so a plan may only be faster.
    """
    if not order.speed or not min(order.rates) > 0.0:
        return
    first, last = along[0].at(0.0), along[-1].at(along[-1].length)
    speed, by = _least(order, layout)
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


def _least(order: Order, layout: PathLayout) -> tuple[float, Law]:
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


def _counts(components: Sequence[float], axes: Sequence[tuple[int, float]]) -> list[float]:
    return [component * k for component, (_, k) in zip(components, axes, strict=True)]


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


# --------------------------------------------------------------------------------------------------- the end


def check_path_end(proof: Proof, run: Run, move: Move, over: bool) -> None:
    """Check that a path ends at its commanded position, and takes time."""
    profile = move.profile
    assert profile is not None
    path = run.order_of(move).path
    assert path is not None
    entries = run.members(path)
    starts = run.origins(path)
    if len(starts) != len(path.members) or any(entry.offset for entry in entries):
        return
    which = path.members.index(move.axis)
    end = end_positions(path, starts)[which]
    where = f"axis {move.axis} from {move.start_time:.6f} s"
    size = max(1.0, abs(end), abs(profile.start))
    if over and abs(profile.end - end) > SLACK * size:
        proof.breaks(move.line, f"{where}: its path ends at {profile.end:g}, commanded {end:g}")
    if which == 0 and over and not profile.duration and PathLayout(path, starts).length > SLACK:
        proof.breaks(move.line, f"{where}: a path in no time")
