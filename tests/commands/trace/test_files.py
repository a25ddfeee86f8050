"""`motionlang trace`: the files have the samples of the run, as the libraries of their formats read them."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motionlang import run
from tests.cli.programs import Cell

# Three axes: two shapes, a stop, a return, and a jog that goes on after the end.
PICK = """\
SCALE(0, 1, 2) = 1200;
SPEED(0, 1, 2) = 250; : ACCEL(0, 1, 2) = 1250; : DECEL(0, 1, 2) = 900;
SRAMP(1) = 100
MOVER(0) = 200 : MOVER(1) = 80 : GO(0, 1)
WAIT = 700
MOVER(2) = -250 : GO(2)
WAIT = 500
STOP(2)
PAUSE IDLE(0)
MOVEA(0) = 0 : GO(0)
JOG(1) = -40
WAIT = 900
"""
# 10 units at 10 units/s with a ramp of 1 µs each, and channels that switch.
SWITCHED = """\
SCALE(0) = 100
SPEED(0) = 10 : ACCEL(0) = 1e7 : DECEL(0) = 1e7
WAIT = 150
OUTX(1) = 1
WAIT = 250
MOVER(0) = 10 : GO(0)
WAIT = 200
OUTX(1) = 0
WAIT = 900
"""
WORLD = """\
controller.instruction_time = 1e-9
input = [{channel = 12, at = 0.0}, {channel = 3, at = 0.25}]
analogue = [{channel = 0, value = 12.5, at = 0.6}]
"""


@pytest.fixture
def programs(cell: Cell) -> Cell:
    cell.write("pick.mnt", PICK)
    cell.write("pick.machine.toml", "run.until = 3\n")
    cell.write("switched.mnt", SWITCHED)
    cell.write("switched.machine.toml", WORLD)
    return cell


def traced(cell: Cell, name: str, file: str, rate: float) -> tuple[Path, Any]:
    """Write the trace of a program, and return the file and the trace of the same run."""
    ran = cell("trace", name, file, "--rate", str(rate))
    assert ran.status == 0
    return cell.folder / file, run(str(cell.folder / name)).trace


def test_csv_has_names_with_units_and_a_row_a_sample(programs: Cell) -> None:
    path, _ = traced(programs, "ballscrew.mcl", "x.csv", 10.0)
    rows = path.read_text().splitlines()
    assert rows[0] == "time_s,axis1_position_uu,axis1_velocity_uu_per_s,axis1_acceleration_uu_per_s2"
    assert rows[1] == "0.000000000,0.000000000,0.000000000,0.000000000"
    assert rows[6] == "0.500000000,99.980000000,250.000000000,0.000000000"
    assert rows[-1].split(",")[1:] == ["200.000000000", "0.000000000", "0.000000000"]


@pytest.mark.parametrize("rate", [100.0, 777.7, 30_000.0])
def test_csv_and_npz_have_the_samples(rate: float, programs: Cell) -> None:
    path, trace = traced(programs, "pick.mnt", "x.npz", rate)
    samples = trace.sample(rate)
    with np.load(path) as archive:
        head = list(archive)
        for name in head:
            np.testing.assert_array_equal(archive[name], samples[name])
    if rate < 1000.0:
        with traced(programs, "pick.mnt", "x.csv", rate)[0].open(newline="") as file:
            names, *rows = csv.reader(file)
        assert names == head
        table = np.array(rows, dtype=float)
        for k, name in enumerate(head):
            np.testing.assert_allclose(table[:, k], samples[name], rtol=0, atol=5.1e-10)


def test_parquet_has_the_samples_and_their_units(programs: Cell) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    path, trace = traced(programs, "pick.mnt", "x.parquet", 200.0)
    table, samples = parquet.read_table(path), trace.sample(200.0)
    assert table.column_names == [column.name for column in samples.columns]
    for column, values in zip(samples.columns, samples.data, strict=True):
        assert table.field(column.name).metadata == {b"unit": column.unit.encode()}
        np.testing.assert_array_equal(table[column.name].to_numpy(), values)


@pytest.mark.parametrize("suffix", ["csv", "npz", "parquet"])
def test_the_same_run_gives_the_same_bytes(suffix: str, programs: Cell) -> None:
    if suffix == "parquet":
        pytest.importorskip("pyarrow")
    one, two = (
        traced(programs, "pick.mnt", f"{name}.{suffix}", 50.0)[0].read_bytes() for name in ("one", "two")
    )
    assert one == two


@pytest.mark.parametrize("suffix", [".csv", ".npz", ".parquet"])
def test_channels_are_columns_of_their_levels(programs: Cell, suffix: str) -> None:
    """Each row has the level at its time; an input that the program reads and that stays off has a column, too."""
    programs.write("reads.mnt", SWITCHED + "If INX(5) Then OUTX(2) = 1\n")
    world = f"reads{suffix}"
    ran = programs(
        "trace", "reads.mnt", world, "--machine", "switched.machine.toml", "--rate", "4",
        "--columns", "position", "--channels",
    )  # fmt: skip
    assert ran.status == 0
    if suffix == ".csv":
        rows = list(csv.DictReader((programs.folder / world).read_text().splitlines()))
        found = {name: [float(row[name]) for row in rows] for name in rows[0]}
    elif suffix == ".npz":
        found = {name: values.tolist() for name, values in np.load(programs.folder / world).items()}
    else:
        from pyarrow.parquet import read_table  # type: ignore[import-untyped]

        found = read_table(programs.folder / world).to_pydict()
    assert list(found) == ["time_s", "axis0_position_uu", "ain0", "in3", "in5", "in12", "out1"]
    assert found["time_s"][:4] == [0.0, 0.25, 0.5, 0.75]
    assert {name: found[name][:4] for name in list(found)[2:]} == {
        "ain0": [0.0, 0.0, 0.0, 12.5],
        "in3": [0.0, 1.0, 1.0, 1.0],
        "in5": [0.0, 0.0, 0.0, 0.0],
        "in12": [1.0, 1.0, 1.0, 1.0],
        "out1": [0.0, 1.0, 1.0, 0.0],
    }
