"""The work of a proof grows with its run, not with its square: counted, not timed."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.controller.move import Move
from motionlang.controller.record import judge
from motionlang.source import Source

BLENDS = """SPEED(0) = 40 : ACCEL(0) = 1000 : DECEL(0) = 1000
PROFILEMODE(0) = 1 : ACCELJERK(0) = 200000 : DECELJERK(0) = 200000
MOVEBUFFERSIZE(0) = 100 : MOVEBUFFERSIZE(1) = 100
BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 0.0000333333
{}GO(0)
PAUSE IDLE(0)
"""


def looks(monkeypatch: pytest.MonkeyPatch, paths: int) -> int:
    """How often the proof of so many blended paths asks how far another one has come."""
    count, gone = 0, judge.gone

    def counted(move: Move, time: float) -> tuple[float, float]:
        nonlocal count
        count += 1
        return gone(move, time)

    text = BLENDS.format("VECTORR(0, 1) = 0.03, 0.04\n" * paths)
    result = run(Source("blends.mnt", text), cache=False, prove=True)
    with monkeypatch.context() as patched:
        patched.setattr(judge, "gone", counted)
        proof = result.proof()
    assert proof.holds
    assert proof.counts["paths"] >= paths
    return count


def test_each_blended_path_is_compared_with_those_that_overlap_it_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    few, many = looks(monkeypatch, 41), looks(monkeypatch, 84)
    assert 0 < many <= 2.2 * few
