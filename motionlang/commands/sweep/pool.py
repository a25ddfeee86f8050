"""The variants of a sweep on an executor, in chunks.

Rows are reported as they arrive. The executor, a pool of processes on this machine or a cluster's, decides where a
chunk runs. A chunk whose worker has died is tried once more, alone, so that it takes no other with it; then its
variants are reported as lost.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from dataclasses import dataclass
from itertools import islice
from time import perf_counter

from motionlang.commands.sweep.job import Result, SweepJob, Variant, problem_of, work, worker_of
from motionlang.kernel import Diagnostic
from motionlang.processes.workers import Workers

# Seconds that a chunk should take; that this process works alone before it starts others; that all the rest
# may take without them.
CHUNK, ALONE, WORTH = 0.1, 0.05, 0.2
# Maximum variants in a chunk, and before their duration is known.
MAX_VARIANTS, FIRST_VARIANTS = 500, 4
# Maximum chunks in progress: of an executor with an unknown number of workers, and for each process of our
# own pool.
MAX_AHEAD, AHEAD = 512, 3


@dataclass
class VariantChunk:
    """Some variants; `is_again` is true if their worker has died before."""

    variants: Sequence[Variant]
    is_again: bool = False


class Hand:
    """Submits the variants of a job; `rows` yields each row once, in order of arrival."""

    def __init__(
        self, job: SweepJob, variants: Iterator[Variant], count: int, executor: Executor | None, jobs: int
    ) -> None:
        self._job, self._variants, self._left = job, variants, count
        self._given, self._jobs = executor, jobs
        self._own: Workers | None = None
        self._lost: deque[VariantChunk] = deque()
        self._running: dict[Future[tuple[float, list[Result]]], VariantChunk] = {}
        # Seconds that a variant took, for the size of chunks; 0 before the first one.
        self._cost = 0.0

    def rows(self) -> Iterator[Result]:
        """Yield every row once.

        An exception that the executor raises for the first chunk twice is passed on: it does not work at all.
        """
        if self._given is None:
            yield from self._alone()
        try:
            while self._fill():
                done, _ = wait(self._running, return_when=FIRST_COMPLETED)
                for future in done:
                    yield from self._taken(future)
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

    def _fill(self) -> bool:
        """Keep enough chunks in progress; False if nothing remains."""
        ahead = MAX_AHEAD if self._given is not None else AHEAD * self._jobs
        while len(self._running) < ahead and (chunk := self._next()) is not None:
            self._running[self._submit(chunk)] = chunk
        return bool(self._running)

    def _next(self) -> VariantChunk | None:
        if self._lost or any(chunk.is_again for chunk in self._running.values()):
            return None if self._running else self._lost.popleft()
        variants = list(islice(self._variants, self._size()))
        self._left -= len(variants)
        return VariantChunk(variants) if variants else None

    def _size(self) -> int:
        """Return the number of variants in a chunk.

        A chunk takes a tenth of a second, less towards the end so that all workers finish together.
        """
        size = int(CHUNK / self._cost) if self._cost else FIRST_VARIANTS
        return max(1, min(size, MAX_VARIANTS, -(-self._left // (2 * self._jobs))))

    def _submit(self, chunk: VariantChunk) -> Future[tuple[float, list[Result]]]:
        if self._given is not None:
            return self._given.submit(work, self._job, chunk.variants)
        if self._own is None:
            self._own = Workers(min(self._jobs, len(chunk.variants) + self._left))
        try:
            return self._own.submit(work, self._job, chunk.variants)
        except BrokenExecutor:  # a worker has died: the pool is made anew
            self._own.shutdown(wait=False)
            self._own = Workers(self._jobs)
            return self._own.submit(work, self._job, chunk.variants)

    def _taken(self, future: Future[tuple[float, list[Result]]]) -> Iterator[Result]:
        chunk = self._running.pop(future)
        try:
            seconds, rows = future.result()
        except Exception as error:
            yield from self._failed(chunk, error)
            return
        self._cost = seconds / len(rows)
        yield from rows

    def _failed(self, chunk: VariantChunk, error: Exception) -> Iterator[Result]:
        """Keep a chunk for another attempt, or yield its variants as lost."""
        if not chunk.is_again:
            self._lost.append(VariantChunk(chunk.variants, is_again=True))
            return
        if not self._cost:
            raise error
        lost = Diagnostic("crash", f"the worker was lost twice: {type(error).__name__}: {error}")
        for index, _ in chunk.variants:
            yield index, (None,) * len(self._job.keep), problem_of([lost])

    def _stop(self) -> None:
        """Cancel the chunks in progress; a caller's executor keeps running."""
        if self._own is not None:
            self._own.stop()
        for future in self._running if self._given is not None else ():
            future.cancel()
        self._running.clear()
