"""When the loops of a task ran, as its code notes it: into the log at their end, and out of frames before that."""

from __future__ import annotations

from sys import _getframe

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from types import FrameType

    from motionlang.lang.statement_time import StatementTime
    from motionlang.log.log import Log
    from motionlang.mint.runtime.task import MintTask

    # The statement with which a loop began, and the moment from which it was counted.
    Begun = tuple[float, float]
    # The source offset of a loop, when it began, s, and the calls that led there.
    Open = tuple[int, float, tuple[int, ...]]

# A loop of fewer statements leaves no record; it counts for what stands around it.
LEAST = 100.0


def looped(
    log: Log,
    statements: StatementTime,
    task: MintTask,
    t: float,
    begun: Begun,
    at: int,
    called: tuple[int, ...],
) -> None:
    """A loop has ended at statement `t`, or a sub; called by what the code of a program calls."""
    count, base = begun
    since, until = base + count * statements.cost, statements.at(t)
    if until - since > LEAST * statements.cost:
        callers = () if _getframe(2) is task.frame else task.callers(3)
        log.loops.add((task.name, at, since, until, (*callers, *called)))


def thrown(log: Log, statements: StatementTime, task: MintTask, jump: Exception, t: float) -> None:
    """A jump has left loops at statement `t`: of each frame that it came through those that it was in."""
    until = statements.at(t)
    for at, since, callers in task.loops_of(jump)[::-1]:
        if until - since > LEAST * statements.cost:
            log.loops.add((task.name, at, since, until, callers))


def open_loops(
    frames: Iterable[FrameType],
    file: str,
    places: Sequence[int],
    statements: StatementTime,
    kinds: str = "lr",
) -> list[Open]:
    """The loops that frames of a task, the outermost first, are in; `kinds` are the first letters of variables."""
    found: list[Open] = []
    callers: tuple[int, ...] = ()
    for frame in frames:
        if frame.f_code.co_filename != file:
            continue
        for name, begun in frame.f_locals.items():
            if name[0] in kinds and name[1:].isdecimal() and begun is not None:
                count, base = begun
                found.append((int(name[1:]), base + count * statements.cost, callers))
        callers = (*callers, places[frame.f_lineno])
    return found
