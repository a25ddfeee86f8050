"""The status word only reads input channels that the machine or program drives."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.lang.machine.machine import Machine
from motionlang.mccl.axis import inputs
from motionlang.mccl.axis.status import word
from motionlang.mccl.runtime.board import Board

if TYPE_CHECKING:
    import pytest

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
