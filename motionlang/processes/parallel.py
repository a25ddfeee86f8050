"""Work on many files at once, on all cores, with results in their order."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")

# With fewer files per process than this, the work is done before a process has started.
_WORTH = 4


def cores() -> int:
    """Return how many processors this process may use."""
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity is not None else os.cpu_count() or 1


def in_parallel(work: Callable[[Item], Result], items: Sequence[Item], jobs: int = 0) -> Iterator[Result]:
    """Yield `work(item)` for each item, in order, computed on `jobs` processes.

    0 jobs means one per core, or fewer for little work. Work and items must be picklable. An exception of the work
    is raised in place of its result.
    """
    jobs = min(jobs, len(items)) or min(cores(), len(items) // _WORTH)
    if jobs <= 1:
        yield from map(work, items)
        return
    from motionlang.processes.workers import Workers

    pool = Workers(jobs)
    try:
        # Not by `map`: it cancels its calls when it is left, and Python 3.11 cannot end the processes of those.
        calls = [pool.submit(work, item) for item in items]
        calls.reverse()
        while calls:
            yield calls.pop().result()
        pool.shutdown()
    except BaseException:
        pool.stop()
        raise
