"""The block form: where it is used, and that only what is around a limit is stepped."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.controller.servo import Drive, Loop, Motor
from motionlang.controller.servo.discrete import discretise, exponential
from motionlang.controller.servo.lifted import Lifted, lift
from motionlang.controller.servo.steps import empty_columns, initial_state, stepper
from motionlang.controller.servo.stretch import run_stretch

ASKED = ("position", "velocity", "integral", "output")
LOOP = Loop(0.04, 2e-5, 0.9, integral_limit=5.0)


def run(loop: Loop, plant: Motor | Drive, points: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """The same samples by blocks, and by steps alone."""
    state = initial_state(discretise(plant, loop.period), float(points[0]))
    given = np.append(points[0], points)
    by_blocks, after = run_stretch(loop, plant, ASKED, given, 0, count, state)
    stretch, _ = run_stretch(loop, plant, ASKED, given, 0, 0, state)
    demand = np.interp(
        np.arange(count) / loop.servo_rate, np.arange(len(points)) / loop.trajectory_rate, points
    )
    columns = empty_columns(ASKED)
    by_steps = stepper(loop, plant, ASKED)(demand.tolist(), (), state, columns)
    assert np.allclose(after[:3], by_steps[:3], rtol=1e-9, atol=1e-6)
    assert len(stretch.columns[0]) == 0
    return np.array([np.asarray(c) for c in by_blocks.columns]), np.array([np.asarray(c) for c in columns])


def kicked(seconds: float, size: float, every: int) -> np.ndarray:
    i = np.arange(int(seconds * 1000) + 2)
    return 50.0 * np.sin(i / 200.0) + size * ((i // every) % 2)


def test_only_what_is_around_a_limit_is_stepped(monkeypatch: pytest.MonkeyPatch) -> None:
    stepped: list[int] = []
    plain = Lifted._plain

    def counted(self: Lifted, *given: object) -> object:
        after = plain(self, *given)  # type: ignore[arg-type]
        stepped.append(after[0] - int(given[4]))  # type: ignore[call-overload]
        return after

    monkeypatch.setattr(Lifted, "_plain", counted)
    blocks, steps = run(LOOP, Motor(), kicked(20.0, 500.0, 5000), 80_000)
    assert np.abs(blocks - steps).max() < 1e-6
    assert np.abs(steps[3]).max() == LOOP.output_limit
    assert 0 < sum(stepped) <= 8, "blocks of 48 samples, of 1666"


@given(st.integers(0, 10_000), st.floats(0.0, 3000.0), st.integers(20, 400), st.sampled_from([1, 2, 3, 4]))
@settings(max_examples=40)
def test_limits_hit_anywhere(seed: int, size: float, every: int, slow: int) -> None:
    rng = np.random.default_rng(seed)
    loop = Loop(
        0.02,
        1e-4,
        0.3,
        integral_limit=float(rng.uniform(0.05, 2.0)),
        derivative_every=slow,
        output_limit=float(rng.uniform(0.5, 10.0)),
        limit_style=("sum", "term")[seed % 2],
    )
    blocks, steps = run(loop, Motor(load_inertia=2e-5), kicked(1.0, size, every), 4000)
    scale = np.maximum(1.0, np.abs(steps).max(axis=1, keepdims=True))
    assert (np.abs(blocks - steps) / scale).max() < 1e-9


def test_no_limits_are_no_checks() -> None:
    made = lift(Loop(0.01, output_limit=inf), Motor(), ASKED, True)
    assert made is not None
    assert made.checks == {}


def test_an_unstable_loop_is_simulated_too() -> None:
    """It saturates, and there is no warning and no NaN."""
    blocks, steps = run(Loop(0.5, 0.0, 8.0), Motor(), kicked(1.0, 100.0, 300), 4000)
    assert np.isfinite(blocks).all()
    assert np.abs(blocks[3]).max() == 10.0
    assert np.abs(blocks[:, :40] - steps[:, :40]).max() < 1e-6


@pytest.mark.parametrize(
    ("loop", "plant"),
    [
        (LOOP, Motor(quantised=True)),
        (LOOP, Motor(coulomb=0.01)),
        (Loop(0.01, dac_bits=12), Motor()),
        (Loop(0.01, output_deadband=0.1), Motor()),
        (Loop(0.01, 0.0, 1.0, derivative_every=257), Motor()),
    ],
)
def test_what_is_not_linear_has_no_blocks(loop: Loop, plant: Motor) -> None:
    assert lift(loop, plant, ASKED, True) is None


def test_the_matrix_exponential() -> None:
    """exp of a rotation, a shear and a stiff decay, and exp(a) exp(-a) = 1."""
    angle = 0.7
    turned = exponential([[0.0, -angle], [angle, 0.0]])
    assert turned[0][0] == pytest.approx(np.cos(angle), abs=1e-15)
    assert turned[1][0] == pytest.approx(np.sin(angle), abs=1e-15)
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
    """The powers of its step overflow; step by step nothing does, as the output stops at its limit."""
    state = initial_state(discretise(Motor(), LOOP.period), 0.0)
    loop = Loop(0.04, 2e-5, derivative)
    ran, after = run_stretch(loop, Motor(), ASKED, kicked(2.0, 500.0, 300), 0, 8000, state)
    columns = np.array([np.asarray(column) for column in ran.columns])
    assert np.isfinite(columns).all()
    assert np.isfinite(after[:3]).all()
    assert np.abs(columns[3]).max() == loop.output_limit
