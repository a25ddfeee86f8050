"""A proof of a run: every profile of every axis held against what was ordered, by what the run left behind alone.

It shares no code with the planners: it evaluates the pieces by itself and asks the log, the track and the orders.
"""

from __future__ import annotations

from math import acos, cos, degrees, fsum, inf, isfinite, sin, sqrt
from typing import TYPE_CHECKING

from motionlang.errors import Diagnostic

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from motionlang.controller.move import Move
    from motionlang.controller.record.orders import Order, Orders
    from motionlang.controller.record.track import Recorded, WholeTrack
    from motionlang.profile import Profile, State
    from motionlang.profile.ramps import Piece

# A part of the largest figure that rounding may be worth; places inside a piece at which it is looked at.
SLACK = 1e-6
PLACES = (1e-9, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0 - 1e-9)
# Kinds that are planned from the settings of the axis, and so keep its rates.
PLANNED = frozenset({"move", "jog", "stop"})


class Proof:
    """What was proved: `counts` of things looked at, the `worst` use of each bound (1.0: all of it), `exceptions` that
    the program has ordered by name, and `violations`, each a diagnostic at its line."""

    def __init__(self) -> None:
        self.counts = {"moves": 0, "profiles": 0, "joins": 0, "paths": 0}
        self.worst: dict[str, float] = {}
        self.exceptions: dict[str, int] = {}
        self.violations: list[Diagnostic] = []

    @property
    def holds(self) -> bool:
        """Whether nothing was broken."""
        return not self.violations

    def lines(self) -> list[str]:
        """The same for a person."""
        looked = ", ".join(f"{name} {count}" for name, count in self.counts.items())
        found = [
            f"proof: {looked}; {len(self.violations) or 'no'} violation{'s'[: len(self.violations) != 1]}"
        ]
        found += [f"  {name}: {share:.9f} of what is allowed" for name, share in sorted(self.worst.items())]
        found += [f"  ordered: {name}, {count} x" for name, count in sorted(self.exceptions.items())]
        return found

    def breaks(self, line: int, message: str) -> None:
        """Something is broken."""
        self.violations.append(Diagnostic("proof", message, line))

    def excuses(self, name: str) -> None:
        """Something would be broken if the program had not ordered it."""
        self.exceptions[name] = self.exceptions.get(name, 0) + 1

    def uses(self, name: str, figure: float, bound: float) -> bool:
        """Note how much of a bound is used; whether it is kept."""
        if bound == inf:
            return True
        share = figure / bound if bound else (0.0 if figure <= SLACK else inf)
        if share <= 1.0 + SLACK:
            self.worst[name] = max(self.worst.get(name, 0.0), share)
            return True
        return False


def prove(controller: Recorded, orders: Orders, until: float) -> Proof:
    """Prove what a controller did up to a time, by its log."""
    proof = Proof()
    for number, a in controller.axes.items():
        records = orders.of[number]
        assert len(records) == len(a.profiles), f"axis {number} has a profile that nobody recorded"
        for i, order in enumerate(records):
            end = (
                a.starts[i + 1] if i + 1 < len(a.starts) else min(until, a.starts[i] + a.profiles[i].duration)
            )
            if end > a.starts[i]:
                _judge_profile(proof, a, i, order, end - a.starts[i])
                if order.kind == "path" and order.members[0] == number:
                    _judge_path(proof, controller, a, i, order, end)
            if i:
                _judge_join(proof, controller, orders, a, i)
    for move in controller.moves:
        _judge_move(proof, controller, move, until)
    return proof


# ------------------------------------------------------------------------------------------------- one profile


def _states(profile: Profile, length: float) -> Iterator[tuple[float, float, float]]:
    """Velocity, acceleration and jerk at places in every piece of the first `length` seconds."""
    for piece, begin, finish in zip(profile.pieces, profile.knots, profile.knots[1:], strict=False):
        span = min(finish, length) - begin
        if span <= 0.0 or not isfinite(span):
            continue
        for place in PLACES:
            yield _derivatives(piece, place * span)[1:]


