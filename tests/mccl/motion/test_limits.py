"""Limits of the boards in every motion: enabled in motion, and smooth by LM."""

from __future__ import annotations

import pytest

from motionlang.report import moves
from tests.mccl.conftest import Runner

HEAD = "1MN,2MN,1CM1,2CM1,1VV10000,1VA100000,1VD100000,2HL2000,2LL-100,"
CONTOUR = HEAD + "2LM{},2LN12\n1CP1,1MA3000,2MA4000\n1WS,1TP,2TP"


@pytest.mark.parametrize(("mode", "rest"), [(0, (1500, 2000)), (4, (1500, 2000)), (8, (1800, 2400))])
def test_a_soft_limit_stops_a_contour_as_its_mode_says(
    mode: int, rest: tuple[int, int], mccl: Runner
) -> None:
    """A smooth stop uses VD along the path: 10000² / 200000 = 500 counts more.

    The axes cover 300 and 400 of it.
    """
    result = mccl(CONTOUR.format(mode))
    assert result.output == [f"01 {rest[0]}", f"02 {rest[1]}"]
    assert [move["ended"] for move in moves(result)] == ["fault", "fault"]
    assert result.controller.faults(2) == 16


def test_a_contour_that_stops_smoothly_may_be_aborted(mccl: Runner) -> None:
    text = CONTOUR.format(8).replace("1WS,1TP,2TP", "WA0.33,AB,1TP,2TP")
    x, y = (int(line.split()[1]) for line in mccl(text).output)
    assert 1500 < x < 1800
    assert y * 3 == pytest.approx(x * 4, abs=4)


IN_FORCE = {
    "LN": ("1HL8000,1LL-9999", "1LN12"),
    "HL": ("1HL90000,1LL-9999,1LN12", "1HL8000"),
    "DH": ("1HL8000,1LL-9999,1DH-50000,1LN12", "1DH20000"),
}


@pytest.mark.parametrize("how", IN_FORCE)
@pytest.mark.parametrize(
    "start", ["1PM,1SV20000,1MR90000", "1VM,1SV20000,1DI0,1GO"], ids=["position", "velocity"]
)
def test_a_limit_put_in_force_behind_a_moving_axis_stops_it(how: str, start: str, mccl: Runner) -> None:
    before, then = IN_FORCE[how]
    result = mccl(f"1MN,1SA100000,1LM4,{before},{start},WA1,{then},WA1,1TV,1TS", until=3.0)
    assert result.output[0] == "01 0", result.output
    assert result.controller.faults(1) == 16
    assert next(moves(result))["ended"] == "fault"


def test_velocity_mode_that_turns_into_an_active_limit_stops_at_the_turn(mccl: Runner) -> None:
    """By LM8, 20000 counts/s at 100000 counts/s² exceed the limit of 8000 by 2000.

    The axis moves back slowly, and reverses again while still beyond the limit. It stops at that reversal.
    """
    text = (
        "1MN,1VM,1SV20000,1SA100000,1DS100000,1LM8,1HL8000,1LL-99999,1LN12,1DI0,1GO,WS,1MN\n"
        "1SV1000,1DI1,1GO,WA0.2,1SV20000,1DI0,1GO,WA1,1TP,1TV"
    )
    position, velocity = (int(line.split()[1]) for line in mccl(text).output)
    assert velocity == 0
    assert 8000 < position < 10000
