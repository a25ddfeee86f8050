"""The run judges the rules of a recording: no cause of its own cause, and no program that is accused without need."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.kernel import Source, read_machine
from tests.cli.programs import Cell
from tests.commands.init.recordings import FOLDER, Logger, csv_of, machine_run, world_of

Entry = dict[str, object]
SENSOR: Entry = {"channel": 3, "output": 2, "delay": 0.25}
PRESSES: dict[str, list[Entry]] = {
    "regular": [{"channel": 1, "at": 1.0, "for": 0.3, "every": 2.5}],
    "irregular": [
        {"channel": 1, "at": at, "for": 0.3}
        for at in (1.0, 3.1, 6.4, 8.2, 11.9, 14.0, 17.7, 20.3, 22.2, 26.0)
    ],
}


def measured(cell: Cell, program: str, world: dict[str, object], logger: Logger) -> tuple[list[Entry], str]:
    """Return the inputs that init writes from a recording of a program in a world, and what it says."""
    cell.write(program, (FOLDER / program).read_text())
    made = machine_run(Path(cell.folder) / program, world)
    cell.write("rec.csv", csv_of(logger.table(made)))
    ran = cell("init", program, "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    machine = (cell.folder / program).with_suffix(".machine.toml")
    return read_machine(Source.read(str(machine)))["input"], ran.err  # type: ignore[return-value]


@pytest.mark.parametrize("presses", PRESSES)
@pytest.mark.parametrize(
    ("step", "noise"), [(0.01, 0.0), (0.005, 0.02), pytest.param(0.001, 0.0, marks=pytest.mark.slow)]
)
def test_a_button_does_not_follow_the_valve_that_it_opens(
    cell: Cell, presses: str, step: float, noise: float
) -> None:
    world = {"input": [*PRESSES[presses], SENSOR], "run.until": 28.0}
    logger = Logger(step, jitter=0.5 * bool(noise), noise=noise)
    found, notes = measured(cell, "press.mnt", world, logger)
    sensor = [each for each in found if each["channel"] == 3]
    assert sensor == [{**SENSOR, "delay": pytest.approx(0.25, abs=step)}]
    button = [each for each in found if each["channel"] == 1]
    assert not any("output" in each or "axis" in each for each in button)
    if presses == "regular":
        assert [(each["every"], each["for"]) for each in button] == [
            (pytest.approx(2.5, abs=0.003), pytest.approx(0.3, abs=step))
        ]
    else:
        assert all("guess" in each for each in button)
        assert len(button) == 2 * len(PRESSES[presses])
    assert "changes of outputs not in the run" not in notes


def test_an_output_that_is_on_from_power_up_on_is_a_cause(cell: Cell) -> None:
    found, _ = measured(cell, "foot.mnt", world_of(FOLDER / "foot.mnt"), Logger(0.005))
    (entry,) = found
    assert entry == {
        "channel": 1,
        "output": 4,
        "delay": pytest.approx(1.0, abs=0.005),
        "for": pytest.approx(0.3, abs=0.005),
    }


HOST = """\
SPEED(0) = 400 : ACCEL(0) = 2000 : DECEL(0) = 2000
Loop
  Repeat
    Wait(20)
  Until COMMS(1) = 6
  COMMS(1) = 0
  OUTX(5) = 1
  OUTX(5) = 0
  MOVEA(0) = 120 : GO(0) : Pause IDLE(0)
  OUTX(2) = 1
  Pause INX(3)
  OUTX(2) = 0
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  Print "part"
End Loop
"""


def test_a_host_that_is_asked_takes_as_long_each_time(cell: Cell) -> None:
    """Output 5 is on for less than a row, so no row has it: this is no other program."""
    program = cell.write("host.mnt", HOST)
    world = {
        "input": [{**SENSOR, "delay": 0.4}],
        "comms": [{"element": 1, "value": 6.0, "asked": 0.7}],
        "run.until": 30.0,
    }
    cell.write("rec.csv", csv_of(Logger(0.005).table(machine_run(Path(program), world))))
    ran = cell("init", "host.mnt", "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    found = read_machine(Source.read(str(cell.folder / "host.machine.toml")))
    assert found["comms"] == [
        {"element": 1, "value": 6.0, "asked": pytest.approx(0.7, abs=0.025), "guess": True}
    ]
    assert found["input"] == [{**SENSOR, "delay": pytest.approx(0.4, abs=0.005)}]
    assert "comms element 1: 6 0." in ran.err
