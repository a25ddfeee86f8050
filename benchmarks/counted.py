"""Count function calls and bytecode instructions of every style.

Usage: `python benchmarks/counted.py FOLDER`. It prints one JSON object: `{"style.stage": [calls,
instructions]}`. `FOLDER` contains the package that is counted. The stages are `compile` (from source text to a
started program), `run` (the program itself) and `report` (to JSON text). Each stage runs once before it is
counted, so that imports and caches within the process do not count. The same package, Python and styles give
equal figures on every machine, whatever its load.
"""

from __future__ import annotations

import gc
import json
import sys
import threading
from typing import TYPE_CHECKING

from styles import STYLES, Style

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import FrameType
    from typing import Any


class Counter:
    """Counts calls of Python and C functions, and instructions, in `counting`."""

    def __init__(self) -> None:
        self.calls = self.instructions = 0

    def counting(self, work: Callable[[], object]) -> tuple[int, int]:
        """Return the calls and instructions of one call of `work`."""
        self.calls = self.instructions = 0
        gc.collect()
        gc.disable()
        threading.settrace(self._trace)
        sys.setprofile(self._profile)
        sys.settrace(self._trace)
        try:
            work()
        finally:
            sys.settrace(None)
            sys.setprofile(None)
            threading.settrace(None)
            gc.enable()
        return self.calls, self.instructions

    def _trace(self, frame: FrameType, event: str, _: Any) -> Any:
        if event == "opcode":
            self.instructions += 1
        elif event == "call":
            frame.f_trace_opcodes, frame.f_trace_lines = True, False
        return self._trace

    def _profile(self, _: FrameType, event: str, __: Any) -> None:
        if event in ("call", "c_call"):
            self.calls += 1


def stages(
    style: Style, count: Callable[[Callable[[], object]], tuple[int, int]]
) -> dict[str, tuple[int, int]]:
    """Return the calls and instructions of each stage of one style."""
    from motionlang.execution import run
    from motionlang.report import text
    from motionlang.source import Source

    def until(time: float) -> object:
        return run(Source(style.file, style.text), machine=style.machine, until=time, cache=False)

    result = run(Source(style.file, style.text), machine=style.machine, until=style.until, cache=False)
    if result.status == "fault":
        raise SystemExit(f"{style.file}: {result.diagnostics}\n{style.text}")
    text(result)
    start = count(lambda: until(0.0))
    whole = count(lambda: until(style.until))
    return {
        "compile": start,
        "run": (whole[0] - start[0], whole[1] - start[1]),
        "report": count(lambda: text(result)),
    }


def main(folder: str) -> None:
    """Count every style with the package in `folder`, and print the result."""
    sys.path.insert(0, folder)
    counter = Counter()
    print(
        json.dumps(
            {
                f"{name}.{stage}": figures
                for name, style in STYLES.items()
                for stage, figures in stages(style, counter.counting).items()
            }
        )
    )


if __name__ == "__main__":
    main(sys.argv[1])
