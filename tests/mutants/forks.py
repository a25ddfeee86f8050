"""Pytest plugin that runs the tests against every mutant of a woven project.

Several worker processes share the work. Each collects all tests once and then goes through three steps:

1. Coverage. The worker runs its share of the test files in a child process and records the mutants and files
   that each test reaches, and its duration. Woven code appends what it reaches to the file `REACHED`; processes
   that a test starts append to the same file, so tests of the command line count as well. A test that fails in
   this step depends on the text of the project and cannot be used.
2. Exchange. The workers read one another's records (`recorded`).
3. Verdicts. A worker claims one mutant after another, forks, and runs the tests that reach the mutant. Fast
   tests that reach few files come first. The child stops at the first test that fails, if it passes without the
   mutant. A child that takes ten times the duration of a test, or too much memory, counts as a failure. The
   verdict is a line of JSON in the pipe `VERDICTS`.

A mutant that is reached while modules are imported cannot be switched on in a fork. It gets a separate process,
which runs the tests of the file `ALONE` (see `__main__`).
"""

from __future__ import annotations

import json
import os
import resource
import signal
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from select import select
from typing import Any

import pytest

from tests.mutants.recorder import ACTIVE, SEEN, activate, record

TASKS, VERDICTS, REACHED = "mutants.json", "verdicts.fifo", "reached"
# The names of the tests to run, if not complete files.
CHOSEN = "chosen.json"
# Environment variables: the number of this worker and of all workers, the files of a process with one mutant, and
# the budget of a mutant.
WORKER, WORKERS = "MOTIONLANG_WORKER", "MOTIONLANG_WORKERS"
ALONE, FAILED = "MOTIONLANG_ALONE", "MOTIONLANG_FAILED"
MUTANT_SECONDS = "MOTIONLANG_MUTANT_SECONDS"
# CPU seconds of a test in addition to ten times its duration, and bytes for a child and for a file it writes.
EXTRA, MEMORY, FILE = 10.0, 6_000_000_000, 1_000_000_000
# Seconds of real time after which a waiting test is ended.
MAX_WAIT = 180.0
# CPU seconds of tests after which a mutant counts as a survivor although tests remain.
BUDGET = 120.0
# Tests that reach nearly all code: they come late, and are never left out.
NET = "tests/generated/test_results.py"
# A child's output for each test that begins.
BEGUN = "."
KILLED, LIVED = 1, 0
# Written in place of a record by a worker whose recording process has died.
DIED = "died"
# No mutant has this number: it shows that a test passes without one.
NONE = 1 << 30
# A mutant that only this many tests reach may be in code whose result is cached: then all tests that reach
# its file run.
MIN_TESTS = 5


def recorded(worker: int) -> Path:
    """Return the file in which a worker records its tests."""
    return Path(f"tests.{worker}.json")


def merged(workers: int, folder: Path = Path()) -> dict[str, Any]:
    """Return the records of all workers: mutants that imports reach, and usable tests."""
    records = [json.loads((folder / recorded(worker)).read_text()) for worker in range(workers)]
    tests = {name: each for worker_record in records for name, each in worker_record["tests"].items()}
    return {
        "imported": {number for worker_record in records for number in worker_record["imported"]},
        "tests": tests,
    }


def reached(path: str) -> tuple[list[int], list[str]]:
    """Return the mutants and the files that a recorder's file lists."""
    lines = Path(path).read_text(encoding="utf-8").split("\n")[:-1]
    return (
        sorted({int(each) for each in lines if each.isdigit()}),
        sorted({each for each in lines if not each.isdigit()}),
    )


_active = int(os.environ.get(ACTIVE, "-1"))
_worker, _workers = int(os.environ.get(WORKER, "0")), int(os.environ.get(WORKERS, "1"))
_path = f"{REACHED}.{_worker}"
# Before anything woven is imported.
_recorder = record(_path) if WORKER in os.environ and _active < 0 else None
if _active >= 0:
    activate(_active)


