"""A recording that is not what it should be: a sentence for each, and nothing invented."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from motionlang.commands.init.recorded.recording import Digital, MeasuredRecording, RecordedChange
from motionlang.commands.init.recorded.rules import rule_of
from motionlang.kernel import Source, read_machine
from tests.cli.programs import Cell, Outcome
from tests.commands.init.recordings import FOLDER, Logger, csv_of, machine_run, world_of

Columns = dict[str, NDArray[np.float64]]


@cache
def columns(program: str = "stamp.mnt", step: float = 0.005, drift: float = 0.0) -> Columns:
    return Logger(step, jitter=0.5, noise=0.01, drift=drift).table(machine_run(FOLDER / program))


def init(cell: Cell, recorded: Columns | str, program: str = "stamp.mnt", *options: str) -> Outcome:
    cell.write(program, (FOLDER / program).read_text())
    cell.write("rec.csv", recorded if isinstance(recorded, str) else csv_of(recorded))
    return cell("init", program, "--recording", "rec.csv", "--format", "none", *options)


def entries(cell: Cell, channel: int, program: str = "stamp") -> list[dict[str, object]]:
    found = read_machine(Source.read(str(cell.folder / f"{program}.machine.toml")))["input"]
    return [each for each in found if each["channel"] == channel]  # type: ignore[attr-defined]


@pytest.mark.slow
def test_a_recording_that_begins_late(cell: Cell) -> None:
    """Delays are right; marks along the belt have their distance, and the operator counts from the begin."""
    late = Logger(0.005, jitter=0.5, before=-5.0).table(machine_run(FOLDER / "stamp.mnt"))
    ran = init(cell, late)
    assert (
        "note: the recording begins while the machine runs, since output 4 is on: record from before"
        in ran.err
    )
    (up,) = entries(cell, 1)
    assert (up["output"], up["value"]) == (1, 0)
    assert abs(up["delay"] - 0.15) < 0.005  # type: ignore[operator]
    (mark,) = entries(cell, 0)
    assert abs(mark["every"] - 120.0) < 1.0  # type: ignore[operator]


@pytest.mark.slow
def test_a_clock_that_drifts(cell: Cell) -> None:
    """0.3 % are seen between outputs with no input between them, and everything is measured in right seconds."""
    ran = init(cell, columns("saw.mccl", 0.001, 0.003), "saw.mccl")
    assert "note: the clock of the recording is 0.3 % fast; its times are corrected" in ran.err
    (bar,) = entries(cell, 4, "saw")
    assert abs(bar["every"] - 2.6) < 0.002  # type: ignore[operator]


@pytest.mark.slow
def test_pulses_shorter_than_a_row(cell: Cell) -> None:
    """The input seems to be off; the entry is a guess, and the cycle shows what is missing."""
    world = world_of(FOLDER / "stamp.mnt")
    short = [{**each, "for": 0.001} if each["channel"] == 3 else each for each in world["input"]]  # type: ignore[attr-defined]
    run = machine_run(FOLDER / "stamp.mnt", {**world, "input": short})
    ran = init(cell, Logger(0.01, jitter=0.5).table(run))
    assert (
        "note: input 3 is off in all of the recording, and the program waits for it: "
        "pulses shorter than a row of 0.01 s are missed, record faster\n"
    ) in ran.err
    assert "ms longer from output 2 on to output 2 off" in ran.err
    assert [each["guess"] for each in entries(cell, 3)] == [True]


@pytest.mark.slow
def test_lost_rows(cell: Cell) -> None:
    kept = np.ones(len(columns()["time_s"]), dtype=bool)
    for row in (300, 900, 1500):
        kept[row : row + 60] = False
    ran = init(cell, {name: values[kept] for name, values in columns().items()})
    assert "warning[recording]: 3 gaps, the longest 0.3" in ran.err
    assert entries(cell, 1) == [{"channel": 1, "output": 1, "value": 0, "delay": 0.15}]
    assert "every" in entries(cell, 0)[0]


@pytest.mark.slow
def test_a_stop_in_the_middle(cell: Cell) -> None:
    """The machine waits for the operator until somebody ends the recording."""
    rows, rest = 1300, 4000
    stopped = {name: np.append(each[:rows], np.full(rest, each[rows])) for name, each in columns().items()}
    stopped["time_s"] = 100.0 + 0.005 * np.arange(rows + rest)
    ran = init(cell, stopped)
    assert "to the end of the recording at 26.5 s; the run then waits in line 13\n" in ran.err
    assert entries(cell, 4) == [{"channel": 4, "at": 0.0, "value": 0}]


@pytest.mark.slow
def test_contacts_that_bounce(cell: Cell) -> None:
    exact = columns("stamp.mnt", 0.001)
    bouncing = exact["in2"].copy()
    for row in np.flatnonzero(np.diff(bouncing)):
        bouncing[[row + 2, row + 4, row + 5]] = bouncing[row]
    ran = init(cell, {**exact, "in2": bouncing})
    assert "note: input 2 bounces: 16 groups of changes within 0.02 s count as one change\n" in ran.err
    assert [each["delay"] for each in entries(cell, 2)] == [0.09, 0.22]


def test_the_recording_of_another_program(cell: Cell) -> None:
    ran = init(cell, columns("saw.mccl"))
    assert ran.status == 1
    assert (
        "error[recording]: the recording is not one of stamp.mnt: 0 of 36 recorded changes of outputs are in the run, "
        "which switches other outputs; first at "
    ) in ran.err
    assert not (cell.folder / "stamp.machine.toml").exists()


def test_an_axis_that_the_controller_does_not_have(cell: Cell) -> None:
    ran = init(cell, columns(), "saw.mccl")
    assert ran.status == 1
    assert "axis0_position_uu is the position of axis 0, and the controller has the axes 1, 2," in ran.err


def test_a_position_in_place_of_an_input(cell: Cell) -> None:
    ran = init(cell, columns(), "stamp.mnt", "--map", "input.2=axis0_position_uu")
    assert ran.status == 1
    assert "values from " in ran.err
    assert "and no two levels" in ran.err


@pytest.mark.slow
def test_outputs_in_the_wrong_columns(cell: Cell) -> None:
    """What no rule explains is written as it was recorded, and stays a guess."""
    ran = init(cell, columns(), "stamp.mnt", "--map", "output.1=in4", "--map", "output.2=in4")
    assert "note: input 2: no rule explains its 16 changes; they are written as recorded\n" in ran.err
    assert all(each["guess"] for each in entries(cell, 2))


def test_a_file_without_channels(cell: Cell) -> None:
    ran = init(cell, "time,b\n1,2\n2,3\n3,4\n")
    assert ran.status == 1
    assert "error[recording]: no column of rec.csv is an input, an output or a position\n" in ran.err


def test_another_scale(cell: Cell) -> None:
    millimetres = columns("saw.mccl")
    ran = init(
        cell, {**millimetres, "axis1_position_uu": millimetres["axis1_position_uu"] / 25.4}, "saw.mccl"
    )
    assert "times as far as the run (millimetres and inches): if its unit differs, give --map" in ran.err


def test_a_machine_in_trouble() -> None:
    """Parts are missing: the rule stays a guess, and names the times."""
    on = [1.0 + 2.0 * k for k in range(10)]
    valve = [RecordedChange(at + later, level, 0.001) for at in on for later, level in ((0.0, 1), (1.0, 0))]
    seen = [
        RecordedChange(at + later, level, 0.001)
        for k, at in enumerate(on)
        for later, level in ((0.3, 1), (1.3, 0))
        if k not in (4, 5)
    ]
    part = Digital("in3", 0, tuple(seen), 0)
    recording = MeasuredRecording(
        "rec.csv", 0.0, 21.5, 0.002, {3: part}, {9: Digital("out9", 0, tuple(valve), 0)}
    )
    rule = rule_of(3, part, recording)
    assert [{**each} for each in rule.entries] == [{"channel": 3, "output": 9, "delay": 0.3}]
    assert rule.missed == (9.0, 11.0)
    assert rule.is_guess
