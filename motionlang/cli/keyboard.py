"""A person at the keyboard of a run in real time: keys reach the program as they are pressed, lines when it asks."""

from __future__ import annotations

import os
import select
import sys
from contextlib import contextmanager
from typing import TYPE_CHECKING, TypeVar

from motionlang.serve.outside import PATIENCE, RealTime

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

Result = TypeVar("Result")
# Bytes read at once.
CHUNK = 1024


class Keyboard(RealTime):
    """Real time, and whatever can be read from `file` in the meantime is typed by the operator."""

    def __init__(self, file: int, factor: float = 1.0) -> None:
        super().__init__(factor)
        self._file: int | None = file

    def _sleep(self, seconds: float) -> None:
        sys.stdout.flush()
        if self._file is None:
            super()._sleep(seconds)
            return
        if not select.select([self._file], [], [], max(0.0, min(seconds, PATIENCE)))[0]:
            return
        text = os.read(self._file, CHUNK)
        if not text:
            self._file = None  # nobody is there any more
            return
        self.ask(lambda: self._type(text.decode("latin-1")))

    def may_act(self) -> bool:
        """Only a program that listens to the keyboard can be helped by it."""
        assert self.machine is not None
        return self._file is not None and self.machine.has_operator

    def _type(self, text: str) -> None:
        assert self.machine is not None
        self.machine.operator.type(text)


def run_live(run: Callable[[Keyboard | None], Result], factor: float) -> Result:
    """What `run` makes of a keyboard, or of none where nobody sits at one."""
    if not is_live():
        return run(None)
    file = sys.stdin.fileno()
    with single_keys(file):
        return run(Keyboard(file, factor))


def is_live() -> bool:
    """Whether a person sits at the keyboard of a terminal that tells of single keys."""
    if not sys.stdin.isatty():
        return False
    try:
        import termios  # noqa: F401 - Windows has none
    except ImportError:
        return False
    return True


@contextmanager
def single_keys(file: int) -> Iterator[None]:
    """The terminal tells of every key at once and shows none by itself; Ctrl-C still interrupts."""
    import termios
    import tty

    before = termios.tcgetattr(file)
    tty.setcbreak(file)
    try:
        yield
    finally:
        termios.tcsetattr(file, termios.TCSADRAIN, before)
