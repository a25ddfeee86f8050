"""Commands on a Python with Lark alone, such as one in a browser."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

import pytest

from tests.built import ROOT

# Those that no run needs. Lark parses.
LIBRARIES = ("numpy", "prompt_toolkit", "rich")
MINT, MCCL = "scripts/mint/pick-and-place.mnt", "scripts/mccl/back-and-forth.mcl"
# Runs the commands of standard input, and prints status and output of each.
COMMANDS = """
import io, json, sys
from motionlang.cli import main

answers, streams = [], (sys.stdout, sys.stderr)
for words in json.load(sys.stdin):
    sys.stdout, sys.stderr = (io.TextIOWrapper(io.BytesIO(), "utf-8", write_through=True) for _ in "oe")
    try:
        status = main(words)
    except SystemExit as end:
        status = end.code
    answers.append((status, "".join(each.buffer.getvalue().decode() for each in (sys.stdout, sys.stderr))))
sys.stdout, sys.stderr = streams
json.dump(answers, sys.stdout)
"""
WITHOUT = f"""
import sys

class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {LIBRARIES!r}:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name.partition(".")[0])

sys.meta_path.insert(0, Absent())
"""
SAME = (
    f"run {MINT}",
    f"run {MCCL} --format json",
    f"profile {MINT}",
    f"certify {MINT}",
    f"check {MINT}",
    "help SPEED",
    "plan --distance 20 --time 0.6 --rule third",
    "serve",
)
# Commands that need numpy, and what the message calls the user of it.
NEEDING = (
    (f"plot {MINT} x.png", "motionlang plot"),
    (f"trace {MINT} x.csv", "motionlang trace"),
    (f"diff {MINT} {MINT}", "motionlang diff"),
    ("run scripts/mint/motor-tuned.mnt", "this run"),
    ("plot scripts/mint/motor-tuned.mnt x.html", "this run"),
)


def answers(lines: Iterable[str], libraries: bool = False) -> list[tuple[int, str]]:
    """Run commands in one process, with or without the libraries; return status and output of each."""
    script = COMMANDS if libraries else WITHOUT + COMMANDS
    ran = subprocess.run(
        [sys.executable, "-c", script],
        cwd=ROOT,
        capture_output=True,
        text=True,
        input=json.dumps([line.split() for line in lines]),
        check=False,
    )
    assert ran.stderr == ""
    return [(status, text) for status, text in json.loads(ran.stdout)]


@pytest.fixture(scope="module")
def without() -> dict[str, tuple[int, str]]:
    """Return the answers of all commands without the libraries."""
    lines = [*SAME, *(line for line, _ in NEEDING)]
    return dict(zip(lines, answers(lines), strict=True))


@pytest.fixture(scope="module")
def with_libraries() -> dict[str, tuple[int, str]]:
    return dict(zip(SAME, answers(SAME, libraries=True), strict=True))


@pytest.mark.parametrize("line", SAME)
def test_a_command_prints_the_same_without_libraries(
    line: str, without: dict[str, tuple[int, str]], with_libraries: dict[str, tuple[int, str]]
) -> None:
    assert without[line] == with_libraries[line]


@pytest.mark.parametrize(("line", "user"), NEEDING)
def test_a_command_that_needs_numpy_says_so(
    line: str, user: str, without: dict[str, tuple[int, str]]
) -> None:
    message = f"error[extra]: {user} needs numpy\n  hint: python -m pip install numpy\n"
    assert without[line] == (69, message)


def test_the_scope_page_is_the_same_without_libraries(tmp_path: Path) -> None:
    for name, libraries in (("with", True), ("without", False)):
        lines = [f"plot {program} {tmp_path / name}-{k}.html" for k, program in enumerate((MINT, MCCL))]
        assert [status for status, _ in answers(lines, libraries)] == [0, 0]
    for k in range(2):
        pages = [tmp_path / f"{name}-{k}.html" for name in ("with", "without")]
        assert pages[0].read_bytes() == pages[1].read_bytes()
