"""Contour arcs: the middle and the end of each kind of description, by hand."""

from __future__ import annotations

from math import sqrt

import pytest

from tests.cases import cases
from tests.mccl.conftest import Runner

START = 300, -200
HEAD = "1MN,2MN,1DH300,2DH-200,1CM1,2CM1,1VV200,1VA100000,1VD100000\n"
# 100 cos 45°.
C = 50.0 * sqrt(2.0)

# The points are those from the start. Half the time is half the angle, because both ramps are equal.
ARCS = [
    # Centre 100, 0: the start is at 180°. Clockwise over 90°, anticlockwise over 270°.
    ("1CP2,1CR100,2CR0,1MR200,2MR0", (100.0, 100.0), (200.0, 0.0)),
    ("1CP3,1CR100,2CR0,1MR200,2MR0", (100.0, -100.0), (200.0, 0.0)),
    # Radius 100 to 100, 100: clockwise the short way is about 100, 0, anticlockwise about 0, 100.
    ("1CP2,1RR100,1MR100,2MR100", (100.0 - C, C), (100.0, 100.0)),
    ("1CP3,1RR100,1MR100,2MR100", (C, 100.0 - C), (100.0, 100.0)),
    # The long way is about the other centre, 270°.
    ("1CP2,1RR-100,1MR100,2MR100", (-C, 100.0 + C), (100.0, 100.0)),
    ("1CP3,1RR-100,1MR100,2MR100", (100.0 + C, -C), (100.0, 100.0)),
    # A chord of just two radii is a half circle.
    ("1CP3,1RR100,1MR0,2MR200", (100.0, 100.0), (0.0, 200.0)),
    # Centre -100, 0: the start is at 0°. By angle: absolute, relative, and whole circles.
    ("1CP3,1CR-100,2CR0,1EA90", (C - 100.0, C), (-100.0, 100.0)),
    ("1CP2,1CR-100,2CR0,1EA90", (-C - 100.0, -C), (-100.0, 100.0)),
    ("1CP3,1CR-100,2CR0,1EA450", (C - 100.0, C), (-100.0, 100.0)),
    ("1CP2,1CR-100,2CR0,1ER90", (C - 100.0, -C), (-100.0, -100.0)),
    ("1CP2,1CR-100,2CR0,1ER-90", (C - 100.0, -C), (-100.0, -100.0)),
    ("1CP3,1CR-100,2CR0,1ER180", (-100.0, 100.0), (-200.0, 0.0)),
    ("1CP3,1CR-100,2CR0,1EA0", (-200.0, 0.0), (0.0, 0.0)),
    ("1CP2,1CR-100,2CR0,1EA-360", (-200.0, 0.0), (0.0, 0.0)),
    ("1CP2,1CR0,2CR100,1MR0,2MR0", (0.0, 200.0), (0.0, 0.0)),
    ("1CP2,1RR1,1MR1,2MR1", (1.0 - 0.01 * C, 0.01 * C), (1.0, 1.0)),
    # One degree: 100 sin 1° and 100 (1 - cos 1°).
    ("1CP3,1CR0,2CR100,1ER1", (0.8726535, 0.0038077), (1.7452406, 0.0152305)),
]  # fmt: skip


@cases("path, middle, end", ARCS)
def test_an_arc_goes_through_its_middle_to_its_end(
    path: str, middle: tuple[float, float], end: tuple[float, float], mccl: Runner
) -> None:
    result = mccl(f"{HEAD}{path}\n1WS")
    assert result.diagnostics == []
    first = result.controller.log.moves[0]
    assert first.profile is not None
    time = first.start_time + 0.5 * first.profile.duration
    for at, expected in ((time, middle), (result.time, end)):
        controller = result.controller
        there = [
            controller.axes[axis].at(at).position - here for axis, here in zip((1, 2), START, strict=True)
        ]
        assert there == pytest.approx(expected, abs=1e-5)


@cases(
    "path, message",
    [
        ("1CP3,1RR100,1MR0,2MR201", "a radius of 100 is too small for a chord of 201"),
        ("1CP3,1RR-100,1MR0,2MR250", "a radius of 100 is too small for a chord of 250"),
        ("1CP2,1RR100,1MR0,2MR0", "a full circle needs a centre, not a radius"),
        ("1CP2,1CR0,2CR0,1ER90", "the centre of the arc is its starting point"),
        ("1CP2,1MR100,2MR100", "an arc needs a centre (CA or CR) or a radius (RR)"),
        ("1CP2,1CR100,1MR100", "an arc needs two axes"),
        ("3MN,3CM1,1CP2,1CR100,2CR0,3CR0,1MR200,2MR0", "an arc lies in the plane of two axes"),
        # The radius is 10000 counts: an end may miss the circle by 10.
        (
            "1CP3,1CR0,2CR10000,1MR10011,2MR10000",
            "the end point is 10011 from the centre, the starting point 10000",
        ),
        (
            "1CP3,1CR0,2CR10000,1MR9989,2MR10000",
            "the end point is 9989 from the centre, the starting point 10000",
        ),
        # The end is 5.7° before the start: a circle through both would have its centre 90 counts away.
        (
            "1CP3,1CR0,2CR10000,1MR-999,2MR41",
            "the end point is 10009 from the centre, the starting point 10000, too much for nearly a full circle; "
            "use EA or ER to end it at an angle",
        ),
    ],
)
def test_an_arc_that_there_is_not_is_a_parameter_error(path: str, message: str, mccl: Runner) -> None:
    result = mccl(f"{HEAD}{path}\n1TP,2TP")
    assert result.output == ["?-1", "01 300", "02 -200"]
    assert result.diagnostics[0].message.startswith(f"the contour path cannot be run: {message} (?")


@cases("end", [10010, 9990])
def test_an_end_may_miss_the_circle_by_a_thousandth_of_the_radius(end: int, mccl: Runner) -> None:
    result = mccl(f"{HEAD}1VV100000,1VA1000000\n1CP3,1CR0,2CR10000,1MR{end},2MR10000\n1WS,1TP,2TP")
    assert result.output == [f"01 {300 + end}", "02 9800"]


def test_a_thousand_paths_may_wait(mccl: Runner) -> None:
    """The first line queues 1000 paths of a count each; a further one is refused."""
    result = mccl(f"{HEAD}1SN\n1CP1,1MR1,2MR0,RP999\n1CP1,1MR1,2MR0\n1TP")
    assert result.output == ["?-1", "01 300"]
    assert "1000 contour paths are waiting already" in result.diagnostics[0].message


@cases(
    "path, code, message",
    [
        ("1CP1,1WS", -1, "the contour path has no end point"),
        ("1CP1,1MA5,1MA6", -17, "axis 1 already has an end point in this path"),
        ("1CP1,3MA5", -15, "axis 3 is not in contour mode under axis 1"),
        ("2MF,1CP1,1MA5,2MA5", -2, "axis 2 is off"),
        ("1VV0,1CP1,1MA5", -1, "a contour path cannot be run: VV is 0"),
        ("1VA0,1CP1,1MA5", -1, "a contour path cannot be run: VA is 0"),
        ("1VD0,1CP1,1MA5", -1, "a contour path cannot be run: VD is 0"),
    ],
)
def test_a_path_that_cannot_be_queued(path: str, code: int, message: str, mccl: Runner) -> None:
    result = mccl(f"{HEAD}{path}\n1TP")
    assert result.output == [f"?{code}", "01 300"]
    assert result.diagnostics[0].message.startswith(f"{message} (?{code}: ")
