"""Properties of every run: each check yields a sentence for each violation."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator
from decimal import Decimal
from itertools import chain, pairwise
from math import fsum, isfinite, isnan
from pathlib import Path
from typing import Any

import jsonschema  # type: ignore[import-untyped]

from motionlang.kernel import Run
from motionlang.kernel.log import LoggedMove
from motionlang.views.report import render
from tests.proof import prove
from tests.proof.expected_motion import ExpectedMotion

SCHEMA = json.loads((Path(__file__).parents[2] / "docs" / "report.schema.json").read_text(encoding="utf-8"))
# Seconds by which the time of an end may be rounded, and the relative error of a position.
ROUNDED, SLACK = 1e-9, 1e-6
# A width beyond any table, so that no column is dropped.
WIDE = 1000
# Cells of a row are at least two blanks apart.
_GAP = re.compile(" {2,}")
_FIGURES = ("start_time", "duration", "start", "end", "distance", "peak_speed")


def proved(result: Run) -> Iterator[str]:
    """Check that the motion is within the commands of the program."""
    for each in prove(result).violations:
        yield f"proof: {each.line}: {each.message}"


def in_order(result: Run) -> Iterator[str]:
    """Check that time never decreases, and nothing is later than the end of the run."""
    log = result.controller.log
    streams: dict[str, Iterable[float]] = {
        "events": (each.time for each in log.events),
        "prints": (each.time for each in log.prints),
        "moves": (each.start_time for each in log.moves),
        "waits": (each.until for each in log.waits),
        "loops": (each.until for each in log.loops),
        "turns": (each.time for each in log.slices),
        "outputs": (each.time for each in log.outputs),
        "inputs": (each.time for each in log.inputs),
        "analogue outputs": (each.time for each in log.analogue_outputs),
    }
    for number, axis in result.controller.axes.items():
        streams[f"the track of axis {number}"] = axis.starts
    for name, stream in streams.items():
        times = [*stream, result.time]
        before, after = next((two for two in pairwise(times) if not two[0] <= two[1]), (0.0, 0.0))
        if before != after:
            yield f"order: {name}: {before!r} s comes before {after!r} s"
    for each in chain[Any](log.waits, log.loops):
        if each.since > each.until:
            yield f"order: {each} ends before it begins"


def entries_end(result: Run) -> Iterator[str]:
    """Check that completed entries end within the run, the last one where its axis is."""
    axes, data = result.controller.axes, ExpectedMotion.of_run(result).data
    last: dict[int, LoggedMove] = {}
    for move in result.controller.log.moves:
        profile, axis = move.profile, axes[move.axis]
        if profile is None:
            continue
        where = f"axis {move.axis} from {move.start_time:.6f} s, line {move.line}"
        if isnan(profile.start) or isnan(profile.end) or isnan(profile.duration):
            yield f"log: {where}: a figure is not a number"
        end = move.start_time + profile.duration
        late = end > result.time + ROUNDED * (1.0 + result.time)
        in_motion = any(move is each for each in axis.entries)  # several during a blend
        if late and isfinite(end) and not in_motion and (move.ended or result.status == "ended"):
            yield f"log: {where}: it ends at {end:.6f} s, the run at {result.time:.6f} s"
        if not move.overlaid and not move.offset:
            last[move.axis] = move
    for number, move in last.items():
        axis, profile, track = axes[number], move.profile, axes[number]
        assert profile is not None
        end = move.start_time + profile.duration
        if end > result.time or axis.move is not None or any(time > end for time in track.starts):
            continue
        shift = data[number][-1] - data[number][track.index_at(move.start_time)]
        here = axis.position(result.time)
        if abs(here - profile.end - shift) > SLACK * max(1.0, abs(here)):
            yield f"log: axis {number} is at {here:g}, its last entry ends at {profile.end:g}"


def phases_add_up(report: dict[str, Any]) -> Iterator[str]:
    """Check that the phases of a move add up to its duration and distance."""
    for move in report["moves"]:
        for name in ("duration", "distance"):
            figures = [phase[name] for phase in move["phases"]]
            if not figures or None in figures or move[name] is None:
                continue
            size = max(map(abs, (*figures, move[name], *(move[each] or 0.0 for each in ("start", "end")))))
            if abs(fsum(figures) - move[name]) > SLACK * max(size, 1e-3):
                yield f"phases: line {move['line']}: {name} {move[name]!r}, its phases {fsum(figures)!r}"


def matches_schema(report: dict[str, Any]) -> Iterator[str]:
    """Check the report against `docs/report.schema.json`."""
    for error in jsonschema.Draft202012Validator(SCHEMA).iter_errors(report):
        yield f"schema: {error.json_path}: {error.message[:100]}"


def table_agrees(result: Run, report: dict[str, Any]) -> Iterator[str]:
    """Check that the printed table has the report's moves, events, axes and figures.

    The figures must agree to the last digit that is printed.
    """
    blocks = render(result, width=WIDE, everything=True).rstrip().split("\n\n")
    moves = [row for row in _rows(blocks, "axis  command") if "├" not in row and "└" not in row]
    rows: dict[str, list[tuple[list[str], list[object]]]] = {"moves": [], "events": [], "axes": []}
    columns = ("axis", "command", "line", "profile", *_FIGURES)
    for text, move in zip(moves, report["moves"], strict=False):
        rows["moves"].append((_GAP.split(text.strip()), [move[name] for name in columns]))
    events = _rows(blocks, "events")
    for text, event in zip(events, report["events"], strict=False):
        rows["events"].append((_GAP.split(text.strip()), [event["time"], event["kind"]]))
    axes = _rows(blocks, "axis  position")
    for text, axis in zip(axes, report["axes"], strict=False):
        rows["axes"].append(
            (_GAP.split(text.strip()), [axis["axis"], axis.get("wrapped_position", axis["position"])])
        )
    for name, shown in (("moves", moves), ("events", events), ("axes", axes)):
        if len(shown) != len(report[name]):
            yield f"table: {len(shown)} of {len(report[name])} {name}"
        for cells, values in rows[name]:
            for cell, value in zip(cells, values, strict=False):
                if not _is_shown(cell, value):
                    yield f"table: {name}: {cell} for {value!r} in {cells}"


def _rows(blocks: list[str], head: str) -> list[str]:
    """Return the rows of the table with the heading `head`."""
    block = next((each for each in blocks if re.sub(" {2,}", "  ", each).lstrip().startswith(head)), "")
    lines = block.split("\n")
    rule = next((k for k, line in enumerate(lines) if line.startswith("─")), len(lines))
    return lines[rule + 1 :]


def _is_shown(cell: str, value: object) -> bool:
    if isinstance(value, str):
        return cell == value
    if value is None:
        return not any(digit in cell for digit in "0123456789")
    assert isinstance(value, int | float)
    shown = Decimal(cell)
    exponent = shown.as_tuple().exponent
    assert isinstance(exponent, int)
    return abs(float(shown) - value) <= 0.5000001 * 10.0**exponent + 1e-12 * abs(value)
