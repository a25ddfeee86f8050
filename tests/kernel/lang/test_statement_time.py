"""Machine time in whole statements, progress that fits, and whole units."""

from __future__ import annotations

from itertools import product
from math import inf

import pytest

from motionlang.kernel.lang.statement_time import UNITS, StatementTime, units


def at_base(base: float, cost: float = 1.0) -> StatementTime:
    time = StatementTime(cost)
    time.start(base)
    return time


@pytest.mark.parametrize(
    ("base", "cost"), [(0.0, 1e-5), (0.3, 1e-5), (1.1, 1e-3), (7.0, 1.0), (38013.2, 2e-5), (0.1, 0.1)]
)
def test_the_first_statement_at_a_time(base: float, cost: float) -> None:
    """It is not before the time, and the one before it is.

    The times are those of statements, their neighbouring floats, and some between two statements.
    """
    time = at_base(base, cost)
    for count, beside in product((0, 1, 2, 3, 7, 29, 1000, 123_457), (0.0, 0.25, 0.75)):
        moment = base + (count + beside) * cost
        for each in (moment, moment * (1.0 + 2.0**-52), moment * (1.0 - 2.0**-53)):
            first = time.first(each)
            assert first in (count, count + 1.0)
            assert time.at(first - 1.0) < each <= time.at(first)
    assert time.first(inf) == inf


def test_a_task_that_goes_on_where_it_stopped_continues_its_count() -> None:
    """It stopped at statement 4, at 14 s.

    Statement 10 is at 20 s. From a base of 15 s that is statement 5.
    """
    time = at_base(10.0)
    assert time.leave(4.0) == time.reached == 14.0
    assert time.go_on(14.0, 20.0) == 4.0
    assert time.until == 20.0
    assert time.go_on(15.0, inf) == 0.0
    assert (time.base, time.until) == (15.0, inf)


@pytest.mark.parametrize(
    ("now", "base", "count", "here", "until", "times"),
    [
        # Three statements, from 2 to 5, end at 5 s: they fit five times more until 20 s and 22 s, and six until 23 s.
        (0.0, 0.0, 2.0, 5.0, 20.0, 5.0),
        (0.0, 0.0, 2.0, 5.0, 22.0, 5.0),
        (0.0, 0.0, 2.0, 5.0, 23.0, 6.0),
        (0.0, 0.0, 2.0, 5.0, inf, inf),
        # After a wait, 2 s later at the same statement: it is 5 s.
        (3.0, 1.0, 2.0, 2.0, 20.0, 7.0),
        (3.0, 1.0, 2.0, 2.0, 21.0, 8.0),
        (3.0, 1.0, 2.0, 3.0, 20.0, 0.0),
        (3.0, 1.0 / 3.0, 2.0, 2.0, 20.0, 0.0),
    ],
)
def test_how_often_progress_fits(
    now: float, base: float, count: float, here: float, until: float, times: float
) -> None:
    assert at_base(now).periods(base, count, here, until) == times


# A number of units up to which each time is a float of its own.
EXACT = 2.0**52
# The rounded product of the seconds and `UNITS` is 1 too small for the first three and 1 too large for the next.
ROUNDED = (3801323441225423, 3496238381354765, 3839428020161331, 3505751284149323, 3932526872744635)


@pytest.mark.parametrize("number", [0, 1, 99_999, int(UNITS), *ROUNDED, int(EXACT) - 1, int(EXACT)])
def test_a_whole_number_of_units_is_found_again(number: int) -> None:
    assert units(number / UNITS) == number


def test_the_product_with_the_units_is_rounded_to_either_side() -> None:
    assert [round(number / UNITS * UNITS) - number for number in ROUNDED] == [-1, -1, -1, 1, 1]
