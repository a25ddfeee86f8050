"""Measure programs and compare each figure with its limit.

Usage: `python -m benchmarks [NAME …]`. A name is one of the programs in `programs.py`, a family of the styles in
`styles.py`, or a style. Without names, all are measured. The exit status is 1 if a figure is beyond its limit.

A style runs in stretches, each as long as all earlier ones together, until it has used `BUDGET` seconds of processor
time or has completed a shift of eight hours. Writing its steps is not measured.
"""

from __future__ import annotations

import gc
import sys
from collections.abc import Sequence
from time import process_time

from benchmarks.programs import PROGRAMS, Program
from benchmarks.styles import STYLES, Style
from motionlang.kernel.lang.dialect import dialect_of
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.scheduler import Scheduler, Stuck
from motionlang.kernel.source import Source

SHIFT = 8 * 3600.0
# The joystick moves until then, s; a program that waits for it longer has completed its shift.
LAST_INPUT = SHIFT - 2.0
# Processor seconds after which a program does not continue, and the machine time of its first stretch, s.
BUDGET, FIRST = 0.4, 4.0
# A run that is over within this, s, is measured so often, and the quickest one counts.
SHORT, ROUNDS = 0.15, 3


def started(style: Style) -> Scheduler:
    """Return the scheduler of a program that is ready to run."""
    language = dialect_of(style.file)
    assert language is not None
    machine = Machine(style.machine, first_axis=language.first_axis)
    program = language.program(Source(style.file, style.text), style.machine)
    machine.scheduler = Scheduler(machine.controller, program.start(machine))
    return machine.scheduler


def once(style: Style) -> tuple[float, float]:
    """Run a program once.

    Return machine seconds per processor second, and the processor seconds used. Raises RuntimeError if the program
    ends, because its speed is then meaningless.
    """
    scheduler = started(style)
    gc.collect()
    gc.disable()
    until, began = FIRST, process_time()
    try:
        while True:
            try:
                ended = scheduler.run(until)
            except Stuck:
                if scheduler.clock.now < LAST_INPUT:
                    raise
                ended, until = "until", SHIFT
            taken = process_time() - began
            if ended != "until":
                raise RuntimeError(f"ended at {scheduler.clock.now} s")
            if taken > BUDGET or until == SHIFT:
                return until / taken, taken
            until = min(2.0 * until, SHIFT)
    finally:
        gc.enable()


def speed(style: Style) -> float:
    """Return machine seconds per processor second of a style."""
    found, taken = once(style)
    return found if taken > SHORT else max(found, *(once(style)[0] for _ in range(ROUNDS - 1)))


def chosen(names: Sequence[str]) -> dict[str, Program]:
    """Return the named programs, or all; KeyError with the name of none."""
    of_styles = {
        name: Program(lambda style=style: speed(style), "x real time", style.least, True)  # type: ignore[misc]
        for name, style in STYLES.items()
    }
    known = PROGRAMS | of_styles
    found = {} if names else known
    for name in names:
        named = {
            each: known[each] for each in known if name in (each, each in STYLES and STYLES[each].family)
        }
        if not named:
            raise KeyError(name)
        found |= named
    return found


def main(names: Sequence[str]) -> int:
    """Print a line for each named program, or for all; return 1 if one is beyond its limit."""
    try:
        programs = chosen(names)
    except KeyError as unknown:
        families = dict.fromkeys(style.family for style in STYLES.values())
        sys.stderr.write(f"there is no program {unknown.args[0]}: {', '.join([*PROGRAMS, *families])}\n")
        return 2
    beyond = 0
    for name, program in programs.items():
        figure = program.measure()
        limit = f"{'at least' if program.is_minimum else 'at most'} {program.limit:g}"
        mark = "" if program.holds(figure) else "  BEYOND ITS LIMIT"
        beyond += bool(mark)
        print(f"{name:<32} {figure:12.1f} {program.unit:<18} {limit}{mark}", flush=True)
    print(f"{len(programs)} programs, {beyond} beyond their limits")
    return 1 if beyond else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
