"""Signals during an exploration: what was found by then is shown as cut off."""

from __future__ import annotations

import signal
import sys
from typing import Any

import pytest

from motionlang.kernel import Scheduler
from tests.cli.programs import Cell
from tests.cli.test_signals import no_signal_is_left_alone  # noqa: F401

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
COMPUTES = (
    "Dim i As Integer, n As Integer\nFor i = 1 To 3000000\n  n = (n * 75 + 74) % 65537\nNext\nPRINT n\n"
)


@pytest.mark.parametrize("command", ["map", "init", "cover", "cover --fail-under 50", "cover --suggest"])
def test_a_signal_ends_what_plays_a_program(
    command: str, cell: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It ends within the run that goes on, and what was found by then is shown as cut off."""
    cell.write("a.mnt", COMPUTES)
    run = Scheduler.run

    def interrupted(scheduler: Scheduler, *given: Any) -> Any:
        monkeypatch.setattr(Scheduler, "run", run)
        signal.raise_signal(signal.SIGTERM)

    monkeypatch.setattr(Scheduler, "run", interrupted)
    verb, *options = command.split()
    ran = cell(verb, "a.mnt", *options)
    assert ran.status == 143
    if verb == "map":
        assert "none so far: no axis moved\n" in ran.out
    if verb == "init":
        assert "# It was cut off" in (cell.folder / "a.machine.toml").read_text()
    if command.startswith("cover") and options[:1] != ["--suggest"]:
        assert ran.err == "note: cut off, so what it reaches is not known: a.mnt\n"
        assert "not reached" not in ran.out
