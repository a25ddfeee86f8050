"""Lines and arcs: lengths, tangents, ends and limits by hand.

The circle has a radius of 100 counts, which are 10 units at 10 counts per unit.
"""

from __future__ import annotations

from math import cos, hypot, inf, pi, radians, sin, sqrt

import pytest

from motionlang.kernel.controller import Line
from motionlang.kernel.controller.moves.geometry import Arc, Segment, corner, limits
from tests.cases import cases

ROUND = 5.0 * pi  # a quarter of the circle, units


def at(segment: Segment, distance: float) -> list[float]:
    """Return the positions of the axes, counts, after a distance in units."""
    return [curve.position(distance) for curve in segment.curves]


def tens(*values: float) -> object:
    return pytest.approx(list(values), abs=1e-9)


def test_a_line_of_3_by_4_units_is_5_long() -> None:
    """From 40, 120 to 70, 200 counts at 10 and 20 counts per unit."""
    laid = Line([70.0, 200.0]).lay([40.0, 120.0], [10.0, 20.0])
    assert laid.length == 5.0
    assert at(laid, 2.5) == tens(55.0, 160.0)
    assert laid.ends == [70.0, 200.0]
    assert laid.entry == laid.leaving == [0.6, 0.8]
    assert (laid.steepest(0), laid.steepest(1), hypot(*laid.entry), laid.curvature) == (6.0, 16.0, 1.0, 0.0)
    laid.shift(1, 5.0)
    assert at(laid, 2.5) == tens(55.0, 165.0)
    assert laid.ends == [70.0, 205.0]
    assert laid.starts is None


def test_a_line_with_a_length_of_its_own() -> None:
    laid = Line([70.0, 200.0], 10.0).lay([40.0, 120.0], [10.0, 20.0])
    assert (laid.length, hypot(*laid.entry)) == (10.0, 0.5)
    assert laid.entry == [0.3, 0.4]
    assert at(laid, 5.0) == tens(55.0, 160.0)


def test_a_line_that_leads_nowhere() -> None:
    laid = Line([40.0, 120.0]).lay([40.0, 120.0], [10.0, 20.0])
    assert (laid.length, list(laid.curves), laid.ends) == (0.0, [], [40.0, 120.0])
    laid.shift(0, 5.0)
    assert laid.ends == [45.0, 120.0]


def test_a_line_counted_from_another_start() -> None:
    line = Line([10.0, 20.0], 7.0).moved([1.0, 2.0])
    assert (line.targets, line.length) == ([11.0, 22.0], 7.0)
    line.shift(0, 3.0)
    assert line.targets == [14.0, 22.0]
    assert line.ends([0.0, 0.0], [1.0, 1.0]) == [14.0, 22.0]


@cases(
    "angle, middle, end, entry, leaving",
    [
        (90.0, 45.0, (0.0, 100.0), (0.0, 1.0), (-1.0, 0.0)),
        (-90.0, -45.0, (0.0, -100.0), (0.0, -1.0), (-1.0, 0.0)),
        (30.0, 15.0, (50.0 * sqrt(3.0), 50.0), (0.0, 1.0), (-0.5, 0.5 * sqrt(3.0))),
        (180.0, 90.0, (-100.0, 0.0), (0.0, 1.0), (0.0, -1.0)),
        (270.0, 135.0, (0.0, -100.0), (0.0, 1.0), (1.0, 0.0)),
        (360.0, 180.0, (100.0, 0.0), (0.0, 1.0), (0.0, 1.0)),
        (-360.0, -180.0, (100.0, 0.0), (0.0, -1.0), (0.0, -1.0)),
        (720.0, 360.0, (100.0, 0.0), (0.0, 1.0), (0.0, 1.0)),
    ],
)
def test_an_arc(
    angle: float,
    middle: float,
    end: tuple[float, float],
    entry: tuple[float, float],
    leaving: tuple[float, float],
) -> None:
    """From 100, 0 about 0, 0.

    Again about 7, -3 and with 20 counts per unit of the second axis.
    """
    half = radians(middle)
    for (cx, cy), ky in (((0.0, 0.0), 10.0), ((7.0, -3.0), 20.0)):
        arc, scales = Arc((cx, cy), angle), (10.0, ky)
        laid = arc.lay((100.0 + cx, cy), scales)
        assert laid.length == pytest.approx(10.0 * radians(abs(angle)))
        assert at(laid, 0.5 * laid.length) == tens(100.0 * cos(half) + cx, 10.0 * ky * sin(half) + cy)
        ends = tens(end[0] + cx, end[1] * ky / 10.0 + cy)
        assert at(laid, laid.length) == laid.ends == arc.ends((100.0 + cx, cy), scales) == ends
        assert laid.entry == tens(*entry)
        assert laid.leaving == tens(*leaving)
        assert laid.curvature == pytest.approx(0.1)
        assert hypot(*laid.entry) == pytest.approx(1.0)
        assert laid.starts is None


