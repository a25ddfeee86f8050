"""`improve` keeps the place of an act that another task, a handler or a later cycle does while an axis moves."""

from __future__ import annotations

import pytest

from tests.cli.programs import Cell

LIMITS = "[axis.0.limits]\nspeed = 1000\nacceleration = 5000\n"
STROKES = """\
SPEED(0) = 200 : ACCEL(0) = 2000 : DECEL(0) = 2000
For n = 1 To 6
  {}
  MOVEA(0) = 300 : GO(0)
  {}
  PAUSE IDLE(0)
  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
Next
"""
GLUE = """\
Dim n As Integer, flag As Integer
Task Glue
  Loop
    PAUSE flag > 1
    WAIT(200)
    OUTX(1) = _ON
    WAIT(100)
    OUTX(1) = _OFF
    flag = 0
  End Loop
End Task
Run Glue
"""
BEAD = "Event IN2\n  WAIT(100)\n  OUTX(1) = _ON\n  WAIT(50)\n  OUTX(1) = _OFF\nEnd Event\n"
SENSOR = "[[input]]\nchannel = 2\naxis = 0\nabove = 120.0\n"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "machine", "held"),
    [
        (GLUE + STROKES.format("flag = flag + 1", ""), "", "output 1 = 1 no longer at 30"),
        (BEAD + STROKES.format("", ""), SENSOR, "output 1 = 1 no longer at 140"),
        (STROKES.format("", "WAIT(200) : DAC(0) = n"), "", "analogue output 0 = 1 no longer at 30"),
        (
            STROKES.format(
                "", "WAIT(200) : REMOTEOUTX(1, 3, 2) = _ON : WAIT(100) : REMOTEOUTX(1, 3, 2) = _OFF"
            ),
            "",
            "output 2 of node 3 of bus 1 = 1 no longer at 30",
        ),
    ],
    ids=["every second part, by a task", "a sensor on the axis", "an analogue output", "an output of a node"],
)
def test_the_place_of_an_act_is_kept(text: str, machine: str, held: str, cell: Cell) -> None:
    cell.write("bead.mnt", text)
    cell.write("bead.machine.toml", LIMITS + machine)
    out = cell("improve", "bead.mnt").out
    assert "note: SPEED[0]" in out
    assert held in out


@pytest.mark.slow
def test_an_output_that_goes_off_with_one_axis_is_held_while_another_one_moves(cell: Cell) -> None:
    cell.write(
        "two.mnt",
        """\
SPEED(0) = 200 : ACCEL(0) = 2000 : DECEL(0) = 2000
SPEED(1) = 100 : ACCEL(1) = 2000 : DECEL(1) = 2000
For n = 1 To 4
  OUTX(1) = _ON
  MOVEA(0) = 300 : GO(0)
  MOVEA(1) = 50 : GO(1) : PAUSE IDLE(1)
  OUTX(1) = _OFF
  PAUSE IDLE(0)
  MOVEA(0, 1) = 0; : GO(0, 1) : PAUSE IDLE(0) And IDLE(1)
Next
""",
    )
    cell.write("two.machine.toml", LIMITS + LIMITS.replace("axis.0", "axis.1"))
    out = cell("improve", "two.mnt").out
    assert "no edit gains anything" in out
    assert "its axis moves with that of SPEED[1]@2, which stays" in out
