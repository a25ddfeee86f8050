"""The benchmarks run, and every figure reaches at least half of its target.

The targets themselves apply to an idle machine.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
# The benchmarks are scripts that import one another from their own folder.
sys.path.append(str(ROOT / "benchmarks"))

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
    helpers = {"__main__", "parse_program", "timing"}
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
