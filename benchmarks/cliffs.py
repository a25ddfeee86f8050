"""Speed of programs in many styles, each compared with a plain one.

Usage: `python -m benchmarks.cliffs [FAMILY …]`. A line has a style, how many times slower it runs than its
neighbour, and its speed in machine seconds per processor second (`x real time`). A style that is more than
`MOST` times slower than its neighbour, or slower than `LEAST` × real time, is a cliff and is marked. A few
styles have other limits (`cliff_styles.py`, which has the programs). The exit status is 1 if there is a cliff.

Compilation is not measured. Each program runs in stretches, each as long as all earlier ones together, until
it has used `BUDGET` seconds of processor time or has completed a shift of eight hours. The neighbour is
measured just before the first of its styles and again after the last one; the faster result counts.
"""

from __future__ import annotations

import gc
import sys
from itertools import groupby
from pathlib import Path
from time import process_time

ROOT = Path(__file__).parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks")]

from cliff_styles import LEAST, MOST, STYLES  # noqa: E402

from motionlang.execution import accelerators, dialect_of  # noqa: E402
from motionlang.lang.machine.machine import Machine  # noqa: E402
from motionlang.lang.scheduler import Scheduler, Stuck  # noqa: E402
from motionlang.source import Source  # noqa: E402

TYPE_CHECKING = False
if TYPE_CHECKING:
    from cliff_styles import Style

SHIFT = 8 * 3600.0
# The joystick moves until then, s; a program that waits for it longer has completed its shift.
LAST_INPUT = SHIFT - 2.0
# Processor seconds after which a program does not continue, and the machine time of its first stretch, s.
BUDGET, FIRST = 0.4, 4.0
# A run that is over within this, s, is measured so often, and the quickest one counts.
SHORT, ROUNDS = 0.15, 3


def started(style: Style) -> Scheduler:
    """Return the scheduler of a compiled program that is ready to run."""
    language = dialect_of(style.file)
    assert language is not None
    machine = Machine(style.machine, first_axis=language.first_axis, accelerators=accelerators())
    program = language.compile(Source(style.file, style.text), style.machine, machine.accelerators.ranges)
    machine.scheduler = (machine.accelerators.scheduler or Scheduler)(machine, program.start(machine))
    return machine.scheduler


def once(style: Style) -> tuple[float, float]:
    """Run a program once.

    Return machine seconds per processor second, and the processor seconds used. Raises RuntimeError if the
    program ends, because its speed is then meaningless.
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


def speed(name: str) -> float:
    """Return machine seconds per processor second of a style."""
    style = STYLES[name]
    try:
        found, taken = once(style)
        return found if taken > SHORT else max(found, *(once(style)[0] for _ in range(ROUNDS - 1)))
    except Exception as error:
        error.add_note(f"in the style {name}")
        raise


def main(families: list[str]) -> int:
    """Print a line for each style of the named families, or of all.

    Return 1 if there is a cliff.
    """
    known = dict.fromkeys(style.family for style in STYLES.values())
    unknown = [each for each in families if each not in known]
    if unknown:
        sys.stderr.write(f"there is no family {unknown[0]}: {', '.join(known)}\n")
        return 2
    chosen = [name for name, style in STYLES.items() if not families or style.family in families]
    cliffs = 0
    for neighbour, group in groupby(chosen, lambda name: STYLES[name].neighbour or name):
        names = [name for name in group if name != neighbour]
        plain = speed(neighbour)
        found = {name: speed(name) for name in names}
        plain = max(plain, speed(neighbour))
        print(f"{neighbour:<28} {1.0:8.2f} times {'itself':<16} {plain:10.0f} x real time", flush=True)
        for name in names:
            style, ratio = STYLES[name], plain / found[name]
            is_cliff = ratio > (style.most or MOST) or found[name] < (style.least or LEAST)
            cliffs += is_cliff
            mark = "  cliff" if is_cliff else ""
            print(
                f"{name:<28} {ratio:8.2f} times {neighbour:<16} {found[name]:10.0f} x real time{mark}",
                flush=True,
            )
    print(f"{len(chosen)} styles, {cliffs} cliffs")
    return 1 if cliffs else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
