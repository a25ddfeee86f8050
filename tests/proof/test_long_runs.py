"""Proofs of runs so long that the log is packed, or that there is more motion than is stored."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.kernel import Run, Source
from motionlang.kernel.log import Stream
from motionlang.kernel.log.stream import Chunk
from tests.kernel.log.small import shrink
from tests.proof import checks, expected_motion, prove, run

JOGS = """Dim k As Float
While k < {}
  k = k + 1
  JOG(0) = 0.001 * k
End While
CANCEL(0)
"""
REPEATED = """Dim i As Integer
For i = 1 To 60
  MOVER(0) = 1 : GO(0)
  PAUSE IDLE(0)
Next
VECTORR(0, 1) = 3, 4
GO(0)
PAUSE IDLE(0)
For i = 1 To 60
  MOVER(0) = 1 : GO(0)
  PAUSE IDLE(0)
Next
PRINT POS(0)
"""


def made(text: str) -> Run:
    return run(Source("long.mnt", text))


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
    result = made(JOGS.format(1000))
    monkeypatch.setattr(Stream, "_unsealed", counted)
    proof = prove(result)
    assert (proof.violations, proof.counts["moves"]) == ([], 1000)
    assert 0 < count <= 250


def test_a_proof_reads_what_is_packed(monkeypatch: pytest.MonkeyPatch) -> None:
    shrink(monkeypatch, chunk=8)
    result = made(REPEATED)
    assert result.controller.axes[0].older is not None
    proof = prove(result)
    assert (proof.violations, proof.counts["moves"], proof.counts["paths"]) == ([], 122, 1)


@pytest.mark.parametrize(("most", "is_proved"), [(9, True), (8, False)])
def test_equal_motion_counts_once_and_a_run_with_more_goes_on_and_is_not_proved(
    most: int, is_proved: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Four orders count as fifty each, and 240 that equal an earlier one as one each: 440, of 450 or 400."""
    for module in (expected_motion, checks):
        monkeypatch.setattr(module, "MAX_PROFILES", most)
    result = made(REPEATED)
    assert result.output == ["123.0000"]
    words = f"nothing was verified: the run has more than {most} profiles of motion, the limit of a proof"
    assert [each.message for each in prove(result).violations] == ([] if is_proved else [words])
