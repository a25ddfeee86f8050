"""Backlash: the motor leads the load by half of it, also with a simulated motor."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Source
from tests.mccl_runs import Runner


@pytest.mark.parametrize("motor", [False, True])
def test_mint_has_the_same_with_the_play_on_one_side(motor: bool) -> None:
    machine = {"axis.0.plant.amplifier": "current"} if motor else {}
    text = (
        "KPROP(0) = 2 : KVEL(0) = 20 : SPEED(0) = 1000 : ACCEL(0) = 10000 : DECEL(0) = 10000\n"
        "BACKLASH(0) = 20 : BACKLASHMODE(0) = 1\n"
        "MOVER(0) = 500 : GO(0) : PAUSE IDLE(0) : PRINT ENCODER(0) - POS(0)\n"
        "MOVER(0) = -500 : GO(0) : PAUSE IDLE(0) : PRINT ENCODER(0) - POS(0)\n"
    )
    result = run(Source("play.mnt", text), machine=machine)
    assert [float(line) for line in result.output] == [20.0, 0.0]


def test_recorded_positions_are_those_of_the_motor(mccl: Runner) -> None:
    """TP and TO report the motor, too.

    Out by 10 counts in 20 ms, and back; BD and BF come after the recording.
    """
    text = "1MN,1SV1000,1SA100000,1DS100000,1BD10,1BN,1PR60,1MR10,1WS,1TP,1MR-10,1WS,1TP,WA0.1,1BD3,1BF,1DO0,1DR0"
    out, back, *recorded = mccl(text).output
    assert (out, back) == ("01 20", "01 -10")
    assert recorded[:60] == recorded[60:]
    assert [recorded[k] for k in (0, 1, 10, 19, 21, 30, 45)] == [
        f"01 {n}" for n in (0, 10, 15, 20, 0, -5, -10)
    ]
