"""The rest position after ST and AB, for each profile, setting and ramp section.

The distances are those of TN1069 (docs/tn1069.md). V, A, D are the velocity and the rates of the move, T is
the duration of its deceleration ramp, t the time since the ramp began, and v the velocity at the stop.
"""

from __future__ import annotations

from math import cos, pi, sin

import pytest

from motionlang import run
from motionlang.kernel import Source

V, D, TARGET = 40_000.0, 100_000.0, 100_000.0
RATIO = 0.1
# T_D, and the distance of the complete ramp in units of V T_D.
RAMPS = {
    "PT": (V / D, 1 / 2),
    "PS": (pi / 2 * V / D, 1 / 2),
    "PS0.1": (V / (D * (1 - RATIO)), 1 / 2),
    "PP": (2 * V / D, 2 / 3),
}


def from_velocity(kind: str, v: float, rate: float) -> float:
    """Return the stopping distance from v, with no initial acceleration."""
    whole, fraction = RAMPS[kind]
    return fraction * v * whole * v / V * D / rate


def in_the_ramp(kind: str, t: float) -> tuple[float, float]:
    """Return the velocity at time t of the ramp, and the distance left to the target."""
    whole, _ = RAMPS[kind]
    left = whole - t
    if kind == "PT":
        return D * left, D * left**2 / 2
    if kind == "PP":  # D at rest, less before it
        return D * (left - left**2 / (2 * whole)), D * (left**2 / 2 - left**3 / (6 * whole))
    if kind == "PS":  # D sin x
        x, omega = pi * t / whole, pi / whole
        return D / omega * (1 + cos(x)), D / omega**2 * (pi - x - sin(x))
    rise = RATIO * whole
    if t < rise:
        return V - D * t**2 / (2 * rise), V * whole / 2 - V * t + D * t**3 / (6 * rise)
    assert t <= whole - rise
    constant_time = left - rise  # after which D falls to 0 over `rise`
    after = D * rise / 2
    return after + D * constant_time, D * rise**2 / 6 + after * constant_time + D * constant_time**2 / 2


def of_a_stop(kind: str, t: float, rate: float) -> float:
    """Return the stopping distance from time t of the ramp, at another rate.

    The acceleration first falls to zero if it may not jump.
    """
    whole, _ = RAMPS[kind]
    v, _ = in_the_ramp(kind, t)
    if kind == "PS":  # the same half wave from the point where it has the same height, and falls
        x, omega = pi * t / whole, pi / whole
        if x >= pi / 2:
            return in_the_ramp(kind, t)[1]
        falling = D / omega**2 * ((1 + 2 * cos(x)) * x - sin(x))
        return falling + from_velocity(kind, 2 * D / omega * cos(x), rate)
    if kind == "PS0.1":
        rise = RATIO * whole
        flank = min(t, rise)
        height = D * flank / rise
        falling = v * flank - height * flank**2 / 2 + height * flank**2 / 6
        return falling + from_velocity(kind, v - height * flank / 2, rate)
    return from_velocity(kind, v, rate)


# The setting before the stop, and the rate of deceleration from then on.
CHANGES = {
    "nothing": ("", D),
    "SV": ("1SV10000", D),
    "SA": ("1SA20000", D),
    "DS as it is": ("1DS100000", D),
    "DS lowered": ("1DS60000", 60_000.0),
    "DS raised": ("1DS250000", 250_000.0),
}


def stopped(kind: str, change: str, time: float, command: str) -> tuple[float, float]:
    """Return when the axis is stopped, s, and where it comes to rest, counts.

    MR is the program's third command.
    """
    text, _ = CHANGES[change]
    wait = f"WA{time:.6f}"
    result = run(
        Source(
            "a.mccl",
            ",".join(["1MN", f"1{kind}", "1MR100000", wait, *([text] if text else []), f"1{command}", "1WS"]),
        ),
    )
    assert not result.diagnostics
    (move,) = result.machine.log.moves
    (event,) = [each for each in result.machine.log.events if each.kind in ("stop", "cancel")]
    return event.time - move.start_time, result.machine.controller.demand(1)


@pytest.mark.parametrize("fraction", [0.05, 0.3, 0.45, 0.6, 0.85])
@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("kind", RAMPS)
def test_st_while_slowing_down(kind: str, change: str, fraction: float) -> None:
    """The stop is at the present rate, or as planned if that is shorter and allowed.

    The planned stop is allowed if its rate is within the present one.
    """
    whole, size = RAMPS[kind]
    begin = (TARGET - 2 * size * V * whole) / V + whole
    time, end = stopped(kind, change, begin + fraction * whole, "ST")
    rate = CHANGES[change][1]
    _, left = in_the_ramp(kind, time - begin)
    distance = of_a_stop(kind, time - begin, rate)
    expected = min(distance, left) if rate >= D else distance
    assert end == pytest.approx(TARGET - left + expected, abs=1e-6)


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("kind", RAMPS)
def test_st_at_constant_velocity(kind: str, change: str) -> None:
    whole, size = RAMPS[kind]
    time, end = stopped(kind, change, whole + 0.1, "ST")
    assert end == pytest.approx(
        size * V * whole + V * (time - whole) + from_velocity(kind, V, CHANGES[change][1]), abs=1e-6
    )


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("kind", RAMPS)
def test_ab_stops_at_once(kind: str, change: str) -> None:
    whole, size = RAMPS[kind]
    begin = (TARGET - 2 * size * V * whole) / V + whole
    time, end = stopped(kind, change, begin + 0.3 * whole, "AB")
    assert end == pytest.approx(TARGET - in_the_ramp(kind, time - begin)[1], abs=1e-6)
