"""Keyboard input in a real-time run: single keys at once, lines on request."""

from __future__ import annotations

import os
import select
import sys
from collections.abc import Callable
from typing import TypeVar

from motionlang.hosts.serve.outside import PATIENCE, RealTimeQueue
from motionlang.views.single_keys import has_keys, single_keys

Result = TypeVar("Result")
# Bytes read at once.
CHUNK = 1024


class Keyboard(RealTimeQueue):
    """Real time in which the operator's keys are read from `file` while it waits."""

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
            self._file = None  # the input has ended
            return
        self.ask(lambda: self._type(text.decode("latin-1")))

    def may_act(self) -> bool:
        """True if the program reads the keyboard, so that a key can change the run."""
        assert self.machine is not None
        return self._file is not None and self.machine.has_operator

    def _type(self, text: str) -> None:
        assert self.machine is not None
        self.machine.operator.type(text)


def run_live(run: Callable[[Keyboard | None], Result], factor: float) -> Result:
    """Call `run` with a keyboard, or with None if there is no terminal."""
    if not has_keys():
        return run(None)
    file = sys.stdin.fileno()
    with single_keys(file):
        return run(Keyboard(file, factor))