def _judge_profile(proof: Proof, a: WholeTrack, i: int, order: Order, length: float) -> None:
    """Speed, acceleration, deceleration and jerk of what was planned from the settings of the axis."""
    profile = a.profiles[i]
    proof.counts["profiles"] += order.kind != "rest"
    if order.kind not in PLANNED or not profile.pieced:
        return
    _judge_knots(proof, a, i, order, length)
    entry = profile.at(0.0)
    fastest = max(order.speed, abs(entry.velocity))
    still = SLACK * max(1.0, profile.peak_speed)
    broken: dict[str, tuple[float, float]] = {}
    for v, acceleration, jerk in _states(profile, length):
        size = abs(acceleration)
        if abs(v) <= still:
            rate, bound = "rate at rest", max(order.accel, order.decel)
        else:
            speeds_up = v * acceleration > 0.0
            rate, bound = ("acceleration", order.accel) if speeds_up else ("deceleration", order.decel)
        if not size:
            bound = inf
        elif order.jerk < inf:  # what the axis came with is eased, whatever its rates
            bound = max(bound, abs(entry.acceleration))
        for name, figure, most in (
            ("speed", abs(v), fastest),
            (rate, size, bound),
            ("jerk", abs(jerk), order.jerk),
        ):
            if not proof.uses(name, figure, most):
                broken[name] = max(broken.get(name, (0.0, most)), (figure, most))
    for name, (figure, most) in broken.items():
        where = f"axis {a.index} from {a.starts[i]:.6f} s"
        proof.breaks(order.line, f"{where}: the {name} reaches {figure:g} counts, above {most:g}")


def _judge_knots(proof: Proof, a: WholeTrack, i: int, order: Order, length: float) -> None:
    """Position and velocity go on from piece to piece, and the acceleration of S-ramps."""
    profile = a.profiles[i]
    sizes = (max(1.0, abs(profile.start)), max(1.0, profile.peak_speed), max(1.0, order.accel, order.decel))
    names = ("position", "velocity", "acceleration")[: 3 if order.jerk < inf else 2]
    for k, knot in enumerate(profile.knots[1:-1]):
        if knot > length:
            return
        x = knot - profile.knots[k]
        late = 4e-16 * (1.0 + a.starts[i] + knot)
        left, right = _derivatives(profile.pieces[k], x), _derivatives(profile.pieces[k + 1], 0.0)
        for order_, name in enumerate(names):
            gap = abs(right[order_] - left[order_])
            if gap > SLACK * sizes[order_] + 4.0 * late * abs(left[order_ + 1]):
                where = f"axis {a.index} at {a.starts[i] + knot:.6f} s"
                proof.breaks(order.line, f"{where}: the {name} jumps by {gap:g} counts within a profile")


def _derivatives(piece: Piece, x: float) -> tuple[float, float, float, float]:
    """Position, velocity, acceleration and jerk of a piece."""
    c0, c1, c2, c3, amplitude, omega, phase = piece
    p, v = c0 + x * (c1 + x * (c2 + x * c3)), c1 + x * (2.0 * c2 + 3.0 * c3 * x)
    a, j = 2.0 * c2 + 6.0 * c3 * x, 6.0 * c3
    if amplitude:
        wave, slope = amplitude * sin(omega * x + phase), amplitude * omega * cos(omega * x + phase)
        p, v, a, j = p + wave, v + slope, a - wave * omega * omega, j - slope * omega * omega
    return p, v, a, j


