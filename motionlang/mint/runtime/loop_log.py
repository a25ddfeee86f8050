"""Log the times of loops, when they end or from the frames they still run in."""

from __future__ import annotations

from sys import _getframe

from motionlang.lang.task import MIN_STATEMENTS, is_same_function

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from types import FrameType

    from motionlang.lang.statement_time import StatementTime
    from motionlang.log.log import Log
    from motionlang.mint.runtime.task import MintTask

    # The statement with which a loop began, and the time from which it was counted.
    Begun = tuple[float, float]
    # The source offset of a loop, its start in s, and the calls that led there.
    Open = tuple[int, float, tuple[int, ...]]


def looped(
    log: Log,
    statements: StatementTime,
    task: MintTask,
    t: float,
    begun: Begun,
    at: int,
    called: tuple[int, ...],
) -> None:
    """Log a loop or a sub that has ended at statement `t`.

    The direct caller must be a function that generated code calls.
    """
    count, base = begun
    since, until = base + count * statements.cost, statements.at(t)
    if until - since > MIN_STATEMENTS * statements.cost:
        callers = () if _getframe(2) is task.frame else task.callers(3)
        log.loops.add((task.name, at, since, until, (*callers, *called)))


def thrown(log: Log, statements: StatementTime, task: MintTask, jump: Exception, t: float) -> None:
    """Log the loops that a jump has left at statement `t`, in each frame it left."""
    until = statements.at(t)
    for at, since, callers in task.loops_of(jump)[::-1]:
        if until - since > MIN_STATEMENTS * statements.cost:
            log.loops.add((task.name, at, since, until, callers))


def open_loops(
    frames: Iterable[tuple[FrameType, int]],
    file: str,
    offsets: Sequence[int],
    statements: StatementTime,
    kinds: str = "lr",
) -> list[Open]:
    """Return the loops that the frames of a task are in; outermost frame first.

    Each frame comes with its line. `kinds` are the first letters of the variables that record loops.
    """
    found: list[Open] = []
    callers: tuple[int, ...] = ()
    caller: FrameType | None = None
    for frame, line in frames:
        if frame.f_code.co_filename != file:
            continue
        if caller is not None and is_same_function(frame, caller):
            callers = callers[:-1]
        caller = frame
        for name, begun in frame.f_locals.items():
            if name[0] in kinds and name[1:].isdecimal() and begun is not None:
                count, base = begun
                found.append((int(name[1:]), base + count * statements.cost, callers))
        callers = (*callers, offsets[line])
    return found
