"""Points of a trajectory, cycle by cycle, by hand.

A cycle takes 0.1 s. After a rest of 0.55 s the command follows two cubics of 1 s each.
"""

from __future__ import annotations

import pytest

from motionlang.kernel.planners import from_curve, hold, plan_velocity
from motionlang.kernel.servo import Track
from motionlang.kernel.servo.demand import FOR_EVER, Generator

# 1 + 2t + 3t² + 4t³ for 1 s, then from 10 on 20t - 10t² for 1 s: at its end it is at rest at 20.
BEGIN, MIDDLE = 0.55, 1.55
CURVE = from_curve(
    "pvt",
    1.0,
    20.0,
    (
        (0.0, 1.0, 2.0),
        ((1.0, 2.0, 3.0, 4.0, 0.0, 0.0, 0.0), (10.0, 20.0, -10.0, 0.0, 0.0, 0.0, 0.0)),
        (("segment", 0), ("segment", 1)),
    ),
    2.0,
    0.0,
)
TRACK = Track([0.0, BEGIN, 2.55], [hold(1.0), CURVE, hold(20.0)])


def by_hand(time: float) -> float:
    """Return the position of the track at a time, s."""
    t = time - BEGIN
    if t <= 0.0:
        return 1.0
    if t <= 1.0:
        return 1.0 + 2.0 * t + 3.0 * t**2 + 4.0 * t**3
    t -= 1.0
    return 10.0 + 20.0 * t - 10.0 * t**2 if t <= 1.0 else 20.0


@pytest.mark.parametrize("period", [0.1, 0.025])
def test_a_point_is_that_of_the_end_of_its_cycle_in_the_profile_before_it(period: float) -> None:
    """The profile from 0.55 s on takes effect in the first cycle that begins later."""
    generator = Generator(TRACK, period)
    count = round(3.0 / period)
    expected = [
        1.0 if round(cycle * period / 0.025) <= 22 else by_hand((cycle + 1) * period)
        for cycle in range(count)
    ]
    assert generator.points(0, count) == pytest.approx(expected)
    assert [generator.points(cycle, 1) for cycle in range(count)] == [
        [each] for each in generator.points(0, count)
    ]
    assert generator.points(3, 0) == []
    assert [generator.first(cycle) for cycle in (0, 4, 8)] == pytest.approx(
        [by_hand(cycle * period) for cycle in (0, 4, 8)]
    )
    middle = round(0.8 / period)
    assert generator.points(middle, 4) == pytest.approx(expected[middle : middle + 4])


def test_a_new_zero_is_no_step_of_the_command() -> None:
    """At 1 s the position 5 becomes 2, at 2 s it becomes 8: the points stay at 5.

    The offsets are 3 and -3.
    A change of rounding is none. A sample exactly at the time of a change is before it.
    """
    track = Track([0.0, 1.0, 2.0, 3.0], [hold(5.0), hold(2.0), hold(8.0), hold(8.0 + 1e-9)])
    generator = Generator(track, 0.1)
    assert [generator.offset(k) for k in (0, 3, 1, 2)] == [0.0, -3.0, 3.0, -3.0]
    assert generator.points(0, 40) == pytest.approx([5.0] * 40, abs=1e-6)
    assert Generator(track, 0.1).shifts(0, 100, 20.0) == [(0, 0.0), (21, 3.0), (41, -3.0)]
    cases = (
        ((20, 100), [(20, 0.0), (21, 3.0), (41, -3.0)]),
        ((21, 100), [(21, 3.0), (41, -3.0)]),
        ((21, 41), [(21, 3.0)]),
        ((21, 42), [(21, 3.0), (41, -3.0)]),
        ((5, 22), [(5, 0.0), (21, 3.0)]),
        ((5, 21), [(5, 0.0)]),
        ((70, 90), [(70, -3.0)]),
    )
    for (first, until), expected in cases:
        assert Generator(track, 0.1).shifts(first, until, 20.0) == expected, (first, until)


@pytest.mark.parametrize("count", range(4))
def test_profiles_that_are_dropped_change_no_later_offset(count: int) -> None:
    starts, profiles = [0.0, 1.0, 2.0, 3.0], [hold(5.0), hold(2.0), hold(8.0), hold(9.0)]
    track = Track(starts, profiles)
    generator = Generator(track, 0.1)
    generator.drop(count)
    del track.starts[:count], track.profiles[:count]
    assert [generator.offset(k) for k in range(4 - count)] == [0.0, 3.0, -3.0, -4.0][count:]


def test_closing_a_loop_sets_the_offset_from_there_on() -> None:
    track = Track([0.0, 1.0, 2.0], [hold(5.0), hold(2.0), hold(8.0)])
    generator = Generator(track, 0.1)
    generator.rebase(15, 7.0)
    assert [generator.offset(k) for k in (0, 1, 2)] == [0.0, 5.0, -1.0]
    generator.rebase(15, 4.0, 1)
    assert [generator.offset(k) for k in (0, 1, 2)] == [0.0, 2.0, -4.0]
    generator.rebase(5, 6.0, 0)  # what comes later begins there again
    assert [generator.offset(k) for k in (0, 1, 2)] == [1.0, 4.0, -2.0]


def test_a_new_zero_in_motion_is_none_of_the_motion() -> None:
    """At 10 counts/s, the position is set to 3 after 1 s and to 1 after 1.5 s."""
    move = plan_velocity("trapezoid", 0.0, 10.0, 10.0, 100.0, 100.0)
    track = Track([2.0, 3.0, 3.5], [move, move.shifted(3.0), move.shifted(1.0)])
    generator = Generator(track, 0.1)
    assert [generator.offset(k) for k in range(3)] == pytest.approx([0.0, 7.0, 14.0])
    expected = [10.0 * (0.1 * (cycle + 1) - 2.0) for cycle in range(20, 50)]
    assert generator.points(20, 30) == pytest.approx(expected)
    assert generator.points(36, 4) == pytest.approx(expected[16:20])
    generator.rebase(38, 100.0)
    assert generator.points(37, 2) == pytest.approx([100.0, 101.0])


@pytest.mark.parametrize(("starts", "count"), [([], 0), ([0.0], 0), ([0.0, 1.0], 1), ([0.0], 2)])
def test_a_track_has_a_profile_for_each_start(starts: list[float], count: int) -> None:
    with pytest.raises(ValueError, match="one start for each profile"):
        Track(starts, [hold(0.0)] * count)


def test_the_first_cycle_of_the_next_profile() -> None:
    """Profiles from 0.5, 0.55 and 0.6 s on take effect in cycles 6, 6 and 7.

    A profile that begins exactly with a cycle takes effect in the next one.
    """
    generator = Generator(Track([0.0, 0.5, 0.55, 0.6], [hold(0.0)] * 4), 0.1)
    assert [generator.past(k) for k in range(4)] == [6, 6, 7, FOR_EVER]
    assert [generator.in_force(cycle) for cycle in (0, 5, 6, 7, 100)] == [0, 0, 2, 3, 3]
    assert generator.points(0, 10) == [0.0] * 10
