"""Signals at any stage of a run, and crashes: complete reports and files."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from motionlang import __version__
from motionlang.cli import main, signals
from motionlang.cli import option_groups as shared
from motionlang.kernel import Scheduler, Terminated, Trace
from motionlang.kernel.mint import MintProgram
from tests.cli.programs import MAX_SECONDS, Cell

COMMAND = [sys.executable, "-m", "motionlang"]
MOVE = "MOVER(0) = 10\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n"
# Its iterations are never the same, and none can be skipped.
ENDLESS = "Dim i As Integer\nPRINT 1\nWhile 1\n i = (i * 75 + 74) Mod 65537\nWend\n"
SIGNALS = [
    pytest.param(signal.SIGINT, "from the keyboard", 130, id="SIGINT"),
    pytest.param(signal.SIGTERM, "by SIGTERM", 143, id="SIGTERM"),
    pytest.param(signal.SIGHUP, "by SIGHUP", 129, id="SIGHUP"),
]
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")


@pytest.fixture(autouse=True)
def no_signal_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Enable SIGHUP, which the test runner may ignore, and freeze the clock."""
    before = signal.signal(signal.SIGHUP, signal.SIG_DFL)
    monkeypatch.setattr(signals, "monotonic", lambda: 0.0)
    yield
    signal.signal(signal.SIGHUP, before)


def sending(number: int, call: Callable[..., object]) -> Callable[..., object]:
    """Return the function, preceded by two deliveries of the signal at each call."""

    def do(*given: object, **named: object) -> object:
        signal.raise_signal(number)
        signal.raise_signal(number)
        return call(*given, **named)

    return do


STAGES = {
    "compiling": (MintProgram, "require", "interrupted"),
    "running": (Scheduler, "run", "interrupted"),
    "reporting": ("motionlang.cli.run_command", "pieces", "ended"),
}


