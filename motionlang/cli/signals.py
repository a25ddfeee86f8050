"""Ctrl-C, SIGTERM and SIGHUP as the end of a command: what was computed is reported, and nothing is shown by halves."""

from __future__ import annotations

import signal
import sys
from time import monotonic

from motionlang.errors import Terminated

TYPE_CHECKING = False
if TYPE_CHECKING:
    from types import FrameType, TracebackType
    from typing import Any, Self

NAMES = ("SIGINT", "SIGTERM", "SIGHUP")
# Seconds within which a further signal is the same wish: `timeout` tells its child, and the group that it is in.
ONE_WISH = 1.0
# Seconds after which a signal that was lost is sent again.
AGAIN = 1e-3


class Signals:
    """`with SIGNALS:` turns a signal into KeyboardInterrupt or `Terminated`, at once or at the end of what is held.

    A signal that whoever started us has switched off, as `nohup` does, stays off.
    """

    __slots__ = ("_asked", "_before", "_held", "_hook", "_lost", "_pending", "_since")

    def __init__(self) -> None:
        self._before: dict[int, Any] = {}
        # The last signal that was heeded, the one that waits for the end of what is held, the one that got lost.
        self._asked = self._pending = self._lost = 0
        self._held = 0
        self._since = 0.0
        self._hook: Any = None

    def __enter__(self) -> Self:
        self._asked = self._pending = self._lost = self._held = 0
        for name in NAMES:
            number = getattr(signal, name, None)  # Windows knows no SIGHUP
            if number is None or signal.getsignal(number) in (signal.SIG_IGN, None):
                continue
            try:
                self._before[number] = signal.signal(number, self._end)
            except ValueError:  # only a main thread hears of signals
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

    @property
    def status(self) -> int:
        """The exit status after the signal that was heeded last; of Ctrl-C where somebody else's handler heard it."""
        return 128 + (self._asked or signal.SIGINT)

    @property
    def held(self) -> Held:
        """`with SIGNALS.held:` lets what is in it come to its end; a second wish, a second later, ends that, too."""
        return Held(self)

    def _end(self, number: int, frame: FrameType | None) -> None:
        now = monotonic()
        if self._asked and now - self._since < ONE_WISH:
            return
        first, self._asked, self._since = not self._asked, number, now
        if self._held and first:
            self._pending = number
            return
        raise error_of(number)

    def let_go(self) -> None:
        """The end of what was held: a signal that came meanwhile counts now."""
        self._held = max(0, self._held - 1)
        if self._pending and not self._held:
            number, self._pending = self._pending, 0
            raise error_of(number)

    def hold(self) -> None:
        self._held += 1

    def _unraisable(self, lost: Any) -> None:
        """Python drops what is raised where nothing can be, as in a callback of its imports: the signal comes again."""
        if not isinstance(lost.exc_value, KeyboardInterrupt | Terminated) or not hasattr(signal, "setitimer"):
            self._hook(lost)
            return
        self._lost, self._asked = self._asked, 0
        signal.signal(signal.SIGALRM, self._come_again)
        signal.setitimer(signal.ITIMER_REAL, AGAIN)

    def _come_again(self, number: int, frame: FrameType | None) -> None:
        self._end(self._lost, frame)


class Held:
    """What `Signals.held` answers."""

    __slots__ = ("_signals",)

    def __init__(self, signals: Signals) -> None:
        self._signals = signals

    def __enter__(self) -> None:
        self._signals.hold()

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if kind is None:
            self._signals.let_go()


def status_of(error: BaseException) -> int:
    """The exit status of a command that a signal ended: 128 and its number, as shells have it."""
    return 128 + (error.number if isinstance(error, Terminated) else signal.SIGINT)


def error_of(number: int) -> BaseException:
    """What a signal raises."""
    return KeyboardInterrupt() if number == signal.SIGINT else Terminated(number)


SIGNALS = Signals()
