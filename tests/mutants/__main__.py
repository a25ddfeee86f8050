"""Mutation testing: `python -m tests.mutants [COUNT] [SEED ...]`.

It draws mutants and reports which of them the tests kill. Each mutant is one small change of the package:
another comparison, sign, constant or operand. All mutants of a draw are woven into one copy of the project, in
which one at a time is switched on. Coverage is recorded first, so that only the tests that reach a mutant run
against it (`forks.py`).

Several seeds are several draws of COUNT that share one recording of the coverage; each has its own score.

`--only TEXT` selects the mutants whose names contain the text. `--tests PATH` runs only those tests, to see if a
new test kills. `--after LOG` first runs the tests that killed a mutant in an earlier run, whose output is LOG;
all tests then run only against the mutants that survive these. `--budget SECONDS` gives each mutant less or more
CPU time for its tests: a survey of a package with its own tests needs little.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections import Counter
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from tests.mutants.forks import (
    ALONE,
    BEGUN,
    BUDGET,
    CHOSEN,
    FAILED,
    MUTANT_SECONDS,
    NONE,
    TASKS,
    VERDICTS,
    WORKER,
    WORKERS,
    by_likelihood,
    merged,
    within_budget,
)
from tests.mutants.mutate import EXPLORE, PACKAGE, ROOT, Mutant, chosen, files, woven
from tests.mutants.recorder import ACTIVE

# Mutants without a visible effect, by name, each with the reason.
EQUIVALENT: dict[str, str] = tomllib.loads(Path(__file__).with_name("equivalent.toml").read_text("utf-8"))
# Tests that cannot be run on mutants: they test the tests, the wheel, other interpreters, or run for weeks.
NOT_RUN = (
    "mutants",
    "test_benchmarks.py",
    "test_package.py",
    "test_pypy.py",
    "test_weeks.py",
    "test_wheel.py",
)
# Seconds of real time that a process with one mutant may take.
MAX_ALONE = 900.0
# The share of the distinguishable mutants that the tests must kill.
BAR = 0.88

WOVEN = """

from tests.mutants.recorder import install