@pytest.mark.parametrize("stage", STAGES)
@pytest.mark.parametrize(("number", "who", "status"), SIGNALS)
def test_a_signal_at_any_stage(
    stage: str, number: int, who: str, status: int, cell: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    owner, name, outcome = STAGES[stage]
    if isinstance(owner, str):
        owner = import_module(owner)
    monkeypatch.setattr(owner, name, sending(number, getattr(owner, name)))
    cell.write("a.mnt", MOVE)
    ran = cell("run", "a.mnt", "--format", "json")
    report = json.loads(ran.out)
    assert (ran.status, report["status"]) == (status, outcome)
    messages = [each["message"] for each in report["diagnostics"]]
    assert messages == ([f"the run was ended {who}"] if outcome == "interrupted" else [])


@pytest.mark.parametrize("most", [10, 0])
def test_an_ended_run_is_certified_where_that_takes_no_time(
    most: int, cell: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = Scheduler.run

    def interrupted(scheduler: Scheduler, *given: Any) -> Any:
        whole(scheduler, 0.5)
        raise KeyboardInterrupt

    monkeypatch.setattr(Scheduler, "run", interrupted)
    monkeypatch.setattr("motionlang.commands.certify.command.CERTIFIED_IN_TIME", most)
    cell.write("a.mnt", "SPEED(0) = 5\n" + MOVE)
    ran = cell("certify", "a.mnt", "--set", "axis.0.limits.speed=100", "--format", "json")
    codes = [each["code"] for each in json.loads(ran.out)["diagnostics"]]
    assert (ran.status, codes) == (130, ["interrupted"] if most else ["interrupted", "beyond-limit"])


def test_a_signal_while_the_file_is_read(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    cell.write("a.mnt", MOVE)
    monkeypatch.setattr(shared, "read", sending(signal.SIGTERM, shared.read))
    ran = cell("run", "a.mnt", "--format", "json")
    assert (ran.status, json.loads(ran.out)["status"]) == (143, "interrupted")


@pytest.mark.parametrize(
    "command",
    [
        "diff b.mnt a.mnt",
        "compare a.mnt b.csv --map position.0=Pos",
        "certify .",
        "pvt export a.mnt",
        "verify . --update -j 1",
    ],
)
def test_a_signal_that_ends_a_run_ends_its_command(
    command: str, cell: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No comparison, certificate or file takes the part that ran for the whole."""
    cell.write("a.mnt", MOVE)
    cell.write("b.csv", "time,Pos\n0,0\n0.1,1\n0.2,2\n0.3,3\n")
    if "b.mnt" in command:
        cell.write("b.mnt", MOVE)
    run = Scheduler.run

    def interrupted(scheduler: Scheduler, *given: Any) -> Any:
        monkeypatch.setattr(Scheduler, "run", run)
        signal.raise_signal(signal.SIGTERM)

    monkeypatch.setattr(Scheduler, "run", interrupted)
    before = sorted(cell.folder.glob("[!.]*"))
    ran = cell(*command.split())
    assert (ran.status, ran.out, sorted(cell.folder.glob("[!.]*"))) == (143, "", before)


def test_a_signal_during_a_trace_leaves_the_report_and_no_half_of_a_file(
    cell: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    cell.write("a.mnt", MOVE)
    before = cell.write("a.csv", "old")
    monkeypatch.setattr(Trace, "chunks", sending(signal.SIGTERM, Trace.chunks))
    ran = cell("trace", "a.mnt", "a.csv", "--format", "json")
    assert (ran.status, json.loads(ran.out)["status"], before.read_text()) == (143, "ended", "old")
    assert "a.csv was not written: the command was ended by SIGTERM" in ran.err
    assert not [each for each in os.listdir() if each.startswith(".a.csv")]


def test_a_second_wish_ends_the_report_too(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    times = iter([10.0, 10.5, 12.0])
    monkeypatch.setattr(signals, "monotonic", lambda: next(times))

    def write(result: object) -> str:
        for _ in range(3):
            signal.raise_signal(signal.SIGINT)
        return "never"

    cell.write("a.mnt", MOVE)
    monkeypatch.setattr("motionlang.cli.run_command.pieces", write)
    ran = cell("run", "a.mnt", "--format", "json")
    assert (ran.status, "never" in ran.out) == (130, False)


def test_what_is_switched_off_stays_off(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    """A signal that the parent process ignores stays ignored, as with nohup."""
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    cell.write("a.mnt", MOVE)
    monkeypatch.setattr(Scheduler, "run", sending(signal.SIGHUP, Scheduler.run))
    assert cell("run", "a.mnt", "--format", "none").status == 0


def test_handlers_are_put_back(cell: Cell) -> None:
    before = [signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)]
    hook = sys.unraisablehook
    cell("help", "SPEED")
    assert [signal.getsignal(n) for n in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)] == before
    assert sys.unraisablehook is hook


class Falls:
    """Python prints and drops an exception that is raised in a `__del__`."""

    def __del__(self) -> None:
        raise Terminated(signal.SIGTERM)


def dropped(waits: float) -> None:
    """Run a command in which Python drops a signal, then wait for another one."""
    with signals.SIGNALS:
        signals.SIGNALS._raised = signal.SIGTERM
        Falls()
        signal.sigtimedwait([], waits)


def test_a_signal_that_python_drops_comes_again() -> None:
    """Our hook for such exceptions raises the signal again."""
    with pytest.raises(Terminated):
        dropped(5.0)


def test_a_signal_that_python_drops_at_the_end_ends_the_command(monkeypatch: pytest.MonkeyPatch) -> None:
    """Otherwise it would come again after the end, when nothing handles it."""
    monkeypatch.setattr(signals, "AGAIN", 60.0)
    with pytest.raises(Terminated):
        dropped(0.0)
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)


@pytest.mark.parametrize(("number", "who", "status"), SIGNALS)
def test_a_process_that_is_terminated(number: int, who: str, status: int, tmp_path: Path) -> None:
    program = tmp_path / "endless.mnt"
    program.write_text(MOVE + ENDLESS)
    command = [*COMMAND, "run", str(program), "--realtime", "1000"]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "10.0000\n"
        process.send_signal(number)
        out, err = process.communicate(timeout=MAX_SECONDS)
    assert (process.returncode, " · interrupted at " in out) == (status, True)
    assert err.startswith(f"error[interrupted]: the run was ended {who}\n")
    assert "Traceback" not in err


@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_a_report_is_whole_that_is_being_written_as_a_signal_comes(unbuffered: str, tmp_path: Path) -> None:
    """The reader is slow, so that the signal arrives in the middle of a write."""
    fcntl, termios = pytest.importorskip("fcntl"), pytest.importorskip("termios")
    program = tmp_path / "many.mnt"
    text = "Dim i As Integer\nFor i = 1 To 500\n  MOVER(0) = 1 : GO(0)\n  PAUSE IDLE(0)\nNext\n"
    program.write_text(text)
    command = [*COMMAND, "run", str(program), "--format", "json"]
    given = os.environ | {"PYTHONUNBUFFERED": unbuffered}
    with subprocess.Popen(command, stdout=subprocess.PIPE, env=given, bufsize=0) as process:
        assert process.stdout is not None
        written, before = bytes(4), b""
        while not (written == before and int.from_bytes(written, sys.byteorder) > 30_000):  # it is full
            before, written = written, fcntl.ioctl(process.stdout, termios.FIONREAD, bytes(4))
        process.send_signal(signal.SIGTERM)
        output = process.stdout.read()
        while more := process.stdout.read():
            output += more
    assert process.returncode == 143
    report = json.loads(output)
    assert (report["status"], len(report["moves"])) == ("ended", 500)


def test_a_signal_while_the_command_line_is_read(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    """Options that need argparse do not prevent the report."""
    from motionlang.cli import commands

    cell.write("a.mnt", MOVE)
    monkeypatch.setattr(commands, "build_parser", sending(signal.SIGTERM, commands.build_parser))
    ran = cell("trace", "a.mnt", "a.csv", "--format", "json")
    assert (ran.status, json.loads(ran.out)["status"]) == (143, "interrupted")
    assert not (cell.folder / "a.csv").exists()


@pytest.fixture
def crashes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "crashes"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return folder


def broken(*given: object, **named: object) -> object:
    raise AssertionError("it cannot be")


def test_a_crash_keeps_what_was_computed_and_what_led_to_it(
    cell: Cell, crashes: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Scheduler, "settle", broken)
    cell.write("a.mnt", MOVE)
    cell.write("a.machine.toml", "[controller]\naxes = 2\n")
    ran = cell("run", "a.mnt", "--format", "json")
    report = json.loads(ran.out)
    assert (ran.status, report["status"], report["output"], len(report["moves"])) == (
        70,
        "fault",
        ["10.0000"],
        1,
    )
    (folder,) = crashes.iterdir()
    assert report["diagnostics"][0]["code"] == "crash"
    assert report["diagnostics"][0]["hint"].endswith(f"are in {folder}")
    assert (folder / "a.mnt").read_text() == MOVE
    assert (folder / "a.machine.toml").read_text() == "[controller]\naxes = 2\n"
    text = (folder / "crash.txt").read_text()
    assert text.startswith(f"motionlang {__version__}, Python ")
    assert "options: run a.mnt --format json\n" in text
    assert "AssertionError: it cannot be" in text
    assert "Traceback" not in ran.out + ran.err


@pytest.mark.parametrize(
    ("target", "arguments"),
    [
        ("motionlang.cli.option_groups.read", ("run", "a.mnt", "--format", "json")),
        ("motionlang.cli.run_command.pieces", ("run", "a.mnt", "--format", "json")),
        ("motionlang.cli.run_command.render", ("run", "a.mnt")),
        ("motionlang.commands.check.command.in_parallel", ("check", "a.mnt")),
        ("motionlang.commands.trace.export.write_trace", ("trace", "a.mnt", "a.csv", "--format", "text")),
    ],
)
def test_a_crash_anywhere_is_reported_and_stored(
    target: str, arguments: tuple[str, ...], cell: Cell, crashes: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(target, broken)
    cell.write("a.mnt", MOVE)
    ran = cell(*arguments)
    assert ran.status == 70
    assert "error[crash]: internal error: AssertionError: it cannot be" in ran.err
    assert (next(crashes.iterdir()) / "a.mnt").read_text() == MOVE
    if "json" in arguments:
        assert json.loads(ran.out)["diagnostics"][0]["code"] == "crash"


def test_a_crash_that_cannot_be_stored_is_reported(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(cell.folder / "none"))
    monkeypatch.setattr("motionlang.commands.check.command.in_parallel", broken)
    ran = cell("check", "a.mnt")
    assert (ran.status, "the crash report could not be written" in ran.err) == (70, True)


def test_a_run_that_nothing_ends_stops_after_its_processor_time(cell: Cell) -> None:
    """The report has what was computed; --until, run.until and --cpu 0 leave the run to its end."""
    cell.write("a.mnt", ENDLESS)
    ran = cell("run", "a.mnt", "--cpu", "0.05", "--format", "json")
    report = json.loads(ran.out)
    assert (ran.status, report["status"], report["output"]) == (130, "interrupted", ["1"])
    (diagnostic,) = report["diagnostics"]
    assert diagnostic["message"] == "the run was ended after 0.05 s of processor time"
    assert diagnostic["line"] in (3, 4)
    assert "--until S" in diagnostic["hint"]
    assert "--cpu S" in diagnostic["hint"]
    assert cell("run", "a.mnt", "--cpu", "0.001", "--until", "0.5").status == 0
    cell.write("b.mnt", MOVE)
    assert cell("run", "b.mnt", "--cpu", "0").status == 0


def test_a_long_run_says_where_it_is_and_how_to_end_it(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    """In a pipe too, once, and only if no machine time ends the run."""
    monkeypatch.setattr("motionlang.cli.run_progress.PATIENCE", 0.05)
    cell.write("a.mnt", ENDLESS)
    note = r"note: still running: line [34], [0-9.]+ s of machine time; --until S or --cpu S ends it\n"
    found = cell("run", "a.mnt", "--cpu", "0.3", "--format", "none")
    assert re.match(note + r"error\[interrupted\]", found.err)
    assert cell("run", "a.mnt", "--until", "0.5", "--format", "none").err == ""


def test_a_signal_between_two_steps_of_a_lock_is_no_crash(monkeypatch: pytest.MonkeyPatch) -> None:
    def waits(given: list[str]) -> int:
        try:
            raise Terminated(signal.SIGTERM)
        finally:
            raise RuntimeError("release unlocked lock")

    monkeypatch.setattr("motionlang.cli._command", waits)
    assert main(["sweep"]) == 128 + signal.SIGTERM
