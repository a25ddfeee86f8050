"""`motionlang verify` where a run ends with an internal error."""

from __future__ import annotations

import tempfile
from pathlib import Path

import pytest

from motionlang import run
from motionlang.commands.verify import command as verify
from motionlang.kernel import Run
from tests.cli.programs import Cell


def test_a_program_that_motionlang_stumbles_over_leaves_the_others_their_golden_files(
    cell: Cell, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path_factory.mktemp("bundles")))

    def stumbles(program: str) -> Run:
        assert "ballscrew" not in program, "somebody has thought wrong"
        return run(program)

    monkeypatch.setattr(verify, "run", stumbles)
    (cell.folder / "wrong.mcl").unlink()
    ran = cell("verify", ".", "--update")
    assert ran.status == 1
    assert ran.out == "./jog.mcl: written\n1 of 2 programs have current golden files\n"
    assert "error[crash]: internal error: AssertionError: somebody has thought wrong" in ran.err
    assert not (cell.folder / "ballscrew.golden.json").exists()
    files = sorted(each.name for each in Path(tempfile.gettempdir()).glob("*/*"))
    assert files == ["ballscrew.mcl", "crash.txt"]
