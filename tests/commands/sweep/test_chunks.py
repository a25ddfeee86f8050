"""Chunks of a sweep: their size, how many are in progress, and those whose worker has died.

The executors of these tests only record what they are given.
"""

from __future__ import annotations

from concurrent.futures import Executor, Future
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.sweep import job, pool
from motionlang.commands.sweep.pool import Chunk, Hand


class Recorded(Executor):
    """An executor that starts nothing; `sizes` are the numbers of variants in its chunks."""

    def __init__(self) -> None:
        self.sizes: list[int] = []

    def submit(self, call: Any, /, *given: Any, **named: Any) -> Future[Any]:
        self.sizes.append(len(given[1]))
        return Future()


def hand(count: int, executor: Recorded | None = None, jobs: int = 2, cost: float = 0.0) -> Any:
    """Return the hand of a sweep of `count` variants; without `executor` it has a pool of its own."""
    of_job: Any = SimpleNamespace(keep=("time", "peak"))
    made: Any = Hand(of_job, ((k, (float(k),)) for k in range(count)), count, executor, jobs)
    made._cost = cost
    made._own = None if executor else Recorded()
    return made


@pytest.mark.parametrize(
    ("left", "cost", "jobs", "size"),
    [
        (1000, 0.0, 2, 4),  # the duration is not known
        (1000, 0.01, 2, 10),  # a tenth of a second
        (1000, 0.03, 2, 3),
        (1000, 0.5, 2, 1),
        (9000, 1e-6, 2, 500),
        (40, 0.001, 2, 10),  # half of the rest, divided among two workers
        (41, 0.001, 2, 11),
        (41, 0.001, 4, 6),
        (1, 0.001, 4, 1),
    ],
)
def test_a_chunk_takes_a_tenth_of_a_second_and_less_towards_the_end(
    left: int, cost: float, jobs: int, size: int
) -> None:
    made = hand(left, jobs=jobs, cost=cost)
    assert [index for index, _ in made._next().variants] == list(range(size))
    assert made._left == left - size


def test_a_pool_of_two_has_six_chunks_in_progress_and_a_given_executor_512() -> None:
    own = hand(10_000)
    assert own._fill()
    assert own._own.sizes == [4] * 6
    given = Recorded()
    assert hand(10_000, given)._fill()
    assert given.sizes == [4] * 512


def test_nothing_is_in_progress_when_nothing_is_left() -> None:
    assert not hand(0)._fill()
    few = hand(3)
    assert few._fill()
    assert few._own.sizes == [1, 1, 1]  # half of the rest for two workers is less than one


def test_a_lost_chunk_runs_alone_when_the_others_are_done() -> None:
    made = hand(10_000)
    made._fill()
    first = next(iter(made._running))
    first.set_exception(OSError())
    assert list(made._taken(first)) == []
    made._fill()
    assert made._own.sizes == [4] * 6
    made._running.clear()
    made._fill()
    made._fill()
    assert made._own.sizes == [4] * 7
    assert [chunk.is_again for chunk in made._running.values()] == [True]
    made._running.clear()
    made._fill()
    assert made._own.sizes == [4] * 13


def test_a_chunk_that_is_lost_twice_is_reported() -> None:
    """If there was no answer so far, the executor does not work."""
    made = hand(10, Recorded())
    chunk = Chunk([(7, ()), (8, ())], is_again=True)
    with pytest.raises(OSError, match="no worker"):
        list(made._failed(chunk, OSError("no worker")))
    made._cost = 0.1
    found = list(made._failed(chunk, OSError("no worker")))
    assert [(index, values) for index, values, _ in found] == [(7, (None, None)), (8, (None, None))]
    assert all("the worker was lost twice: OSError: no worker" in str(problem) for *_, problem in found)


def test_an_interrupt_ends_the_sweep() -> None:
    made = hand(10, Recorded())
    stopped: Future[Any] = Future()
    stopped.set_exception(KeyboardInterrupt())
    made._running[stopped] = Chunk([])
    with pytest.raises(KeyboardInterrupt):
        list(made._taken(stopped))


def test_a_small_sweep_needs_no_other_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Variants run here for 50 ms, and on while the rest takes less than 0.2 s.

    The first one takes 30 ms and each other one 25 ms. After two, 7 of 9 take 0.175 s more, and 10 of 12 take 0.25 s.
    """
    now = 0.0

    def result(variant: tuple[int, object]) -> int:
        nonlocal now
        now += 0.025 if variant[0] else 0.03
        return variant[0]

    monkeypatch.setattr(pool, "worker_of", lambda job: SimpleNamespace(result=result))
    monkeypatch.setattr(pool, "perf_counter", lambda: now)
    for count, jobs, done in ((9, 2, 9), (12, 2, 2), (12, 1, 12), (1, 2, 1)):
        made = hand(count, jobs=jobs)
        assert list(made._alone()) == list(range(done))
        assert made._left == count - done


def test_a_process_keeps_the_workers_of_the_last_eight_jobs(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(job, "_WORKERS", {})
    monkeypatch.setattr(job, "Worker", lambda given: SimpleNamespace(job=given))
    jobs: list[Any] = [SimpleNamespace(digest=str(number)) for number in range(9)]
    first = [job.worker_of(each) for each in jobs[:8]]
    assert [job.worker_of(each) for each in jobs[:8]] == first
    job.worker_of(jobs[8])
    assert list(job._WORKERS) == ["1", "2", "3", "4", "5", "6", "7", "8"]
    assert job.worker_of(jobs[7]) is first[7]
