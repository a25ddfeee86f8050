"""The proof of a run, with its report and its trace."""

from __future__ import annotations

from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.outputs import ROWS
from motionlang.commands.prove.checks import prove
from motionlang.kernel.log.track import Recorded
from motionlang.kernel.report import moves
from motionlang.kernel.result import Run


def proof(run: Run, views: bool = True) -> Proof:
    """Return the proof of the motion of a run against the commands; ValueError without `prove`.

    With `views` the report and the trace are checked, too.
    """
    if run.expected_motion is None:
        raise ValueError("the run was not made with prove=True")
    if not views:
        return prove(Recorded(run.controller), run.expected_motion, run.time)
    samples = run.trace.sample(ROWS / run.time) if run.time > 0.0 else None
    return prove(Recorded(run.controller), run.expected_motion, run.time, moves(run), samples)
