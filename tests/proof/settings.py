"""Checks of settings written in motion: the profile is replaced, or it observes them.

Rates may come too late: a motion that could not stop at its end with them continues by its plan.
"""

from __future__ import annotations

from math import copysign, inf

from motionlang.kernel import Axis
from motionlang.kernel.planners import Profile
from tests.proof.axes import check_bounds
from tests.proof.checker import SLACK, Proof, RunRecords
from tests.proof.order import Order
from tests.proof.path_bounds import could_stop
from tests.proof.paths import check_rest, in_force, rest_along
from tests.proof.segments import spans
from tests.proof.stretches import stopping_distance

LATE = "a rate written too late: the motion keeps the one in force"


def check_settings(proof: Proof, run: RunRecords) -> None:
    """Check every setting that did not lead to a new profile of its axis, and rates that came too late for theirs."""
    for (number, time), wanted in run.expected_motion.late.items():
        a = run.axes[number]
        _check_late(proof, a, a.index_at(time), wanted)
    for (number, time), wanted in run.expected_motion.unheeded.items():
        a = run.axes[number]
        i = a.index_at(time)
        order = run.expected_motion.of[number][i]
        end = run.span(a, i)[1]
        if end - time > SLACK * SLACK * (1.0 + time) and order.settings != wanted.settings:
            _check_setting(proof, run, a, i, order, wanted, (time, end))


def _check_late(proof: Proof, a: Axis, i: int, wanted: Order) -> None:
    if wanted.kind == "move" and _could_stop(wanted, a.profiles[i], 0.0):
        where = f"axis {a.index} at {a.starts[i]:.6f} s"
        proof.breaks(wanted.line, f"{where}: it keeps its rates, commanded {wanted.rates[1]:g} counts/s²")
    else:
        proof.excuses(LATE)


def _check_setting(
    proof: Proof,
    run: RunRecords,
    a: Axis,
    i: int,
    order: Order,
    wanted: Order,
    span: tuple[float, float],
) -> None:
    time, end = span
    where = f"axis {a.index} at {time:.6f} s"
    if order.path is not None and wanted.path is not None:
        if order.path.entry == wanted.path.entry and not order.path.comes_to_rest:
            _check_path_setting(proof, run, in_force(run, a, i, order), wanted, time, end - time)
        return
    kinds = order.kind, wanted.kind
    if order.tie is not None and wanted.tie is not None:
        if order.tie.ratio != wanted.tie.ratio:
            words = f"it follows at {order.tie.ratio:g}, commanded {wanted.tie.ratio:g}"
            proof.breaks(order.line, f"{where}: {words}")
    elif kinds in (("move", "stop"), ("jog", "stop")):
        proof.breaks(order.line, f"{where}: it continues, commanded to stop")
    elif kinds == ("jog", "jog") and order.goal != wanted.goal:
        words = f"it goes to {order.goal:g} counts/s, commanded {wanted.goal:g}"
        proof.breaks(order.line, f"{where}: {words}")
    elif kinds == ("move", "move") and a.profiles[i].pieced:
        elapsed = time - a.starts[i]
        state = a.profiles[i].at(elapsed)
        entry = state.velocity, state.acceleration
        is_heeded = _could_stop(wanted, a.profiles[i], elapsed)
        if not is_heeded:
            proof.excuses(LATE)
        lower = _lower(order, wanted, is_heeded)
        check_bounds(proof, lower, spans(a.profiles[i], elapsed, end - time), entry, where)


def _could_stop(order: Order, profile: Profile, elapsed: float) -> bool:
    """True if a move certainly has room for a stop by an order.

    An axis that moves away from its target, or passes it to turn round, has all room.
    """
    state = profile.at(elapsed)
    ahead = copysign(1.0, state.velocity)
    room = ahead * (profile.end - state.position)
    farthest = ahead * profile.after(elapsed).extrema()[ahead > 0.0]
    turns = room < 0.0 or farthest - ahead * profile.end > SLACK * room
    needed = stopping_distance(order, state.velocity, state.acceleration)
    return needed < (inf if turns else room * (1.0 - SLACK))


def _check_path_setting(
    proof: Proof, run: RunRecords, order: Order, wanted: Order, time: float, length: float
) -> None:
    assert order.path is not None
    assert wanted.path is not None
    layout, along = rest_along(run, order, time, length)
    if not along:
        return
    is_heeded = could_stop(wanted, layout, along)
    if is_heeded and wanted.path.comes_to_rest:
        where = f"path from {order.path.begun:.6f} s at {time:.6f} s"
        proof.breaks(order.line, f"{where}: it continues, commanded to stop")
    elif not is_heeded and order.rates != wanted.rates:
        proof.excuses(LATE)
    else:
        lower = _lower(order, wanted, is_heeded)
        path = order.path._replace(most=tuple(map(min, order.path.most, wanted.path.most)))
        lower = lower._replace(path=path)
        check_rest(proof, run, lower, lower, time, length)


def _lower(order: Order, wanted: Order, is_heeded: bool) -> Order:
    """Return an order with the lower speed of two; also with the lower rates if they do not come too late."""
    rates = min(order.rates[0], wanted.rates[0]), min(order.rates[1], wanted.rates[1])
    return order._replace(speed=min(order.speed, wanted.speed), rates=rates if is_heeded else order.rates)
