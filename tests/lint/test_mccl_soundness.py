"""The linter is right about random files in MCCL, which tell each line before it runs."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import Source, dialect
from tests.generated.draw import Draw
from tests.generated.mccl_motion import McclProgram

# Warnings of commands that the board rejects, or that wait forever.
FAILING = frozenset(("nothing-loaded", "still-running", "zero-speed", "zero-acceleration", "motor-off"))
MCCL = dialect("mccl")


def told(text: str) -> str:
    """Return a file with a command that tells the number of each line, also in macros, before the line runs."""
    lines = []
    for number, line in enumerate(text.splitlines(), 1):
        head, comma, rest = line.partition(",") if line.startswith("MD") else ("", "", line)
        lines.append(f'{head}{comma}OT"line {number};",{rest}')
    return "\n".join(lines) + "\n"


def is_right(seed: int) -> bool:
    """True if each command that is said to fail fails if a run of the program with this seed reaches it."""
    source = Source("random.mcl", told(McclProgram(Draw(seed)).text))
    wrong = {each.line for each in check(MCCL.program(source)) if each.code in FAILING}
    if not wrong:
        return True
    found = run(source, until=60.0)
    reached = {line for line in wrong if f"line {line};" in found.output}
    return reached <= {each.line for each in found.diagnostics}


@pytest.mark.parametrize("seed", range(40))
def test_a_command_that_is_said_to_fail_fails(seed: int) -> None:
    assert is_right(seed)
