"""The variants of a sweep on an executor, in chunks, with retries.

Rows are reported as they arrive. The executor, a pool of processes on this machine or a cluster's, decides
where a chunk runs.
"""

from __future__ import annotations

from collections import deque
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from time import perf_counter

from motionlang.analysis.sweeps.job import problem_of, work, worker_of
from motionlang.errors import Diagnostic
from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from motionlang.analysis.sweeps.job import Job, Result, Variant
    from motionlang.analysis.workers import Workers

# Seconds that a chunk should take; that this process works alone before it starts others; that all the rest
# may take without them.
CHUNK, ALONE, WORTH = 0.1, 0.05, 0.2
# Maximum variants in a chunk, and before their duration is known.
MAX_VARIANTS, FIRST_VARIANTS = 500, 4
# Maximum chunks in progress: of an executor with an unknown number of workers, and for each process of our
# own pool.
MAX_AHEAD, AHEAD = 512, 3
# Times that a chunk is submitted, the last of them in single variants, before these are reported as lost.
TRIES, WHOLE_TRIES = 5, 2


@record
class _Chunk:
    variants: Sequence[Variant]
    tries: int = 0


class Hand:
    """Submits the variants of a job; `rows` yields each row once, in order of arrival."""

    def __init__(
        self, job: Job, variants: Iterator[Variant], count: int, executor: Executor | None, jobs: int
    ) -> None:
        self._job, self._variants, self._left = job, variants, count
        self._given, self._jobs = executor, jobs
        self._own: Workers | None = None
        self._again: deque[_Chunk] = deque()
        self._running: dict[Future[tuple[str, float, list[Result]]], _Chunk] = {}
        self._seen: set[str] = set()
        # Seconds that a variant took, for the size of chunks.
        self._cost = 0.0
        self._worked = False

    def rows(self) -> Iterator[Result]:
        """Yield every row once.

        Exceptions that the executor raises for the first chunks of an attempt are passed on.
        """
        if self._given is None:
            yield from self._alone()
            if not self._left:
                return
            self._start(min(self._jobs, self._left))
        try:
            yield from self._from_others()
        except BaseException:
            self._stop()
            raise
        if self._own is not None:
            self._own.shutdown()

    def _alone(self) -> Iterator[Result]:
        """Yield the first rows, computed in this process.

        A small sweep needs no other process, and the workers of a pool that forks inherit the compiled
        program.
        """
        worker, began, done = worker_of(self._job), perf_counter(), 0
        while self._left and (
            self._jobs == 1 or perf_counter() - began < ALONE or 0.0 < self._cost * self._left < WORTH
        ):
            result = worker.result(next(self._variants))
            self._left -= 1
            done += 1
            # The first variant compiles the program, so its time does not predict the others.
            if done == 1:
                first = perf_counter()
            else:
                self._cost = (perf_counter() - first) / (done - 1)
            yield result

    def _from_others(self) -> Iterator[Result]:
        while self._fill():
            done, _ = wait(self._running, return_when=FIRST_COMPLETED)
            for future in done:
                yield from self._taken(future)

    def _fill(self) -> bool:
        """Keep enough chunks in progress; False if nothing remains."""
        ahead = MAX_AHEAD if self._given is not None else AHEAD * self._jobs
        suspects = any(chunk.tries for chunk in self._running.values())
        while len(self._running) < ahead and not (suspects and self._given is None):
            chunk = self._next()
            if chunk is None:
                break
            executor = self._own if self._given is None else self._given
            assert executor is not None
            try:
                future = executor.submit(work, self._job, chunk.variants)
            except BrokenExecutor:
                if self._given is not None:
                    raise
                self._again.appendleft(chunk)
                executor.shutdown(wait=False)
                self._start(self._jobs)
                continue
            self._running[future] = chunk
            # A chunk that has ended a process of our own pool runs alone, so that it affects no other.
            suspects = bool(chunk.tries) and self._given is None
        return bool(self._running)

    def _next(self) -> _Chunk | None:
        if self._again and not (self._given is None and self._again[0].tries and self._running):
            return self._again.popleft()
        if self._again or not self._left:
            return None
        count = self._size()
        self._left -= count
        return _Chunk([next(self._variants) for _ in range(count)])

    def _size(self) -> int:
        """Return the number of variants in a chunk.

        A chunk takes a tenth of a second, less towards the end so that all workers finish together.
        """
        size = int(CHUNK / self._cost) if self._cost else FIRST_VARIANTS
        workers = max(self._jobs if self._given is None else 1, len(self._seen))
        return max(1, min(size, MAX_VARIANTS, -(-self._left // (2 * workers)), self._left))

    def _taken(self, future: Future[tuple[str, float, list[Result]]]) -> Iterator[Result]:
        chunk = self._running.pop(future)
        try:
            who, seconds, rows = future.result()
        except (KeyboardInterrupt, SystemExit):
            raise
        except (Exception, CancelledError) as error:
            yield from self._failed(chunk, error)
            return
        self._worked = True
        self._seen.add(who)
        if rows:
            self._cost = seconds / len(rows)
        yield from rows

    def _failed(self, chunk: _Chunk, error: BaseException) -> Iterator[Result]:
        """Retry a chunk whose worker died or never started, finally variant by variant."""
        tries = chunk.tries + 1
        if tries >= TRIES:
            if not self._worked:
                raise error
            lost = Diagnostic("crash", f"the worker was lost {tries} times: {type(error).__name__}: {error}")
            for index, _ in chunk.variants:
                yield index, (None,) * len(self._job.keep), problem_of([lost])
        elif len(chunk.variants) > 1 and (self._given is None or tries >= WHOLE_TRIES):
            self._again.extend(_Chunk([variant], tries) for variant in chunk.variants)
        else:
            self._again.append(_Chunk(chunk.variants, tries))

    def _start(self, jobs: int) -> None:
        """Start a pool of our own."""
        from motionlang.analysis.workers import Workers

        self._own = Workers(jobs)

    def _stop(self) -> None:
        """Cancel the chunks in progress; a caller's executor keeps running."""
        if self._own is not None:
            self._own.stop()
        for future in self._running if self._given is not None else ():
            future.cancel()
        self._running.clear()
