"""`python -m tests.mutants [COUNT] [SEED]`: how many of so many mutants are killed, and which live.

`--only TEXT` takes those of them whose names have the text, `--tests PATH` those tests: to see whether a new one kills.
`--after LOG` begins with the tests that killed in an earlier run, of which that is the output; only what these let live
is held against all tests, which is most of the time of a run.
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
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tests.mutants.equivalent import EQUIVALENT
from tests.mutants.forks import ACTIVE, ALONE, BEGUN, CHOSEN, FAILED, NONE, TASKS, TOLD
from tests.mutants.mutate import PACKAGE, ROOT, Mutant, chosen, woven

# All but what starts processes of its own, and what asks about the text of the project.
TESTS = tuple(
    f"tests/{name}"
    for name in (
        "profile", "controller", "metamorphic", "reference_model", "copley", "mint", "mccl", "spec", "golden",
        "errors", "lang", "lint", "cycle", "measured", "readings", "diff", "sweeps", "repl", "serve", "views",
        "fuzz", "test_scenarios.py",
    )
)  # fmt: skip
# Seconds by the clock that a process of its own may take.
LONGEST = 1800.0

WOVEN = """

def _woven() -> None:
    import builtins
    import os

    if not hasattr(builtins, "__mutant__"):
        builtins.__mutant__ = int(os.environ.get({active!r}, "-1")).__eq__
        builtins.__seen__ = lambda file: None


_woven()
"""


def copied(folder: Path, mutants: list[Mutant]) -> Path:
    """A copy of the project with the mutants woven into it, by their numbers."""
    tree = folder / "motionlang"
    left_out = shutil.ignore_patterns(".git", ".venv", "__pycache__", ".*_cache", "*.egg-info")
    shutil.copytree(ROOT, tree, ignore=left_out)
    for path in {mutant.path for mutant in mutants}:
        numbers = {mutant.place: number for number, mutant in enumerate(mutants) if mutant.path == path}
        (tree / path.relative_to(ROOT)).write_text(woven(path, numbers), encoding="utf-8")
    with open(tree / PACKAGE.name / "__init__.py", "a", encoding="utf-8") as package:
        package.write(WOVEN.format(active=ACTIVE))
    return tree


def pytest(tree: Path, tests: list[str], **environment: str) -> subprocess.Popen[bytes]:
    """pytest on the copy, with the plugin; what it tells is nobody's business but that of the plugin."""
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-p",
        "tests.mutants.forks",
        "-p",
        "no:cacheprovider",
        "-p",
        "no:xdist",
    ]
    command += ["-q", "-s", f"--basetemp={tree / 'temporary'}", *tests]
    given = {
        "MOTIONLANG_NO_CACHE": "1",
        "PYTHONDONTWRITEBYTECODE": "1",
        "PYTHONPATH": str(tree),
        **environment,
    }
    with open(tree / "pytest.log", "ab") as log:
        return subprocess.Popen(command, cwd=tree, env=os.environ | given, stdout=log, stderr=log, stdin=log)


def verdicts(tree: Path, mutants: list[Mutant], tests: list[str]) -> Iterator[tuple[Mutant, str]]:
    """Each mutant, and the test that fails with it; "" where none does."""
    (tree / TASKS).write_text(
        json.dumps(
            [
                {
                    "number": number,
                    "file": mutant.path.relative_to(ROOT).as_posix(),
                    "imported": mutant.imported,
                }
                for number, mutant in enumerate(mutants)
            ]
        )
    )
    os.mkfifo(tree / TOLD)
    parent = pytest(tree, tests)
    alone: list[tuple[Mutant, int, dict[str, float]]] = []
    with open(tree / TOLD, encoding="utf-8") as told:
        for line in told:
            each: dict[str, Any] = json.loads(line)
            mutant = mutants[each["number"]]
            if "alone" in each:
                alone.append((mutant, each["number"], each["alone"]))
            else:
                yield mutant, each["by"]
    if parent.wait():
        raise SystemExit(
            f"the tests did not run: {(tree / 'pytest.log').read_text(errors='replace')[-3000:]}"
        )
    for mutant, number, durations in alone:
        while by := failing(tree, number, durations):
            if by not in durations or not failing(tree, NONE, {by: durations[by]}):
                break
            del durations[by]  # it fails in a process of its own without the mutant, too
        yield mutant, by


