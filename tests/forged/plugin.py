"""A plugin of pytest: `-p tests.forged.plugin --forged NUMBER` runs tests with one forged planner."""

from __future__ import annotations

import re
import subprocess
import sys
from contextlib import ExitStack

import pytest

from tests.forged.changes import ROOT, Change, changes, forged

# The tests of planners: of single plans first, then of what the controller and programs plan with them.
FOLDERS = (
    "tests/kernel/planners/test_fastest.py",
    "tests/kernel/planners",
    "tests/kernel/controller",
    "tests/spec",
)
# Seconds for each of them; an endless forged planner fails.
SECONDS = 120.0


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--forged", type=int, metavar="NUMBER")


def pytest_configure(config: pytest.Config) -> None:
    until_end = ExitStack()
    until_end.enter_context(forged(changes()[config.getoption("--forged")]))
    config.add_cleanup(until_end.close)


def rejected_by(change: Change) -> str:
    """Return the test of planners that fails with a forged planner; "" if none does."""
    number = str(changes().index(change))
    options = ["-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", "-p", "tests.forged.plugin"]
    for tests in FOLDERS:  # one after the other: some plan already as they are collected
        command = [sys.executable, "-m", "pytest", *options, "--forged", number, tests]
        try:
            ran = subprocess.run(
                command, cwd=ROOT, capture_output=True, text=True, timeout=SECONDS, check=False
            )
        except subprocess.TimeoutExpired:
            return f"{tests}: endless"
        found = re.search(r"^(?:FAILED|ERROR) (\S+)", ran.stdout, re.MULTILINE)
        assert (found is None) == (ran.returncode == 0), ran.stdout + ran.stderr
        if found is not None:
            return found[1]
    return ""