@cases(
    "plane, start, end",
    [
        ((0, 1), (100.0, 0.0, 5.0), (0.0, 100.0, 35.0)),
        ((1, 0), (0.0, 100.0, 5.0), (100.0, 0.0, 35.0)),
        ((0, 2), (100.0, 5.0, 0.0), (0.0, 35.0, 100.0)),
        ((2, 0), (0.0, 5.0, 100.0), (100.0, 35.0, 0.0)),
        ((1, 2), (5.0, 100.0, 0.0), (35.0, 0.0, 100.0)),
        ((2, 1), (5.0, 0.0, 100.0), (35.0, 100.0, 0.0)),
    ],
)
def test_a_helix(plane: tuple[int, int], start: tuple[float, ...], end: tuple[float, ...]) -> None:
    """A quarter of the circle in the plane of two axes.

    The third one climbs 30 counts, 15 units.
    """
    rise = next(axis for axis in range(3) if axis not in plane)
    scales = [2.0 if axis == rise else 10.0 for axis in range(3)]
    arc = Arc((0.0, 0.0), 90.0, [35.0], plane=plane)
    laid = arc.lay(start, scales)
    length = hypot(ROUND, 15.0)
    assert laid.length == pytest.approx(length)
    assert at(laid, length) == laid.ends == arc.ends(start, scales) == tens(*end)
    assert at(laid, 0.5 * length)[rise] == pytest.approx(20.0)
    assert laid.entry[rise] == laid.leaving[rise] == pytest.approx(15.0 / length)
    assert hypot(*laid.entry) == hypot(*laid.leaving) == pytest.approx(1.0)
    assert laid.entry[plane[1]] == -laid.leaving[plane[0]] == pytest.approx(ROUND / length)
    for axis in range(3):
        shifted = Arc((0.0, 0.0), 90.0, [35.0], plane=plane, arrives=(0.0, 100.0))
        shifted.shift(axis, 7.0)
        moved = [each + 7.0 * (k == axis) for k, each in enumerate(start)]
        expected = [each + 7.0 * (k == axis) for k, each in enumerate(end)]
        assert shifted.ends(moved, scales) == shifted.lay(moved, scales).ends == tens(*expected)
        assert at(shifted.lay(moved, scales), length) == tens(*expected)


def test_an_arc_counted_from_another_start() -> None:
    arc = Arc((-100.0, 0.0), 90.0, [30.0], 9.0, (0, 2), (-100.0, 100.0)).moved([1.0, 2.0, 3.0])
    assert (arc.centre, arc.rest, arc.arrives) == ((-99.0, 3.0), [32.0], (-99.0, 103.0))
    assert (arc.angle, arc.length, arc.plane) == (90.0, 9.0, (0, 2))
    assert Arc((-100.0, 0.0), 90.0).moved([1.0, 2.0]).arrives is None


