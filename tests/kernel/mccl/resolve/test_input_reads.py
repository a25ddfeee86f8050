"""Where a program depends on inputs."""

from __future__ import annotations

from motionlang.kernel import Source
from motionlang.kernel.mccl import DIALECT as MCCL


def test_where_a_program_depends_on_inputs() -> None:
    """WN and WF wait, the others test, each for a level."""
    found = MCCL.program(
        Source("inputs.mcl", "WN5\nCN33,WF6,IN7\nIF8,DN9,DF10,1WE0\nIN11,BK,NO,WA1,RP\nIN12,BK,NO\n")
    ).reads
    assert found == [
        (5, 1, 1), (6, 0, 2), (7, 1, 2), (8, 0, 3), (9, 1, 3), (10, 0, 3), (11, 1, 4), (12, 1, 5),
    ]  # fmt: skip
