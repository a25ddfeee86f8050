"""The cycle that is improved is a piece: one gripped twice, and one that fails by an input at a fixed second."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.kernel import Run, Source, read_machine
from motionlang_explore.improve import improver_of

LIMITS = """
controller.model = "mintmt"
[axis.0.limits]
speed = 1000
acceleration = 5000
"""

TWICE = """
Const _vEMPTY As Float = 500
Dim part As Integer
ACCEL(0) = 5000 : DECEL(0) = 5000
SPEED(0) = _vEMPTY
SPEED(1) = 200 : ACCEL(1) = 2000 : DECEL(1) = 2000
For part = 1 To 8
  goX(100)
  If part Mod 2 Then goX(140) : Wait(50)
  pickUp
  SPEED(0) = 300
  goX(300)
  letGo
  SPEED(0) = _vEMPTY
  goX(250)
  Wait(1000)
  goX(300)
  pickUp
  SPEED(0) = 300
  goX(380)
  letGo
  SPEED(0) = _vEMPTY
  Print "part "; part
Next
End
Sub pickUp
  goZ(-60)
  OUTX(0) = 1 : Wait(100)
  goZ(0)
End Sub
Sub letGo
  goZ(-60)
  OUTX(0) = 0
  goZ(0)
End Sub
Sub goX(ByVal x As Float)
  MOVEA(0) = x : GO(0) : Pause IDLE(0)
End Sub
Sub goZ(ByVal z As Float)
  MOVEA(1) = z : GO(1) : Pause IDLE(1)
End Sub
"""

# The third part fails, by an input at 8.5 s; a part takes 3 s.
FAILS = """
Dim part As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
For part = 1 To 6
  goX(100)
  Wait(400)
  If INX(1) Then goX(150) : Print "bad" Else goX(120) : Print "good"
  goX(0)
Next
End
Sub goX(ByVal x As Float)
  MOVEA(0) = x : GO(0) : Pause IDLE(0)
End Sub
"""
WORLD = """
controller.model = "mintmt"
input = [{ channel = 1, at = 7.5, for = 0.4 }]
[axis.0.limits]
speed = 200
acceleration = 1000
"""


def test_a_part_that_is_gripped_twice_gains_what_its_empty_moves_gain() -> None:
    machine = read_machine(Source("machine.toml", LIMITS))
    found = improver_of(Source("twice.mnt", TWICE), machine).improved()
    assert found.before == pytest.approx(6.514, abs=1e-3)
    assert [(each.literal.address, each.value) for each in found.edits] == [("_vEMPTY", 1000.0)]
    assert found.before - found.after == pytest.approx(0.18, abs=1e-3)


def test_an_input_at_a_fixed_second_stays_with_its_part() -> None:
    machine = read_machine(Source("machine.toml", WORLD))
    improver = improver_of(Source("fails.mnt", FAILS), machine)
    found = improver.improved()
    bad = ["good", "good", "bad", "good", "good", "good"]
    assert improver._base.output == bad
    assert [each.value for each in found.edits] == [200.0]
    assert found.result.output == bad
    (remark,) = [each for each in found.waits if "belongs" in each]
    assert remark.startswith("input 1 at 7.5 s belongs to piece 3: this run has it at ")


@pytest.mark.slow
def test_the_tray_of_a_leak_tester_gains_all_that_its_limits_allow() -> None:
    """Two tasks, a part that leaks at a fixed second; by hand 33.36 s a tray, and 28.67 s at best."""
    folder = Path(__file__).parent
    machine = read_machine(Source.read(str(folder / "leaktest.world.toml")))
    improver = improver_of(str(folder / "leaktest.mnt"), machine)
    found = improver.improved()
    before, after = (_tray(each) for each in (improver._base, found.result))
    assert before - after > 0.95 * (33.361 - 28.670)
    assert improver._base.output == found.result.output
    assert {"_vLOADED", "SPEED[_axZ]@138"} <= {each.literal.address for each in found.held}


def _tray(made: Run) -> float:
    """Return the time of the four parts from the first one on."""
    times = [each.time for each in made.machine.log.prints if "part" in each.text]
    return times[4] - times[0]


@pytest.mark.slow
def test_32_numbers_are_tried_together() -> None:
    moves = [
        f"  SPEED(0) = {100 + k}\n  MOVEA(0) = {0 if k % 2 else 100} : GO(0) : PAUSE IDLE(0)"
        for k in range(32)
    ]
    head = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nLoop\n"
    text = head + "\n".join(moves) + '\n  Print "part"\nEnd Loop\n'
    limits = "run.until = 150\n[axis.0.limits]\nspeed = 250\nacceleration = 3000\n"
    machine = read_machine(Source("machine.toml", limits))
    found = improver_of(Source("many.mnt", text), machine).improved()
    assert len(found.edits) == 34
    assert found.trials <= 200


def test_what_answers_when_asked_belongs_to_no_piece() -> None:
    """Its time is that from which on it answers, which no edit moves."""
    text = """\
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  Pause INX(1)
  MOVER(0) = 100 : GO(0) : Pause IDLE(0)
  Pause INX(1) = 0
  MOVER(0) = -100 : GO(0) : Pause IDLE(0)
End Loop
"""
    world = 'run.until = 20.0\ninput = [{ channel = 1, asked = 0.3 }]\nkey = [{ text = "S", asked = 1.0, at = 5.0 }]\n'
    source = Source("answers.mnt", text)
    found = improver_of(source, read_machine(Source("answers.machine.toml", world + LIMITS))).improved()
    assert [each.literal.address for each in found.edits] == ["SPEED[0]@1", "ACCEL[0]@1", "DECEL[0]@1"]
    assert not [each for each in found.waits if "belongs to piece" in each]
