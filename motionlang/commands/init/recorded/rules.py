"""The rule that explains the recorded changes of an input, with its measured figures.

    on, or off, all the time
    follows an output       each change comes a delay after a change of the output; on and off may differ in delay
    follows with `for`      it is active for some time after each change of an output
    follows a position      it changes where an axis passes, once or every so many user units
    every so many seconds   it is active again and again
    at a time               it changes once, or is active once, as of a button
    its changes one by one  for anything else

Each form is measured for each output and axis. A form is a rule if it explains every change of the input, but for
those next to a gap, within a spread that a machine may have. The output may change without an effect on the input, for
example when a part is missing; such a rule stays a guess. The rule with the fewest of these is chosen, then that with
the smallest spread. Of rules with the same spread, within the sampling, the simplest is chosen, then the one whose
output changed last before the input.

Cost: outputs and axes times the changes of an input.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import fsum, inf
from statistics import fmean, median
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.commands.init.recorded.recording import (
    Digital,
    MeasuredRecording,
    RecordedChange,
    Series,
    least_speed,
    slopes,
    window_of,
)
from motionlang.exploration import Entry
from motionlang.kernel.tools import count_of

Array = NDArray[np.float64]

# A delay may vary by this share of it, by this time, s, or by so many rows.
SPREAD_SHARE, SPREAD, SPREAD_ROWS = 0.4, 0.01, 4.0
# So many changes that agree are no guess any more.
SEEN = 3
# A rule is none if more than this share of the changes of its output have no effect.
MISSED = 0.34
# One pulse with equal delays after both changes of an output, s, follows it; a longer delay may be chance.
NEAR = 1.0
# A pulse that each change of an output begins anew lasts until the other one: longer than any run, s.
FOR_EVER = 86400.0
# An input follows a position if this share of its changes is in the middle of a move.
IN_MOVES = 0.9
# Regions of an axis at most in which an input is active, each one mark or several at equal distances.
MAX_REGIONS = 20
# The rows may have missed some marks between the first and the last, but not most.
MAX_LEFT_OUT = 2
# A figure whose values differ by more than this share of it is a guess.
WIDE = 0.2
# Decimal places of times and positions.
PLACES = 3


class MeasuredFigure(NamedTuple):
    """A measured quantity: the figure to write, by how much the values and the rows may differ from it, and how often.

    `is_wide` is True if the values differ by more than a machine that repeats itself, and than the rows.
    """

    value: float
    spread: float
    within: float
    times: int
    unit: str
    is_wide: bool

    def __str__(self) -> str:
        return f"{self.interval} ({count_of(self.times, 'change')})"

    @property
    def interval(self) -> str:
        """The figure with its interval, such as "0.250 s ± 0.005"."""
        return f"{self.value:.{PLACES}f} {self.unit} ± {max(self.within, 10.0**-PLACES):.{PLACES}f}"


class MeasuredRule(NamedTuple):
    """Why an input changes: entries of the machine file, each with a comment, and how well they explain it.

    `subject` names the cause. `seen` counts the changes that agree, 0 if it assumes something before the recording,
    `missed` has the times at which the cause had no effect, `spread` is that of the times, s, `delay` the time after
    the cause. The more a rule assumes, the larger is its `size`. `others` are the subjects of rules that explain the
    input equally well, `reason` says why not these.
    """

    subject: str
    entries: tuple[Entry, ...]
    comments: tuple[str, ...]
    seen: int
    spread: float
    size: int
    delay: float = 0.0
    missed: tuple[float, ...] = ()
    others: tuple[str, ...] = ()
    reason: str = ""
    is_explained: bool = True
    is_wide: bool = False
    is_confirmed: bool = True

    @property
    def is_guess(self) -> bool:
        """True if too few changes agree, some contradict, they differ much, or a run does not have them."""
        is_sure = self.is_explained and self.is_confirmed and not self.is_wide
        return self.seen < SEEN or bool(self.missed) or not is_sure


def rules_of(number: int, channel: Digital, recording: MeasuredRecording) -> list[MeasuredRule]:
    """Return the rules that may explain an input, the likeliest first; the last one is its changes as recorded."""
    if not channel.changes:
        text = f"{'on' if channel.first else 'off'} in all of the recording"
        constant: Entry = {"channel": number, "at": 0.0, **({} if channel.first else {"value": 0})}
        seen = 0 if recording.is_late else SEEN  # what was before it begins, nothing shows
        return [MeasuredRule("", (constant,), (text,), seen, 0.0, 0)]
    found = [*_following(number, channel, recording), *_along_axes(number, channel, recording)]
    found += [*_every(number, channel, recording), *_once(number, channel, recording)]
    least = min((len(each.missed) for each in found), default=0)
    best = (
        min((each.spread for each in found if len(each.missed) == least), default=0.0) + 2.0 * recording.step
    )

    def is_equal(rule: MeasuredRule) -> bool:
        return len(rule.missed) == least and rule.spread <= best

    found.sort(key=lambda each: (not is_equal(each), len(each.missed), each.size, each.delay, each.subject))
    equal = [each for each in found if is_equal(each)]
    rules = [_with_others(each, equal[k + 1 :]) if k < len(equal) else each for k, each in enumerate(found)]
    return [*rules, as_recorded(number, channel)]


def _with_others(rule: MeasuredRule, equal: Sequence[MeasuredRule]) -> MeasuredRule:
    """Return a rule with those that explain an input equally well, and why not these."""
    others = dict.fromkeys(each.subject for each in equal if each.subject and each.subject != rule.subject)
    is_simpler = any(each.size > rule.size for each in equal if each.subject in others)
    return rule._replace(
        others=tuple(others), reason="is simpler" if is_simpler else "changes last before it"
    )


def _figure(values: Sequence[float], within: float, unit: str = "s") -> MeasuredFigure:
    """Return the mean of values, each of which is known within so much."""
    value, spread = fmean(values), max(values) - min(values)
    rounded = round(value, PLACES)
    deviation = max(abs(each - value) for each in values)
    is_wide = unit == "s" and spread > WIDE * abs(value) + 2.0 * within
    return MeasuredFigure(rounded, spread, max(deviation, within), len(values), unit, is_wide)


def _tolerance(value: float, recording: MeasuredRecording) -> float:
    """Return by how much a measured time may vary around its median, s."""
    return max(SPREAD_SHARE * abs(value), SPREAD, SPREAD_ROWS * recording.step)


# ------------------------------------------------------------------------------------------ outputs


class _Pairs(NamedTuple):
    """Changes of an input with those of an output that led to them, and those of the output without an effect."""

    pairs: list[tuple[RecordedChange, RecordedChange]]
    missed: list[RecordedChange]

    def delays(self, level: int) -> list[float]:
        """Return the delays to one level of the input, s."""
        return [max(after.time - before.time, 0.0) for before, after in self.pairs if after.level == level]


def _paired(
    changes: Sequence[RecordedChange], causes: Sequence[RecordedChange], recording: MeasuredRecording
) -> _Pairs | None:
    """Pair each change of an input with the last cause before it; None if one has no cause at a usual time before.

    `causes` have the level that they lead to. A change without a cause may come from a gap, or from before a recording
    that begins after power-up.
    """
    by_level = {level: [each for each in causes if each.level == level] for level in (0, 1)}
    times = {level: [each.time for each in by_level[level]] for level in (0, 1)}
    found: list[tuple[RecordedChange, RecordedChange]] = []
    without: list[RecordedChange] = []
    # What changes in the same row may be the effect: a run judges, but not one of a recording that begins later.
    rows = -1e-9 if recording.is_late else recording.step / 2
    for each in changes:
        latest = each.time + rows + (0.0 if recording.is_late else each.within)
        at = bisect_right(times[each.level], latest) - 1
        if at < 0:
            without.append(each)
        else:
            found.append((by_level[each.level][at], each))
    usual = {
        level: median(leads)
        for level in (0, 1)
        if (leads := [b.time - a.time for a, b in found if b.level == level])
    }
    pairs: list[tuple[RecordedChange, RecordedChange]] = []
    for cause, each in found:
        lead = each.time - cause.time
        if abs(lead - usual[each.level]) <= _tolerance(usual[each.level], recording):
            pairs.append((cause, each))
        else:
            without.append(each)
    for each in without:
        since = each.time - 1.5 * usual.get(each.level, 0.0) - 2.0 * recording.step
        is_before = recording.is_late and since <= recording.begin
        if not is_before and not recording.has_gap(since, each.time):
            return None
    used = {(cause.time, cause.level) for cause, _ in pairs}
    if len(used) < len(pairs):  # two changes cannot have the same cause
        return None
    missed = [
        each
        for each in causes
        if (each.time, each.level) not in used
        and (end := each.time + 2.0 * usual.get(each.level, 0.0) + 2.0 * recording.step) < recording.end
        and not recording.has_gap(each.time - recording.step, end)
    ]
    return _Pairs(pairs, missed)


def _causes(output: Digital, *, is_inverted: bool) -> list[RecordedChange]:
    return [each._replace(level=each.level ^ is_inverted) for each in output.changes]


def _following(number: int, channel: Digital, recording: MeasuredRecording) -> Iterator[MeasuredRule]:
    """Yield the rules by which an input follows an output: both of its changes, or pulses after one of them."""
    for output, switched in sorted(recording.outputs.items()):
        for is_inverted in (False, True):
            causes = _causes(switched, is_inverted=is_inverted)
            # A recording that begins late may begin within a delay.
            if recording.is_late or channel.first == (switched.first ^ is_inverted):
                yield from _followed(number, channel, output, causes, recording, is_inverted=is_inverted)
            for active in (0, 1) if recording.is_late else (1 - channel.first,):
                yield from _pulses(
                    number, channel, output, causes, active, recording, is_inverted=is_inverted
                )


def _followed(
    number: int,
    channel: Digital,
    output: int,
    causes: list[RecordedChange],
    recording: MeasuredRecording,
    *,
    is_inverted: bool,
) -> Iterator[MeasuredRule]:
    paired = _paired(channel.changes, causes, recording)
    if paired is None or not paired.pairs:
        return
    to_on, to_off = paired.delays(1), paired.delays(0)
    delays = to_on + to_off
    # A change to the level that the input already has needs no effect.
    missed = tuple(each.time for each in _effective(paired.missed, channel))
    if len(missed) > MISSED * len(causes):
        return
    base: Entry = {"channel": number, "output": output}
    inverted: Entry = {"value": 0} if is_inverted else {}
    subject = f"output {output}"
    is_equal = (
        not to_on or not to_off or abs(median(to_on) - median(to_off)) <= max(2.0 * recording.step, SPREAD)
    )
    if is_equal and max(delays) - min(delays) <= _tolerance(median(delays), recording):
        if len(delays) < SEEN and (len(delays) < 2 or median(delays) > NEAR):
            return
        figure = _figure(delays, recording.step)
        entry = base | inverted | {"delay": figure.value}
        # A pair of changes, each with its own cause, agrees with itself.
        yield MeasuredRule(
            subject,
            (entry,),
            (str(figure),),
            len(delays),
            figure.spread,
            0,
            figure.value,
            missed,
            is_wide=figure.is_wide,
        )
    elif len(to_on) > 1 and len(to_off) > 1:
        # The later entry decides about the level at power-up.
        parts = [(1, to_on), (0, to_off)] if channel.first else [(0, to_off), (1, to_on)]
        entries, comments, is_wide = [], [], False
        for level, own in parts:
            figure = _figure(own, recording.step)
            entries.append(
                base
                | {"level": level ^ is_inverted, "delay": figure.value, "for": FOR_EVER}
                | ({} if level else {"value": 0})
            )
            comments.append(f"{'on' if level else 'off'} after {figure}")
            is_wide |= figure.is_wide
        spread = max(max(own) - min(own) for _, own in parts)
        lead = min(median(to_on), median(to_off))
        yield MeasuredRule(
            subject, tuple(entries), tuple(comments), len(delays), spread, 2, lead, missed, is_wide=is_wide
        )


def _effective(missed: Sequence[RecordedChange], channel: Digital) -> Iterator[RecordedChange]:
    """Yield the causes after which the input should have had another level than it had at that time."""
    for each in missed:
        if _level(channel, each.time) != each.level:
            yield each


def _level(channel: Digital, time: float) -> int:
    at = bisect_right([each.time for each in channel.changes], time) - 1
    return channel.first if at < 0 else channel.changes[at].level


def _pulses(
    number: int,
    channel: Digital,
    output: int,
    causes: list[RecordedChange],
    active: int,
    recording: MeasuredRecording,
    *,
    is_inverted: bool,
) -> Iterator[MeasuredRule]:
    starts = [each for each in channel.changes if each.level == active]
    lengths = [b.time - a.time for a, b in pairwise(channel.changes) if a.level == active]
    if len(starts) < 2 or not lengths or not _agree(lengths, recording):
        return
    paired = _paired(starts, [each for each in causes if each.level == active], recording)
    if paired is None or len(paired.pairs) < 2:
        return
    missed = tuple(each.time for each in paired.missed)
    if len(missed) > MISSED * len(causes) / 2:
        return
    delay, length = _figure(paired.delays(active), recording.step), _figure(lengths, recording.step)
    entry: Entry = {"channel": number, "output": output, "delay": delay.value, "for": length.value}
    entry |= {} if active ^ is_inverted else {"level": 0}
    entry |= {} if active else {"value": 0}
    yield MeasuredRule(
        f"output {output}",
        (entry,),
        (f"{delay.interval}; for {length}",),
        len(starts),
        max(delay.spread, length.spread),
        3,
        delay.value,
        missed,
        is_wide=delay.is_wide or length.is_wide,
    )


def _agree(times: Sequence[float], recording: MeasuredRecording) -> bool:
    return max(times) - min(times) <= _tolerance(median(times), recording)


# ------------------------------------------------------------------------------------------ positions


def _along_axes(number: int, channel: Digital, recording: MeasuredRecording) -> Iterator[MeasuredRule]:
    for axis, path in sorted(recording.positions.items()):
        yield from _along(number, channel, axis, path, recording)


def _along(
    number: int, channel: Digital, axis: int, path: Series, recording: MeasuredRecording
) -> Iterator[MeasuredRule]:
    """Yield the rule by which an input follows the position of an axis, if there is one."""
    if len(channel.changes) < SEEN or not float(np.ptp(path.values)) > 0.0:
        return
    times = np.array([each.time for each in channel.changes])
    window = window_of(path)
    speeds = slopes(path, window)
    at = np.interp(times, path.times, path.values)
    speed = np.interp(times, path.times, speeds)
    moves = np.abs(speed) > least_speed(path, window)
    if moves.mean() < IN_MOVES:
        return
    pairs = [
        (float(x), float(v), each.level)
        for x, v, each, is_moving in zip(at, speed, channel.changes, moves, strict=True)
        if is_moving and not recording.has_gap(each.time - each.within, each.time + each.within)
    ]
    fastest, usual = float(np.abs(speed).max()), float(np.median(np.abs(speed[moves])))
    for active in (1, 0):
        lows = [x for x, v, level in pairs if (level == active) == (v > 0.0)]
        highs = [x for x, v, level in pairs if (level == active) != (v > 0.0)]
        tolerance = 3.0 * recording.step * fastest + 1e-6
        for regions in _regions(lows, highs, tolerance, recording.step * usual):
            missed = _passed(regions, active, channel, path, recording)
            if missed is None or len(missed) > MISSED * len(pairs) / 2:
                continue
            keys = [each.keys for each in regions] if active else _complement(regions)
            if not keys:
                continue
            entries = tuple({"channel": number, "axis": axis, **each} for each in keys)
            seconds = max(each.spread for each in regions) / usual
            texts = tuple(each.text for each in regions)
            yield MeasuredRule(f"axis {axis}", entries, texts, len(pairs), seconds, 1, missed=missed)


class _Region(NamedTuple):
    """Where an input is active: keys of the entry, its edges, the spread of the positions in user units, a comment."""

    keys: Entry
    edges: tuple[tuple[float, float], ...]
    spread: float
    text: str


def _regions(
    lows: list[float], highs: list[float], tolerance: float, within: float
) -> Iterator[list[_Region]]:
    """Yield where an input may be active that changes at these ends: beyond one, or in marks.

    Marks are at equal distances from the first to the last one, of which the rows may have missed some, or those that
    were seen.
    """
    firsts, lasts = (
        [_figure(each, within, "uu") for each in _groups(ends, tolerance)] for ends in (lows, highs)
    )
    if len(firsts) == 1 and not lasts:
        (edge,) = firsts
        yield [_Region({"above": edge.value}, ((edge.value, inf),), edge.spread, str(edge))]
    if len(lasts) == 1 and not firsts:
        (edge,) = lasts
        yield [_Region({"below": edge.value}, ((-inf, edge.value),), edge.spread, str(edge))]
    ends = [each.value for pair in zip(firsts, lasts, strict=False) for each in pair]
    if not firsts or len(firsts) != len(lasts) or ends != sorted(ends):
        return
    marks = [*zip(firsts, lasts, strict=True)]
    steps = [b[0].value - a[0].value for a, b in pairwise(marks)]
    counts = [round((low.value - firsts[0].value) / min(steps)) if steps else 0 for low, _ in marks]
    if _is_even(marks, counts, tolerance) and counts[-1] < MAX_LEFT_OUT * len(marks):
        yield [_marks(marks, counts)]
    found: list[_Region] = []
    while marks:
        count = min(len(marks), 2)
        while count < len(marks) and _is_even(marks[: count + 1], range(count + 1), tolerance):
            count += 1
        found.append(_marks(marks[:count], range(count)))
        marks = marks[count:]
    if 1 < len(found) <= MAX_REGIONS:
        yield found


def _complement(regions: Sequence[_Region]) -> list[Entry]:
    """Return the keys of where an input is on that is off in a region; none for several regions."""
    if len(regions) > 1 or len(regions[0].edges) > 1:
        return []
    ((low, high),) = regions[0].edges
    found: list[Entry] = [{"below": low}, {"above": high}]
    return [each for each, end in zip(found, (low, high), strict=True) if abs(end) < inf]


def _groups(values: list[float], tolerance: float) -> list[list[float]]:
    """Return values in groups, so that neighbours in one are as close as the tolerance."""
    found: list[list[float]] = []
    for each in sorted(values):
        if found and each - found[-1][0] <= tolerance:
            found[-1].append(each)
        else:
            found.append([each])
    return found


_Mark = tuple[MeasuredFigure, MeasuredFigure]


def _is_even(marks: Sequence[_Mark], counts: Sequence[int], tolerance: float) -> bool:
    """True if marks lie at equal distances, so many of them from the first one."""
    every, first = _line(marks, counts)
    return all(
        abs(first + count * every - low.value) <= tolerance
        for count, (low, _) in zip(counts, marks, strict=True)
    )


def _line(marks: Sequence[_Mark], counts: Sequence[int]) -> tuple[float, float]:
    """Return the distance between marks, and the position of the first one."""
    if len(marks) == 1:
        return 0.0, marks[0][0].value
    every, first = np.polyfit(np.array(counts), np.array([low.value for low, _ in marks]), 1)
    return float(every), float(first)


def _marks(marks: Sequence[_Mark], counts: Sequence[int]) -> _Region:
    """Return the region of marks at equal distances."""
    (first, last), number = marks[0], counts[-1] + 1
    spread = max(max(low.spread, high.spread) for low, high in marks)
    if number == 1:
        one = ((first.value, last.value),)
        return _Region({"between": [first.value, last.value]}, one, spread, f"{first.interval}, and {last}")
    every, at = _line(marks, counts)
    width = fmean(high.value - low.value for low, high in marks)
    between = [round(at, PLACES), round(at + width, PLACES)]
    keys: Entry = {"between": between, "every": round(every, PLACES), "times": number}
    within = max(
        10.0**-PLACES, *(abs(at + k * every - low.value) for k, (low, _) in zip(counts, marks, strict=True))
    )
    within = max(within, first.within)
    changes = count_of(int(fsum(each.times for mark in marks for each in mark)), "change")
    text = f"{at:.{PLACES}f} uu ± {within:.{PLACES}f}, every {every:.{PLACES}f} uu ({changes})"
    edges = tuple((at + k * every, at + k * every + width) for k in range(number))
    return _Region(keys, edges, spread, text)


def _passed(
    regions: Sequence[_Region], active: int, channel: Digital, path: Series, recording: MeasuredRecording
) -> tuple[float, ...] | None:
    """Return when an axis was in a region without an effect; None if the input was active elsewhere."""
    inside = np.zeros(len(path.values), dtype=bool)
    for region in regions:
        for low, high in region.edges:
            inside |= (path.values >= low) & (path.values <= high)
    times = [each.time for each in channel.changes]
    at = np.searchsorted(times, path.times, "right") - 1
    levels = np.array([each.level for each in channel.changes])
    actual = np.where(at < 0, channel.first, levels[at]) == active
    missed: list[float] = []
    for first, past in _stretches(actual != inside):
        begin, end = float(path.times[first]), float(path.times[past - 1])
        if end - begin > SPREAD_ROWS * recording.step + SPREAD and not recording.has_gap(begin, end):
            if actual[first]:
                return None
            missed.append(begin)
    return tuple(missed)


def _stretches(differs: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    """Yield the stretches of rows in which something is true, as the first row and the one after the last."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], differs, [False])).astype(np.int8)))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)


