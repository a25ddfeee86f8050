"""The status word only reads input channels that the machine or program drives."""

from __future__ import annotations

from math import inf

import pytest

from motionlang.kernel import Machine
from motionlang.kernel.log import Move
from motionlang.kernel.mccl import Board
from motionlang.kernel.mccl.axis import inputs
from motionlang.kernel.mccl.axis.status import word
from motionlang.kernel.planners import plan_velocity

HOME = inputs.channel_of(1, "home")


def test_undriven_channels_are_not_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    board = Board(Machine(first_axis=1))
    asked: list[str] = []

    def channel(_board: object, _axis: object, name: str) -> bool:
        asked.append(name)
        return False

    monkeypatch.setattr(inputs, "is_channel_active", channel)
    word(board, board.axes[1], 0)
    assert asked == []
    board.controller.inputs[HOME] = 1
    word(board, board.axes[1], 0)
    assert "home" in asked


def test_an_input_of_the_program_is_on_while_it_is_driven() -> None:
    board = Board(Machine(first_axis=1))
    axis, found = board.axes[1], []
    for level in (0, 1, 0):
        board.controller.inputs[HOME] = level
        found.append(inputs.is_active(board, axis, "home"))
    assert found == [False, True, False]


@pytest.mark.parametrize("velocity", [100.0, -100.0])
@pytest.mark.parametrize(
    ("position", "is_on", "up", "down"),
    [
        (250.0, True, 250.5, 249.5),
        (250.4, True, 250.5, 249.5),
        (249.6, True, 250.5, 249.5),
        (250.6, False, 349.5, 250.5),
        (299.0, False, 349.5, 250.5),
        (301.0, False, 349.5, 250.5),
        (349.0, False, 349.5, 250.5),
        (30.0, False, 49.5, -49.5),
    ],
)
def test_the_index_is_on_at_a_mark_until_its_edge(
    velocity: float, position: float, is_on: bool, up: float, down: float
) -> None:
    """Marks are 1 count wide and every 100 counts, one of them at 7 + 43.

    The axis runs at 100 counts/s.
    """
    board = Board(Machine(first_axis=1))
    axis, a = board.axes[1], board.controller.axes[1]
    assert inputs.index_input(board, axis) == (False, inf)  # an encoder without marks
    a.index_every, a.datum, a.index_origin = 100.0, 7.0, 43.0
    profile = plan_velocity("trapezoid", position, velocity, velocity, 1000.0, 1000.0)
    assert inputs.index_input(board, axis)[1] == inf
    board.controller.run_profile(a, Move(1, "JOG", 0, profile.end), profile)
    now_on, until = inputs.index_input(board, axis)
    assert now_on is is_on
    edge = up if velocity > 0.0 else down
    assert until == pytest.approx((edge - position) / velocity)
