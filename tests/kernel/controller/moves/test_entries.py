"""Buffer entries other than moves and paths: cams, offsets, stored profiles."""

from __future__ import annotations

import pytest

from motionlang.kernel import INFINITY, Controller, Rejected
from tests.counted_calls import all_calls


def ready(axes: int = 2) -> Controller:
    controller = Controller(axes)
    for axis in range(axes):
        for name, value in (("speed", 100.0), ("accel", 1000.0), ("decel", 1000.0), ("buffer_size", 4.0)):
            controller.configure(axis, name, value)
    return controller


def climbing(segments: int, cycles: int) -> Controller:
    """Return a controller after some cycles of a cam that rises as far as its master.

    In the middle of each cycle the cam is 10 ahead of a straight line.
    """
    controller = ready()
    positions = [100.0 * n / segments for n in range(segments + 1)]
    points = positions, [x + 0.4 * x - 0.004 * x * x for x in positions]
    controller.load_cam(1, 0, lambda _: points, cyclic=True)
    controller.go([1])
    controller.jog(0, 100.0)
    controller.clock.advance(0.05 + cycles)  # the ramp takes 0.1 s and half of the distance
    return controller


def test_many_cycles_of_a_cam_add_up() -> None:
    controller = climbing(segments=20, cycles=500)
    assert controller.position(0) == pytest.approx(50_000.0)
    assert controller.position(1) == pytest.approx(50_000.0)
    found = controller.crossing_time(1, 50_060.0)  # x + 0.4 x - 0.004 x² = 60: x = 50, a point of the table
    assert found == pytest.approx(500.05 + 0.5)


def test_a_crossing_of_a_long_table_is_looked_up() -> None:
    def calls(segments: int) -> int:
        controller = climbing(segments, cycles=3)
        level = controller.position(1) - 40.0  # the cam is not there again
        assert controller.crossing_time(1, level) == INFINITY
        return all_calls(lambda: controller.crossing_time(1, level))

    assert calls(1000) == calls(10)


def test_the_log_of_a_cam_whose_table_changes_is_packed_by_the_size_of_its_tables() -> None:
    """A cycle of 800 segments counts as one hundred profiles."""
    controller = ready()
    positions = [float(n) for n in range(801)]
    controller.load_cam(
        1, 0, lambda _: (positions, [0.0] * 800 + [1.0]), cyclic=True
    )  # a new one in each cycle
    controller.go([1])
    controller.jog(0, 800.0)
    controller.clock.advance(150.0)
    assert len(controller.log.moves) > 1  # the cam continues as another entry
    assert controller.position(1) == pytest.approx(149.0, abs=1.0)


def test_a_bad_table_is_refused_when_it_is_loaded() -> None:
    controller = ready()
    with pytest.raises(Rejected, match="cannot follow the table"):
        controller.load_cam(1, 0, lambda start: ([0.0, 0.0], [start, start]))
    assert controller.room(1) == 4


def test_points_begin_where_the_move_before_it_ends_and_again_and_again() -> None:
    controller = ready()

    def make(start: float) -> tuple[list[float], list[float], list[float]]:
        return [start, start + 1.0, start], [0.0, 0.0, 0.0], [0.5, 0.5]

    controller.load_by(0, 20.0)
    controller.load_points(0, make, make)
    controller.go([0])
    end = controller.idle_time(0)
    controller.clock.advance(end + 7.5)
    assert controller.position(0) == pytest.approx(21.0)
    controller.stop(0)
    controller.clock.advance(end + 9.0)
    assert controller.is_idle(0)
    assert controller.room(0) == 4


def test_outputs_between_paths_do_not_hold_up_the_run() -> None:
    """Two sides of a square take 1.1 s; the output turns on at the corner, at 0.55 s."""
    controller = ready()
    controller.configure(0, "contour_mode", True)
    controller.configure(0, "contour_angle", 90.0)
    controller.load_line_by((0, 1), (50.0, 0.0))
    controller.load_output(0, {3: 1.0})
    controller.load_pulse(1, 4, 0.1)
    controller.load_line_by((0, 1), (0.0, 50.0))
    controller.go([0, 1])
    corner = controller.crossing_time(0, 50.0)
    assert corner == pytest.approx(0.55)
    controller.clock.advance(0.549)
    assert (controller.output(3), controller.output(4)) == (0, 0)
    controller.clock.advance(0.551)
    assert (controller.output(3), controller.output(4)) == (1, 1)
    assert controller.path_speed(0) == pytest.approx(100.0)
    controller.clock.advance(1.2)
    assert controller.is_idle(0)
    assert controller.is_idle(1)
    assert controller.position(1) == 50.0
    assert controller.log.moves[-1].start_time == pytest.approx(0.55)
