"""The judge of paths: the way that was ordered, the speed along it and how it changes, the limits of every axis, and
where it ends."""

from __future__ import annotations

from itertools import pairwise
from math import fsum, hypot, inf, isfinite, pi
from typing import TYPE_CHECKING

from motionlang.controller.record.judge import SLACK, Uses, place
from motionlang.controller.record.spans import combined, rotation, spans

if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.controller.axis import Axis
    from motionlang.controller.move import Move
    from motionlang.controller.record.judge import Proof, Run
    from motionlang.controller.record.orders import Order, PathOrder
    from motionlang.controller.record.spans import Span
    from motionlang.profile import Profile


class Way:
    """A path as it was ordered, laid out from where it began, in user units.

    `unit` is the direction of a line, None for an arc, whose `turn` is 1/radius as seen along the path. `steepest` is
    the largest part of the speed along the path that each axis can have.
    """

    def __init__(self, path: PathOrder, starts: Sequence[float]) -> None:
        self.path, self.starts = path, starts
        first = [start / k for start, k in zip(starts, path.scales, strict=True)]
        self.ends = _ends(path, starts)
        self.turn = 0.0
        self.unit: list[float] | None = None
        if path.line or not path.angle:
            ways = [(end - start) / k for start, end, k in zip(starts, self.ends, path.scales, strict=True)]
            self.length = hypot(*ways)
            self.unit = [way / self.length for way in ways] if self.length else ways
            self.steepest = [abs(each) for each in self.unit]
            return
        centre = self.centre()
        x, y = first[0] - centre[0], first[1] - centre[1]
        self.radius = hypot(x, y)
        climbs = [
            (end - start) / k
            for start, end, k in zip(starts[2:], self.ends[2:], path.scales[2:], strict=True)
        ]
        round_ = self.radius * abs(path.angle) * pi / 180.0
        self.length = hypot(round_, *climbs)
        flat = round_ / self.length if self.length else 0.0
        self.turn = abs(path.angle) * pi / 180.0 / self.length if self.length else 0.0
        self.steepest = [flat, flat, *(abs(climb) / self.length if self.length else 0.0 for climb in climbs)]

    def centre(self) -> tuple[float, float]:
        """The centre of an arc, user units."""
        cx, cy = (c / k for c, k in zip(self.path.centre, self.path.scales, strict=False))
        if self.path.relative:
            return cx + self.starts[0] / self.path.scales[0], cy + self.starts[1] / self.path.scales[1]
        return cx, cy

    def off(self, places: Sequence[float]) -> float:
        """How far a point, counts, lies off the way, user units."""
        point = [place / k for place, k in zip(places, self.path.scales, strict=True)]
        first = [start / k for start, k in zip(self.starts, self.path.scales, strict=True)]
        gone = [p - f for p, f in zip(point, first, strict=True)]
        if self.unit is not None:
            along = fsum(g * u for g, u in zip(gone, self.unit, strict=True))
            return max(abs(g - along * u) for g, u in zip(gone, self.unit, strict=True))
        centre = self.centre()
        return abs(hypot(point[0] - centre[0], point[1] - centre[1]) - self.radius)


def judge_path(proof: Proof, run: Run, master: Axis, i: int, order: Order, end: float) -> None:
    """The way, the speed along it and how that changes, and the limits of each axis, while one profile is in force."""
    path = order.path
    assert path is not None
    proof.counts["paths"] += 1
    begin = master.starts[i]
    entries = [run.entries.get((number, path.begun)) for number in path.members]
    if any(entry is None or entry.profile is None for entry in entries):
        proof.breaks(order.line, f"path from {begin:.6f} s: the log does not tell of all of its axes")
        return
    moves = [entry for entry in entries if entry is not None]
    profiles = [entry.profile for entry in moves if entry.profile is not None]
    way = Way(path, [profile.start for profile in profiles])
    blended = run.is_blended(master, begin)
    where = f"path from {begin:.6f} s"
    if blended:
        proof.excuses("paths blended into each other")
        along = _along(profiles, way, begin - path.begun, end - begin)
    else:
        axes = [run.axes[number] for number in path.members]
        tracks = [a.profiles[place(a, begin)] for a in axes]
        along = _along(tracks, way, 0.0, end - begin)
    for share in (0.0, 0.3, 0.7, 1.0):
        time = begin - path.begun + share * (end - begin)
        off = way.off([profile.position(time) for profile in profiles])
        if off > SLACK * max(
            1.0, way.length, *(abs(s / k) for s, k in zip(way.starts, path.scales, strict=True))
        ):
            proof.breaks(order.line, f"{where}: it lies {off:g} off the way that was ordered")
            break
    if along:
        _judge_along(proof, order, way, along, where, blended)


