"""A track and the moves of an axis, cut to an earlier time: before, during and after packing."""

from __future__ import annotations

import pytest

from motionlang.kernel import Controller, WholeTrack
from motionlang.kernel.log import log
from tests.kernel.log.small import shrink


@pytest.fixture(autouse=True)
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pack early."""
    shrink(monkeypatch, left=3, most=12)
    monkeypatch.setattr(log, "FIRST_CHECK", 4)


def moved(controller: Controller, first: int, past: int) -> Controller:
    """Move axis 1 to and fro; axis 0 is on its long way all the time."""
    for k in range(first, past):
        controller.move_to(1, float(k % 2))
        controller.clock.advance(k + 1.0)
    return controller


def started() -> Controller:
    controller = Controller(2)
    controller.configure(0, "speed", 1.0)
    controller.configure(1, "speed", 100.0)
    controller.move_to(0, 1e6)
    return controller


def seen(controller: Controller) -> object:
    moves = [
        (each.axis, each.start_time, each.target, each.ended, each.profile and each.profile.curve)
        for each in controller.log.moves
    ]
    tracks = [WholeTrack(a) for a in controller.axes.values()]
    return moves, [(list(each.starts), [profile.curve for profile in each.profiles]) for each in tracks]


@pytest.mark.parametrize("before", [0, 1, 3, 5, 8, 13, 20])
@pytest.mark.parametrize("added", [0, 1, 6, 40])
def test_track_and_moves_are_cut_and_go_on(before: int, added: int) -> None:
    controller = moved(started(), 0, before)
    moves, axes = controller.log.moves, controller.axes
    expected, long_move, last = seen(controller), axes[0].move, axes[1].profiles[-1]
    extent, extents = moves.extent(), [a.extent() for a in axes.values()]
    moved(controller, before, before + added)
    moves.cut(extent)
    for a, own in zip(axes.values(), extents, strict=True):
        a.cut(own)
    assert seen(controller) == expected
    assert moves[0] is long_move
    assert long_move is not None
    assert moves.number(long_move) == 0
    assert axes[1].profiles[-1] is last


def test_a_move_in_progress_that_was_packed_when_it_had_ended_is_in_progress_again() -> None:
    controller = moved(started(), 0, 2)
    moves, move = controller.log.moves, controller.axes[0].move
    extent = moves.extent()
    controller.stop(0)
    moved(controller, 3, 30)
    assert moves.packed > 1
    moves.cut(extent)
    assert moves[0] is move
    assert len(moves) == 3
