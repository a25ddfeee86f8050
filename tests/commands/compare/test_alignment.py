"""The delay of a recording is found and reported for any unit, sign and zero.

The recordings are written in closed form: 80 uu out and back at 100 uu/s and 1000 uu/s² are 0.1 s of
acceleration, 0.7 s at speed and 0.1 s of deceleration. A statement takes 10 µs: the first stroke begins after
five of them and 0.1 s, the second one after 0.9 s of motion, 0.2 s of rest and three statements more.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from math import sqrt
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from motionlang import compare, run
from motionlang.kernel import Run, Source

Array = NDArray[np.float64]
PROGRAM = """\
SPEED(0) = 100
ACCEL(0) = 1000
DECEL(0) = 1000
WAIT(100)
MOVEA(0) = 80
GO(0)
PAUSE IDLE(0)
WAIT(200)
MOVEA(0) = 0
GO(0)
PAUSE IDLE(0)
WAIT(300)
"""
OUT, BACK = 0.10005, 0.10005 + 0.9 + 0.2 + 3e-5
RATE, DELAY = 1000.0, 0.31234


@cache
def simulated() -> Run:
    return run(Source("stroke.mnt", PROGRAM))


def travelled(t: Array) -> Array:
    """Return the distance of a stroke `t` seconds after its start."""
    rising: Array = 500.0 * np.clip(t, 0.0, 0.1) ** 2
    falling = 500.0 * np.clip(0.9 - t, 0.0, 0.1) ** 2
    return rising + 100.0 * np.clip(t - 0.1, 0.0, 0.7) + np.where(t > 0.8, 5.0 - falling, 0.0)


def machine(t: Array) -> Array:
    """Return the position of the axis at a time of the run."""
    return travelled(t - OUT) - travelled(t - BACK)


def speed(t: Array) -> Array:
    """Return the velocity of the axis at a time of the run."""
    out, back = (np.clip(np.minimum(t - start, start + 0.9 - t), 0.0, 0.1) for start in (OUT, BACK))
    velocity: Array = 1000.0 * (out - back)
    return velocity


def recorded(begin: float, end: float, *columns: Callable[[Array], Array], rate: float = RATE) -> Source:
    """Return columns t, x, y, …: functions of the times from `begin` to `end`."""
    times = np.arange(begin, end, 1.0 / rate)
    rows = np.stack([times, *(each(times) for each in columns)], 1)
    lines = ["t,x,y,z"[: 1 + 2 * len(columns)], *(",".join(f"{cell:.9f}" for cell in row) for row in rows)]
    return Source("real.csv", "\n".join(lines))


def found(source: Source, **columns: str) -> Any:
    """Compare with columns by their quantities; x is the position."""
    mapping = {"position.0": "x"} | {f"{name}.0": column for name, column in columns.items()}
    return compare(simulated(), source, mapping)


def test_the_run_is_what_the_recordings_are_made_of() -> None:
    log = simulated().machine.log
    assert [move.start_time for move in log.moves] == pytest.approx([OUT, BACK], abs=1e-9)
    times = np.linspace(0.0, 2.3, 231)
    assert simulated().trace.at(0, "position", times) == pytest.approx(machine(times), abs=1e-9)


@pytest.mark.parametrize("delay", [DELAY, -0.0421, 12.5])
@pytest.mark.parametrize("offset", [0.0, -37.5, 1e5])
@pytest.mark.parametrize("scale", [1.0, 1.1, -1.0, 1000.0, 0.001, -1 / 25.4])
def test_the_delay_is_found_whatever_the_unit_the_sign_and_the_zero_are(
    scale: float, offset: float, delay: float
) -> None:
    made = found(recorded(delay - 0.5, delay + 3.0, lambda t: scale * machine(t - delay) + offset))
    # Nine decimals of the smallest recording, 0.08 from end to end, resolve 1e-5 s at most.
    assert made.delay == pytest.approx(delay, abs=1e-7 if abs(scale) >= 1.0 else 1e-5)
    (row,) = made.signals
    assert row["scale"] == pytest.approx(scale, rel=1e-5)
    assert row["offset"] == pytest.approx(offset, rel=1e-9, abs=1e-5)
    hints = [each.hint for each in made.remarks if "times as far" in each.message]
    assert [f"--map position.0=x*{1 / scale:.6g}" in hint for hint in hints] == [True] * (scale != 1.0)


@pytest.mark.parametrize("scale", [1.0, -1.0, 1000.0, 0.001])
def test_noise_blurs_the_delay_as_much_as_it_must(scale: float) -> None:
    """With noise of 0.5 uu, the delay found by least squares has a known deviation.

    The standard deviation is 0.5 / sqrt(sum of squared velocities). The sum over both strokes is 2 * 1000 / s *
    (0.7 s * 100² + 0.2 s * 100² / 3) (uu/s)².
    """
    noise = np.random.default_rng(1).normal(0.0, 0.5, 4000)
    source = recorded(0.0, 3.0, lambda t: scale * (machine(t - DELAY) + noise[: len(t)]))
    made = found(source)
    deviation = 0.5 / sqrt(2.0 * RATE * (0.7 * 100.0**2 + 0.2 * 100.0**2 / 3.0))
    assert deviation == pytest.approx(1.28e-4, rel=0.01)
    assert abs(made.delay - DELAY) < 4.0 * deviation
    assert made.signals[0]["scale"] == pytest.approx(scale, rel=2e-3)


def test_every_column_has_a_unit_and_a_sign_of_its_own() -> None:
    """Position in inches, and velocity in mm/min with reversed sign and a bias."""
    source = recorded(
        0.0, 3.0, lambda t: machine(t - DELAY) / 25.4, lambda t: 120.0 - 60.0 * speed(t - DELAY)
    )
    made = found(source, velocity="y")
    assert made.delay == pytest.approx(DELAY, abs=1e-6)
    assert [row["scale"] for row in made.signals] == pytest.approx([1 / 25.4, -60.0], rel=1e-5)
    assert [row["offset"] for row in made.signals] == pytest.approx([0.0, 120.0], abs=1e-2)


@pytest.mark.parametrize(("scale", "stroke"), [(1.0, BACK), (2.0, BACK), (1.0, OUT), (3.0, OUT)])
def test_a_recording_of_one_stroke_of_two_keeps_its_direction(scale: float, stroke: float) -> None:
    """The other stroke would fit equally well with the sign reversed."""
    begin = stroke - 0.05 + DELAY
    made = found(recorded(begin, begin + 1.0, lambda t: scale * machine(t - DELAY)))
    assert made.delay == pytest.approx(DELAY, abs=1e-6)
    assert made.signals[0]["scale"] == pytest.approx(scale, rel=1e-6)


def test_a_stroke_with_few_rows_keeps_its_direction() -> None:
    """Rows every 0.25 s: on that grid of delays the other stroke fits better, by a little."""
    begin = OUT - 0.3875 + DELAY
    columns = (lambda t: machine(t - DELAY), lambda t: speed(t - DELAY))
    made = found(recorded(begin, begin + 1.6, *columns, rate=4.0), velocity="y")
    assert made.delay == pytest.approx(DELAY, abs=1e-6)
    assert [row["scale"] for row in made.signals] == pytest.approx([1.0, 1.0], rel=1e-5)


@pytest.mark.parametrize("scale", [1.0, -1.0, 40.0])
def test_a_recording_of_part_of_a_stroke(scale: float) -> None:
    """Half the acceleration, the slew and half the deceleration: 0.8 s without rest."""
    begin = BACK + 0.05 + DELAY
    made = found(recorded(begin, begin + 0.8, lambda t: scale * machine(t - DELAY)))
    # Reversed, the other stroke is the same motion at the other delay; the sign without reversal is chosen.
    expected = DELAY if scale > 0.0 else DELAY + BACK - OUT
    assert made.delay == pytest.approx(expected, abs=1e-6)
    assert made.signals[0]["scale"] == pytest.approx(abs(scale), rel=1e-6)


def test_a_reversed_stroke_is_not_taken_for_the_other_one_that_is_slower() -> None:
    """Out at 100 uu/s and back at 90: reversed, the recording of the first is near the second, but not equal to it."""
    made = run(Source("stroke.mnt", PROGRAM.replace("MOVEA(0) = 0", "SPEED(0) = 90 : MOVEA(0) = 0")))
    compared = compare(made, recorded(0.0, 1.15, lambda t: -travelled(t - OUT)), {"position.0": "x"})
    assert compared.delay == pytest.approx(0.0, abs=1e-6)
    assert compared.signals[0]["scale"] == pytest.approx(-1.0)
