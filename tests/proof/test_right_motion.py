"""Motion that is right, and was once called a violation: settings and zeros that are written in motion."""

from __future__ import annotations

import pytest

from motionlang.kernel import Source
from tests.proof import prove, run

RATES = "SPEED(0) = 50 : ACCEL(0) = 100 : DECEL(0) = 100\n"
MOVE = "MOVER(0) = 100 : GO(0)\nWAIT 500\n"
REST = "PAUSE IDLE(0)\n"
MCCL = "2MA-672.05\nWA0.05,2DS69462\nWA0.01,2DH1\n2WS\n"


@pytest.mark.parametrize("shape", ["2PT", "2PS", "2PS0.2", "2PP"])
@pytest.mark.parametrize("text", [MCCL, "2MA-672.05\n2DS69462\n2DH1\n2WS\n"])
def test_a_rate_and_a_zero_in_motion(shape: str, text: str) -> None:
    assert prove(run(Source("a.mcl", f"2MN,{shape}\n{text}"))).violations == []


@pytest.mark.parametrize("shape", ["", "PROFILEMODE(0) = 1 : ACCELJERK(0) = 500 : DECELJERK(0) = 900\n"])
@pytest.mark.parametrize(
    "text",
    [
        f"{MOVE}INCR(0) = -150\nWAIT 100\nACCEL(0) = 30\nSPEED(0) = 20\n{REST}",
        f"FEEDRATEMODE(0) = 0\n{MOVE}FEEDRATEMODE(0) = 1\nSPEED(0) = 20\nWAIT 100\nACCEL(0) = 40\n{REST}",
        f"{MOVE}DECELTIME(0) = 900\n{REST}",
        f"{MOVE}POS(0) = 3\nWAIT 200\nPOS(0) = -8\n{REST}",
    ],
)
def test_settings_and_positions_in_motion(text: str, shape: str) -> None:
    assert prove(run(Source("a.mnt", RATES + shape + text))).violations == []
