"""Each axis's share of a path's speed and rates in a proof, by hand."""

from __future__ import annotations

from math import cos, hypot, inf, pi, sin, sqrt

import pytest

from motionlang.commands.prove.order import PathOrder
from motionlang.commands.prove.path_layout import PathLayout, end_positions

FREE = (inf, inf)


def arc(angle: float) -> PathOrder:
    return PathOrder(
        (0, 1), (1.0, 1.0), 0.0, 0, False, (), (0.0, 0.0), angle, (), (0, 1), None, FREE, FREE, FREE, 0.0
    )  # fmt: skip


def test_a_quarter_of_a_circle_has_the_whole_acceleration_in_each_axis() -> None:
    layout = PathLayout(arc(90.0), [10.0, 0.0])
    assert layout.length == pytest.approx(5.0 * pi)
    assert layout.rates(0.0, layout.length, 3.0, 20.0) == pytest.approx([hypot(3.0, 40.0)] * 2)


def test_a_segment_of_an_arc_has_the_slopes_of_its_ends() -> None:
    begin, end = 30.0 * pi / 180.0, 50.0 * pi / 180.0
    layout = PathLayout(arc(20.0), [10.0 * cos(begin), 10.0 * sin(begin)])
    assert layout.slopes(0.0, layout.length) == pytest.approx([sin(end), cos(begin)])
    assert layout.ends == pytest.approx([10.0 * cos(end), 10.0 * sin(end)])


def line(ends: tuple[float, float], relative: bool = False, length: float | None = None) -> PathOrder:
    """Return a line of two axes with 2 and -4 counts per unit."""
    return PathOrder(
        (0, 1), (2.0, -4.0), 0.0, 0, relative, ends, (0.0, 0.0), 0.0, (), (0, 1), length, FREE, FREE, FREE, 0.0
    )  # fmt: skip


# A line of (6, 8) units from (3, 2): its ends, whether they are relative, and the nominal length. Expected are
# the length, the stretch, and the distance from the origin: (0.6 * 3 + 0.8 * 2) = 3.4, by the stretch.
LINES: dict[str, tuple[tuple[float, float], bool, float | None, float, float, float]] = {
    "absolute": ((18.0, -40.0), False, None, 10.0, 1.0, 3.4),
    "relative": ((12.0, -32.0), True, None, 10.0, 1.0, 3.4),
    "that counts as twice as long": ((12.0, -32.0), True, 20.0, 20.0, 0.5, 6.8),
    "that counts as nothing": ((12.0, -32.0), True, 0.0, 0.0, 1.0, 3.4),
}


@pytest.mark.parametrize("name", LINES)
def test_a_line_is_laid_out_in_user_units(name: str) -> None:
    """The line begins at (6, -8) counts, and is measured in units.

    The point (6, 2) is (3, 0) from there, (1.08, 1.44) of it along the line: 1.92 off in x, 1.44 in y.
    """
    ends, relative, nominal, length, stretch, origin = LINES[name]
    layout = PathLayout(line(ends, relative, nominal), [6.0, -8.0])
    assert layout.first == [3.0, 2.0]
    assert layout.ends == [18.0, -40.0]
    assert layout.unit == pytest.approx([0.6, 0.8])
    assert (layout.length, layout.stretch, layout.angle_rate) == (length, stretch, 0.0)
    assert layout.origin == pytest.approx(origin)
    assert layout.slopes(0.0, 1.0) == pytest.approx([0.6 * stretch, 0.8 * stretch])
    assert layout.rates(0.0, 1.0, 50.0, 7.0) == pytest.approx([30.0 * stretch, 40.0 * stretch])
    assert layout.off([12.0, -8.0]) == pytest.approx(1.92)
    assert layout.off([18.0, -40.0]) == pytest.approx(0.0, abs=1e-12)


def test_a_line_with_a_length_alone_moves_no_axis() -> None:
    layout = PathLayout(line((0.0, 0.0), True, 5.0), [6.0, -8.0])
    assert (layout.length, layout.stretch, layout.origin, layout.unit) == (5.0, 0.0, 0.0, [0.0, 0.0])
    assert layout.slopes(0.0, 5.0) == [0.0, 0.0]


