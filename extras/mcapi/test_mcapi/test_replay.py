"""Logs: recorded, printed and replayed, and the messages if a replay differs."""

from __future__ import annotations

import io
import math
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest

import motionlang_mcapi as mc
from motionlang.cli import main
from motionlang_mcapi import Mcapi, VirtualBoard
from motionlang_mcapi.log import BadLog, CallRecorder, model_of, read
from motionlang_mcapi.replay import replay_file

# The move of 5000 counts at 100 000 counts/s² takes twice the root of s/a.
SHORT, SHORT_TIME = 5000.0, 2.0 * math.sqrt(5000.0 / 100_000.0)


def recorded(model: str = "multiflex") -> str:
    """Return the log of a host that moves an axis and reads it in motion."""
    lines: list[str] = []
    board = VirtualBoard({"controller.model": model}, complain=lambda text: None)
    board.desk.record = CallRecorder(lines.append, model)
    host = Mcapi(board)
    host.Open(0, mc.MC_OPEN_BINARY)
    host.GetConfigurationEx(mc.MCPARAMEX())
    host.EnableAxis(1, True)
    host.SetVelocity(1, 40_000.0)
    host.MoveAbsolute(1, SHORT)
    for _ in range(20):
        host.advance(0.01)
        host.GetPositionEx(1)
        host.GetStatus(1)
    host.IsStopped(1, 10.0)
    host.advance(0.05)
    host.GetPositionEx(1)
    host.Wait(0.25)
    host.Close()
    return "".join(lines)


def replayed(text: str, skew: float = 0.01, tolerance: float = 0.0, **machine: object) -> Any:
    with TemporaryDirectory() as folder:
        log = Path(folder, "a.log")
        log.write_text(text, encoding="latin-1")
        return replay_file(str(log), machine, skew, tolerance)


def altered(text: str, what: str, change: Callable[[str], str], which: int = 0) -> tuple[str, int]:
    """Change the answer in one of the log's lines that contain `what`.

    Return the log and the number of the line, from 1.
    """
    lines = text.split("\n")
    number = [k for k, line in enumerate(lines) if what in line][which]
    head, answer = lines[number].split(" = ")
    lines[number] = f"{head} = {change(answer)}"
    return "\n".join(lines), number + 1


def test_a_log_replays_without_a_difference() -> None:
    replay = replayed(recorded())
    assert (replay.first, replay.counts) == (None, {})
    assert replay.calls == 5 + 40 + 4


def test_the_same_host_writes_the_same_log() -> None:
    assert recorded() == recorded()


@pytest.mark.parametrize(
    ("what", "which", "change", "kind"),
    [
        ("MCEnableAxis", 0, lambda answer: "15", "code"),
        ("MCGetConfigurationEx", 0, lambda answer: answer.replace(" 8 8 ", " 8 7 "), "setting"),
        ("MCGetPositionEx", 20, lambda answer: "0 4999.0", "position"),
        ("MCGetStatus", 5, lambda answer: str(int(answer) ^ 1 << mc.MC_STAT_MTR_ENABLE), "state"),
        ("MCGetPositionEx", 5, lambda answer: "0 1.0", "position"),
    ],
)
def test_an_altered_answer_is_found_at_its_call(
    what: str, which: int, change: Callable[[str], str], kind: str
) -> None:
    text, number = altered(recorded(), what, change, which)
    replay = replayed(text)
    assert replay.counts == {kind: 1}
    assert replay.first is not None
    assert replay.first.entry.line == number


def test_a_position_read_in_motion_may_be_off_by_the_skew() -> None:
    """The skew is 10 ms: the travel of 5 ms is within it, that of 20 ms is not."""
    text = recorded()
    at = 6 + 2 * 10
    line = text.split("\n")[at]
    assert "MCGetPositionEx" in line
    begin, position = float(line.split()[0]), float(line.split()[-1])
    velocity = 100_000.0 * (begin - float(text.split("\n")[5].split()[0]))
    near, far = position + 0.005 * velocity, position + 0.02 * velocity
    for value, wanted in ((near, {}), (far, {"position": 1})):
        changed, _ = altered(text, "MCGetPositionEx", lambda answer, value=value: f"0 {value:.1f}", 10)  # type: ignore[misc]
        assert replayed(changed).counts == wanted


def test_a_position_at_rest_has_a_tolerance_in_counts() -> None:
    text, _ = altered(recorded(), "MCGetPositionEx", lambda answer: "0 4997.0", 20)
    assert replayed(text, tolerance=3.0).counts == {}
    assert replayed(text, tolerance=2.0).counts == {"position": 1}


