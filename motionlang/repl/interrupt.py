"""Ctrl-C as a request to end a running command.

The command ends between two steps, when every axis is consistent.
"""

from __future__ import annotations

import os
import signal
from types import FrameType, TracebackType


class Interrupts:
    """`with interrupts:` makes the first Ctrl-C call `pressed()`.

    A second press raises the ordinary KeyboardInterrupt. `echoed` is False if the terminal does not show ^C.
    """

    def __init__(self, *, echoed: bool = True) -> None:
        self._pressed, self._echoed = False, echoed

    def pressed(self) -> bool:
        return self._pressed

    def __enter__(self) -> Interrupts:
        self._before = signal.signal(signal.SIGINT, self._press)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        signal.signal(signal.SIGINT, self._before)
        self._pressed = False

    def _press(self, number: int, frame: FrameType | None) -> None:
        if self._pressed:
            raise KeyboardInterrupt
        self._pressed = True
        if self._echoed and os.isatty(2):
            os.write(2, b"\n")  # the terminal has shown ^C, and further output belongs on its own line
