"""The benchmarks run, and every figure reaches at least half of its target.

The targets themselves apply to an idle machine.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
# The benchmarks are scripts that import one another from their own folder.
sys.path.append(str(ROOT / "benchmarks"))

from against import BASELINE, Allowed, compare, read_baseline, show  # noqa: E402
from cliff_styles import STYLES  # noqa: E402
from cliffs import started  # noqa: E402


def benchmarks(*names: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "benchmarks", *names]
    return subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT)


@pytest.mark.slow
def test_ratios_within_one_run_come_halfway_to_their_bars() -> None:
    ran = benchmarks("--halfway", "loop", "mccl")
    assert (ran.returncode, ran.stderr) == (0, ""), ran.stdout
    assert "loop_declared" in ran.stdout


def test_every_benchmark_is_listed() -> None:
    ran = benchmarks("none")
    assert ran.returncode == 2
    listed = re.findall(r"\w+", ran.stderr.partition(": ")[2])
    files = {path.stem for path in (ROOT / "benchmarks").glob("*.py")}
    helpers = {"__main__", "against", "counted", "parse_program", "styles", "timing"}
    assert files - helpers - {"cliffs", "cliff_styles"} == set(listed)  # cliffs prints a table of its own


@pytest.mark.slow
def test_every_style_of_the_cliffs_runs_and_has_a_neighbour_that_is_plain() -> None:
    assert len(STYLES) >= 85
    for name, style in STYLES.items():
        assert style.neighbour == "" or STYLES[style.neighbour].neighbour in ("", "rest_pause"), name
        assert started(style).run(0.05) == "until", name


def test_an_unknown_family_of_the_cliffs_is_an_error() -> None:
    command = [sys.executable, "-m", "benchmarks.cliffs", "none"]
    ran = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT)
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr.startswith("there is no family none: rest, watch, tasks, ")


FORGED = """
from motionlang import run
from motionlang.controller.core import Core
from motionlang.planners import plan
from motionlang.source import Source

Core.plan_move = lambda *_: plan("trapezoid", 0.0, 100.0, 500.0, 9000.0, 9000.0)
run(Source("a.mnt", "PROFILEMODE(0) = 1 : SPEED(0) = 5 : MOVER(0) = 100 : GO(0)"), cache=False)
"""


def test_a_run_that_breaks_its_limits_ends_its_benchmark() -> None:
    path = os.pathsep.join(map(str, (ROOT / "benchmarks" / "proved", ROOT)))
    command = [sys.executable, "-c", FORGED]
    environment = os.environ | {"PYTHONPATH": path}
    ran = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    assert ran.returncode == 1
    assert ran.stderr.startswith("line 1: ")


@pytest.mark.long
def test_what_is_measured_is_proved() -> None:
    ran = benchmarks("--prove", "shift", "poll", "loop", "mccl", "cycle", "diff", "sweep", "events", "start")
    assert (ran.returncode, ran.stderr) == (0, ""), ran.stdout
    assert ran.stdout.count("runs are proved") >= 7


def test_ten_per_cent_more_instructions_fail(capsys: pytest.CaptureFixture[str]) -> None:
    before = {"pause.run": (1000, 20000), "jog.run": (1000, 20000)}
    assert show(compare(before, {"pause.run": (1100, 22000), "jog.run": (900, 15000)}, []), "7b66ced")
    assert not show(compare(before, {"pause.run": (1000, 22001), "jog.run": (900, 15000)}, []), "7b66ced")
    assert not show(compare(before, {"pause.run": (1101, 20000), "jog.run": (900, 15000)}, []), "7b66ced")
    assert "more than 10% above 7b66ced: pause.run" in capsys.readouterr().out


def test_an_increase_with_a_reason_is_accepted_up_to_its_ratio(capsys: pytest.CaptureFixture[str]) -> None:
    commit, allowed = read_baseline("# why\ncommit 7b66ced\npause.* 1.25 a wait also notes its axis\n")
    assert (commit, allowed) == ("7b66ced", [Allowed("pause.*", 1.25, "a wait also notes its axis")])
    before = {"pause.run": (1000, 20000)}
    assert show(compare(before, {"pause.run": (1000, 25000)}, allowed), commit)
    assert "a wait also notes its axis" in capsys.readouterr().out
    assert not show(compare(before, {"pause.run": (1000, 25001)}, allowed), commit)


@pytest.mark.parametrize(
    "text", ["", "commit\n", "commit 7b66ced\npause.run 1.2\n", "commit 7b66ced\na x why\n"]
)
def test_a_baseline_that_is_wrong_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"line|commit"):
        read_baseline(text)


def test_the_baseline_of_the_repository_names_a_commit() -> None:
    assert re.fullmatch("[0-9a-f]{7,40}", read_baseline(BASELINE.read_text(encoding="utf-8"))[0])


def test_a_commit_that_does_not_exist_is_an_error() -> None:
    ran = benchmarks("--against", "no-such-commit")
    assert (ran.returncode, ran.stderr) == (2, "there is no commit no-such-commit in this repository\n")


@pytest.mark.slow
def test_a_shallow_clone_skips_with_a_message(tmp_path: Path) -> None:
    clone = tmp_path / "clone"
    subprocess.run(["git", "clone", "-q", "--depth", "1", ROOT.as_uri(), str(clone)], check=True)
    for file in ("__main__.py", "against.py"):
        (clone / "benchmarks" / file).write_bytes((ROOT / "benchmarks" / file).read_bytes())
    (clone / "benchmarks" / "baseline").write_text("commit 0123456\n")
    command = [sys.executable, "-m", "benchmarks", "--against", "baseline"]
    ran = subprocess.run(command, capture_output=True, text=True, check=False, cwd=clone)
    assert (ran.returncode, ran.stdout) == (0, "skipped: this clone does not contain commit 0123456\n")


def test_counts_do_not_depend_on_the_run() -> None:
    one, two = counted("pause"), counted("pause")
    assert one == two
    assert one["pause.run"][1] > one["pause.run"][0] > 0


def counted(style: str) -> dict[str, list[int]]:
    """Return the figures of one style, measured in a process of its own."""
    program = (
        "import json, counted; from styles import STYLES;"
        f" print(json.dumps({{f'{style}.{{k}}': v for k, v in"
        f" counted.stages(STYLES['{style}'], counted.Counter().counting).items()}}))"
    )
    path = os.pathsep.join(map(str, (ROOT, ROOT / "benchmarks")))
    command = [sys.executable, "-c", program]
    ran = subprocess.run(
        command, capture_output=True, text=True, check=True, env=os.environ | {"PYTHONPATH": path}
    )
    found: dict[str, list[int]] = json.loads(ran.stdout)
    return found
