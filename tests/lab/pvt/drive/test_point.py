"""Bad points, reported with their index and the reaction of a drive."""

from __future__ import annotations

from math import inf, nan

import pytest

from motionlang.lab.pvt.drive.point import BadPoint, WirePoint, check_points, from_wire, to_wire
from motionlang.lab.pvt.points import Point

GOOD = Point(0, 0, 0.01)
END = Point(10, 0, 0.0)


@pytest.mark.parametrize(
    ("points", "index", "reason", "consequence"),
    [
        (
            [GOOD, Point(1, 0, 0.0), GOOD, END],
            1,
            "the time is 0 in mid-move",
            "the drive would end the move at this point and keep the 2 points after it for the next start",
        ),
        (
            [GOOD, Point(1, 0, 0.0), END],
            1,
            "the time is 0 in mid-move",
            "the drive would end the move at this point and keep the point after it for the next start",
        ),
        (
            [GOOD, Point(1, 0, 0.256), END],
            1,
            "the time 256 ms is longer than 255 ms",
            "the field holds eight bits: the drive would end the move at this point",
        ),
        (
            [GOOD, Point(1, 0, 0.3), END],
            1,
            "the time 300 ms is longer than 255 ms",
            "the field holds eight bits: the drive would take 44 ms",
        ),
        (
            [GOOD, Point(3e9, 0, 0.01), END],
            1,
            "the position 3000000000 counts does not fit 32 bits",
            "the drive would read -1294967296 counts",
        ),
        (
            [GOOD, Point(0, -3e8, 0.01), END],
            1,
            "the velocity -300000000 counts/s does not fit 32 bits",
            "the drive would read 129496729.6 counts/s",
        ),
        (
            [GOOD, Point(nan, 0, 0.01), END],
            1,
            "the position is not a number",
            "there is nothing that could be sent: no drive would see it",
        ),
        (
            [GOOD, Point(0, inf, 0.01), END],
            1,
            "the velocity is infinite",
            "there is nothing that could be sent: no drive would see it",
        ),
        (
            [GOOD, Point(0, 0, -0.01), END],
            1,
            "the time is negative",
            "there is nothing that could be sent: no drive would see it",
        ),
        (
            [GOOD, Point(0, 0, 0.0025), END],
            1,
            "the time 2.5 ms is not a whole number of milliseconds",
            "the drive would take 2 ms",
        ),
        (
            [GOOD, Point(0, 0, 0.0004), END],
            1,
            "the time 0.4 ms is not a whole number of milliseconds",
            "the drive would end the move at this point",
        ),
        (
            [GOOD, GOOD],
            1,
            "the last point does not end the move: its time is not 0",
            "the drive would reach it, find its buffer empty, flag an underflow and brake",
        ),
        ([], 0, "there are no points", "the drive would have nothing to start with"),
    ],
)
def test_each_bad_point_says_what_the_drive_would_do(
    points: list[Point], index: int, reason: str, consequence: str
) -> None:
    (bad,) = check_points(points)
    assert (bad.index, bad.reason, bad.consequence, bad.severe) == (index, reason, consequence, True)
    with pytest.raises(ValueError, match=f"point {index}"):
        to_wire(points)


def test_good_points_have_no_messages() -> None:
    assert check_points([GOOD, Point(-(2.0**31), 214_748_364.7, 0.255), Point(5, None, 0.001), END]) == []


def test_a_start_elsewhere_is_a_step() -> None:
    assert check_points([GOOD, END], start=100.0) == [
        BadPoint(
            0,
            "the move begins at 0 but the motor is at 100",
            "the drive would command a step of -100 counts at once",
            severe=False,
        )
    ]
    assert check_points([GOOD, END], start=0.0) == []
    assert check_points([Point(0, 0, 0.01, relative=True), END], start=100.0) == []


def test_rounding_is_to_whole_counts_and_tenths() -> None:
    points = [Point(0.4, 12.34, 0.01), Point(83.6, None, 0.1, relative=True), Point(-0.6, -12.36, 0.0)]
    assert to_wire(points) == [
        WirePoint(0, 123, 10),
        WirePoint(84, None, 100, relative=True),
        WirePoint(-1, -124, 0),
    ]
    assert from_wire(to_wire(points))[0] == Point(0.0, 12.3, 0.01)
