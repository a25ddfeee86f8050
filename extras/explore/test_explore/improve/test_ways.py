"""The final edits in all ways: a time-out that they change refuses them, and what only goes elsewhere is named."""

from __future__ import annotations

import pytest

from tests.cli.programs import Cell

# The clamp must say closed within 1.5 s of a stroke that takes 2.1 s, and 1.1 s with the edits.
CLAMP = """\
' IN 1 part  2 clamp closed
SCALE(0) = 100
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  Pause INX(1)
  OUTX(1) = 1
  TIME = 0
  MOVER(0) = 200 : GO(0)
  While Not IDLE(0)
    If INX(2) = 0 And TIME > 1500 Then LATE
  End While
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  OUTX(1) = 0
End Loop
"""
MACHINE = """\
controller.model = "mintmt"
[axis.0.limits]
speed = 200
acceleration = 2000
[[input]]
channel = 1
at = 0.1
[[input]]
channel = 2
at = 0.2
"""


def improved(cell: Cell, late: str) -> tuple[int, str, str]:
    cell.write("clamp.mnt", CLAMP.replace("LATE", late))
    cell.write("clamp.machine.toml", MACHINE)
    ran = cell("improve", "clamp.mnt", "--patch", "faster.diff")
    return ran.status, ran.out, ran.err


@pytest.mark.slow
def test_edits_that_change_a_printed_line_in_a_way_are_refused(cell: Cell) -> None:
    status, out, err = improved(cell, 'STOP(0) : Print "CLAMP" : Exit')
    assert status == 1
    assert "SPEED[0]@3" in out
    assert "+++" not in out
    assert not (cell.folder / "faster.diff").exists()
    assert err == (
        "error[beyond-limit]: the edits change what the program does: start; input 1 (part) on: "
        "A axis 0 MOVER, cut off at 150.099 (stop), then 'CLAMP' after 0.00 s, "
        "B axis 0 to 200 at 200, then axis 0 to 0 at 200, then output 1 off and 586 more after 0.00 s "
        "(line 8 of A, line 8 of B, in 2 ways)\n"
        "  hint: --hold SPEED[0]@3 keeps that number; --edits and --by make fewer edits\n"
    )


@pytest.mark.slow
def test_a_way_that_only_goes_elsewhere_is_named(cell: Cell) -> None:
    status, out, err = improved(cell, "OUTX(3) = 1")
    assert (status, err) == (0, "")
    assert "ways played with the edits, too: some differ\n" in out
    assert (
        "note: B, with the edits, does something else: start; input 1 (part) on: A output 3 on after" in out
    )
    assert (cell.folder / "faster.diff").exists()


@pytest.mark.slow
def test_an_axis_that_is_elsewhere_in_a_way_refuses_the_edits(cell: Cell) -> None:
    """With input 2 the nozzle opens 0.5 s after the start of the way back, at 45 of 200 uu, and twice as far later."""
    cell.write(
        "nozzle.mnt",
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nLoop\n  Pause INX(1)\n"
        "  MOVEA(0) = 200 : GO(0) : Pause IDLE(0)\n  MOVEA(0) = 0 : GO(0)\n"
        "  If INX(2) Then Wait(500) : OUTX(3) = 1\n  Pause IDLE(0)\n  OUTX(3) = 0\nEnd Loop\n",
    )
    cell.write("nozzle.machine.toml", MACHINE.partition("[[input]]\nchannel = 2")[0])
    ran = cell("improve", "nozzle.mnt")
    assert ran.status == 1
    assert "note: 3 ways played with the edits, too: some differ\n" in ran.out
    assert ran.err == (
        "error[beyond-limit]: the edits change what the program does: start; input 1 on and input 2 on: "
        "line 6: output 3 = 1 no longer at -45.003 uu of the move of line 5\n"
        "  hint: --hold SPEED[0]@1 keeps that number; --edits and --by make fewer edits\n"
    )


def test_speeds_are_no_difference_in_a_world_either(cell: Cell) -> None:
    """The switch of the punch starts the move, without the program's part."""
    cell.write(
        "punch.mnt",
        "SPEED(0) = 500 : ACCEL(0) = 10000 : DECEL(0) = 10000\nTRIGGERMODE(0) = _trINPUT\nTRIGGERINPUT(0) = 1\n"
        'For n = 1 To 2\n  MOVER(0) = 25\n  PAUSE IDLE(0) = 0\n  PAUSE IDLE(0)\n  PRINT "step "; n\nNext\n',
    )
    cell.write(
        "punch.machine.toml",
        "axis.0.limits = { speed = 700, acceleration = 20000 }\n"
        "input = [{ channel = 1, at = 0.2, for = 0.2 }, { channel = 1, at = 0.6, for = 0.2 }]\n",
    )
    ran = cell("improve", "punch.mnt")
    assert " played with the edits, too: the same but for time" in ran.out, ran


def test_the_width_of_a_figure_is_no_difference(cell: Cell) -> None:
    """The time has fewer digits if the way is faster, and so a blank more."""
    cell.write(
        "shuttle.mnt",
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nLoop\n  TIME = 0\n"
        '  MOVEA(0) = 100 : GO(0) : Pause IDLE(0)\n  Print "there "; TIME USING 5\n'
        "  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)\nEnd Loop\n",
    )
    cell.write(
        "shuttle.machine.toml",
        "run.until = 20\naxis.0.limits = { speed = 200, acceleration = 2000 }\n",
    )
    ran = cell("improve", "shuttle.mnt")
    assert "\n+SPEED(0) = 200 : " in ran.out
    assert " played with the edits, too: the same but for time\n" in ran.out


def test_the_end_of_a_run_is_no_difference(cell: Cell) -> None:
    """A faster program may end before the time limit, or while the play of the other one is cut."""
    rates = "SPEED(0) = {} : ACCEL(0) = 1000 : DECEL(0) = 1000\nFOLLOW(1) = 0.5\nFor k = 1 To {}\n"
    moves = "MOVEA(0) = 10 : GO(0) : Pause IDLE(0)\nMOVEA(0) = 0 : GO(0) : Pause IDLE(0)\nPrint k\nNext\n"
    for cycles, until in ((40, 60), (4, 30)):
        cell.write("end.mnt", f"Dim k\n{rates.format(10, cycles)}{moves}")
        limits = "limits = { speed = 40, acceleration = 1000 }"
        cell.write("end.machine.toml", f"run.until = {until}\naxis.0.{limits}\naxis.1.{limits}\n")
        ran = cell("improve", "end.mnt")
        assert (ran.status, "SPEED[0]@2     2    10  40  1.4400" in ran.out) == (0, True), ran.out + ran.err
        assert "note: 1 way played with the edits, too: the same but for time\n" in ran.out


def test_a_way_that_only_the_edits_open_is_not_played(cell: Cell) -> None:
    """The stroke takes 2.1 s, so the program never reads input 2; with the edits it takes 1.1 s, and it does."""
    rates, go = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n", " : GO(0) : Pause IDLE(0)\n"
    early = "  If TIME < 1500 Then\n    If INX(2) Then OUTX(3) = 1\n  End If\n"
    text = f"{rates}Loop\n  Pause INX(1)\n  TIME = 0\n  MOVER(0) = 200{go}{early}  MOVEA(0) = 0{go}End Loop\n"
    cell.write("early.mnt", text)
    cell.write("early.machine.toml", MACHINE.partition("[[input]]\nchannel = 2")[0])
    ran = cell("improve", "early.mnt")
    assert "SPEED[0]@1     1   100   200" in ran.out
    assert "note: 2 ways played with the edits, too: the same but for time\n" in ran.out
