"""Identification of the rule behind an input: the forms that explain all its changes, each measured.

Problem. The changes of an input, the switches of outputs, the positions of axes and what a program asks for, from a
recording, a run in which a person changes inputs, or a played run (`Observation`).

Idea. A form is a row of `FORMS`: its fit yields the rules of this form that explain every change, but for those next to
a gap, with the entry of the machine file.

    follows an output       each change comes a delay after a change of the output; on and off may differ in delay
    follows with `for`      it is active for some time after each change of an output
    follows a position      it changes where an axis passes, once or every so many user units
    when asked              each change comes while the program asks for it
    every so many seconds   it is active again and again
    at a time               it changes once, or is active once, as of a button

Times may differ by a spread that a machine, or the person, may have. The output may change without an effect on the
input, for example when a part is missing; such a rule stays a guess. The rule with the fewest of these is chosen, then
that with the smallest spread. Of rules with the same spread, within the sampling, the simplest is chosen, then the one
whose output changed last before the input.

Cost: outputs and axes times the changes of an input.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise, product
from math import inf
from statistics import fmean, median
from typing import NamedTuple, Protocol

from motionlang.kernel import Axis
from motionlang.kernel.tools import count_of

Entry = dict[str, object]

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
# A figure whose values differ by more than this share of it is a guess.
WIDE = 0.2
# Decimal places of times and positions.
PLACES = 3


class LevelChange(NamedTuple):
    """A change of a channel to a level; it lies within `within` of `time`, s."""

    time: float
    level: int
    within: float = 0.0


class Digital(NamedTuple):
    """A digital channel: the column, the first level, and its changes; `bounces` of them were taken as one each."""

    column: str
    first: int
    changes: tuple[LevelChange, ...]
    bounces: int = 0

    @property
    def shortest(self) -> float:
        """The shortest time between two changes, s."""
        return min((b.time - a.time for a, b in pairwise(self.changes)), default=inf)

    def last(self, time: float) -> LevelChange:
        """Return the last change up to a time, one long before if there is none."""
        at = bisect_right(self.changes, time, key=lambda each: each.time)
        return self.changes[at - 1] if at else LevelChange(-inf, self.first)


def channels(levels: Iterable[tuple[int, float, object]]) -> dict[int, Digital]:
    """Return channels that are off at first, from numbers, times and levels; to write the same level is no change."""
    found: dict[int, list[LevelChange]] = defaultdict(list)
    for number, time, value in levels:
        own, level = found[number], int(bool(value))
        if level != (own[-1].level if own else 0):
            own.append(LevelChange(time, level))
    return {number: Digital("", 0, tuple(own)) for number, own in found.items()}


def place(a: Axis, time: float) -> float:
    """Return where an axis was at a time, in user units from the zero of the machine, which a homing leaves."""
    return (a.position(time) - a.datum) / a.scale_at(time)[0]


class AxisPath(Protocol):
    """The positions of an axis."""

    def rules(self, number: int, axis: int, channel: Digital, seen: Observation) -> Iterator[MeasuredRule]:
        """Yield the rules by which an input follows the position."""


@dataclass(frozen=True)
class Observation:
    """The switches of outputs and the positions of axes, by number, with times in s.

    `step` is the usual time from row to row, 0 if times are exact. A change may vary by the `reaction` of a person, s,
    which is infinite if it only says what the program needed. `asked` has for how long the program has asked for a
    change, s, by the input and the time. `is_late` is True if it begins after power-up, `is_placed` if its times count
    from power-up. Rows are missing in `gaps`.
    """

    begin: float
    end: float
    step: float = 0.0
    outputs: dict[int, Digital] = field(default_factory=dict)
    positions: Mapping[int, AxisPath] = field(default_factory=dict)
    asked: Mapping[tuple[int, float], float] = field(default_factory=dict)
    reaction: float = 0.0
    is_late: bool = False
    is_placed: bool = True
    gaps: tuple[tuple[float, float], ...] = ()

    def has_gap(self, begin: float, end: float) -> bool:
        """True if rows are missing between two times."""
        return any(a < end and b > begin for a, b in self.gaps)

    def tolerance(self, value: float) -> float:
        """Return by how much a measured time may vary around its median, s."""
        return max(SPREAD_SHARE * abs(value), SPREAD, SPREAD_ROWS * self.step, self.reaction)

    def agree(self, times: Sequence[float]) -> bool:
        """True if times vary no more than those of one cause."""
        return max(times) - min(times) <= self.tolerance(median(times))


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


def figure_of(values: Sequence[float], within: float, unit: str = "s") -> MeasuredFigure:
    """Return the mean of values, each of which is known within so much."""
    value, spread = fmean(values), max(values) - min(values)
    deviation = max(abs(each - value) for each in values)
    is_wide = unit == "s" and spread > WIDE * abs(value) + 2.0 * within
    return MeasuredFigure(round(value, PLACES), spread, max(deviation, within), len(values), unit, is_wide)


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
    is_wide: bool = False
    others: tuple[str, ...] = ()
    reason: str = ""
    is_explained: bool = True
    is_confirmed: bool = True

    @property
    def is_guess(self) -> bool:
        """True if too few changes agree, some contradict, they differ much, or a run does not have them."""
        is_sure = self.is_explained and self.is_confirmed and not self.is_wide
        return self.seen < SEEN or bool(self.missed) or not is_sure


def rules_of(number: int, channel: Digital, seen: Observation) -> list[MeasuredRule]:
    """Return the rules that may explain an input, the likeliest first; the last one is its changes as recorded."""
    if not channel.changes:
        text = f"{'on' if channel.first else 'off'} in all of the recording"
        constant: Entry = {"channel": number, "at": 0.0, **({} if channel.first else {"value": 0})}
        count = 0 if seen.is_late else SEEN  # what was before it begins, nothing shows
        return [MeasuredRule("", (constant,), (text,), count, 0.0, 0)]
    found = [rule for form in FORMS for rule in form.fit(number, channel, seen)]
    least = min((len(each.missed) for each in found), default=0)
    best = min((each.spread for each in found if len(each.missed) == least), default=0.0)
    best += max(2.0 * seen.step, seen.reaction)

    def is_equal(rule: MeasuredRule) -> bool:
        return len(rule.missed) == least and rule.spread <= best

    found.sort(key=lambda each: (not is_equal(each), len(each.missed), each.size, each.delay, each.subject))
    for k, rule in enumerate(found):
        equal = [each for each in found[k + 1 :] if is_equal(rule) and is_equal(each)]
        others = dict.fromkeys(each.subject for each in equal if each.subject != rule.subject)
        is_simpler = any(each.size > rule.size for each in equal if each.subject in others)
        reason = "is simpler" if is_simpler else "changes last before it"
        found[k] = rule._replace(others=tuple(others), reason=reason)
    return [*found, as_recorded(number, channel)]


def _measured(
    subject: str,
    entries: tuple[Entry, ...],
    comments: tuple[str, ...],
    figures: Sequence[MeasuredFigure],
    seen: int,
    size: int,
    delay: float = 0.0,
    missed: tuple[float, ...] = (),
) -> MeasuredRule:
    spread = max(each.spread for each in figures)
    is_wide = any(each.is_wide for each in figures)
    return MeasuredRule(subject, entries, comments, seen, spread, size, delay, missed, is_wide)


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


# ------------------------------------------------------------------------------------------ outputs


def _paired(
    changes: Sequence[LevelChange], causes: Sequence[LevelChange], seen: Observation
) -> tuple[tuple[list[float], list[float]], list[LevelChange]] | None:
    """Pair each change with the last cause before it; return the delays to off and on, and causes without an effect.

    `causes` have the level that they lead to. Return None if a change has no cause at a usual time before, but for one
    that may come from a gap, or from before a recording that begins after power-up.
    """
    by_level = [[each for each in causes if each.level == level] for level in (0, 1)]
    found: dict[LevelChange, LevelChange] = {}
    leads: tuple[list[float], list[float]] = [], []
    before = -inf
    for each in changes:
        # What changes in the same row may be the effect: a run judges, but not one of a recording that begins later.
        latest = each.time + (-1e-9 if seen.is_late else seen.step / 2 + each.within)
        at = bisect_right(by_level[each.level], latest, key=lambda cause: cause.time)
        # A person reacts to what came after the change before.
        if at and by_level[each.level][at - 1].time > (before if seen.reaction else -inf):
            found[each] = by_level[each.level][at - 1]
            leads[each.level].append(each.time - found[each].time)
        before = each.time
    usual = [median(each) if each else 0.0 for each in leads]
    delays: tuple[list[float], list[float]] = [], []
    used: set[tuple[float, int]] = set()
    for each in changes:
        lead = each.time - found[each].time if each in found else inf
        since = each.time - 1.5 * usual[each.level] - 2.0 * seen.step
        if abs(lead - usual[each.level]) <= seen.tolerance(usual[each.level]) and lead < inf:
            if found[each][:2] in used:  # two changes cannot have the same cause
                return None
            used.add(found[each][:2])
            delays[each.level].append(max(lead, 0.0))
        elif not (seen.is_late and since <= seen.begin) and not seen.has_gap(since, each.time):
            return None
    missed = [
        each
        for each in causes
        if each[:2] not in used
        and (end := each.time + 2.0 * usual[each.level] + 2.0 * seen.step) < seen.end
        and not seen.has_gap(each.time - seen.step, end)
    ]
    return delays, missed


def _following(number: int, channel: Digital, seen: Observation) -> Iterator[MeasuredRule]:
    """Yield the rules by which an input follows an output: both of its changes, or pulses after one of them."""
    for (output, switched), is_inverted in product(sorted(seen.outputs.items()), (False, True)):
        # An exact run begins with what is set up at power-up, or before the output switches. A played one may set up
        # later, as soon as the program asks.
        begin, mine = channel.changes[0], channel
        is_early = seen.reaction == inf or channel.changes[:1] < switched.changes[:1]
        is_set_up = not seen.step and (begin.time == 0.0 or (is_early and begin.level == is_inverted))
        if is_set_up:
            mine = channel._replace(first=begin.level, changes=channel.changes[1:])
        causes = [each._replace(level=each.level ^ is_inverted) for each in switched.changes]
        base: Entry = {"channel": number, "output": output}
        # A recording that begins late may begin within a delay.
        if seen.is_late or is_set_up or mine.first == (switched.first ^ is_inverted):
            yield from _followed(base, mine, causes, seen, is_inverted=is_inverted)
        for active in (0, 1) if seen.is_late else (1 - mine.first,):
            yield from _pulses(base, mine, causes, active, seen, is_inverted=is_inverted)


def _followed(
    base: Entry, channel: Digital, causes: list[LevelChange], seen: Observation, *, is_inverted: bool
) -> Iterator[MeasuredRule]:
    paired = _paired(channel.changes, causes, seen)
    if paired is None or not any(paired[0]):
        return
    (to_off, to_on), without = paired
    delays = to_on + to_off
    # A change to the level that the input already has needs no effect.
    missed = tuple(each.time for each in without if channel.last(each.time).level != each.level)
    if len(missed) > MISSED * len(causes):
        return
    near = max(2.0 * seen.step, SPREAD, seen.reaction)
    is_equal = not to_on or not to_off or abs(median(to_on) - median(to_off)) <= near
    parts: list[tuple[Entry, str, MeasuredFigure]] = []
    if is_equal and seen.agree(delays):
        # A pair of changes, each with its own cause, agrees with itself; of a played run, a run judges any.
        is_pair = len(delays) == 2 and median(delays) <= NEAR
        if len(delays) >= SEEN or is_pair or seen.reaction == inf:
            figure = figure_of(delays, seen.step)
            entry = {**base, "delay": figure.value, **({"value": 0} if is_inverted else {})}
            parts = [(entry, str(figure), figure)]
    elif len(to_on) > 1 and len(to_off) > 1:
        # The later entry decides about the level at power-up.
        for level in (1, 0) if channel.first else (0, 1):
            figure = figure_of(to_on if level else to_off, seen.step)
            entry = base | {"level": level ^ is_inverted, "delay": figure.value, "for": FOR_EVER}
            text = f"{'on' if level else 'off'} after {figure}"
            parts.append((entry if level else {**entry, "value": 0}, text, figure))
    if parts:
        entries, comments, figures = zip(*parts, strict=True)
        size, lead = 2 * (len(parts) - 1), min(each.value for each in figures)
        yield _measured(
            f"output {base['output']}", entries, comments, figures, len(delays), size, lead, missed
        )


def _pulses(
    base: Entry,
    channel: Digital,
    causes: list[LevelChange],
    active: int,
    seen: Observation,
    *,
    is_inverted: bool,
) -> Iterator[MeasuredRule]:
    starts = [each for each in channel.changes if each.level == active]
    lengths = [b.time - a.time for a, b in pairwise(channel.changes) if a.level == active]
    if len(starts) < 2 or not lengths or not seen.agree(lengths):
        return
    paired = _paired(starts, [each for each in causes if each.level == active], seen)
    if paired is None or len(paired[0][active]) < 2 or len(paired[1]) > MISSED * len(causes) / 2:
        return
    delay, length = figure_of(paired[0][active], seen.step), figure_of(lengths, seen.step)
    entry = {**base, "delay": delay.value, "for": length.value}
    entry |= {} if active ^ is_inverted else {"level": 0}
    entry |= {} if active else {"value": 0}
    subject, text = f"output {base['output']}", f"{delay.interval}; for {length}"
    missed = tuple(each.time for each in paired[1])
    yield _measured(subject, (entry,), (text,), (delay, length), len(starts), 3, delay.value, missed)


def _along_axes(number: int, channel: Digital, seen: Observation) -> Iterator[MeasuredRule]:
    """Yield the rules by which an input follows the position of an axis."""
    for axis, path in sorted(seen.positions.items(), key=lambda each: each[0]):
        yield from path.rules(number, axis, channel, seen)


# ------------------------------------------------------------------------------------------ times


def _asked(number: int, channel: Digital, seen: Observation) -> Iterator[MeasuredRule]:
    """Yield the rule of an input each of whose changes comes while the program asks for it."""
    changed = [(number, each.time) for each in channel.changes]
    delays = [seen.asked[each] for each in changed if each in seen.asked]
    if 1 < len(channel.changes) == len(delays):
        figure = figure_of(delays, seen.step)
        entry: Entry = {"channel": number, "asked": figure.value}
        yield _measured("the program", (entry,), (str(figure),), (figure,), len(delays), 2, figure.value)


def _every(number: int, channel: Digital, seen: Observation) -> Iterator[MeasuredRule]:
    """Yield the rule of an input that is active again and again."""
    starts = [each.time for each in channel.changes if each.level != channel.first]
    lengths = [b.time - a.time for a, b in pairwise(channel.changes) if a.level != channel.first]
    if channel.first or len(starts) < SEEN or not lengths or not seen.agree(lengths):
        return
    period = figure_of([b - a for a, b in pairwise(starts)], seen.step)
    length = figure_of(lengths, seen.step)
    drift = max(abs(each - starts[0] - k * period.value) for k, each in enumerate(starts))
    if drift > max(SPREAD, SPREAD_ROWS * seen.step):  # a clock, not a person who is about as fast each time
        return
    mean = round((starts[-1] - starts[0]) / (len(starts) - 1), PLACES)
    entry: Entry = {"channel": number, "at": round(starts[0], PLACES), "for": length.value, "every": mean}
    if starts[-1] + 1.5 * mean < seen.end:
        entry["times"] = len(starts)
    text, count = f"every {period.interval}; for {length}", len(starts) if seen.is_placed else 0
    yield _measured("time", (entry,), (text,), (period, length), count, 4)


def _once(number: int, channel: Digital, seen: Observation) -> Iterator[MeasuredRule]:
    changes = channel.changes
    if len(changes) > 2:
        return
    figures = [figure_of([each.time], each.within) for each in changes]
    texts = [str(each) for each in figures]
    entries: list[Entry] = [{"channel": number, "at": each.value} for each in figures]
    if channel.first:
        later = ({**entry, "value": each.level} for entry, each in zip(entries, changes, strict=True))
        entries, texts = [{"channel": number, "at": 0.0}, *later], ["", *texts]
    elif len(changes) == 2:
        length = figure_of([changes[1].time - changes[0].time], 2.0 * changes[0].within)
        entries, texts = [{**entries[0], "for": length.value}], [f"{figures[0].interval}; for {length}"]
    yield MeasuredRule("time", tuple(entries), tuple(texts), 1, 0.0, 5 if channel.first else 1)


# ------------------------------------------------------------------------------------------ forms


class Form(NamedTuple):
    """A form of rules: the key that its entries have, its fit, and an entry in words."""

    key: str
    fit: Callable[[int, Digital, Observation], Iterator[MeasuredRule]]
    words: Callable[[Mapping[str, object]], str]


def _output_words(entry: Mapping[str, object]) -> str:
    if "for" in entry:
        level, change = ("off" if entry.get(key) == 0 else "on" for key in ("value", "level"))
        lead = f"{entry.get('delay', 0)} s after output {entry['output']} goes {change}"
        return f"{level} for {entry['for']} s, {lead}"
    inverted = ", inverted," if entry.get("value") == 0 else ""
    delay = f" after {entry['delay']} s" if entry.get("delay") else ""
    return f"follows output {entry['output']}{inverted}{delay}"


def _axis_words(entry: Mapping[str, object]) -> str:
    edges = (f" {key} {entry[key]}" for key in ("above", "below", "between") if key in entry)
    return f"follows axis {entry['axis']}{''.join(edges)}"


# The simplest first.
FORMS = (
    Form("output", _following, _output_words),
    Form("axis", _along_axes, _axis_words),
    Form("asked", _asked, lambda entry: f"{entry['asked']} s after it is asked for"),
    Form("every", _every, lambda entry: f"every {entry['every']} s by the machine file"),
    Form("at", _once, lambda entry: "set by the machine file"),
)


def in_words(entry: Mapping[str, object]) -> str:
    """Return the rule of an entry in words."""
    return next(form for form in FORMS if form.key in entry or form is FORMS[-1]).words(entry)
