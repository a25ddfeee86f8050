"""Stepping back by copies of the process shows the same as running again."""

from __future__ import annotations

import os
import select
import signal
import sys
from pathlib import Path
from random import Random
from typing import Any

import pytest

from tests.dap.client import PATIENCE, Client
from tests.dap.remote import Remote
from tests.debug.test_debugger import CALLS

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="copies are made on Linux alone")

# Two tasks that count next to each other, subs and output.
POLLS = """\
Dim n As Integer, m As Integer
Run Count
Repeat
  n = n + 1
  If n Mod 500 = 0 Then
    Print "n ", n
    Add(n)
  End If
Until m > 3000
Print "end ", n, " ", m
End
Sub Add(ByVal k As Integer)
  Dim twice As Integer
  twice = 2 * k
  m = m + twice - twice
End Sub
Task Count
  Loop
    m = m + 1
  End Loop
End Task
"""
# A motor in a loop of moves.
MOTOR = """\
Dim n As Integer, measured As Float
SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500
For n = 1 To 40
  MOVER(0) = 5 : GO(0)
  PAUSE IDLE(0)
  measured = ENCODER(0)
Next
Print n, measured
"""
PLANT = '[axis.0.plant]\nkind = "dc"\n'
COMMANDS = [
    "stepBack",
    "stepBack",
    "stepBack",
    "next",
    "stepIn",
    "reverseContinue",
    "time",
    "continue",
    "set",
]


def write(folder: Path, text: str) -> Path:
    path = folder / "program.mnt"
    path.write_text(text)
    if text is MOTOR:
        (folder / "program.machine.toml").write_text(PLANT)
    return path


def walk(client: Client, program: Path, seed: int, steps: int) -> list[Any]:
    """Return the stops, the states and the output of a random session."""
    draw, seen = Random(seed), []
    client.launch(program, stopAtEnd=True)
    lines = [{"line": draw.randrange(1, 18)} for _ in range(draw.randrange(3))]
    client.ask("setBreakpoints", source={"path": str(program)}, breakpoints=lines)
    stop = client.begin()
    for _ in range(steps):
        at_end = "ended" in stop["body"].get("text", "")
        command = draw.choice(COMMANDS)
        if command == "time":
            stop = client.go("goToTime", time=draw.random() * (5.0 if program.read_text() == MOTOR else 0.06))
        elif command == "set":
            if not at_end:
                client.ask("setExpression", expression="n", value="7")
        elif not at_end or command in ("stepBack", "reverseContinue"):
            stop = client.go(command)
        texts = [each["body"]["output"] for each in client.events if each["event"] == "output"]
        seen.append((command, stop["body"], client.frames(stop), client.scopes(stop), texts))
    return seen


@pytest.mark.parametrize("text", [POLLS, MOTOR], ids=["polls", "motor"])
@pytest.mark.parametrize("seed", range(2))
def test_copies_change_nothing(text: str, seed: int, tmp_path: Path) -> None:
    """Each run makes its copies at other statements; clients see no difference."""
    program = write(tmp_path, text)
    found = []
    for client in (Client(), Remote()):
        found.append(walk(client, program, seed, 12))
        client.close()
    assert found[0] == found[1]


# ------------------------------------------------------------------------------------------------------- processes


def children(process: int) -> set[int]:
    """Return all descendants of a process."""
    tasks = Path(f"/proc/{process}/task")
    try:
        found = {int(child) for task in tasks.iterdir() for child in (task / "children").read_text().split()}
    except OSError:
        return set()
    return found.union(*map(children, found))


def copied(client: Remote, tmp_path: Path) -> tuple[int, set[int]]:
    """Start an endless program; return its engine, and at least one copy of it."""
    client.launch(write(tmp_path, "Dim n As Integer\nLoop\n  n = n + 1\n  If n > 99 Then n = 0\nEnd Loop\n"))
    client.ask("configurationDone")
    (engine,) = (
        int(each)
        for each in Path(f"/proc/{client.process.pid}/task/{client.process.pid}/children").read_text().split()
    )
    found: set[int] = set()
    while not found:
        found = children(engine)
    return engine, found


