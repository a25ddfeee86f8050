"""Which comparisons of a position for equality `check` warns of."""

from __future__ import annotations

import pytest

from motionlang.mccl import DIALECT
from motionlang.source import Source

LOOKED_UP = 'LU"POSITION",'


@pytest.mark.parametrize(
    ("line", "count"),
    [
        (f"MD4,{LOOKED_UP}1RL@0,IU500,JR-3,NO", 1),
        (f"MD4,{LOOKED_UP}1RL@0,IE500,BK,NO,RP", 1),
        ('MD4,LU"AUXPOSITION",1RL@0,IE500,BK,NO,RP', 1),
        (f"MD4,{LOOKED_UP}AR7,1RL@7,IE500,BK,NO,RP", 1),
        (f"MD4,{LOOKED_UP}1RL@0,IE500,BK,NO,JP0", 1),
        # A line that reads the position once does not poll it.
        (f"MD4,{LOOKED_UP}1RL@0,IE500,CN1,NO", 0),
        # IG and IB are true on one side of the position, which the axis cannot miss.
        (f"MD4,{LOOKED_UP}1RL@0,IG500,BK,NO,RP", 0),
        # Another variable, another register, another value in the accumulator.
        ('MD4,LU"STATUS",1RL@0,IE500,BK,NO,RP', 0),
        (f"MD4,{LOOKED_UP}AR7,1RL@8,IE500,BK,NO,RP", 0),
        (f"MD4,{LOOKED_UP}1RL@0,AL500,IE500,BK,NO,RP", 0),
        (f"MD4,{LOOKED_UP}AL3,1RL@0,IE500,BK,NO,RP", 0),
        ("IE500,BK,NO,RP", 0),
        # A read leaves its value in the accumulator, no address; a command of an axis leaves the address there.
        (f"MD4,{LOOKED_UP}1RL@0,1RL@0,IE500,BK,NO,RP", 0),
        (f"MD4,{LOOKED_UP}1MR100,1RL@0,IE500,BK,NO,RP", 1),
    ],
)
def test_a_line_that_polls_a_position_for_equality_is_reported(line: str, count: int) -> None:
    found = DIALECT.check(Source("a.mcl", line + "\nMC4\n"))
    assert [each.code for each in found].count("exact-position") == count
