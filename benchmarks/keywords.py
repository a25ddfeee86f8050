"""The time of the commonest keywords, relative to reading POS of an axis at rest.

Prints `name value unit`. A figure is the time of a statement, without that of its loop, divided by that of
`x = POS(0)`. The loops run one after the other in each round, and the fastest run of each counts.
"""

from __future__ import annotations

import gc
from os import environ
from time import process_time

from motionlang.execution import accelerators
from motionlang.lang.machine.machine import Machine
from motionlang.lang.scheduler import Scheduler
from motionlang.mint import DIALECT
from motionlang.source import Source

COUNT = 50_000
ROUNDS = 3 if environ.get("BENCHMARKS_HALFWAY") else 7
STATEMENTS = {
    "loop": "",
    "pos": "x = POS(0)",
    "inx": "k = INX(3)",
    "adc": "x = ADC(0)",
    "outx": "OUTX(3) = n And 1",
    "time": "k = TIME",
}


def cost(statement: str) -> float:
    """Return the processor seconds of a loop that executes a statement."""
    text = f"Dim x As Float, k As Integer, n As Integer\nFor n = 1 To {COUNT}\n  {statement}\nNext\n"
    machine = Machine(accelerators=accelerators())
    task = DIALECT.compile(Source("keyword.mnt", text), {}, machine.accelerators.ranges).start(machine)
    machine.scheduler = (machine.accelerators.scheduler or Scheduler)(machine, task)
    gc.collect()
    gc.disable()
    begin = process_time()
    machine.scheduler.run()
    taken = process_time() - begin
    gc.enable()
    return taken


def main() -> None:
    """Print `name value unit` lines."""
    quickest = dict.fromkeys(STATEMENTS, float("inf"))
    for _ in range(ROUNDS):
        for name, statement in STATEMENTS.items():
            quickest[name] = min(quickest[name], cost(statement))
    loop = quickest.pop("loop")
    pos = quickest.pop("pos") - loop
    for name, found in quickest.items():
        print(f"keyword_{name} {(found - loop) / pos:.2f} x POS")


if __name__ == "__main__":
    main()
