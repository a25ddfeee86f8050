"""Value change dumps: the complete file, and its values as read by pyvcd."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from motionlang.commands.trace.export import write_trace
from motionlang.kernel import Run
from motionlang.kernel.tracks import trace as trace_module
from motionlang.views.lanes import lanes
from tests.dumps import read
from tests.views.runs import ballscrew, ended, new_run, pick

# The kind, the times (ns) and the values of every variable of `switched`, in 2 rows per second.
SWITCHED = {
    "axis0.position_uu": ("real", [0, 500_000_000, 1_000_000_000, 1_500_000_000], [0.0, 2.5, 7.5, 10.0]),
    # Velocity is repeated before it changes.
    "axis0.velocity_uu_per_s": (
        "real", [0, 500_000_000, 1_000_000_000, 1_500_000_000], [0.0, 10.0, 10.0, 0.0]),
    "axis0.acceleration_uu_per_s2": ("real", [0], [0.0]),
    "inputs.in3": ("wire", [0, 250_000_000], [0, 1]),
    "inputs.in12": ("wire", [0], [1]),
    "outputs.out1": ("wire", [0, 150_000_001, 600_000_000], [0, 1, 0]),
    "analogue_inputs.ain0": ("real", [0, 600_000_000], [0.0, 12.5]),
}  # fmt: skip


def switched() -> Run:
    """Return a run of 10 units at 10 units/s with minimal ramps and switched channels."""
    run, controller = new_run()
    controller.set_scale(0, 100.0)
    for name, value in (("speed", 1000.0), ("accel", 1e12), ("decel", 1e12)):
        controller.configure(0, name, value)
    controller.inputs[12] = 1
    controller.clock.advance(0.150000001)
    controller.outputs[1] = 1
    controller.clock.advance(0.25)
    controller.inputs[3] = 1
    controller.move_by(0, 1000.0)
    controller.clock.advance(0.6)
    controller.outputs[1] = 0
    controller.analogue_inputs[0] = 12.5
    controller.clock.advance(1.5)
    return ended(run)


def test_a_whole_file(tmp_path: Path) -> None:
    write_trace(switched().trace, str(tmp_path / "x.vcd"), 2.0)
    assert read(tmp_path / "x.vcd") == (SWITCHED, 1_500_000_000)


@pytest.mark.parametrize("make", [ballscrew, pick, switched])
def test_another_program_reads_the_samples_in_it(tmp_path: Path, make: object) -> None:
    run: Run = make()  # type: ignore[operator]
    write_trace(run.trace, str(tmp_path / "x.vcd"), 1000.0)
    found, end = read(tmp_path / "x.vcd")
    assert end == round(run.trace.end * 1e9)
    samples = run.trace.sample(1000.0)
    grid = np.rint(samples.time * 1e9).astype(np.int64)
    for column, values in zip(samples.columns[1:], samples.data[1:], strict=True):
        _, times, states = found[column.name.replace("_", ".", 1)]
        shown = np.array(states)[np.searchsorted(times, grid, "right") - 1]
        np.testing.assert_allclose(shown, values, rtol=0, atol=1e-6)
        # A viewer that draws straight lines shows the same: no slope during standstill.
        np.testing.assert_allclose(np.interp(grid, times, states), values, rtol=0, atol=1e-6)
    for lane in lanes(run.controller):
        _, times, states = found[f"{lane.group.replace(' ', '_')}.{lane.name}"]
        assert (times, states) == ([round(time * 1e9) for time in lane.times], lane.values)


def test_chunks_do_not_show(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_trace(pick().trace, str(tmp_path / "one.vcd"), 200.0)
    monkeypatch.setattr(trace_module, "ROWS", 600)
    write_trace(pick().trace, str(tmp_path / "two.vcd"), 200.0)
    assert (tmp_path / "one.vcd").read_bytes() == (tmp_path / "two.vcd").read_bytes()