def ends(process: int) -> bool:
    """Wait for the end of a process; return False if it still runs after `PATIENCE`."""
    try:
        handle = os.pidfd_open(process)
    except ProcessLookupError:
        return True
    ended = bool(select.select([handle], [], [], PATIENCE)[0])
    os.close(handle)
    return ended


def test_no_process_is_left_when_the_front_is_killed(tmp_path: Path) -> None:
    client = Remote()
    engine, copies = copied(client, tmp_path)
    client.process.send_signal(signal.SIGKILL)
    assert client.finish() == (-signal.SIGKILL, b"")
    assert all(ends(each) for each in (engine, *copies))


def test_no_process_is_left_when_the_engine_is_killed(tmp_path: Path) -> None:
    client = Remote()
    engine, copies = copied(client, tmp_path)
    os.kill(engine, signal.SIGKILL)
    client.wait("terminated")
    assert all(ends(each) for each in copies)
    error = client.request("threads")["body"]["error"]
    assert error == {"id": 1, "format": "the debugger has ended unexpectedly", "showUser": True}
    assert client.finish() == (0, b"")


def test_a_client_that_leaves_ends_all_copies(tmp_path: Path) -> None:
    client = Remote()
    engine, copies = copied(client, tmp_path)
    client.close()
    assert all(ends(each) for each in (engine, *copies))


# ------------------------------------------------------------------------------------------------ without copies


def test_a_slow_replay_reports_its_progress_and_is_cancelled(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A step back from the end runs the program again; if cancelled, it stops earlier."""
    monkeypatch.setattr("motionlang.debug.checkpoints.INTERVAL", 0.001)
    monkeypatch.setattr("motionlang.debug.checkpoints.SLOW", 1)
    client = Client()
    client.ask("initialize", adapterID="x", supportsProgressReporting=True)
    client.ask("launch", program=str(write(tmp_path, POLLS.replace("3000", "60000"))), stopAtEnd=True)
    client.begin()
    client.ask("stepBack")
    begun = client.wait("progressStart", "stopped")
    assert begun["event"] == "progressStart"
    assert begun["body"]["cancellable"]
    client.ask("cancel", progressId=begun["body"]["progressId"])
    stop = client.wait("stopped")
    assert stop["body"]["reason"] == "pause"
    assert float(client.ask("evaluate", expression="m")["result"]) < 60000
    client.close()


def test_a_search_that_is_cancelled_leaves_the_program_where_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("motionlang.debug.checkpoints.INTERVAL", 0.001)
    monkeypatch.setattr("motionlang.debug.checkpoints.SLOW", 1)
    client = Client()
    client.ask("initialize", adapterID="x", supportsProgressReporting=True)
    program = write(tmp_path, POLLS.replace("3000", "60000"))
    client.ask("launch", program=str(program))
    client.ask("setBreakpoints", source={"path": str(program)}, breakpoints=[{"line": 10}])
    before = client.begin()
    client.ask("lastChange", name="n")
    client.wait("progressStart")
    client.ask("cancel")
    stop = client.wait("stopped")
    assert stop["body"]["text"] == "cancelled"
    assert client.frames(stop) == client.frames(before)
    client.close()


def test_programs_that_are_fast_make_no_copies(tmp_path: Path) -> None:
    """The first copy is made 0.3 s after the start of a run."""
    from tests.dap.test_processes import requests, send, start, until

    with start() as front:
        assert front.stdin is not None
        assert front.stdout is not None
        send(front.stdin, requests(write(tmp_path, CALLS)))
        until(front.stdout, "terminated")
        assert len(children(front.pid)) == 1
        front.communicate(timeout=PATIENCE)
