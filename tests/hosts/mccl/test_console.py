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


def test_a_background_task_runs_on_only_while_a_host_waits() -> None:
    """Task 1 counts every 0.1 s; it has 0.45 s while the port executes WA0.45."""
    console = Console(Machine(first_axis=1))
    port = console.open(echo=False)
    port.feed(b"AL0,AR20\rMD1,RA20,AA1,AR20,WA0.1,RP\r")
    assert console.settle()
    port.feed(b"GT1,WA0.45\r")
    assert console.settle()
    port.take()
    for _ in range(20):
        port.feed(b"TR20\r")
        assert console.settle()
        assert port.take() == b"5\n>"
