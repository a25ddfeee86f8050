"""Going back in a slow run: progress, and a pause on the way."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.ide.dap.client import Client

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


def program(folder: Path, text: str) -> Path:
    path = folder / "program.mnt"
    path.write_text(text)
    return path


def test_a_slow_replay_reports_its_progress_and_is_cancelled(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A step back without snapshots runs the program again; if cancelled, it stops earlier."""
    monkeypatch.setattr("motionlang.ide.debug.replay.POLL", 0.001)
    monkeypatch.setattr("motionlang.ide.debug.checkpoints.FIRST", 1 << 60)
    client = Client()
    client.ask("initialize", adapterID="x", supportsProgressReporting=True)
    client.ask("launch", program=str(program(tmp_path, POLLS.replace("3000", "60000"))), stopAtEnd=True)
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


def test_a_search_that_is_cancelled_pauses_the_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("motionlang.ide.debug.replay.POLL", 0.001)
    monkeypatch.setattr("motionlang.ide.debug.checkpoints.FIRST", 1 << 60)
    client = Client()
    client.ask("initialize", adapterID="x", supportsProgressReporting=True)
    path = program(tmp_path, POLLS.replace("3000", "60000"))
    client.ask("launch", program=str(path))
    client.ask("setBreakpoints", source={"path": str(path)}, breakpoints=[{"line": 10}])
    client.begin()
    client.ask("evaluate", expression=".changed n", context="repl")
    client.wait("progressStart")
    client.ask("cancel")
    stop = client.wait("stopped")
    assert stop["body"]["reason"] == "pause"
    assert float(client.ask("evaluate", expression="m")["result"]) < 60000
    client.close()
