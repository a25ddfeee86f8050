"""Chunks of a sweep: their size, how many are in progress, and lost workers.

The executors of these tests only record what they are given.
"""

from __future__ import annotations

from concurrent.futures import Executor, Future
from concurrent.futures.process import BrokenProcessPool
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.analysis.sweeps import job, pool
from motionlang.analysis.sweeps.pool import Hand, _Chunk


class Recorded(Executor):
    """An executor that starts nothing.

    `sizes` are the numbers of variants in its chunks.
    """

    def __init__(self, broken: int = 0) -> None:
        self.sizes: list[int] = []
        self.broken = broken

    def submit(self, call: Any, /, *given: Any, **named: Any) -> Future[Any]:
        if self.broken:
            self.broken -= 1
            raise BrokenProcessPool
        self.sizes.append(len(given[1]))
        return Future()


def hand(count: int, executor: Recorded | None = None, jobs: int = 2, cost: float = 0.0) -> Any:
    """Return the hand of a sweep of `count` variants.

    Without `executor` it has a pool of its own.
    """
    job: Any = SimpleNamespace(keep=("time", "peak"))
    made: Any = Hand(job, ((k, (float(k),)) for k in range(count)), count, executor, jobs)
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
        (2, 0.001, 1, 1),
        (1, 0.001, 4, 1),
    ],
)
def test_a_chunk_takes_a_tenth_of_a_second_and_less_towards_the_end(
    left: int, cost: float, jobs: int, size: int
) -> None:
    assert hand(left, jobs=jobs, cost=cost)._size() == size


@pytest.mark.parametrize(("seen", "size"), [(0, 20), (1, 20), (4, 5)])
def test_a_given_executor_has_the_workers_that_have_answered(seen: int, size: int) -> None:
    """Of 40 variants half are divided among them."""
    made = hand(40, Recorded(), jobs=2, cost=0.001)
    made._seen = {f"worker {k}" for k in range(seen)}
    assert made._size() == size


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


@pytest.mark.parametrize(
    ("is_given", "tries", "sizes"),
    [
        (False, 0, [1, 4, 4, 4, 4, 4]),
        (False, 1, [1]),  # a chunk that has ended a process of our own pool runs alone
        (True, 1, [1] + [4] * 511),
    ],
)
def test_a_chunk_is_tried_again_before_others(is_given: bool, tries: int, sizes: list[int]) -> None:
    executor = Recorded()
    made = hand(10_000, executor if is_given else None)
    made._again.append(_Chunk([(0, (0.0,))], tries))
    made._fill()
    assert (executor if is_given else made._own).sizes == sizes
    made._fill()
    assert (executor if is_given else made._own).sizes == sizes


def test_a_suspect_waits_until_the_others_are_done() -> None:
    made = hand(10_000)
    made._fill()
    made._again.append(_Chunk([(0, (0.0,))], 1))
    made._running.popitem()
    made._fill()
    assert len(made._own.sizes) == 6
    made._running.clear()
    made._fill()
    assert made._own.sizes == [4] * 6 + [1]


def test_a_broken_pool_is_started_again_and_a_given_executor_is_not(monkeypatch: pytest.MonkeyPatch) -> None:
    """The chunk that could not be submitted is the first one of the new pool."""
    made, fresh = hand(10, cost=0.05), Recorded()
    made._own = Recorded(broken=1)
    monkeypatch.setattr(made, "_start", lambda jobs: setattr(made, "_own", fresh))
    assert made._fill()
    assert fresh.sizes[0] == 2
    assert [index for index, _ in next(iter(made._running.values())).variants] == [0, 1]
    with pytest.raises(BrokenProcessPool):
        hand(10, Recorded(broken=1))._fill()


@pytest.mark.parametrize(
    ("is_given", "tries", "chunks"),
    [
        (False, 0, [([0], 1), ([1], 1), ([2], 1)]),  # our own pool: variant by variant at once
        (True, 0, [([0, 1, 2], 1)]),
        (True, 1, [([0], 2), ([1], 2), ([2], 2)]),
        (True, 3, [([0], 4), ([1], 4), ([2], 4)]),
    ],
)
def test_a_chunk_of_a_lost_worker_is_divided(
    is_given: bool, tries: int, chunks: list[tuple[list[int], int]]
) -> None:
    made = hand(10, Recorded() if is_given else None)
    assert list(made._failed(_Chunk([(k, ()) for k in range(3)], tries), OSError())) == []
    assert [([index for index, _ in each.variants], each.tries) for each in made._again] == chunks


def test_a_variant_that_was_tried_five_times_is_lost() -> None:
    """Without any answer so far, the executor does not work."""
    made = hand(10, Recorded())
    chunk = _Chunk([(7, ())], 4)
    with pytest.raises(OSError, match="no worker"):
        list(made._failed(chunk, OSError("no worker")))
    made._worked = True
    ((index, values, problem),) = made._failed(chunk, OSError("no worker"))
    assert (index, values) == (7, (None, None))
    assert "the worker was lost 5 times: OSError: no worker" in str(problem)
    assert list(made._failed(_Chunk([(7, ())], 3), OSError())) == []
    assert [each.tries for each in made._again] == [4]


def test_rows_teach_how_long_a_variant_takes() -> None:
    made = hand(10, Recorded())
    for rows, cost in (([(0, ()), (1, ())], 0.25), ([], 0.25)):
        future: Future[Any] = Future()
        future.set_result(("worker", 0.5, rows))
        made._running[future] = _Chunk([])
        assert list(made._taken(future)) == rows
        assert (made._cost, made._seen, made._worked) == (cost, {"worker"}, True)
    stopped: Future[Any] = Future()
    stopped.set_exception(KeyboardInterrupt())
    made._running[stopped] = _Chunk([])
    with pytest.raises(KeyboardInterrupt):
        list(made._taken(stopped))
    assert made._running == {}


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
