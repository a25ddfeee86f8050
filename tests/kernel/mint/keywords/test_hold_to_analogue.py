"""HTA, control of an axis by a sensor, against the recurrence of its control law.

The sensor's value rises with the position.
"""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

PERIOD = 1e-3
RATES = "SPEED(0) = 1e5 : ACCEL(0) = 1e8 : DECEL(0) = 1e8\nHTACHANNEL(0) = 2\n"
# A sensor of 2 percent per unit from position 0 on.
SENSOR = [{"channel": 2, "axis": 0, "above": 0.0, "value": 0.0, "per_unit": 2.0}]


def ran(text: str, sensor: list[dict[str, float]] | None = None, until: float = 5.0) -> Run:
    result = run(Source("a.mnt", text), machine={"analogue": sensor or SENSOR}, until=until)
    assert [each.message for each in result.diagnostics] == []
    return result


def at_ticks(result: Run, count: int) -> list[float]:
    """Return the positions at `count` control ticks from the axis's first command on."""
    a = result.controller.axes[0]
    first = a.starts[2]
    return [a.position(first + k * PERIOD) for k in range(count)]


def law(
    wanted: float, kp: float, kd: float = 0.0, ki: float = 0.0, per_unit: float = 2.0, n: int = 200
) -> list[float]:
    """Return the positions that the control law gives at `n` ticks.

    x' = x + T (v + v')/2, v' = kp e + kd (e - e_before) + ki sum(e), e = wanted - per_unit x.
    """
    x = v = total = 0.0
    before = None
    positions = []
    for _ in range(n):
        positions.append(x)
        e = wanted - per_unit * x
        total += e
        following = kp * e + kd * (e - before if before is not None else 0.0) + ki * total
        before = e
        x, v = x + PERIOD * (v + following) / 2.0, following
    return positions


def test_proportional_holding_has_a_closed_form() -> None:
    """The error obeys e'' = (1 - a) e' - a e, with a = slope gain T/2.

    The larger one of its two roots gives the time constant.
    """
    result = ran(RATES + "HTAKPROP(0) = 10\nHTA(0) = 40\nWAIT = 2000\nPRINT ADC(2), VEL(0)\nSTOP(0)")
    a = 2.0 * 10.0 * PERIOD / 2.0
    root = ((1 - a) ** 2 - 4 * a) ** 0.5
    r1, r2 = (1 - a + root) / 2.0, (1 - a - root) / 2.0
    e0, e1 = 40.0, 40.0 * (1 - a)
    c1 = (e1 - r2 * e0) / (r1 - r2)
    errors = [c1 * r1**k + (e0 - c1) * r2**k for k in range(300)]
    assert [40.0 - 2.0 * x for x in at_ticks(result, 300)] == pytest.approx(errors, abs=1e-9)
    assert result.output == ["40.00000.0000"]


@pytest.mark.parametrize(
    ("kp", "kd", "ki"), [(10.0, 0.0, 0.0), (10.0, 5.0, 0.0), (5.0, 1.0, 0.05), (20.0, -3.0, 0.0)]
)
def test_the_law_to_the_tick(kp: float, kd: float, ki: float) -> None:
    gains = f"HTAKPROP(0) = {kp} : HTADAMPING(0) = {kd} : HTAKINT(0) = {ki}\n"
    result = ran(RATES + gains + "HTA(0) = 40\nWAIT = 400\nSTOP(0)")
    assert at_ticks(result, 200) == pytest.approx(law(40.0, kp, kd, ki), abs=1e-9)


def test_a_new_value_is_no_new_entry_of_the_log() -> None:
    result = ran(RATES + "HTAKPROP(0) = 10\nHTA(0) = 40\nWAIT = 200\nHTA(0) = 10\nWAIT = 200\nSTOP(0)")
    assert len(result.controller.log.moves) == 1


def test_it_sleeps_when_there_is_nothing_to_do_and_wakes_when_the_input_changes() -> None:
    """A pulse of 30 percent causes a speed of -30 for 100 ms, with ramps of one tick."""
    pulse = [{"channel": 2, "at": 1.0, "for": 0.1, "value": 30.0}]
    result = ran(RATES + "HTAKPROP(0) = 1\nHTA(0) = 0\nWAIT = 2000\nPRINT VEL(0)\nSTOP(0)", pulse)
    assert result.output == ["0.0000"]
    assert result.controller.position(0) == pytest.approx(-3.0, abs=0.04)
    assert len(result.controller.axes[0].profiles) < 10


def test_per_unit_needs_an_axis() -> None:
    from motionlang.kernel.lang import first_mistake

    assert "needs an axis" in first_mistake({"analogue": [{"channel": 1, "value": 0.0, "per_unit": 2.0}]})


@pytest.mark.parametrize("wanted", [0.0, 40.0, -40.0])
def test_it_sleeps_at_any_value_that_the_input_has(wanted: float) -> None:
    """Two events in 2 s: the input at the start, and the end of the wait."""
    text = RATES + f"HTAKPROP(0) = 10\nHTA(0) = {wanted}\nWAIT = 2000\nSTOP(0)"
    result = ran(text, [{"channel": 2, "at": 0.0, "value": wanted}])
    assert result.controller.clock.fired <= 3
