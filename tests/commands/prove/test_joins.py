"""Joins of profiles: the states on both sides, and the step of a stepper."""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.prove.checks import _both, _step
from motionlang.commands.prove.order import Order, PathOrder
from motionlang.kernel.planners import Profile, hold, plan_velocity
from tests.cases import cases

FREE = (inf, inf)
# 10 counts/s are reached after 0.25 s and 1.25 counts.
JOG = plan_velocity("trapezoid", 0.0, 0.0, 10.0, 40.0, 40.0)


def track(index: int, starts: list[float], profiles: list[Profile]) -> Any:
    return SimpleNamespace(
        index=index,
        starts=starts,
        profiles=profiles,
        index_at=lambda time: max(k for k, start in enumerate(starts) if start <= time),
    )


def test_both_sides_of_a_join_of_a_path() -> None:
    """Axis 0 stops at 2 s: 1.25 + 10 * 1.75 = 18.75.

    Axis 1 began at 0.5 s and continues: 1.25 + 10 * 1.25 = 13.75.
    """
    axes = {0: track(0, [0.0, 2.0], [JOG, hold(18.75)]), 1: track(1, [0.0, 0.5], [hold(0.0), JOG])}
    path = PathOrder(
        (0, 1), (1.0, 1.0), 0.0, 0, False, (), (0.0, 0.0), 0.0, (), (0, 1), None, FREE, FREE, FREE, 0.0
    )  # fmt: skip
    run: Any = SimpleNamespace(axes=axes)
    old, new = _both(run, Order("path", 1, path=path), 2.0)
    for found, positions, velocities in (
        (old, [18.75, 13.75], [10.0, 10.0]),
        (new, [18.75, 13.75], [0.0, 10.0]),
    ):
        assert [each.position for each in found] == pytest.approx(positions)
        assert [each.velocity for each in found] == pytest.approx(velocities)


MOVE, STOP = Order("step", 1, step=5.0), Order("stop", 2, step=3.0)


@cases(
    "orders, ends, step",
    [
        ((MOVE,), (-30.0,), 5.0),
        ((STOP,), (-30.0,), 3.0),
        # The stop continues the move to its end, or to another one.
        ((MOVE, STOP), (-30.0, -30.0), 5.0),
        ((MOVE, STOP), (-30.0, -30.00002), 5.0),
        ((MOVE, STOP), (-30.0, -29.0), 0.0),
        ((MOVE, STOP), (-0.5, -0.49999), 0.0),
        ((MOVE, MOVE), (-30.0, -40.0), 5.0),
        ((STOP, Order("step", 3, step=7.0)), (-30.0, -40.0), 7.0),
    ],
)
def test_the_step_of_a_stepper_at_the_end_of_a_profile(
    orders: tuple[Order, ...], ends: tuple[float, ...], step: float
) -> None:
    """Ends agree within 1e-6 of their size, which is at least 1 count."""
    a = track(0, [float(k) for k in range(len(ends))], [hold(end) for end in ends])
    run: Any = SimpleNamespace(expected_motion=SimpleNamespace(of={0: list(orders)}))
    assert _step(run, a, len(orders), orders[-1]) == step