def test_a_blocking_call_may_differ_by_the_skew() -> None:
    """An MCWait of 0.25 s may take 0.255 s, but not 0.3 s."""
    lines = recorded().split("\n")
    number = next(k for k, line in enumerate(lines) if "MCWait" in line)
    begin, _, rest = lines[number].split(" ", 2)
    for took, wanted in ((0.255, {}), (0.3, {"time": 1})):
        changed = list(lines)
        changed[number] = f"{begin} {float(begin) + took:.9f} {rest}"
        changed[number + 1 :] = []
        assert replayed("\n".join(changed) + "\n").counts == wanted


@pytest.mark.parametrize(
    ("wait", "text"),
    [
        ("0.105", None),
        ("0.115", "the call took 0.1000 s, and does not end here"),
        ("0.085", "the call took 0.1000 s, here 0.0850 s"),
    ],
)
def test_the_last_call_of_a_log_may_end_here_later_by_the_skew(wait: str, text: str | None) -> None:
    """It took 100 ms in the log. The skew is 10 ms, and the replay ends then."""
    replay = replayed(f"mcapi-log 1\n0.0 0.0 1 MCOpen 0 2 - = 1\n0.1 0.2 1 MCWait 1 {wait} = -\n")
    assert (replay.first.text if replay.first is not None else None) == text


def test_a_replay_on_another_model_says_which(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = tmp_path / "a.log"
    log.write_text(recorded("dcx-pci100"), encoding="latin-1")
    assert main(["mcapi", "replay", str(log)]) == 0
    assert capsys.readouterr().out == "49 calls, 0 differences\n"
    assert main(["mcapi", "replay", str(log), "--set", "controller.model=multiflex"]) == 1
    found = capsys.readouterr()
    assert found.err == "note: the log is of a dcx-pci100, this board is a multiflex\n"
    assert "a.log:3: at " in found.out
    assert "the log is of a dcx-pci100, this board is a multiflex\n  MCGetConfigurationEx 1 +\n" in found.out


def test_the_model_is_what_the_first_200_bytes_of_a_log_say() -> None:
    assert model_of(io.BytesIO(b"mcapi-log 1 dcx-pci100\n0.0")) == "dcx-pci100"
    assert model_of(io.BytesIO(b"mcapi-log 1\n")) == ""
    assert model_of(io.BytesIO(b"mcapi-log 1 " + 300 * b"x")) == (200 - len("mcapi-log 1 ")) * "x"


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("", 1, "this is no log of MCAPI: the first line is not 'mcapi-log 1'"),
        ("hello\n", 1, "this is no log of MCAPI: the first line is not 'mcapi-log 1'"),
        ("mcapi-log 2\n", 1, "this is version 2 of a log, not 1"),
        (
            "mcapi-log 1\n0.0 0.1 1 MCOpen 0 2 - = 1\n0.2 0.3 1 MCGetPos",
            3,
            "the log is cut in the middle of this line",
        ),
        ("mcapi-log 1\nhello\n", 2, "this is no call: begin, end, host, call = answer"),
        ("mcapi-log 1\n0.0 0.1 1 MCNothing 1 = 0\n", 2, "this is no call: there is no function 'MCNothing'"),
        ("mcapi-log 1\n0.5 0.1 1 MCOpen 0 2 - = 1\n", 2, "this is no call: begin, end, host, call = answer"),
        ("mcapi-log 1\nnan 0.1 1 MCOpen 0 2 - = 1\n", 2, "this is no call: begin, end, host, call = answer"),
        ("mcapi-log 1\n0.0 1e9 1 MCOpen 0 2 - = 1\n", 2, "this is no call: begin, end, host, call = answer"),
        ("mcapi-log 1\n0.0 inf 1 MCOpen 0 2 - = 1\n", 2, "this is no call: begin, end, host, call = answer"),
    ],
)
def test_a_log_that_cannot_be_read(text: str, line: int, message: str) -> None:
    """The message names the line."""
    with pytest.raises(BadLog) as caught:
        list(read(io.BytesIO(text.encode())))
    assert (caught.value.line, str(caught.value)) == (line, message)


def test_a_call_that_does_not_fit_its_function() -> None:
    """A line with too few arguments is not a valid call."""
    assert replayed("mcapi-log 1\n0.0 0.1 1 MCOpen 0 2 - = 1\n0.2 0.2 1 MCStop 1 = 0\n").counts == {
        "code": 1,
        "time": 1,
    }


