"""Many files at once, on all cores: the same work for each, the results in the order of the files."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar

from motionlang.analysis.sweeps.cores import cores

if TYPE_CHECKING:
    from argparse import ArgumentParser
    from collections.abc import Callable, Iterator, Sequence

    Item = TypeVar("Item")
    Result = TypeVar("Result")

# Fewer files than this for each process are done before a process has begun.
_WORTH = 4


def in_parallel(work: Callable[[Item], Result], items: Sequence[Item], jobs: int = 0) -> Iterator[Result]:
    """`work` of each item, in their order; `jobs` processes, 0 for as many as there are cores and work for.

    Work and items must be what another process can be sent. What work raises is raised where its result was due.
    """
    jobs = min(jobs, len(items)) or min(cores(), len(items) // _WORTH)
    if jobs <= 1:
        yield from map(work, items)
        return
    from motionlang.analysis.workers import Workers

    pool = Workers(jobs)
    try:
        yield from pool.map(work, items)
    except BaseException:
        pool.stop()
        raise
    pool.shutdown()


def add_jobs(parser: ArgumentParser) -> None:
    """The option of commands that take many files."""
    parser.add_argument(
        "--jobs",
        metavar="N",
        type=_jobs,
        default=0,
        help="processes at once; without it as many as there are cores",
    )


def _jobs(text: str) -> int:
    import argparse

    if not text.isdecimal() or not 1 <= int(text) <= 1024:
        raise argparse.ArgumentTypeError(f"{text!r} is no number of processes from 1 to 1024")
    return int(text)
