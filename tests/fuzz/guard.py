"""Detection of interpreter crashes and of exceeded time limits, in this process."""

from __future__ import annotations

import signal
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import ProgramError, Source, dialect
from tests.fuzz.inputs import SUFFIX

# Machine time of a run, and the limit of this process's seconds for such an input.
UNTIL, MAX_SECONDS = 0.5, 20.0


class TooLong(Exception):
    """Raised if an input exceeds the time limit."""


@contextmanager
def bounded(seconds: float) -> Iterator[None]:
    """Raise `TooLong` in the main thread after some seconds of processor time.

    It is raised again every second, because Python ignores the first one if it comes in a `__del__`.
    """

    def end(number: int, frame: FrameType | None) -> None:
        raise TooLong(f"more than {seconds:g} s")

    before = signal.signal(signal.SIGVTALRM, end)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds, 1.0)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, before)


def trouble(name: str, text: str) -> str:
    """Return the error of a program's check or run and its location; "" if none."""
    source = Source(f"fuzz{SUFFIX[name]}", text)
    try:
        with bounded(MAX_SECONDS):
            try:
                check(dialect(name).program(source, {}))
            except ProgramError:
                pass
            run(source, until=UNTIL)
    except Exception as error:
        frames = traceback.extract_tb(error.__traceback__)
        location = " < ".join(
            f"{frame.filename.rpartition('motionlang/')[2]}:{frame.lineno}" for frame in frames[:-4:-1]
        )
        return f"{type(error).__name__}: {str(error)[:200]} at {location}"
    return ""
