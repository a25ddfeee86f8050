"""Columns of motors, and the number of rows and chunks."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from motionlang.kernel import Controller, Trace
from motionlang.kernel.tracks import history
from motionlang.kernel.tracks import trace as module
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


@pytest.mark.parametrize("rows", [7, 65_536])
def test_the_columns_of_a_motor_are_in_user_units(rows: int, monkeypatch: pytest.MonkeyPatch) -> None:
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
    trace = Trace(controller)
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


def test_values_before_power_up_are_those_of_the_first_piece() -> None:
    trace = Trace(machine())
    assert trace.at(0, "position", np.array([-1.0, 0.0, 1.0])).tolist() == [0.0, 0.0, 0.0]
    trace = Trace(shuttled(1))
    assert trace.at(0, "position", np.array([-1.0, 1.35])).tolist() == pytest.approx([0.0, 10.0])
