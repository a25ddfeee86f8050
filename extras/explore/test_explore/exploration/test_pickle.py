"""An exploration that a pool of processes sends."""

from __future__ import annotations

import pickle

import pytest

import motionlang

MOVE = "MOVER(0) = 50 : GO(0) : PAUSE IDLE(0)\n"


@pytest.mark.parametrize(
    ("name", "text"), [("a.mnt", f"Loop\nPAUSE INX(1)\n{MOVE}End Loop\n"), ("a.mcl", "WN1,1MN,1MR9,1WS,RP")]
)
def test_an_exploration(name: str, text: str) -> None:
    found = motionlang.explore(motionlang.Source(name, text))
    sent = pickle.loads(pickle.dumps(found))
    assert repr(sent.cycles) == repr(found.cycles)
    assert (len(sent.nodes), sent.missed, sent.world.settings) == (
        len(found.nodes),
        found.missed,
        found.world.settings,
    )
    assert sent.world.run.report == found.world.run.report
    assert [repr(each) for each in sent.variants()] == [repr(each) for each in found.variants()]
