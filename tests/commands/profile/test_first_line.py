"""The time at the start is charged to the first line with more than a comment."""

from __future__ import annotations

from motionlang.kernel.mccl import DIALECT as MCCL
from motionlang.kernel.mint import DIALECT as MINT
from tests.cases import cases


@cases(
    ("line", "has_code"),
    [
        ("", False), ("  \t", False), ("' a comment", False), ("  'x = 1", False), ("REM x", False), ("rem", False),
        ("REMConfigure the drive", False), ("remaining = 5", True), ("REMOTEOUT(1) = 0", True), ("rem_x = 1", True),
        ("x = 1 ' a comment", True), ("#START", True),
    ],
)  # fmt: skip
def test_a_line_of_mint_with_code(line: str, has_code: bool) -> None:
    assert MINT.has_code(line) is has_code
    kinds = {kind for kind, _, _ in MINT.tokens(line)}
    assert bool(kinds - {"comment"}) is has_code


@cases(("line", "has_code"), [("", False), (" ; a comment", False), (",, ; x", False), ("1MN ; on", True)])
def test_a_line_of_mccl_with_code(line: str, has_code: bool) -> None:
    assert MCCL.has_code(line) is has_code
