"""The time profile for other programs: as JSON, and for speedscope, whose files Perfetto opens, too."""

from __future__ import annotations

import json
from typing import Any

from motionlang.commands.profile.profile import PROGRAM, TimeProfile
from motionlang.commands.profile.source_positions import SourcePositions
from motionlang.commands.profile.view import profile_document
from motionlang.kernel.files import replacing
from motionlang.kernel.version import __version__

Row = dict[str, Any]

# The suffixes of a profile's file, the longest first.
SUFFIXES = (".speedscope.json", ".json")


def write_profile(made: TimeProfile, path: str) -> None:
    """Write the profile in the format of the suffix. Raises OSError."""
    is_speedscope = path.lower().endswith(SUFFIXES[0])
    text = json.dumps(speedscope(made), indent=1) + "\n" if is_speedscope else profile_document(made).json()
    with replacing(path) as file:
        file.write(text.encode())


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
