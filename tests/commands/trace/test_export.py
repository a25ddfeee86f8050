"""Traces as files: contents, atomic writes, and reproducible bytes."""

from __future__ import annotations

import csv
import os
from pathlib import Path

import numpy as np
import pytest

from motionlang.commands.trace.export import write_trace
from motionlang.kernel.tracks import trace as trace_module
from tests.views.runs import ballscrew, pick

NAMES = ["time_s", "axis0_position_uu", "axis0_velocity_uu_per_s", "axis0_acceleration_uu_per_s2"]


def test_csv_has_names_with_units_and_a_row_a_sample(tmp_path: Path) -> None:
    path = tmp_path / "ballscrew.csv"
    assert write_trace(ballscrew().trace, str(path), 10.0) == 12
    rows = path.read_text().splitlines()
    assert rows[0].split(",") == NAMES
    assert rows[1] == "0.000000000,0.000000000,0.000000000,0.000000000"
    assert rows[6] == "0.500000000,99.987500000,250.000000000,0.000000000"
    assert rows[-1] == "1.000050000,200.000000000,0.000000000,0.000000000"


def test_csv_writes_any_number_and_no_negative_zero(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    trace = ballscrew().trace
    trace.choose(["position"])
    data = (np.arange(5) / 8, np.array([-0.0, -4e-10, -6e-10, 1e300, np.nan]))
    chunk = trace_module.Samples(trace.columns(), data)
    monkeypatch.setattr(trace_module.Trace, "chunks", lambda self, rate: [chunk])
    write_trace(trace, str(tmp_path / "x.csv"))
    shown = [row.split(",")[1] for row in (tmp_path / "x.csv").read_text().splitlines()[1:]]
    assert shown == ["0.000000000", "0.000000000", "-0.000000001", f"{1e300:.9f}", "nan"]


@pytest.mark.parametrize("rate", [100.0, 1000.0, 777.7])
def test_both_formats_hold_the_samples(tmp_path: Path, rate: float, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trace_module, "ROWS", 193)
    trace = pick().trace
    samples = trace.sample(rate)
    write_trace(trace, str(tmp_path / "pick.csv"), rate)
    write_trace(trace, str(tmp_path / "pick.npz"), rate)
    with (tmp_path / "pick.csv").open(newline="") as file:
        head, *rows = csv.reader(file)
    table = np.array(rows, dtype=float)
    with np.load(tmp_path / "pick.npz") as archive:
        assert list(archive) == head
        for k, name in enumerate(head):
            np.testing.assert_array_equal(archive[name], samples[name])
            np.testing.assert_allclose(table[:, k], samples[name], rtol=0, atol=5.1e-10)


def test_parquet_holds_the_samples_and_their_units(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    monkeypatch.setattr(trace_module, "ROWS", 193)
    samples = pick().trace.sample(200.0)
    assert write_trace(pick().trace, str(tmp_path / "x.parquet"), 200.0) == len(samples)
    table = parquet.read_table(tmp_path / "x.parquet")
    assert table.column_names == [column.name for column in samples.columns]
    for column, values in zip(samples.columns, samples.data, strict=True):
        assert table.field(column.name).metadata == {b"unit": column.unit.encode()}
        np.testing.assert_array_equal(table[column.name].to_numpy(), values)


def test_the_same_run_gives_the_same_bytes(tmp_path: Path) -> None:
    for suffix in (".csv", ".npz", ".vcd", ".parquet"):
        if suffix == ".parquet":
            pytest.importorskip("pyarrow")
        one, two = tmp_path / f"one{suffix}", tmp_path / f"two{suffix}"
        write_trace(pick().trace, str(one))
        write_trace(pick().trace, str(two))
        assert one.read_bytes() == two.read_bytes()


def test_progress_goes_from_nothing_to_all(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trace_module, "ROWS", 100)
    for suffix in (".csv", ".npz", ".vcd"):
        fractions: list[float] = []
        write_trace(ballscrew().trace, str(tmp_path / f"x{suffix}"), 1000.0, fractions.append)
        assert fractions == sorted(fractions)
        assert fractions[-1] == 1.0


def test_a_failure_leaves_the_old_file_and_no_half_of_a_new_one(tmp_path: Path) -> None:
    path = tmp_path / "pick.csv"
    path.write_text("old")

    def fail(fraction: float) -> None:
        raise OSError(28, "No space left on device")

    with pytest.raises(OSError, match="No space left"):
        write_trace(ballscrew().trace, str(path), 1000.0, fail)
    assert path.read_text() == "old"
    assert os.listdir(tmp_path) == ["pick.csv"]


def test_ctrl_c_leaves_nothing_either(tmp_path: Path) -> None:
    def interrupt(fraction: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_trace(ballscrew().trace, str(tmp_path / "x.npz"), 1000.0, interrupt)
    assert os.listdir(tmp_path) == []
