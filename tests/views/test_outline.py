"""The outline of a picture contains every peak of the motion."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from motionlang.kernel import Controller, Run, Trace
from motionlang.views.outline import outline, thinned
from tests.views.runs import ballscrew, pick, short_shift


@pytest.mark.parametrize("make", [ballscrew, pick, short_shift])
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
    times, values = outline(Trace(Controller(1)), 0, "position")
    assert (times.tolist(), values.tolist()) == ([0.0], [0.0])


def test_a_window_has_the_values_of_the_motion_in_it() -> None:
    """From 0.05 to 0.9 s: a part of each ramp, and the slew at 250 uu/s.

    The speed is 1250 uu/s² times the time since 50 µs, or up to the end at 1.00005 s. The window has ten even steps.
    """
    times, values = outline(ballscrew().trace, 0, "velocity", (0.05, 0.9), bins=10)
    expected = np.minimum(250.0, 1250.0 * np.minimum(times - 5e-5, 1.00005 - times))
    np.testing.assert_allclose(values, expected, atol=1e-6)
    assert (times[0], times[-1]) == pytest.approx((0.05, 0.9))
    assert all(np.abs(times - each).min() < 1e-9 for each in np.linspace(0.05, 0.9, 11))


@pytest.mark.parametrize(
    ("count", "left"), [(16, [k / 15 for k in range(16)]), (17, [0.0, 7 / 16, 8 / 16, 1.0])]
)
def test_more_than_eight_points_a_bin_are_thinned_to_its_extremes(count: int, left: list[float]) -> None:
    """Two bins of a rising line have two extremes each.

    The first and the last point occur twice.
    """
    times = np.linspace(0.0, 1.0, count)
    found, values = thinned(times, 3.0 * times, (0.0, 1.0), bins=2)
    assert sorted(set(found.tolist())) == pytest.approx(left)
    np.testing.assert_allclose(values, 3.0 * found)
    assert (found[0], found[-1]) == (0.0, 1.0)


@pytest.mark.parametrize(
    ("span", "kept"),
    [((0.0, 5.0), [0, 1, 2, 3, 4, 5]), ((2.5, 4.0), [2, 3, 4]), ((2.0, 3.9), [1, 2, 3]), ((0.5, 0.5), [0])],
)
def test_a_line_enters_a_window_from_the_left(span: tuple[float, float], kept: list[int]) -> None:
    """The last point before the window belongs to it."""
    times = np.arange(6.0)
    found, values = thinned(times, 10.0 * times, span)
    assert found.tolist() == kept
    assert values.tolist() == [10.0 * each for each in kept]
