"""Ctrl-C, SIGTERM, SIGHUP and a limit of processor time end a command, with complete output.

Results computed so far are reported.
"""

from __future__ import annotations

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from time import monotonic
from types import FrameType, TracebackType
from typing import TYPE_CHECKING, Any, Self

from motionlang.kernel import OutOfTime, Terminated

if TYPE_CHECKING:
    from motionlang.kernel import Run

NAMES = ("SIGINT", "SIGTERM", "SIGHUP")
# Seconds within which another signal is a duplicate: `timeout` signals its child and the group that it is in.
DUPLICATE_WINDOW = 1.0
# Seconds after which a lost signal is sent again.
AGAIN = 1e-3


class Signals:
    """`with SIGNALS:` turns a signal into KeyboardInterrupt or `Terminated`.

    The exception is raised at once, or at the end of a deferring block. A signal that the parent process has
    disabled, as `nohup` does, stays disabled.
    """

    def __init__(self) -> None:
        self._before: dict[int, Any] = {}
        # The last signal that was raised, the one that waits for the end of a held block, and the lost one.
        self._raised = self._pending = self._lost = 0
        self._depth = 0
        self._since = self._limit = 0.0
        self._hook: Any = None

    def __enter__(self) -> Self:
        self._raised = self._pending = self._lost = self._depth = 0
        for name in NAMES:
            number = getattr(signal, name, None)  # Windows has no SIGHUP
            if number is None or signal.getsignal(number) in (signal.SIG_IGN, None):
                continue
            try:
                self._before[number] = signal.signal(number, self._end)
            except ValueError:  # only a main thread receives signals
                return self
        self._hook, sys.unraisablehook = sys.unraisablehook, self._unraisable
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        while self._before:
            signal.signal(*self._before.popitem())
        if self._hook is not None:
            sys.unraisablehook, self._hook = self._hook, None
        if self._lost:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
            number, self._lost = self._lost, 0
            raise error_of(number)

    @property
    def status(self) -> int:
        """The exit status after the last signal raised; that of Ctrl-C if there was none, or a limit of time."""
        return 128 + (self._raised if self._raised in self._before else signal.SIGINT)

    def end_with(self, result: Run) -> None:
        """Raise the signal that ended a run again, so that it ends the command as well."""
        if result.status == "interrupted":
            raise error_of(self._raised or signal.SIGINT)

    @property
    def deferred(self) -> Deferral:
        """`with SIGNALS.deferred:` completes its block; only a second signal ends it.

        A signal within a second of the first is a duplicate.
        """
        return Deferral(self)

    @contextmanager
    def limited(self, seconds: float) -> Iterator[None]:
        """Raise `OutOfTime` in a block that takes more processor time than this; 0 means no limit.

        Systems without interval timers, such as Windows, have no limit.
        """
        if not seconds or not self._before or not hasattr(signal, "setitimer"):
            yield
            return
        self._limit = seconds
        before = signal.signal(signal.SIGPROF, self._end)
        signal.setitimer(signal.ITIMER_PROF, seconds)
        try:
            yield
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0.0)
            signal.signal(signal.SIGPROF, before)

    def _end(self, number: int, frame: FrameType | None) -> None:
        now = monotonic()
        if self._raised and now - self._since < DUPLICATE_WINDOW:
            return
        first, self._raised, self._since = not self._raised, number, now
        if self._depth and first:
            self._pending = number
            return
        raise OutOfTime(self._limit) if number not in self._before else error_of(number)

    def defer(self) -> None:
        """Begin a block in which the first signal waits for `deliver`."""
        self._depth += 1

    def deliver(self) -> None:
        """End a deferring block; raise the exception of a pending signal."""
        self._depth = max(0, self._depth - 1)
        if self._pending and not self._depth:
            number, self._pending = self._pending, 0
            raise error_of(number)

    def _unraisable(self, lost: Any) -> None:
        """Repeat a signal whose exception Python dropped, such as in an import callback."""
        if not isinstance(lost.exc_value, KeyboardInterrupt | Terminated) or not hasattr(signal, "setitimer"):
            self._hook(lost)
            return
        self._lost, self._raised = self._raised, 0
        signal.signal(signal.SIGALRM, self._come_again)
        signal.setitimer(signal.ITIMER_REAL, AGAIN)

    def _come_again(self, number: int, frame: FrameType | None) -> None:
        number, self._lost = self._lost, 0
        self._end(number, frame)


class Deferral:
    """The context manager of `Signals.deferred`."""

    def __init__(self, signals: Signals) -> None:
        self._signals = signals

    def __enter__(self) -> None:
        self._signals.defer()

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if kind is None:
            self._signals.deliver()


def status_of(error: BaseException) -> int:
    """Return the exit status after a signal: 128 plus its number, like in shells."""
    return 128 + (error.number if isinstance(error, Terminated) else signal.SIGINT)


def error_of(number: int) -> BaseException:
    """Return the exception for a signal number."""
    return KeyboardInterrupt() if number == signal.SIGINT else Terminated(number)


SIGNALS = Signals()
