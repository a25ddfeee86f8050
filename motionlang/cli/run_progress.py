"""Progress of a long run: a line on a terminal below the program's output, and a note how to end it."""

from __future__ import annotations

import sys
from collections.abc import Callable
from threading import Timer
from time import monotonic

from motionlang.kernel import Diagnostic, Machine, Program, Run
from motionlang.kernel.log import cycle_so_far
from motionlang.views.formatting import clock_time
from motionlang.views.progress import Watcher, is_shown, run_line
from motionlang.views.terminal import shower

# Seconds of real time after which the note is written, and after which the progress line names the cycle.
PATIENCE, CYCLE_PATIENCE = 10.0, 1.0


def reported(
    run: Callable[[Callable[[str], object], Callable[[Machine], None]], Run],
    warn: Callable[[Diagnostic], object],
    line_of: Callable[[int], int] | None = None,
    *,
    program: Program,
    homes: Callable[[str], bool],
    until: float,
) -> Run:
    """Return the result of `run(show, begun)`, with a progress line on a terminal until it ends at `until`.

    `homes` is true for the commands that home an axis.

    Warnings of the machine during the run go to `warn`, above the progress line. With `line_of`, which returns the line
    of an offset, a long run gets a note on standard error.
    """
    show = shower(sys.stdout)
    watcher: Watcher | None = None
    timer: Timer | None = None

    def above(write: Callable[[str], object], text: str) -> None:
        if watcher is None:
            write(text)
        else:
            watcher.above(write, text)

    def begun(machine: Machine) -> None:
        nonlocal watcher, timer
        if is_shown(sys.stderr):
            watcher = Watcher(sys.stderr, _describer(machine, program, homes, until, line_of is not None))
            watcher.start()
        machine.warn = lambda diagnostic: above(lambda _: warn(diagnostic), "\n")
        if line_of is not None:
            timer = Timer(PATIENCE, lambda: above(_write_note, _note(machine, line_of)))
            timer.daemon = True
            timer.start()

    try:
        return run(lambda text: above(show, text), begun)
    finally:
        if timer is not None:
            timer.cancel()
        if watcher is not None:
            watcher.stop()


def _note(machine: Machine, line_of: Callable[[int], int]) -> str:
    line, now = "", machine.clock.now
    if machine.scheduler is not None:
        at, reached = machine.scheduler.current.reached
        line, now = f"line {line_of(at)}, ", max(now, reached)
    return f"note: still running: {line}{clock_time(round(now, 3))} of machine time; --until S or --cpu S ends it\n"


def _write_note(text: str) -> None:
    sys.stdout.flush()
    sys.stderr.write(text)
    sys.stderr.flush()


def _describer(
    machine: Machine, program: Program, homes: Callable[[str], bool], until: float, is_endless: bool
) -> Callable[[], str]:
    """Return the function that makes the progress line.

    The clock does not advance while the program computes without a wait; the line then says so.
    """
    began, before = monotonic(), -1.0
    period: str | None = None
    owner = program.structure.owners().get

    def describe() -> str:
        nonlocal before, period
        now = machine.clock.now
        if period is None and monotonic() - began >= CYCLE_PATIENCE:
            found = cycle_so_far(machine.log, now, owner, homes)
            period = f"{found.period:.5g} s" if found else ""
        line = run_line(now, until, period or "", is_endless=is_endless, is_computing=now == before)
        before = now
        return line

    return describe
