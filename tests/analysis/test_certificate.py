"""The extremes of a motion, by hand arithmetic and by samples; the certificate."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf, pi
from pathlib import Path

import pytest

from motionlang.analysis.certificate import (
    Limit,
    certificate,
    contradictions,
    least_margin,
    violations,
)
from motionlang.execution import run
from motionlang.log.extremes import Extreme, extremes, peak_speed
from motionlang.result import Run
from motionlang.source import Source
from motionlang.views.certificate import _row

SCRIPTS = Path(__file__).parents[2] / "scripts"
SET = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 500 : "
# The motion, and the lowest and highest position, speed, acceleration and jerk, user units and seconds.
MOTIONS: dict[str, tuple[str, tuple[float, float, float, float, float]]] = {
    "nothing": ("OUTX(1) = 1", (0, 0, 0, 0, 0)),
    "a trapezoid": ("MOVEA(0) = 40 : GO(0) : PAUSE IDLE(0)", (0, 40, 100, 1000, inf)),
    "there and beyond": ("MOVEA(0) = 9 : GO(0) : MOVEA(0) = -30 : GO(0) : PAUSE IDLE(0)", (-30, 9, 100, 1000, inf)),
    "a triangle": ("MOVEA(0) = 7.5 : GO(0) : PAUSE IDLE(0)", (0, 7.5, (15000 / 3) ** 0.5, 1000, inf)),
    "one that is cut off at once": ("JOG(0) = 80 : WAIT(500) : CANCEL(0)", (0, 80 * 0.5 - 3.2, 80, inf, inf)),
    "a jog that is on its way at the end": ("JOG(0) = 80", (0, 80 * 2.0 - 3.2, 80, 1000, inf)),
    "one that must turn": (
        "MOVEA(0) = 40 : GO(0) : PAUSE POS(0) > 20 : MOVEA(0) = 0 : STOP(0) : PAUSE IDLE(0) : GO(0) : PAUSE IDLE(0)",
        (0, 30, 100, 1000, inf),
    ),
}  # fmt: skip


@pytest.mark.parametrize("motion", MOTIONS)
def test_the_extremes_of_a_motion(motion: str) -> None:
    program, expected = MOTIONS[motion]
    result = run(Source("m.mnt", SET + program), until=2.0, cache=False)
    found = extremes(result.controller.axes[0], result.time)
    values = [found.lowest, found.highest, found.speed, found.acceleration, found.jerk]
    assert [each.value for each in values] == pytest.approx(list(expected), abs=3e-3), result.diagnostics
    assert peak_speed(result.controller.axes[0], result.time) == found.speed.value


def test_a_sinusoidal_ramp_has_its_crest_in_its_middle() -> None:
    result = run(Source("s.mcl", "1MN,1PS,1SV100,1SA500,1DS500\n1MR1000,1WS0\n"), cache=False)
    found = extremes(result.controller.axes[1], result.time)
    length = pi / 2 * 100 / 500  # of a sinusoidal ramp whose crest is the acceleration
    assert found.acceleration.value == pytest.approx(500)
    assert found.acceleration.time == pytest.approx(result.controller.log.moves[0].start_time + length / 2)
    assert found.jerk.value == pytest.approx(500 * pi / length)


@pytest.mark.parametrize(
    "name",
    [
        "mint/pick-and-place.mnt",
        "mint/cam-lift.mnt",
        "mint/laser-contour.mnt",
        "mccl/scurve.mcl",
        "mint/winder.mnt",
    ],
)
def test_nothing_that_is_sampled_lies_beyond(name: str) -> None:
    result = run(SCRIPTS / name, cache=False)
    lines = [
        Limit(a.index, "speed", "", 1.0, Extreme(0.0, 0.0), 0)
        for a in result.controller.axes.values()
        if len(a.starts) > 1
    ]
    assert lines
    assert contradictions(result.controller, lines, result.time) == []


def certified(limits: Mapping[str, object]) -> tuple[Run, list[Limit]]:
    settings = {f"axis.0.limits.{name}": value for name, value in limits.items()}
    result = run(
        Source("m.mnt", SET + "\nMOVEA(0) = 40\nGO(0) : PAUSE IDLE(0)"), machine=settings, cache=False
    )
    return result, certificate(result.controller, settings, result.time)


def test_a_certificate_says_when_and_on_which_line_and_what_is_left() -> None:
    _, (low, high, speed, accel) = certified(
        {"position": [-1.0, 30.0], "speed": 100.0, "acceleration": 1250.0}
    )
    assert [line.verdict for line in (low, high, speed, accel)] == ["within", "exceeded", "within", "within"]
    assert [low.margin, high.margin, speed.margin, accel.margin] == pytest.approx([1.0, -10.0, 0.0, 0.2])
    assert [speed.line, speed.reached, speed.time] == pytest.approx([2, 100.0, 0.1], abs=1e-4)
    assert least_margin([low, high, speed, accel]) == pytest.approx(-1 / 3)
    # The margin of a position is a distance, any other one a share.
    assert [_row(line)[-2].split()[1] for line in (low, high, accel)] == ["uu", "uu", "%"]


def test_what_prevents_signing_is_reported() -> None:
    for limits, expected in (
        ({"speed": 99.0}, "the speed of axis 0 reaches 100 uu/s at 0.1000"),
        ({"torque": 1.0}, "the torque of axis 0 cannot be certified: no motor is simulated"),
        ({"jerk": 1e9}, "the jerk of axis 0 is infinite at 0.0000"),
        ({}, "nothing to certify: the machine has no limits"),
    ):
        result, lines = certified(limits)
        (found,) = violations(result.controller, lines, result.time)
        assert found.message.startswith(expected)
        assert found.code == "beyond-limit"
    result, lines = certified({"speed": 100.0, "acceleration": 1000.0, "position": [0.0, 40.0]})
    assert violations(result.controller, lines, result.time) == []
