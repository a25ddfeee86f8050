"""What was done by hand is a scenario that `motionlang verify` passes, and gives the same run to the byte."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from motionlang.cli import main
from motionlang.commands.panel.play import Play
from motionlang.kernel.report import text as report_of
from tests.commands.panel.hands import PRESS, Hand, operated


def press(hand: Hand, parts: int = 1) -> None:
    """Put in a part and press START, once for each of some parts."""
    hand.rests()
    hand.set(2, 1)
    for _ in range(parts):
        hand.set(1, 1)
        hand.rests()
        hand.set(1, 0)
        hand.rests()


def saved(hand: Hand) -> Path:
    """Save, and return the path of the scenario."""
    hand.notice = ""
    hand("save")
    found = re.match(r"saved (.*\.toml); motionlang verify ", hand.hears("saved "))
    assert found is not None, hand.notice
    return Path(found[1])


def verified(program: Path, capsys: pytest.CaptureFixture[str]) -> str:
    """Verify a program that has only scenarios, and return what that says."""
    main(["verify", str(program)])
    return capsys.readouterr().out


def run_of(hand: Hand) -> Play:
    """Return the present run of a panel."""
    return hand.session._play


def test_a_part_by_hand_is_a_scenario(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "press.mnt"
    with operated(path, PRESS) as hand:
        press(hand)
        scenario = saved(hand)
    assert scenario.relative_to(tmp_path).as_posix() == "press.scenarios/hand-1.toml"
    assert (
        scenario.read_text(encoding="utf-8")
        == """\
# press.mnt as it was operated by hand, saved at 0.64 s by motionlang panel.
run.until = 0.64

input = [
  { channel = 2, at = 0.16, value = 1 },
  { channel = 1, at = 0.16, value = 1 },
  { channel = 1, at = 0.62, value = 0 },
]

expect = [
  { prints = "part 1", after = 0.41, before = 0.51 },
  { quantity = "moves", value = 1 },
  { axis = 0, position = 20.0, within = 0.001 },
  { diagnostic = "never" },
]
"""
    )
    assert "1 of 1 scenarios pass" in verified(path, capsys)


def test_a_scenario_of_a_program_that_has_ended(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "press.mnt"
    with operated(path, PRESS) as hand:
        press(hand, parts=3)
        assert hand.state["end"] == "the program has ended"
        text = saved(hand).read_text(encoding="utf-8")
        assert saved(hand).name == "hand-2.toml"
    assert 'status = "ended"' in text
    assert '{ prints = "done"' in text
    assert "2 of 2 scenarios pass" in verified(path, capsys)


def test_the_same_actions_at_the_same_times_give_the_same_run_to_the_byte(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        press(hand, parts=3)
        by_hand = run_of(hand).result
        hand.state = {}
        hand("back", time=1e6)
        hand.sees(lambda state: state["mode"] == "ended")
        again = run_of(hand).result
        assert by_hand is not None
        assert again is not None
        assert again is not by_hand
        assert report_of(again) == report_of(by_hand)


def test_answers_keys_and_numbers_are_saved(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "ask.mnt"
    text = 'Dim n\nInput "How many", n\nPause COMMS(3) > 4\nPause READKEY\nPause ADC(0) > n\n'
    text += 'Print "over "; n\nPause INX(9)\n'
    with operated(path, text) as hand:
        hand.rests()
        hand("reply", text="12")
        hand.sees(lambda state: state["mode"] == "paused")
        hand.set(3, 5.5, "comms")
        assert hand.rests()["waits"] == [("key", 0, 4)]
        hand("change", table="key", number=0, value="x")
        assert hand.rests()["waits"] == [("analogue", 0, 5)]
        hand.set(0, 50, "analogue")
        assert hand.rests()["waits"] == [("input", 9, 7)]
        made = saved(hand).read_text(encoding="utf-8")
    assert 'answer = [\n  { text = "12" },\n]' in made
    assert re.search(r"comms = \[\n  \{ element = 3, at = [\d.]+, value = 5.5 \},\n\]", made)
    assert re.search(r'key = \[\n  \{ at = [\d.]+, text = "x" \},\n\]', made)
    assert '{ prints = "over 12.0000"' in made
    assert "1 of 1 scenarios pass" in verified(path, capsys)


def test_an_input_of_the_machine_file_that_a_hand_took_is_saved_whole(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "clamp.mnt"
    machine = "input = [{ channel = 2, output = 1, delay = 0.1 }, { channel = 5, at = 0.0 }]\n"
    (tmp_path / "clamp.machine.toml").write_text(machine, encoding="utf-8")
    text = 'OUTX(1) = 1\nPause INX(2)\nPause INX(3)\nOUTX(1) = 0\nPause INX(4)\nPause INX(2)\nPrint "end"\n'
    with operated(path, text) as hand:
        hand.rests()
        hand.set(2, 0)
        hand.set(2, 1)
        hand.set(3, 1)
        hand.rests()
        hand.set(4, 1)
        hand("run")
        hand.sees(lambda state: state["mode"] == "ended")
        made = saved(hand).read_text(encoding="utf-8")
    assert made.count("channel = 2") == 3
    assert "channel = 5" not in made
    assert "1 of 1 scenarios pass" in verified(path, capsys)


@pytest.mark.parametrize(
    ("overrides", "change", "why"),
    [
        ({"pitch": 5.0}, "", "--set pitch is not in the program"),
        ({}, "Pause INX(4)\n", "press.mnt has changed: restart"),
        ({}, None, "{path}: no such file or directory"),
    ],
)
def test_what_is_no_scenario_is_not_saved(
    tmp_path: Path, overrides: dict[str, float | str], change: str | None, why: str
) -> None:
    path = tmp_path / "press.mnt"
    with operated(path, f"Dim pitch\npitch = 4\n{PRESS}", overrides) as hand:
        hand.rests()
        if change:
            path.write_text(change, encoding="utf-8")
        elif change is None:
            path.unlink()
        hand("save")
        hand.hears(f"not saved: {why.format(path=path)}")
        assert not (tmp_path / "press.scenarios").exists()


def test_a_folder_that_cannot_be_made_is_reported(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        (tmp_path / "press.scenarios").write_text("", encoding="utf-8")
        hand("save")
        hand.hears(f"not saved: {tmp_path / 'press.scenarios'}: file exists")
