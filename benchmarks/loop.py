"""A counting loop of a million iterations in Mint, compared with CPython.

Virtual time is charged. Prints `name value unit`; the ratios are medians of rounds in which both run one after
the other.
"""

from __future__ import annotations

from os import environ
from statistics import median
from time import process_time

from motionlang.execution import accelerators
from motionlang.lang.machine.machine import Machine
from motionlang.lang.scheduler import Scheduler
from motionlang.mint import DIALECT
from motionlang.source import Source

# A median of three shorter loops is enough for a figure that may miss its bar by a factor of two.
ITERATIONS, ROUNDS = (300_000, 3) if environ.get("BENCHMARKS_HALFWAY") else (1_000_000, 7)
LOOP = f"For i = 1 To {ITERATIONS}\n  x = x + i * 2\n  If x > 1000 Then x = 0\nNext\n"
FORMS = {
    "declared": f"Dim i As Integer, x As Integer\n{LOOP}",
    "undeclared": LOOP,
    "while": f"i = 1\nWhile i <= {ITERATIONS}\n  x = x + i * 2\n  If x > 1000 Then x = 0\n  i = i + 1\nEnd While\n",
    "shared": f"{LOOP}End\nTask Other\n  x = i\nEnd Task\n",
    "four_tasks": "".join(f"Run T{k}\n" for k in range(4))
    + "".join(f"PAUSE TASKSTATUS(T{k}) = 0\n" for k in range(4))
    + "End\n"
    + "".join(
        f"Task T{k}\nDim i As Integer, x As Integer\n{LOOP.replace(str(ITERATIONS), str(ITERATIONS // 4))}End Task\n"
        for k in range(4)
    ),
}


def native() -> int:
    x = 0
    i = 1
    while i <= ITERATIONS:
        x = x + i * 2
        if x > 1000:
            x = 0
        i += 1
    return x


def seconds(text: str) -> float:
    machine = Machine(accelerators=accelerators())
    task = DIALECT.compile(Source("loop.mnt", text), {}, machine.accelerators.ranges).start(machine)
    scheduler = machine.scheduler = (machine.accelerators.scheduler or Scheduler)(machine, task)
    start = process_time()
    scheduler.run()
    return process_time() - start


def main() -> None:
    ratios: dict[str, list[float]] = {name: [] for name in FORMS}
    plain = []
    for _ in range(ROUNDS):
        start = process_time()
        native()
        plain.append(process_time() - start)
        for name, text in FORMS.items():
            ratios[name].append(seconds(text) / plain[-1])
    print(f"loop_native {median(plain) / ITERATIONS * 1e9:.1f} ns/turn")
    for name, values in ratios.items():
        print(f"loop_{name} {median(values):.2f} x native")


if __name__ == "__main__":
    main()
