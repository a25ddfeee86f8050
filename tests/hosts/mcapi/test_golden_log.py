"""A log of calls as a golden file of `verify`.

It is the recorded laboratory stage of yaqd-pmc.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from motionlang.cli import main

LOG = Path(__file__).parents[3] / "scripts" / "hosts" / "stage.mcapi-log"


def test_the_committed_log_replays(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", str(LOG.parent)]) == 0
    assert capsys.readouterr().out == "1 of 1 logs match their golden files\n"


def test_a_log_next_to_a_program_is_counted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shutil.copy(LOG, tmp_path)
    (tmp_path / "a.mcl").write_text("1MN,1MR100,1WS,1TP\n", encoding="utf-8")
    assert main(["verify", str(tmp_path), "--update"]) == 0
    assert main(["verify", str(tmp_path)]) == 0
    last = capsys.readouterr().out.splitlines()[-1]
    assert last == "1 of 1 programs, 1 of 1 logs match their golden files"


def test_an_altered_log_fails_at_its_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    lines = LOG.read_text(encoding="latin-1").splitlines()
    number = next(k for k, line in enumerate(lines) if "MCSetVelocity" in line)
    lines[number] = lines[number].replace(" = 0", " = 15")
    log = tmp_path / "stage.mcapi-log"
    log.write_text("\n".join(lines) + "\n", encoding="latin-1")
    assert main(["verify", str(log)]) == 1
    assert capsys.readouterr().out.splitlines() == [
        f"{log}: differs",
        f"  stage.mcapi-log:{number + 1}: MCSetVelocity 1 1 11000.0: the result is 15, here 0",
        f"  {len(lines) - 1} calls, 1 difference: 1 of code",
        "0 of 1 logs match their golden files",
    ]
    assert main(["verify", str(log), "--format", "json"]) == 1
    (row,) = json.loads(capsys.readouterr().out)["verdicts"]
    assert (row["kind"], row["file"], row["matches_golden"]) == ("log", str(log), False)


def test_the_machine_file_next_to_it_is_used(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The log runs with one axis; a machine file with no axis is an error."""
    shutil.copy(LOG, tmp_path)
    machine = tmp_path / "stage.machine.toml"
    machine.write_text("[controller]\naxes = 1\n", encoding="utf-8")
    assert main(["verify", str(tmp_path)]) == 0
    machine.write_text("[controller]\naxes = 0\n", encoding="utf-8")
    capsys.readouterr()
    assert main(["verify", str(tmp_path)]) == 1
    assert "stage.machine.toml:2:1" in capsys.readouterr().err


def test_a_log_that_is_cut(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = tmp_path / "cut.mcapi-log"
    log.write_text(LOG.read_text(encoding="latin-1")[:-20], encoding="latin-1")
    assert main(["verify", str(log)]) == 1
    number = len(LOG.read_text(encoding="latin-1").splitlines())
    assert f"line {number}: the log is cut in the middle of this line" in capsys.readouterr().out