def test_an_arc_with_an_end_of_its_own_keeps_both_ends() -> None:
    laid = Arc((0.0, 0.0), 90.0, arrives=(0.25, 100.0)).lay((100.0, 0.0), (10.0, 10.0))
    assert laid.ends == [0.25, 100.0]
    assert list(laid.starts or ()) == [100.0, 0.0]
    laid.shift(0, 5.0)
    assert laid.ends == [5.25, 100.0]
    assert list(laid.starts or ()) == [105.0, 0.0]


def test_an_arc_with_a_length_of_its_own() -> None:
    laid = Arc((0.0, 0.0), 90.0, length=2.0 * ROUND).lay((100.0, 0.0), (10.0, 10.0))
    assert laid.length == 2.0 * ROUND
    assert hypot(*laid.entry) == pytest.approx(0.5)
    assert laid.curvature == pytest.approx(0.05)


def test_the_tangents_of_an_arc_are_in_units_per_unit_of_its_length() -> None:
    """From 6, 8 units to -8, 6, with twice the length in space."""
    laid = Arc((3.0, -4.0), 90.0, length=2.0 * ROUND).lay((63.0, 76.0), (10.0, 10.0))
    assert laid.entry == tens(-0.4, 0.3)
    assert laid.leaving == tens(-0.3, -0.4)


def test_the_centre_of_an_arc_is_shifted_in_its_own_axis() -> None:
    for axis, centre in ((0, (10.0, -4.0)), (1, (3.0, 3.0))):
        arc = Arc((3.0, -4.0), 90.0, arrives=(1.0, 2.0))
        arc.shift(axis, 7.0)
        assert arc.centre == centre
        assert arc.arrives == ((8.0, 2.0) if axis == 0 else (1.0, 9.0))


def test_an_arc_of_no_angle_is_the_line_of_its_other_axes() -> None:
    nothing = Arc((0.0, 0.0), 0.0).lay((100.0, 0.0), (10.0, 10.0))
    assert (nothing.length, list(nothing.curves), list(nothing.ends)) == (0.0, [], [100.0, 0.0])
    assert Arc((0.0, 0.0), 90.0, length=0.0).lay((100.0, 0.0), (10.0, 10.0)).length == 0.0
    for arc in (Arc((0.0, 0.0), 0.0, [50.0]), Arc((100.0, 0.0), 90.0, [50.0])):  # no angle, or no radius
        climb = arc.lay((100.0, 0.0, 20.0), (10.0, 10.0, 10.0))
        assert (climb.length, climb.entry) == (3.0, [0.0, 0.0, 1.0])
        assert at(climb, 1.5) == tens(100.0, 0.0, 35.0)


@cases("turned", [0.0, 1e-4, 0.01, 1.0, 20.0, 25.0, 26.0, 30.0, 45.0, 90.0, 120.0, 179.0, 180.0])
def test_the_corner_between_two_lines_is_the_angle_of_their_directions(turned: float) -> None:
    """A small angle is exact to a millionth of it."""
    first = Line([30.0, 40.0]).lay([0.0, 0.0], [10.0, 10.0])
    c, s = cos(radians(turned)), sin(radians(turned))
    for sign in (1.0, -1.0):
        second = Line([3.0 * c - sign * 4.0 * s, 4.0 * c + sign * 3.0 * s]).lay([0.0, 0.0], [1.0, 1.0])
        assert corner(first, second) == pytest.approx(turned, rel=1e-6, abs=1e-6)


def test_a_corner_of_an_arc_is_that_of_its_tangents_and_of_nothing_is_180() -> None:
    arc = Arc((0.0, 0.0), 90.0).lay((100.0, 0.0), (10.0, 10.0))
    back, up = (Line(end).lay((0.0, 100.0), (10.0, 10.0)) for end in ([-50.0, 100.0], [0.0, 150.0]))
    nothing = Line([0.0, 100.0]).lay((0.0, 100.0), (10.0, 10.0))
    assert corner(arc, back) == pytest.approx(0.0, abs=1e-6)
    assert corner(arc, up) == pytest.approx(90.0)
    assert corner(up, arc) == pytest.approx(0.0, abs=1e-6)
    assert corner(arc, nothing) == corner(nothing, arc) == 180.0


