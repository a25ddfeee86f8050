"""`motionlang init --recording --update`: guesses of a machine file become facts, and what a person wrote stays."""

from __future__ import annotations

import pytest

from test_explore.init.recordings import FOLDER, Logger, csv_of, machine_run
from tests.cli.programs import Cell

MACHINE = """\
# My saw, bought in 2003.
controller.model = "dcx-pci300"
input = [
  # the hood
  { channel = 1, at = 0.0 },
  { channel = 2, name = "clamped", output = 9, delay = 0.3, guess = true },    # the old clamp
  { channel = 3, output = 11, value = 0, delay = 0.4 },
  { channel = 4, at = 0.0, guess = true },
]    # 6 is missing

[axis.1]
limits.speed = 400    # data sheet
"""
DIFFERENCE = """\
--- saw.machine.toml
+++ saw.machine.toml
@@ -3,9 +3,11 @@
 input = [
   # the hood
   { channel = 1, at = 0.0 },
-  { channel = 2, name = "clamped", output = 9, delay = 0.3, guess = true },    # the old clamp
+  # the old clamp
+  { channel = 2, name = "clamped", output = 9, delay = 0.18 },    # 0.180 s ± 0.001 (12 changes)
   { channel = 3, output = 11, value = 0, delay = 0.4 },
-  { channel = 4, at = 0.0, guess = true },
+  { channel = 4, at = 1.5, for = 1.0, every = 2.6 },    # every 2.600 s ± 0.001; for 1.000 s ± 0.001 (8 changes)
+  { channel = 6, at = 3.2, for = 0.3, guess = true },    # 3.200 s ± 0.001; for 0.300 s ± 0.001 (1 change)
 ]    # 6 is missing
 {blank}
 [axis.1]
""".replace("{blank}", "")


def recorded(cell: Cell, machine: str = MACHINE) -> None:
    cell.write("saw.mccl", (FOLDER / "saw.mccl").read_text())
    cell.write("saw.machine.toml", machine)
    exact = Logger(0.001, before=0.0005)
    cell.write("rec.csv", csv_of(exact.table(machine_run(FOLDER / "saw.mccl"))))


def update(cell: Cell, *options: str) -> tuple[int, str, str]:
    ran = cell("init", "saw.mccl", "--recording", "rec.csv", "--update", *options)
    return ran.status, ran.out, ran.err


def test_the_difference_is_printed_and_the_file_stays(cell: Cell) -> None:
    recorded(cell)
    status, out, err = update(cell)
    assert (status, out) == (0, DIFFERENCE)
    assert "note: input 3 stays as it is; the recording has { channel = 3, axis = 2, below = 0.5" in err
    assert (cell.folder / "saw.machine.toml").read_text() == MACHINE


@pytest.mark.slow
def test_it_is_written_on_request(cell: Cell) -> None:
    """A second update finds nothing more."""
    recorded(cell)
    assert update(cell, "--write")[1] == DIFFERENCE + "saw.machine.toml: written\n"
    text = (cell.folder / "saw.machine.toml").read_text()
    kept = [each for each in MACHINE.splitlines() if "guess" not in each]
    assert [each for each in kept if each not in text.splitlines()] == []
    assert "the old clamp" in text
    assert update(cell)[1] == ""


def test_entries_in_blocks_stay_and_others_follow(cell: Cell) -> None:
    block = 'controller.model = "dcx-pci300"\n\n[[input]]    # mine\nchannel = 1\nat = 0.0\n'
    recorded(cell, block)
    status, out, _ = update(cell, "--write")
    assert status == 0
    text = (cell.folder / "saw.machine.toml").read_text()
    assert text.startswith(block)
    assert "\n[[input]]\n# 0.180 s ± 0.001 (12 changes)\nchannel = 2\noutput = 9\ndelay = 0.18\n" in text


CORRECTED = """\
# corrected by hand
run.until = 60
input = [
  # the part
  { channel = 0, at = 9.0, guess = true },
  { channel = 1, name = "eye", output = 2, value = 0, delay = 0.1 },
]
"""
FEEDER = """\
SPEED = 50 : ACCEL = 500 : DECEL = 500
LOOP
  PAUSE INX.0
  MOVER = 10 : GO : PAUSE IDLE
  PAUSE INX.1
  OUTX.2 = 1 : WAIT = 200 : OUTX.2 = 0
  ? "FED"
  PAUSE NOT INX.0
ENDL
"""


def test_what_a_person_has_corrected_is_true_and_the_rest_is_searched(cell: Cell) -> None:
    cell.write("feed.prg", FEEDER)
    cell.write("feed.machine.toml", CORRECTED)
    ran = cell("init", "feed.prg", "--update", "--write")
    changes = [line for line in ran.out.split("\n") if line[:1] in ("-", "+")]
    assert changes[2:] == [
        "-  { channel = 0, at = 9.0, guess = true },",
        "+  { channel = 0, asked = 0.3, guess = true },",
    ]
    assert ran.status == 0
    assert ran.err.endswith("note: entries that differ: input 0\n")
    again = cell("init", "feed.prg", "--update")
    assert (again.out, "entries that differ" in again.err) == ("", False)
    (cell.folder / "feed.machine.toml").unlink()
    assert "hint: motionlang init feed.prg writes it" in cell("init", "feed.prg", "--update").err


TOOL = """\
Dim n As Integer
Loop
  Pause INX(1)
  OUTX(1) = 1
  MOVER(0) = 10 : GO(0) : Pause IDLE(0)
  OUTX(1) = 0
  n = n + 1
  If n = 30 Then
    Print "change the tool"
    Pause INX(7)
    Pause INX(7) = 0
    n = 0
  End If
  Pause INX(1) = 0
End Loop
"""


@pytest.mark.parametrize("known", ["", "{ channel = 1, asked = 0.2 },"])
def test_a_button_that_must_come_and_go_has_no_constant_level(cell: Cell, known: str) -> None:
    """Also where a person has corrected another entry, which stays."""
    cell.write("tool.mnt", TOOL)
    if known:
        cell.write(
            "tool.machine.toml", f"input = [\n  {known}\n  {{ channel = 7, at = 0.0, guess = true }},\n]\n"
        )
    assert cell("init", "tool.mnt", *(("--update", "--write") if known else ("--format", "none"))).status == 0
    machine = (cell.folder / "tool.machine.toml").read_text()
    assert "{ channel = 7, asked = 0.3, guess = true }" in machine
    assert known in machine


def test_a_machine_that_only_says_that_its_tool_is_worn_is_good(cell: Cell) -> None:
    """It says so after more time than a machine file runs."""
    cell.write("slow.mnt", f"SPEED(0) = 1 : ACCEL(0) = 600 : DECEL(0) = 600\n{TOOL}")
    ran = cell("init", "slow.mnt", "--format", "none")
    assert (ran.status, "no good piece" in ran.err) == (0, False)
