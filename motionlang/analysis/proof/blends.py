"""Checks of blended paths: at most two overlap, and each observes its own bounds.

Their sum then observes the bounds that the program has set for both. A stop, an override or a limit acts on
each of them.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from math import fsum

from motionlang.analysis.proof.checker import ROUNDED, SLACK, Proof, Run
from motionlang.analysis.proof.path_bounds import spans_along
from motionlang.analysis.proof.path_layout import PathLayout
from motionlang.analysis.proof.paths import check_tail, same_law, stops_within
from motionlang.controller.move import Move
from motionlang.log.order import Order, PathOrder
from motionlang.log.track import WholeTrack
from motionlang.planners import Profile

# Paths that may overlap.
MAX_OVERLAP = 2
# The largest share of a path that another one may overlap.
MAX_SHARE = 0.5
# Seconds of a path that are searched for its position.
MOMENT = 1e-6
# The fractions of a profile at which the velocities of its paths are added.
SHARES = (0.0, 0.35, 0.65, 0.95)


def check_blend(proof: Proof, run: Run, master: WholeTrack, i: int, order: Order, end: float) -> None:
    """Check the paths blended with a profile's path while the profile is in force."""
    path, begin = order.path, master.starts[i]
    assert path is not None
    if begin == path.begun:
        _check_begin(proof, run, master, i, order)
    ends: list[float] = []
    entries = [run.members(path)]
    for tail in path.tails:
        assert tail.path is not None
        moves = run.members(tail.path)
        if len(moves) != len(path.members) or moves[0].profile is None:
            continue
        finish = min(end, moves[0].start_time + moves[0].profile.duration)
        if finish - begin > ROUNDED * (1.0 + begin):
            ends.append(finish)
            entries.append(moves)
            plan, k = _tail_in_force(run, master, i, tail), _plan_index(run, master, i, tail)
            suspended = suspended_by(run, master, k, tail)
            check_tail(proof, run, plan, begin, finish - begin, suspended, master.starts[k])
    if len(ends) >= MAX_OVERLAP:
        count = len(ends) + 1
        words = f"{count} paths overlap at {begin:.6f} s, at most {MAX_OVERLAP} may"
        proof.breaks(order.line, f"path from {path.begun:.6f} s: {words}")
    if ends and all(len(moves) == len(path.members) for moves in entries):
        _check_sum(proof, run, order, entries, (begin, min(end, *ends)))


def _tail_in_force(run: Run, master: WholeTrack, i: int, tail: Order) -> Order:
    """Return the order by which a blended path was planned.

    A stopped or suspended path that could not stop before its end by the present rates continues by its
    earlier order.
    """
    assert tail.path is not None
    if not tail.path.comes_to_rest or stops_within(run, tail, master.starts[i]):
        return tail
    for order in reversed(run.expected_motion.of[master.index][:i]):
        for each in (order, *(order.path.tails if order.path is not None else ())):
            if each.path is not None and each.path.entry == tail.path.entry and not each.path.comes_to_rest:
                return each
        if order.path is None or order.path.begun < tail.path.begun:
            break
    return tail


def _plan_index(run: Run, master: WholeTrack, i: int, tail: Order) -> int:
    """Return the number of the profile at which a blended path was planned.

    It was planned by the order in force at profile i.
    """
    assert tail.path is not None
    for k in range(i - 1, -1, -1):
        order = run.expected_motion.of[master.index][k]
        for each in (order, *(order.path.tails if order.path is not None else ())):
            if each.path is not None and each.path.entry == tail.path.entry:
                break
        else:
            return k + 1
        stops = each.path.comes_to_rest != tail.path.comes_to_rest
        if stops or each.speed != tail.speed or not same_law(each, tail):
            return k + 1
    return 0


def suspended_by(run: Run, master: WholeTrack, i: int, tail: Order) -> Order | None:
    """Return the order of a resumed path while it was suspended.

    None if it was not suspended.
    """
    order = run.expected_motion.of[master.index][i - 1]
    assert tail.path is not None
    for each in (order, *(order.path.tails if order.path is not None else ())):
        if each.path is not None and each.path.entry == tail.path.entry:
            resumed = each.path.comes_to_rest and not tail.path.comes_to_rest
            return _tail_in_force(run, master, i - 1, each) if resumed else None
    return None


