"""Runs for metamorphic tests: proved, and compared at given times."""

from __future__ import annotations

from motionlang.kernel import Run, Source
from tests.proof import prove, run


def proved(text: str, name: str = "job.mnt", until: float | None = None, fine: float = 1e-9) -> Run:
    """Return the run of a program after checking its diagnostics and its proof.

    There may be no diagnostics. A statement takes `fine` seconds.
    """
    machine = {"controller.instruction_time": fine}
    result = run(Source(name, text), machine=machine, until=until)
    messages = [each.message for each in (*result.diagnostics, *prove(result, views=False).violations)]
    assert messages == [], text
    return result


def grid(result: Run, count: int = 57) -> list[float]:
    """Return evenly spaced times of a run."""
    return [result.time * k / count for k in range(count + 1)]
