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
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from math import inf
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
# Marks along an axis, at most.
MARKS = 1000
# Decimal places of times and positions.
PLACES = 3


class MeasuredFigure(NamedTuple):
    """Measured values of one quantity: the figure to write, the least and the largest, and the unit."""

    value: float
    least: float
    most: float
    times: int
    unit: str = "s"

    def __str__(self) -> str:
        low, high = f"{self.least:.{PLACES}g}", f"{self.most:.{PLACES}g}"
        times = {1: "once", 2: "twice"}.get(self.times, f"{self.times} times")
        return f"{low} {self.unit}, {times}" if low == high else f"{low} to {high} {self.unit}, {times}"


class MeasuredRule(NamedTuple):
    """Why an input changes: entries of the machine file, each with a comment, and how well they explain it.

    `subject` names the cause. `seen` counts the changes that agree, `missed` has the times at which the cause had no
    effect, `spread` is that of the times, s, `delay` the time after the cause. The more a rule assumes, the larger is
    its `size`. `others` are the subjects of rules that explain the input equally well, `reason` says why not these.
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

    @property
    def is_guess(self) -> bool:
        """True if too few changes agree, or some contradict."""
        return self.seen < SEEN or bool(self.missed) or not self.is_explained


def rules_of(number: int, channel: Digital, recording: MeasuredRecording) -> list[MeasuredRule]:
    """Return the rules that may explain an input, the likeliest first; the last one is its changes as recorded."""
    if not channel.changes:
        text = f"{'on' if channel.first else 'off'} in all of the recording"
        constant: Entry = {"channel": number, "at": 0.0, **({} if channel.first else {"value": 0})}
        return [MeasuredRule("", (constant,), (text,), SEEN, 0.0, 0)]
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


def _figure(values: Sequence[float], unit: str = "s") -> MeasuredFigure:
    return MeasuredFigure(round(fmean(values), PLACES), min(values), max(values), len(values), unit)


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
            if channel.first == (switched.first ^ is_inverted):
                yield from _followed(number, channel, output, causes, recording, is_inverted=is_inverted)
            yield from _pulses(number, channel, output, causes, recording, is_inverted=is_inverted)


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
        figure = _figure(delays)
        entry = base | inverted | {"delay": figure.value}
        # A pair of changes, each with its own cause, agrees with itself.
        yield MeasuredRule(
            subject,
            (entry,),
            (str(figure),),
            len(delays),
            figure.most - figure.least,
            0,
            figure.value,
            missed,
        )
    elif len(to_on) > 1 and len(to_off) > 1:
        # The later entry decides about the level at power-up.
        parts = [(1, to_on), (0, to_off)] if channel.first else [(0, to_off), (1, to_on)]
        entries, comments = [], []
        for level, own in parts:
            figure = _figure(own)
            entries.append(
                base
                | {"level": level ^ is_inverted, "delay": figure.value, "for": FOR_EVER}
                | ({} if level else {"value": 0})
            )
            comments.append(f"{'on' if level else 'off'} after {figure}")
        spread = max(max(own) - min(own) for _, own in parts)
        lead = max(median(to_on), median(to_off))
        yield MeasuredRule(subject, tuple(entries), tuple(comments), len(delays), spread, 2, lead, missed)


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
    recording: MeasuredRecording,
    *,
    is_inverted: bool,
) -> Iterator[MeasuredRule]:
    active = 1 - channel.first
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
    delay, length = _figure(paired.delays(active)), _figure(lengths)
    entry: Entry = {"channel": number, "output": output, "delay": delay.value, "for": length.value}
    entry |= {} if active ^ is_inverted else {"level": 0}
    entry |= {} if active else {"value": 0}
    spread = max(delay.most - delay.least, length.most - length.least)
    comment = f"{delay}; for {length}"
    yield MeasuredRule(f"output {output}", (entry,), (comment,), len(starts), spread, 3, delay.value, missed)


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
    for active in (1, 0):
        lows = [x for x, v, level in pairs if (level == active) == (v > 0.0)]
        highs = [x for x, v, level in pairs if (level == active) != (v > 0.0)]
        tolerance = 3.0 * recording.step * float(np.abs(speed).max()) + 1e-6
        for keys, spread, texts in _regions(lows, highs, tolerance, recording):
            entry: Entry = {"channel": number, "axis": axis, **keys, **({} if active else {"value": 0})}
            if _agrees(entry, active, channel, path, recording):
                seconds = spread / float(np.median(np.abs(speed[moves])))
                yield MeasuredRule(f"axis {axis}", (entry,), (texts,), len(pairs), seconds, 1)


def _regions(
    lows: list[float], highs: list[float], tolerance: float, recording: MeasuredRecording
) -> Iterator[tuple[Entry, float, str]]:
    """Yield the keys of a region with these ends, their spread in user units, and the comment."""
    spread = max(max(each) - min(each) for each in (lows, highs) if each)
    if spread > tolerance:
        if len(lows) > 1 and len(highs) > 1:
            yield from _marks(lows, highs, tolerance, is_late=recording.is_late)
    elif not highs:
        figure = _figure(lows, "uu")
        yield {"above": figure.value}, spread, str(figure)
    elif not lows:
        figure = _figure(highs, "uu")
        yield {"below": figure.value}, spread, str(figure)
    else:
        first, last = _figure(lows, "uu"), _figure(highs, "uu")
        if first.value < last.value:
            yield {"between": [first.value, last.value]}, spread, f"{first}, and {last}"


def _marks(
    lows: list[float], highs: list[float], tolerance: float, *, is_late: bool
) -> Iterator[tuple[Entry, float, str]]:
    """Yield the keys of marks at equal distances along an axis, as `_regions` does.

    A recording that is late has not seen the first marks.
    """
    ordered = sorted(lows)
    every = _period(ordered, tolerance)
    if every <= tolerance:
        return
    first, last = _phase(lows, every), _phase(highs, every)
    spread = max(_off(lows, first, every), _off(highs, last, every))
    low = ordered[0] + (first - ordered[0] + every / 2) % every - every / 2
    low = low % every if is_late else low
    high = low + (last - low) % every
    if spread <= tolerance:
        between = [round(low, 2), round(high, 2)]
        keys: Entry = {"between": between, "every": round(every, 2), "times": MARKS}
        yield keys, spread, f"within {spread:.2g} uu, {len(lows)} marks"


def _period(ordered: Sequence[float], tolerance: float) -> float:
    """Return the distance between marks that were passed, some of them more than once or left out; 0 if none is."""
    steps = [b - a for a, b in pairwise(ordered) if b - a > tolerance]
    if not steps:
        return 0.0
    least = min(steps)
    places = [(each - ordered[0]) / least for each in ordered]
    counts = np.round(np.array(places))
    return float(np.polyfit(counts, np.array(ordered), 1)[0])


def _phase(values: Sequence[float], every: float) -> float:
    """Return the median position of marks below a multiple of the distance, next to the first one."""
    first = values[0]
    return first + median((each - first + every / 2) % every - every / 2 for each in values)


def _off(values: Sequence[float], phase: float, every: float) -> float:
    offs = [(each - phase + every / 2) % every - every / 2 for each in values]
    return max(offs) - min(offs)


def _agrees(entry: Entry, active: int, channel: Digital, path: Series, recording: MeasuredRecording) -> bool:
    """True if the input has the level of a region in all rows but those around its changes."""
    inside = _region(entry)(path.values)
    times = [each.time for each in channel.changes]
    at = np.searchsorted(times, path.times, "right") - 1
    levels = np.array([each.level for each in channel.changes])
    actual = np.where(at < 0, channel.first, levels[at])
    differs = (actual == active) != inside
    return float(differs.mean()) <= 2.0 * len(times) * max(recording.step, SPREAD) / (
        recording.end - recording.begin
    )


def _region(entry: Entry) -> Callable[[Array], NDArray[np.bool_]]:
    """Return the function that is True at the positions where an entry is active."""
    if "above" in entry or "below" in entry:
        edge, sign = float(str(entry.get("above", entry.get("below")))), 1.0 if "above" in entry else -1.0
        return lambda values: sign * values >= sign * edge
    low, high = (float(each) for each in entry["between"])  # type: ignore[attr-defined]
    every = float(str(entry.get("every", inf)))
    return lambda values: (values >= low) & (np.mod(values - low, every) <= high - low)


# ------------------------------------------------------------------------------------------ times


def _every(number: int, channel: Digital, recording: MeasuredRecording) -> Iterator[MeasuredRule]:
    """Yield the rule of an input that is active again and again."""
    starts = [each.time for each in channel.changes if each.level != channel.first]
    lengths = [b.time - a.time for a, b in pairwise(channel.changes) if a.level != channel.first]
    periods = [b - a for a, b in pairwise(starts)]
    if channel.first or len(starts) < SEEN or not lengths or not _agree(lengths, recording):
        return
    period, length = _figure(periods), _figure(lengths)
    drift = max(abs(each - starts[0] - k * period.value) for k, each in enumerate(starts))
    if drift > max(
        SPREAD, SPREAD_ROWS * recording.step
    ):  # a clock, not a person who is about as fast each time
        return
    mean = round((starts[-1] - starts[0]) / (len(starts) - 1), PLACES)
    entry: Entry = {"channel": number, "at": round(starts[0], PLACES), "for": length.value, "every": mean}
    if starts[-1] + 1.5 * mean < recording.end:
        entry["times"] = len(starts)
    spread = max(period.most - period.least, length.most - length.least)
    yield MeasuredRule("time", (entry,), (f"every {period}; for {length}",), len(starts), spread, 4)


def _once(number: int, channel: Digital, recording: MeasuredRecording) -> Iterator[MeasuredRule]:
    """Yield the rule of an input that changes once, or is active once."""
    changes = channel.changes
    if len(changes) > 2:
        return
    first = changes[0]
    entry: Entry = {"channel": number, "at": round(first.time, PLACES)}
    if channel.first:
        entries: list[Entry] = [{"channel": number, "at": 0.0}]
        entries += [
            {"channel": number, "at": round(each.time, PLACES), "value": each.level} for each in changes
        ]
        yield MeasuredRule("time", tuple(entries), ("", *["once"] * len(changes)), 1, 0.0, 5)
    elif len(changes) == 1:
        yield MeasuredRule("time", (entry,), ("once",), 1, 0.0, 1)
    else:
        length = round(changes[1].time - first.time, PLACES)
        yield MeasuredRule("time", ({**entry, "for": length},), ("once",), 1, 0.0, 1)


def as_recorded(number: int, channel: Digital) -> MeasuredRule:
    """Return the recorded changes of an input, which no rule explains."""
    entries: list[Entry] = [{"channel": number, "at": 0.0}] if channel.first else []
    entries += [
        {"channel": number, "at": round(each.time, PLACES), "value": each.level} for each in channel.changes
    ]
    comments = ("as recorded: no rule explains it", *[""] * (len(entries) - 1))
    return MeasuredRule("", tuple(entries), comments, 0, 0.0, 9, is_explained=False)
