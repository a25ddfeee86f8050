"""Plans as a program of Python makes them: figures, programs, and what is assumed."""

from __future__ import annotations

import pytest

import motionlang
from motionlang.commands.plan import number, solve_plan


@pytest.mark.parametrize(
    ("dialect", "axis", "scale", "text"),
    [
        ("mint", None, 1.0, "SPEED(0) = 50\nACCEL(0) = 250\nDECEL(0) = 250\nMOVER(0) = 20\nGO(0)\n"),
        (
            "mint",
            0,
            4.0,
            "SCALE(0) = 4\nSPEED(0) = 50\nACCEL(0) = 250\nDECEL(0) = 250\nMOVER(0) = 20\nGO(0)\n",
        ),
        ("mint", 3, 1.0, "SPEED(3) = 50\nACCEL(3) = 250\nDECEL(3) = 250\nMOVER(3) = 20\nGO(3)\n"),
        ("mccl", None, 1.0, "1MN,1PM,1PT\n1SV50,1SA250,1DS250\n1MR20,1WS0\n"),
        ("mccl", 1, 4.0, "1US4\n1MN,1PM,1PT\n1SV50,1SA250,1DS250\n1MR20,1WS0\n"),
        ("mccl", 2, 1.0, "2MN,2PM,2PT\n2SV50,2SA250,2DS250\n2MR20,2WS0\n"),
    ],
)
def test_the_program_of_a_plan(dialect: str, axis: int | None, scale: float, text: str) -> None:
    """20 uu in 0.6 s by thirds: a speed of 20/0.4 = 50 after 0.2 s at 250."""
    plan = motionlang.plan(distance=20.0, time=0.6, rule="third")
    assert plan.program(dialect, axis=axis, scale=scale) == text


def test_ramp_times_are_milliseconds() -> None:
    plan = motionlang.plan(distance=20.0, time=0.6, rule="third")
    assert "ACCELTIME(0) = 200\nDECELTIME(0) = 200\n" in plan.program(use_times=True)


@pytest.mark.parametrize(("dialect", "axis"), [("mint", -1), ("mccl", 0), ("mccl", -1)])
def test_the_first_axis_of_a_language(dialect: str, axis: int) -> None:
    plan = motionlang.plan(distance=20.0, time=0.6, rule="third")
    first = {"mint": 0, "mccl": 1}[dialect]
    with pytest.raises(ValueError, match=f"there is no axis {axis}: {dialect} counts from {first}"):
        plan.program(dialect, axis=axis)
    with pytest.raises(ValueError, match="there is no dialect 'basic': mint or mccl"):
        plan.program("basic")


def test_a_plan_in_the_other_direction() -> None:
    """Only the distance is negative."""
    plan = motionlang.plan(distance=-20.0, time=0.6, rule="third")
    assert (plan.distance, plan.speed, plan.accel) == pytest.approx((-20.0, 50.0, 250.0))
    assert repr(plan) == (
        "<Plan: distance=-20, time=0.6, accel_time=0.2, slew_time=0.2, decel_time=0.2, speed=50, accel=250, decel=250>"
    )
    assert plan.figures()["distance"] == -20.0
    with pytest.raises(ValueError, match="distance must be greater than zero"):
        motionlang.plan(distance=0.0, time=1.0, rule="third")


@pytest.mark.parametrize(
    ("given", "assumed"),
    [
        ({"distance": 20.0, "speed": 50.0, "accel": 250.0}, {"decel"}),
        ({"distance": 20.0, "speed": 50.0, "decel": 250.0}, {"accel"}),
        ({"distance": 20.0, "speed": 50.0, "accel_time": 0.2}, {"decel_time"}),
        ({"distance": 20.0, "speed": 50.0, "accel": 250.0, "decel": 250.0}, set()),
        ({"distance": 20.0, "speed": 50.0, "accel_time": 0.2, "decel_time": 0.2}, set()),
    ],
)
def test_a_ramp_that_is_missing_is_that_of_the_other_end(given: dict[str, float], assumed: set[str]) -> None:
    figures, mirrored, wanted = solve_plan(given, None)
    assert (mirrored, wanted) == (assumed, {})
    assert (figures["accel"], figures["decel"], figures["time"]) == pytest.approx((250.0, 250.0, 0.6))


@pytest.mark.parametrize(
    ("given", "assumed"),
    [
        ({"accel": 2000.0}, {"decel"}),
        ({"decel": 2000.0}, {"accel"}),
        ({"accel": 2000.0, "decel": 2000.0}, set()),
        ({"accel_time": 0.15}, {"decel"}),
        ({"accel_time": 0.15, "decel": 2000.0}, set()),
    ],
)
def test_a_move_too_short_for_its_speed(given: dict[str, float], assumed: set[str]) -> None:
    """10 uu at 2000 uu/s² reach sqrt(10 · 2000) = 141.4 of 300 uu/s.

    That takes 0.15 s.
    """
    figures, mirrored, wanted = solve_plan({"distance": 10.0, "speed": 300.0, **given}, None)
    assert figures["speed"] == pytest.approx(20_000.0**0.5)
    assert figures["slew_time"] == 0.0
    assert mirrored == assumed
    assert wanted == pytest.approx({"speed": 300.0, "accel_time": 0.15, "decel_time": 0.15})
    plan = motionlang.plan(distance=10.0, speed=300.0, **given)  # type: ignore[arg-type]
    assert plan.commanded_speed == 300.0
    assert "SPEED(0) = 300" in plan.program()


@pytest.mark.parametrize(
    "given",
    [
        {"distance": 10.0, "speed": 300.0},
        {"distance": 10.0, "speed": 0.0, "accel": 2000.0},
        {"distance": 10.0, "speed": 300.0, "accel": 0.0},
        {"distance": 10.0, "speed": -300.0, "accel": 2000.0},
    ],
)
def test_figures_without_a_plan(given: dict[str, float]) -> None:
    with pytest.raises(ValueError, match=r"\w"):
        solve_plan(given, None)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (20.0, "20"),
        (0.1, "0.1"),
        (1 / 3, "0.3333333333"),
        (1e-7, "0.0000001"),
        (1e10, "10000000000"),
        (1e12, "1000000000000"),
    ],
)
def test_a_number_has_no_exponent(value: float, text: str) -> None:
    assert number(value) == text
