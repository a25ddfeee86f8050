"""Progress of a long run on a terminal, below the program's output."""

from __future__ import annotations

import sys
from collections.abc import Callable
from time import monotonic

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.result import Run
from motionlang.views.progress import Watcher, is_shown, run_line
from motionlang.views.terminal import shower


def watched(
    run: Callable[[Callable[[str], object], Callable[[Machine], None]], Run],
    warn: Callable[[Diagnostic], object],
) -> Run:
    """Return the result of `run(show, begun)`, with a progress line until it ends.

    Warnings of the machine during the run go to `warn`, above the progress line.
    """
    if not is_shown(sys.stderr):
        return run(shower(sys.stdout), lambda machine: setattr(machine, "warn", warn))
    write = shower(sys.stdout)
    watcher: Watcher | None = None

    def show(text: str) -> None:
        if watcher is not None:
            watcher.above(write, text)
        else:
            write(text)

    def begun(machine: Machine) -> None:
        nonlocal watcher
        watcher = Watcher(sys.stderr, _describer(machine))
        watcher.start()
        shown = watcher
        machine.warn = lambda diagnostic: shown.above(lambda _: warn(diagnostic), "\n")

    try:
        return run(show, begun)
    finally:
        if watcher is not None:
            watcher.stop()


def _describer(machine: Machine) -> Callable[[], str]:
    """Return the function that makes the progress line.

    The clock does not advance while the program computes without a wait; the line then says so.
    """
    began, before = monotonic(), -1.0

    def describe() -> str:
        nonlocal before
        now = machine.clock.now
        line = run_line(now, monotonic() - began, machine.moves_made, is_computing=now == before)
        before = now
        return line

    return describe
