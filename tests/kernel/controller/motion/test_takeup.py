"""Take-up of backlash: its rate, by hand arithmetic."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Source
from motionlang.kernel.controller.motion.takeup import Takeup
from motionlang.kernel.planners import plan_trapezoid
from tests.fuzz.guard import bounded
from tests.kernel.controller.machines import machine, until


def test_play_is_taken_up_while_the_axis_moves_and_at_its_rate() -> None:
    c = machine(1)
    play = Takeup(c.axes[0], 0.0)
    play.size, play.ramp = 10.0, 2.0
    assert (play.advance(0.0, True), play.rate()) == (0.0, 0.0)
    c.move_to(0, 12.0)
    assert until(c, 1.0).velocity(0) == 10.0
    assert (play.advance(1.0, True), play.rate()) == (5.0, 5.0)
    until(c, 2.0)
    assert (play.advance(2.0, True), play.rate()) == pytest.approx((6.5, 0.0))


@pytest.mark.parametrize(
    ("size", "asked", "taken"),
    [
        (10.0, (3.2, 4.3, 5.4), (5.0, 0.5, 5.0)),
        (10.0, (4.3,), (0.5,)),
        (10.0, (4.25, 4.3), (0.25, 0.5)),
        (10.0, (2.0, 3.1, 3.2, 4.2, 5.3), (0.0, 5.5, 5.0, 0.0, 5.5)),
        (10.0, (6.5,), (0.0,)),
        (-10.0, (3.1, 3.2, 4.2, 4.3, 5.3), (0.0, -0.5, -5.5, -5.0, 0.0)),
        (20.0, (3.2, 4.1, 5.3, 6.0, 6.5), (10.0, 1.0, 11.0, 4.0, 0.0)),
    ],
)
def test_play_is_taken_up_forward_and_given_back(
    size: float, asked: tuple[float, ...], taken: tuple[float, ...]
) -> None:
    """From 2 s on the axis goes out and back twice, 10 counts in 1.1 s each time.

    The play takes 2 s of motion in one direction, so a leg takes up 0.55 of it: 5.5 of 10. The axis turns at 3.1, 4.2
    and 5.3 s and rests at 6.4 s. A negative play is taken up in reverse motion. A reading changes no later one.
    """
    c = machine(1)
    play = Takeup(c.axes[0], 0.0)
    play.size, play.ramp = size, 2.0
    until(c, 2.0)
    out, back = plan_trapezoid(0.0, 10.0, 10.0, 100.0, 100.0), plan_trapezoid(10.0, 0.0, 10.0, 100.0, 100.0)
    c.play(0, out.then(back).then(out).then(back))
    found = []
    for time in asked:
        until(c, time)
        found.append(play.advance(time, True))
    assert found == pytest.approx(taken, abs=1e-9)


def test_no_play_is_taken_up_while_a_spline_stands_on_its_way() -> None:
    """Backlash of 2 takes 0.2 s of motion: half of it in the first 100 ms.

    None is taken up in the next 100 ms, in which the spline is at rest.
    """
    text = (
        "Dim way(4) As Float = 3, 10, 0, 10\nDim slow(4) As Float = 3, 0, 0, 0\n"
        "BACKLASH(0) = 2 : BACKLASHINTERVAL(0) = 200 : BACKLASHMODE(0) = 1\n"
        "SPLINETABLE(0, way, slow, NULL) : SPLINETIME(0) = 100\nSPLINE(0) = 0 : GO(0)\n"
        "WAIT = 150\nPRINT ENCODER(0) - POS(0) USING 1, 4\n"
        "PAUSE IDLE(0)\nPRINT ENCODER(0) - POS(0) USING 1, 4\n"
    )
    with bounded(5.0):  # the standstill is one stretch, not one every nanosecond
        result = run(Source("spline.mnt", text), machine={})
    assert [each.message for each in result.diagnostics] == []
    assert result.output == ["1.0000", "2.0000"]


@pytest.mark.parametrize(
    ("size", "velocity", "rate"), [(0.5, 2.0, 0.25), (0.5, -2.0, 0.0), (-0.5, -2.0, -0.25), (-0.5, 2.0, 0.0)]
)
def test_play_of_less_than_a_count_is_taken_up_at_its_rate(size: float, velocity: float, rate: float) -> None:
    """Half a count in 2 s is 0.25 counts/s; the axis moves since 0 s."""
    c = machine(1)
    play = Takeup(c.axes[0], 0.0)
    play.size, play.ramp = size, 2.0
    c.move_to(0, 8.0 * velocity)
    until(c, 1.0)
    assert (play.advance(1.0, True), play.rate()) == (rate, rate)


def test_play_without_a_ramp_is_taken_up_at_once() -> None:
    c = machine(1)
    play = Takeup(c.axes[0], 0.0)
    play.size = 3.0
    c.move_to(0, 8.0)
    until(c, 0.1)
    assert (play.advance(0.1, False), play.advance(0.1, True)) == (0.0, 0.0)
    until(c, 0.2)
    assert (play.advance(0.2, True), play.rate()) == (3.0, 0.0)


def test_without_backlash_nothing_is_taken_up() -> None:
    c = machine(1)
    play = Takeup(c.axes[0], 0.0)
    play.ramp = 2.0
    c.move_to(0, 8.0)
    until(c, 0.5)
    assert (play.advance(0.5, True), play.rate(), play.heading) == (0.0, 0.0, 1)


@pytest.mark.parametrize("size", [10.0, -10.0])
def test_the_rate_has_the_sign_of_the_change(size: float) -> None:
    """Ten counts in 2 s: taken up after 2 s, and given back from 4 s on."""
    c = machine(1)
    play = Takeup(c.axes[0], 0.0)
    play.size, play.ramp = size, 2.0
    sign = 1.0 if size > 0.0 else -1.0
    c.jog(0, sign * 10.0)
    found = []
    for time in (1.0, 3.0):
        until(c, time)
        found.append((play.advance(time, True), play.rate()))
    until(c, 4.0).abort(0)
    c.jog(0, -sign * 10.0)
    for time in (5.0, 7.0):
        until(c, time)
        found.append((play.advance(time, True), play.rate()))
    assert found == [
        (pytest.approx(0.5 * size), 0.5 * size),
        (size, 0.0),
        (pytest.approx(0.5 * size), -0.5 * size),
        (pytest.approx(0.0), 0.0),
    ]
