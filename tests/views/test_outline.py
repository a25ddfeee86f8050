"""The outline of a picture contains every peak of the motion."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from motionlang.controller.controller import Controller
from motionlang.result import Run
from motionlang.views.outline import outline
from tests.views.runs import ballscrew, pick, shift


@pytest.mark.parametrize("make", [ballscrew, pick, shift])
@pytest.mark.parametrize("quantity", ["position", "velocity", "acceleration"])
@pytest.mark.parametrize("bins", [50, 1000])
def test_extremes_are_those_of_a_fine_sampling(make: Callable[[], Run], quantity: str, bins: int) -> None:
    run = make()
    for axis in run.trace.axes:
        times, values = outline(run.trace, axis, quantity, bins=bins)
        fine = run.trace.sample(5000.0, (axis,), quantities=(quantity,)).get(axis, quantity)
        reach = max(1e-6, float(np.abs(fine).max()))
        assert values.max() >= fine.max() - 1e-4 * reach
        assert values.min() <= fine.min() + 1e-4 * reach
        assert np.all(np.diff(times) >= 0.0)
        assert times[0] == 0.0
        assert times[-1] == pytest.approx(run.time)
        assert len(times) <= max(9 * bins, 2 * bins + 2)


def test_a_jump_is_drawn_upright() -> None:
    times, values = outline(ballscrew().trace, 0, "acceleration")
    jumps = np.flatnonzero(np.abs(np.diff(values)) > 1.0)
    assert len(jumps) == 3
    np.testing.assert_allclose(np.diff(times)[jumps], 0.0, atol=1e-12)


def test_nothing_moved_is_one_point() -> None:
    times, values = outline(Controller(1).trace, 0, "position")
    assert (times.tolist(), values.tolist()) == ([0.0], [0.0])
