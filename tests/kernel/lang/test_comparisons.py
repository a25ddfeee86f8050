"""A debug build reports both sides of each comparison, also of a Case, a PAUSE and MCCL's IE."""

from __future__ import annotations

import pytest

from motionlang.kernel import Hook, Source, run

KEY = """\
#KEY
k = INKEY
IF k = 0 THEN GOTO KEY
k = k - 48
IF k < 0 OR k > 5 THEN PRINT 1
SELECT CASE k
CASE 1 TO 2
CASE 3
END SELECT
PAUSE ADC(0) * 3 > 5
"""
WORLD = {"key": [{"text": "3", "at": 0.1}], "analogue": [{"channel": 0, "value": 9.0, "at": 0.5}]}


class Sides(Hook):
    """The comparisons of a run, each once."""

    def __init__(self) -> None:
        super().__init__(lambda task, time, offset: None)
        self.seen: dict[tuple[object, object], None] = {}

    def compared(self, left: object, right: object) -> None:
        self.seen[left, right] = None


@pytest.mark.parametrize(
    ("name", "text", "machine", "sides"),
    [
        ("key.mnt", KEY, WORLD, [(0, 0), (51, 0), (3, 0), (3, 5), (3, 1), (3, 2), (3, 3), (0, 5), (27, 5)]),
        ("key.mcl", "AL5,IE3,NO,IG4,NO,IB9,NO,NO\n", {}, [(5, 3), (5, 9)]),
    ],
)
def test_both_sides_of_comparisons(
    name: str, text: str, machine: dict[str, object], sides: list[tuple[float, float]]
) -> None:
    hook = Sides()
    result = run(Source(name, text), machine=machine, hook=hook)
    assert result.diagnostics == []
    assert list(hook.seen) == sides
