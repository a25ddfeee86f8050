"""A machine in time: rests, pauses, steps, questions, going back, files that change, and programs that go wrong."""

from __future__ import annotations

import threading
from functools import partial
from pathlib import Path
from queue import Queue

import pytest

from motionlang_explore.panel.play import Play
from motionlang_explore.panel.session import Cursor, WrongAction
from test_explore.panel.hands import PATIENCE, PRESS, State, operated

HOST = """\
Dim k
Repeat
  k = INKEY
Until k > 0
Print "key "; k
Pause COMMS(3) > 4
Print COMMS(3)
Pause ADC(0) > 50
Print "hot"
"""
HOME = """\
SCALE(0) = 100
HOMESPEED(0) = 20
HOME(0) = _hmNEGATIVE_SWITCH
Pause IDLE(0)
Pause INX(1)
"""


def test_a_program_runs_from_rest_to_rest(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        assert hand.rests()["waits"] == [("input", 1, 7)]
        hand.set(1, 1)
        assert hand.rests()["waits"] == [("input", 2, 8)]
        hand.set(2, 1)
        state = hand.rests()
        assert state["waits"] == [("input", 1, 15)]
        assert state["axes"][0][:3] == [20.0, 0.0, None]
        assert hand.text == "part 1\n"
        assert [words for _, words in hand.record] == ["input 1 on", "input 2 on"]


def test_the_velocity_of_an_axis_is_in_user_units(tmp_path: Path) -> None:
    with operated(
        tmp_path / "jog.mnt", "SCALE(0) = 100\nACCEL(0) = 1000\nJOG(0) = 20\nPause INX(1)\n"
    ) as hand:
        hand("run")
        assert hand.sees(lambda state: state["t"] > 0.1)["axes"][0][1] == 20.0


def test_a_move_has_its_start_to_a_millisecond_and_its_line(tmp_path: Path) -> None:
    """The count to ten takes 0.1 ms at least."""
    count = "For n = 1 To 10\nNext\n"
    with operated(tmp_path / "late.mnt", f"WAIT(500)\n{count}MOVER(0) = 20 : GO(0)\nPause INX(1)\n") as hand:
        assert hand.rests()["moves"] == [[0.5, 0, 4]]


def test_a_page_is_never_shown_the_run_before_as_the_present_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        begun: Queue[Play] = Queue()

        def hold(play: Play) -> None:
            begun.put(play)

        with monkeypatch.context() as patch:
            patch.setattr(Play, "start", hold)
            hand("back", time=0)
            play = begun.get(timeout=PATIENCE)
            assert hand.session.updates(Cursor(), 0.0) is None
        play.start()
        hand.sees(lambda state: state["t"] == 0.0)


def test_nothing_is_lost_that_is_asked_for_while_the_run_is_replaced(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        with hand.busy():
            hand.set(1, 1)
            hand("restart", keep=True)
            hand.set(2, 1)
        hand.sees(lambda state: state["inputs"] == {1: 1, 2: 1})
        assert [words for _, words in hand.record] == ["input 1 on", "input 2 on"]


def test_a_run_that_goes_back_is_started_again_up_to_where_it_goes(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        hand.set(1, 1)
        hand.rests()
        with hand.busy():
            hand("back", time=0.2)
            hand("restart", keep=True)
        hand.hears("started again, with 1 action up to 0.20 s")


def test_what_the_page_has_comes_from_comments_and_statements(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        rows = [(each["number"], each["name"], each["kind"]) for each in hand.contents["inputs"]]
        assert rows == [(1, "start", "button"), (2, "part in", "button")]
        assert hand.contents["outputs"] == [{"number": 1, "name": "clamp"}]
        assert hand.contents["axes"] == [{"number": 0, "name": "", "range": None}]


def test_a_step_goes_to_the_next_statement(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        lines: list[int] = []
        for _ in range(4):
            before = hand.state["t"], hand.state["stopped"]
            hand("step")
            hand.sees(partial(_stops_elsewhere, before))
            lines += hand.state["stopped"]
        assert lines == [3, 4, 4, 4]


def test_a_change_at_a_step_is_made_at_the_next_event(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand("step")
        hand.sees(lambda state: state["stopped"])
        hand.set(1, 1)
        assert hand.sees(lambda state: state["pending"])["pending"] == ["input 1 on"]
        hand.rests()
        assert hand.record == [(0.02, "input 1 on")]


def test_a_press_of_a_paused_program_lasts_until_it_goes_on(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        hand.press(1)
        hand.press()
        assert hand.sees(lambda state: state["pending"])["pending"] == ["input 1 off"]
        assert hand.state["inputs"] == {1: 1}
        assert hand.rests()["waits"] == [("input", 2, 8)]
        assert hand.record == [(0.16, "input 1 on"), (0.18, "input 1 off")]


def test_a_change_by_hand_is_no_reading(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        hand.set(3, 1)
        state = hand.sees(lambda state: state["inputs"] == {3: 1})
        assert (state["waits"], state["read"]) == ([("input", 1, 7)], [1])


def test_a_change_at_a_step_stays_if_the_run_is_started_again(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand("step")
        hand.sees(lambda state: state["stopped"])
        with hand.busy():
            hand.set(1, 1)
            hand("restart", keep=True)
        hand.sees(lambda state: state["inputs"] == {1: 1})
        assert hand.record == [(0.02, "input 1 on")]


def test_back_to_an_earlier_moment_cuts_off_what_came_later(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        hand.set(1, 1)
        hand.rests()
        before = hand.state["t"]
        hand.set(2, 1)
        hand.rests()
        hand("back", time=before - 0.02)
        hand.hears(": 1 later action cut off")
        state = hand.sees(lambda state: state["mode"] == "paused" and state["t"] < before)
        assert (state["t"], hand.text) == (round(before - 0.02, 5), "")
        assert [words for _, words in hand.record] == ["input 1 on"]


def test_what_a_hand_does_while_the_run_goes_back_comes_behind_it(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        hand.rests()
        hand.set(1, 1)
        hand.rests()
        hand("back", time=0.2)
        hand.set(2, 1)
        hand.rests()
        assert [words for _, words in hand.record] == ["input 1 on", "input 2 on"]
        assert [time for time, _ in hand.record] == [0.16, 0.2]


def test_a_run_to_the_next_rest_that_is_asked_for_on_the_way_back_may_end_there(tmp_path: Path) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand:
        time = hand.rests()["t"]
        with hand.busy():
            hand("back", time=time)
            hand("rest")
        hand.hears("back at 0.16 s")
        assert hand.sees(lambda state: state["mode"] == "paused")["t"] == time == 0.16


def test_machine_time_stands_until_a_question_is_answered(tmp_path: Path) -> None:
    text = 'Dim n\nInput "How many", n\nPrint n\nPause INX(1)\n'
    with operated(tmp_path / "ask.mnt", text) as hand:
        state = hand.rests()
        assert (state["mode"], state["question"].strip(" ?")) == ("asks", "How many")
        hand.reply("12")
        assert hand.sees(lambda state: state["waits"])["waits"] == [("input", 1, 4)]
        assert "12.0000" in hand.text
        assert hand.record[0][1] == "answer 12"


def test_an_input_whose_number_is_computed_is_the_one_that_the_line_reads_now(tmp_path: Path) -> None:
    text = "waitFor(4)\nwaitFor(5)\nEnd\nSub waitFor(ByVal ch As Integer)\nPause INX(ch)\nEnd Sub\n"
    with operated(tmp_path / "channel.mnt", text) as hand:
        state = hand.rests()
        assert (state["read"], state["waits"]) == ([4], [("input", 4, 5)])
        hand.set(4, 1)
        state = hand.rests()
        assert (state["read"], state["waits"]) == ([4, 5], [("input", 5, 5)])


def test_a_wait_whose_time_is_read_from_a_computed_channel_shows_it_to_its_end(tmp_path: Path) -> None:
    """The second wait is longer than the first one, which is the known period of the loop."""
    text = "Dim n, t\nn = 3\nt = 100\nLoop\nWAIT(t + ADC(n))\nt = 900\nEnd Loop\n"
    with operated(tmp_path / "wait.mnt", text) as hand:
        assert hand.rests()["waits"] == [("analogue", 3, 5)]


def test_an_answer_is_for_its_own_question(tmp_path: Path) -> None:
    text = 'Dim n\nInput "How many", n\nInput "How much", n\nPause INX(1)\n'
    with operated(tmp_path / "ask.mnt", text) as hand:
        first = hand.rests()["asks"]
        with hand.busy():
            hand.reply("12")
            hand.reply("34")
        hand.hears('the answer "34" came too late: its question has been answered')
        hand.sees(lambda state: "much" in (state["question"] or ""))
        assert hand.state["asks"] != first
        hand("back", time=0)
        hand.hears("back at 0 s")
        assert hand.record == [(0.0, "answer 12")]


def test_an_answer_that_is_not_a_number_is_warned_of(tmp_path: Path) -> None:
    text = 'Dim n\nInput "How many", n\nInput "How much", n\nPause INX(1)\n'
    with operated(tmp_path / "ask.mnt", text) as hand:
        hand.rests()
        hand.reply("abc")
        hand.hears('line 2: the answer "abc" is not a number: INPUT takes 0; type a number alone')
        hand.sees(lambda state: state["mode"] == "asks" and "much" in state["question"])
        hand.reply("3x")
        hand.hears('line 3: the answer "3x" is not a number: INPUT takes 3; type a number alone')


def test_keys_and_numbers_of_a_host(tmp_path: Path) -> None:
    with operated(tmp_path / "host.mnt", HOST) as hand:
        assert hand.rests()["waits"] == [("key", 0, 3)]
        hand("change", table="key", number=0, value="A")
        assert hand.rests()["waits"] == [("comms", 3, 6)]
        hand.set(3, 5.5, "comms")
        assert hand.rests()["waits"] == [("analogue", 0, 8)]
        assert hand.state["values"] == {"analogue 0": 0, "comms 3": 5.5}
        hand.set(0, 60, "analogue")
        hand("run")
        hand.sees(lambda state: state["mode"] == "ended")
        assert hand.text.split() == ["key", "65.0000", "5.5000", "hot"]


def test_a_hand_takes_an_input_from_the_machine_file_until_it_lets_go(tmp_path: Path) -> None:
    (tmp_path / "clamp.machine.toml").write_text("input = [{ channel = 2, output = 1 }]\n", encoding="utf-8")
    text = (
        "OUTX(1) = 1\nPause INX(3)\nOUTX(1) = 0\nPause INX(3) = 0\nOUTX(1) = 1\nPause INX(4)\nPause INX(2)\n"
    )
    with operated(tmp_path / "clamp.mnt", text) as hand:
        hand.rests()
        assert hand.contents["inputs"][0]["driven"] == "follows output 1"
        assert hand.state["inputs"] == {2: 1}
        hand.set(2, 0)
        hand.set(3, 1)
        hand.rests()
        hand.set(3, 0)
        state = hand.rests()
        assert (state["inputs"], state["held"], state["outputs"]) == ({}, [2], [1])
        hand("change", table="release", number=2)
        assert hand.sees(lambda state: not state["held"])["inputs"] == {2: 1}


def test_a_homing_axis_is_given_a_switch(tmp_path: Path) -> None:
    with operated(tmp_path / "home.mnt", HOME) as hand:
        hand("run")
        hand.sees(lambda state: state["homing"] == [0])
        hand("switch")
        hand.hears("repeated with axis.0.home_switch = [-22.0, -20.0]")
        hand.sees(lambda state: state["waits"] == [("input", 1, 5)])
        assert hand.state["axes"][0][3] == "homed"


def test_a_fault_and_an_end_stay_on_the_page(tmp_path: Path) -> None:
    with operated(tmp_path / "fault.mnt", "Dim n\nPause INX(1)\nn = 1 / (n - n)\n") as hand:
        hand.rests()
        hand.set(1, 1)
        hand("run")
        state = hand.sees(lambda state: state["mode"] == "fault")
        assert state["end"].startswith("line 3: ")
        hand("back", time=0)
        hand.sees(lambda state: state["mode"] == "paused" and not state["end"])


def test_a_program_that_computes_for_ever_is_paused(tmp_path: Path) -> None:
    with operated(
        tmp_path / "loop.mnt", "Dim n\nWhile 1\nn = n + 1\nIf n > 1000 Then n = 0\nEnd While\n"
    ) as hand:
        hand("run")
        hand.sees(lambda state: state["t"] > 0.1)
        hand("pause")
        state = hand.sees(lambda state: state["mode"] == "paused")
        assert state["tasks"][0][1] in (2, 3, 4)


def test_a_changed_file_is_run_again_with_the_same_actions(tmp_path: Path) -> None:
    path = tmp_path / "press.mnt"
    with operated(path, PRESS) as hand:
        hand.rests()
        hand.set(1, 1)
        hand.rests()
        path.write_text(PRESS.replace("Pause INX(2)", "Pause INX(3)"), encoding="utf-8")
        hand("restart", keep=True)
        hand.hears("started again, with 1 action")
        hand.sees(lambda state: state["waits"] == [("input", 3, 8)])
        path.write_text("Pause INX(\n", encoding="utf-8")
        with pytest.raises(WrongAction, match="not restarted: line 1"):
            hand("restart", keep=True)


class Twice(threading.Event):
    """An event that comes after two waits, which take no time."""

    waits = 0

    def wait(self, timeout: float | None = None) -> bool:
        self.waits += 1
        return self.waits > 2


def test_a_change_of_the_file_is_offered(tmp_path: Path) -> None:
    path = tmp_path / "press.mnt"
    with operated(path, PRESS) as hand:
        hand.session.watch(Twice())
        path.write_text(f"{PRESS}' longer\n", encoding="utf-8")
        hand.session.watch(Twice())
        hand.hears("press.mnt or its machine file has changed")
        assert hand.is_changed
        path.write_text(f"{PRESS}Pause INX(\n", encoding="utf-8")
        with pytest.raises(WrongAction, match="not restarted: line 18"):
            hand("restart", keep=False)
        hand.session.say("")
        path.write_text(PRESS, encoding="utf-8")
        hand.session.watch(Twice())
        hand.hears("press.mnt or its machine file has changed")
        hand("restart", keep=False)
        hand.hears("started again")
        assert not hand.is_changed


@pytest.mark.parametrize(
    ("asked", "why"),
    [
        ({"do": "fly"}, "unknown action"),
        ({"do": "speed", "speed": 1000}, "the speed is 0.1 to 100"),
        ({"do": "back", "time": "now"}, "time must be a number"),
        ({"do": "back", "time": -5}, "^the run begins at 0 s: choose 0 or later$"),
        (
            {"do": "change", "table": "input", "number": 1, "value": 7},
            r"^an input is 1 \(on\) or 0 \(off\), not 7$",
        ),
        ({"do": "change", "table": "input", "number": 1.5, "value": 1}, "number must be a whole number"),
        ({"do": "rule", "number": 1.5}, "number must be a whole number"),
        ({"do": "change", "table": "fault", "number": 0, "value": 1}, "fault cannot be changed by hand"),
        ({"do": "change", "table": "input", "number": -1, "value": 1}, "channel"),
        ({"do": "change", "table": "comms", "number": 1, "value": None}, "value must be a number"),
        ({"do": "change", "table": "release", "number": 1}, "does not drive input 1"),
        ({"do": "rule", "number": 1}, "nothing explains"),
        ({"do": "reply", "text": "a\nb"}, "an answer is one line"),
        ({"do": "reply", "text": "a"}, "question must be a number"),
    ],
)
def test_what_no_page_may_ask_for_is_refused(tmp_path: Path, asked: dict[str, object], why: str) -> None:
    with operated(tmp_path / "press.mnt", PRESS) as hand, pytest.raises(WrongAction, match=why):
        hand.session.act(asked)


def _stops_elsewhere(before: tuple[float, list[int]], state: State) -> bool:
    """True if a run has stopped, and not where it was."""
    return state["mode"] == "paused" and (state["t"], state["stopped"]) != before


def test_an_input_that_follows_an_output_becomes_a_rule(tmp_path: Path) -> None:
    text = "Dim n\nFor n = 1 To 3\nOUTX(1) = 1\nPause INX(2)\nOUTX(1) = 0\nPause INX(2) = 0\n"
    text += "Print n\nNext\nPause INX(5)\n"
    with operated(tmp_path / "clamp.mnt", text) as hand:
        for level in (1, 0):
            hand.rests()
            hand.set(2, level)
        hand.rests()
        assert hand.rules == {2: "follows output 1 after 0.16 s"}
        hand("rule", number=2)
        hand.hears("repeated: input 2 follows output 1 after 0.16 s")
        hand("run")
        hand.sees(lambda state: state["waits"] == [("input", 5, 9)])
        assert hand.contents["inputs"][0]["driven"] == "follows output 1 after 0.16 s"
        assert (hand.text.split(), hand.record) == (["1.0000", "2.0000", "3.0000"], [])
        hand.notice = ""
        hand("save")
        hand.hears("saved ")
        made = (tmp_path / "clamp.scenarios" / "hand-1.toml").read_text(encoding="utf-8")
        assert "{ channel = 2, output = 1, delay = 0.16 }" in made


def test_a_rule_stays_if_the_machine_file_changes(tmp_path: Path) -> None:
    text = "OUTX(1) = 1\nPause INX(2)\nOUTX(1) = 0\nPause INX(2) = 0\nPause INX(5)\nPause INX(6)\n"
    with operated(tmp_path / "clamp.mnt", text) as hand:
        for level in (1, 0):
            hand.rests()
            hand.set(2, level)
        hand.rests()
        hand("rule", number=2)
        hand.hears("repeated: input 2 follows output 1")
        (tmp_path / "clamp.machine.toml").write_text(
            "input = [{ channel = 5, at = 0.0 }]\n", encoding="utf-8"
        )
        hand("restart", keep=False)
        hand.sees(lambda state: state["waits"] == [("input", 6, 6)])
        driven = {each["number"]: each["driven"] for each in hand.contents["inputs"]}
        assert driven == {2: "follows output 1 after 0.16 s", 5: "set by the machine file", 6: ""}


def test_an_axis_of_mccl_that_looks_for_its_switch_is_given_one(tmp_path: Path) -> None:
    text = "1US100\n1MN\n1VM,1DI1,1SV40,1GO,1FE0,1ST,1WS.1\nWN2\n"
    with operated(tmp_path / "home.mccl", text) as hand:
        hand("run")
        hand.sees(lambda state: state["homing"] == [1])
        assert hand.state["tasks"][0][2] == "for the home switch of axis 1"
        hand("switch")
        hand.hears("repeated with axis.1.home_switch = [-44.0, -40.0]")
        hand.sees(lambda state: state["waits"] == [("input", 2, 4)])


def test_a_task_that_polls_now_and_then_is_no_other_rest(tmp_path: Path) -> None:
    text = (
        "Task heater\nDim n\nLoop\nIf ADC(0) < 50 Then\nOUTX(1) = 1\nEnd If\nWait(300)\nEnd Loop\nEnd Task\n"
    )
    with operated(tmp_path / "heat.mnt", f"{text}Run heater\nPause INX(2)\nPause INX(3)\n") as hand:
        hand.rests()
        hand("speed", speed=100)
        hand("run")
        waits = hand.sees(lambda state: state["t"] > 1.0)["waits"]
        assert waits == [("analogue", 0, 4), ("input", 2, 11)]
        hand("rest")
        hand.set(2, 1)
        hand.sees(lambda state: state["mode"] == "paused")
        assert hand.state["waits"] == [("analogue", 0, 4), ("input", 3, 12)]


def test_an_input_that_the_program_asks_for_becomes_a_rule(tmp_path: Path) -> None:
    """A loop polls it, and no output changes."""
    text = "Dim n\nFor n = 1 To 3\nWhile INX(2) = 0 : End While\nPause INX(2) = 0\nNext\nPause INX(5)\n"
    with operated(tmp_path / "poll.mnt", text) as hand:
        for level in (1, 0):
            hand.rests()
            hand.set(2, level)
        hand.rests()
        (words,) = hand.rules.values()
        assert words.endswith(" s after it is asked for")
        hand("rule", number=2)
        hand("run")
        hand.sees(lambda state: state["waits"] == [("input", 5, 6)])
