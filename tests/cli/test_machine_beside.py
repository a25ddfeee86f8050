"""`pick.machine.toml` next to `pick.mnt` is the program's machine in all commands."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import pytest

from motionlang import run
from motionlang.kernel import ProgramError
from tests.cli.programs import Cell

WAITS = "PAUSE INX(3)\nPRINT TIME\n"
ORDERS = "Loop\n  PAUSE INX(3)\n  PRINT TIME\n  PAUSE Not INX(3)\nEnd Loop\n"
PULSE = "[[input]]\nchannel = 3\nat = 0.25\nfor = 0.1\n"


def test_run_takes_it(cell: Cell) -> None:
    cell.write("pick.mnt", WAITS)
    cell.write("pick.machine.toml", PULSE)
    assert cell("run", "pick.mnt", "--format", "none").out == "250\n"
    assert cell("run", "pick.mnt", "--format", "none").out == "250\n"  # from the cache, too


def test_a_machine_that_is_given_takes_its_place(cell: Cell) -> None:
    cell.write("pick.mnt", WAITS)
    cell.write("pick.machine.toml", PULSE)
    cell.write("late.toml", PULSE.replace("0.25", "0.5"))
    assert cell("run", "pick.mnt", "--machine", "late.toml", "--format", "none").out == "500\n"


def test_python_takes_it(tmp_path: Path) -> None:
    program = tmp_path / "pick.mnt"
    program.write_text(WAITS)
    (tmp_path / "pick.machine.toml").write_text(PULSE)
    assert run(program).output == ["250"]
    assert run(program, machine={}, until=1.0).diagnostics[0].code == "never"
    (tmp_path / "pick.machine.toml").write_text("axis.0.travle = 1\n")
    with pytest.raises(ProgramError, match="travle"):
        run(program)


def test_the_prompt_takes_it(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    cell.write("pick.mnt", WAITS)
    cell.write("pick.machine.toml", PULSE)
    monkeypatch.setattr(sys, "stdin", io.StringIO("PRINT 7\n"))
    assert cell("repl", "pick.mnt").out.split() == ["250", "7"]


@pytest.mark.parametrize("limit", ["", "run.until = 2.0\n"])
def test_a_machine_file_that_has_run_out_is_no_fault(limit: str, cell: Cell) -> None:
    cell.write("orders.mnt", ORDERS)
    cell.write("orders.machine.toml", f"{limit}{PULSE}")
    ran = cell("run", "orders.mnt", "--format", "none")
    assert (ran.status, ran.out) == (0, "250\n")
    assert "note: the machine file has nothing more for what the program waits for\n" in ran.err
    assert "note: line 2: ParentTask still waited until INX(3), since 0.350 s\n" in ran.err


@pytest.mark.parametrize("limit", ["", "run.until = 2.0\n"])
def test_a_time_limit_hides_no_wait_that_nothing_has_ended(limit: str, cell: Cell) -> None:
    cell.write("orders.mnt", ORDERS)
    cell.write("orders.machine.toml", f"{limit}{PULSE.replace('channel = 3', 'channel = 4')}")
    ran = cell("run", "orders.mnt", "--format", "none")
    assert (ran.status, ran.out) == (1, "")
    assert "error[never]: the program waits until INX(3), which can never happen" in ran.err


FAR = "[[input]]\nchannel = 1\naxis = 44\nabove = 1.0\n\n[axis.12]\nstart = 3\n"
FAR_MESSAGE = """\
error[machine-file]: [[input]]: there is no axis 44
 --> far.toml
  hint: the axes are 0 to 7; controller.axes sets their number

error[machine-file]: axis.12: there is no axis 12
 --> far.toml
  hint: the axes are 0 to 7; controller.axes sets their number
"""


def test_an_axis_that_there_is_not_is_no_machine(cell: Cell) -> None:
    cell.write("pick.mnt", "PRINT 1\n")
    cell.write("far.toml", FAR)
    ran = cell("run", "pick.mnt", "--machine", "far.toml")
    assert (ran.status, ran.out, ran.err) == (1, "", FAR_MESSAGE)
    assert cell("check", "pick.mnt", "--machine", "far.toml").status == 1
    ran = cell("repl", "--machine", "far.toml")
    assert (ran.status, ran.err) == (1, FAR_MESSAGE.replace(" --> far.toml\n", ""))
    given = ("--set", "controller.axes=64", "--format", "none")
    assert cell("run", "pick.mnt", "--machine", "far.toml", *given).out == "1\n"


def test_mccl_counts_its_axes_from_one(cell: Cell) -> None:
    assert cell("run", "ballscrew.mcl", "--set", "axis.8.start=1", "--format", "none").status == 0
    ran = cell("run", "ballscrew.mcl", "--set", "axis.0.start=1")
    assert (ran.status, ran.err.splitlines()[0]) == (1, "error[machine-file]: axis.0: there is no axis 0")
