"""The pytest plugin that runs a copy of the project in which every mutant is woven: collects once, then forks for each.

What it is to do stands in `TASKS`, a JSON file; it writes a line of JSON for each mutant into the pipe `TOLD`. First
all tests run once, in a child, and note which places and files each of them comes by and how long it takes; a test that
fails then knows the text of the project and says nothing about mutants. Then each mutant gets a child that runs the
tests which come by its place, the quickest first, up to the first that fails and passes without the mutant. A child
that takes ten times the time of a test, or all memory, is a difference, too. A place that is passed as modules are
imported is left to a process of its own, which runs the tests of `ALONE`.
"""

from __future__ import annotations

import builtins
import json
import os
import resource
import signal
import time
from collections.abc import Callable
from pathlib import Path
from select import select
from typing import Any

import pytest

TASKS, TOLD, TESTS, ALONE = "mutants.json", "told.fifo", "tests.json", "alone.json"
# The names of the tests that are run, where not all of their files are.
CHOSEN = "chosen.json"
# Where a process of its own says which test it has come to, and in the end which one fails.
FAILED = "failed.txt"
# The environment variable with the number of the mutant that is made, here and in processes of tests.
ACTIVE = "MOTIONLANG_MUTANT"
# Seconds of the processor that a test gets beside ten times what it took, and bytes for a child.
BESIDES, MEMORY = 10.0, 6_000_000_000
# Seconds by the clock after which a test that waits for something is given up.
LONGEST = 600.0
# What is told of each test that begins.
BEGUN = "."
KILLED, LIVED = 1, 0
# The number of no mutant, which is made to see that a test passes without one.
NONE = 1 << 30
# A place that so few tests come by may be one whose result is kept: all tests that come by its file are run then.
FEW = 5


def sow(active: int, places: set[int], files: set[str]) -> None:
    """What the woven code asks: whether a mutant is the active one; with none active it notes where it has been."""
    making = active >= 0
    builtins.__mutant__ = active.__eq__ if making else places.add  # type: ignore[attr-defined]
    builtins.__seen__ = (lambda file: None) if making else files.add  # type: ignore[attr-defined]


_active, _places, _files = int(os.environ.get(ACTIVE, "-1")), set[int](), set[str]()
sow(_active, _places, _files)  # before anything woven is imported


class Forks:
    """The runs of one session."""

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
            self.durations = json.loads(Path(ALONE).read_text())
            self._run([items[name] for name in self.durations if name in items], Path(FAILED).write_text)
        if not Path(TESTS).exists():
            self._cover(session)
        known = json.loads(Path(TESTS).read_text())
        tests = {name: {**each, "places": set(each["places"])} for name, each in known["tests"].items()}
        self.durations = {
            name: tests[name]["cpu"] for name in sorted(tests, key=lambda name: tests[name]["cpu"])
        }
        with open(TOLD, "w", encoding="utf-8") as told:
            for mutant in json.loads(Path(TASKS).read_text()):
                print(json.dumps(self._verdict(mutant, known, tests, items)), file=told, flush=True)
        return True

    def _verdict(
        self,
        mutant: dict[str, Any],
        known: dict[str, Any],
        tests: dict[str, dict[str, Any]],
        items: dict[str, pytest.Item],
    ) -> dict[str, Any]:
        """What is found of one mutant, or the tests for a process of its own."""
        number, file = mutant["number"], mutant["file"]
        near = [name for name in self.durations if file in tests[name]["files"]]
        if mutant["imported"] or number in known["imported"]:
            return {"number": number, "alone": {name: self.durations[name] for name in near}}
        names = [name for name in self.durations if number in tests[name]["places"]]
        names = names if len(names) >= FEW else near
        while by := self._fork([items[name] for name in names if name in items], number):
            if by not in self.durations or by in self.sound or not self._fork([items[by]], NONE):
                self.sound.add(by)
                break
            del self.durations[by]  # it fails by itself, as what it asks of has been changed by the weaving
            names.remove(by)
        return {"number": number, "by": by}

    def _cover(self, session: pytest.Session) -> None:
        """Write which places and files each test comes by, of those that pass; in a child, so that nothing stays."""
        child = os.fork()
        if child:
            os.waitpid(child, 0)
            return
        imported, failed = sorted(_places), set[str]()
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
        self.failed = failed.add
        found: dict[str, dict[str, Any]] = {}
        for item, following in zip(session.items, [*session.items[1:], None], strict=True):
            _places.clear()
            _files.clear()
            begun = time.process_time()
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
            taken = time.process_time() - begun
            found[item.nodeid] = {"cpu": taken, "places": sorted(_places), "files": sorted(_files)}
        passed = {name: each for name, each in found.items() if name not in failed}
        text = json.dumps({"imported": imported, "tests": passed, "failed": sorted(failed)})
        Path(TESTS).write_text(text)
        os._exit(0)

    def _fork(self, items: list[pytest.Item], number: int) -> str:
        """The test that fails with a mutant, or what else is different; "" for nothing."""
        reading, writing = os.pipe()
        child = os.fork()
        if child == 0:
            os.close(reading)
            os.environ[ACTIVE] = str(number)
            sow(number, _places, _files)
            resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
            self._run(items, lambda told: os.write(writing, told.encode()[:2000]))
        os.close(writing)
        told = b""
        with os.fdopen(reading, "rb", buffering=0) as pipe:
            while select([pipe], [], [], LONGEST)[0]:
                more = pipe.read(4096)
                if not more:
                    break
                told += more
            else:
                os.kill(child, signal.SIGKILL)
        status = os.waitpid(child, 0)[1]
        return told.decode().strip(BEGUN) or ("time or memory" if status else "")

    def _run(self, items: list[pytest.Item], tell: Callable[[str], object]) -> None:
        """Run tests up to the first that fails, and end the process; tells `BEGUN` for each, and which fails."""
        from tests import cases

        def fail(name: str) -> None:
            tell(name)
            os._exit(KILLED)

        cases.FAILURES = ()  # type: ignore[assignment]  # the first case that fails is enough
        self.failed = fail
        for item in items:
            tell(BEGUN)
            signal.setitimer(signal.ITIMER_PROF, BESIDES + 10.0 * self.durations[item.nodeid])
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=None)
        os._exit(LIVED)


def pytest_configure(config: pytest.Config) -> None:
    """Take the place of the loop over the tests."""
    config.pluginmanager.register(Forks(), "mutants")
