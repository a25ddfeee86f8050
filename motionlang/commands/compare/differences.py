"""The differences between a recording and a run in words: scale, travel, times, and moves on one side only."""

from __future__ import annotations

import re
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
# A warning lists so many moves.
MAX_LISTED = 9
# Rates that differ by less than this share agree.
RATE_SHARE = 0.05


def unrecorded_remarks(
    signal: str, rows: Sequence[Row], begin: float, end: float, noun: str
) -> Iterator[Diagnostic]:
    """Yield a warning if moves of an axis are outside of its recording, from `begin` to `end` of the run, s."""
    outside = [row for row in rows if row["peak"] is None and row["lag"] is None]
    if outside:
        first = outside[0]
        more = f" (and {count_of(len(outside) - 1, 'more move')})" if len(outside) > 1 else ""
        yield _warning(
            f"{signal}, {_move(first)}: not recorded{more}, "
            f"the recording has {round(max(begin, 0.0), 3):g} s to {round(end, 3):g} s of {noun}",
            "record from before the start of the program to its end, or give --delay",
        )


def later_remarks(signal: str, matched: Matched, delay: float, noun: str) -> Iterator[Diagnostic]:
    """Yield a warning if an axis moves in its recording after the end of the run."""
    if matched.later:
        start = round(matched.later[0].begin - delay, 2)
        yield _warning(
            f"{signal}: {count_of(len(matched.later), 'move')} from {start:g} s on "
            f"{'is' if len(matched.later) == 1 else 'are'} recorded after the end of {noun}, and not compared",
            "the recording has more than one pass, or --until ends the run too soon",
        )


def scale_remarks(
    row: Row, quantity: str, matched: Matched | None, counts: float, noun: str
) -> Iterator[Diagnostic]:
    """Yield what is wrong with the scale of a signal; `counts` are those of a user unit."""
    signal, column, scale = row["signal"], row["column"], row["scale"]
    if row["points"] == 0:
        yield _warning(
            f"{signal}: no time of {column} lies within {noun}",
            "try another --delay, or another unit of time",
        )
    elif scale and abs(scale - 1.0) > SAME_SHARE and row["moves"]:
        travel = ""
        if matched is not None and quantity == "position":
            pair = max(matched.pairs, key=lambda each: abs(each.run.travel))
            travel = f" ({_size(pair.recorded.travel)} against {_size(pair.run.travel)} uu)"
        usual = usual_factor(scale, counts, quantity)
        yield _warning(
            f"{signal}: {column} moves {scale:.6g} times as far as {noun}{travel}{usual and ': '}{usual}",
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


def stroke_remarks(
    signal: str, matched: Matched, delay: float, rows: Sequence[Row], noun: str
) -> Iterator[Diagnostic]:
    """Yield the differences of the strokes of an axis, whose moves are `rows`: a warning for each kind, with a list."""
    found: dict[str, list[tuple[str, str, str]]] = {}
    for move, text, brief, hint in _differences(signal, matched, delay, rows, noun):
        found.setdefault(hint, []).append((move, text, brief))
    for hint, ((move, text, _), *others) in found.items():
        listed = {
            f"{name.rpartition(' of ')[2]}{name and ' '}{brief}" for name, _, brief in others if name != move
        }
        more = f" (and {len(others)} more{_listed(sorted(listed, key=_by_line))})" if others else ""
        yield _warning(f"{signal}{move and ', '}{move}: {text}{more}", hint)


def _by_line(text: str) -> tuple[float, str]:
    number = re.search(r"\d+", text)
    return float(number[0]) if number else 0.0, text


def _listed(moves: Sequence[str]) -> str:
    more = f"; and {len(moves) - MAX_LISTED} others" if len(moves) > MAX_LISTED else ""
    return f": {'; '.join(moves[:MAX_LISTED])}{more}" if moves else ""


def _differences(
    signal: str, matched: Matched, delay: float, rows: Sequence[Row], noun: str
) -> Iterator[tuple[str, str, str, str]]:
    """Yield the move, the difference, the same in brief, and the hint."""
    for stroke in matched.missing:
        start = round(stroke.begin, 3)
        yield (
            _name(stroke, rows),
            f"{_size(stroke.travel)} uu at {start:g} s are not recorded",
            f"at {start:g} s",
            "the controller skips this move, or executes another line",
        )
    for stroke in matched.extra:
        travel, start = stroke.travel / matched.scale, round(stroke.begin - delay, 3)
        yield (
            "",
            f"{_size(travel)} uu at {start:g} s are recorded, {noun} is at rest",
            f"{_size(travel)} uu at {start:g} s",
            "the program has no such move, or does not reach it",
        )
    for pair in matched.pairs:
        name, length = _name(pair.run, rows), _size(abs(pair.run.travel))
        if matched.has_other_travel(pair):
            travel = pair.recorded.travel / matched.scale
            yield (
                name,
                f"recorded {_rate(travel / pair.run.travel)} times as far, {_size(abs(travel))} against {length} uu",
                f"{_rate(travel / pair.run.travel)} times as far",
                "compare the target of this move",
            )
        elif matched.has_other_time(pair):
            yield (
                name,
                f"recorded the same {length} uu in {_times(matched.scale, pair)}",
                f"in {_times(matched.scale, pair)}",
                "compare speed, acceleration, deceleration and feed override",
            )
    for before, after in pairwise(matched.pairs):
        change = matched.dwell_change(before, after)
        if change:
            when = f"{round(abs(change), 3):g} s {'later' if change > 0.0 else 'earlier'}"
            yield (
                _name(after.run, rows),
                f"recorded {when}, counted from the move before",
                when,
                "compare what the program waits for between the moves",
            )


def _times(scale: float, pair: Pair) -> str:
    """Return by how much more or less time a pair takes, and the speeds or the rates that differ."""
    share = pair.recorded.duration / pair.run.duration - 1.0
    text = f"{float(significant(abs(100.0 * share), 2)):g} % {'more' if share > 0.0 else 'less'} time"
    size = abs(scale)
    speeds = pair.recorded.speed / size, pair.run.speed
    if not isclose(*speeds, rel_tol=SAME_SHARE):
        return f"{text}: {_rate(speeds[0])} against {_rate(speeds[1])} uu/s"
    rates = zip(("accelerated", "decelerated"), pair.recorded.rates, pair.run.rates, strict=True)
    for name, there, here in rates:
        if there is not None and here is not None and not isclose(there / size, here, rel_tol=RATE_SHARE):
            text += f", {name} at {_rate(there / size)} against {_rate(here)} uu/s²"
    return text


def _name(stroke: Stroke, rows: Sequence[Row]) -> str:
    """Return the command and the line of the move that begins a stroke."""
    begun = [row for row in rows if row["start_time"] <= stroke.begin + 1e-6]
    return _move(begun[-1]) if begun else ""


def _move(row: Row) -> str:
    if not row["line"]:
        return f"move at {round(row['start_time'], 3):g} s"
    return f"{row['command'] or 'move'} of line {row['line']}"


def _size(travel: float) -> str:
    """Format a travel, whose last digits depend on the samples."""
    return f"{float(f'{travel:.5g}'):.10g}"


def _rate(value: float) -> str:
    """Format a speed or an acceleration, which are known to four digits."""
    return f"{float(f'{value:.4g}'):.10g}"


def _warning(message: str, hint: str) -> Diagnostic:
    return Diagnostic("recording", message, severity="warning", hint=hint)
