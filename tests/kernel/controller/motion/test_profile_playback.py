"""Stored profiles, such as splines, are suspended and stopped on their course."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel import Controller
from motionlang.kernel.controller import Playback
from tests.cases import examples
from tests.kernel.controller.machines import machine, until
from tests.kernel.planners.splines import cubic_table

quick = settings(max_examples=examples(60))
TIMES = [0.0, 0.5, 1.0, 1.5, 2.0]


def playing(on_path: bool = True) -> Controller:
    """Return two axes on a spline of half a second per point."""
    c = machine(suspend_time=0.2)
    c.play(0, cubic_table(TIMES, [0.0, 3.0, 5.0, 2.0, 8.0]), "SPLINE", 3, on_path)
    c.play(1, cubic_table(TIMES, [0.0, -1.0, 4.0, 4.0, 1.0]), "SPLINE", 3, on_path)
    return c


def plain(axis: int, time: float) -> float:
    return playing().axes[axis].position(time)


@quick
@given(st.lists(st.floats(0.01, 0.8), min_size=1, max_size=6))
def test_axes_that_play_together_stay_together(pauses: list[float]) -> None:
    c = playing()
    suspended = False
    for pause in pauses:
        until(c, c.clock.now + pause)
        for axis in (0, 1):
            (c.resume if suspended else c.suspend)(axis)
        suspended = not suspended
    for axis in (0, 1):
        c.resume(axis)
    until(c, 99.0)
    assert (c.position(0), c.position(1)) == (8.0, 1.0)
    for k in range(100):
        t = 0.05 * k
        x, y = c.axes[0].position(t), c.axes[1].position(t)
        # the position of the first axis on its spline gives the time of the spline, up to its first extremum
        if t < pauses[0] and t < 0.9:
            assert (x, y) == pytest.approx((plain(0, t), plain(1, t)), abs=1e-9)
    first = playing().axes[0].profiles[-1]
    for time in (first.crossing(4.0), first.crossing(1.0)):
        assert time is not None
        mine = c.axes[0]
        passed = [p.crossing(first.position(time)) for p in mine.profiles[1:]]
        where = next(i for i, found in enumerate(passed) if found is not None) + 1
        found = mine.profiles[where].crossing(first.position(time))
        assert found is not None
        at = mine.starts[where] + found
        if where + 1 == len(mine.starts) or at <= mine.starts[where + 1]:
            assert c.axes[1].position(at) == pytest.approx(plain(1, time), abs=1e-6)


def test_resumed_while_it_slows_down_it_speeds_up_from_there() -> None:
    """The playback slows from rate 1 to 0.5 in 0.1 s and returns in 0.1 s.

    0.75 of that time passes for the profile.
    """
    c = playing(on_path=False)
    for time, command in ((0.7, c.suspend), (0.8, c.resume)):
        until(c, time)
        for axis in (0, 1):
            command(axis)
    assert c.idle_time(0) == pytest.approx(0.9 + (2.0 - 0.85))


UNEVEN = [0.0, 0.5, 1.5, 1.75]
# The time of a new zero, and the times from there to the points that follow.
LEFT: dict[str, tuple[float, list[float]]] = {
    "within the first segment": (0.25, [0.25, 1.0, 0.25]),
    "at a point": (0.5, [1.0, 0.25]),
    "within the second segment": (0.75, [0.75, 0.25]),
    "within the last segment": (1.625, [0.125]),
}


@pytest.mark.parametrize("begin", [0.0, 8.0])
@pytest.mark.parametrize("name", LEFT)
def test_a_new_zero_shifts_the_points_that_are_left(name: str, begin: float) -> None:
    """The points are at 0, 3, 5 and 2 counts; 100 counts are added to each."""
    time, left = begin + LEFT[name][0], LEFT[name][1]
    c = machine()
    if begin:  # after moves there and back
        c.move_to(0, 1.0)
        until(c, 4.0).move_to(0, 0.0)
    until(c, begin)
    c.play(0, cubic_table(UNEVEN, [0.0, 3.0, 5.0, 2.0]), "SPLINE", 3, True)
    axis, playback = until(c, time).axes[0], Playback()
    playback.ordered = [0.0, 3.0, 5.0, 2.0], [0.0, 10.0, 20.0, 0.0], [0.5, 1.0, 0.25]
    playback.shift(axis, 100.0)
    points, velocities, times = playback.ordered
    count = len(left)
    assert points == [pytest.approx(axis.position(time) + 100.0), *[103.0, 105.0, 102.0][-count:]]
    assert velocities == [pytest.approx(axis.velocity(time)), *[10.0, 20.0, 0.0][-count:]]
    assert times == left


def test_without_a_time_to_slow_down_in_it_stops_at_once() -> None:
    c = playing()
    c.configure(0, "suspend_time", 0.0)
    until(c, 0.7).suspend(0)
    assert until(c, 2.0).position(0) == pytest.approx(plain(0, 0.7))
    c.resume(0)
    assert until(c, 9.0).position(0) == 8.0
