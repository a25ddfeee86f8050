"""The short commands import only what they need."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

# The most modules of ours that a command imports.
MOST = {"run": 235, "check": 355, "help HOMESPEED": 170, "help": 52, "--version": 30}
# Keywords that none of them needs, and what a run of a few moves does not: paths, motors, pictures, texts with errors,
# machine files.
UNUSED = (
    "kernel.mint.keywords.camboxes",
    "cli.picture",
    "commands.certify",
    "kernel.controller.io.asking",
    "kernel.controller.moves.path_run",
    "kernel.controller.surroundings",
    "kernel.lang.machine.file",
    "kernel.lang.machine.keys",
    "kernel.lang.wait_hints",
    "kernel.mint.syntax.errors",
    "kernel.servo.settings",
)


@pytest.mark.parametrize("words", MOST)
def test_a_short_command_imports_no_more_than_it_needs(words: str, tmp_path: Path) -> None:
    program = tmp_path / "move.mnt"
    program.write_text(
        "SPEED(0) = 10\nACCEL(0) = 100\nMOVER(0) = 1\nGO(0)\nPAUSE IDLE(0)\n", encoding="utf-8"
    )
    arguments = words.split() if words not in ("run", "check") else [words, str(program)]
    code = (
        "import sys\n"
        "import motionlang.cli.commands\n"
        "from motionlang.cli import main\n"
        "motionlang.cli.commands._others = dict  # other distributions import their own\n"
        "try:\n"
        f"    assert main({arguments!r}) in (None, 0)\n"
        "except SystemExit as ended:\n"
        "    assert not ended.code\n"
        "ours = {each.removeprefix('motionlang.') for each in sys.modules if each.startswith('motionlang.')}\n"
        f"print(len(ours), *({set(UNUSED if words == 'run' else UNUSED[:1])!r} & ours))\n"
    )
    done = subprocess.run([sys.executable, "-c", code], check=False, capture_output=True, text=True)
    count, *unused = done.stdout.splitlines()[-1].split()
    assert (done.returncode, unused) == (0, []), done.stderr
    assert int(count) <= MOST[words]
