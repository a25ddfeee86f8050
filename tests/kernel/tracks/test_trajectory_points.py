"""The commands to the servo loop: TN1069's points at 1 kHz, joined by lines."""

from __future__ import annotations

import numpy as np
import pytest

from motionlang.kernel import Controller, Trace

EVERY = ("position", "velocity", "acceleration", "jerk")


def machine(start: float = 0.0, scale: float = 1.0) -> Controller:
    """Return the run of a move of 100 counts at 250 counts/s and 1250 counts/s².

    The move starts at `start`, s.
    """
    controller = Controller(1)
    controller.set_scale(0, scale)
    for name, value in (("speed", 250.0), ("accel", 1250.0), ("decel", 1250.0)):
        controller.configure(0, name, value)
    controller.clock.advance(start)
    controller.move_by(0, 100.0)
    controller.clock.advance(controller.idle_time(0))
    return controller


@pytest.mark.parametrize("start", [0.0, 5e-5, 9.3e-4])
def test_points_are_those_of_the_note(start: float) -> None:
    """S(T) = ACC/2 T², with ACC = A/N² in counts per cycle squared and T in cycles.

    A move begins at the next cycle.
    """
    points = Trace(machine(start)).as_controller().sample(1000.0, quantities=("position",)).get(0, "position")
    begin = int(np.ceil(start * 1000.0))
    acc = 1250.0 / 1000.0**2
    cycles = np.arange(201)
    np.testing.assert_allclose(points[begin : begin + 201], acc / 2.0 * cycles**2, rtol=0, atol=1e-12)
    assert points[-1] == 100.0


def test_between_the_points_are_straight_lines() -> None:
    samples = Trace(machine(5e-5)).as_controller().sample(4000.0, quantities=EVERY)
    position = samples.get(0, "position")
    assert position[4:13].tolist() == pytest.approx(
        [0.0, 0.00015625, 0.0003125, 0.00046875, 0.000625, 0.00109375, 0.0015625, 0.00203125, 0.0025],
        abs=1e-15,
    )
    assert samples.get(0, "velocity")[3:13:4].tolist() == pytest.approx([0.0, 0.625, 1.875])
    assert samples.get(0, "velocity")[4:8].tolist() == pytest.approx([0.625] * 4)
    assert samples.get(0, "acceleration")[4:13:4].tolist() == pytest.approx([625.0, 1250.0, 1250.0])
    assert samples.get(0, "jerk")[4:13:4].tolist() == pytest.approx([625e3, 625e3, 0.0], abs=1e-3)


def test_it_leaves_the_curve_by_what_a_chord_does() -> None:
    """A chord between points of a parabola is at most A/8N² = 0.00015625 counts away."""
    trace = Trace(machine())
    exact, commanded = trace.sample(4000.0), trace.as_controller().sample(4000.0)
    count = len(exact) - 1
    away = np.abs(exact.get(0, "position")[:count] - commanded.get(0, "position")[:count])
    assert away.max() == pytest.approx(1250.0 / 8.0 / 1000.0**2)
    assert not away[::4].max() > 1e-12


def test_the_trace_ends_at_rest_a_cycle_after_the_run() -> None:
    controller = machine(5e-5)
    assert controller.clock.now == pytest.approx(0.60005)
    samples = Trace(controller).as_controller().sample(4000.0)
    assert samples.time[-1] == pytest.approx(0.602)
    assert [float(column[-1]) for column in samples.data[1:]] == pytest.approx([100.0, 0.0, 0.0])


def test_a_new_speed_shows_a_cycle_later_and_a_new_zero_at_once() -> None:
    controller = Controller(1)
    for name, value in (("speed", 100.0), ("accel", 1e5), ("decel", 1e5)):
        controller.configure(0, name, value)
    controller.jog(0, 100.0)
    controller.clock.advance(0.0505)
    controller.define_position(0, 0.0)
    controller.clock.advance(0.1003)
    controller.jog(0, 200.0)
    controller.clock.advance(0.2)
    samples = Trace(controller).as_controller().sample(2000.0)
    position, velocity = samples.get(0, "position"), samples.get(0, "velocity")
    assert position[100] == pytest.approx(
        4.95
    )  # 50 ms less half the millisecond of the ramp, at 100 counts/s
    assert position[101] == pytest.approx(0.0, abs=1e-9)
    # From the old speed in 0.7 ms, 0.07 counts, to the new one in 1.7 ms, 0.29 counts.
    assert velocity[202] == pytest.approx(220.0)
    assert velocity[[201, 204]].tolist() == pytest.approx([100.0, 200.0])


@pytest.mark.parametrize("start", [0.0, 5e-5, 5e-4, 9.3e-4])
def test_a_stop_in_motion_keeps_to_the_set_acceleration(start: float) -> None:
    """The move waits for its cycle, and the stop is delayed as long, without a jump."""
    controller = Controller(1)
    for name, value in (("speed", 250.0), ("accel", 1250.0), ("decel", 1250.0)):
        controller.configure(0, name, value)
    controller.clock.advance(start)
    controller.move_by(0, 100.0)
    controller.clock.advance(start + 0.3)
    controller.stop(0)
    controller.clock.advance(controller.idle_time(0))
    acceleration = Trace(controller).as_controller().sample(4000.0).get(0, "acceleration")
    assert float(np.abs(acceleration).max()) == pytest.approx(1250.0)


def test_lengths_are_user_units() -> None:
    samples = Trace(machine(scale=50.0)).as_controller().sample(4000.0)
    assert samples.get(0, "position")[-1] == 2.0
    assert samples.get(0, "velocity").max() == pytest.approx(5.0)


def test_other_rates() -> None:
    slow = Trace(machine()).as_controller(10.0)
    positions = slow.sample(20.0, quantities=("position",)).get(0, "position")
    assert positions[:5].tolist() == pytest.approx([0.0, 3.125, 6.25, 15.625, 25.0])
