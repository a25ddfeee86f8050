"""The proof of a slave that follows a curve while an input suspends its axis."""

from __future__ import annotations

import pytest

from motionlang import prove, run
from motionlang.kernel import Source
from motionlang.kernel.controller import CurveFollow
from motionlang.kernel.controller.motion import halt
from motionlang.kernel.planners import Profile

RATES = "SPEED(0, 1) = 20; : ACCEL(0, 1) = 100; : DECEL(0, 1) = 100;\n"
TIE = "MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0 : SUSPENDINPUT(1) = 2\n"
LOADS = {
    "fly": "MASTERDISTANCE(1) = 100 : FLY(1) = 100 : GO(1)\n",
    "cam": "Dim rise(2) As Float = 1, 10\nCAMTABLE(1, rise, NULL) : MASTERDISTANCE(1) = 40\nCAM(1) = 4 : GO(1)\n",
}
JOGS = "JOG(0) = 20\nWAIT = 1000\nJOG(0) = 10\nWAIT = 2000\nEnd\nEvent ONERROR\nEnd Event\n"


def violations(load: str) -> list[str]:
    """Return the violations of a proof of 4 s; from 0.5 s the input is closed."""
    machine = {"controller.instruction_time": 1e-9, "input": [{"channel": 2, "at": 0.5}]}
    source = Source("held.mnt", f"{RATES}{TIE}{LOADS[load]}{JOGS}")
    result = run(source, machine=machine, prove=True, until=4.0)
    assert result.diagnostics == []
    return [each.message for each in prove(result).violations]


@pytest.mark.parametrize("load", LOADS)
def test_a_slave_that_leaves_its_curve_while_it_is_held_is_rejected(
    load: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A slave on a curve cannot be suspended; a forged one comes to rest at DECEL."""
    assert violations(load) == []
    honest = CurveFollow.base

    def base(tie: CurveFollow, coming: Profile, position: float) -> Profile:
        if tie.a.suspended:
            return halt.with_standstill(tie.controller, tie.a)
        return honest(tie, coming, position)

    monkeypatch.setattr(CurveFollow, "base", base)
    assert any("its master requires" in each for each in violations(load))
