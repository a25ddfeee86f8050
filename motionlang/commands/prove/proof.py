"""The proof of a run, with its report and its trace."""

from __future__ import annotations

from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.checks import prove
from motionlang.commands.prove.expected_motion import ExpectedMotion
from motionlang.commands.prove.outputs import ROWS
from motionlang.kernel import Run
from motionlang.kernel.report import moves
from motionlang.kernel.tracks import Recorded


def proof(run: Run, views: bool = True) -> Proof:
    """Return the proof of the motion of a run against the commands; ValueError without `prove`.

    With `views` the report and the trace are checked, too.
    """
    expected = ExpectedMotion.of_run(run)
    if not views:
        return prove(Recorded(run.controller), expected, run.time)
    samples = run.trace.sample(ROWS / run.time) if run.time > 0.0 else None
    return prove(Recorded(run.controller), expected, run.time, moves(run), samples)
