"""The differences between a recording and a run in words: scale, travel, times, and moves on one side only."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from math import isclose
from typing import Any

from motionlang.commands.compare.strokes import SAME_SHARE, Matched, Pair, Stroke
from motionlang.kernel import Diagnostic
from motionlang.kernel.tools import count_of
from motionlang.views.formatting import significant

Row = Mapping[str, Any]

# The usual factors of units, and what they convert. Inverse factors are read in the other direction.
USUAL = {
    25.4: "millimetres and inches",
    1000.0: "a prefix of the unit, such as µm and mm",
    360.0: "degrees and turns",
}
# A factor this close to a usual one is that one; the largest count of teeth of a gear that is named.
NEAR, MAX_GEAR = 0.003, 5
# Rates that differ by less than this share agree.
RATE_SHARE = 0.05


def unrecorded_remarks(signal: str, rows: Sequence[Row], begin: float, end: float) -> Iterator[Diagnostic]:
    """Yield a warning if moves of an axis are outside of its recording, from `begin` to `end` of the run, s."""
    outside = [row for row in rows if row["peak"] is None and row["lag"] is None]
    if outside:
        first = outside[0]
        more = f" (and {count_of(len(outside) - 1, 'more move')})" if len(outside) > 1 else ""
        yield _warning(
            f"{signal}, {first['command'] or 'move'} of line {first['line']}: not recorded{more}, "
            f"the recording has {round(max(begin, 0.0), 3):g} s to {round(end, 3):g} s of the run",
            "record from before the start of the program to its end, or give --delay",
        )


def scale_remarks(row: Row, quantity: str, matched: Matched | None, counts: float) -> Iterator[Diagnostic]:
    """Yield what is wrong with the scale of a signal; `counts` are those of a user unit."""
    signal, column, scale = row["signal"], row["column"], row["scale"]
    if row["points"] == 0:
        yield _warning(
            f"{signal}: no time of {column} lies within the run",
            "try another --delay, or another unit of time",
        )
    elif scale and abs(scale - 1.0) > SAME_SHARE and row["moves"]:
        travel = ""
        if matched is not None and quantity == "position":
            pair = max(matched.pairs, key=lambda each: abs(each.run.travel))
            travel = f" ({_size(pair.recorded.travel)} against {_size(pair.run.travel)} uu)"
        usual = usual_factor(scale, counts, quantity)
        yield _warning(
            f"{signal}: {column} moves {scale:.6g} times as far as the run{travel}{usual and ': '}{usual}",
            f"if its unit differs: --map {signal}={column}*{1.0 / scale:.6g}",
        )


def usual_factor(scale: float, counts: float, quantity: str) -> str:
    """Return what a factor usually means, "" if it is no usual one."""
    size = abs(scale)
    names = dict(USUAL)
    if quantity != "position":
        names[60.0] = "minutes and seconds"
    names.setdefault(abs(counts), "counts and user units")
    for factor, name in names.items():
        if factor != 1.0 and (
            isclose(size, factor, rel_tol=NEAR) or isclose(size, 1.0 / factor, rel_tol=NEAR)
        ):
            return name
    if isclose(scale, -1.0, rel_tol=NEAR):
        return "the opposite direction"
    for driver in range(1, MAX_GEAR + 1):
        for driven in range(1, MAX_GEAR + 1):
            if driver != driven and isclose(size, driver / driven, rel_tol=NEAR):
                return f"a gear of {driver}:{driven}"
    return ""


def stroke_remarks(signal: str, matched: Matched, delay: float, rows: Sequence[Row]) -> Iterator[Diagnostic]:
    """Yield the differences of the strokes of an axis, whose moves are `rows`; those of a line only once."""
    found: dict[tuple[str, str], list[str]] = {}
    for text, hint in _differences(signal, matched, delay, rows):
        found.setdefault((text.partition(":")[0], hint), []).append(text)
    for (_, hint), texts in found.items():
        yield _warning(texts[0] + (f" (and {len(texts) - 1} more)" if len(texts) > 1 else ""), hint)


def _differences(
    signal: str, matched: Matched, delay: float, rows: Sequence[Row]
) -> Iterator[tuple[str, str]]:
    for stroke in matched.missing:
        name, start = _name(signal, stroke, rows), round(stroke.begin, 3)
        yield (
            f"{name}: {_size(stroke.travel)} uu at {start:g} s are not recorded",
            "the controller skips this move, or executes another line",
        )
    for stroke in matched.extra:
        travel = stroke.travel / matched.scale
        yield (
            f"{signal}: {_size(travel)} uu at {round(stroke.begin - delay, 3):g} s are recorded, the run is at rest",
            "the program has no such move, or does not reach it",
        )
    for pair in matched.pairs:
        name, length = _name(signal, pair.run, rows), _size(abs(pair.run.travel))
        if matched.has_other_travel(pair):
            travel = pair.recorded.travel / matched.scale
            yield (
                f"{name}: recorded {_rate(travel / pair.run.travel)} times as far, "
                f"{_size(abs(travel))} against {length} uu",
                "compare the target of this move",
            )
        elif matched.has_other_time(pair):
            yield (
                f"{name}: recorded the same {length} uu in {_times(matched.scale, pair)}",
                "compare speed, acceleration, deceleration and feed override",
            )
    for before, after in pairwise(matched.pairs):
        change = matched.dwell_change(before, after)
        if change:
            when = f"{round(abs(change), 3):g} s {'later' if change > 0.0 else 'earlier'}"
            yield (
                f"{_name(signal, after.run, rows)}: recorded {when}, counted from the move before",
                "compare what the program waits for between the moves",
            )


def _times(scale: float, pair: Pair) -> str:
    """Return by how much more or less time a pair takes, and the speeds or the rates that differ."""
    share = pair.recorded.duration / pair.run.duration - 1.0
    text = f"{significant(abs(100.0 * share), 2)} % {'more' if share > 0.0 else 'less'} time"
    size = abs(scale)
    speeds = pair.recorded.speed / size, pair.run.speed
    if not isclose(*speeds, rel_tol=SAME_SHARE):
        return f"{text}: {_rate(speeds[0])} against {_rate(speeds[1])} uu/s"
    rates = zip(("accelerated", "decelerated"), pair.recorded.rates, pair.run.rates, strict=True)
    for name, there, here in rates:
        if there is not None and here is not None and not isclose(there / size, here, rel_tol=RATE_SHARE):
            text += f", {name} at {_rate(there / size)} against {_rate(here)} uu/s²"
    return text


def _name(signal: str, stroke: Stroke, rows: Sequence[Row]) -> str:
    """Return the signal with the command and the line of the move that begins a stroke."""
    begun = [row for row in rows if row["start_time"] <= stroke.begin + 1e-6]
    return f"{signal}, {begun[-1]['command'] or 'move'} of line {begun[-1]['line']}" if begun else signal


def _size(travel: float) -> str:
    """Format a travel, whose last digits depend on the samples."""
    return f"{float(f'{travel:.5g}'):.10g}"


def _rate(value: float) -> str:
    """Format a speed or an acceleration, which are known to four digits."""
    return f"{float(f'{value:.4g}'):.10g}"


def _warning(message: str, hint: str) -> Diagnostic:
    return Diagnostic("recording", message, severity="warning", hint=hint)
