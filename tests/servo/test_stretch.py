"""Commands and feed-forward of servo samples, from trajectory points, by hand.

The trajectory has 100 points a second and the servo 400 samples, so a cycle of 0.01 s has 4 samples.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from motionlang.servo.discrete import discretise
from motionlang.servo.loop import Loop
from motionlang.servo.plant import Drive
from motionlang.servo.steps import MEMORY, initial_state
from motionlang.servo.stretch import (
    Stretch,
    _acting,
    _feed,
    _feeds,
    _given,
    _given_at_once,
    _spans,
    run_steps,
    run_stretch,
)

# The point before, the beginning, and the end of 5 cycles: at 0, 4, 8, 8, -8 and -8 counts a cycle.
POINTS = [0.0, 0.0, 4.0, 12.0, 20.0, 12.0, 4.0]
RATES: dict[str, Any] = {"servo_rate": 400.0, "trajectory_rate": 100.0}
SLOW: dict[str, Any] = {"servo_rate": 100.0, "trajectory_rate": 100.0}
# A quarter of a cycle later is a quarter of the way.
DEMAND = [
    *(0.0, 1.0, 2.0, 3.0),
    *(4.0, 6.0, 8.0, 10.0),
    *(12.0, 14.0, 16.0, 18.0),
    *(20.0, 18.0, 16.0, 14.0),
    *(12.0, 10.0, 8.0, 6.0),
]
# Volts by the velocity, in 0.01 V a count/s; and by its change, in 0.0001 V a count/s². 4 counts a cycle are 400
# counts/s, and their change in a cycle is 40 000 counts/s².
BY_VELOCITY = [4.0, 8.0, 8.0, -8.0, -8.0]
BY_ACCELERATION = [4.0, 4.0, 0.0, -16.0, 0.0]


@pytest.mark.parametrize(
    ("gains", "volts"),
    [
        ({"velocity_ff": 0.01}, BY_VELOCITY),
        ({"accel_ff": 0.0001, "decel_ff": 0.0001}, BY_ACCELERATION),
        ({"velocity_ff": 0.01, "accel_ff": 0.0001, "decel_ff": 0.0001}, [8.0, 12.0, 8.0, -24.0, -8.0]),
        # From 8 to -8 counts a cycle the speed is the same, so the axis does not slow down.
        ({"accel_ff": 0.0001, "decel_ff": 0.0005}, BY_ACCELERATION),
        ({"velocity_ff": 0.01, "accel_ff": 0.0001}, [8.0, 12.0, 8.0, -24.0, -8.0]),
        ({}, []),
    ],
)
def test_feed_forward_of_each_cycle(gains: dict[str, Any], volts: list[float]) -> None:
    loop = Loop(**gains, **RATES)
    if gains:
        assert _feed(loop, POINTS) == pytest.approx(volts)
    assert _feeds(loop, np.diff(np.array(POINTS))).tolist() == pytest.approx(volts)


def test_an_axis_that_slows_down_has_the_gain_of_deceleration() -> None:
    """The axis moves by 1, 3, 2, -1, -4 and -2 counts a cycle.

    A change of 1 is 10 000 counts/s².
    From 3 to 2, from 2 to -1 and from -4 to -2 the speed falls: 2, 3 and 2 times the gain of 0.0005.
    """
    points = [0.0, 1.0, 4.0, 6.0, 5.0, 1.0, -1.0]
    loop = Loop(velocity_ff=0.01, accel_ff=0.0001, decel_ff=0.0005, **RATES)
    by_velocity = [3.0, 2.0, -1.0, -4.0, -2.0]
    by_change = [2.0, -5.0, -15.0, -3.0, 10.0]
    volts = [a + b for a, b in zip(by_velocity, by_change, strict=True)]
    assert _feed(loop, points) == pytest.approx(volts)
    assert _feeds(loop, np.diff(np.array(points))).tolist() == pytest.approx(volts)


@pytest.mark.parametrize("samples", [slice(0, 20), slice(0, 16), slice(3, 9), slice(4, 5), slice(7, 20)])
@pytest.mark.parametrize("gains", [{}, {"velocity_ff": 0.01}])
def test_the_command_of_a_sample_is_on_the_line_between_two_points(
    samples: slice, gains: dict[str, Any]
) -> None:
    loop = Loop(**gains, **RATES)
    volts = [volt for volt in BY_VELOCITY for _ in range(4)][samples] if gains else []
    both: Any = ((_given, POINTS), (_given_at_once, np.array(POINTS)))
    for given, points in both:
        demand, feed = given(loop, points, samples)
        assert demand == DEMAND[samples]
        assert feed == pytest.approx(volts)
        if samples == slice(0, 20):
            slow, volts_of_cycles = given(Loop(**gains, **SLOW), points, slice(1, 5))
            assert slow == [4.0, 12.0, 20.0, 12.0]
            assert volts_of_cycles == pytest.approx([8.0, 8.0, -8.0, -8.0] if gains else [])


def test_a_stretch_knows_its_commands_and_marks() -> None:
    """It begins with the third sample of its first cycle.

    The mark at 0 has no point before it.
    """
    states = [(float(n),) for n in range(3)]
    stretch = Stretch(POINTS[1:], 2, 4, [], list(zip((0, 2, 10), states, strict=True)))
    assert stretch.demand(12).tolist() == DEMAND[2:14]
    assert [stretch.last_demand(count) for count in (1, 2, 3, 6, 12)] == [
        DEMAND[1 + count] for count in (1, 2, 3, 6, 12)
    ]
    assert stretch.mark_before(1) is None
    assert stretch.mark_before(2) is None
    assert stretch.mark_before(3) == (2, states[1], [0.0, 4.0, 12.0])
    assert stretch.mark_before(10) == (2, states[1], [0.0, 4.0, 12.0])
    assert stretch.mark_before(11) == (10, states[2], [12.0, 20.0, 12.0])
    slow = Stretch(POINTS[1:], 1, 1, [])
    assert slow.demand(2).tolist() == [4.0, 12.0]
    assert slow.demand(3).tolist() == [4.0, 12.0, 20.0]
    assert slow.last_demand(3) == 20.0


@pytest.mark.parametrize(
    ("mode", "acting"),
    [
        ("always", [True]),
        ("steady", [True, False, False, True, False]),  # cycles that the next one equals in speed
        ("stopped", [True, False, False, False, True]),
        ("zeroed", [True, False, False, False, True]),
    ],
)
def test_the_integral_acts_by_the_motion_of_the_command(mode: str, acting: list[bool]) -> None:
    """It is at rest, begins to move, moves faster and then uniformly, and stops."""
    points = [0.0, 0.0, 0.0, 1.0, 3.0, 5.0, 5.0]
    assert _acting(Loop(integral_mode=mode, **RATES), points) == acting
    assert _acting(Loop(integral_mode=mode, **RATES), np.array(points)) == acting
    # Rounding of large positions is no motion.
    assert _acting(Loop(integral_mode=mode, **RATES), [1e9, 1e9, 1e9 + 2e-6])[0]
    assert _acting(Loop(integral_mode=mode, **RATES), [0.0, 0.0, 2e-6])[0] is (mode == "always")


@pytest.mark.parametrize(
    ("mode", "offset", "count", "expected"),
    [
        ("stopped", 0, 20, [(0, 4, True, False), (4, 16, False, False), (16, 20, True, False)]),
        ("zeroed", 0, 20, [(0, 4, True, False), (4, 16, False, True), (16, 20, True, False)]),
        ("zeroed", 3, 17, [(0, 1, True, False), (1, 13, False, True), (13, 17, True, False)]),
        ("zeroed", 4, 10, [(0, 10, False, True)]),
        ("zeroed", 0, 4, [(0, 4, True, False)]),
        ("steady", 3, 6, [(0, 1, True, False), (1, 6, False, False)]),
    ],
)
def test_samples_are_run_in_spans_with_and_without_the_integral(
    mode: str, offset: int, count: int, expected: list[tuple[int, int, bool, bool]]
) -> None:
    """It acts in the first cycle and in the last one of five."""
    acting = [True, False, False, False, True]
    assert _spans(Loop(integral_mode=mode, **RATES), acting, offset, count) == expected


@pytest.mark.parametrize("form", [list, np.array], ids=["list", "array"])
@pytest.mark.parametrize("mode", ["always", "zeroed"])
def test_chunks_do_not_change_a_run(
    form: Callable[[list[float]], list[float]], mode: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """18 samples in chunks of 5, marked every 3, have the columns of one run."""
    loop = Loop(
        proportional=0.5, integral=0.1, velocity_ff=0.01, integral_mode=mode, integral_limit=100.0, **RATES
    )
    plant, columns, points = (
        Drive(),
        ("position", "output", "integral"),
        [5.0, 5.0, 5.0, 7.0, 11.0, 15.0, 15.0],
    )
    state = initial_state(discretise(plant, loop.period), 5.0)
    whole, after = run_steps(loop, plant, columns, form(points), 2, 18, state)
    assert whole.demand(18).tolist() == [5.0] * 3 + [5.5, 6.0, 6.5, *range(7, 15)] + [15.0] * 4
    assert [done for done, _ in whole.marks] == ([0] if mode == "always" else [0, 2, 14])
    if mode == "zeroed":
        assert whole.marks[1][1][MEMORY.index("total") - len(MEMORY)] == 0.0
    monkeypatch.setattr("motionlang.servo.stretch._CHUNK", 5)
    monkeypatch.setattr("motionlang.servo.stretch.MARKED", 3)
    made, last = run_stretch(loop, plant, columns, form(points), 2, 18, state)
    for found, expected in zip(made.columns, whole.columns, strict=True):
        assert list(found) == pytest.approx(list(expected))
    assert last == pytest.approx(after)
    assert made.last_demand(18) == whole.last_demand(18)
