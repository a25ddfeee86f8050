"""What metamorphic tests run and compare: proved runs, and the times at which their places are looked at."""

from __future__ import annotations

from motionlang import run
from motionlang.result import Run
from motionlang.source import Source


def proved(text: str, name: str = "job.mnt", until: float | None = None, fine: float = 1e-9) -> Run:
    """A run without a diagnostic whose proof holds; a statement costs `fine` seconds."""
    machine = {"controller.instruction_time": fine}
    result = run(Source(name, text), machine=machine, until=until, cache=False, prove=True)
    told = [each.message for each in (*result.diagnostics, *result.proof(views=False).violations)]
    assert told == [], text
    return result


def grid(result: Run, count: int = 57) -> list[float]:
    """Moments of a run, evenly spread."""
    return [result.time * k / count for k in range(count + 1)]
