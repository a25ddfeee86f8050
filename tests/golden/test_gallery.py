"""Every program of the gallery runs once: it matches its golden files, and its motion and its time are accounted for.

`pytest --update` rewrites the golden files.
"""

from __future__ import annotations

from itertools import pairwise
from math import fsum
from pathlib import Path

import pytest

from motionlang.cli.program_files import programs
from motionlang.commands.diff.golden import differences, golden_files, update
from motionlang.commands.profile.profile import TimeProfile
from motionlang.commands.scenarios import scenario_files
from motionlang.commands.verify.further import further_check, further_files, sweep_golden
from motionlang.kernel import Run
from tests.proof import prove, run

ROOT = Path(__file__).parent.parent.parent
PROGRAMS = [Path(program) for program in programs([str(ROOT / "scripts")])]


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.relative_to(ROOT / "scripts").as_posix())
def test_program(program: Path, request: pytest.FixtureRequest) -> None:
    if request.config.getoption("--update"):
        update(str(program), run(program))
    result = run(program)
    assert differences(str(program), result) == []
    assert prove(result).violations == []
    assert_every_second_is_charged_once(result)


def assert_every_second_is_charged_once(result: Run) -> None:
    """Compare the time profile with the run: no second is missing, and none is in two links or shares."""
    made = TimeProfile(result)
    assert made.seconds == pytest.approx(result.time, abs=1e-9)
    assert all(link.end == after.begin for link, after in pairwise(made.links))
    assert [made.links[0].begin, made.links[-1].end] == [0.0, result.time] if made.links else True
    for shares in (made.lines(), made.kinds(), made.subs()):
        assert fsum(share.seconds for share in shares) == pytest.approx(result.time, abs=1e-9)
    for task in made.tasks:
        parts = [task.computing, task.ready, *task.waiting.values()]
        assert fsum(parts) == pytest.approx(task.life, abs=1e-9)
        assert min(parts) > -1e-9


@pytest.mark.slow
def test_scenarios_and_sweeps_are_as_expected(request: pytest.FixtureRequest) -> None:
    for rewrite in (True, False) if request.config.getoption("--update") else (False,):
        found = [
            further_check(str(program), path, rewrite)
            for program in PROGRAMS
            for path in further_files(str(program))
        ]
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
