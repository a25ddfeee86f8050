"""Short commands import no library that only other commands need."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = str(Path(__file__).parent.parent.parent / "scripts" / "mint" / "hello.mnt")
# Libraries that take a millisecond or more each, and the packages that questions about runs need.
OTHERS = {
    "email", "hashlib", "http", "motionlang.analysis.diff", "motionlang.analysis.sweeps",
    "motionlang.report", "multiprocessing", "numpy", "socket", "urllib.request", "xml",
}  # fmt: skip


@pytest.mark.parametrize("arguments", [["check", PROGRAM], ["keywords", "SPEED"]])
def test_a_short_command_imports_what_it_needs(arguments: list[str]) -> None:
    command = [sys.executable, "-X", "importtime", "-m", "motionlang", *arguments]
    ran = subprocess.run(command, capture_output=True, text=True, check=True)
    imported = {line.rpartition("|")[2].strip() for line in ran.stderr.splitlines() if line.count("|") == 2}
    assert "motionlang.cli" in imported
    assert imported & OTHERS == set()
