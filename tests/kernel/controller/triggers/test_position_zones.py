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