def test_calls_are_replayed_in_the_order_of_their_begins() -> None:
    """The wait that began first is the last line, because it ended last."""
    text = (
        "mcapi-log 1\n"
        "0.0 0.0 1 MCOpen 0 2 - = 1\n"
        "0.1 0.1 2 MCOpen 0 2 - = 1\n"
        "0.3 0.3 2 MCGetStatus 1 1 = 12\n"
        "0.2 0.7 1 MCIsStopped 1 1 0.5 = 1\n"
    )
    entries = list(read(io.BytesIO(text.encode())))
    assert [entry.begin for entry in entries] == [0.0, 0.1, 0.2, 0.3]
    assert [entry.line for entry in entries] == [2, 3, 5, 4]


def test_a_log_as_mccl(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Each line has the command of a call, and its time as a comment."""
    log = tmp_path / "a.log"
    log.write_text(
        "mcapi-log 1\n"
        "0.0 0.0 1 MCOpen 0 2 - = 1\n"
        "0.1 0.1 1 MCEnableAxis 1 1 1 = -\n"
        "0.2 0.2 1 MCMoveAbsolute 1 1 5000.5 = -\n"
        "0.3 0.3 1 MCGetPositionEx 1 1 + = 0 17.0\n"
        "0.4 0.4 1 MCSetLimits 1 1 9 0 -5.0 5.0 = 0\n"
        "0.5 0.5 1 MCSetProfile 1 1 77 = -\n",
        encoding="latin-1",
    )
    assert main(["mcapi", "log", str(log)]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "; 0.000000 s MCOpen 0 2 - = 1",
        "1MN                             ; 0.100000 s MCEnableAxis",
        "1MA5000.5                       ; 0.200000 s MCMoveAbsolute",
        "1TP                             ; 0.300000 s MCGetPositionEx = 0 17.0",
        "1LL-5,1HL5,1LM2,1LF14,1LN1      ; 0.400000 s MCSetLimits",
        "; 0.500000 s MCSetProfile 1 1 77 = -",
    ]


def test_reports_on_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = tmp_path / "a.log"
    text, number = altered(recorded(), "MCEnableAxis", lambda answer: "15")
    text, _ = altered(text, "MCGetPositionEx", lambda answer: "0 4999.0", 20)
    log.write_text(text, encoding="latin-1")
    assert main(["mcapi", "replay", str(log)]) == 1
    begin = float(text.split("\n")[number - 1].split()[0])
    assert capsys.readouterr().out == (
        f"a.log:{number}: at {begin:.6f} s: the result is 15, here 0\n"
        "  MCEnableAxis 1 1 1\n"
        "49 calls, 2 differences: 1 of code, 1 of position\n"
    )
    log.write_text("mcapi-log 9\n", encoding="latin-1")
    assert main(["mcapi", "replay", str(log)]) == 1
    assert f"{log}:1: this is version 9 of a log, not 1" in capsys.readouterr().err
    assert main(["mcapi", "log", str(tmp_path / "none.log")]) == 1
    assert "none.log: " in capsys.readouterr().err


# An axis that moves 1000 counts at 1000 counts/s from 0.2 s on: it is at full speed after 10 ms and 5 counts.
SLOW = """\
mcapi-log 1
0.0 0.0 1 MCOpen 0 2 - = 1
0.05 0.05 2 MCOpen 0 2 - = 1
0.1 0.1 1 MCEnableAxis 1 1 1 = -
0.11 0.11 1 MCSetVelocity 1 1 1000.0 = 0
0.2 0.2 1 MCMoveAbsolute 1 1 1000.0 = -
"""


@pytest.mark.parametrize(
    ("answer", "counts"),
    [
        # 0.5 s after the start it is at 495; the skew of 10 ms is 10 counts, and half a count is rounding.
        ("MCGetPositionEx 1 1 + = 0 485.0", {}),
        ("MCGetPositionEx 1 1 + = 0 505.0", {}),
        ("MCGetPositionEx 1 1 + = 0 484.0", {"position": 1}),
        ("MCGetPositionEx 1 1 + = 0 506.0", {"position": 1}),
        ("MCGetOptimalEx 1 1 + = 0 490.0", {}),
        ("MCGetVelocityActual 1 1 + = 0 1000.0", {}),
        ("MCGetVelocityActual 1 1 + = 0 999.0", {"position": 1}),
        # The following error is unknown in motion.
        ("MCGetFollowingError 1 1 + = 0 3.0", {}),
        # Bit 3 is "trajectory complete", which motion changes; bit 5 enables the joystick.
        ("MCGetStatus 1 1 = 4110", {}),
        ("MCGetStatus 1 1 = 4130", {"state": 1}),
        ("MCIsStopped 1 1 0.0 = 1", {}),
        ("MCGetVelocityEx 1 1 + = 0 999.0", {"setting": 1}),
        ("MCGetPositionEx 1 1 + = 15", {"code": 1}),
    ],
)
def test_a_reading_in_motion(answer: str, counts: dict[str, int]) -> None:
    assert replayed(f"{SLOW}0.7 0.7 2 {answer}\n").counts == counts


@pytest.mark.parametrize(
    ("answer", "counts"),
    [
        ("MCGetPositionEx 1 1 + = 0 1000.0", {}),
        ("MCGetPositionEx 1 1 + = 0 999.0", {"position": 1}),
        ("MCGetVelocityActual 1 1 + = 0 10.0", {"position": 1}),
        ("MCGetFollowingError 1 1 + = 0 3.0", {"position": 1}),
        ("MCGetStatus 1 1 = 4098", {"state": 1}),
        ("MCIsStopped 1 1 0.0 = 0", {"state": 1}),
    ],
)
def test_a_reading_at_rest(answer: str, counts: dict[str, int]) -> None:
    """The move ends at 1.21 s."""
    assert replayed(f"{SLOW}1.5 1.5 2 {answer}\n").counts == counts


@pytest.mark.parametrize("took", [0.25, 0.245])
@pytest.mark.parametrize(("position", "counts"), [(1000.0, {}), (17.0, {"position": 1})])
def test_a_reading_after_a_wait_that_takes_longer_here(
    took: float, position: float, counts: dict[str, int]
) -> None:
    """The wait takes 250 ms here, and 5 ms less in the log.

    The reading is 5 ms late, and is still checked.
    """
    end = 1.5 + took
    log = f"{SLOW}1.5 {end} 1 MCWait 1 0.25 = -\n{end} {end} 1 MCGetPositionEx 1 1 + = 0 {position}\n"
    assert replayed(log).counts == counts


def test_a_speed_that_changes_may_be_off_by_the_skew() -> None:
    """At 100,000 counts/s² a skew of 4 ms is 400 counts/s.

    5 ms after the start it has 500.
    """
    for speed, counts in ((150.0, {}), (850.0, {}), (50.0, {"position": 1}), (950.0, {"position": 1})):
        log = f"{SLOW}0.205 0.205 1 MCGetVelocityActual 1 1 + = 0 {speed}\n"
        assert replayed(log, skew=0.004).counts == counts


def test_a_poll_of_one_host_does_not_delay_another() -> None:
    """Host 2 stops the axis at 495 while host 1 waits for its end.

    It needs v²/2a = 5 counts.

    The wait ends early, and the axis stays at 500.
    """
    log = (
        f"{SLOW}"
        "0.7 0.7 2 MCStop 1 1 = -\n"
        "0.3 0.71 1 MCIsStopped 1 1 5.0 = 1\n"
        "1.5 1.5 1 MCGetPositionEx 1 1 + = 0 500.0\n"
    )
    assert replayed(log, tolerance=1.0).counts == {}


def test_handles_may_have_other_numbers() -> None:
    """A real library numbers handles in another way."""
    log = (
        "mcapi-log 1\n"
        "0.0 0.0 1 MCOpen 0 2 - = 2\n"
        "0.1 0.1 1 MCOpen 0 1 - = 1\n"
        '0.2 0.2 1 pmcputs 1 "AL7\\x0d" = 4\n'
        "0.3 0.3 1 MCGetRegister 1 0 + 2 = 0 7\n"
        "0.4 0.4 1 MCGetRegister 2 0 + 2 = 0 0\n"
        "0.5 0.5 1 MCOpen 0 2 - = -3\n"
    )
    replay = replayed(log)
    assert replay.counts == {"setting": 1}
    assert replay.first is not None
    assert replay.first.text == "the result is -3, here 3"


def test_a_position_of_a_scaled_axis_is_exact() -> None:
    """At 40 counts per unit, 0.01 units are 0.4 counts.

    Without units positions are whole.
    """
    scale = "0.15 0.15 1 MCSetScale 1 1 6 1.0 0.0 1.0 {} 0.0 1.0 = -\n0.16 0.16 1 MCEnableAxis 1 1 1 = -\n"
    head = SLOW.partition("0.2 0.2")[0]
    for counts_per_unit, wanted in ((40.0, {"position": 1}), (1.0, {})):
        log = head + scale.format(counts_per_unit)
        value = 0.01 if counts_per_unit > 1.0 else 0.4
        assert replayed(f"{log}0.3 0.3 1 MCGetPositionEx 1 1 + = 0 {value}\n").counts == wanted


def test_a_value_of_an_array_that_differs() -> None:
    log = "mcapi-log 1\n0.0 0.0 1 MCOpen 0 2 - = 1\n0.1 0.1 1 MCGetInstalledModules 1 + 3 = 0 252 252 15\n"
    replay = replayed(log)
    assert replay.first is not None
    assert replay.first.text == "modules is 15, here 252"
    assert replay.summary == "2 calls, 1 difference: 1 of setting"


def test_a_call_that_does_not_end() -> None:
    """The log has an answer after 0.1 s; here the input never comes on."""
    replay = replayed("mcapi-log 1\n0.0 0.0 1 MCOpen 0 2 - = 1\n0.1 0.2 1 MCWaitForDigitalIO 1 1 1 = -\n")
    assert replay.first is not None
    assert replay.first.text == "the call took 0.1000 s, and does not end here"
    assert replay.summary == "2 calls, 1 difference: 1 of time"


def test_calls_with_the_same_begin_keep_their_order() -> None:
    """The line that comes after a later begin is read after those with its own begin."""
    text = (
        "mcapi-log 1\n"
        "0.3 0.3 1 MCOpen 0 2 - = 1\n"
        "0.5 0.5 2 MCOpen 0 2 - = 1\n"
        "0.3 0.6 3 MCOpen 0 2 - = 1\n"
        "0.7 0.7 4 MCOpen 0 2 - = 1\n"
    )
    assert [entry.line for entry in read(io.BytesIO(text.encode()))] == [2, 4, 3, 5]


def test_a_zero_that_is_set_shifts_positions_in_motion() -> None:
    """The start is set to 100, so after 495 counts the position is 595."""
    log = SLOW.replace(
        "0.2 0.2 1 MCMoveAbsolute", "0.15 0.15 1 MCSetPosition 1 1 100.0 = -\n0.2 0.2 1 MCMoveRelative"
    )
    for position, counts in ((595.0, {}), (395.0, {"position": 1}), (495.0, {"position": 1})):
        assert replayed(f"{log}0.7 0.7 2 MCGetPositionEx 1 1 + = 0 {position}\n").counts == counts


def test_lines_that_come_late_are_read_in_the_order_of_their_begins() -> None:
    """Each line is a call of another host; five come after one that begins later."""
    begins = [0.1, 0.5, 0.3, 0.2, 0.9, 0.6, 0.7, 0.4]
    lines = [f"{begin} 1.0 {host} MCGetError 1 = 0\n" for host, begin in enumerate(begins)]
    entries = list(read(io.BytesIO("".join(["mcapi-log 1\n", *lines]).encode())))
    assert [(entry.begin, entry.host, entry.line) for entry in entries] == [
        (0.1, 0, 2), (0.2, 3, 5), (0.3, 2, 4), (0.4, 7, 9), (0.5, 1, 3), (0.6, 5, 7), (0.7, 6, 8), (0.9, 4, 6),
    ]  # fmt: skip


@pytest.mark.parametrize(("off", "wanted"), [(0.25, {}), (0.75, {"position": 1})])
def test_a_position_in_user_units_may_be_off_by_the_skew(off: float, wanted: dict[str, int]) -> None:
    """A unit is 40 counts, and the position is set to 25 units before the move.

    The axis runs at 50 units/s, so that 10 ms of skew are 0.5 units.
    """
    lines: list[str] = []
    board = VirtualBoard(complain=lambda text: None)
    board.desk.record = CallRecorder(lines.append, "multiflex")
    host, scale = Mcapi(board), mc.MCSCALE()
    host.Open(0, mc.MC_OPEN_BINARY)
    scale.Constant = scale.Rate = scale.Time = 1.0
    scale.Scale = 40.0
    host.SetScale(1, scale)
    host.EnableAxis(1, True)
    host.SetPosition(1, 25.0)
    host.SetVelocity(1, 50.0)
    host.SetAcceleration(1, 5000.0)
    host.MoveRelative(1, 200.0)
    host.advance(1.0)
    host.GetPositionEx(1)
    host.advance(0.1)
    text, _ = altered("".join(lines), "MCGetPositionEx", lambda answer: f"0 {float(answer.split()[1]) + off}")
    assert replayed(text).counts == wanted
