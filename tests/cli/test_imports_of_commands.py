"""Short commands import no library that only other commands need."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = str(Path(__file__).parent.parent.parent / "scripts" / "mint" / "hello.mnt")
# Libraries that take a millisecond or more each, and the packages that questions about runs need.
OTHERS = {
    "email", "hashlib", "http", "motionlang.commands.diff", "motionlang.commands.sweep",
    "multiprocessing", "numpy", "pathlib", "socket",
    "urllib.request", "xml",
}  # fmt: skip


# Those of Lark.
PARSING = {"hashlib", "pathlib"}


@pytest.mark.parametrize(("arguments", "needed"), [(["check", PROGRAM], PARSING), (["help", "SPEED"], set())])
def test_a_short_command_imports_what_it_needs(arguments: list[str], needed: set[str]) -> None:
    command = [sys.executable, "-X", "importtime", "-m", "motionlang", *arguments]
    ran = subprocess.run(command, capture_output=True, text=True, check=True)
    imported = [line.rpartition("|")[2].strip() for line in ran.stderr.splitlines() if line.count("|") == 2]
    ours = imported[imported.index("motionlang") :]  # an installation may import for itself before
    assert "motionlang.cli" in ours
    assert {*ours} & OTHERS <= needed
