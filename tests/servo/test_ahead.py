"""A motor that is simulated ahead and rolled back has exactly the states it had.

This applies to every plant.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.planners import hold
from motionlang.servo import Loop, Motor, Track, simulate, speculative, stretch
from motionlang.servo.discrete import discretise
from motionlang.servo.speculative import SpeculativeServo
from motionlang.servo.speculative_points import SpeculativeGenerator
from motionlang.servo.steps import COLUMNS, initial_state
from motionlang.servo.stretch import MARKED, run_steps
from tests.cases import cases, examples
from tests.servo.test_closed_form import track
from tests.servo.test_oracle import LOOPS, PLANTS, WHOLE

ALL = LOOPS | WHOLE
ROUGH = PLANTS["everything"]


def renamed() -> Track:
    """Return the same motion with a new zero during the first rest."""
    before = track()
    return Track(
        [*before.starts[:4], 0.9, *before.starts[4:]],
        [*before.profiles[:4], hold(100.0), *(each.shifted(-4400.0) for each in before.profiles[4:])],
    )


# ------------------------------------------------------------------------------------------------------ the points


@given(
    first=st.integers(0, 1500),
    count=st.integers(1, 3000),
    known=st.lists(st.floats(-1e6, 1e6), max_size=3),
    rate=st.sampled_from([1000.0, 4000.0, 2929.6875]),
)
def test_points_are_those_that_are_made_one_by_one(
    first: int, count: int, known: list[float], rate: float
) -> None:
    made = SpeculativeGenerator(renamed(), 1.0 / rate)
    one_by_one = [made.point(cycle) for cycle in range(first, first + count)]
    assert np.asarray(made.points(first, count, known)).tolist() == [*known, *one_by_one]


@cases(
    ("name", "ratio", "phase"),
    [(name, ratio, phase) for name in ALL for ratio, phase in ((1, 0), (4, 0), (3, 2))],
)
def test_steps_along_an_array_are_those_along_a_list(name: str, ratio: int, phase: int) -> None:
    loop = replace(ALL[name], servo_rate=1000.0 * ratio, trajectory_rate=1000.0)
    points = SpeculativeGenerator(renamed(), 1e-3).points(700, 400)
    state = initial_state(discretise(ROUGH, loop.period), float(points[1]))
    along = run_steps(loop, ROUGH, COLUMNS, np.asarray(points), phase, 390 * ratio, state)
    assert isinstance(points, np.ndarray)
    listed = run_steps(loop, ROUGH, COLUMNS, points.tolist(), phase, 390 * ratio, state)
    assert along[0].columns == listed[0].columns
    assert along[1] == listed[1]


# --------------------------------------------------------------------------------------------------- rollback


@given(
    seen=st.integers(1, 300),
    count=st.integers(1, 2000),
    name=st.sampled_from(sorted(ALL)),
    plant=st.sampled_from(sorted(PLANTS)),
)
@settings(max_examples=examples(60))
def test_what_is_run_again_is_what_was_seen(seen: int, count: int, name: str, plant: str) -> None:
    """This includes plain steps: a linear loop gets a nonlinear plant."""
    if PLANTS[plant].is_linear and ALL[name].is_linear:
        plant = "encoder"
    servo, twin = (SpeculativeServo(ALL[name], PLANTS[plant], renamed()) for _ in range(2))
    servo.run_block(seen)
    twin.run_block(seen)
    there = servo.run_block(2000)
    assert twin.run_block(count).tolist() == there[:, :count].tolist()
    servo.back(seen + count)
    assert (servo.state, servo.sample, servo.error) == (twin.state, twin.sample, twin.error)
    assert servo.run_block(90).tolist() == twin.run_block(90).tolist()


@pytest.mark.parametrize("sample", [1, MARKED, MARKED + 1, 5 * MARKED, 499, 500])
def test_taken_back_it_runs_a_few_steps_again_and_not_the_block(
    sample: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    servo = SpeculativeServo(Loop(0.04, 2e-5, 0.9, servo_rate=1000.0), Motor(quantised=True), track())
    servo.run_block(500)
    again: list[int] = []

    def counted(*given: object) -> object:
        again.append(given[5])  # type: ignore[arg-type]
        return run_steps(*given)  # type: ignore[arg-type]

    monkeypatch.setattr(speculative, "run_steps", counted)
    servo.back(sample)
    assert servo.sample == sample
    assert again == [(sample - 1) % MARKED + 1]


def test_a_long_run_by_steps_goes_in_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Chunks limit the memory; a chunk may end within a trajectory cycle."""
    whole = simulate(renamed(), LOOPS["feed-forward"], ROUGH, until=0.5)
    monkeypatch.setattr(stretch, "_CHUNK", 333)
    chunked = simulate(renamed(), LOOPS["feed-forward"], ROUGH, until=0.5)
    assert all(
        np.array_equal(whole[name], chunked[name]) for name in ("position", "velocity", "output", "error")
    )
