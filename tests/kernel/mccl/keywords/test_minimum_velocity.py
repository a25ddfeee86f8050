"""MV: the trapezoid between two steps of velocity, checked by its segments."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel import Source
from motionlang.kernel.planners import Profile
from tests.cases import examples
from tests.proof import prove, run

rates = st.integers(100, 100_000)


@settings(max_examples=examples(150))
@given(
    st.integers(-(10**5), 10**5).filter(bool), st.floats(0.01, 1.0), st.floats(0.0, 1.5), rates, rates, rates
)
def test_a_move_and_its_continuation_keep_their_rates_and_steps(
    distance: int, fraction: float, when: float, speed: int, accel: int, decel: int
) -> None:
    """The proof knows the two steps of velocity; a further move may begin in motion."""
    settings = f"1SV{speed},1SA{accel},1DS{decel},1MV{int(fraction * speed)}"
    text = f"1MN,{settings}\n1MR{distance}\nWA{when:.4f},1MR{distance},1WS,1TP\n"
    result = run(Source("step.mcl", text), machine={"axis.1.motor": "stepper"})
    assert result.output == [f"01 {2 * distance}"]
    assert prove(result).violations == []


STEPPER = "1MN,1SV5000,1SA20000,1DS10000,1MV1000\n1MR4000,1WS\n"


def forged(change: Callable[[Profile], Profile]) -> list[str]:
    """Return the violations that the proof finds in a changed move of a stepper."""
    result = run(Source("step.mcl", STEPPER))
    assert prove(result).violations == []
    assert "a step of a stepper that starts or stops at once" in prove(result).exceptions
    a = result.controller.axes[1]
    i = next(k for k, each in enumerate(a.profiles) if each.shape == "trapezoid")
    a.profiles[i] = change(a.profiles[i])
    return [each.message for each in prove(result).violations]


@pytest.mark.parametrize(
    ("low", "speed", "accel", "decel", "message"),
    [
        (1000.0, 5500.0, 20000.0, 10000.0, "the speed reaches"),
        (1000.0, 5000.0, 21000.0, 10000.0, "the acceleration reaches 21000"),
        (1000.0, 5000.0, 20000.0, 11000.0, "the deceleration reaches 11000"),
        (1200.0, 5000.0, 20000.0, 10000.0, "the velocity jumps by 1200"),
    ],
)
def test_the_proof_holds_a_move_to_its_rates_and_to_the_step(
    low: float, speed: float, accel: float, decel: float, message: str
) -> None:
    text = f"1MN,1SV{speed:g},1SA{accel:g},1DS{decel:g},1MV{low:g}\n1MR4000,1WS\n"
    other = run(Source("step.mcl", text)).controller.axes[1].profiles
    messages = forged(lambda _: next(each for each in other if each.shape == "trapezoid"))
    assert any(message in each for each in messages), messages


def test_what_is_left_of_a_move_at_a_new_zero_is_held_to_what_it_was_planned_with() -> None:
    run_on = "1MN,1SV5000,1SA20000,1DS10000,1MV1000\n1MR4000\nWA0.2,1SV100,1DH5,1WS\n"
    result = run(Source("zero.mcl", run_on))
    assert prove(result).violations == []


def test_a_stop_that_continues_the_move_ends_with_its_step() -> None:
    """A sine takes longer than what is left of the trapezoid to 1743.

    Its end, a sum of times, is rounded to just before the step.
    """
    stops = (
        "1MN,1PT,1SV10283,1SA281078,1DS35986,1MV360\n1MR17393,1MR3541\nWA0.458\n1MA1743\nWA0.4,1PS,1ST,1WS\n"
    )
    fine = {"controller.instruction_time": 1e-9}
    result = run(Source("stop.mcl", stops), machine=fine)
    assert prove(result).violations == []
    assert result.controller.position(1) == 1743.0
