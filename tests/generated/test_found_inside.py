"""Wrong answers that were found, which only a change inside the controller shows."""

from __future__ import annotations

import pytest

from motionlang.kernel import Source
from motionlang.kernel.controller import settings
from motionlang.kernel.controller.motion.takeup import Takeup
from tests.generated.test_found import CONTOUR, RATES, proved
from tests.proof import prove, run


def test_rates_that_a_path_could_keep_are_asked_of_those_ahead_of_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """DECEL is lowered to 50 with 41 of the path left.

    A controller that ignores it brakes at 100, and the proof reports that.
    """
    monkeypatch.setattr(settings, "_replan", lambda axis, name: None)
    lines = "VECTORR(0, 1) = 51, 0\nVECTORR(0, 1) = 1, 0\nGO(0)\nWAIT = 600\nDECEL(0) = 50\nPAUSE IDLE(0)\n"
    program = Source("found.mnt", f"{RATES}{CONTOUR}{lines}")
    found = prove(run(program)).violations
    assert "the path deceleration reaches 100, above 50" in found[0].message


def test_the_play_of_an_axis_is_looked_up_once_for_a_rest(monkeypatch: pytest.MonkeyPatch) -> None:
    """A jog at 1 is suspended and comes to rest after 10 µs.

    One second later the play has been looked up for three stretches of time, not for every nanosecond.
    """
    stretches, find = list[float](), Takeup._stretch

    def noted(play: Takeup, now: float) -> tuple[float, int]:
        stretches.append(now)
        assert len(stretches) < 20
        return find(play, now)

    monkeypatch.setattr(Takeup, "_stretch", noted)
    jog = "BACKLASH(0) = 1 : BACKLASHMODE(0) = 1\nJOG(0) = 1\nWAIT = 5\nSUSPEND(0) = 1\nWAIT = 1000\n"
    assert proved(f"{jog}PRINT ENCODER(0) > 0\nCANCEL(0)\n").output == ["1"]