def failing(tree: Path, number: int, durations: dict[str, float]) -> str:
    """Which of the tests fails in a process of its own with a mutant, or what else is different; "" for nothing."""
    if not durations:
        return ""
    (tree / ALONE).write_text(json.dumps(durations))
    (tree / FAILED).write_text("")
    process = pytest(tree, sorted({name.partition("::")[0] for name in durations}), **{ACTIVE: str(number)})
    try:
        status = process.wait(LONGEST)
    except subprocess.TimeoutExpired:
        process.kill()
        status = process.wait()
    told = (tree / FAILED).read_text().strip(BEGUN)
    return told or (f"the end of its process with {status}" if status else "")


def killers(log: str) -> list[str]:
    """The tests that killed a mutant in an earlier run, as far as their files are still there."""
    found = re.findall(rf"^\d+ killed by (tests/.+?): {PACKAGE.name}/", log, re.MULTILINE)
    return sorted({name for name in found if (ROOT / name.partition("::")[0]).exists()})


def living(mutants: list[Mutant], tests: list[str], chosen: list[str]) -> list[Mutant]:
    """What no test kills, of the chosen ones where any are; prints a line a mutant."""
    lived = []
    with tempfile.TemporaryDirectory() as folder:
        tree = copied(Path(folder), mutants)
        if chosen:
            (tree / CHOSEN).write_text(json.dumps(chosen))
            tests = sorted({name.partition("::")[0] for name in chosen})
        for done, (mutant, by) in enumerate(verdicts(tree, mutants, tests), 1):
            print(f"{done} {f'killed by {by}' if by else 'LIVED'}: {mutant}", flush=True)
            if not by:
                lived.append(mutant)
    return lived


def main(count: int, seed: int, only: list[str], tests: list[str], earlier: str = "") -> int:
    """Print a line a mutant and the share that was killed; 1 where less than 95 % were.

    `earlier` is the output of an earlier run: of what the tests that killed then kill again, no other is asked.
    """
    mutants = [each for each in chosen(count, seed) if not only or any(text in each.name for text in only)]
    known = [each for each in mutants if each.name in EQUIVALENT]
    mutants = [each for each in mutants if each.name not in EQUIVALENT]
    lived = mutants
    if first := killers(earlier):
        lived = living(lived, tests, first)
        print(f"{len(lived)} of {len(mutants)} live through {len(first)} tests", flush=True)
    if lived:
        lived = living(lived, tests, [])
    share = 1.0 - len(lived) / max(len(mutants), 1)
    print(
        f"{len(mutants)} mutants, seed {seed}, and {len(known)} that change nothing: {share:.1%} killed; lived:"
    )
    print(*(mutant.name for mutant in lived), sep="\n", flush=True)
    return 0 if share >= 0.95 else 1


if __name__ == "__main__":
    parser = argparse.ArgumentParser(prog="python -m tests.mutants", description=__doc__)
    parser.add_argument("count", type=int, nargs="?", default=300)
    parser.add_argument("seed", type=int, nargs="?", default=0)
    parser.add_argument("--only", metavar="TEXT", action="append", default=[])
    parser.add_argument("--tests", metavar="PATH", action="append", default=[])
    parser.add_argument("--after", metavar="LOG", type=Path)
    given = parser.parse_args()
    earlier = given.after.read_text(encoding="utf-8") if given.after is not None else ""
    sys.exit(main(given.count, given.seed, given.only, given.tests or list(TESTS), earlier))