def _judge_path(
    proof: Proof, controller: Recorded, master: WholeTrack, i: int, order: Order, end: float
) -> None:
    """The speed along a path and how it changes, and the limits of each axis on it."""
    begin = master.starts[i]
    proof.counts["paths"] += 1
    axes = [controller.axes[number] for number in order.members]
    k = abs(master.scale.counts)
    broken: dict[str, tuple[float, float]] = {}
    entry = _speed(axes, [a.at(begin) for a in axes])
    for place in PLACES:
        states = [a.at(begin + place * (end - begin)) for a in axes]
        speed = _speed(axes, states)
        if any(a.profiles[-1].shape == "blend" or _shape(a, begin) == "blend" for a in axes):
            proof.excuses("paths blended into each other")
            return
        checks = [("path speed", speed, max(order.speed / k, entry))]
        if speed > SLACK:
            along = fsum(
                s.velocity * s.acceleration / a.scale.counts**2 for a, s in zip(axes, states, strict=True)
            )
            bound = order.accel if along > 0.0 else order.decel
            checks.append(
                ("path acceleration" if along > 0.0 else "path deceleration", abs(along) / speed, bound / k)
            )
        for a, state, most in zip(axes, states, order.most, strict=True):
            checks.append(
                (
                    f"speed of axis {a.index}",
                    abs(state.velocity),
                    max(most, entry * abs(a.scale.counts)),
                )
            )
        for name, figure, most in checks:
            if not proof.uses(name.split(" of axis")[0], figure, most):
                broken[name] = max(broken.get(name, (0.0, most)), (figure, most))
    for name, (figure, most) in broken.items():
        proof.breaks(order.line, f"path from {begin:.6f} s: the {name} reaches {figure:g}, above {most:g}")


def _shape(a: WholeTrack, time: float) -> str:
    return a.profiles[_place(a, time)].shape


def _speed(axes: Sequence[WholeTrack], states: Sequence[State]) -> float:
    return sqrt(fsum((s.velocity / a.scale.counts) ** 2 for a, s in zip(axes, states, strict=True)))


# ------------------------------------------------------------------------------------------------------- joins


def _judge_join(proof: Proof, controller: Recorded, orders: Orders, a: WholeTrack, i: int) -> None:
    """Position and velocity go on where one profile follows another, and the acceleration of S-ramps."""
    proof.counts["joins"] += 1
    time, order = a.starts[i], orders.of[a.index][i]
    before = a.profiles[i - 1].at(time - a.starts[i - 1])
    after = a.profiles[i].at(0.0)
    stands = (a.index, time) in orders.stands
    shift = orders.data[a.index][i] - orders.data[a.index][i - 1]
    where = f"axis {a.index} at {time:.6f} s"
    line = order.line or orders.of[a.index][i - 1].line
    # The time of a join is rounded to the clock, and the axis has gone on by as much.
    late = 4e-16 * (1.0 + time)
    moved = abs(after.position - before.position - shift)
    if shift:
        proof.excuses("a position that is given a new value")
    if moved > SLACK * max(1.0, abs(before.position) * 1e-6) + 4.0 * late * abs(before.velocity):
        if a.feedback is not None and not after.velocity and orders.of[a.index][i].kind == "rest":
            proof.excuses("a demand that is taken to where its motor is")
        else:
            proof.breaks(line, f"{where}: the position jumps by {moved:g} counts")
    jump = abs(after.velocity - before.velocity)
    kinds = (orders.of[a.index][i - 1].kind, order.kind)
    if jump > SLACK * max(1.0, abs(before.velocity), abs(after.velocity)) + 4.0 * late * abs(
        before.acceleration
    ):
        excuse = _excuse(controller, orders, a, i, kinds, stands)
        if excuse:
            proof.excuses(excuse)
        else:
            proof.breaks(line, f"{where}: the velocity jumps by {jump:g} counts/s")
    elif kinds == ("path", "path") and order.jerk < inf and order.members[0] == a.index:
        bend = _bend(controller, order, time)
        if bend > SLACK * max(1.0, order.accel, order.decel) / abs(a.scale.counts):
            proof.breaks(line, f"{where}: the acceleration along the path jumps by {bend:g}")
    elif order.kind in PLANNED and order.jerk < inf and kinds[0] in (*PLANNED, "rest"):
        bend = abs(after.acceleration - before.acceleration)
        if bend > SLACK * max(1.0, order.accel, order.decel) + 4.0 * late * order.jerk:
            proof.breaks(line, f"{where}: the acceleration of an S-ramp jumps by {bend:g} counts/s²")