def helix(angle: float, relative: bool = True, length: float | None = None) -> PathOrder:
    """Return an arc about (0, 3) units in the plane of the third and the first axis.

    The second axis goes from 6 to 36 counts.
    """
    centre, rest = ((-40.0, 0.0), (30.0,)) if relative else ((0.0, 1.5), (36.0,))
    return PathOrder(
        (0, 1, 2), (0.5, 2.0, 4.0), 0.0, 0, relative, (), centre, angle, rest, (2, 0), length,
        FREE, FREE, FREE, 0.0,
    )  # fmt: skip


HELIX_START = [1.5, 6.0, 40.0]


@pytest.mark.parametrize("relative", [True, False])
@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_helix_is_laid_out_in_user_units(relative: bool, sense: float) -> None:
    """A quarter circle of 10 units begins at (10, 3): 40 counts of the third axis.

    It is 5 pi long, and the second axis travels 30 counts, 15 units.
    """
    layout = PathLayout(helix(90.0 * sense, relative), HELIX_START)
    length = hypot(5.0 * pi, 15.0)
    assert layout.ends == pytest.approx([1.5 + 5.0 * sense, 36.0, 0.0])
    assert layout.unit is None
    assert (layout.stretch, layout.length) == pytest.approx((1.0, length))
    assert layout.at(0.0) == pytest.approx(HELIX_START)
    assert layout.at(length / 3.0) == pytest.approx([1.5 + 2.5 * sense, 16.0, 20.0 * sqrt(3.0)])
    flat, climb = 5.0 * pi / length, 15.0 / length
    assert layout.slopes(0.0, length / 3.0) == pytest.approx([flat, climb, 0.5 * flat])
    assert layout.slopes(length / 3.0, length) == pytest.approx([flat * 0.5 * sqrt(3.0), climb, flat])
    # At a standstill the acceleration is along the path; a speed of 6 adds flat² 6² / 10 across it.
    assert layout.rates(0.0, length / 3.0, 2.0, 0.0) == pytest.approx([2.0 * flat, 2.0 * climb, flat])
    across = (flat * 6.0) ** 2 / 10.0
    assert layout.rates(0.0, length / 3.0, 0.0, 6.0) == pytest.approx([0.5 * across, 0.0, across])
    # Both are largest at 45 degrees, if they are equal.
    rates = layout.rates(0.0, length, across / flat, 6.0)
    assert rates == pytest.approx([across * sqrt(2.0), across / flat * climb, across * sqrt(2.0)])
    assert layout.off([1.5, 99.0, 44.0]) == pytest.approx(1.0)
    assert layout.off([1.5 - 4.75, 99.0, 0.0]) == pytest.approx(0.5)


def test_a_helix_may_count_as_longer_than_it_is() -> None:
    """A quarter of 10 units counts as 25: 5 pi / 25 of the speed is in its plane."""
    layout = PathLayout(helix(90.0, length=25.0), HELIX_START)
    assert (layout.length, layout.stretch) == (25.0, 1.0)
    assert layout.angle_rate == pytest.approx(0.5 * pi / 25.0)
    assert layout.slopes(0.0, 25.0) == pytest.approx([0.2 * pi, 0.6, 0.2 * pi])
    assert layout.at(12.5)[1] == 21.0


def test_the_ends_of_an_arc_of_axes_with_other_scales() -> None:
    """From (10, 0) about (4, 0) to (-2, 0); the other axis goes to 7 or by 7 counts."""
    made = [
        end_positions(
            PathOrder(
                (0, 1, 2), (2.0, 1.0, -5.0), 0.0, 0, relative, (), centre, 180.0, (7.0,), (0, 2), None,
                FREE, FREE, FREE, 0.0,
            ),
            [20.0, 3.0, 0.0],
        )
        for relative, centre in ((False, (8.0, 0.0)), (True, (-12.0, 0.0)))
    ]  # fmt: skip
    assert made == [pytest.approx([-4.0, 7.0, 0.0], abs=1e-9), pytest.approx([-4.0, 10.0, 0.0], abs=1e-9)]
