"""Worker processes of this machine, which end with the process that started them.

A worker cannot rely on the end of its input: every worker inherits the writing ends of the pipes of its
siblings, so the pipes stay open. A thread of each worker therefore waits for the end of the parent, by
a file descriptor of `multiprocessing`, and ends the process. Signals that end a command are blocked while
processes start: a signal between a fork and its record would leave a process that the pool does not know.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing.connection import wait
from multiprocessing.process import BaseProcess
from typing import Any, ParamSpec, TypeVar

P = ParamSpec("P")
T = TypeVar("T")

# The signals that end a command; Windows has no SIGHUP.
_ENDING = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]


class Workers(ProcessPoolExecutor):
    """An executor of `jobs` processes; if forking is safe they inherit the program."""

    def __init__(self, jobs: int) -> None:
        fork = hasattr(os, "fork") and os.uname().sysname == "Linux" and threading.active_count() == 1
        super().__init__(jobs, multiprocessing.get_context("fork" if fork else "spawn"), _begin)

    def submit(self, fn: Callable[P, T], /, *args: P.args, **kwargs: P.kwargs) -> Future[T]:
        """Schedule a call, starting processes if necessary."""
        with _signals_put_off():
            return super().submit(fn, *args, **kwargs)

    def stop(self) -> None:
        """End all processes now; their results are lost."""
        # Python 3.11 fails to cancel calls while a pool ends, so the processes end first.
        processes: dict[int, Any] = getattr(self, "_processes", None) or {}
        for process in list(processes.values()):
            process.terminate()
        self.shutdown(wait=True)


@contextmanager
def _signals_put_off() -> Iterator[None]:
    """Delay signals that end a command until after the block.

    Processes started in the block inherit the blocked signals.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, _ENDING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begin() -> None:
    """Prepare a worker: unblock signals, ignore Ctrl-C, and end with the parent."""
    for number in _ENDING:
        signal.signal(number, signal.SIG_IGN if number == signal.SIGINT else signal.SIG_DFL)
    parent = multiprocessing.parent_process()
    assert parent is not None
    threading.Thread(target=_end_with, args=(parent,), daemon=True).start()
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, _ENDING)


def _end_with(parent: BaseProcess) -> None:
    wait([parent.sentinel])
    os._exit(1)