def _check_begin(proof: Proof, run: Run, master: WholeTrack, i: int, order: Order) -> None:
    """Check that a path begins at its blend distance before the end of the last one.

    It may begin later only at one of the times of `_causes`.
    """
    path, begin = order.path, master.starts[i]
    assert path is not None
    while i > 0 and master.starts[i] == begin:  # a path that has ended takes no time at its end
        i -= 1
    in_progress = path.tails[-1].path if path.tails else run.expected_motion.of[master.index][i].path
    begun = run.members(path)
    before = run.path_before(begun[0]) if begun else None
    if in_progress is None or before is None or run.rest_of(begun[0]) is not None:
        return
    # The previous path may have ended while the path before that is still in motion.
    earlier = run.order_of(before).path
    if (
        earlier is None
        or earlier.members != path.members
        or earlier.comes_to_rest
        or earlier.entry == path.entry
    ):
        return
    moves, late = run.members(earlier), ROUNDED * (1.0 + begin)
    if len(moves) != len(path.members) or (not path.tails and (moves[0].ended or not path.blend)):
        return
    if not path.tails and any(
        run.path_before(each) is not before for each, before in _pairs(run, path, moves)
    ):
        return  # another path of one of its axes is in between
    layout = PathLayout(earlier, run.origins(earlier))
    profiles = [(move.profile, begin - move.start_time) for move in moves if move.profile is not None]
    left, speed = _left(layout, profiles)
    wanted = min(path.blend, MAX_SHARE * layout.length)
    slack = SLACK * max(1.0, layout.length) + 8.0 * late * speed
    prompts = [
        each
        for number in path.members
        for each in run.expected_motion.prompted(number, _planned(run, moves[0]) + late, begin + late)
    ]
    # A blend that is planned by then keeps the distance that was in force, and joined paths stay joined.
    if left is None or any(word in ("blend_mode", "blend_distance") for _, word in prompts):
        return
    where = f"path from {begin:.6f} s"
    if left > wanted + slack:
        if all(word != "blend" for _, word in prompts):
            words = f"it begins {left:g} before the end of the previous one, commanded at most {wanted:g}"
            proof.breaks(order.line, f"{where}: {words}")
    elif (
        left < wanted - slack
        and not path.comes_to_rest  # a suspended path is not blended
        and all(abs(time - begin) > late for time in _causes(run, moves[0], prompts, begin))
    ):
        words = f"it begins {left:g} before the end of the previous one, commanded {wanted:g}"
        proof.breaks(order.line, f"{where}: {words}")


def _pairs(run: Run, path: PathOrder, moves: Sequence[Move]) -> Iterator[tuple[Move, Move]]:
    """Yield the entries of a path, each with the corresponding entry in `moves`."""
    return zip(run.members(path), moves, strict=False)


def _planned(run: Run, move: Move) -> float:
    """Return when the joined paths up to an entry began, which were planned as one."""
    while (before := run.path_before(move)) is not None and before.profile is not None:
        end = before.start_time + before.profile.duration
        at_rest = not before.profile.velocity(before.profile.duration)
        if at_rest or abs(move.start_time - end) > ROUNDED * (1.0 + end):
            break
        move = before
    return move.start_time


def _left(layout: PathLayout, profiles: Sequence[tuple[Profile, float]]) -> tuple[float | None, float]:
    """Return the remaining distance of a path, None if unknown, and its speed."""
    states = [
        (end - profile.position(time), profile.velocity(time), end - start, abs(k))
        for (profile, time), start, end, k in zip(
            profiles, layout.starts, layout.ends, layout.path.scales, strict=True
        )
    ]
    fast = max(abs(velocity) / k for _, velocity, _, k in states)
    if layout.unit is not None:
        left, _, length, _ = max(states, key=lambda state: abs(state[2]) / state[3])
        return (layout.length * left / length if length else 0.0), fast
    along = spans_along(profiles, layout, MOMENT)
    return (layout.length - along[0].at(0.0)[0] if along else None), fast


def _causes(run: Run, before: Move, prompts: Sequence[tuple[float, str]], begin: float) -> Iterator[float]:
    """Yield the times at which a path may begin later than its blend distance.

    They are the times of prompts, and the end of a path with which the previous one is blended.
    """
    yield from (time for time, _ in prompts)
    entries = run.paths[before.axis]
    k = bisect_left(entries, begin, key=lambda move: move.start_time) - 1
    for move in entries[max(k - MAX_OVERLAP, 0) : k + 1]:
        if move.profile is not None and move is not before:
            yield move.start_time + move.profile.duration


def _check_sum(
    proof: Proof, run: Run, order: Order, entries: list[list[Move]], time: tuple[float, float]
) -> None:
    path, (begin, end) = order.path, time
    assert path is not None
    for index, number in enumerate(path.members):
        a = run.axes[number]
        for share in SHARES:
            now = begin + share * (end - begin)
            k = a.index_at(now)
            state = a.profiles[k].at(now - a.starts[k])
            profiles = [(moves[index].profile, moves[index].start_time) for moves in entries]
            velocities = [profile.velocity(now - start) for profile, start in profiles if profile is not None]
            done, total = state.velocity, fsum(velocities)
            rounding = 8e-16 * (1.0 + now) * abs(state.acceleration)
            if abs(done - total) > SLACK * max(1.0, *map(abs, velocities)) + rounding:
                words = (
                    f"axis {number} runs at {done:g} counts/s at {now:.6f} s, its paths add up to {total:g}"
                )
                proof.breaks(order.line, f"path from {path.begun:.6f} s: {words}")
                return
