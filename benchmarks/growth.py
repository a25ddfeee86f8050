"""Growth of work and memory with program size.

Each figure is the exponent of growth over a factor of ten in size. Each line measures one kind of program at a
size and at a tenth of it, in two separate processes, by the calls (Python and C) of a stage. `growth_x 1.02`
means that a program ten times as long takes 10^1.02 times the calls. `growth_x_memory` is the increase of the
peak memory of the process at the larger size, MB. Calls do not show copies of long texts or lists within one
call; memory does, and these copies have tests of their own.
"""

from __future__ import annotations

import resource
import subprocess
import sys
from collections.abc import Callable
from math import log10
from pathlib import Path

# The kinds of programs whose growth is measured, by stage.
GROWTH = {
    "compile": "assignments variables undeclared labels jumps for for_if subs moves mccl_moves",
    "check": "variables labels for_if subs moves unknown unreadable no_value unused mccl_unknown",
    "run": "display waits for_if moves mccl_moves",
}

ROOT = Path(__file__).parent.parent
# The larger size by stage.
SIZES = {"compile": 10_000, "check": 5_000, "run": 5_000}


def _lines(text: str) -> Callable[[int], str]:
    """Return a function that makes a program of n copies of some lines.

    `@` is replaced by the number of the copy.
    """
    return lambda count: "".join(text.replace("@", str(n)) for n in range(count))


def _subs(count: int) -> str:
    calls = "".join(f"fill{n}()\n" for n in range(count))
    return calls + "End\n" + "".join(f"Sub fill{n}()\n OUT(0) = 1\nEnd Sub\n" for n in range(count))


PROGRAMS: dict[str, Callable[[int], str]] = {
    "assignments": _lines("x = x + @\n"),
    "variables": _lines("Dim x@ As Integer\nx@ = @\n"),
    "undeclared": _lines("x@ = @\ntotal = total + x@\n"),
    "labels": _lines("#l@\nn = n + 1\n"),
    "jumps": _lines("#l@\nn = n + 1\nIf n = @ Then Goto l@\n"),
    "for": _lines("For i = 1 To 2\nn = n + i\nNext\n"),
    "for_if": lambda count: "Dim i As Integer\n" + _lines("For i = 1 To 3@\nIf i = 2 Then n = n + i\nNext\n")(count),
    "subs": _subs,
    "moves": _lines("MOVER(0) = 1\nGO(0)\nPAUSE IDLE(0)\n"),
    "display": _lines("x = 1\nPRINT x;\n"),
    "waits": _lines("WAIT(1)\n"),
    "unknown": _lines("frodo@ = baggins@ + 1\n"),
    "unreadable": _lines("foo foo @\n"),
    "no_value": _lines("Dim x@ As Integer\nPRINT x@\n"),
    "unused": _lines("x@ = 1\n"),
    "mccl_moves": _lines("1MR1,1WS\n"),
    "mccl_unknown": _lines("1QX@\n"),
}  # fmt: skip


def measured(stage: str, name: str, size: int) -> tuple[int, float]:
    """Return the calls of a stage and the growth of this process's peak memory, MB."""
    from motionlang.execution import run
    from motionlang.lang.dialect import dialect
    from motionlang.source import Source

    text = PROGRAMS[name](size)
    language = "mccl" if name.startswith("mccl") else "mint"
    source = Source("growth.mcl" if language == "mccl" else "growth.mnt", text)

    def work(source: Source) -> None:
        if stage == "check":
            dialect(language).check(source, {})
        elif stage == "compile":
            dialect(language).compile(source)
        else:
            run(source, cache=False)

    work(Source(source.name, PROGRAMS[name](1)))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    calls = 0

    def count(_: object, event: str, __: object) -> None:
        nonlocal calls
        calls += event in ("call", "c_call")

    sys.setprofile(count)
    try:
        work(source)
    finally:
        sys.setprofile(None)
    return calls, (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024


def main() -> None:
    """Print `name value unit` lines."""
    for stage, names in GROWTH.items():
        for name in names.split():
            found = []
            for size in (SIZES[stage] // 10, SIZES[stage]):
                command = [sys.executable, __file__, stage, name, str(size)]
                ran = subprocess.run(command, capture_output=True, text=True, check=True)
                found.append([float(figure) for figure in ran.stdout.split()])
            (small, _), (large, memory) = found
            print(f"growth_{stage}_{name} {log10(large / small):.3f} exponent", flush=True)
            print(f"growth_{stage}_{name}_memory {memory:.0f} MB_at_{SIZES[stage]}", flush=True)


if __name__ == "__main__":
    sys.path[:0] = [str(ROOT)]
    if len(sys.argv) > 1:
        print(*measured(sys.argv[1], sys.argv[2], int(sys.argv[3])))
    else:
        main()
