"""A log of calls that is a golden file: the recorded laboratory stage of yaqd-pmc."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from motionlang.cli import main

LOG = Path(__file__).with_name("stage.mcapi-log")


def test_the_committed_log_replays(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mcapi", "replay", str(LOG)]) == 0
    assert capsys.readouterr().out == "273 calls, 0 differences\n"


def test_an_altered_log_fails_at_its_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    lines = LOG.read_text(encoding="latin-1").splitlines()
    number = next(k for k, line in enumerate(lines) if "MCSetVelocity" in line)
    lines[number] = lines[number].replace(" = 0", " = 15")
    log = tmp_path / "stage.mcapi-log"
    log.write_text("\n".join(lines) + "\n", encoding="latin-1")
    assert main(["mcapi", "replay", str(log)]) == 1
    first, call, summary = capsys.readouterr().out.splitlines()
    assert first.startswith(f"stage.mcapi-log:{number + 1}: at ")
    assert first.endswith(" s: the result is 15, here 0")
    assert call == "  MCSetVelocity 1 1 11000.0"
    assert summary == f"{len(lines) - 1} calls, 1 difference: 1 of code"


def test_the_machine_file_next_to_it_is_used(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The log runs with one axis; a machine file with no axis is an error."""
    shutil.copy(LOG, tmp_path)
    machine, log = tmp_path / "stage.machine.toml", str(tmp_path / LOG.name)
    machine.write_text("[controller]\naxes = 1\n", encoding="utf-8")
    assert main(["mcapi", "replay", log]) == 0
    machine.write_text("[controller]\naxes = 0\n", encoding="utf-8")
    assert main(["mcapi", "replay", log]) == 1
    assert "stage.machine.toml:2:1" in capsys.readouterr().err


def test_a_log_that_is_cut(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = tmp_path / "cut.mcapi-log"
    text = LOG.read_text(encoding="latin-1")
    log.write_text(text[:-20], encoding="latin-1")
    assert main(["mcapi", "replay", str(log)]) == 1
    number = len(text.splitlines())
    assert f"cut.mcapi-log:{number}: the log is cut in the middle of this line" in capsys.readouterr().err
