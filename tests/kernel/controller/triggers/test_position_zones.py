"""Intervals between edges: exact times, wraps, both directions, any motion."""

from __future__ import annotations

from bisect import bisect_right
from functools import partial
from math import floor
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel import Controller
from motionlang.kernel.controller.triggers.position_zones import Cells
from motionlang.kernel.planners.extrapolation import Extrapolated
from motionlang.kernel.planners.rate import Rate
from tests.cases import examples

Crossings = list[tuple[float, int]]


def machine() -> Controller:
    c = Controller(1)
    for name, value in (("speed", 8.0), ("accel", 16.0), ("decel", 16.0)):
        c.configure(0, name, value)
    return c


def watched(c: Controller, edges: tuple[float, ...], **how: Any) -> tuple[Cells, Crossings]:
    crossings: Crossings = []
    cells = Cells(c, c.axes[0], edges, lambda index: crossings.append((c.clock.now, index)), **how)
    return cells, crossings


def test_each_edge_is_reported_when_it_is_reached() -> None:
    c = machine()
    cells, crossings = watched(c, (6.0, 8.0))
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    c.move_to(0, 6.0)
    c.clock.advance(10.0)
    assert [index for _, index in crossings] == [1, 2, 1, 0]
    assert [time for time, _ in crossings[:2]] == pytest.approx([1.0, 1.25])
    assert cells.index == 0


def test_a_move_that_ends_on_one_edge_next_to_another_misses_neither() -> None:
    c = machine()
    _, crossings = watched(c, (11.0, 12.0, 13.0))
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    c.move_to(0, 14.0)
    c.clock.advance(10.0)
    assert [index for _, index in crossings] == [1, 2, 3]


def test_a_new_zero_is_reported() -> None:
    c = machine()
    cells, crossings = watched(c, (6.0, 8.0))
    c.define_position(0, 100.0)
    c.define_position(0, 7.0)
    assert [index for _, index in crossings] == [2, 1]
    cells.remove()
    c.define_position(0, 0.0)
    assert len(crossings) == 2
    assert not c.axes[0].watches
    assert not c.axes[0].followers


def test_physical_edges_stay_where_the_machine_has_them() -> None:
    c = machine()
    _, crossings = watched(c, (6.0,), physical=True)
    c.define_position(0, 100.0)
    c.move_to(0, 112.0)
    c.clock.advance(5.0)
    assert [index for _, index in crossings] == [1]
    assert crossings[0][0] == pytest.approx(1.0)


def test_edges_repeat_in_every_revolution() -> None:
    c = machine()
    _, crossings = watched(c, (1.0, 2.0), period=4.0)
    c.jog(0, -8.0)
    c.clock.advance(2.0)
    assert [index for _, index in crossings][:4] == [-1, -2, -3, -4]
    assert crossings[0][0] == pytest.approx(0.5)  # -2: v = 16 t, 8 t^2 = 2
    assert crossings[2][0] - crossings[0][0] == pytest.approx(0.5)


@pytest.mark.parametrize("lead", [0.125, 0.25])
def test_with_a_lead_an_edge_is_reported_that_much_earlier(lead: float) -> None:
    c = machine()
    cells, crossings = watched(c, (6.0, 10.0), view=partial(Extrapolated, lead=lead))
    c.move_to(0, 20.0)
    c.clock.advance(1.5)
    assert [time for time, _ in crossings] == pytest.approx([1.0 - lead, 1.5 - lead])
    cells.remove()
    assert not c.axes[0].followers


def test_a_velocity_is_reported_when_it_is_reached_and_when_it_drops_at_once() -> None:
    c = machine()
    cells, crossings = watched(c, (4.0,), view=Rate)
    c.move_to(0, 12.0)
    c.clock.advance(5.0)
    c.jog(0, 8.0)
    c.clock.advance(6.0)
    c.abort(0)
    assert [index for _, index in crossings] == [1, 0, 1, 0]
    assert [time for time, _ in crossings] == pytest.approx([0.25, 1.75, 5.25, 6.0])
    cells.remove()


EDGES = st.lists(st.integers(-40, 40), min_size=1, max_size=6, unique=True).map(sorted)
MOVES = st.lists(st.tuples(st.integers(-50, 50), st.integers(1, 60)), min_size=1, max_size=6)


@settings(max_examples=examples(120))
@given(edges=EDGES, moves=MOVES, wraps=st.booleans())
def test_any_motion_is_always_in_the_reported_stretch(
    edges: list[int], moves: list[tuple[int, int]], wraps: bool
) -> None:
    period = 97.0 if wraps else 0.0
    c = machine()
    cells, _ = watched(c, tuple(edge + 0.0 for edge in edges), period=period)
    for target, ticks in moves:
        c.move_to(0, float(target))
        for _ in range(ticks):
            c.clock.advance(c.clock.now + 0.07)
            here = c.position(0)
            revolution = floor((here - edges[0]) / period) if period else 0
            within = here - revolution * period
            if min(abs(within - edge) for edge in (*edges, edges[0] + period)) > 1e-3:
                assert cells.index == revolution * len(edges) + bisect_right(edges, within)
