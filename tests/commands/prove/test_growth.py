"""The work of a proof grows linearly with its run: counted, not timed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

from motionlang import prove, run
from motionlang.commands.prove import checker, path_bounds, paths
from motionlang.commands.prove.order import PathOrder
from motionlang.commands.prove.path_layout import PathLayout
from motionlang.kernel import Run, Source
from motionlang.kernel.log import Move, Stream
from motionlang.kernel.log.stream import Chunk
from tests.kernel.log.small import shrink

BLENDS = """SPEED(0) = 40 : ACCEL(0) = 1000 : DECEL(0) = 1000
PROFILEMODE(0) = 1 : ACCELJERK(0) = 200000 : DECELJERK(0) = 200000
MOVEBUFFERSIZE(0) = 100 : MOVEBUFFERSIZE(1) = 100
BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 0.0000333333
{}GO(0)
PAUSE IDLE(0)
"""


JOGS = """Dim k As Float
While k < {}
  k = k + 1
  JOG(0) = 0.001 * k
End While
CANCEL(0)
"""

OFFSETS = """SPEED(1) = 80 : ACCEL(1) = 300 : DECEL(1) = 400 : MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0
FOLLOW(1) = 0.5
JOG(0) = 30
Dim i As Integer
For i = 1 To {}
  OFFSET(1) = 0.1 : GO(1)
  WAIT 60
Next
CANCEL(0)
"""


CONTOUR = """SPEED(0) = 40 : ACCEL(0) = 1000 : DECEL(0) = 1000
CONTOURMODE(0) = 1 : MOVEBUFFERSIZE(0) = 100 : MOVEBUFFERSIZE(1) = 100
{}GO(0)
PAUSE IDLE(0)
"""


def proved(text: str) -> Run:
    return run(Source("long.mnt", text), prove=True)


def count_checks(monkeypatch: pytest.MonkeyPatch, text: str) -> int:
    """Return how often the proof calculates how far another entry has got."""
    count, travelled = 0, checker.travelled

    def counted(move: Move, time: float) -> tuple[float, float]:
        nonlocal count
        count += 1
        return travelled(move, time)

    result = proved(text)
    with monkeypatch.context() as patched:
        patched.setattr(checker, "travelled", counted)
        assert prove(result).holds
    return count


def test_each_blended_path_is_compared_with_those_that_overlap_it_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    few, many = (
        count_checks(monkeypatch, BLENDS.format("VECTORR(0, 1) = 0.03, 0.04\n" * paths)) for paths in (41, 84)
    )
    assert 0 < many <= 2.2 * few


def test_each_path_of_a_contour_is_laid_out_equally_often(monkeypatch: pytest.MonkeyPatch) -> None:
    """The distance to the end of a contour of n paths is a sum of up to n lengths."""
    laid: list[PathLayout] = []

    class Counted(PathLayout):
        def __init__(self, path: PathOrder, starts: Sequence[float]) -> None:
            super().__init__(path, starts)
            laid.append(self)

    counts = []
    for count in (40, 80):
        result = proved(CONTOUR.format("VECTORR(0, 1) = 0.3, 0.4\n" * count))
        for module in (paths, path_bounds):
            monkeypatch.setattr(module, "PathLayout", Counted)
        assert prove(result).holds
        counts.append(len(laid))
        laid.clear()
        monkeypatch.undo()
    assert counts[0] >= 40
    assert counts[1] <= 2.2 * counts[0]


def test_a_slave_is_compared_with_the_offsets_that_are_under_way_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    few, many = (count_checks(monkeypatch, OFFSETS.format(offsets)) for offsets in (50, 100))
    assert 0 < many <= 2.2 * few


@pytest.mark.slow
def test_a_long_run_is_unpacked_a_few_times_and_not_for_each_of_its_moves(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """1 000 jogs without rests are some 8 chunks of 128 moves, and 8 of profiles."""
    count = 0
    unsealed = Stream._unsealed

    def counted(stream: Stream[Any], chunk: Chunk) -> Chunk:
        nonlocal count
        count += 1
        return unsealed(stream, chunk)

    shrink(monkeypatch, chunk=128, left=128)
    result = proved(JOGS.format(1000))
    monkeypatch.setattr(Stream, "_unsealed", counted)
    proof = prove(result)
    assert proof.holds
    assert proof.counts["moves"] == 1000
    assert 0 < count <= 250
