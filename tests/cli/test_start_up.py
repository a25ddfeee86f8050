"""The short commands import only what they need."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

# A file of keywords that neither command needs.
UNUSED = ("motionlang.kernel.mint.keywords.camboxes",)


@pytest.mark.parametrize("arguments", [["check"], ["help", "HOMESPEED"]])
def test_a_short_command_imports_no_more_than_it_needs(arguments: list[str], tmp_path: Path) -> None:
    program = tmp_path / "move.mnt"
    program.write_text("MOVER(0) = 1\nGO(0)\nPAUSE IDLE(0)\n", encoding="utf-8")
    if arguments == ["check"]:
        arguments = ["check", str(program)]
    code = (
        "import sys\n"
        "from motionlang.cli import main\n"
        f"assert main({arguments!r}) in (None, 0)\n"
        f"assert [each for each in {UNUSED!r} if each in sys.modules] == []\n"
    )
    done = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