class Forks:
    """The plugin: one session of tests, run in forks."""

    def __init__(self) -> None:
        self.durations: dict[str, float] = {}
        self.sound: set[str] = set()
        self.failed: Callable[[str], None] = lambda name: None

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_logreport(self, report: pytest.TestReport) -> Any:
        if report.failed:
            self.failed(report.nodeid)
        return (yield)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed and _active >= 0:
            os._exit(KILLED)

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        if Path(CHOSEN).exists():
            names = set(json.loads(Path(CHOSEN).read_text()))
            items[:] = [item for item in items if item.nodeid in names]

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        from hypothesis.internal.conjecture.engine import ConjectureRunner

        for name in ("shrink_interesting_examples", "shrink_interesting_test_cases"):
            if hasattr(ConjectureRunner, name):
                setattr(ConjectureRunner, name, lambda self: None)
        items = {item.nodeid: item for item in session.items}
        if _active >= 0:
            self.durations = json.loads(Path(os.environ[ALONE]).read_text())
            self._run(
                [items[name] for name in self.durations if name in items], Path(os.environ[FAILED]).write_text
            )
        self._cover(session)
        while not all(recorded(worker).exists() for worker in range(_workers)):
            time.sleep(0.2)
        if any(recorded(worker).read_text() == DIED for worker in range(_workers)):
            pytest.exit("the process that records the tests has died", 1)
        known = merged(_workers)
        tests = {name: {**each, "mutants": set(each["mutants"])} for name, each in known["tests"].items()}
        self.durations = {name: tests[name]["cpu"] for name in by_likelihood(tests)}
        with open(VERDICTS, "a", encoding="utf-8") as verdicts:
            for mutant in json.loads(Path(TASKS).read_text()):
                if claimed(mutant["number"]):
                    print(json.dumps(self._verdict(mutant, known, tests, items)), file=verdicts, flush=True)
        return True

    def _verdict(
        self,
        mutant: dict[str, Any],
        known: dict[str, Any],
        tests: dict[str, dict[str, Any]],
        items: dict[str, pytest.Item],
    ) -> dict[str, Any]:
        """Return the verdict on a mutant.

        It has the test that kills the mutant, "" for none, or that the mutant needs a separate process.
        """
        number, file = mutant["number"], mutant["file"]
        if mutant["imported"] or number in known["imported"]:
            return {"number": number, "alone": True}
        near = [name for name in self.durations if file in tests[name]["files"]]
        names = [name for name in self.durations if number in tests[name]["mutants"]]
        names = within_budget(names if len(names) >= MIN_TESTS else near, self.durations)
        while by := self._fork([items[name] for name in names if name in items], number):
            if by not in self.durations or by in self.sound or not self._fork([items[by]], NONE):
                self.sound.add(by)
                break
            del self.durations[
                by
            ]  # it fails without the mutant, because weaving changed a file that it reads
            names.remove(by)
        return {"number": number, "by": by}

    def _cover(self, session: pytest.Session) -> None:
        """Record what this worker's share of tests reaches, in a child process."""
        assert _recorder is not None
        files = sorted({item.path for item in session.items})
        mine = {path for index, path in enumerate(files) if index % _workers == _worker}
        items = [item for item in session.items if item.path in mine]
        imported = reached(_path)[0]
        child = os.fork()
        if child:
            if os.waitpid(child, 0)[1]:
                recorded(_worker).write_text(DIED)  # or the other workers would wait for it
            return
        failed = set[str]()
        # Its resources have no limit: no mutant is active, and half of all tests leave threads and buffers behind.
        # OpenBLAS waits for ever for memory that it does not get.
        os.environ[SEEN] = os.path.abspath(_path)
        self.failed = failed.add
        found: dict[str, dict[str, Any]] = {}
        for item, following in zip(items, [*items[1:], None], strict=True):
            _recorder.clear()
            begun = cpu_time()
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
            taken = cpu_time() - begun
            mutants, seen = reached(_path)
            found[item.nodeid] = {"cpu": taken, "mutants": mutants, "files": seen}
        passed = {name: each for name, each in found.items() if name not in failed}
        written = recorded(_worker).with_suffix(".part")
        written.write_text(json.dumps({"imported": imported, "tests": passed, "failed": sorted(failed)}))
        written.rename(recorded(_worker))
        os._exit(0)

    def _fork(self, items: list[pytest.Item], number: int) -> str:
        """Return the test that fails with a mutant, or another failure; "" if none does."""
        read_end, writing = os.pipe()
        child = os.fork()
        if child == 0:
            os.close(read_end)
            os.environ[ACTIVE] = str(number)
            activate(number)
            limit_resources()
            self._run(items, lambda text: os.write(writing, text.encode()[:2000]))
        os.close(writing)
        written = b""
        with os.fdopen(read_end, "rb", buffering=0) as pipe:
            while select([pipe], [], [], MAX_WAIT)[0]:
                more = pipe.read(4096)
                if not more:
                    break
                written += more
            else:
                os.kill(child, signal.SIGKILL)
        status = os.waitpid(child, 0)[1]
        return written.decode().strip(BEGUN) or ("time or memory" if status else "")

    def _run(self, items: list[pytest.Item], report: Callable[[str], object]) -> None:
        """Run tests up to the first failure, and end the process.

        `report` gets `BEGUN` for each test, and the name of the test that fails.
        """
        from tests import cases

        def fail(name: str) -> None:
            report(name)
            os._exit(KILLED)

        cases.FAILURES = ()  # type: ignore[assignment]  # the first case that fails is enough
        self.failed = fail
        for item in items:
            report(BEGUN)
            signal.setitimer(signal.ITIMER_PROF, EXTRA + 10.0 * self.durations[item.nodeid])
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=None)
        os._exit(LIVED)


def limit_resources() -> None:
    """Limit this process and its children: a mutant may allocate or write endlessly."""
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (FILE, FILE))


def claimed(number: int) -> bool:
    """True for the first worker that claims a mutant."""
    try:
        os.close(os.open(f"claimed.{number}", os.O_CREAT | os.O_EXCL))
    except FileExistsError:
        return False
    return True


def cpu_time() -> float:
    """Return CPU seconds of this process and of the children that have ended."""
    times = os.times()
    return time.process_time() + times.children_user + times.children_system


def by_likelihood(tests: Mapping[str, Mapping[str, Any]]) -> list[str]:
    """Return the names of tests in the order in which they are tried.

    A fast test that reaches few files is about these files, and costs little if it does not fail.
    """
    return sorted(tests, key=lambda name: tests[name]["cpu"] * len(tests[name]["files"]))


def within_budget(names: list[str], durations: dict[str, float]) -> list[str]:
    """Return the first tests whose total is within the budget, and all tests of `NET`."""
    budget = float(os.environ.get(MUTANT_SECONDS, BUDGET))
    total, chosen = 0.0, []
    for name in names:
        if not name.startswith(NET):
            total += durations[name]
        if total <= budget or name.startswith(NET):
            chosen.append(name)
    return chosen


def pytest_configure(config: pytest.Config) -> None:
    """Replace pytest's loop over the tests."""
    config.pluginmanager.register(Forks(), "mutants")
