"""The step of loop and motor: its matrix exponential, and a divergent loop."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from motionlang.planners import hold, plan_trapezoid
from motionlang.servo import Drive, Loop, Motor, Track, simulate
from motionlang.servo.discrete import discretise, exponential
from motionlang.servo.steps import initial_state
from motionlang.servo.stretch import run_stretch

COLUMNS = ("position", "velocity", "integral", "output")


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


@pytest.mark.parametrize("derivative", [40.0, 400.0, 1e300])
@pytest.mark.filterwarnings("error")
def test_the_output_of_a_loop_that_runs_away_has_an_end(derivative: float) -> None:
    """Nothing overflows, because the output is limited."""
    loop = Loop(0.04, 2e-5, derivative)
    state = initial_state(discretise(Motor(), loop.period), 0.0)
    i = np.arange(2002)
    kicked = 50.0 * np.sin(i / 200.0) + 500.0 * ((i // 300) % 2)
    ran, after = run_stretch(loop, Motor(), COLUMNS, kicked, 0, 8000, state)
    columns = np.array([np.asarray(column) for column in ran.columns])
    assert np.isfinite(columns).all()
    assert np.isfinite(after[:3]).all()
    assert np.abs(columns[3]).max() == loop.output_limit


def test_figures_may_be_numbers_of_numpy() -> None:
    """They come out of tables and of `np.linspace`."""
    move = plan_trapezoid(0.0, 400.0, 20_000.0, 200_000.0, 200_000.0)
    track = Track([0.0, move.duration], [move, hold(400.0)])
    number: Any = np.float64
    bits: Any = np.int64(12)
    plain = simulate(track, Loop(0.04, dac_bits=12), Motor(coulomb=0.003), until=0.1)
    other = simulate(track, Loop(number(0.04), dac_bits=bits), Motor(coulomb=number(0.003)), until=0.1)
    assert plain.measured.tolist() == other.measured.tolist()
    plain, other = (simulate(track, Loop(0.4), Drive(kind(5e3)), until=0.1) for kind in (float, number))
    assert plain.measured.tolist() == other.measured.tolist()
