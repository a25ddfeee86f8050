"""The judge of single axes: bounds and times of what was planned from their settings."""

from __future__ import annotations

from itertools import pairwise
from math import copysign, inf, isfinite
from typing import TYPE_CHECKING

from motionlang.controller.record.due import law, lead, move_time
from motionlang.controller.record.judge import SLACK, Uses
from motionlang.controller.record.spans import spans

if TYPE_CHECKING:
    from motionlang.controller.record.judge import Proof
    from motionlang.controller.record.orders import Order
    from motionlang.controller.record.spans import Span
    from motionlang.controller.record.track import WholeTrack
    from motionlang.profile import Profile

# Kinds that are planned from the settings of the axis, and so keep its rates.
PLANNED = frozenset({"move", "step", "jog", "stop"})
# Places of a span at which two motions are compared: two cubics that agree at four of them are one.
FOUR = (0.05, 0.35, 0.65, 0.95)


def judge_profile(proof: Proof, a: WholeTrack, i: int, order: Order, before: Order, length: float) -> None:
    """Speed, rates, jerk and time of what was planned from the settings of the axis; continuity of all in pieces."""
    profile = a.profiles[i]
    proof.counts["profiles"] += order.kind != "rest"
    if not profile.pieced or order.kind == "rest":
        return
    parts = spans(profile, 0.0, min(length, 1e300))
    _judge_knots(proof, a, i, order, parts)
    if order.kind not in PLANNED:
        return
    entry = profile.at(0.0)
    # An axis that comes in too fast, or with too much acceleration, is excused until it has slowed down.
    came = abs(entry.velocity)
    if order.jerks[0] < inf and entry.acceleration * entry.velocity > 0.0:
        came += 0.5 * entry.acceleration**2 / order.jerks[0]
    fastest = max(order.speed, came)
    still = SLACK * max(1.0, abs(profile.start_velocity), order.speed if order.speed < inf else 0.0)
    uses = Uses(proof)
    smooth = order.jerks[0] < inf or order.shape in ("sinusoidal", "scurve")
    eased = abs(entry.acceleration) if smooth else 0.0
    for span in parts:
        uses.look("speed", span.peak(1), fastest)
        sides = list(span.sides())
        for power, left, right in sides:
            side = 0 if power > 0.0 else 1
            rate, jerk = order.rates[side], order.jerks[side]
            if max(abs(left[1]), abs(right[1])) <= still:  # at rest but for rounding
                rate = max(order.rates)
            if len(sides) > 1:  # what turns round eases out at the jerk that it came with
                jerk = max(order.jerks)
            name = ("acceleration", "deceleration")[side]
            uses.look(name, max(abs(left[2]), abs(right[2])), max(rate, eased))
            if order.jerks[0] < inf:
                uses.look("jerk", max(abs(left[3]), abs(right[3])), jerk)
    where = f"axis {a.index} from {a.starts[i]:.6f} s"
    uses.tell(order.line, where, " counts")
    _judge_time(proof, profile, order, before, where)


def _judge_time(proof: Proof, profile: Profile, order: Order, before: Order, where: str) -> None:
    """What was planned takes no longer than its bounds ask for, from whatever state it begins with."""
    by = law(order.shape, order.rates, order.jerks, order.ramp)
    entry = profile.at(0.0)
    v0, a0 = entry.velocity, entry.acceleration if by.smooth else 0.0
    extra = 0.0
    if order.shape != "trapezoid" and not by.smooth and entry.acceleration:
        # The flank of the ramp that PMC's S-curve is in: that is no longer than a whole one to its speed.
        peak = before.speed if before.speed < inf else abs(v0)
        v0, extra = (
            2.0 * v0,
            law(before.shape, before.rates, before.jerks, before.ramp).stretch * peak / min(before.rates),
        )
    if order.kind in ("move", "step"):
        if not isfinite(profile.duration):
            return
        # A stepper stops at once at the velocity of its step, as if it came to rest so much later and farther on.
        late = order.step / order.rates[1]
        way = profile.distance + copysign(0.5 * order.step * late, profile.distance)
        wanted, took = move_time(v0, a0, way, order.speed, by) - late, profile.duration
    else:
        wanted = lead(v0, a0, order.goal, by)[0]
        took = profile.knots[-1] if isfinite(profile.knots[-1]) else profile.knots[-2]
    if took > (wanted + extra) * (1.0 + SLACK) + 1e-9 + 4e-16 * abs(profile.start):
        proof.breaks(order.line, f"{where}: it takes {took:g} s where {wanted:g} s are due")


def _judge_knots(proof: Proof, a: WholeTrack, i: int, order: Order, parts: list[Span]) -> None:
    """Position goes on from piece to piece; the velocity of planned motion too, and the acceleration of S-ramps."""
    profile = a.profiles[i]
    names = ("position", "velocity", "acceleration")[
        : 1 if order.kind not in (*PLANNED, "path") else 3 if order.jerks[0] < inf else 2
    ]
    sizes = [max(1.0, abs(profile.start))]
    for left, right in pairwise(parts):
        before, after = left.at(left.length), right.at(0.0)
        if len(sizes) == 1:
            sizes += [max(1.0, profile.peak_speed), max(1.0, *(r for r in order.rates if r < inf), 1.0)]
        late = 4e-16 * (1.0 + a.starts[i] + right.begin)
        for which, name in enumerate(names):
            gap = abs(after[which] - before[which])
            if gap > SLACK * sizes[which] + 4.0 * late * abs(before[which + 1]):
                where = f"axis {a.index} at {a.starts[i] + right.begin:.6f} s"
                proof.breaks(order.line, f"{where}: the {name} jumps by {gap:g} counts within a profile")