def _judge_along(proof: Proof, order: Order, way: Way, along: list[Span], where: str, blended: bool) -> None:
    path = order.path
    assert path is not None
    smooth = order.jerks[0] < inf
    _, v0, a0, _ = along[0].at(0.0)
    came = abs(v0) + (0.5 * a0 * a0 / order.jerks[0] if smooth and a0 * v0 > 0.0 else 0.0)
    eased = abs(a0) if smooth else 0.0
    # A path that begins too fast, since a limit has come down, has as much across it until it has slowed down.
    across = way.turn * came * came if came > order.speed else 0.0
    uses = Uses(proof)
    for span in along:
        top = span.peak(1)
        uses.look("path speed", top, max(order.speed, came))
        for steep, most, k, number in zip(way.steepest, path.most, path.scales, path.members, strict=True):
            uses.look(f"speed of axis {number}", top * steep * abs(k), max(most, came * steep * abs(k)))
        for power, left, right in span.sides():
            side = 0 if power > 0.0 else 1
            rate, speed = max(abs(left[2]), abs(right[2])), max(abs(left[1]), abs(right[1]))
            if speed > SLACK:
                uses.look(
                    f"path {('acceleration', 'deceleration')[side]}", rate, max(order.rates[side], eased)
                )
                if smooth:
                    uses.look("path jerk", max(abs(left[3]), abs(right[3])), max(order.jerks))
            whole = hypot(rate, way.turn * speed * speed)
            limits = path.most_decel if side else path.most_accel
            for steep, most, k, number in zip(way.steepest, limits, path.scales, path.members, strict=True):
                excused = hypot(eased, across, way.turn * came * came if came > speed else 0.0)
                uses.look(
                    f"rate of axis {number}", whole * steep * abs(k), max(most, excused * steep * abs(k))
                )
    uses.tell(order.line, where, "")
    names = ("speed", "acceleration")[: 2 if smooth else 1]
    for before, after in pairwise(along):
        for which, name in enumerate(names, 1):
            gap = abs(after.at(0.0)[which] - before.at(before.length)[which])
            if gap > SLACK * max(1.0, came, *(r for r in (order.speed, *order.rates) if r < inf)):
                proof.breaks(order.line, f"{where}: the {name} along it jumps by {gap:g}")


def _along(profiles: Sequence[Profile], way: Way, begin: float, length: float) -> list[Span]:
    """The distance along the way over time; empty where it cannot be told."""
    found: list[Span] = []
    while length > 0.0:
        parts = [_part(profile, begin) for profile in profiles]
        span = min(length, *(left for _, _, left in parts))
        some = _spans_along([(profile, at) for profile, at, _ in parts], way, span)
        if some is None:
            return []
        offset = found[-1].begin + found[-1].length if found else 0.0
        for each in some:
            each.begin += offset
        found += some
        begin, length = begin + span, length - span
        if span <= 0.0 or not isfinite(length):
            break
    return found


def _part(profile: Profile, time: float) -> tuple[Profile, float, float]:
    """The profile of a row of them that is in force at a time, how long it has been, and how long it still is."""
    parts = getattr(profile, "parts", None)
    if parts is None:
        left = profile.duration - time
        return profile, time, left if left > 0.0 else inf
    for begin, part in zip(profile.begins, parts, strict=True):  # type: ignore[attr-defined]
        if time < begin + part.duration:
            return _part(part, time - begin)
    return parts[-1], time - profile.begins[-1], inf  # type: ignore[attr-defined]


def _spans_along(parts: Sequence[tuple[Profile, float]], way: Way, length: float) -> list[Span] | None:
    for profile, begin in parts:
        travelled = getattr(profile, "along", None)
        if travelled is not None:
            return spans(travelled, begin, length) if travelled.pieced else None
    if not all(profile.pieced for profile, _ in parts):
        return None
    if way.unit is None:  # an arc of which every axis is straight is none, or stands
        return []
    weights = [u / k for u, k in zip(way.unit, way.path.scales, strict=True)]
    rows = [spans(profile, begin, length) for profile, begin in parts]
    moving = [(row, w) for row, w, u in zip(rows, weights, way.unit, strict=True) if u]
    if not moving or len({len(row) for row, _ in moving}) != 1:
        return None
    return [combined([row[n] for row, _ in moving], [w for _, w in moving]) for n in range(len(moving[0][0]))]


# --------------------------------------------------------------------------------------------------- the end


def judge_path_end(proof: Proof, run: Run, move: Move, over: bool) -> None:
    """A path ends where the program has it end, and takes time."""
    a, profile = run.axes[move.axis], move.profile
    assert profile is not None
    order = run.order_at(a, move.start_time)
    path = order.path
    assert path is not None
    starts = [entry.profile.start for entry in _members(run, path) if entry.profile is not None]
    if len(starts) != len(path.members):
        return
    which = path.members.index(move.axis)
    end = _ends(path, starts)[which]
    where = f"axis {move.axis} from {move.start_time:.6f} s"
    size = max(1.0, abs(end), abs(profile.start))
    if over and abs(profile.end - end) > SLACK * size:
        proof.breaks(move.line, f"{where}: its path ends at {profile.end:g}, ordered was {end:g}")
    if which == 0 and over and not profile.duration and Way(path, starts).length > SLACK:
        proof.breaks(move.line, f"{where}: a path in no time")


def _members(run: Run, path: PathOrder) -> list[Move]:
    found = [run.entries.get((number, path.begun)) for number in path.members]
    return [entry for entry in found if entry is not None]


def _ends(path: PathOrder, starts: Sequence[float]) -> list[float]:
    """Where a path that begins at `starts` ends, counts."""
    if path.line:
        return [s + t for s, t in zip(starts, path.line, strict=True)] if path.relative else list(path.line)
    rest = [s + r for s, r in zip(starts[2:], path.rest, strict=True)] if path.relative else list(path.rest)
    centre = [c + s if path.relative else c for c, s in zip(path.centre, starts, strict=False)]
    x, y = ((s - c) / k for s, c, k in zip(starts[:2], centre, path.scales, strict=False))
    turned = rotation(x, y, path.angle)
    return [*(c + t * k for c, t, k in zip(centre, turned, path.scales, strict=False)), *rest]
