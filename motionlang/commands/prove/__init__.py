"""The proof of a run: checks its motion against the commands, without planners."""

from motionlang.commands.prove.checker import Proof as Proof
from motionlang.kernel import Run
from motionlang.kernel.log import Recorded
from motionlang.kernel.report import moves


def proof(run: Run, views: bool = True) -> Proof:
    """Return the proof of the motion of a run against the commands; ValueError without `prove`.

    With `views` the report and the trace are checked, too.
    """
    # The checks need NumPy; `motionlang prove --help` does not.
    from motionlang.commands.prove.checks import prove
    from motionlang.commands.prove.outputs import ROWS

    if run.expected_motion is None:
        raise ValueError("the run was not made with prove=True")
    if not views:
        return prove(Recorded(run.controller), run.expected_motion, run.time)
    samples = run.trace.sample(ROWS / run.time) if run.time > 0.0 else None
    return prove(Recorded(run.controller), run.expected_motion, run.time, moves(run), samples)
