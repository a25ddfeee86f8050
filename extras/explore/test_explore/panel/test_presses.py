"""A button is down as long as a hand is on it."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang_explore.panel.presses import PATIENCE, Presses
from motionlang_explore.panel.session import WrongAction
from test_explore.panel.hands import PRESS, operated


def test_a_later_message_counts_and_two_pages_hold_one_button() -> None:
    seen: list[tuple[int, bool]] = []
    presses = Presses(lambda number, is_down: seen.append((number, is_down)))
    presses.put("a", 2, [1])
    presses.put("a", 1, [])
    presses.put("b", 1, [1, 2])
    presses.put("a", 3, [])
    assert seen == [(1, True), (2, True)]
    presses.gone("b")
    assert seen[2:] == [(1, False), (2, False)]
    presses.put("a", 2, [5])
    assert not presses.down


def test_a_page_that_does_not_repeat_what_it_presses_presses_nothing() -> None:
    now = [0.0]
    presses = Presses(lambda number, is_down: None, lambda: now[0])
    presses.put("a", 1, [1])
    presses.put("b", 1, [2])
    now[0] = PATIENCE
    presses.put("b", 2, [2])
    presses.expire()
    assert presses.down == {1, 2}
    now[0] += 0.1
    presses.expire()
    assert presses.down == {2}


def test_a_latched_button_stays_on_when_a_hand_leaves_it(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        hand.press(1)
        assert hand.sees(lambda state: state["inputs"] == {1: 1})["pressed"] == [1]
        hand.set(1, 1)
        hand.press()
        hand.press(2)
        state = hand.sees(lambda state: state["inputs"] == {1: 1, 2: 1})
        assert state["pressed"] == [2]
        hand.press(1, 2)
        hand.press()
        hand.press(2)
        hand.set(1, 0)
        hand.sees(lambda state: state["inputs"] == {2: 1})


def test_a_button_that_the_machine_file_drives_is_driven_again_when_the_hand_leaves(tmp_path: Path) -> None:
    (tmp_path / "clamp.machine.toml").write_text("input = [{ channel = 2, output = 1 }]\n", encoding="utf-8")
    with operated(tmp_path / "clamp.mnt", "OUTX(1) = 1\nPause INX(3)\nOUTX(1) = 0\nPause INX(2)\n") as hand:
        hand.press(2)
        hand.rests()
        hand.set(3, 1)
        assert hand.rests()["inputs"] == {2: 1, 3: 1}
        hand.press()
        hand.sees(lambda state: not state["held"])
        hand("run")
        hand.sees(lambda state: state["inputs"] == {3: 1})


def test_fast_presses_come_one_after_another_and_are_saved(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        with hand.busy():
            for _ in range(2):
                hand.press(1)
                hand.press()
        hand("run")
        hand.sees(lambda state: state["t"] > 1.0)
        assert hand.record == [
            (0.16, "input 1 on"),
            (0.18, "input 1 off"),
            (0.2, "input 1 on"),
            (0.22, "input 1 off"),
        ]
        hand("save")
        hand.hears("saved ")


@pytest.mark.parametrize("is_on", [True, False])
def test_a_run_that_goes_back_to_a_press_knows_whether_the_hand_is_still_on(
    tmp_path: Path, is_on: bool
) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        hand.press(1)
        at = hand.rests()["t"]
        if not is_on:
            hand.press()
            hand.sees(lambda state: not state["pressed"])
        hand.state = {}
        hand("back", time=at)
        hand.sees(lambda state: state["t"] == at)
        hand.press(*([1] if is_on else []), 2)
        hand.sees(lambda state: state["inputs"] == ({1: 1, 2: 1} if is_on else {2: 1}))
        hand("restart", keep=False)
        hand.press(*([1] if is_on else []), 3)
        hand.sees(lambda state: state["inputs"] == ({1: 1, 3: 1} if is_on else {3: 1}))


@pytest.mark.parametrize(
    ("asked", "why"),
    [
        ({"numbers": 1}, "numbers must be a list"),
        ({"numbers": [1.5]}, "number must be a whole number"),
        ({"numbers": [-1]}, "channel"),
        ({"numbers": [1], "message": "first"}, "message must be a number"),
    ],
)
def test_a_press_that_is_none_is_refused(tmp_path: Path, asked: dict[str, object], why: str) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand, pytest.raises(WrongAction, match=why):
        hand("press", **{"page": "a", "message": 1, **asked})
