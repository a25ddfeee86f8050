"""Gains are searched for no longer than there may be some."""

from __future__ import annotations

import pytest

from motionlang.controller.servo import tuning
from motionlang.controller.servo.axis_loop import axis_loop
from motionlang.controller.servo.loop import Loop
from motionlang.controller.servo.plant import Drive, Motor
from motionlang.controller.servo.response import bandwidth
from motionlang.controller.servo.tuning import BeyondPlant, suggest


@pytest.mark.parametrize("inductance", [10.0, 1e6, 1e12])
def test_a_plant_that_no_gains_close_is_given_up_after_few_searches(
    inductance: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A bandwidth costs a hundred times what the stability of a loop does."""
    asked: list[float] = []

    def counted(loop: Loop, plant: Motor | Drive) -> float:
        asked.append(bandwidth(loop, plant))
        return asked[-1]

    monkeypatch.setattr(tuning, "bandwidth", counted)
    suggest.cache_clear()
    with pytest.raises(BeyondPlant):
        axis_loop({}, {}, Motor(inductance=inductance))
    assert len(asked) <= 16
