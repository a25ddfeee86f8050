"""The check of one change in seconds: `python -m tests --quick`, after `--record`.

Format, lint and types run for the complete tree. At the same time, those tests run that reach files changed
since the last commit. `--record` finds out which files of the package each test reaches, and how long the
test takes. It does so in a copy of the project whose functions report their calls (`tests/mutants`). The
record is a file that git ignores. It may be days old: a changed test runs in any case, and a changed module
without a record runs the tests of the same name or folder.

A test that reaches few files comes first, because it is specific to them. The tests together take at most
`BUDGET` seconds, and no run is proved. The complete suite runs the rest.
"""

from __future__ import annotations

import ast
import json
import os
import re
import subprocess
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.steps import ROOT, conclude, start_static

RECORD = ROOT / ".pytest_cache" / "reach.json"
# CPU seconds of the chosen tests, as recorded, and for collecting each of their files.
BUDGET, PER_FILE = 4.0, 0.03


class Reach(NamedTuple):
    """CPU time of a test, s, and the files of the package that it reaches."""

    cpu: float
    files: frozenset[str]


def record(jobs: int) -> int:
    """Record which files each test reaches, using `jobs` processes."""
    from tests.mutants.__main__ import coverage

    found = coverage(jobs)
    files = sorted({file for each in found.values() for file in each["files"]})
    numbers = {file: number for number, file in enumerate(files)}
    tests = {
        name: (round(each["cpu"], 3), [numbers[file] for file in each["files"]])
        for name, each in found.items()
    }
    RECORD.parent.mkdir(exist_ok=True)
    RECORD.write_text(json.dumps({"files": files, "tests": tests}), encoding="utf-8")
    print(f"{len(found)} tests recorded in {RECORD.relative_to(ROOT)}")
    return 0


def recorded() -> dict[str, Reach]:
    """Return the record, empty if there is none."""
    if not RECORD.exists():
        return {}
    read = json.loads(RECORD.read_text(encoding="utf-8"))
    files: list[str] = read["files"]
    return {
        name: Reach(cpu, frozenset(files[n] for n in reached))
        for name, (cpu, reached) in read["tests"].items()
    }


def changed(since: str) -> list[str]:
    """Return the Python files that differ from the commit `since`, including new ones."""
    found: set[str] = set()
    for command in (
        ["diff", "--name-only", "--diff-filter=d", since],
        ["ls-files", "-o", "--exclude-standard"],
    ):
        listed = subprocess.run(["git", *command], cwd=ROOT, check=True, capture_output=True, text=True)
        found.update(listed.stdout.split("\n"))
    return sorted(name for name in found if name.endswith(".py"))


def nearest(module: str, test_files: Iterable[str]) -> list[str]:
    """Return the test files for a module without a record: by name, else by folder."""
    path = Path(module)
    names = (f"test_{path.stem.strip('_')}.py", f"test_{path.parent.name}.py")
    folder = Path("tests", *path.parent.parts[1:])
    known = list(test_files)
    named = [each for each in known if Path(each).name in names]
    return named or [each for each in known if Path(each).parent == folder != Path("tests")]


def importers(helper: str, test_files: Iterable[str]) -> list[str]:
    """Return the test files that import a helper module of the tests, a tool, or a module of extras."""
    path = re.sub(r"^extras/\w+/", "", helper)
    module = path.removesuffix(".py").replace("/", ".").removesuffix(".__init__")
    return [each for each in test_files if module in _imported(ROOT / each)]


def _imported(path: Path) -> set[str]:
    nodes = [node for node in ast.walk(ast.parse(path.read_bytes())) if isinstance(node, ast.ImportFrom)]
    return {node.module or "" for node in nodes} | {f"{n.module}.{a.name}" for n in nodes for a in n.names}


def chosen(
    changes: Iterable[str], tests: Mapping[str, Reach], test_files: Iterable[str], budget: float = BUDGET
) -> tuple[list[str], list[str]]:
    """Return the test files to run completely, and the recorded tests to run.

    The recorded tests reach a change, and together take at most `budget` seconds.
    """
    known = list(test_files)
    whole: set[str] = set()
    modules: set[str] = set()
    for name in changes:
        if name in known:
            whole.add(name)
        elif name.startswith(("tests/", "tools/", "extras/")):
            whole.update(importers(name, known))
        elif name.startswith("motionlang/"):
            modules.add(name)
    reached = {module for module in modules if any(module in each.files for each in tests.values())}
    for module in modules - reached:
        whole.update(nearest(module, known))
    near = [name for name, each in tests.items() if each.files & reached and name.partition("::")[0] in known]
    near.sort(key=lambda name: (len(tests[name].files - reached), tests[name].cpu, name))
    return sorted(whole), list(_within(near, tests, whole, budget))


def _within(names: list[str], tests: Mapping[str, Reach], whole: set[str], budget: float) -> Iterator[str]:
    """Yield the first of the named tests that together take at most `budget` seconds."""
    seen = set(whole)
    for name in names:
        file = name.partition("::")[0]
        if file in whole:
            continue
        cost = tests[name].cpu + (0.0 if file in seen else PER_FILE)
        if cost <= budget:
            budget -= cost
            seen.add(file)
            yield name


class Only:
    """A pytest plugin that runs only the chosen tests and the chosen files."""

    def __init__(self, whole: Iterable[str], names: Iterable[str]) -> None:
        self._whole, self._names = frozenset(whole), frozenset(names)

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        items[:] = [
            item
            for item in items
            if item.nodeid in self._names or item.nodeid.partition("::")[0] in self._whole
        ]


def main(since: str) -> int:
    """Run the steps and the tests at the same time; 1 if anything failed."""
    static = start_static()
    tests = recorded()
    known = sorted(
        path.relative_to(ROOT).as_posix()
        for folder in ("tests", "extras")
        for path in (ROOT / folder).rglob("test_*.py")
    )
    changes = changed(since)
    whole, names = chosen(changes, tests, known)
    print(f"== {len(changes)} changed since {since}, {len(whole)} test files, {len(names)} tests", flush=True)
    if not tests:
        print("no record of what tests reach; `python -m tests --record` writes it", flush=True)
    passed = True
    files = sorted({*whole, *(name.partition("::")[0] for name in names)})
    if files:
        os.chdir(ROOT)
        plain = ["-p", "no:xdist", "-p", "no:cacheprovider", *files]
        status = pytest.main(plain, plugins=[Only(whole, names)])
        passed = status in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED)
    return conclude(static, passed)
