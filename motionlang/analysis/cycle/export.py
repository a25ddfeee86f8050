"""The time profile for other programs: trace events and speedscope.

Trace events are for Perfetto and chrome://tracing.
"""

from __future__ import annotations

import json
from itertools import chain

from motionlang import __version__
from motionlang.analysis.cycle.profile import PROGRAM, about_link
from motionlang.analysis.cycle.source_positions import SourcePositions
from motionlang.files import replacing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from typing import Any

    from motionlang.analysis.cycle.profile import TimeProfile

    Row = dict[str, Any]

MICRO = 1e6
# The lane of the critical path.
PATH = "critical path"
# The suffixes of `--profile-to`, the longest first, and the output of each.
FORMATS = (".speedscope.json", ".trace.json", ".json")


def write_profile(made: TimeProfile, path: str) -> None:
    """Write the profile in the format of the suffix. Raises OSError."""
    lower = path.lower()
    pieces: Iterable[str]
    if lower.endswith(".speedscope.json"):
        pieces = chain(json.JSONEncoder(indent=1).iterencode(speedscope(made)), "\n")
    elif lower.endswith(".trace.json"):
        pieces = _trace(made)
    else:
        pieces = json_pieces(made)
    with replacing(path) as file:
        file.writelines(piece.encode() for piece in pieces)


def json_pieces(made: TimeProfile) -> Iterator[str]:
    """Yield `TimeProfile.report` as JSON with indent 1, ten times as fast as json.

    Of several links that differ only in their times one is formatted in full; the end of a link is the start
    of the next one.
    """
    document = made.report(critical_path=False)
    written: dict[int, str] = {}  # the other fields of a link, by the identity of their source
    yield json.dumps(document, indent=1).removesuffix("\n}")
    yield ',\n "critical_path": ['
    separator = "\n"
    before, text = -1.0, ""
    for begin, end, about in made.spans():
        rest = written.get(id(about))
        if rest is None:
            rest = written[id(about)] = _inner(about_link(about))
        begins = text if begin == before else repr(begin)
        before, text = end, repr(end)
        yield f'{separator}  {{\n   "begin": {begins},\n   "end": {text},\n{rest}'
        separator = ",\n"
    yield "\n ]\n}\n" if written else "]\n}\n"


def _inner(row: Row) -> str:
    """Return the fields of an object in a list of the document, and its last bracket."""
    return "\n".join(f"  {line}" for line in json.dumps(row, indent=1).split("\n")[1:])


def _trace(made: TimeProfile) -> Iterator[str]:
    """Yield a document of trace events, one line per event."""
    separator = '{"traceEvents": [\n'
    for event in trace_events(made):
        yield separator + json.dumps(event)
        separator = ",\n"
    yield f'\n],\n"otherData": {json.dumps({"version": f"motionlang {__version__}"})}}}\n'


def trace_events(made: TimeProfile) -> Iterator[Row]:
    """Yield trace events: lanes for the path, each task's waits, each axis's moves.

    Times are microseconds. The name of a lane precedes its first event, and the name of the process precedes
    all events.
    """
    run, positions = made.run, SourcePositions(made.run)
    lanes: dict[str, int] = {}
    yield {"name": "process_name", "ph": "M", "pid": 1, "args": {"name": run.source.name}}
    for lane, name, begin, end, about in _stretches(made, positions):
        number = lanes.get(lane)
        if number is None:
            number = lanes[lane] = len(lanes) + 1
            yield {"name": "thread_name", "ph": "M", "pid": 1, "tid": number, "args": {"name": lane}}
        row = {
            "name": name,
            "cat": lane if lane == PATH else lane.partition(" ")[0],
            "ph": "X",
            "pid": 1,
            "tid": number,
        }
        yield row | {"ts": begin * MICRO, "dur": (end - begin) * MICRO, "args": about}


def _stretches(made: TimeProfile, positions: SourcePositions) -> Iterator[tuple[str, str, float, float, Row]]:
    """Yield the lane, name, begin, end and further fields of each event."""
    run = made.run
    for begin, end, (cause, position, task, axes, _) in made.spans():
        name = f"{cause}, line {position.line}" if position.line else cause
        yield PATH, name, begin, end, {"line": position.line, "axes": axes, "task": task}
    for task, waits in made.waits().items():
        for wait in waits:
            what = wait.why or f"for {wait.until - wait.since:.6g} s"
            about = {"line": positions.of(wait.at, wait.callers).line, "cause": wait.cause}
            yield f"task {task}", what, wait.since, wait.until, about
    for move in run.controller.log.moves:
        if move.profile is None:
            continue
        lane, begin = f"axis {move.axis}", move.start_time
        end = min(begin + move.profile.duration, run.time)
        yield lane, move.command or "move", begin, end, {"line": move.line}
        for phase in move.profile.phases:
            end = min(begin + phase.duration, run.time)
            if end > begin:
                yield lane, phase.name, begin, end, {}
            begin = end


def speedscope(made: TimeProfile) -> Row:
    """Return the critical path as weighted stacks: program, calls, line, and action."""
    positions = SourcePositions(made.run)
    frames: dict[tuple[str, int], int] = {}
    known: dict[int, list[int]] = {}  # of a link by the identity of its shared fields
    spans = made.spans()
    for _, _, about in spans:
        if id(about) not in known:
            cause, position, *_ = about
            stack = [(PROGRAM, 0)]
            for line in position.callers:
                stack += [(positions.sub(line) or PROGRAM, 0), (_named(made, line), line)]
            stack += [(position.sub or PROGRAM, 0), (_named(made, position.line), position.line), (cause, 0)]
            unique = [frame for k, frame in enumerate(stack) if k == 0 or frame != stack[k - 1]]
            known[id(about)] = [frames.setdefault(frame, len(frames)) for frame in unique]
    name = made.run.source.name
    return {
        "$schema": "https://www.speedscope.app/file-format-schema.json",
        "exporter": f"motionlang {__version__}",
        "name": name,
        "shared": {
            "frames": [
                {"name": frame, "file": name, "line": line} if line else {"name": frame}
                for frame, line in frames
            ]
        },
        "profiles": [
            {
                "type": "sampled",
                "name": name,
                "unit": "seconds",
                "startValue": 0.0,
                "endValue": made.seconds,
                "samples": [known[id(about)] for _, _, about in spans],
                "weights": [end - begin for begin, end, _ in spans],
            }
        ],
    }


def _named(made: TimeProfile, line: int) -> str:
    return f"line {line}: {made.run.source.line(line).strip()[:60]}" if line else PROGRAM
