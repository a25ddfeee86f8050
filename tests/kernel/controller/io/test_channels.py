"""Channels of inputs and outputs, and those who follow them."""

from __future__ import annotations

from motionlang.kernel import Machine


def test_a_change_is_no_reading() -> None:
    controller = Machine().controller
    inputs, read = controller.inputs, list[tuple[str, int]]()
    controller.reads.add(lambda table, number: read.append((table, number)))
    heard: list[float] = []
    inputs.listen(lambda channel, value: heard.append(inputs[channel]))
    inputs[1] = 1
    assert (heard, read) == ([1], [])
    assert inputs[1] == 1
    assert read == [("input", 1)]


def test_each_observer_is_told_of_each_reading() -> None:
    machine = Machine()
    reads, first, second = machine.controller.reads, list[tuple[str, int]](), list[tuple[str, int]]()
    reads.add(lambda table, number: first.append((table, number)))
    assert machine.operator.next_key() == 0  # it joins later
    reads.add(lambda table, number: second.append((table, number)))
    assert machine.controller.analogue_inputs[2] == 0
    assert machine.host.integer("netdata", 5) == 0
    with reads.replaced():
        assert machine.controller.inputs[3] == 0
    assert first == [("key", 1), ("analogue", 2), ("netdata", 5)]
    assert second == first[1:]
