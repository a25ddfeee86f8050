"""The first statement after a tick or the end of a WAIT, to the last bit."""

from __future__ import annotations

from math import ceil

import pytest

from motionlang.fast.transitions import TICK, first_statement
from motionlang.lang.waits import ROUNDING

TASK = 0


@pytest.mark.parametrize(
    ("moment", "count"), [(2.0, 4.0), (1.999, 4.0), (2.001, 5.0), (1.0, 0.0), (1.25, 1.0), (1.01, 1.0)]
)
def test_the_first_statement_that_is_not_before_a_tick(moment: float, count: float) -> None:
    """Statements are at 1 s and each quarter of a second after it."""
    assert first_statement((moment, TICK, 0.0), 1.0, 0.25) == count


@pytest.mark.parametrize("cost", [1e-5, 0.7310585e-5, 3e-6, 1e-3 / 3.0])
@pytest.mark.parametrize("base", [0.0, 0.1, 1234.5678])
def test_a_tick_at_the_time_of_a_statement_to_the_last_bit(cost: float, base: float) -> None:
    """A quotient rounds differently from a product, so it may be one off."""
    off = 0
    for count in range(1, 400):
        moment = base + count * cost
        found = first_statement((moment, TICK, 0.0), base, cost)
        assert found is not None
        assert base + found * cost >= moment
        assert base + (found - 1.0) * cost < moment
        off += found != ceil((moment - base) / cost)
    assert off > 0 or base == 0.0


@pytest.mark.parametrize(
    ("distance", "count"),
    [
        (0.0, 4.0),
        (0.09, 4.0),
        (-0.09, 4.0),
        (0.11, None),
        (-0.11, None),
        (1.9, None),
        (-1.9, None),
        (2.1, 4.0),
        (-2.1, 5.0),
    ],
)
def test_the_first_statement_after_the_end_of_a_wait(distance: float, count: float | None) -> None:
    """A statement is at 2 s, at a distance after the end in units of rounding.

    Within a tenth of a unit it counts as the end; up to two units rounding may decide.
    """
    assert first_statement((2.0 - distance * ROUNDING, TASK, 0.0), 1.0, 0.25) == count
    assert first_statement((2.0 - distance * ROUNDING, TASK, 0.0), 1.5, 0.125) == count
