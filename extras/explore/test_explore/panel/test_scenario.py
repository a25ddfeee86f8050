"""What was done by hand is a scenario that `motionlang verify` passes, and gives the same run to the byte."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from motionlang.cli import main
from motionlang.kernel.report import text as report_of
from motionlang_explore.panel.play import Play
from test_explore.panel.hands import PRESS, Hand, operated


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

run.until = 20.0

input = [
  { channel = 2, at = 0.16, value = 1 },
  { channel = 1, asked = 0.16, level = 1, times = 1 },
  { channel = 1, asked = 0.16, level = 0, times = 1 },
]

expect = [
  { prints = "part 1" },
  { quantity = "moves", value = 1 },
  { axis = 0, position = 20.0, within = 0.001 },
  { status = "until" },
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


@pytest.mark.parametrize("speed", [30, 400])
def test_a_scenario_passes_with_another_speed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], speed: int
) -> None:
    path = tmp_path / "press.mnt"
    with operated(path, PRESS) as hand:
        press(hand, parts=3)
        text = saved(hand).read_text(encoding="utf-8")
    assert text.count("asked = ") == 5
    assert "for = " in text  # the last time, START was let go when the program had ended
    path.write_text(PRESS.replace("SPEED(0) = 100", f"SPEED(0) = {speed}"), encoding="utf-8")
    assert "1 of 1 scenarios pass" in verified(path, capsys)


def test_a_button_is_pressed_for_some_time_while_the_program_moves(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "press.mnt"
    text = PRESS.replace("MOVER(0) = 20", "MOVER(0) = 100").replace("  Pause INX(1) = 0\n", "")
    with operated(path, text) as hand:
        hand.rests()
        hand.set(2, 1)
        hand.press(1)
        hand.press()
        hand.rests()
        made = saved(hand).read_text(encoding="utf-8")
    assert "{ channel = 1, asked = 0.16, level = 1, times = 1, for = 0.02 }" in made
    path.write_text(text.replace("SPEED(0) = 100", "SPEED(0) = 50"), encoding="utf-8")
    assert "1 of 1 scenarios pass" in verified(path, capsys)


def test_a_switch_that_is_thrown_twice_is_saved_as_nothing(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        hand.set(1, 1)
        hand.set(1, 0)
        hand("run")
        hand.sees(lambda state: state["t"] > 0.5)
        assert "asked" not in saved(hand).read_text(encoding="utf-8")


def test_a_run_that_goes_on_is_saved_with_its_times(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The run is saved before its next line, so the scenario ends there, and has the times of what it prints."""
    path = tmp_path / "guard.mnt"
    text = "SPEED(0) = 10\nOUTX(1) = 1\nMOVER(0) = 20 : GO(0) : Pause IDLE(0)\n"
    text += 'If INX(3) Then Print "guard open"\nWAIT = 5000\nPrint "over"\nPause INX(4)\n'
    with operated(path, text) as hand:
        hand.set(3, 1)
        hand.rests()
        hand.state = {}
        hand("back", time=3.0)
        hand.sees(lambda state: state["t"] == 3.0 and state["mode"] == "paused")
        made = saved(hand).read_text(encoding="utf-8")
    assert re.search(r"\{ channel = 3, at = [\d.]+, value = 1 \}", made)
    assert re.search(r'\{ prints = "guard open", after = [\d.]+, before = [\d.]+ \}', made)
    assert "1 of 1 scenarios pass" in verified(path, capsys)


def test_the_first_and_the_last_twenty_of_many_prints_are_saved(tmp_path: Path) -> None:
    with operated(tmp_path / "many.mnt", "For k = 1 To 41\n  Print k USING 1\nNext\n") as hand:
        hand.rests()
        prints = re.findall(r'prints = "(\d+)"', saved(hand).read_text(encoding="utf-8"))
    assert prints == [str(k) for k in range(1, 42) if k != 21]


def test_an_input_that_answers_does_so_in_the_panel_until_a_hand_takes_it(tmp_path: Path) -> None:
    path = tmp_path / "press.mnt"
    machine = "input = [{ channel = 1, asked = 0.3, times = 6 }, { channel = 2, asked = 0.2 }]\n"
    (tmp_path / "press.machine.toml").write_text(machine, encoding="utf-8")
    with operated(path, PRESS) as hand:
        hand.set(1, 0)
        assert hand.rests()["waits"] == [("input", 1, 7)]
        assert hand.state["held"] == [1]
        hand("speed", speed=100)
        hand("run")
        assert hand.sees(lambda state: state["t"] > 5.0)["waits"] == [("input", 1, 7)]
        hand("change", table="release", number=1, value=0)
        hand.sees(lambda state: state["mode"] == "ended")


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
        hand.reply("12")
        hand.sees(lambda state: state["mode"] == "paused")
        hand.set(3, 5.5, "comms")
        assert hand.rests()["waits"] == [("key", 0, 4)]
        hand("change", table="key", number=0, value="x")
        assert hand.rests()["waits"] == [("analogue", 0, 5)]
        hand.set(0, 50, "analogue")
        assert hand.rests()["waits"] == [("input", 9, 7)]
        made = saved(hand).read_text(encoding="utf-8")
    assert 'answer = [\n  { text = "12" },\n]' in made
    assert re.search(r"comms = \[\n  \{ element = 3, asked = [\d.]+, value = 5.5, times = 1 \},\n\]", made)
    assert re.search(r'key = \[\n  \{ text = "x", asked = [\d.]+, times = 1 \},\n\]', made)
    assert re.search(r"analogue = \[\n  \{ channel = 0, asked = [\d.]+, value = 50, times = 1 \},\n\]", made)
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


def test_what_answers_does_so_again_after_going_back(tmp_path: Path) -> None:
    machine = "input = [{ channel = 1, asked = 0.3, for = 0.5 }, { channel = 2, asked = 0.2 }]\n"
    (tmp_path / "press.machine.toml").write_text(machine, encoding="utf-8")
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand("speed", speed=100)
        hand("run")
        hand.sees(lambda state: state["mode"] == "ended")
        first = run_of(hand).result
        hand.state = {}
        hand("back", time=0.7)
        hand.sees(lambda state: state["mode"] == "paused" and state["t"] == 0.7)
        hand("run")
        hand.sees(lambda state: state["mode"] == "ended")
        again = run_of(hand).result
        assert first is not None
        assert again is not None
        assert again is not first
        assert report_of(again) == report_of(first)
        assert [each.text for each in first.machine.log.events if each.kind == "asked"].count(
            "input 1 on"
        ) == 3