# ------------------------------------------------------------------------------------------ times


def _every(number: int, channel: Digital, recording: MeasuredRecording) -> Iterator[MeasuredRule]:
    """Yield the rule of an input that is active again and again."""
    starts = [each.time for each in channel.changes if each.level != channel.first]
    lengths = [b.time - a.time for a, b in pairwise(channel.changes) if a.level != channel.first]
    periods = [b - a for a, b in pairwise(starts)]
    if channel.first or len(starts) < SEEN or not lengths or not _agree(lengths, recording):
        return
    period, length = _figure(periods, recording.step), _figure(lengths, recording.step)
    drift = max(abs(each - starts[0] - k * period.value) for k, each in enumerate(starts))
    if drift > max(
        SPREAD, SPREAD_ROWS * recording.step
    ):  # a clock, not a person who is about as fast each time
        return
    mean = round((starts[-1] - starts[0]) / (len(starts) - 1), PLACES)
    entry: Entry = {"channel": number, "at": round(starts[0], PLACES), "for": length.value, "every": mean}
    if starts[-1] + 1.5 * mean < recording.end:
        entry["times"] = len(starts)
    yield MeasuredRule(
        "time",
        (entry,),
        (f"every {period.interval}; for {length}",),
        len(starts) if recording.is_placed else 0,
        max(period.spread, length.spread),
        4,
        is_wide=length.is_wide,
    )


