"""The extremes of a motion, by hand arithmetic and by samples; the certificate."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf, pi
from pathlib import Path

import pytest

from motionlang.commands.certify import (
    Limit,
    certificate,
    least_margin,
    violations,
)
from motionlang.commands.certify.extremes import Extreme, extremes, peak_speed
from motionlang.commands.certify.view import limits_table
from motionlang.kernel import Run, Source, run

SCRIPTS = Path(__file__).parents[3] / "scripts"
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
    result = run(Source("m.mnt", SET + program), until=2.0)
    found = extremes(result.controller.axes[0], result.time)
    values = [found.lowest, found.highest, found.speed, found.acceleration, found.jerk]
    assert [each.value for each in values] == pytest.approx(list(expected), abs=3e-3), result.diagnostics
    assert peak_speed(result.controller.axes[0], result.time) == found.speed.value


def test_a_sinusoidal_ramp_has_its_crest_in_its_middle() -> None:
    result = run(Source("s.mcl", "1MN,1PS,1SV100,1SA500,1DS500\n1MR1000,1WS0\n"))
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
    """The trace computes the samples by other code than that of the extremes."""
    result = run(SCRIPTS / name)
    moved = [a for a in result.controller.axes.values() if len(a.starts) > 1]
    assert moved
    for a in moved:
        found = extremes(a, result.time)
        bounds = {
            "position": (found.lowest.value, found.highest.value),
            "velocity": (-found.speed.value, found.speed.value),
            "acceleration": (-found.acceleration.value, found.acceleration.value),
        }
        rate = min(1000.0, 100_000 / result.time)
        for chunk in result.trace.chunks(rate, (a.index,), result.time, tuple(bounds)):
            for quantity, (low, high) in bounds.items():
                values = chunk.get(a.index, quantity)
                slack = 1e-6 * max(1.0, abs(low), abs(high)) if high < inf else 0.0
                assert low - slack <= values.min(), quantity
                assert values.max() <= high + slack, quantity


def certified(limits: Mapping[str, object]) -> tuple[Run, list[Limit]]:
    settings = {f"axis.0.limits.{name}": value for name, value in limits.items()}
    result = run(Source("m.mnt", SET + "\nMOVEA(0) = 40\nGO(0) : PAUSE IDLE(0)"), machine=settings)
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
    assert [row.split()[-1] for row in limits_table([low, accel]).lines(200)[-2:]] == ["uu", "%"]


def test_what_prevents_signing_is_reported() -> None:
    for limits, expected in (
        ({"speed": 99.0}, "the speed of axis 0 reaches 100 uu/s at 0.1000"),
        ({"torque": 1.0}, "the torque of axis 0 cannot be certified: no motor is simulated"),
        ({"jerk": 1e9}, "the jerk of axis 0 is infinite at 0.0000"),
        ({}, "nothing to certify: the machine has no limits"),
    ):
        result, lines = certified(limits)
        (found,) = violations(lines, "")
        assert found.message.startswith(expected)
        assert found.code == "beyond-limit"
    result, lines = certified({"speed": 100.0, "acceleration": 1000.0, "position": [0.0, 40.0]})
    assert violations(lines, "") == []


# The limit, its value, the value reached, the margin and the verdict. A position may be exceeded by a
# billionth of its limit, or of 1 if that is more; any other figure by a billionth of its limit.
MARGINS: dict[str, tuple[str, float, float, float, str]] = {
    "above the lowest position": ("lowest position", -4.0, -1.0, 3.0, "within"),
    "below the lowest position": ("lowest position", -4.0, -6.0, -2.0, "exceeded"),
    "below the highest position": ("highest position", 50.0, 20.0, 30.0, "within"),
    "a position beyond by rounding": ("highest position", 1e6, 1e6 + 9e-4, -9e-4, "within"),
    "a position beyond by more": ("highest position", 1e6, 1e6 + 2e-3, -2e-3, "exceeded"),
    "at 0, beyond by rounding": ("lowest position", 0.0, -9e-10, -9e-10, "within"),
    "at 0, beyond by more": ("lowest position", 0.0, -2e-9, -2e-9, "exceeded"),
    "a quarter left": ("speed", 100.0, 75.0, 0.25, "within"),
    "a speed beyond by rounding": ("speed", 0.1, 0.1 * (1.0 + 9e-10), -9e-10, "within"),
    "a speed beyond by more": ("speed", 0.1, 0.1 * (1.0 + 2e-9), -2e-9, "exceeded"),
    "twice the jerk": ("jerk", 10.0, 20.0, -1.0, "exceeded"),
}  # fmt: skip


@pytest.mark.parametrize("name", MARGINS)
def test_the_margin_of_a_limit(name: str) -> None:
    which, limit, reached, margin, verdict = MARGINS[name]
    line = Limit(0, which, "", limit, Extreme(reached, 0.5), 3)
    assert line.margin == pytest.approx(margin, rel=1e-6)
    assert line.verdict == verdict
    assert (line.reached, line.time) == (reached, 0.5)


def test_the_least_margin_takes_a_position_relative_to_its_limit() -> None:
    """30 of 50 is 0.6, 3 of 4 is 0.75; without a known limit there is none."""
    high = Limit(0, "highest position", "", 50.0, Extreme(20.0, 0.0), 0)
    low = Limit(0, "lowest position", "", -4.0, Extreme(-1.0, 0.0), 0)
    speed = Limit(0, "speed", "", 10.0, Extreme(3.0, 0.0), 0)
    torque = Limit(0, "torque", "", 1.0, None, 0)
    assert (torque.verdict, torque.reached, torque.time) == ("unknown", None, None)
    # Relative to a limit of 0 any distance is large.
    zero = Limit(0, "lowest position", "", 0.0, Extreme(0.5, 0.0), 0)
    cases = [[high, low, speed, torque], [low, speed], [low, torque], [torque], [], [zero, speed]]
    assert [least_margin(lines) for lines in cases] == [0.6, 0.7, 0.75, None, None, 0.7]
