"""A recording that is not what it should be: a sentence for each, and nothing invented."""

from __future__ import annotations

import re
from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

from motionlang.kernel import Source, read_machine
from test_explore.init.recordings import FOLDER, Logger, csv_of, machine_run, world_of
from tests.cli.programs import Cell, Outcome

ROTARY = """\
1MN,1SV8000,1SA16000,1DS16000
1VM,1DI0,1SV1000,1GO,1FI0,1ST,1WS0.1,1PM,1SV8000,1MA0,1WS0.1
WN2,1MR2000,1WS0.05,RP6
"""
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
@pytest.mark.parametrize("step", [0.001, 0.005, 0.02])
def test_a_clock_that_drifts(cell: Cell, step: float) -> None:
    """Strokes show 0.3 %, also where an input comes between any two outputs; all is measured in right seconds."""
    ran = init(cell, columns("saw.mccl", step, 0.003), "saw.mccl")
    assert "note: the clock of the recording is 0.3 % fast; its times are corrected" in ran.err
    (bar,) = entries(cell, 4, "saw")
    assert abs(bar["every"] - 2.6) < 0.003  # type: ignore[operator]


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
    assert "every 0.005 s, 3 gaps (0.3" in ran.err
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


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.parametrize(
    ("program", "axis", "scale", "name"),
    [
        ("saw.mccl", 1, 25.4, "millimetres and inches"),
        ("saw.mccl", 1, 1000.0, "a prefix of the unit, such as µm and mm"),
        ("saw.mccl", 1, 1.5, "a gear of 2:3"),
        (
            "stamp.mnt",
            0,
            25.4,
            "millimetres and inches",
        ),  # where a mark ends the strokes elsewhere in the run
    ],
)
def test_another_scale(cell: Cell, program: str, axis: int, scale: float, name: str) -> None:
    column = f"axis{axis}_position_uu"
    right = columns(program)
    ran = init(cell, {**right, column: right[column] / scale}, program)
    (line,) = (each for each in ran.err.splitlines() if "times as far as the run" in each)
    assert f"({name}): if its unit differs, give --map position.{axis}={column}*" in line
    assert float(line.rpartition("*")[2]) == pytest.approx(scale, rel=0.005)


@pytest.mark.slow
def test_a_drive_with_a_lag(cell: Cell) -> None:
    """The position is that of a drive with a time constant of 15 ms; the switches are where they were."""
    exact = Logger(0.002).table(machine_run(FOLDER / "picker.mnt"))
    late = exact["axis0_position_uu"].copy()
    for row in range(1, len(late)):
        late[row] = late[row - 1] + (late[row] - late[row - 1]) * (1.0 - np.exp(-0.002 / 0.015))
    ran = init(cell, {**exact, "axis0_position_uu": late}, "picker.mnt")
    (lag,) = re.findall(r"note: axis 0: the position is (\S+) ms behind the run \(\d+ strokes\)", ran.err)
    assert float(lag) == pytest.approx(15.0, abs=3.0)


@pytest.mark.slow
def test_a_drive_that_does_not_reach_its_speed(cell: Cell) -> None:
    """Strokes are as long as in the run, and slower at their top."""
    text = (FOLDER / "picker.mnt").read_text().replace("SPEED(0) = 300", "SPEED(0) = 240")
    slow = machine_run(cell.write("slow.mnt", text), world_of(FOLDER / "picker.mnt"))
    ran = init(cell, Logger(0.002).table(slow), "picker.mnt")
    assert re.search(r"note: axis 0, line \d+: 240 uu/s recorded, 300 uu/s run: the drive does not", ran.err)


@pytest.mark.slow
def test_missed_parts(cell: Cell) -> None:
    """The machine was in trouble in cycles 5 and 6: the rule stays a guess, and names the times."""
    seen = columns("picker.mnt")
    times, caught = seen["time_s"] - 100.0, seen["in1"].copy()
    caught[(times > 11.5) & (times < 15.0)] = 0.0
    ran = init(cell, {**seen, "in1": caught}, "picker.mnt")
    assert "note: input 1 follows output 0, but not after output 0 at " in ran.err
    (vacuum,) = entries(cell, 1, "picker")
    assert (vacuum["output"], vacuum["guess"]) == (0, True)
    assert vacuum["delay"] == pytest.approx(0.3, abs=0.003)


def test_an_axis_that_turns_where_it_began(cell: Cell) -> None:
    """It has passed no index mark: the distance between the marks stays a guess."""
    positions = [
        0.00, 3.17, 12.75, 28.72, 48.67, 68.67, 88.67, 108.67, 128.67, 148.67, 168.67, 188.67, 8.07,
        22.10, 29.73, 31.26, 31.26, 31.26, 31.26, 31.26, 30.96, 25.80, 14.30, 3.97, 0.04, 0.00, 0.00,
        0.00, 0.00, 0.00, 2.51, 11.37, 26.64,
    ]  # fmt: skip
    text = "\n".join(["time,position.1,in2", *(f"{k / 50},{each},1" for k, each in enumerate(positions))])
    cell.write("turn.mccl", ROTARY)
    cell.write("rec.csv", text)
    ran = cell("init", "turn.mccl", "--recording", "rec.csv", "--format", "none")
    assert "internal error" not in ran.err
    assert "index_every = 200.0\n" in (cell.folder / "turn.machine.toml").read_text()
