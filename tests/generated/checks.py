"""What every generated program must satisfy, whatever it does."""

from __future__ import annotations

import json
from math import isfinite, isnan

from motionlang import run
from motionlang.controller.move import Move
from motionlang.controller.record.track import WholeTrack
from motionlang.errors import ProgramError
from motionlang.result import Run
from motionlang.source import Source
from tests.fuzz.guard import bounded
from tests.generated.motion import UNTIL, Generated

# Seconds of the processor that one program may take.
LONGEST = 10.0
# Seconds by which the time of an end may be rounded, and parts of a position.
ROUNDED, SLACK = 1e-9, 1e-6


def findings(program: Generated) -> list[str]:
    """What is wrong with the runs of a program; empty if nothing is."""
    try:
        with bounded(LONGEST):
            first = _run(program)
            found = _proved(first) + _agreeing(first)
            report = _bytes(first)
            if "NaN" in report or "Infinity" in report:
                found.append("report: a figure is not a number")
            if report != _bytes(_run(program)):
                found.append("again: a second run has another report")
            return found
    except ProgramError as error:
        return [f"grammar: {each.line}: {each.message}" for each in error.diagnostics]
    except Exception as error:
        frame, where = error.__traceback__, ""
        while frame is not None:
            where = f"{frame.tb_frame.f_code.co_filename.rpartition('/')[2]}:{frame.tb_lineno}"
            frame = frame.tb_next
        return [f"crash: {type(error).__name__}: {str(error)[:200]} at {where}"]


def _run(program: Generated) -> Run:
    source = Source(program.name, program.text)
    return run(source, machine=program.machine, until=UNTIL, cache=False, prove=True)


def _bytes(result: Run) -> str:
    return json.dumps([result.report, result.output], default=str)


def _proved(result: Run) -> list[str]:
    return [f"proof: {each.line}: {each.message}" for each in result.proof().violations]


def _agreeing(result: Run) -> list[str]:
    """Entries that are over ended within the run, and the last one of an axis where the axis is."""
    assert result.orders is not None
    found, axes, data = [], result.controller.axes, result.orders.data
    last: dict[int, Move] = {}
    for move in result.controller.log.moves:
        profile, axis = move.profile, axes[move.axis]
        if profile is None:
            continue
        where = f"axis {move.axis} from {move.start_time:.6f} s, line {move.line}"
        if isnan(profile.start) or isnan(profile.end) or isnan(profile.duration):
            found.append(f"log: {where}: a figure is not a number")
        end = move.start_time + profile.duration
        late = end > result.time + ROUNDED * (1.0 + result.time)
        under_way = any(move is each for each in axis.entries)  # several while paths are blended
        if late and isfinite(end) and not under_way and (move.ended or result.status == "ended"):
            found.append(f"log: {where}: it ends at {end:.6f} s, the run at {result.time:.6f} s")
        if not move.overlaid and not move.offset:
            last[move.axis] = move
    for number, move in last.items():
        axis, profile, track = axes[number], move.profile, WholeTrack(axes[number])
        assert profile is not None
        end = move.start_time + profile.duration
        if end > result.time or axis.move is not None or any(time > end for time in track.starts):
            continue
        shift = data[number][-1] - data[number][track.place(move.start_time)]
        here = axis.position(result.time)
        if abs(here - profile.end - shift) > SLACK * max(1.0, abs(here)):
            found.append(f"log: axis {number} is at {here:g}, its last entry ends at {profile.end:g}")
    return found
