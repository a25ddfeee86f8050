"""Status bit 2: the time at which an axis is within DB of its target for DT."""

from __future__ import annotations

import pytest

from tests.cases import cases
from tests.mccl_runs import Runner

# 0.1 s and 50 counts up, 0.2 s and 100 counts down; 1000 counts take 0.1 + 0.85 + 0.2 s.
RATES = "1MN,1SV1000,1SA10000,1DS5000,"


@cases(
    "commands, since",
    [
        # 10 counts before the end of a deceleration of 5000 counts/s2: sqrt(2 * 10 / 5000) = 0.06325 s.
        ("1DB10,1MR1000", 1.15 - 0.063246),
        ("1DB10,1MR-1000", 1.15 - 0.063246),
        ("1DB1,1MR1000", 1.15 - 0.02),
        ("1DB10,1DT0.02,1MR1000", 1.17 - 0.063246),
        ("1DT0.02,1MR1000", 1.17),
        ("1MR1000", 1.15),
        ("1DB2000,1MR1000", 0.0),
        ("1DB2000,1DT0.3,1MR1000", 0.3),
    ],
)
def test_bit_2_is_on_within_db_of_the_target_for_dt(commands: str, since: float, mccl: Runner) -> None:
    """WT ends then, and so does a loop that polls the bit."""
    for wait in ("1WT", 'LU"STATUS",1RL@0,IC2,JR-3,NO'):
        result = mccl(f"{RATES}WA1\n{commands}\n{wait}\nCN33")
        (switched,) = result.controller.log.outputs
        assert switched.time == pytest.approx(1.0 + since, abs=3e-4)


@cases(
    "commands, since",
    [
        ("1DB10,1DT0.05,1MR10", 0.05),
        # 1 count is travelled after sqrt(2 * 1 / 10000) = 0.01414 s.
        ("1DB10,1DT0.05,1MR11", 0.05 + 0.014142),
        ("1DB10,1MA5", 1.145 - 0.063246),
        ("1DB10,1MA-1000", 2.15 - 0.063246),
    ],
)
def test_the_distance_to_the_target_counts_from_where_the_axis_is(
    commands: str, since: float, mccl: Runner
) -> None:
    """The axis begins at 1000 counts at 2 s: 1.15 s of motion, 0.85 s of waiting.

    A target within DB at the start of the move is near enough at once.
    """
    result = mccl(f"{RATES}1MA1000,1WS,WA0.85\n{commands}\n1WT\nCN33")
    (switched,) = result.controller.log.outputs
    assert switched.time == pytest.approx(2.0 + since, abs=3e-4)
