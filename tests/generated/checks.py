"""The checks of every generated program, independent of its content.

Each program is run once and checked for general properties of runs. Then it is run a second time under a
condition that must not change the result, or only to an earlier time. The seed selects the condition, since
each one costs another run.
"""

from __future__ import annotations

import json
from collections.abc import Iterator

from motionlang.kernel import ProgramError, Run, Source, run
from motionlang.kernel.report import text as report_of
from tests import proof
from tests.fuzz.guard import bounded
from tests.generated.compared import every_iteration
from tests.generated.draw import Draw
from tests.generated.invariants import (
    entries_end,
    in_order,
    matches_schema,
    phases_add_up,
    proved,
    table_agrees,
)
from tests.generated.motion import UNTIL, Generated
from tests.generated.prefix import differences

# Processor seconds that one program may take: a cam may repeat 5000 times a second, and each piece of it is proved.
MAX_SECONDS = 120.0


def findings(program: Generated) -> list[str]:
    """Return the violations in the runs of a program; empty if there are none."""
    try:
        with bounded(MAX_SECONDS):
            return list(_findings(program))
    except ProgramError as error:
        return [f"grammar: {each.line}: {each.message}" for each in error.diagnostics]
    except Exception as error:
        frame, where = error.__traceback__, ""
        while frame is not None:
            where = f"{frame.tb_frame.f_code.co_filename.rpartition('/')[2]}:{frame.tb_lineno}"
            frame = frame.tb_next
        return [f"crash: {type(error).__name__}: {str(error)[:200]} at {where}"]


def _findings(program: Generated) -> Iterator[str]:
    first = _run(program)
    if first.program is None:  # the generator discards nothing: its programs are grammatical
        yield from (f"grammar: {each.line}: {each.message}" for each in first.diagnostics)
    text = _report(first)
    report = json.loads(text)
    yield from proved(first)
    yield from entries_end(first)
    yield from in_order(first)
    yield from phases_add_up(report)
    if "NaN" in text or "Infinity" in text:
        yield "report: a figure is not a number"
    if program.seed % 4 == 0:
        yield from matches_schema(report)
    if program.seed % 4 == 1:
        yield from table_agrees(first, report)
    yield from _OTHER_RUNS[program.seed % len(_OTHER_RUNS)](program, first, text)


def _run(program: Generated, until: float = UNTIL) -> Run:
    source = Source(program.name, program.text)
    made = proof.run if until == UNTIL else run
    return made(source, machine=program.machine, until=until)


def _report(result: Run) -> str:
    return report_of(result, whole=False)


def _again(program: Generated, first: Run, report: str) -> Iterator[str]:
    """Check that a run leaves no state: a second run gives the same report."""
    if report != _report(_run(program)):
        yield "again: a second run has another report"


def _cut(program: Generated, first: Run, report: str) -> Iterator[str]:
    """Check runs up to an earlier time, either any time or within a move.

    For every sixteenth seed, check three such times.
    """
    draw = Draw(program.seed)
    moves = [move for move in first.controller.log.moves if move.profile is not None]
    for _ in range(3 if program.seed % 16 == 1 else 1):
        time = draw.uniform(0.0, first.time)
        if moves and draw.chance(0.5):
            move = draw.choice(moves)
            assert move.profile is not None
            time = min(move.start_time + draw.random() * min(move.profile.duration, 1.0), first.time)
        yield from differences(first, _run(program, time), time)


def _plain(program: Generated, first: Run, report: str) -> Iterator[str]:
    """Check a run in which every iteration of a loop is carried out."""
    with every_iteration():
        if report != _report(_run(program)):
            yield "skipped: with no iteration skipped a run has another report"


_OTHER_RUNS = (_again, _cut, _plain, _cut)
