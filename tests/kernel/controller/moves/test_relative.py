"""A relative entry of the buffer counts from where its axis is when it starts."""

from __future__ import annotations

import pytest

from tests.kernel.controller.machines import machine, until


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
