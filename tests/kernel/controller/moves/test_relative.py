"""A relative entry of the buffer counts from where its axis is when it starts."""

from __future__ import annotations

import pytest

from tests.kernel.controller.machines import machine, until


def test_a_new_zero_before_the_start_moves_the_end_along() -> None:
    c = machine(1)
    c.load_by(0, 10.0)
    c.define_position(0, 100.0)
    c.go([0])
    until(c, 9.0)
    assert c.position(0) == 110.0


def test_a_new_zero_in_motion_moves_the_ends_of_all_that_waits() -> None:
    c = machine(1, buffer_size=5.0)
    for _ in range(3):
        c.load_by(0, 10.0)
    c.load_to(0, 5.0)
    c.load_by(0, 1.0)
    c.go([0])
    until(c, 0.5)
    c.define_position(0, c.position(0) + 1000.0)
    until(c, 300.0)
    assert [move.target for move in c.log.moves] == pytest.approx([1010.0, 1020.0, 1030.0, 5.0, 6.0])


def test_an_arc_keeps_its_radius_after_a_new_zero() -> None:
    c = machine()
    c.load_arc([0, 1], [10.0, 0.0], 360.0, relative=True)
    c.define_position(0, 100.0)
    c.go([0])
    until(c, 60.0)
    assert (c.position(0), c.position(1)) == (100.0, 0.0)
    low, high = c.log.moves[0].profile.extrema()  # type: ignore[union-attr]
    assert (low, high) == (pytest.approx(100.0), pytest.approx(120.0))


def test_a_line_keeps_its_direction_after_a_new_zero() -> None:
    c = machine()
    c.load_line_by([0, 1], [3.0, 4.0])
    c.define_position(1, -50.0)
    c.go([0])
    until(c, 60.0)
    assert (c.position(0), c.position(1)) == (3.0, -46.0)


def test_what_waits_behind_a_path_that_another_axis_stops_counts_from_its_rest() -> None:
    """At 1 s the path has covered 50 x 1 - 12.5 = 37.5, and brakes over 6.25.

    Axis 0 comes to rest at 0.6 of 43.75.
    """
    c = machine(2, speed=50.0, accel=100.0, decel=200.0)
    c.load_line([0, 1], [60.0, 80.0])
    c.load_by(0, 5.0)
    c.go([0, 1])
    until(c, 1.0)
    c.stop(1)
    until(c, 60.0)
    assert [c.position(0), c.position(1)] == pytest.approx([31.25, 35.0])


def test_a_dwell_before_the_first_move_does_not_move_the_end() -> None:
    c = machine(1, buffer_size=5.0)
    c.load_dwell(0, 0.5)
    c.load_by(0, 10.0)
    c.define_position(0, 100.0)
    c.go([0])
    until(c, 9.0)
    assert c.position(0) == 110.0


def test_a_new_end_leaves_the_ends_of_straight_moves_behind_it() -> None:
    c = machine(2, buffer_size=5.0)
    for step in (20.0, 10.0):
        c.load_by(0, step)
    c.go([0])
    until(c, 0.5)
    c.retarget_by(0, 5.0)
    until(c, 60.0)
    assert [move.target for move in c.log.moves] == [25.0, 30.0]


def test_a_new_end_leaves_the_end_of_a_line_behind_it() -> None:
    c = machine(2, buffer_size=5.0)
    c.load_by(0, 20.0)
    c.load_line_by([0, 1], [10.0, 7.0])
    c.load_by(0, 10.0)
    c.go([0])
    until(c, 0.5)
    c.retarget_by(0, 5.0)
    until(c, 60.0)
    assert (c.position(0), c.position(1)) == (40.0, 7.0)
    assert c.log.moves[1].target == 30.0


def test_a_new_end_carries_an_arc_along() -> None:
    c = machine(2, buffer_size=5.0)
    c.load_by(0, 20.0)
    c.load_arc([0, 1], [10.0, 0.0], 180.0, relative=True)
    c.load_by(0, 10.0)
    c.go([0])
    until(c, 0.5)
    c.retarget_by(0, 5.0)
    until(c, 60.0)
    assert [move.target for move in c.log.moves] == pytest.approx([25.0, 45.0, 0.0, 50.0], abs=1e-9)
    assert c.log.moves[1].profile.distance == pytest.approx(20.0)  # type: ignore[union-attr]