def _once(number: int, channel: Digital, recording: MeasuredRecording) -> Iterator[MeasuredRule]:
    """Yield the rule of an input that changes once, or is active once."""
    changes = channel.changes
    if len(changes) > 2:
        return
    figures = [_figure([each.time], each.within) for each in changes]
    entry: Entry = {"channel": number, "at": figures[0].value}
    if channel.first:
        entries: list[Entry] = [{"channel": number, "at": 0.0}]
        entries += [
            {"channel": number, "at": at.value, "value": each.level}
            for at, each in zip(figures, changes, strict=True)
        ]
        yield MeasuredRule("time", tuple(entries), ("", *map(str, figures)), 1, 0.0, 5)
    elif len(changes) == 1:
        yield MeasuredRule("time", (entry,), (str(figures[0]),), 1, 0.0, 1)
    else:
        length = _figure([changes[1].time - changes[0].time], 2.0 * changes[0].within)
        text = f"{figures[0].interval}; for {length}"
        yield MeasuredRule("time", ({**entry, "for": length.value},), (text,), 1, 0.0, 1)


def as_recorded(number: int, channel: Digital) -> MeasuredRule:
    """Return the recorded changes of an input, which no rule explains.

    Each is as early as it may have been. If it is later than it was, a program that polls may see it a period later.
    """
    entries: list[Entry] = [{"channel": number, "at": 0.0}] if channel.first else []
    entries += [
        {"channel": number, "at": max(round(each.time - each.within, PLACES), 0.0), "value": each.level}
        for each in channel.changes
    ]
    comments = ("as recorded: no rule explains it", *[""] * (len(entries) - 1))
    return MeasuredRule("", tuple(entries), comments, 0, 0.0, 9, is_explained=False)
