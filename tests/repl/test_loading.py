"""The prompt loads what it uses."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from tests.cli.programs import STROKE

# What is loaded only when it is asked for.
LATER = (
    "exploration",
    *(
        f"commands.{each}"
        for each in ["map", "improve", "diff", "sweep", "certify", "profile", "cover", "init"]
    ),
)
MAX_LINES = 57_000
LOADED = """
import sys
from motionlang.cli import main
main(["repl", sys.argv[1]])
for name, module in sys.modules.items():
    if name.startswith("motionlang"):
        print("loaded", name, module.__file__)
"""


def test_a_prompt_with_a_program_loads_no_command_that_plays_one(tmp_path: Path) -> None:
    program = tmp_path / "a.mnt"
    program.write_text(STROKE)
    ran = subprocess.run(
        [sys.executable, "-c", LOADED, str(program)],
        input="PRINT 7\n",
        capture_output=True,
        text=True,
        check=True,
    )
    loaded = dict(line.split()[1:] for line in ran.stdout.splitlines() if line.startswith("loaded"))
    assert [name for name in loaded if name.removeprefix("motionlang.").startswith(LATER)] == []
    assert sum(Path(file).read_text(encoding="utf-8").count("\n") for file in loaded.values()) <= MAX_LINES
