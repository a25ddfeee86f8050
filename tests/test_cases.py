"""`@cases` runs every case, and a failure names its case."""

from __future__ import annotations

import pytest
from hypothesis.internal.conjecture import providers

import motionlang
from tests.cases import cases


def test_every_case_runs_and_a_failure_names_its_case() -> None:
    seen = []

    @cases("one, two", [(1, 2), (3, 3), (4, 5)])
    def run(one: int, two: int, factor: int) -> None:
        seen.append(one * factor)
        assert one == two

    with pytest.raises(BaseExceptionGroup, match="2 of 3 cases failed") as error:
        run(factor=10)
    assert seen == [10, 30, 40]
    assert [each.__notes__ for each in error.value.exceptions] == [["case 1, 2"], ["case 4, 5"]]


def test_one_failure_is_raised_as_it_is() -> None:
    @cases("number", [1, 2], ids=lambda number: f"number {number}")
    def run(number: int) -> None:
        with pytest.raises(ZeroDivisionError):
            1 / (1 - number % 2)

    with pytest.raises(pytest.fail.Exception) as error:
        run()
    assert error.value.__notes__ == ["case number 2"]


def test_hypothesis_draws_no_constants_of_the_package() -> None:
    """Such constants would depend on the modules that earlier tests imported."""
    assert motionlang is not None
    constants = getattr(providers.HypothesisProvider(None), "_local_constants", ())  # private to Hypothesis
    assert len(constants) == 0
