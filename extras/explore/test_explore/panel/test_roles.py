"""An exploration tells switches from buttons, and what must not change while a move runs."""

from __future__ import annotations

import threading
from concurrent.futures import Future
from pathlib import Path

import pytest

from motionlang.kernel import Source
from motionlang_explore.panel.roles import Roles, roles_of
from motionlang_explore.panel.session import WrongAction
from test_explore.panel.hands import operated

GUARD = """\
' IN 1 start  2 guard closed  3 emergency stop
SCALE(0) = 100
SPEED(0) = 20 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  Pause INX(2)
  Pause INX(1)
  MOVER(0) = 20 : GO(0)
  Repeat
    If INX(2) = 0 Then
      STOP(0)
    End If
  Until IDLE(0)
  Pause INX(1) = 0
End Loop
#IN3
  STOP(0)
  Print "stopped"
Return
"""
CHANNEL = """\
first = 3
Loop
  waitFor(first + 1)
  OUTX(1) = 1 : MOVER(0) = 5 : GO(0) : Pause IDLE(0)
End Loop
Sub waitFor(ByVal ch As Integer)
  Pause INX(ch)
  Pause INX(ch) = 0
End Sub
"""


def test_a_guard_is_a_switch_and_stops_the_move(tmp_path: Path) -> None:
    found = roles_of(Source(str(tmp_path / "guard.mnt"), GUARD), {})
    assert found == Roles({1: "button", 2: "switch"}, {7: [2, 3]})


def test_a_guard_that_is_only_waited_for_is_a_switch_and_a_reset_is_none(tmp_path: Path) -> None:
    text = """\
Pause INX(5)
Loop
  Pause INX(2)
  Pause INX(1)
  OUTX(1) = 1 : MOVER(0) = 5 : GO(0) : Pause IDLE(0) : OUTX(1) = 0
  Pause INX(1) = 0
End Loop
"""
    assert roles_of(Source(str(tmp_path / "guard.mnt"), text), {}).kinds == {1: "button", 2: "switch"}


def test_an_input_whose_number_is_computed_has_a_button_once_the_program_is_explored(tmp_path: Path) -> None:
    with operated(tmp_path / "channel.mnt", CHANNEL, explore=roles_of) as hand:
        assert hand.contents["inputs"] == []
        hand.session.explore()
        hand.sees(lambda state: hand.contents["inputs"])
        kinds = {each["number"]: each["kind"] for each in hand.contents["inputs"]}
        assert kinds == {4: "button"}


def test_the_moves_of_a_page_are_marked(tmp_path: Path) -> None:
    with operated(tmp_path / "guard.mnt", GUARD, explore=roles_of) as hand:
        hand.session.explore()
        hand.sees(lambda state: hand.contents["stops"] == {7: [2, 3]})
        hand.set(1, 1)
        hand.set(2, 1)
        hand("run")
        hand.sees(lambda state: state["moving"] == [7])
        hand.sees(lambda state: state["moving"] == [])


def test_a_person_chooses_another_kind_which_stays_when_the_program_is_explored(tmp_path: Path) -> None:
    with operated(tmp_path / "guard.mnt", GUARD, explore=roles_of) as hand:
        hand("kind", number=2, kind="button")
        hand.session.explore()
        hand.sees(lambda state: hand.contents["stops"])
        hand("restart", keep=False)
        hand.hears("started again")
        kinds = {each["number"]: each["kind"] for each in hand.contents["inputs"]}
        assert kinds == {1: "button", 2: "button", 3: "button"}
        with pytest.raises(WrongAction, match="an input is a switch or a button, not lamp"):
            hand("kind", number=2, kind="lamp")


def test_a_page_works_while_the_program_is_explored_and_if_that_fails(tmp_path: Path) -> None:
    begun, results = threading.Event(), Future[Roles]()

    def explore(source: Source, settings: object) -> Roles:
        begun.set()
        return results.result()

    with operated(tmp_path / "guard.mnt", GUARD, explore=explore) as hand:
        hand.session.explore()
        assert begun.wait(30)
        hand.set(2, 1)
        assert hand.rests()["inputs"] == {2: 1}
        results.set_exception(ValueError())
        hand.press(1)
        hand.rests()
        assert hand.contents["stops"] == {}
