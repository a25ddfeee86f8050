"""The time profile for other programs: trace events (Perfetto, chrome://tracing) and speedscope."""

from __future__ import annotations

import json

from motionlang import __version__
from motionlang.cycle.places import Places
from motionlang.cycle.profile import PROGRAM, about_link
from motionlang.files import replacing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from typing import Any

    from motionlang.cycle.profile import TimeProfile

    Row = dict[str, Any]

MICRO = 1e6
# The suffixes of `--profile-to`, the longest first, and what is written.
FORMATS = (".speedscope.json", ".trace.json", ".json")


def write_profile(made: TimeProfile, path: str) -> None:
    """Write the profile in the format of the suffix. Raises OSError."""
    lower = path.lower()
    pieces: Iterable[str]
    if lower.endswith(".speedscope.json"):
        pieces = (json.dumps(speedscope(made), indent=1), "\n")
    elif lower.endswith(".trace.json"):
        pieces = (json.dumps(trace_events(made), indent=1), "\n")
    else:
        pieces = _report(made)
    with replacing(path) as file:
        file.writelines(piece.encode() for piece in pieces)


def _report(made: TimeProfile) -> Iterator[str]:
    """`TimeProfile.report` as json writes it with an indent of 1, which takes Python ten times as long.

    Of links that differ in their times alone one is written out, and the end of one is the begin of the next.
    """
    document = made.report(chain=False)
    written: dict[int, str] = {}  # what a link has behind its times, by the identity of what that is made of
    yield json.dumps(document, indent=1).removesuffix("\n}")
    yield ',\n "chain": ['
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
    """The fields of an object in a list of a document, with the bracket that ends it."""
    return "\n".join(f"  {line}" for line in json.dumps(row, indent=1).split("\n")[1:])


def trace_events(made: TimeProfile) -> Row:
    """A lane for the chain, one for each task's waits, one for each axis's moves with their phases; microseconds."""
    run = made.run
    events: list[Row] = []
    lanes: dict[str, int] = {}

    def put(lane: str, name: str, begin: float, end: float, **about: object) -> None:
        number = lanes.setdefault(lane, len(lanes) + 1)
        row = {"name": name, "cat": lane.partition(" ")[0], "ph": "X", "pid": 1, "tid": number}
        events.append(row | {"ts": begin * MICRO, "dur": (end - begin) * MICRO, "args": about})

    for link in made.links:
        name = f"{link.cause}, line {link.place.line}" if link.place.line else link.cause
        put("chain", name, link.begin, link.end, line=link.place.line, axes=link.axes, task=link.task)
    places = Places(run)
    for task, waits in made.waits().items():
        for wait in waits:
            what = wait.why or f"for {wait.until - wait.since:.6g} s"
            line = places.of(wait.at, wait.callers).line
            put(f"task {task}", what, wait.since, wait.until, line=line, cause=wait.cause)
    for move in run.controller.log.moves:
        if move.profile is None:
            continue
        lane, begin = f"axis {move.axis}", move.start_time
        put(lane, move.command or "move", begin, min(begin + move.profile.duration, run.time), line=move.line)
        for phase in move.profile.phases:
            end = min(begin + phase.duration, run.time)
            if end > begin:
                put(lane, phase.name, begin, end)
            begin = end
    names = [
        {"name": "thread_name", "ph": "M", "pid": 1, "tid": number, "args": {"name": lane}}
        for lane, number in lanes.items()
    ]
    return {"traceEvents": names + events, "otherData": {"version": f"motionlang {__version__}"}}


def speedscope(made: TimeProfile) -> Row:
    """The chain as weighted stacks: the program, what was called, the line, and what it did."""
    places = Places(made.run)
    frames: dict[tuple[str, int], int] = {}
    samples, weights = [], []
    for link in made.links:
        stack = [(PROGRAM, 0)]
        for line in link.place.callers:
            stack += [(places.sub(line) or PROGRAM, 0), (_named(made, line), line)]
        stack += [(link.place.sub or PROGRAM, 0), (_named(made, link.place.line), link.place.line)]
        stack.append((link.cause, 0))
        unique = [frame for k, frame in enumerate(stack) if k == 0 or frame != stack[k - 1]]
        samples.append([frames.setdefault(frame, len(frames)) for frame in unique])
        weights.append(link.duration)
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
                "samples": samples,
                "weights": weights,
            }
        ],
    }


def _named(made: TimeProfile, line: int) -> str:
    return f"line {line}: {made.run.source.line(line).strip()[:60]}" if line else PROGRAM
