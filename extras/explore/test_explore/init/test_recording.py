"""`motionlang init --recording`: the rules of the world in which a recording was made come back."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

import pytest

from motionlang.kernel import Run, Source, read_machine
from test_explore.init.recordings import FOLDER, PROGRAMS, Logger, csv_of, machine_run, world_of
from tests.cli.programs import Cell

Entry = dict[str, object]


@cache
def made(program: str) -> Run:
    return machine_run(FOLDER / program)


def measured(cell: Cell, program: str, logger: Logger) -> tuple[list[Entry], str]:
    """Return the inputs of the machine file that init writes from a recording, and its notes."""
    cell.write(program, (FOLDER / program).read_text())
    cell.write("rec.csv", csv_of(logger.table(made(program))))
    ran = cell("init", program, "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    machine = (cell.folder / program).with_suffix(".machine.toml")
    return read_machine(Source.read(str(machine)))["input"], ran.err  # type: ignore[return-value]


def rules(entries: list[Entry], step: float) -> list[Entry]:
    """Return entries without marks, with figures that are right within the sampling rounded to those of the world."""
    found = []
    for entry in entries:
        made_of = {key: value for key, value in entry.items() if key not in ("times", "guess", "level")}
        if made_of != {"channel": entry["channel"], "at": 0.0, "value": 0}:
            found.append(made_of)
    return found


def assert_same(found: list[Entry], world: list[Entry], step: float, speed: float) -> None:
    """Assert that the rules are those of a world, times within the sampling, positions within its distance."""
    assert [set(each) for each in rules(found, step)] == [set(each) for each in rules(world, step)]
    for mine, right in zip(rules(found, step), rules(world, step), strict=True):
        for key, value in right.items():
            near = speed * step if key in ("between", "below", "above") or "axis" in right else step
            assert mine[key] == pytest.approx(value, abs=near + 0.003), (mine, right)


@pytest.mark.slow
@pytest.mark.parametrize("step", [0.001, 0.005, 0.02])
@pytest.mark.parametrize("program", PROGRAMS)
def test_the_rules_of_the_world_come_back(cell: Cell, program: str, step: float) -> None:
    found, notes = measured(cell, program, Logger(step, jitter=0.5, noise=0.01, before=1.7))
    assert_same(found, world_of(FOLDER / program)["input"], step, 300.0)  # type: ignore[arg-type]
    (on,) = re.findall(r"the machine is switched on (\S+) s after the begin of the recording", notes)
    assert float(on) == pytest.approx(1.7, abs=step + 0.003)
    assert "note: cycle " in notes


def test_what_happens_once_stays_a_guess(cell: Cell) -> None:
    found, _ = measured(cell, "saw.mccl", Logger(0.005))
    assert [each["channel"] for each in found if "guess" in each] == [6]


@pytest.mark.slow
def test_switches_and_levels(cell: Cell) -> None:
    """The homing turned at the switch, and the air came after four seconds."""
    found, _ = measured(cell, "picker.mnt", Logger(0.005, jitter=0.5, noise=0.01, before=1.0))
    assert found == [{"channel": 1, "output": 0, "delay": pytest.approx(0.3, abs=0.003)}]
    machine = read_machine(Source.read(str(cell.folder / "picker.machine.toml")))
    right = world_of(FOLDER / "picker.mnt")
    assert machine["axis.0.home_switch"][1] == pytest.approx(right["axis.0.home_switch"][1], abs=0.3)  # type: ignore[index]
    assert machine["axis.0.guess"] is True  # it was seen once
    assert machine["analogue"] == [
        {"channel": 0, "value": 20.0, "at": 0.0},
        {"channel": 0, "value": 65.0, "at": pytest.approx(4.0, abs=0.008)},
    ]


@pytest.mark.slow
def test_a_recording_in_another_format(cell: Cell) -> None:
    """A Parquet file has the same rules; `compare` reads it, too."""
    cell.write("saw.mccl", (FOLDER / "saw.mccl").read_text())
    world = cell.write("world.toml", (FOLDER / "saw.world.toml").read_text())
    options = ["--machine", str(world), "--columns", "position", "--rate", "500", "--channels"]
    recording = str(cell.folder / "rec.parquet")
    assert cell("trace", "saw.mccl", recording, *options).status == 0
    assert (
        cell("compare", "saw.mccl", recording, "--machine", str(world), "--tolerance", "0.001uu").status == 0
    )
    assert cell("init", "saw.mccl", "--recording", recording, "--format", "none").status == 0
    found = read_machine(Source.read(str(cell.folder / "saw.machine.toml")))["input"]
    assert_same(found, world_of(FOLDER / "saw.mccl")["input"], 0.002, 300.0)  # type: ignore[arg-type]


@pytest.mark.parametrize("text", ["time,in4\n0,1\n1,0\n", "hello", ""])
def test_a_file_of_another_format(cell: Cell, text: str) -> None:
    cell.write("saw.mccl", (FOLDER / "saw.mccl").read_text())
    cell.write("rec.parquet", text)
    ran = cell("init", "saw.mccl", "--recording", "rec.parquet")
    assert ran.status == 1
    assert "error[recording]: rec.parquet is not a" in ran.err


# Where an input on an axis is on, as an entry has it.
REGIONS = ("between = [39.0, 61.0]", "between = [39.0, 50.0]", "below = 39.0", "below = 0.5")
# A carriage passes a light barrier, or touches a switch at its end.
CARRIAGE = """\
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Dim n As Integer
For n = 1 To 4
  MOVEA(0) = 80 : GO(0)
  While Not IDLE(0)
    OUTX(1) = INX(2)
  End While
  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
Next
"""


def only_input(settings: dict[str, object]) -> Any:
    """Return the entry of the only input of a machine file."""
    inputs: Any = settings["input"]
    (found,) = inputs
    return found


@pytest.mark.parametrize("rate", [20, 100, 1000])
@pytest.mark.parametrize("region", REGIONS)
def test_an_input_in_a_region_of_an_axis(cell: Cell, region: str, rate: int) -> None:
    cell.write("a.mnt", CARRIAGE)
    entry = f"{{ channel = 2, axis = 0, {region} }}"
    world = read_machine(Source("w.toml", f"input = [{entry}]"))
    cell.write("rec.csv", csv_of(Logger(1.0 / rate).table(machine_run(cell.folder / "a.mnt", world))))
    assert cell("init", "a.mnt", "--recording", "rec.csv", "--format", "none").status == 0
    right = only_input(world)
    found = only_input(read_machine(Source.read(str(cell.folder / "a.machine.toml"))))
    assert set(found) == set(right)
    for key in set(right) - {"channel", "axis"}:
        assert found[key] == pytest.approx(right[key], abs=100.0 / rate)


def test_a_pulse_after_an_output_went_off(cell: Cell) -> None:
    text = "For n = 1 To 4\n  OUTX(1) = 1\n  WAIT(1200 + 100 * n)\n  OUTX(1) = 0\n  PAUSE INX(2)\n  PAUSE Not INX(2)\n"
    cell.write("a.mnt", f"Dim n As Integer\n{text}Next\n")
    entry = {"channel": 2, "output": 1, "level": 0, "delay": 0.3, "for": 0.2}
    run = machine_run(cell.folder / "a.mnt", {"input": [entry]})
    cell.write("rec.csv", csv_of(Logger(0.01).table(run)))
    assert cell("init", "a.mnt", "--recording", "rec.csv", "--format", "none").status == 0
    found = only_input(read_machine(Source.read(str(cell.folder / "a.machine.toml"))))
    assert found == pytest.approx(entry, abs=0.011)
