"""Overlapping paths, at most two: the proof rejects a wrong ramp or sum."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang import run
from motionlang.log.order import Order
from motionlang.result import Run
from motionlang.source import Source

# The second path begins 6 uu before the first one ends: at 0.8 s, 0.2 s before that slows down.
BLEND = (
    "SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100\nBLENDMODE(0) = 1 : BLENDDISTANCE(0) = 6\n"
    "VECTORR(0, 1) = 20, 0\nVECTORR(0, 1) = 0, 20\nGO(0)\nPAUSE IDLE(0)\n"
)


def proved() -> Run:
    machine = {"controller.instruction_time": 1e-9}
    result = run(Source("blend.mnt", BLEND), machine=machine, prove=True)
    assert result.diagnostics == []
    return result


def found(result: Run) -> list[str]:
    return [each.message for each in result.proof(views=False).violations]


def forge(result: Run, made: Callable[[Order], Order]) -> None:
    """Change the order of the first path, with which the second one is blended."""
    assert result.expected_motion is not None
    for axis, records in result.expected_motion.of.items():
        for k, order in enumerate(records):
            if order.path is not None and order.path.tails:
                tails = tuple(made(each) for each in order.path.tails)
                result.expected_motion.of[axis][k] = order._replace(path=order.path._replace(tails=tails))


def test_two_paths_that_overlap_are_proved() -> None:
    """The second axis speeds up from 0.8 s to 1.0 s, the first slows down until 1.2 s."""
    result = proved()
    assert found(result) == []
    axes = result.controller.axes
    speeds = [axes[k].velocity(time) for time in (0.9, 1.1) for k in (0, 1)]
    assert speeds == pytest.approx([20.0, 10.0, 10.0, 20.0], abs=1e-4)


@pytest.mark.parametrize(
    ("made", "message"),
    [
        (lambda o: o._replace(speed=5.0), "the path speed reaches 20, above 5"),
        (lambda o: o._replace(path=o.path._replace(most=(5.0, 5.0))), "speed on paths of axis 0 reaches 20"),
        (lambda o: o._replace(rates=(100.0, 90.0)), "the path deceleration reaches 100, above 90"),
    ],
)
def test_a_path_that_goes_on_beneath_another_one_keeps_its_own_bounds(
    made: Callable[[Order], Order], message: str
) -> None:
    result = proved()
    forge(result, made)
    assert any(message in each for each in found(result)), found(result)


def test_three_paths_at_once_are_found() -> None:
    result = proved()
    assert result.expected_motion is not None
    for records in result.expected_motion.of.values():
        for k, order in enumerate(records):
            if order.path is not None and order.path.tails:
                path = order.path._replace(tails=order.path.tails * 2)
                records[k] = order._replace(path=path)
    assert any("3 paths overlap at 0.8" in each for each in found(result)), found(result)


def test_a_sum_that_is_not_that_of_its_paths_is_found() -> None:
    """The first path is forged to run at 21 uu/s while the sum has 20 uu/s for it."""
    result = proved()
    first = result.controller.log.moves[0]
    assert first.profile is not None
    first.profile = first.profile.scaled(first.profile.start, 1.05)
    assert any("its paths add up to" in each for each in found(result)), found(result)
