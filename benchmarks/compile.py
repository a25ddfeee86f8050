"""Time until a Mint program can run: `name value unit` lines, mostly ratios.

    python benchmarks/compile.py [BYTES]

The text is a program of about a quarter of a megabyte, generated twice with equal statements: in Mint and in
Python, so that CPython's own `compile` is a fair comparison. A program is runnable if its first statement can
be executed: the code of a long program is generated function by function, when they are called. `everything`
includes the code of all functions. The garbage collector is off for both. `lines` are programs without
branches or functions, whose cost should be proportional to their length. Times are processor times; ratios are
medians of rounds in which both run one after the other.
"""

from __future__ import annotations

import sys
from functools import partial
from statistics import median

from parse_program import program
from timing import seconds

from motionlang.execution import accelerators
from motionlang.mint.program import compile_source, load
from motionlang.mint.syntax.parser import parse
from motionlang.source import Source

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.program import MintProgram

ROUNDS = 11
LINES = (10_000, 40_000)


def runnable(source: Source) -> MintProgram:
    """Compile a program until its first statement can be executed."""
    return compile_source(source, ranges=accelerators().ranges)


def compile_all(compiled: MintProgram) -> None:
    """Compile the units that are still text."""
    for unit in compiled.code.units:
        unit.compile()


def whole(source: Source) -> None:
    """Compile a complete program, all functions included."""
    compile_all(runnable(source))


def main(arguments: list[str]) -> int:
    """Measure and print."""
    mint, python = program(int(arguments[0]) if arguments else 250_000)
    source = Source("big.mnt", mint)
    steps: dict[str, Callable[[], object]] = {
        "parse": lambda: parse(source),
        "runnable": lambda: runnable(source),
        "everything": lambda: whole(source),
    }
    native: list[float] = []
    ratios: dict[str, list[float]] = {name: [] for name in steps}
    for _ in range(ROUNDS):
        native.append(seconds(lambda: compile(python, "big.py", "exec")))
        for name, step in steps.items():
            ratios[name].append(seconds(step) / native[-1])
    compiled = runnable(source)
    compile_all(compiled)
    payload = compiled.payload()
    cached = min(seconds(lambda: load(payload)) for _ in range(ROUNDS))
    called = min(seconds(partial(compile_all, load(payload))) for _ in range(ROUNDS))
    print(f"compile_program {len(mint) / 1e6:.2f} MB")
    print(f"compile_python {median(native) * 1e3:.0f} ms")
    for name, values in ratios.items():
        print(f"compile_{name} {median(values):.2f} x_python")
    print(f"compile_over_cached_load {min(ratios['everything']) * min(native) / cached:.0f} x")
    print(f"compile_over_cached_load_of_all {min(ratios['everything']) * min(native) / called:.0f} x")
    for count in LINES:
        straight = Source("straight.mnt", "PRINT 1\n" * count)
        taken = min(seconds(lambda text=straight: whole(text)) for _ in range(2))  # type: ignore[misc]
        print(f"compile_lines_{count} {taken / count * 1e6:.1f} us/line")
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
