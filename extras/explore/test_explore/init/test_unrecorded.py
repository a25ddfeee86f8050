"""`motionlang init --recording`: numbers, keys and answers come when the recording needs them, and stay guesses."""

from __future__ import annotations

import re

import pytest

from motionlang.kernel import Source, read_machine
from test_explore.init.recordings import FOLDER, Logger, csv_of, machine_run
from tests.cli.programs import Cell

Table = list[dict[str, float]]


def measured(cell: Cell, program: str, logger: Logger) -> tuple[dict[str, Table], str]:
    """Return the machine file that init writes from a recording, and its notes."""
    cell.write(program, (FOLDER / program).read_text())
    cell.write("rec.csv", csv_of(logger.table(machine_run(FOLDER / program))))
    ran = cell("init", program, "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    return read_machine(Source.read(str((cell.folder / program).with_suffix(".machine.toml")))), ran.err  # type: ignore[return-value]


@pytest.mark.slow
@pytest.mark.parametrize("step", [0.001, 0.005, 0.02])
def test_a_host_starts_a_batch(cell: Cell, step: float) -> None:
    """Nothing moves before, so times count from the first row of the recording, 1.7 s before power-up."""
    machine, notes = measured(
        cell, "feeder.mnt", Logger(step, jitter=0.5, noise=0.01, before=1.7, drift=0.003)
    )
    assert (
        "note: nothing recorded shows when the machine was switched on: times count from the first row"
        in notes
    )
    assert "note: not recorded: comms element 1, comms element 2; the entries are guesses\n" in notes
    clock = re.findall(r"note: the clock of the recording is (\S+) % fast; its times are corrected\n", notes)
    assert clock == ([] if step == 0.02 else ["0.3"])  # the strokes have too few rows of 20 ms
    assert "note: comms element 2: 11 at " in notes
    assert "note: cycle " in notes
    (edge,) = machine["input"]
    assert edge["delay"] == pytest.approx(0.18, abs=0.003)
    start, labels = machine["comms"]
    assert (start["element"], start["value"], labels["element"], labels["value"]) == (1, 1, 2, 11)
    assert start["at"] == pytest.approx(1.7 + 2.3, abs=step + 0.003)
    assert all(each["guess"] for each in machine["comms"])


@pytest.mark.slow
def test_an_operator_types(cell: Cell) -> None:
    """One key for each strip, where the punch went on, and the answer with which a strip has as many holes."""
    machine, notes = measured(cell, "punch.mnt", Logger(0.005, jitter=0.5, noise=0.01))
    assert "note: not recorded: a key, the answer to 'holes'; the entries are guesses\n" in notes
    assert [str(each["text"]) for each in machine["answer"]] == ["7"]
    assert [each["at"] for each in machine["key"]] == [pytest.approx(at, abs=0.02) for at in (2.2, 9.1, 13.4)]
    (down,) = machine["input"]
    assert down["delay"] == pytest.approx(0.12, abs=0.003)


def test_a_key_that_comes_every_two_seconds_is_one_entry(cell: Cell) -> None:
    """A part takes 0.4 or 0.8 s in turn, so no key comes a fixed time after the program asks for it."""
    cell.write(
        "beat.mnt",
        "Loop\n  Pause INKEY = 82\n  OUTX(1) = 1 : Wait(400)\n  OUTX(1) = 0 : OUTX(2) = 1 - OUTX(2)\n"
        "  Wait(400 * OUTX(2))\nEnd Loop\n",
    )
    world: dict[str, object] = {"key": [{"text": "R", "at": 1.0, "every": 2.0}], "run.until": 14.0}
    cell.write("rec.csv", csv_of(Logger(0.01).table(machine_run(cell.folder / "beat.mnt", world))))
    ran = cell("init", "beat.mnt", "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    found = read_machine(Source.read(str(cell.folder / "beat.machine.toml")))
    assert found["key"] == [{"text": "R", "at": pytest.approx(1.0, abs=0.02), "every": 2.0, "guess": True}]
