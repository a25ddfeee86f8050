"""Everything that a run produces, for comparison with another run."""

from __future__ import annotations

from motionlang.kernel import Run
from motionlang.kernel.report import text

STREAMS = (
    "waits",
    "inputs",
    "outputs",
    "analogue_inputs",
    "analogue_outputs",
    "settings",
    "events",
    "prints",
)


def whole(run: Run) -> tuple[str, list[list[list[object]]]]:
    """Return the report and the log of a run, which must be equal in both runs."""
    log = run.machine.log
    return text(run), [[list(each) for each in getattr(log, name)] for name in STREAMS]
