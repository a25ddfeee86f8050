"""Channels of inputs and outputs, and those who follow them."""

from __future__ import annotations

from motionlang.kernel import Machine


def test_a_change_is_no_reading() -> None:
    inputs = Machine().controller.inputs
    read: list[int] = []
    inputs.observer = read.append
    heard: list[float] = []
    inputs.listen(lambda channel, value: heard.append(inputs[channel]))
    inputs[1] = 1
    assert (heard, read) == ([1], [])
    assert inputs[1] == 1
    assert read == [1]
