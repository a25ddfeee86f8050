"""Inputs of the machine file that follow the position of an axis: exact times, both directions, any motion."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel import Controller, Machine
from tests.cases import examples

FIRST = 10  # the channel of the first zone


def machine(edges: list[float], **more: object) -> Controller:
    """Return an axis with an input for each zone between two edges."""
    zones = [
        {"channel": FIRST + k, "axis": 0, "between": list(zone), **more}
        for k, zone in enumerate(pairwise(edges))
    ]
    c = Machine({"controller.axes": 1, "input": zones}).controller
    for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
        c.configure(0, name, value)
    return c


def changes(c: Controller) -> list[tuple[float, int, float]]:
    return [(time, channel - FIRST, value) for time, channel, value in c.log.inputs]


def test_each_edge_is_passed_at_its_time_in_both_directions() -> None:
    """From 12 back to 6, which is the edge of the first zone."""
    c = machine([6.0, 8.0, 10.0])
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    c.move_to(0, 6.0)
    c.clock.advance(10.0)
    found = changes(c)
    assert [value for _, zone, value in found if zone == 0] == [1, 0, 1, 0]
    assert [value for _, zone, value in found if zone == 1] == [1, 0, 1, 0]
    assert [time for time, *_ in found[:2]] == pytest.approx([1.0, 1.25])


def test_a_move_that_ends_on_one_edge_next_to_another_misses_neither() -> None:
    c = machine([11.0, 12.0, 13.0])
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    c.move_to(0, 14.0)
    c.clock.advance(10.0)
    assert [each[1:] for each in changes(c)] == [(0, 1), (0, 0), (1, 1), (1, 0)]


def test_edges_stay_where_the_machine_has_them() -> None:
    c = machine([6.0, 50.0])
    c.define_position(0, 100.0)
    c.move_to(0, 112.0)
    c.clock.advance(5.0)
    ((time, zone, value),) = changes(c)
    assert (zone, value) == (0, 1)
    assert time == pytest.approx(1.0)


def test_a_new_position_at_rest_passes_no_edge_and_a_motion_back_passes_all() -> None:
    c = machine([1.0, 2.0], every=4.0, times=3)
    c.jog(0, 8.0)
    c.clock.advance(2.0)
    assert [value for *_, value in changes(c)] == [1, 0, 1, 0, 1, 0]
    assert changes(c)[0][0] == pytest.approx((2.0 * 1.0 / 16.0) ** 0.5)
    c.jog(0, -8.0)
    c.clock.advance(9.0)
    assert [value for *_, value in changes(c)] == [1, 0] * 6


# No edge is where the axis begins or where a move ends.
EDGES = st.lists(st.integers(-40, 40).filter(bool), min_size=2, max_size=6, unique=True).map(sorted)
MOVES = st.lists(st.tuples(st.integers(-50, 50), st.integers(1, 60)), min_size=1, max_size=6)


@settings(max_examples=examples(120))
@given(EDGES, MOVES)
def test_any_motion_is_always_in_the_zone_that_is_on(edges: list[int], moves: list[tuple[int, int]]) -> None:
    c = machine([float(edge) for edge in edges])
    for target, ticks in moves:
        c.move_to(0, target + 0.5)
        for _ in range(ticks):
            c.clock.advance(c.clock.now + 0.07)
            here = c.position(0)
            if min(abs(here - edge) for edge in edges) > 1e-3:
                on = [c.inputs[FIRST + k] for k in range(len(edges) - 1)]
                assert on == [int(a < here < b) for a, b in pairwise(edges)]
