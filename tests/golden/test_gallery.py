"""Every program of the gallery does what its golden files say; `pytest --update` writes them anew."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import run
from motionlang.cli.golden import differences, golden_files, programs, update

ROOT = Path(__file__).parent.parent.parent
PROGRAMS = [Path(program) for program in programs([str(ROOT / "scripts")])]


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.relative_to(ROOT / "scripts").as_posix())
def test_program(program: Path, request: pytest.FixtureRequest) -> None:
    if request.config.getoption("--update"):
        update(str(program), run(program, cache=False))
    result = run(program, cache=False, prove=True)
    assert differences(str(program), result) == []
    assert result.proof().violations == []


def test_no_golden_file_is_left_without_its_program() -> None:
    expected = {name for program in PROGRAMS for name in golden_files(str(program))}
    found = {str(path) for path in (ROOT / "scripts").rglob("*.golden.*")}
    assert found <= expected
