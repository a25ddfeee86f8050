"""The motion as columns: names, units, grid rows, the last row, chunks."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel import Controller, Trace
from tests.cases import examples


def ballscrew(start: float = 0.0) -> Controller:
    """Return a move of 200 mm at 250 mm/s and 1250 mm/s² on axis 0, 1200 counts/mm.

    The run ends with the move.
    """
    controller = Controller(4)
    controller.set_scale(0, 1200.0)
    for name, value in (("speed", 300_000.0), ("accel", 1_500_000.0), ("decel", 1_500_000.0)):
        controller.configure(0, name, value)
    controller.clock.advance(start)
    controller.move_by(0, 240_000.0, "MOVER", 1)
    controller.clock.advance(controller.idle_time(0))
    return controller


def test_columns_have_names_and_units() -> None:
    samples = Trace(ballscrew()).sample(10.0)
    assert [(c.name, c.unit, c.axis) for c in samples.columns] == [
        ("time_s", "s", None),
        ("axis0_position_uu", "uu", 0),
        ("axis0_velocity_uu_per_s", "uu/s", 0),
        ("axis0_acceleration_uu_per_s2", "uu/s2", 0),
    ]
    assert samples["axis0_velocity_uu_per_s"] is samples.get(0, "velocity")


def test_a_move_in_user_units() -> None:
    samples = Trace(ballscrew()).sample(10.0, quantities=("position", "velocity", "acceleration", "jerk"))
    np.testing.assert_allclose(samples.time, np.arange(11) / 10.0, rtol=0, atol=1e-15)
    expected = [0, 6.25, 25, 50, 75, 100, 125, 150, 175, 193.75, 200]
    np.testing.assert_allclose(samples.get(0, "position"), expected, rtol=1e-12)
    expected = [0, 125, 250, 250, 250, 250, 250, 250, 250, 125, 0]
    np.testing.assert_allclose(samples.get(0, "velocity"), expected, atol=1e-9)
    expected = [1250, 1250, 0, 0, 0, 0, 0, 0, -1250, -1250, 0]
    np.testing.assert_allclose(samples.get(0, "acceleration"), expected, atol=1e-9)
    assert not samples.get(0, "jerk").any()


def test_the_last_row_is_the_very_end() -> None:
    trace = Trace(ballscrew(start=5e-5))
    samples = trace.sample(1000.0)
    assert len(samples) == trace.rows(1000.0) == 1002
    assert samples.time[-2] == 1.0
    assert samples.time[-1] == trace.end == 1.00005
    assert samples.get(0, "position")[-1] == pytest.approx(200.0, rel=1e-15)
    assert samples.get(0, "velocity")[-1] == 0.0


def test_an_end_on_the_grid_is_no_further_row() -> None:
    assert len(Trace(ballscrew()).sample(1000.0)) == 1001


def test_until_cuts_and_extends() -> None:
    trace = Trace(ballscrew())
    assert trace.sample(1000.0, until=0.25).time[-1] == 0.25
    later = trace.sample(10.0, until=2.0)
    assert later.get(0, "position")[-1] == 200.0


def test_only_axes_that_moved_unless_others_are_named() -> None:
    trace = Trace(ballscrew())
    assert trace.axes == (0,)
    samples = trace.sample(10.0, axes=(3,))
    assert samples.columns[1].name == "axis3_position_uu"
    assert not samples.get(3, "position").any()
    assert Trace(Controller(4, first=1)).axes == (1,)
    with pytest.raises(KeyError):
        samples.get(0, "position")
    with pytest.raises(KeyError):
        samples["axis0_position_uu"]


def test_nothing_moved_and_no_time_passed_is_one_row() -> None:
    samples = Trace(Controller(4)).sample(1000.0)
    assert [values.tolist() for values in samples.data] == [[0.0], [0.0], [0.0], [0.0]]


def test_a_zero_shifts_positions_only() -> None:
    controller = ballscrew()
    end = controller.clock.now
    controller.set_scale(0, 1200.0, zero=120_000.0)
    samples = Trace(controller).sample(10.0)
    assert samples.get(0, "position")[[0, -1]].tolist() == [
        0.0,
        controller.axes[0].position(end) / 1200.0 - 100.0,
    ]
    assert samples.get(0, "velocity")[5] == pytest.approx(250.0)


@pytest.mark.parametrize("rate", [0.0, -1.0, float("nan"), float("inf")])
def test_a_rate_must_be_a_number_above_zero(rate: float) -> None:
    with pytest.raises(ValueError, match="the rate must be a number above 0"):
        Trace(ballscrew()).sample(rate)


def test_what_does_not_fit_into_memory_is_refused() -> None:
    with pytest.raises(ValueError, match="too many to hold at once"):
        Trace(ballscrew()).sample(1e12)
    with pytest.raises(ValueError, match="the end must be a time"):
        Trace(ballscrew()).sample(1.0, until=-1.0)


@settings(max_examples=examples(60))
@given(
    targets=st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=5),
    gaps=st.lists(st.floats(0.0, 3.0), min_size=5, max_size=5),
    rate=st.floats(0.5, 5000.0),
)
def test_samples_are_what_the_controller_reports(
    targets: list[float], gaps: list[float], rate: float
) -> None:
    controller = Controller(1)
    for target, gap in zip(targets, gaps, strict=False):
        controller.move_to(0, target)
        controller.clock.advance(controller.clock.now + gap)
    samples = Trace(controller).sample(rate)
    axis = controller.axes[0]
    for k in range(0, len(samples), 1 + len(samples) // 50):
        time = float(samples.time[k])
        assert samples.get(0, "position")[k] == pytest.approx(axis.position(time), rel=1e-9, abs=1e-4)
        assert samples.get(0, "velocity")[k] == pytest.approx(axis.velocity(time), rel=1e-6, abs=1e-2)


def test_chunks_are_the_same_rows() -> None:
    trace = Trace(ballscrew(start=5e-5))
    whole = trace.sample(200_000.0)
    chunks = [[values.copy() for values in chunk.data] for chunk in trace.chunks(200_000.0)]
    assert len(chunks) > 1
    for k, values in enumerate(whole.data):
        joined = np.concatenate([chunk[k] for chunk in chunks])
        np.testing.assert_allclose(joined, values, rtol=1e-12, atol=1e-9)
