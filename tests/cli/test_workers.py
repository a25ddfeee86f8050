"""Commands with worker processes: no worker survives its command."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.programs import MAX_SECONDS

JOBS = 2
# The command line, in which each new process reports on standard error. Workers inherit that, so its end is
# theirs.
ANNOUNCED = """
import os, sys
from motionlang.cli import main
os.register_at_fork(after_in_child=lambda: os.write(2, b"worker\\n"))
sys.exit(main(sys.argv[1:]))
"""
# Here SIGTERM comes as soon as the first process is started.
AT_ONCE = ANNOUNCED.replace(
    "sys.exit(main",
    "os.register_at_fork(after_in_parent=lambda: os.kill(os.getpid(), 15))\nsys.exit(main",
)
COMMANDS = {
    "sweep": ("sweep", "stroke.mnt", "--vary", "rate=1:1000:1000000"),
    "check": ("check", "a.mnt", "b.mnt"),
    "verify": ("verify", "a.mnt", "b.mnt"),
}
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="pools fork on Linux only")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with a program, and two pipes at which a worker blocks."""
    (tmp_path / "stroke.mnt").write_text(
        "Const rate = 1000\nACCEL(0) = rate\nMOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\n"
    )
    for name in ("a", "b"):
        os.mkfifo(tmp_path / f"{name}.mnt")
        (tmp_path / f"{name}.golden.json").write_text("{}")
    return tmp_path


def started(script: str, verb: str, folder: Path) -> subprocess.Popen[str]:
    """Start a command with `JOBS` worker processes in a separate process group."""
    command = [sys.executable, "-c", script, *COMMANDS[verb], "--jobs", str(JOBS)]
    return subprocess.Popen(
        command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, process_group=0
    )


def output_until_all_have_ended(process: subprocess.Popen[str]) -> str:
    """Return standard error, read until the command and all workers have closed it."""
    try:
        return process.communicate(timeout=MAX_SECONDS)[1]
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass


# Each signal for one command, and each command with one signal: their workers are of the same kind.
@pytest.mark.parametrize(
    ("number", "verb"),
    [
        (signal.SIGKILL, "sweep"),
        (signal.SIGTERM, "sweep"),
        (signal.SIGHUP, "sweep"),
        (signal.SIGINT, "sweep"),
        (signal.SIGKILL, "check"),
        (signal.SIGINT, "verify"),
    ],
)
def test_no_worker_outlives_a_command_that_is_ended(number: int, verb: str, folder: Path) -> None:
    process = started(ANNOUNCED, verb, folder)
    assert process.stderr is not None
    assert [process.stderr.readline() for _ in range(JOBS)] == ["worker\n"] * JOBS
    if number == signal.SIGINT:  # a terminal sends it to the complete group
        os.killpg(process.pid, number)
    else:
        process.send_signal(number)
    output = output_until_all_have_ended(process)
    assert process.returncode in (-number, 128 + number)
    assert "Traceback" not in output


@pytest.mark.parametrize("verb", COMMANDS)
def test_a_signal_while_the_workers_are_started(verb: str, folder: Path) -> None:
    process = started(AT_ONCE, verb, folder)
    output = output_until_all_have_ended(process)
    assert (process.returncode, output.count("worker\n")) == (143, JOBS)
    assert "Traceback" not in output


def test_a_reader_that_goes_away_ends_the_workers_without_a_word(tmp_path: Path) -> None:
    """The rest of the files is still with the workers when a line no longer finds its reader."""
    for number in range(40):
        (tmp_path / f"p{number}.mnt").write_text("MOVER(0) = 100 : GO(0)\nPAUSE IDLE(0)\n" * 50)
    command = [sys.executable, "-m", "motionlang", "check", str(tmp_path), "--literals", "--jobs", str(JOBS)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        process.stdout.readline()
        process.stdout.close()
        output = output_until_all_have_ended(process)
    assert (process.returncode, output) == (141, "")
