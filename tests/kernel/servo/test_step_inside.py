"""Seen from inside: the step of loop and motor by hand: commands, feed-forward, integral, plants, and rest."""

from __future__ import annotations

import numpy as np
import pytest

from motionlang.kernel.servo import Loop, Servo, VelocityDrive, servo, simulate
from motionlang.kernel.servo.discrete import exponential
from motionlang.kernel.servo.step import at_rest, truncated
from tests.kernel.servo.test_oracle import LOOPS, PLANTS
from tests.kernel.servo.test_step import RATES, along, varied


@pytest.mark.parametrize(
    ("mode", "acting"),
    [
        ("never", [False] * 6),
        ("always", [True] * 6),
        ("steady", [True, False, False, True, False, True]),  # cycles that the last one equals in speed
        ("stopped", [True, False, False, False, True, True]),
    ],
)
@pytest.mark.parametrize("far", [0.0, 1e9])
def test_the_integral_acts_by_the_motion_of_the_command(far: float, mode: str, acting: list[bool]) -> None:
    """It is at rest, begins to move, moves faster and then uniformly, and stops.

    The motor stays 100 counts away. Rounding of large positions is no motion.
    """
    points = [far, far, far + 1.0, far + 3.0, far + 5.0, far + 5.0, far + 5.0]
    loop = Loop(integral=1e-3, integral_limit=9.0, integral_mode=mode, **RATES)
    made = Servo(loop, VelocityDrive(1e-9), along(points))
    made.state = at_rest(far + 100.0)
    integral = made.run(24).integral.reshape(-1, 4)
    assert (np.diff(integral[:, -1], prepend=0.0) != 0.0).tolist() == acting


def test_the_matrix_exponential() -> None:
    """The exponential of a rotation, a shear and a stiff decay; exp(a) exp(-a) = 1."""
    angle = 0.7
    rotation = exponential([[0.0, -angle], [angle, 0.0]])
    assert rotation[0][0] == pytest.approx(np.cos(angle), abs=1e-15)
    assert rotation[1][0] == pytest.approx(np.sin(angle), abs=1e-15)
    assert exponential([[0.0, 1e-9], [0.0, 0.0]]) == [[1.0, 1e-9], [0.0, 1.0]]
    assert exponential([[-50.0]])[0][0] == pytest.approx(np.exp(-50.0), rel=1e-12)
    rng = np.random.default_rng(5)
    for size in (2, 4, 6):
        m = rng.normal(size=(size, size))
        there, back = np.array(exponential(m.tolist())), np.array(exponential((-m).tolist()))
        assert np.abs(there @ back - np.eye(size)).max() < 1e-11


def test_a_long_run_goes_in_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Chunks limit the memory; a chunk may end within a trajectory cycle."""
    whole = simulate(varied(), LOOPS["feed-forward"], PLANTS["everything"], until=0.5)
    monkeypatch.setattr(servo, "_CHUNK", 333)
    chunked = simulate(varied(), LOOPS["feed-forward"], PLANTS["everything"], until=0.5)
    assert whole.columns.tolist() == chunked.columns.tolist()


def test_a_quotient_is_rounded_towards_zero() -> None:
    values = (-257.0, -256.0, -255.0, -1.0, 0.0, 1.0, 255.0, 256.0, 511.0)
    assert [truncated(value, 256.0) for value in values] == [-1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0]
