"""Predictions of a simulated motor, compared with its readings sample by sample."""

from __future__ import annotations

from math import inf

import pytest

from motionlang.kernel import Controller
from motionlang.kernel.controller.feedback import Feedback

MOTOR: dict[str, object] = {"load_inertia": 4e-5, "viscous": 2e-5}
# A soft loop at 1000 samples a second, which overshoots and settles late.
GAINS: dict[str, object] = {"proportional": 0.008, "derivative": 0.15}
COUNT = 600


def moving(at: float = 0.05) -> tuple[Controller, Feedback]:
    """Return an axis on the way from 0 to 400 counts; at 0.03 s it gets another zero."""
    controller = Controller(1)
    a = controller.axes[0]
    feedback = a.feedback = Feedback(a, MOTOR, GAINS)
    for name, value in (("speed", 4000.0), ("accel", 40_000.0), ("decel", 40_000.0)):
        controller.configure(0, name, value)
    controller.move_to(0, 400.0)
    controller.clock.advance(0.03)
    controller.define_position(0, controller.position(0) + 1000.0)
    controller.clock.advance(at)
    return controller, feedback


@pytest.fixture(scope="module")
def readings() -> list[tuple[float, float, float]]:
    """Return position, following error and velocity at every sample from 0.05 s on."""
    controller, feedback = moving()
    found = []
    for k in range(50, COUNT):
        controller.clock.advance(k / 1000)
        found.append((feedback.position, feedback.error, feedback.velocity))
    return found


Readings = list[tuple[float, float, float]]


def first(readings: Readings, is_there: list[bool]) -> float:
    """Return the time of the first sample that is there."""
    return (50 + is_there.index(True)) / 1000


def test_when_a_following_error_is_reached(readings: Readings) -> None:
    controller, feedback = moving()
    begin = readings[0][1]
    assert feedback.error == pytest.approx(begin)
    level = 0.5 * begin
    wanted = first(readings, [(error > level) is not (begin > level) for _, error, _ in readings])
    time = feedback.error_crossing_time(level)
    while time < wanted - 1e-9:
        controller.clock.advance(time)
        time = feedback.error_crossing_time(level)
    assert time == pytest.approx(wanted)


def test_positions_are_known_at_the_samples_that_are_stored(readings: Readings) -> None:
    unmoved = Feedback(Controller(1).axes[0], MOTOR, GAINS)
    assert (unmoved.known_position(0.0), unmoved.velocity, unmoved.error) == (None, 0.0, 0.0)
    assert (unmoved.crossing_time(5.0), unmoved.error_crossing_time(5.0)) == (inf, inf)
    assert (unmoved.settled_time(), unmoved.resting) == (0.0, True)
    controller, feedback = moving(0.1)
    assert feedback.known_position(0.1) == pytest.approx(readings[50][0])
    assert feedback.known_position(0.1009) == feedback.known_position(0.1) == feedback.position
    assert feedback.known_position(1e9) is None
    assert feedback.position == pytest.approx(controller.position(0))
