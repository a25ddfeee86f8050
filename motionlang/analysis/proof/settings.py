"""Checks of settings written in motion: the profile is replaced, or it continues.

If a planner continues its plan, the plan is checked against the setting from that time on. New rates may come
too late: a move that could not stop at its end with them continues unchanged.
"""

from __future__ import annotations

from motionlang.analysis.proof.blends import suspended_by
from motionlang.analysis.proof.checker import SLACK, Proof, Run
from motionlang.analysis.proof.paths import check_tail, same_law, stops_within
from motionlang.analysis.proof.time_bounds import law, lead
from motionlang.log.order import Order
from motionlang.log.track import WholeTrack


def check_settings(proof: Proof, run: Run) -> None:
    """Check every setting that did not lead to a new profile of its axis."""
    for (number, time), wanted in run.expected_motion.unheeded.items():
        a = run.axes[number]
        i = a.index_at(time)
        order = run.expected_motion.of[number][i]
        end = run.span(a, i)[1]
        if end - time > SLACK * SLACK * (1.0 + time) and order.settings != wanted.settings:
            _check_setting(proof, run, a, i, order, wanted, (time, end))


def _check_setting(
    proof: Proof, run: Run, a: WholeTrack, i: int, order: Order, wanted: Order, span: tuple[float, float]
) -> None:
    time, end = span
    where = f"axis {a.index} at {time:.6f} s"
    if order.path is not None and wanted.path is not None:
        if order.path.comes_to_rest or order.path.entry != wanted.path.entry:
            return
        if not same_law(order, wanted) and not stops_within(run, wanted, time):
            return  # by the present settings it would stop after its end, where it comes to rest as planned
        # Only lower values: a path may keep its speed if it could not stop at its end without it.
        path = order.path._replace(
            most=tuple(map(min, order.path.most, wanted.path.most)),
            most_accel=tuple(map(min, order.path.most_accel, wanted.path.most_accel)),
            most_decel=tuple(map(min, order.path.most_decel, wanted.path.most_decel)),
            comes_to_rest=wanted.path.comes_to_rest,
        )
        rates = min(order.rates[0], wanted.rates[0]), min(order.rates[1], wanted.rates[1])
        lower = order._replace(speed=min(order.speed, wanted.speed), rates=rates, path=path)
        check_tail(proof, run, lower, time, end - time, suspended_by(run, a, i, lower))
        return
    kinds = order.kind, wanted.kind
    if order.tie is not None and wanted.tie is not None:
        if order.tie.ratio != wanted.tie.ratio:
            words = f"it follows at {order.tie.ratio:g}, commanded {wanted.tie.ratio:g}"
            proof.breaks(order.line, f"{where}: {words}")
    elif kinds in (("move", "stop"), ("jog", "stop")):
        proof.breaks(order.line, f"{where}: it continues, commanded to stop")
    elif kinds in (("jog", "jog"), ("reference", "reference")) and order.goal != wanted.goal:
        words = f"it goes to {order.goal:g} counts/s, commanded {wanted.goal:g}"
        proof.breaks(order.line, f"{where}: {words}")
    elif kinds == ("move", "move") and order.speed != wanted.speed:
        words = f"it is planned for {order.speed:g} counts/s, commanded {wanted.speed:g}"
        proof.breaks(order.line, f"{where}: {words}")
    elif kinds == ("move", "move") and order.rates != wanted.rates:
        profile, state = a.profiles[i], a.profiles[i].at(time - a.starts[i])
        by, left = law(wanted.shape, wanted.rates, wanted.jerks, wanted.ramp), profile.end - state.position
        acceleration = state.acceleration if by.smooth else 0.0
        shaped = state.acceleration and not by.smooth and order.shape != "trapezoid"
        if state.velocity * left <= 0.0 or shaped:
            return
        # With a lower jerk it may run back before its deceleration is zero, which is an overshoot, too.
        stop = lead(state.velocity, acceleration, 0.0, by)[1]
        if 0.0 <= stop / left < 1.0 - SLACK:
            words = f"it keeps the rates {order.rates[0]:g} and {order.rates[1]:g}"
            proof.breaks(
                order.line, f"{where}: {words}, commanded {wanted.rates[0]:g} and {wanted.rates[1]:g}"
            )
