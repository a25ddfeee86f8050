"""Every program of the gallery matches its golden files.

`pytest --update` rewrites these.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import run
from motionlang.analysis.scenarios import scenario_files
from motionlang.cli.golden import differences, golden_files, update
from motionlang.cli.program_files import programs
from motionlang.cli.verify_further import further_checks, sweep_golden

ROOT = Path(__file__).parent.parent.parent
PROGRAMS = [Path(program) for program in programs([str(ROOT / "scripts")])]


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.relative_to(ROOT / "scripts").as_posix())
def test_program(program: Path, request: pytest.FixtureRequest) -> None:
    if request.config.getoption("--update"):
        update(str(program), run(program, cache=False))
    result = run(program, cache=False, prove=True)
    assert differences(str(program), result) == []
    assert result.proof().violations == []


def test_scenarios_and_sweeps_are_as_expected(request: pytest.FixtureRequest) -> None:
    for rewrite in (True, False) if request.config.getoption("--update") else (False,):
        found = [each for program in PROGRAMS for each in further_checks(str(program), rewrite)]
        assert [each.lines + each.diagnostics for each in found if each.failed] == []
    kinds = [each.kind for each in found]
    assert kinds.count("scenario") >= 4
    assert kinds.count("sweep") >= 1


def test_no_golden_file_is_left_without_its_program() -> None:
    expected = {name for program in PROGRAMS for name in golden_files(str(program))}
    expected |= {
        name for program in PROGRAMS for path in scenario_files(str(program)) for name in golden_files(path)
    }
    expected |= {sweep_golden(str(path)) for path in (ROOT / "scripts").rglob("*.sweep.toml")}
    found = {str(path) for path in (ROOT / "scripts").rglob("*.golden.*")}
    assert found <= expected
