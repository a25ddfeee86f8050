"""A separate folder for each test of the command line, with a cache of its own."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.cli import commands
from tests.cli.programs import BALLSCREW, JOG, WRONG, Cell, parser_of


@pytest.fixture
def cell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Cell:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(commands, "build_parser", parser_of)
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / ".cache"))
    for name in ("NO_COLOR", "FORCE_COLOR", "COLUMNS"):
        monkeypatch.delenv(name, raising=False)
    made = Cell(tmp_path, capsys)
    made.write("ballscrew.mcl", BALLSCREW)
    made.write("wrong.mcl", WRONG)
    made.write("jog.mcl", JOG)
    return made
