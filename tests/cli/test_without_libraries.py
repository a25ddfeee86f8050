"""Commands on a Python with Lark alone, such as one in a browser."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.built import ROOT

# Those that no run needs. Lark parses.
LIBRARIES = ("numpy", "prompt_toolkit", "rich")
MINT, MCCL = "scripts/mint/pick-and-place.mnt", "scripts/mccl/back-and-forth.mcl"
WITHOUT = f"""
import sys

class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {LIBRARIES!r}:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name.partition(".")[0])

sys.meta_path.insert(0, Absent())
from motionlang.cli import main
sys.exit(main())
"""


def command(*arguments: str, libraries: bool = False) -> tuple[int, str]:
    """Run a command with or without the libraries; return its status and output."""
    how = ["-m", "motionlang"] if libraries else ["-c", WITHOUT]
    ran = subprocess.run(
        [sys.executable, *how, *arguments], cwd=ROOT, capture_output=True, text=True, check=False
    )
    return ran.returncode, ran.stdout + ran.stderr


@pytest.mark.parametrize(
    "line",
    [
        f"run {MINT} --no-cache",
        f"run {MCCL} --no-cache --report json",
        f"run {MINT} --no-cache --profile",
        f"check {MINT}",
        "keywords SPEED",
        "plan --distance 20 --time 0.6 --rule third",
    ],
)
def test_a_command_prints_the_same_without_libraries(line: str) -> None:
    assert command(*line.split()) == command(*line.split(), libraries=True)


@pytest.mark.parametrize("program", [MINT, MCCL])
def test_the_scope_page_is_the_same_without_libraries(program: str, tmp_path: Path) -> None:
    pages = [tmp_path / "with.html", tmp_path / "without.html"]
    for page, libraries in zip(pages, (True, False), strict=True):
        status, _ = command("run", program, "--plot", str(page), libraries=libraries)
        assert status == 0
    assert pages[0].read_bytes() == pages[1].read_bytes()


@pytest.mark.parametrize(
    ("line", "user"),
    [
        (f"run {MINT} --plot x.png", "--plot"),
        (f"run {MINT} --trace x.csv", "--trace"),
        (f"run {MINT} --certify", "--certify"),
        (f"run {MINT} --prove", "--prove"),
        (f"diff {MINT} {MINT}", "motionlang diff"),
        ("run scripts/mint/motor-tuned.mnt", "this run"),
        ("run scripts/mint/motor-tuned.mnt --plot x.html", "this run"),
    ],
)
def test_a_command_that_needs_numpy_says_so(line: str, user: str) -> None:
    message = f"error[extra]: {user} needs numpy\n  hint: python -m pip install numpy\n"
    assert command(*line.split()) == (69, message)