@cases(
    "speeds, accels, decels, expected",
    [
        # 6 and 16 counts per unit.
        ((60.0, inf), (inf, inf), (inf, inf), (10.0, inf, inf)),
        ((60.0, 80.0), (600.0, inf), (inf, 320.0), (5.0, 100.0, 20.0)),
        ((inf, inf), (600.0, 160.0), (60.0, 320.0), (inf, 10.0, 10.0)),
        ((inf, inf), (inf, inf), (inf, inf), (inf, inf, inf)),
    ],
)
def test_limits_along_a_line(
    speeds: tuple[float, ...],
    accels: tuple[float, ...],
    decels: tuple[float, ...],
    expected: tuple[float, float, float],
) -> None:
    laid = Line([70.0, 200.0]).lay([40.0, 120.0], [10.0, 20.0])
    assert limits(laid, speeds, accels, decels) == pytest.approx(expected)
    assert limits(Line([1.0]).lay([1.0], [1.0]), speeds[:1], accels[:1], decels[:1]) == (inf, inf, inf)


# The share of the acceleration for the curvature and for the change of speed: 1/√2 where the axis has its largest
# slope and curvature and 45° in between. From 0° to 30° it is least at 30°: 1 / (1 + cos 30°).
SHARE = 1.0 / (1.0 + cos(radians(30.0)))


@cases(
    "begin, angle, accels, decels, expected",
    [
        # The largest slope is 10 counts per unit, the largest curvature 1 count per unit².
        (
            0.0,
            360.0,
            (100.0, inf),
            (200.0, inf),
            (sqrt(100.0 / sqrt(2.0)), 10.0 / sqrt(2.0), 20.0 / sqrt(2.0)),
        ),
        (
            0.0,
            90.0,
            (200.0, inf),
            (100.0, inf),
            (sqrt(100.0 / sqrt(2.0)), 20.0 / sqrt(2.0), 10.0 / sqrt(2.0)),
        ),
        (
            0.0,
            -90.0,
            (inf, 100.0),
            (inf, 100.0),
            (sqrt(100.0 / sqrt(2.0)), 10.0 / sqrt(2.0), 10.0 / sqrt(2.0)),
        ),
        # The first axis has the slope 5 and the curvature 1, the second one 10 and 0.5.
        (0.0, 30.0, (100.0, inf), (100.0, inf), (sqrt(100.0 * SHARE), 20.0 * SHARE, 20.0 * SHARE)),
        (0.0, 30.0, (inf, 100.0), (inf, 100.0), (sqrt(200.0 * SHARE), 10.0 * SHARE, 10.0 * SHARE)),
        (0.0, 30.0, (100.0, 100.0), (100.0, 50.0), (sqrt(100.0 * SHARE), 10.0 * SHARE, 5.0 * SHARE)),
        (150.0, 30.0, (100.0, inf), (100.0, inf), (sqrt(100.0 * SHARE), 20.0 * SHARE, 20.0 * SHARE)),
        # From 20° to 70°: slope and curvature end at cos 20°, and add up most at 45°.
        (
            20.0,
            50.0,
            (100.0, inf),
            (100.0, inf),
            (sqrt(100.0 / sqrt(2.0)), 10.0 / sqrt(2.0), 10.0 / sqrt(2.0)),
        ),
    ],
)
def test_limits_along_an_arc(
    begin: float,
    angle: float,
    accels: tuple[float, float],
    decels: tuple[float, float],
    expected: tuple[float, float, float],
) -> None:
    start = 100.0 * cos(radians(begin)), 100.0 * sin(radians(begin))
    laid = Arc((0.0, 0.0), angle).lay(start, (10.0, 10.0))
    assert limits(laid, (inf, inf), accels, decels) == pytest.approx(expected)
    slow, _, _ = limits(laid, (5.0, inf), (inf, inf), (inf, inf))
    assert slow == pytest.approx(5.0 / laid.steepest(0))
