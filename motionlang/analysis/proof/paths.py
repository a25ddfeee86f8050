"""Checks of paths in a run: geometry, the orders in force, neighbours, and end."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf, nextafter

from motionlang.analysis.proof.checker import SLACK, Proof, Run
from motionlang.analysis.proof.path_bounds import (
    ROUNDED,
    cannot_stop,
    check_along,
    check_path_time,
    enters_too_fast,
    gentlest_stop,
    least_bounds,
    path_slowing,
    spans_along,
    until_rest,
)
from motionlang.analysis.proof.path_layout import PathLayout, end_positions
from motionlang.analysis.proof.segments import Span
from motionlang.analysis.proof.time_bounds import lead, reverses
from motionlang.controller.move import Move
from motionlang.log.order import Order, PathOrder
from motionlang.log.track import WholeTrack
from motionlang.planners import Profile


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
            check_along(proof, plan, layout, along, where, beyond=beyond)
            rest = []
        follows_stop = plan is order and _follows_stop(before, order, layout, along, beyond)
        if follows_stop:
            stop, rest = until_rest(along)
            check_along(proof, before, layout, stop, where)
        if rest:
            gentlest = _gentlest_before(run, master, i, order)
            check_along(proof, order, layout, rest, where, fresh, beyond, gentlest)
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
                until_rest(along)[1] if follows_stop else along
            )  # a stop by earlier rates takes its own time
            if timed:
                check_path_time(proof, plan, layout, timed, where)


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
    by = least_bounds(wanted, layout)[1]
    by = by._replace(rates=(by.rates[0], gentlest_stop(wanted, layout, by.rates[1])))
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
        planned = path_slowing(order, layout, v0, a0, layout.length - travelled, inf).speed
    if suspended is not None and cannot_stop(order, layout, first, 0.0):
        stop, along = until_rest(along)
        check_along(proof, suspended, layout, stop, where)
    if along:
        check_along(proof, order, layout, along, where, planned=planned)


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
    return cannot_stop(order, layout, along, beyond)


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
    return plan if along and enters_too_fast(order, layout, along) else order


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
        rate = min(rate, gentlest_stop(earlier, layout, least_bounds(earlier, layout)[1].rates[1]))
        order = earlier
    return rate


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
