"""A track and the moves of an axis, cut to an earlier time."""

from __future__ import annotations

import pytest

from motionlang.kernel import Controller


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
    tracks = controller.axes.values()
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
    assert axes[1].profiles[-1] is last
