"""Checks of paths in a run: geometry, the orders in force, neighbours, and end."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import inf, nextafter

from motionlang.kernel import Axis
from motionlang.kernel.log import LoggedMove
from motionlang.kernel.planners import Profile
from tests.proof.checker import SLACK, Proof, RunRecords
from tests.proof.order import Order, PathOrder
from tests.proof.path_bounds import check_along, could_stop, spans_along
from tests.proof.path_layout import PathLayout, end_positions
from tests.proof.segments import Span


def check_path(proof: Proof, run: RunRecords, master: Axis, i: int, order: Order, end: float) -> None:
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
    where = f"path from {begin:.6f} s"
    axes = [run.axes[number] for number in path.members]
    indices = [a.index_at(begin) for a in axes]
    tracks = [(a.profiles[k], begin - a.starts[k]) for a, k in zip(axes, indices, strict=True)]
    along = spans_along(tracks, layout, end - begin)
    is_first = i > 0 and begin == path.begun and run.rest_of(moves[0]) is None
    fresh = is_first and _speeds_up(run, order, path, master, i)
    is_endless = min(profile.duration - time for profile, time in tracks) == inf
    can_move = order.speed and min(order.rates) and layout.length and not path.comes_to_rest
    if is_endless and can_move:
        proof.breaks(order.line, f"{where}: it never reaches its end")
    _check_geometry(proof, order, layout, profiles, along, (begin - path.begun, end - begin), where)
    if along:
        plan = order if could_stop(order, layout, along) else in_force(run, master, i, order)
        check_along(proof, order, plan, layout, along, where, fresh)


def check_rest(proof: Proof, run: RunRecords, order: Order, plan: Order, begin: float, length: float) -> None:
    """Check the bounds along a path from a time on, by its entries in the log; see `check_along`."""
    layout, along = rest_along(run, order, begin, length)
    if along:
        assert order.path is not None
        where = f"path from {order.path.begun:.6f} s at {begin:.6f} s"
        check_along(proof, order, plan, layout, along, where)


def rest_along(run: RunRecords, order: Order, begin: float, length: float) -> tuple[PathLayout, list[Span]]:
    """Return the layout of a path and its motion along it from a time on, by its entries in the log."""
    path = order.path
    assert path is not None
    profiles = [entry.profile for entry in run.members(path) if entry.profile is not None]
    layout = PathLayout(path, run.origins(path))
    return layout, spans_along([(profile, begin - path.begun) for profile in profiles], layout, length)


def _speeds_up(run: RunRecords, order: Order, path: PathOrder, master: Axis, i: int) -> bool:
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


def in_force(run: RunRecords, master: Axis, i: int, order: Order) -> Order:
    """Return the order of a path at profile i, with the rates of the plans that it may continue.

    A stop that comes too late continues the plan before it, and a path that is resumed may complete its stop.
    """
    found = order
    for earlier in _orders_before(run, master, i, order):
        assert order.path is not None
        assert earlier.path is not None
        if not (order.path.comes_to_rest or earlier.path.comes_to_rest):
            break
        found, order = _wider(found, earlier), earlier
    return found


def _orders_before(run: RunRecords, master: Axis, i: int, order: Order) -> Iterator[Order]:
    """Yield the earlier orders of a path, the last one first."""
    assert order.path is not None
    for k in range(i - 1, -1, -1):
        before = run.expected_motion.of[master.index][k]
        if before.path is None or before.path.nth != order.path.nth:
            return
        yield before


def _wider(one: Order, other: Order) -> Order:
    """Return an order with the shape, rates, jerks and limits of axes that either of two allows."""
    assert one.path is not None
    assert other.path is not None
    path = one.path._replace(
        most_accel=tuple(map(max, one.path.most_accel, other.path.most_accel)),
        most_decel=tuple(map(max, one.path.most_decel, other.path.most_decel)),
    )
    rates = max(one.rates[0], other.rates[0]), max(one.rates[1], other.rates[1])
    jerks = max(one.jerks[0], other.jerks[0]), max(one.jerks[1], other.jerks[1])
    shape = one.shape if other.bends else other.shape
    return one._replace(rates=rates, jerks=jerks, shape=shape, path=path)


def _check_geometry(
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


def check_path_end(proof: Proof, run: RunRecords, move: LoggedMove, over: bool) -> None:
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
