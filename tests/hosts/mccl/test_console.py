"""A console runs its tasks only while a host waits for an answer."""

from __future__ import annotations

from motionlang.hosts.mccl.console import Console
from motionlang.kernel import Machine


def test_a_round_trip_is_one_time_slice() -> None:
    """1TP takes one command of 10 us, and time stops with its answer."""
    console = Console(Machine(first_axis=1))
    port = console.open(echo=False)
    console.settle()
    port.take()
    log = console.machine.log
    before, slices = console.now, len(log.slices)
    for _ in range(20):
        port.feed(b"1TP\r")
        assert console.settle()
        assert port.take() == b"01 0\n>"
    assert console.now - before < 20 * 1.0001e-5
    assert {task for each in list(log.slices)[slices:] for task in each.tasks} == {"port"}
    assert {wait.task for wait in log.waits} == {"port"}
