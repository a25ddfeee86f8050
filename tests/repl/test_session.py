"""Sessions that transcripts cannot show: interrupts, pacing, files."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from motionlang.kernel import ONE_SHIFT, Source, dialect
from motionlang.repl.command import open_session
from motionlang.repl.commands import COMMANDS, PromptCommand
from motionlang.repl.live import Live
from motionlang.repl.session import Session
from motionlang.repl.status import number_text


def after(polls: int) -> object:
    """Return a user who presses Ctrl-C after a command has run for some polls."""
    left = iter(range(polls))
    return lambda: next(left, None) is None


def test_ctrl_c_ends_the_command_and_the_axis_goes_on() -> None:
    session = Session(dialect("mccl"))
    session.feed("1MN,1PM,1SV1000,1SA5000,1DS5000")
    session.interrupted = after(20)  # type: ignore[assignment]
    answer = session.feed("1MR1000,WA0.5,WA0.25,1TP,RP")
    assert "error[interrupted]: the command was interrupted from the keyboard" in answer
    session.interrupted = lambda: False
    assert session.feed("1WS0,1TP") != "01 0\n"
    assert not session.over


def test_pace_is_called_with_the_next_time() -> None:
    session = Session(dialect("mccl"))
    times: list[float] = []
    session.pace = times.append
    session.feed("WA3")
    assert times == sorted(times)
    assert times[-1] == pytest.approx(3.0, abs=1e-3)


def test_pace_is_called_when_a_background_task_continues() -> None:
    """The command waits and is interrupted every 0.25 s; then the task Other runs.

    No task runs in between.
    """
    session = Session(dialect("mint"))
    session.feed("Task Other\nLoop\n  WAIT(300)\nEnd Loop\nEnd Task")
    session.feed("Run Other")
    times: list[float] = []
    session.pace = times.append
    session.feed("WAIT(2000)")
    for moment in (0.3, 0.6, 0.9, 1.2, 1.5, 1.8):
        assert any(time == pytest.approx(moment, abs=1e-3) for time in times), moment


def test_a_command_that_never_ends_is_ended_after_a_shift() -> None:
    session = Session(dialect("mccl"))
    assert "error[never]" in session.feed("WA1000,RP")
    session.reset()
    assert "error[limit]" in session.feed("WA1000,AA1,RP")
    assert session.machine.controller.clock.now == pytest.approx(ONE_SHIFT)
    assert session.feed("1TP") == "01 0\n"


def test_input_is_answered_by_ask() -> None:
    session = Session(dialect("mint"), {"answer": [{"text": "3"}]})
    prompts: list[tuple[str, float]] = []

    def answer(begun: str) -> str:
        prompts.append((begun, session.machine.clock.now))
        return "21"

    session.ask = answer
    session.feed("Dim n As Integer")
    assert (
        session.feed('INPUT "how many? ", n : PRINT n * 2') == "how many? 3\n6\n"
    )  # the machine file's comes first
    assert session.feed('INPUT "how many? ", n : PRINT n * 2') == "how many? 21\n42\n"
    assert session.feed(".reset") == ""
    assert session.feed("Dim s As String\nINPUT s : PRINT s; : INPUT s") == "3\n321\n"
    assert [begun for begun, _ in prompts] == ["how many? ", "3"]
    assert all(time < 1e-3 for _, time in prompts)


def test_ctrl_c_instead_of_an_answer_ends_the_command_at_the_input() -> None:
    session = Session(dialect("mint"))

    def leave(begun: str) -> str:
        raise KeyboardInterrupt

    session.feed("Dim n As Integer")
    session.ask = leave
    answer = session.feed("n = 3 : INPUT n")
    assert "error[interrupted]: the command was interrupted from the keyboard\n --> input:2:9\n" in answer
    assert session.feed("PRINT n") == "3\n"


def test_unanswered_input_ends_the_command() -> None:
    session = Session(dialect("mint"))
    answer = session.feed("Dim n As Integer\nINPUT n")
    assert answer == (
        "error[never]: the command waits for the operator to answer INPUT, which can never happen\n"
        " --> input:2:1\n  |\n2 | INPUT n\n  | ^^^^^\n"
        "  hint: .answer 1 ends it, as does [[answer]] of the machine file\n"
    )
    assert session.feed("PRINT 1") == "1\n"


def test_an_input_takes_the_next_line_of_standard_input(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    text = b'Dim n As Integer\nINPUT "how many? ", n\n21\r\nPRINT n * 2\nINPUT n\n'
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(text)))
    assert open_session("mint") == 1
    out, err = capsys.readouterr()
    assert out == "how many? 21\n42\n"
    assert "the command waits for the operator to answer INPUT" in err


def test_no_command_lives_on_what_an_earlier_one_printed() -> None:
    session = Session(dialect("mccl"))
    session.feed("1TP")
    assert session.machine.terminal.lines == []


def test_without_a_terminal_lines_come_from_standard_input(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    program = tmp_path / "pick.mcl"
    program.write_text("1DH7\n")
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"1TP\r\n1XX\n\xff\n.quit\n2TP\n")))
    assert open_session(None, str(program)) == 1
    out, err = capsys.readouterr()
    assert out.startswith("01 7\n?1\n")
    assert "02 0" not in out
    assert err.startswith("error[unknown-word]: there is no command XX")


def test_a_session_without_trouble_ends_well(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("1TP\n"))
    assert open_session("mccl") == 0
    assert capsys.readouterr() == ("01 0\n", "")


def test_machine_unknown_to_the_language_is_reported(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("1TP\n"))
    assert open_session("mccl", None, {"controller.model": "abacus"}) == 1
    assert "abacus" in capsys.readouterr().err


def test_a_language_that_rejects_the_machine_is_not_switched_to() -> None:
    session = Session(dialect("mint"), {"controller.model": "mint4"})
    session.feed("SCALE(0) = 2")
    answer = session.feed(".mccl")
    assert answer.startswith("error[machine-file]: MCCL has no model mint4\n")
    session = Session(dialect("mint"), overrides={"SPEED[0]": 4.0})
    session.feed("SCALE(0) = 2 : WAIT = 500")
    assert session.feed(".mccl").startswith("error[unknown-word]: SPEED[0] is not a register\n")
    assert session.feed("PRINT SCALE(0)\n.time") == "2.0000\n0.50003 s   0: 0\n"


def test_live_mode_lets_the_machine_catch_up_with_the_wall(monkeypatch: pytest.MonkeyPatch) -> None:
    wall = [100.0]
    monkeypatch.setattr("time.monotonic", lambda: wall[0])
    monkeypatch.setattr("time.sleep", lambda seconds: wall.__setitem__(0, wall[0] + seconds))
    session = Session(dialect("mccl"))
    clock = session.machine.controller.clock
    live = Live(session)
    session.live = False
    wall[0] += 5.0
    live.catch_up()
    assert clock.now == 0.0

    session.live = True
    wall[0] += 1.5
    live.catch_up()
    assert clock.now == pytest.approx(1.5)

    live.begin()
    session.feed("WA2")
    live.end()
    assert wall[0] == pytest.approx(108.5, abs=0.03)
    assert clock.now == pytest.approx(3.5, abs=1e-3)


def test_a_position_at_the_prompt_is_in_whole_counts() -> None:
    """In the 10 µs of GO the axis moves ½·1·(1e-5)² uu.

    This is less than a count, which a controller cannot show.
    """
    session = Session(dialect("mint"))
    session.feed("SCALEFACTOR(0) = 1000 : SPEED(0) = 10 : ACCEL(0) = 1 : MOVER(0) = 100 : GO(0)")
    assert session.feed("PRINT POS(0)") == "0.0000\n"
    assert session.feed("PRINT POS") == "0.0000\n"
    assert session.feed("Dim x As Float = POS(0)\nPRINT x > 0 And x < 1e-6") == "1\n"
    session.machine.clock.advance(1.0)  # ½·1·1² uu are 500 counts
    assert session.feed("PRINT POS(0), POSREMAINING(0)") == "0.500099.5000\n"


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (4e-13, "0"), (-4e-13, "0"), (6e-13, "0.0000000000006"), (1 / 3, "0.3333333333")],
)
def test_a_number_has_ten_digits_and_no_noise_below_half_of_1e_12(value: float, text: str) -> None:
    assert number_text(value) == text


def test_a_line_reports_success() -> None:
    """Texts that do not compile, that fail, and that never end."""
    session = Session(dialect("mint"))
    session.feed("Dim x As Float")
    texts = ("PRINT 1", "PRINT +", "x = 0 : PRINT 1 / x", "PAUSE IN(1)", "PRINT 2")
    assert [session.execute(Source("input", text)) for text in texts] == [True, False, False, False, True]
    assert [session.load(Source("a.mnt", text)) for text in texts] == [True, False, False, False, True]
    assert [session.runner.pass_time(0.1), session.runner.settle()] == [True, True]
    session.feed("JOG(0) = 5")
    assert [session.runner.pass_time(0.1), session.runner.settle()] == [True, False]


def test_a_handler_continues_after_an_interrupted_command() -> None:
    """Ctrl-C ends the command at 0.25 s, but not the handler from 0.1 s to 0.6 s."""
    session = Session(dialect("mint"))
    session.feed("Event IN1\n  WAIT = 500\n  PRINT 7\nEnd Event\n.input 1=1@0.1")
    session.interrupted = lambda: session.machine.clock.now >= 0.25
    assert "error[interrupted]" in session.feed("WAIT = 300")
    session.interrupted = lambda: False
    assert session.feed("WAIT = 500") == "7\n"


def test_a_task_that_fails_has_ended() -> None:
    """It fails at 0.1 s, at no line of the command; the other task continues."""
    session = Session(dialect("mint"))
    session.feed(
        "Dim z\nTask t\n  WAIT = 100\n  PRINT 1 / z\nEnd Task\nTask u\n  WAIT = 900\n  PRINT 9\nEnd Task"
    )
    session.feed("Run t : Run u")
    assert session.feed("WAIT = 500") == (
        "error[division-by-zero]: division by zero\n  hint: test the divisor before dividing\n"
    )
    assert session.machine.scheduler is not None
    assert [task.name for task in session.machine.scheduler.tasks] == ["ParentTask", "u"]
    assert session.feed("WAIT = 900") == "9\n"


def test_a_missing_library_is_reported_and_another_error_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    session = Session(dialect("mint"))
    errors: list[Exception] = []

    def fail(*_: object) -> None:
        raise errors[0]

    monkeypatch.setattr(session.runner.interactive, "task", fail)
    monkeypatch.setitem(COMMANDS, "report", PromptCommand("report", "", "A report.", fail))
    errors[:] = [ImportError("no numpy", name="numpy")]
    for line, user in (("PRINT 1", "this line"), (".report", ".report")):
        assert session.feed(line).startswith(f"error[extra]: {user} needs numpy\n")
        assert session.failed
    assert session.execute(Source("input", "PRINT 1")) is False
    errors[:] = [ImportError("no module", name="other")]
    for line in ("PRINT 1", ".report"):
        with pytest.raises(ImportError, match="no module"):
            session.feed(line)


def test_messages_are_wrapped_at_words_on_a_terminal() -> None:
    session = Session(dialect("mint"))
    session.live, session.width = False, 50
    assert session.feed(".analog 0=200\n.axe") == (
        "error[option]: value of [[analogue]] must be a\n"
        "  percentage, -100 to 100, not 200.0\n"
        "  hint: the value in percent, such as 25\n"
        "error[unknown-word]: there is no command .axe\n"
        "  hint: did you mean .axes?\n"
    )
    session.feed("SPEED(0) = 5")
    assert session.feed("MOVER(0) = 100 : GO(0)") == (
        "-- axis 0 in motion, time is paused: .run S or\n.settle continues\n"
    )
