"""The proof of a run, with its report and its trace."""

from __future__ import annotations

from motionlang.kernel import Run
from motionlang.kernel.report import moves
from tests.proof.checker import Proof
from tests.proof.checks import prove
from tests.proof.expected_motion import ExpectedMotion
from tests.proof.outputs import ROWS


def proof(run: Run, views: bool = True) -> Proof:
    """Return the proof of the motion of a run against the commands; ValueError if none is expected.

    With `views` the report and the trace are checked, too.
    """
    expected = ExpectedMotion.of_run(run)
    if not views:
        return prove(run.controller, expected, run.time)
    samples = run.trace.sample(ROWS / run.time) if run.time > 0.0 else None
    return prove(run.controller, expected, run.time, moves(run), samples)
