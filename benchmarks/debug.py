"""The cost of debug builds against plain ones, and of a step back.

A step back is compared with the run up to the same statement. Prints `name value unit`; all figures are ratios
within one run, of the smallest processor time of each side.
"""

from __future__ import annotations

from collections.abc import Callable

from timing import seconds

from motionlang.debug.debugger import Debugger
from motionlang.execution import dialect_of, run
from motionlang.lang.debugging import Hook
from motionlang.source import Source

ROUNDS = 5
_AXIS = "Dim i As Integer, s As Float\nSPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
PROGRAMS = {
    "moves": Source(
        "moves.mnt", f"{_AXIS}For i = 1 To 20000\n  MOVER(0) = 1\n  GO(0)\n  PAUSE IDLE(0)\nNext\n"
    ),
    "poll": Source(
        "poll.mnt",
        f"{_AXIS}For i = 1 To 2000\n  MOVER(0) = 1\n  GO(0)\n  While IDLE(0) = 0\n"
        "    If IN(1) Then Exit While\n  End While\nNext\n",
    ),
    "mccl": Source("mccl.mcl", "AL0,AR10\nMD1,RA10,AA1,AR10,IB40000,MJ1\nMC1\n"),
    "loop": Source("loop.mnt", "Dim i As Integer, s As Float\nFor i = 1 To 300000\n  s = s + i\nNext\n"),
}
# The gallery's longest cycles end within this many statements.
FAR = 30_000


def main() -> None:
    """Print the figures."""
    for name, source in PROGRAMS.items():
        print(f"debug_{name} {_build(source):.2f} x plain")
    print(f"debug_step_back {_step_back(PROGRAMS['moves']):.2f} x running")


def _build(source: Source) -> float:
    """Return the time of a debug build, relative to that of a plain program."""

    def debugged() -> object:
        return run(source, machine={}, cache=False, hook=Hook(_go_on))

    return _least(debugged) / _least(lambda: run(source, machine={}, cache=False))


def _go_on(*_: object) -> None:
    """Let the program go on."""


def _least(work: Callable[[], object]) -> float:
    return min(seconds(work) for _ in range(ROUNDS))


def _step_back(source: Source) -> float:
    """Return the time of a step back, relative to a run up to the same statement.

    The first step back after a stop is not counted: it has to search for the previous statement.
    """
    language = dialect_of(source.name)
    assert language is not None
    debugger = Debugger(source, language, {})
    debugger._arrive(FAR, "goto")
    debugger.step_back()
    running = _least(lambda: debugger._arrive(FAR, "goto"))
    back = _least(debugger.step_back)
    debugger.abandon()
    return back / running


if __name__ == "__main__":
    main()
