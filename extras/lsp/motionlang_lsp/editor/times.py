"""The simulated time of each line, from a limited run that writes no files."""

from __future__ import annotations

from dataclasses import dataclass
from math import fsum

from motionlang.commands.profile.motions import Motions
from motionlang.commands.profile.polls import Polls
from motionlang.commands.profile.source_positions import SourcePositions
from motionlang.commands.profile.tasks import all_waits
from motionlang.kernel import CheckedSettings, Run, end_of, run
from motionlang_lsp.editor.page import Page

# The machine time after which a run ends here, s: most programs of machines have no end of their own.
MAX_TIME = 600.0


@dataclass(eq=False, slots=True)
class LineTime:
    """The number of moves that a line has started, and their duration, s.

    `waited` is the time, in seconds, that tasks have waited at the line.
    """

    line: int
    moves: int
    seconds: float
    waited: float

    def __str__(self) -> str:
        texts = [f"{_seconds(self.seconds)} ({self.moves}×)"] if self.moves else []
        if self.waited >= _SHORTEST:
            texts.append(f"waits {_seconds(self.waited)}")
        return " · ".join(texts)


# A shorter wait is not shown, s.
_SHORTEST = 0.0005


@dataclass(eq=False, slots=True)
class Times:
    """The times of a run's lines.

    `fault` is the line and the message of the error that ended the run, or None. `until` is the machine time, s, at
    which the run was cut short, 0 if it ended by itself. `running` has the lines at which its tasks then were.
    """

    lines: list[LineTime]
    fault: tuple[int, str] | None
    until: float
    running: list[int]

    def texts(self) -> dict[int, str]:
        """Return the hint of each line that has one."""
        found = {each.line: str(each) for each in self.lines}
        ends = [(line, f"still running at {self.until:g} s") for line in self.running]
        if self.fault is not None:
            line, message = self.fault
            ends.append((line, f"ends here: {message}"))
        for line, text in ends:
            found[line] = " · ".join(filter(None, (found.get(line), text)))
        return found


NO_TIMES = Times([], None, 0.0, [])


def times(page: Page) -> Times:
    """Run a program and return the times of its lines; none if it has errors."""
    settings = CheckedSettings(page.settings)
    result = run(
        page.source,
        dialect=page.language,
        machine=settings,
        until=min(end_of(settings), MAX_TIME),
        keep_crash=True,
    )
    if result.program is None:
        return NO_TIMES
    cut = result.time if result.status in ("until", "interrupted", "limit") else 0.0
    return Times(_lines(result), _fault(result), cut, _running(result) if cut else [])


def _lines(result: Run) -> list[LineTime]:
    moves: dict[int, list[float]] = {}
    waits: dict[int, list[float]] = {}
    log = result.machine.log
    for move in log.moves:
        assert move.profile is not None
        last = move.start_time + move.profile.duration
        moves.setdefault(move.line, []).append(min(last, result.time) - move.start_time)
    positions = SourcePositions(result)
    # A polling loop waits, too, and a profile finds out for how long. A wait that the end of the run cuts short is left
    # out.
    over = {
        task: [wait for wait in found if wait[3] < result.time or result.status == "ended"]
        for task, found in all_waits(result).items()
    }
    for found in Polls(result, Motions(result), over).waits.values():
        for _, at, since, until, *_ in found:
            waits.setdefault(positions.line(at), []).append(until - since)
    times = [
        LineTime(line, len(moves.get(line, ())), fsum(moves.get(line, ())), fsum(waits.get(line, ())))
        for line in sorted(moves.keys() | waits.keys())
    ]
    return [each for each in times if each.line and str(each)]


def _fault(result: Run) -> tuple[int, str] | None:
    if result.status != "fault":
        return None
    found = [each for each in result.diagnostics if each.severity == "error" and each.line]
    return (found[-1].line, found[-1].message) if found else None


def _running(result: Run) -> list[int]:
    """Return the lines of the tasks that have not ended; the end of the program ends them all."""
    scheduler = result.machine.scheduler
    if scheduler is None or scheduler.parent.done:
        return []
    positions = SourcePositions(result)
    return sorted({positions.line(task.at) for task in scheduler.tasks if not task.done})


def _seconds(value: float) -> str:
    return f"{value:.3g} s" if value < 100 else f"{value:.0f} s"
