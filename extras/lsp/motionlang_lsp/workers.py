"""The workers of a language server: a separate process, or this one.

A server requests one job at a time. A check that takes too long, or a process that dies, gives no result; the next job
gets a new process.
"""

from __future__ import annotations

import _thread
import asyncio
import os
import sys
import threading
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor
from typing import Protocol

from motionlang_lsp.editor.times import NO_TIMES
from motionlang_lsp.jobs import TIMES, Job, Result, work


class StoppableExecutor(Protocol):
    """An executor whose processes can be killed."""

    def stop(self) -> None: ...


# Wall time that a run for hints may take, s. The times up to then are its result.
RUN_LIMIT = 2.0
# Wall time after which a job is given up and its process ended, s.
JOB_LIMIT = 20.0


class Inline:
    """Carries out jobs in the process of the server, as required in a browser."""

    async def do(self, job: Job) -> Result | None:
        """Return the result of a job."""
        return work(job)

    def stop(self) -> None:
        """Do nothing: there is no process."""


class WorkerProcess:
    """Carries out jobs in a separate process, which ends with this one."""

    def __init__(self, limit: float = JOB_LIMIT, run_limit: float = RUN_LIMIT) -> None:
        self._limit, self._run_limit = limit, run_limit
        self._workers: Executor | None = None

    async def do(self, job: Job) -> Result | None:
        """Return the result of a job, None if there is none."""
        from motionlang.processes.workers import Workers

        if self._workers is None:
            self._workers = Workers(1)
        try:
            future = self._workers.submit(_limited, job, self._run_limit)
            return await asyncio.wait_for(asyncio.wrap_future(future), self._limit)
        except (BrokenExecutor, TimeoutError):
            self.stop()
            return None

    def stop(self) -> None:
        """End the process."""
        workers, self._workers = self._workers, None
        if workers is not None:
            stopping: StoppableExecutor = workers  # type: ignore[assignment]
            stopping.stop()


def _limited(job: Job, limit: float) -> Result:
    """Carry out a job in a worker process; interrupt a run after `limit` seconds."""
    _silence()
    if job.what != TIMES:
        return work(job)
    timer = threading.Timer(limit, _thread.interrupt_main)
    timer.daemon = True
    return _interruptible(lambda: work(job), timer)


def _interruptible(action: Callable[[], Result], timer: threading.Timer) -> Result:
    """Run an action that a timer interrupts like Ctrl-C."""
    import signal

    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        timer.start()
        try:
            return action()
        finally:
            timer.cancel()
            timer.join()
    except KeyboardInterrupt:  # not during the run, which has results up to then
        return NO_TIMES
    finally:
        signal.signal(signal.SIGINT, signal.SIG_IGN)


def _silence() -> None:
    """Detach a worker from the streams of the server, which carry the protocol."""
    if getattr(sys, "_motionlang_silent", False):
        return
    null = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1):
        os.dup2(null, number)
    os.close(null)
    sys._motionlang_silent = True  # type: ignore[attr-defined]