install()
"""


def default_tests() -> list[str]:
    """Return the tests that can run against mutants, as paths relative to the project."""
    found = [path for path in (ROOT / "tests").iterdir() if path.name not in NOT_RUN]
    found.append(EXPLORE / "test_explore")
    return sorted(
        path.relative_to(ROOT).as_posix()
        for path in found
        if path.name.startswith("test_") or (path.is_dir() and (path / "__init__.py").exists())
    )


def copied(folder: Path, mutants: list[Mutant], recorded: Iterable[Path] = ()) -> Path:
    """Return a copy of the project with the mutants woven in, by their numbers.

    The `recorded` files report each call of their functions.
    """
    tree = folder / "motionlang"
    left_out = shutil.ignore_patterns(
        ".git", ".venv", "__pycache__", ".*_cache", "*.egg-info", "node_modules"
    )
    shutil.copytree(ROOT, tree, ignore=left_out)
    for path in {*recorded, *(mutant.path for mutant in mutants)}:
        numbers = {mutant.ordinal: number for number, mutant in enumerate(mutants) if mutant.path == path}
        (tree / path.relative_to(ROOT)).write_text(woven(path, numbers), encoding="utf-8")
    with open(tree / PACKAGE.name / "__init__.py", "a", encoding="utf-8") as package:
        package.write(WOVEN)
    return tree


def pytest(tree: Path, tests: list[str], prove: bool, **environment: str) -> subprocess.Popen[bytes]:
    """Start pytest on the copy with the plugin; the output goes to a log."""
    command = [sys.executable, "-m", "pytest", "-p", "tests.mutants.forks", "-p", "no:cacheprovider"]
    # Next to the copy, as some tests copy the project.
    temporary = tree.parent / f"temporary.{environment.get(WORKER) or environment.get(ACTIVE)}"
    command += ["-p", "no:xdist", "-q", "-s", f"--basetemp={temporary}", *tests]
    command += ["--prove"] * prove
    paths = os.pathsep.join(map(str, (tree, tree / EXPLORE.relative_to(ROOT))))
    given = {"PYTHONPATH": paths, **environment}
    # The active mutant is known by its number, not by the code: all processes share the bytecode of the copy.
    inherited = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    with open(tree / "pytest.log", "ab") as log:
        return subprocess.Popen(command, cwd=tree, env=inherited | given, stdout=log, stderr=log, stdin=log)


def coverage(jobs: int) -> dict[str, dict[str, Any]]:
    """Return the package files that each test reaches, and its CPU seconds.

    The runs are not proved.
    """
    with tempfile.TemporaryDirectory() as folder:
        tree = copied(Path(folder), [], files())
        for _ in verdicts(tree, [], default_tests(), jobs):
            raise AssertionError
        found: dict[str, dict[str, Any]] = merged(jobs, tree)["tests"]
        return found


def verdicts(tree: Path, mutants: list[Mutant], tests: list[str], jobs: int) -> Iterator[tuple[Mutant, str]]:
    """Yield each mutant with the test that fails with it; "" if no test does."""
    tasks = [
        {"number": number, "file": each.path.relative_to(ROOT).as_posix(), "imported": each.imported}
        for number, each in enumerate(mutants)
    ]
    (tree / TASKS).write_text(json.dumps(tasks))
    os.mkfifo(tree / VERDICTS)
    workers = [
        pytest(tree, tests, bool(mutants), **{WORKER: str(each), WORKERS: str(jobs)}) for each in range(jobs)
    ]
    alone: list[int] = []
    with open(tree / VERDICTS, encoding="utf-8") as lines:
        for line in lines:
            each: dict[str, Any] = json.loads(line)
            if "alone" in each:
                alone.append(each["number"])
            else:
                yield mutants[each["number"]], each["by"]
    statuses = [worker.wait() for worker in workers]
    if any(statuses):
        log = (tree / "pytest.log").read_text(errors="replace")
        raise SystemExit(f"the tests did not run: {log[-3000:]}")
    with ThreadPoolExecutor(jobs) as pool:
        yield from pool.map(lambda number: (mutants[number], verdict_alone(tree, tasks[number], jobs)), alone)


def verdict_alone(tree: Path, task: dict[str, Any], jobs: int) -> str:
    """Return the test that fails with a mutant that imports reach; "" if none does."""
    tests = that_reach(task["file"], merged(jobs, tree)["tests"])
    durations = {name: tests[name]["cpu"] for name in by_likelihood(tests)}
    durations = {name: durations[name] for name in within_budget(list(durations), durations)}
    while by := failing(tree, task["number"], durations):
        if by not in durations or not failing(tree, task["number"], {by: durations[by]}, active=NONE):
            break
        del durations[by]  # it fails in a process of its own without the mutant, too
    return by


def that_reach(file: str, tests: dict[str, dict[str, Any]]) -> dict[str, dict[str, Any]]:
    """Return the tests that call a function of a file; all tests if none does.

    A file may have constants alone, whose use is not recorded.
    """
    return {name: each for name, each in tests.items() if file in each["files"]} or tests


def failing(tree: Path, number: int, durations: dict[str, float], active: int | None = None) -> str:
    """Run tests with a mutant in a separate process, and return the first failure.

    A failure is a test, or how the process ended; "" means that all tests pass.
    """
    if not durations:
        return ""
    alone, failed = tree / f"alone.{number}.json", tree / f"failed.{number}"
    alone.write_text(json.dumps(durations))
    failed.write_text("")
    tests = sorted({name.partition("::")[0] for name in durations})
    files = {ALONE: str(alone), FAILED: str(failed)}
    process = pytest(tree, tests, True, **{ACTIVE: str(number if active is None else active)}, **files)
    try:
        status = process.wait(MAX_ALONE)
    except subprocess.TimeoutExpired:
        process.kill()
        status = process.wait()
    return failed.read_text().strip(BEGUN) or (f"the end of its process with {status}" if status else "")


def killers(log: str) -> list[str]:
    """Return the tests that killed a mutant in an earlier run and still exist."""
    found = re.findall(
        rf"^\d+ killed by ((?:tests|extras)/.+?): (?:{PACKAGE.name}|extras)/", log, re.MULTILINE
    )
    return sorted({name for name in found if (ROOT / name.partition("::")[0]).exists()})


def living(mutants: list[Mutant], tests: list[str], only: list[str], jobs: int) -> list[Mutant]:
    """Return the mutants that survive the tests, or the tests `only`; print each."""
    lived = []
    with tempfile.TemporaryDirectory() as folder:
        tree = copied(Path(folder), mutants)
        if only:
            (tree / CHOSEN).write_text(json.dumps(only))
            tests = sorted({name.partition("::")[0] for name in only})
        for done, (mutant, by) in enumerate(verdicts(tree, mutants, tests, jobs), 1):
            print(f"{done} {f'killed by {by}' if by else 'LIVED'}: {mutant}", flush=True)
            if not by:
                lived.append(mutant)
    return lived


def table(mutants: list[Mutant], lived: list[Mutant]) -> Iterator[str]:
    """Yield a line for each top-level package, with how many mutants were killed."""
    drawn, survived = Counter(each.package for each in mutants), Counter(each.package for each in lived)
    for package in sorted(drawn):
        killed = drawn[package] - survived[package]
        yield f"{package:<12} {killed:>3} of {drawn[package]:>3}  {killed / drawn[package]:.0%}"


def main(
    count: int, seeds: list[int], only: list[str], tests: list[str], earlier: str = "", jobs: int = 2
) -> int:
    """Print a line for each mutant and the score of each draw.

    Return 1 if a score is below `BAR`. `earlier` is the output of an earlier run: the tests that killed a mutant in
    it run first, and all tests run only against the mutants that survive these.
    """
    draws = {
        seed: [each for each in chosen(count, seed) if not only or any(text in each.name for text in only)]
        for seed in seeds
    }
    mutants = list({each.name: each for draw in draws.values() for each in draw}.values())
    mutants = [each for each in mutants if each.name not in EQUIVALENT]
    lived = mutants
    if first := killers(earlier):
        lived = living(lived, tests, first, jobs)
        print(f"{len(lived)} of {len(mutants)} survive {len(first)} tests", flush=True)
    if lived:
        lived = living(lived, tests, [], jobs)
    print(*table(mutants, lived), sep="\n")
    scores = [print_score(seed, draw, lived) for seed, draw in draws.items()]
    print("survivors:", *(f"{mutant}\n    {mutant.name}" for mutant in lived), sep="\n", flush=True)
    return 0 if min(scores) >= BAR else 1


def print_score(seed: int, draw: list[Mutant], lived: list[Mutant]) -> float:
    """Print and return the killed share of a draw's mutants, without equivalent ones."""
    mutants = [each for each in draw if each.name not in EQUIVALENT]
    score = 1.0 - len([each for each in mutants if each in lived]) / max(len(mutants), 1)
    print(f"seed {seed}: {len(mutants)} mutants, {len(draw) - len(mutants)} equivalent, {score:.1%} killed")
    return score


if __name__ == "__main__":
    parser = argparse.ArgumentParser(prog="python -m tests.mutants", description=__doc__)
    parser.add_argument("count", type=int, nargs="?", default=80)
    parser.add_argument("seed", type=int, nargs="*", default=[0])
    parser.add_argument("--only", metavar="TEXT", action="append", default=[])
    parser.add_argument("--tests", metavar="PATH", action="append", default=[])
    parser.add_argument("--after", metavar="LOG", type=Path)
    parser.add_argument("--budget", metavar="SECONDS", type=float, default=BUDGET)
    parser.add_argument("--jobs", metavar="N", type=int, default=os.cpu_count() or 1)
    given = parser.parse_args()
    os.environ[MUTANT_SECONDS] = str(given.budget)  # for the workers
    earlier = given.after.read_text(encoding="utf-8") if given.after is not None else ""
    sys.exit(main(given.count, given.seed, given.only, given.tests or default_tests(), earlier, given.jobs))
