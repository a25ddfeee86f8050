"""The switch for accelerators: without them a run is equal and loads none of them."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from motionlang import execution
from motionlang.controller.accelerators import NO_ACCELERATORS
from motionlang.report import text
from motionlang.source import Source
from tests.built import copy_with_bytecode
from tests.cases import cases

PACKAGE = Path(execution.__file__).parent
GALLERY = PACKAGE.parent / "scripts"
# Loops that count, tasks that poll in parallel, alternating waits, moves from rest to rest.
PROGRAMS = (
    "Dim i As Integer, n As Integer\nFor i = 1 To 500\n  n = n + i\nNext\nPRINT n; TIME\n",
    "Dim n As Integer\nWhile TIME < 700\n  n = n + 1\nWend\nPRINT n\n",
    "Run Clock\nMOVER(0) = 40 : GO(0)\nWhile Not IDLE(0)\nWend\nPRINT POS(0); TIME\nEnd\n"
    "Task Clock\n  Loop\n    If INX(1) Then PRINT TIME\n  End Loop\nEnd Task\n",
    "Run Other\nDim i As Integer\nFor i = 1 To 9\n  MOVER(0) = 7 : GO(0) : PAUSE IDLE(0)\n  WAIT(13)\nNext\nEnd\n"
    "Task Other\n  Loop\n    MOVER(1) = 3 : GO(1) : PAUSE IDLE(1)\n    WAIT(20)\n"
    "    MOVEA(1) = 0 : GO(1) : PAUSE IDLE(1)\n"
    "  End Loop\nEnd Task\n",
)


@cases("program", PROGRAMS)
def test_a_run_without_accelerators_is_the_same(program: str) -> None:
    fast, plain = (
        execution.run(Source("a.mnt", program), cache=False, fast=fast, until=20.0) for fast in (True, False)
    )
    assert plain.machine.accelerators is NO_ACCELERATORS
    assert fast.machine.accelerators.scheduler is not None
    assert text(plain) == text(fast)


def test_the_environment_sets_it_and_an_argument_overrides_that(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(execution.FAST, raising=False)
    assert execution.accelerators().ranges is not None
    monkeypatch.setenv(execution.FAST, "0")
    assert execution.accelerators() is NO_ACCELERATORS
    assert execution.accelerators(True).ranges is not None
    monkeypatch.setenv(execution.FAST, "1")
    assert execution.accelerators(False) is NO_ACCELERATORS


def test_a_compiled_program_is_cached_for_each_setting(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The code of the two settings differs: one contains the ranges of variables."""
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path))
    monkeypatch.delenv("MOTIONLANG_NO_CACHE", raising=False)
    source = Source("a.mnt", PROGRAMS[0])
    found = {(execution.run(source, fast=fast).output[0]) for fast in (True, False, True, False)}
    assert len(found) == 1
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.slow
def test_the_engine_runs_a_third_of_the_gallery_without_the_folder(tmp_path: Path) -> None:
    root = tmp_path / "motionlang"
    copy_with_bytecode(PACKAGE, root, "fast")
    copy_with_bytecode(PACKAGE.parent / "grammars", root / "grammars")
    programs = map(str, sorted(GALLERY.glob("*/*.m[nc]*"))[::3])
    command = [sys.executable, "-m", "motionlang", "verify", *programs, "--jobs", "1"]
    ran = subprocess.run(
        command,
        capture_output=True,
        text=True,
        check=False,
        cwd=tmp_path,
        env=os.environ | {"MOTIONLANG_FAST": "0", "MOTIONLANG_NO_CACHE": "1", "PYTHONPATH": str(tmp_path)},
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr
