"""Columns of motors, and the number of rows and chunks."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from motionlang.kernel import Controller, Trace
from motionlang.kernel.tracks import history
from motionlang.kernel.tracks import trace as module
from motionlang.kernel.tracks.trajectory_points import TrajectoryPoints
from tests.kernel.log.test_records import shuttled
from tests.kernel.tracks.test_figures import machine
from tests.kernel.tracks.test_history import blocks


@pytest.mark.parametrize(("until", "chunks"), [(1.8, [10, 9]), (1.9, [10, 10]), (2.0, [10, 10, 1])])
def test_a_chunk_has_ten_rows(until: float, chunks: list[int], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "ROWS", 10)
    assert [len(each) for each in Trace(shuttled(1)).chunks(10.0, until=until)] == chunks


def test_so_many_rows_are_held_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MAX_ROWS", 16)
    trace = Trace(shuttled(1))
    assert len(trace.sample(10.0)) == 16
    with pytest.raises(ValueError, match="17 rows are too many to hold at once"):
        trace.sample(10.0, until=1.6)
    trace.choose([])
    assert [len(trace.sample(10.0)), len(trace.sample(10.0).columns)] == [16, 1]


@pytest.mark.parametrize("as_controller", [False, True])
@pytest.mark.parametrize("rows", [7, 65_536])
def test_the_columns_of_a_motor_are_in_user_units(
    as_controller: bool, rows: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Sample k has the error k, the position -k, 10 k V and k / 2 N m.

    The first one is at 8 ms. A unit is 2 counts, and its zero is at 5 counts. A following error
    has no zero, and volts and torques no unit.
    """
    monkeypatch.setattr(module, "ROWS", rows)
    monkeypatch.setattr(history, "chunks", lambda a, until: iter(blocks(4)))
    controller = Controller(2)
    controller.set_scale(1, 2.0, zero=5.0)
    feedback: Any = object()
    controller.axes[1].feedback = feedback
    trace = Trace(controller).as_controller() if as_controller else Trace(controller)
    assert [column.quantity for column in trace.columns(axes=(1,))] == [
        *("time", "position", "velocity", "acceleration"),
        *("actual", "following error", "output", "torque"),
    ]
    samples = trace.sample(1000.0, axes=(0, 1), until=0.02, quantities=("position",))
    assert [samples.get(axis, "position")[3] for axis in (0, 1)] == [0.0, -2.5]
    trace.choose(["torque.1", "actual.1", "position.0", "following-error.1", "output.1"])
    samples = trace.sample(1000.0, until=0.02)
    k = np.maximum(np.arange(21), 8)
    assert samples.get(1, "actual").tolist() == ((-k - 5.0) / 2.0).tolist()
    assert samples.get(1, "following error").tolist() == (k / 2.0).tolist()
    assert samples.get(1, "output").tolist() == (10.0 * k).tolist()
    assert samples.get(1, "torque").tolist() == (k / 2.0).tolist()
    assert samples.get(0, "position").tolist() == [0.0] * 21


@pytest.mark.parametrize(
    ("end", "last"), [(0.3, 0.301), (0.3 + 1e-11, 0.301), (0.2999, 0.301), (0.3001, 0.302)]
)
def test_points_end_a_cycle_after_the_run(end: float, last: float) -> None:
    controller = Controller(1)
    controller.clock.advance(end)
    assert Trace(controller).as_controller().end == last


def test_values_before_power_up_are_those_of_the_first_piece() -> None:
    trace = Trace(machine())
    assert trace.at(0, "position", np.array([-1.0, 0.0, 1.0])).tolist() == [0.0, 0.0, 0.0]
    trace = Trace(shuttled(1))
    assert trace.at(0, "position", np.array([-1.0, 1.35])).tolist() == pytest.approx([0.0, 10.0])


def test_points_of_a_new_zero_and_of_a_jog() -> None:
    """An axis jogs at 100 counts/s from 0 on, and is given the position 0 at 0.0505 s.

    It covers 0.5 counts in the 10 ms of its ramp and 4.05 counts in 40.5 ms. The points are not renamed, the
    displacement is, from that time on.
    """
    controller = Controller(1)
    for name, value in (("speed", 100.0), ("accel", 1e4), ("decel", 1e4)):
        controller.configure(0, name, value)
    controller.jog(0, 100.0)
    controller.clock.advance(0.0505)
    controller.define_position(0, 0.0)
    controller.clock.advance(0.1)
    points = TrajectoryPoints(controller.axes[0], 0.001)
    times = np.array([-1.0, 0.0, 0.0504, 0.0505 - 1e-9, 0.0505 - 1e-11, 0.0505, 0.06])
    assert points.renamed(times).tolist() == pytest.approx([0.0, 0.0, 0.0, 0.0, 4.55, 4.55, 4.55])
    for first, last in ((8, 60), (50, 53), (51, 51), (52, 52), (0, 1)):
        ramp = [0.005 * k * k if k < 10 else 0.1 * k - 0.5 for k in range(first, last + 1)]
        assert points.between(first, last).tolist() == pytest.approx(ramp, abs=1e-9)