def _excuse(
    controller: Recorded, orders: Orders, a: WholeTrack, i: int, kinds: tuple[str, str], stands: bool
) -> str:
    """What the program has ordered that makes the velocity jump; "" where nothing has."""
    if stands:
        return "a stop at once: cancelled, switched off, or at a limit"
    named = [kind for kind in kinds if kind not in (*PLANNED, "rest", "path")]
    if named:
        return f"a step of {named[-1]}: a table, a master or a reference of the program"
    order = orders.of[a.index][i]
    if kinds == ("path", "path"):
        axes, old, new = _both(controller, order, a.starts[i])
        before, after = _speed(axes, old), _speed(axes, new)
        if abs(before - after) > SLACK * max(1.0, before) or not before:
            return ""
        dot = fsum(
            o.velocity * n.velocity / x.scale.counts**2 for x, o, n in zip(axes, old, new, strict=True)
        )
        angle = degrees(acos(max(-1.0, min(1.0, dot / (before * after)))))
        return "a kink within CONTOURANGLE" if angle <= order.angle + 1e-6 else ""
    return ""


def _bend(controller: Recorded, order: Order, time: float) -> float:
    """By how much the acceleration along a path changes at a moment."""
    axes, *both = _both(controller, order, time)
    rates = []
    for states in both:
        speed = _speed(axes, states)
        power = fsum(
            s.velocity * s.acceleration / x.scale.counts**2 for x, s in zip(axes, states, strict=True)
        )
        if speed < SLACK:
            return 0.0
        rates.append(power / speed)
    return abs(rates[1] - rates[0])


def _both(
    controller: Recorded, order: Order, time: float
) -> tuple[list[WholeTrack], list[State], list[State]]:
    """The axes of a path, and their states just before a moment and from then on."""
    axes = [controller.axes[number] for number in order.members]
    places = [_place(a, time) for a in axes]
    old = [a.profiles[k - 1].at(time - a.starts[k - 1]) for a, k in zip(axes, places, strict=True)]
    return axes, old, [a.at(time) for a in axes]


def _place(a: WholeTrack, time: float) -> int:
    return a.place(time)


# ---------------------------------------------------------------------------------------------------- the log


def _judge_move(proof: Proof, controller: Recorded, move: Move, until: float) -> None:
    """An entry of the log: it takes time, its phases add up, it ends where it was sent, and the track says the same."""
    proof.counts["moves"] += 1
    profile, a = move.profile, controller.axes[move.axis]
    assert profile is not None
    where = f"axis {move.axis} from {move.start_time:.6f} s"
    size = max(1.0, abs(profile.start), abs(profile.end) if isfinite(profile.end) else 0.0)
    if not profile.duration and abs(profile.distance) > SLACK * size:
        proof.breaks(move.line, f"{where}: {profile.distance:g} counts in no time")
    if isfinite(profile.duration):
        phases = profile.phases
        time, way = fsum(each.duration for each in phases), fsum(each.distance for each in phases)
        if abs(time - profile.duration) > SLACK * max(1.0, profile.duration):
            proof.breaks(move.line, f"{where}: the phases take {time:g} s, the move {profile.duration:g} s")
        if abs(way - profile.distance) > SLACK * size:
            proof.breaks(move.line, f"{where}: the phases go {way:g} counts, the move {profile.distance:g}")
    over = move.start_time + profile.duration <= until and a.move is not move
    if (
        over
        and move.action is None
        and not move.ended
        and abs(profile.end + move.offset - move.target) > SLACK * size
    ):
        proof.breaks(move.line, f"{where}: it ends at {profile.end + move.offset:g}, sent to {move.target:g}")
    blended = _shape(a, move.start_time) == "blend"
    if not move.overlaid and not move.offset and not blended and isfinite(profile.start):
        middle = move.start_time + 0.5 * min(profile.duration, until - move.start_time)
        told, done = profile.position(middle - move.start_time), a.position(middle)
        if abs(told - done) > SLACK * size:
            proof.breaks(
                move.line, f"{where}: the log has it at {told:g} at {middle:.6f} s, the track at {done:g}"
            )
