"""Gears of a board: slaves follow their ratio; waits and status follow the master."""

from __future__ import annotations

import pytest

from motionlang import Run
from tests.mccl.conftest import Runner

# 10000 counts at 10000/s with ramps of 0.1 s: 1.1 s; the slave covers half of it.
HEAD = "MN,SV10000,SA100000,DS100000,2SS0.5\n"
MOVE = "1MR10000\n"


def proved(mccl: Runner, text: str) -> Run:
    result = mccl(HEAD + text, prove=True, machine={"controller.instruction_time": 1e-9})
    assert result.proof().violations == []
    return result


@pytest.mark.parametrize("wait", ["2WS", "2WT"])
def test_a_wait_for_a_slave_ends_with_its_masters_motion(wait: str, mccl: Runner) -> None:
    result = proved(mccl, f"2SM1\n{wait},2TP\n{MOVE}{wait},1TP,2TP\n{MOVE}{wait},2TP")
    assert result.output == ["02 0", "01 10000", "02 5000", "02 10000"]
    assert result.time == pytest.approx(2.2, abs=1e-6)


def test_at_target_counts_from_when_the_master_rests(mccl: Runner) -> None:
    """DT of 0.25 s begins when the master is at rest; the second wait ends at once."""
    result = proved(mccl, f"2DT0.25,2SM1\n{MOVE}2WT,2WT,WA1,2WT")
    assert result.time == pytest.approx(1.1 + 0.25 + 1.0, abs=1e-6)


def test_the_target_of_a_slave_is_where_its_masters_takes_it(mccl: Runner) -> None:
    result = proved(mccl, f"2DH100,2SM1,2TT\n{MOVE}WA0.3,2TT\n1WS,2TT")
    assert result.output == ["02 100", "02 5100", "02 5100"]


@pytest.mark.parametrize("model", ["dcx-pci300", "multiflex"])
def test_the_status_of_a_slave_shows_its_mode_and_its_motion(model: str, mccl: Runner) -> None:
    text = f"{HEAD}2SM1,2TS\n{MOVE}WA0.3,2TS\n1WS,2TS\n2SM0,2TS"
    result = mccl(text, machine={"controller.model": model})
    bits = [int(line.split()[-1]) for line in result.output]
    assert [bit >> 3 & 1 for bit in bits] == [1, 0, 1, 1]
    if model == "multiflex":
        modes = mccl(f"{HEAD}2TS3\n2SM1,2TS3\n2SM0,2TS3", machine={"controller.model": model}).output
        assert [int(line.split()[-1]) >> 7 & 1 for line in modes] == [0, 1, 0]


def test_a_slave_that_is_freed_in_motion_ends_what_it_is_doing(mccl: Runner) -> None:
    """The slave completes its motion; stopping and returning the master has no effect."""
    result = proved(mccl, f"2SM1\n{MOVE}WA0.5,2SM0\nWA0.1,1ST,1WS,1MA0\n2WS,2TP\n2MA0,2WS,2TP")
    assert result.output == ["02 5000", "02 0"]
    first = next(move for move in result.controller.log.moves if move.axis == 2)
    assert (first.command, first.ended) == ("SM", "")
    assert first.profile is not None
    assert first.start_time + first.profile.duration == pytest.approx(1.1, abs=1e-6)


def test_a_slave_that_is_freed_from_what_runs_on_runs_on_until_it_is_stopped(mccl: Runner) -> None:
    """At 5000 counts/s: 4750 counts in the first second, 5000 more, a stop of 125."""
    result = proved(mccl, "2SM1,1VM,1DI0,1GO\nWA1,2SM0,1ST,1WS\nWA0.9,2TV,2ST,2WS,2TP,2TV")
    assert result.output == ["02 5000", "02 9875", "02 0"]


def test_stopped_and_switched_off_slaves_have_no_master(mccl: Runner) -> None:
    for command in ("2ST,2WS", "2AB", "2MF,2MN"):
        result = proved(mccl, f"2SM1\n{MOVE}WA0.5,{command},2MA-100\n2WS,1WS,2TP")
        assert result.output == ["02 -100"], command


def test_a_slave_takes_no_part_in_a_contour(mccl: Runner) -> None:
    result = mccl(f"{HEAD}2SM1,2CM1")
    assert result.output == ["?-2"]
    assert "is slaved to axis 1" in result.diagnostics[0].message


def test_a_slave_of_a_contour_follows_its_axis(mccl: Runner) -> None:
    result = proved(
        mccl, "3SS2,3SM2,1CM1,2CM1,1VV10000,1VA100000,1VD100000\n1CP1,1MA3000,2MA4000\n3WS,3TP,3TT"
    )
    assert result.output == ["03 8000", "03 8000"]
