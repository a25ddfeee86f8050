"""The acts of a program in a played way, and the differences from those of another program.

An act is a move, an output, a value for the host or a printed line. Each task has its own order. Acts have no lines in
a comparison: a moved sub is no difference. A move is the same if it goes to the same count at the same speed in counts,
and is cut off in the same manner. Ways are compared with times up to `WITHIN`, two runs of the same world with the
tolerance of the user.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict, deque
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from math import inf
from typing import NamedTuple

from motionlang.comparison.align import aligned
from motionlang.comparison.texts import described, plain, without_figures
from motionlang.comparison.tolerance import Tolerance
from motionlang.kernel import Run
from motionlang.kernel.log import CONTINUED

# An act of a way may come earlier or later by so much, s, and a move may take so much longer.
WITHIN, MOTION = 0.025, 1e-3
# What happens so shortly before the end of a run may come after it in another one, s.
TAIL = 0.1
# If an axis is elsewhere by so little, the peak of a short move may differ by this fraction.
SLOWER = 0.02
# Positions and speeds have so many digits in a comparison of ways, and a place at rest so many counts.
DIGITS, COUNT = 6, 1.0
# The tolerance of ways.
IN_WAYS = Tolerance(f"time={WITHIN}s", least=10.0**-DIGITS, shifts=True)
# The end of a way is no difference: what one side lacks there must be this many times overdue.
OVERDUE = 2.0
# Acts are in another order if they are no further apart than so many.
ORDER = 4
# The words of a digital output that changes, by its level.
LEVELS = ("off", "on")
# The name, in place of a task, of what no statement does, such as the end of a pulse.
WORLD = "world"
# A terminal puts the next letters at a row and column.
_PLACES = re.compile(r"\x1b\[(\d+);(\d+)H")


class ComparedAct(NamedTuple):
    """An act: its times, s, its line, 0 if it is unknown, its subject, "" for a printed line, and words.

    `exact` says how a move was cut off. Its `target` is in counts, None if it has none; so is its `speed`. `unit` is
    the number of counts in a user unit. `place` has the rows and columns of a text on a display.
    """

    begin: float
    end: float
    line: int
    subject: str
    words: str
    exact: tuple[object, ...] = ()
    target: float | None = None
    speed: float = 0.0
    place: str = ""
    unit: float = 1.0

    def __str__(self) -> str:
        return f"{self.subject} {self.words}".strip() if self.subject else f"'{self.words}'"

    @property
    def key(self) -> tuple[object, ...]:
        """The part that two equal acts share; it leaves out where a move is cut off, which depends on a time."""
        if not self.exact:
            return self.subject, self.words, self.place
        target = None if self.is_cut or self.target is None else _rounded(self.target)
        return self.subject, self.exact, target, _rounded(self.speed)

    @property
    def content(self) -> tuple[object, ...]:
        """The part by which acts are aligned: of a printed line or a value, all but the figures."""
        return self.key if self.exact or self.is_switch else (*self.kind, self.place)

    @property
    def kind(self) -> tuple[str, str]:
        """The subject, and the words of a line or a switched output without figures."""
        return self.subject, "" if self.exact else without_figures(self.words)

    @property
    def is_cut(self) -> bool:
        """True if it is a move that was cut off."""
        return bool(self.exact) and self.exact[1] != ""

    @property
    def is_switch(self) -> bool:
        """True if it switches a digital output."""
        return bool(self.subject) and self.words in LEVELS


class PlayedWay(NamedTuple):
    """The play of a way: the acts of each task in order, how the program ended and when, s.

    `until` is how long it is known what it does: for ever if it ended, or if nothing could change any more. `status` is
    "waits", "ended", or the code of the error with which it ended. `places` are where the axes rest at the end, by
    number, in counts and user units. `stays` are the times of the rests of the machine, `changed` is when the world
    changed last. `begun` are the source offsets of the statements that began, `outcomes` those of the conditions that
    came out, with their numbers and how, `order` those of each task in the order in which they first began behind the
    last change, with that time. `changes` are the times of all changes.
    """

    acts: Mapping[str, Sequence[ComparedAct]]
    status: str
    time: float
    until: float
    places: Mapping[int, tuple[float, float]]
    stays: Sequence[tuple[float, float]]
    changed: float
    begun: Set[int]
    outcomes: Set[tuple[int, int, bool]]
    order: Mapping[str, Mapping[int, float]]
    changes: Sequence[float] = ()

    @property
    def is_at_rest(self) -> bool:
        """True if the machine rests at the end."""
        return self.until == inf or bool(self.stays and self.stays[-1][1] >= self.time)

    @property
    def ordered(self) -> list[ComparedAct]:
        """The acts of all tasks in the order of time."""
        return sorted((each for some in self.acts.values() for each in some), key=lambda each: each.begin)


def status_of(run: Run, status: str) -> str:
    """Return how a run ended: the code of its error if it has one."""
    if status != "fault":
        return status
    return next((each.code for each in run.diagnostics if each.severity == "error"), status)


def places_of(run: Run) -> dict[int, tuple[float, float]]:
    """Return where the axes rest at the end of a run, by number, in counts and user units."""
    return {
        number: (round(axis.position(run.time), 3), axis.scale.position_to_user(axis.position(run.time)))
        for number, axis in run.controller.axes.items()
        if axis.is_still and axis.profiles
    }


def acts_of(run: Run, line: Callable[[int], int]) -> Iterator[ComparedAct]:
    """Yield the acts of a run; `line` is that of a source offset."""
    log = run.machine.log
    homes = run.dialect.table().homes
    for move in log.moves:
        profile, is_homing = move.profile, homes(move.command)
        if profile is None:
            continue
        cut = "" if move.ended == CONTINUED else move.ended
        is_whole = profile.duration < inf and not cut
        end = move.start_time + (profile.duration if is_whole else 0.0)
        target = profile.end if profile.duration < inf and not is_homing else None
        if cut:
            place = round(move.to_user(profile.end), 3) + 0.0
            words = f"{move.command}, cut off at {place:.6g} ({cut})"
        else:
            words = described(move, is_homing)
        unit, subject = run.controller.axes[move.axis].scale.counts, f"axis {move.axis}"
        yield ComparedAct(
            move.start_time,
            end,
            move.line,
            subject,
            words,
            (is_homing, cut),
            target,
            profile.peak_speed,
            unit=unit,
        )
    for each in log.outputs:
        yield switched(each.time, _line(each.at, line), each.channel, each.value)
    for each in log.analogue_outputs:
        yield written(each.time, _line(each.at, line), f"analogue output {each.channel}", each.value)
    for other in log.writes:
        yield written(other.time, _line(other.at, line), other.target, other.value)
    for text in log.prints:
        where = ", ".join(f"row {row} column {column}" for row, column in _PLACES.findall(text.text))
        yield ComparedAct(text.time, text.time, _line(text.at, line), "", plain(text.text), place=where)
    for label, terminal in run.machine.terminals.items():
        for text in terminal.prints:
            yield ComparedAct(text.time, text.time, _line(text.at, line), "", f"[{label}] {plain(text.text)}")


def switched(time: float, line: int, channel: int, value: float) -> ComparedAct:
    """Return the act of a digital output that changes."""
    return ComparedAct(time, time, line, f"output {channel}", LEVELS[bool(value)])


def written(time: float, line: int, target: str, value: float) -> ComparedAct:
    """Return the act of an analogue output, or of a value for the host or in another device, that changes."""
    return ComparedAct(time, time, line, target, f"to {value:.6g}")


def occurred(time: float, line: int, axis: int | None, kind: str) -> ComparedAct:
    """Return an event of an axis, or of none, as an act."""
    return ComparedAct(time, time, line, "event" if axis is None else f"axis {axis}", kind)


def _line(at: int, line: Callable[[int], int]) -> int:
    return line(at) if at >= 0 else 0


def _rounded(value: float) -> float:
    return float(f"{value:.{DIGITS}g}") if abs(value) > 1e-6 else 0.0


Row = tuple[ComparedAct | None, ComparedAct | None]


class ActDifference(NamedTuple):
    """A difference: what A does and what B does, none for a side that does nothing there; each with its time, s.

    `end` are the sentences of two ends, or of places where an axis rests. `is_order` is True if both do the same in
    another order.
    """

    a: Sequence[ComparedAct]
    b: Sequence[ComparedAct]
    end: tuple[str, str] | None = None
    is_order: bool = False

    @property
    def key(self) -> object:
        """The part that one difference shares in several ways."""
        if self.end is not None:
            return self.end
        sides = (each[0] if each else None for each in (self.a, self.b))
        return tuple(
            None if each is None else (each.line, each.subject, each.words if each.is_switch else "")
            for each in sides
        )

    @property
    def begin(self) -> float:
        """When it shows, s."""
        return min([inf, *(each[0].begin for each in (self.a, self.b) if each)])


class Later(NamedTuple):
    """An act that both do, `seconds` later in B; it `lasts` longer, or comes later than what is before it."""

    act: ComparedAct
    other: ComparedAct
    seconds: float
    lasts: bool


class ComparedActs(NamedTuple):
    """The differences of two played ways: what is done, what comes later, and the pairs of equal acts.

    `undecided` are acts of one side that the end of the way may have cut off on the other one.
    """

    differences: Sequence[ActDifference]
    later: Sequence[Later]
    pairs: Sequence[tuple[ComparedAct, ComparedAct]]
    undecided: Sequence[ComparedAct] = ()


def compared(a: PlayedWay, b: PlayedWay, tolerance: Tolerance = IN_WAYS) -> ComparedActs:
    """Return the differences of what two programs do in a way, or two runs."""
    found: list[ActDifference] = []
    later: list[Later] = []
    pairs: list[tuple[ComparedAct, ComparedAct]] = []
    undecided: list[ComparedAct] = []
    # By how much each axis may be elsewhere, in counts, since a move of it was cut off a little earlier or later.
    drift: dict[str, float] = defaultdict(float)
    for task in dict.fromkeys((*a.acts, *b.acts)):
        mine, others = a.acts.get(task, ()), b.acts.get(task, ())
        pairs += _task(mine, others, (a, b), tolerance, found, later, undecided, drift)
    found.sort(key=lambda each: each.begin)
    if not found:
        # An axis whose moves the end of the way has cut off may be anywhere.
        far = drift | {each.subject: inf for each in undecided if each.subject.startswith("axis ")}
        found += _ends(
            a, b, tolerance, {int(axis.split()[1]): counts for axis, counts in far.items()}, undecided
        )
        later += _later_end(a, b, pairs) if tolerance is IN_WAYS else ()
    return ComparedActs(found, later, pairs, undecided)


def _task(
    mine: Sequence[ComparedAct],
    others: Sequence[ComparedAct],
    ways: tuple[PlayedWay, PlayedWay],
    tolerance: Tolerance,
    found: list[ActDifference],
    later: list[Later],
    undecided: list[ComparedAct],
    drift: dict[str, float],
) -> list[tuple[ComparedAct, ComparedAct]]:
    pairs: list[tuple[ComparedAct, ComparedAct]] = []
    hunks: list[list[Row]] = []
    hunk: list[Row] = []
    lags = [0.0]
    rows: list[Row] = [
        (None if i is None else mine[i], None if j is None else others[j])
        for i, j in aligned(mine, others, lambda each: each.content, lambda each: each.kind)  # type: ignore[attr-defined]
    ]
    for k, (one, other) in enumerate([*rows, (None, None)]):
        is_end = one is None and other is None
        is_same = (
            one is not None
            and other is not None
            and (_is_near(one, other, tolerance, drift) or _is_text(one, other, tolerance, lags))
        )
        if not is_same and not is_end:
            hunk.append((one, other))
            continue
        if hunk and not is_end and _is_moved(rows[k + 1 :], hunk):
            hunk.append((one, other))
            continue
        if hunk:
            last = pairs[-1] if pairs else None
            hunks.append([*_overdue(hunk, last, ways, undecided)] if is_end else hunk)
            hunk = []
        if one is not None and other is not None:
            lags.append(other.end - one.end)
            pairs.append((one, other))
    for each in _without_late(hunks, ways, later):
        _add(found, each)
    _times(pairs, ways, tolerance, later)
    return pairs


def _without_late(
    hunks: Sequence[Sequence[Row]], ways: tuple[PlayedWay, PlayedWay], later: list[Later]
) -> Iterator[Sequence[Row]]:
    """Yield differences without the acts that both sides do, as often, at other times: those are `later`."""
    missing: tuple[list[ComparedAct], list[ComparedAct]] = [], []
    for hunk in hunks:
        sides = [side for side in (0, 1) if any(row[side] is not None for row in hunk)]
        if len(sides) == 1:
            missing[sides[0]].extend(act for row in hunk if (act := row[sides[0]]) is not None)
    counts = [Counter(act.key for act in some) for some in missing]
    late = {key for key, count in counts[0].items() if count == counts[1][key]}
    moved: list[list[ComparedAct]] = [[act for act in some if act.key in late] for some in missing]
    left: dict[object, deque[ComparedAct]] = defaultdict(deque)
    for act in moved[1]:
        left[act.key].append(act)
    for act in moved[0]:
        other = left[act.key].popleft()
        later.append(Later(act, other, other.begin - act.begin - _shift(ways, act.begin), False))
    gone = {id(act) for some in moved for act in some}
    yield from ([row for row in hunk if not any(id(act) in gone for act in row)] for hunk in hunks)


def _shift(ways: tuple[PlayedWay, PlayedWay], time: float) -> float:
    """Return by how much the last change of the world up to a time comes later in the second way."""
    changes = zip(*(each.changes for each in ways), strict=False)
    last: tuple[float, float] = max((each for each in changes if each[0] <= time), default=(0.0, 0.0))
    return last[1] - last[0]


def _overdue(
    hunk: Sequence[Row],
    last: tuple[ComparedAct, ComparedAct] | None,
    ways: tuple[PlayedWay, PlayedWay],
    undecided: list[ComparedAct],
) -> Iterator[Row]:
    """Yield what differs behind the last act that both have; what the other side may still do is `undecided`.

    What one side alone does so long after that act must be overdue on the other one when its way ends: if both have had
    acts before, the other one may be slower. A task that has done nothing since the last change may wait for that, so
    what it lacks counts from there.
    """
    begun = [0.0, 0.0] if last is None else [each.begin for each in last]
    goes_on = [last is not None and begun[side] >= ways[side].changed for side in (0, 1)]
    done = [begun[side] if any(goes_on) else max(ways[side].changed, begun[side]) for side in (0, 1)]
    slower = 1.0 if last is None else OVERDUE
    are_both = all(any(row[side] is not None for row in hunk) for side in (0, 1))
    for row in hunk:
        rooms = [
            (ways[1 - side].until - done[1 - side] - slower * (act.begin - done[side]), act)
            for side, act in enumerate(row)
            if act is not None
        ]
        if are_both or rooms[0][0] > TAIL:
            yield row
        else:
            undecided.append(rooms[0][1])


def _is_moved(rows: Sequence[Row], hunk: Sequence[Row]) -> bool:
    """True if what one side lacks in a difference comes at the same moment a little later: another order."""
    first = next((each for each in hunk[0] if each is not None), None)
    if len(hunk) > ORDER or first is None or None not in hunk[0]:
        return False
    side = hunk[0].index(None)
    near = (row[side] for row in rows[:ORDER] if row[1 - side] is None)
    return any(
        each is not None and each.key == first.key and each.begin - first.begin < WITHIN for each in near
    )


def _times(
    pairs: Sequence[tuple[ComparedAct, ComparedAct]],
    ways: tuple[PlayedWay, PlayedWay],
    tolerance: Tolerance,
    later: list[Later],
) -> None:
    """Add what takes longer, or comes later behind the act, the change of the world or the end of a move before it.

    An act that comes when it did is not earlier because what is before it is later.
    """
    lag, before, shift = 0.0, 0.0, 0.0
    ends: list[tuple[float, float]] = []
    changes = deque(zip(*(each.changes for each in ways), strict=False))
    for one, other in pairs:
        ends = [each for each in ends if each[0] >= before]
        while changes and changes[0][0] <= one.begin:
            at, in_b = changes.popleft()
            shift = in_b - at
            ends.append((at, shift))
        causes = [lag, *(late for ended, late in ends if ended <= one.begin + WITHIN)]
        lag, before = other.begin - one.begin, one.begin
        wait = min((lag - each for each in causes), key=abs)
        least = tolerance.of("time", one.begin, other.begin)
        if abs(wait) > least and abs(lag - shift) > least and wait * (lag - shift) > 0.0:
            later.append(Later(one, other, wait, False))
        spans = one.end - one.begin, other.end - other.begin
        lasts = spans[1] - spans[0]
        if abs(lasts) > (MOTION if tolerance is IN_WAYS else tolerance.of("time", *spans)):
            later.append(Later(one, other, lasts, True))
        if spans[1] > 0.0:
            ends.append((one.end, other.end - one.end))


def _is_near(one: ComparedAct, other: ComparedAct, tolerance: Tolerance, drift: dict[str, float]) -> bool:
    """True if two acts are the same, but for how far a move of the axis came until it was cut off."""
    if one.subject != other.subject or one.exact != other.exact:
        return False
    if not one.exact:
        return (one.words, one.place) == (other.words, other.place)
    faster = abs(one.speed - other.speed)
    as_fast = tolerance.of("speed", one.speed, other.speed, one.unit)
    if one.target is None or other.target is None:
        return one.target == other.target and faster <= as_fast
    apart, is_cut = abs(one.target - other.target), one.is_cut
    allowed = max(drift[one.subject], tolerance.of("position", one.target, other.target, one.unit))
    allowed += one.speed * tolerance.size("time") if is_cut else 0.0
    if is_cut and apart <= allowed:
        drift[one.subject] = max(drift[one.subject], apart)
    return faster <= max(as_fast, SLOWER * one.speed if drift[one.subject] else 0.0) and apart <= allowed


def _is_text(one: ComparedAct, other: ComparedAct, tolerance: Tolerance, lags: Sequence[float]) -> bool:
    """True if two printed lines differ by figures alone, and those within the tolerance, or by a delay in s or ms."""
    if one.subject or other.subject or (one.kind, one.place) != (other.kind, other.place):
        return False
    figures = [
        (float(x), float(y))
        for x, y in zip(one.words.split(), other.words.split(), strict=False)
        if x != y and _is_figure(x) and _is_figure(y)
    ]
    lag = other.begin - one.begin
    delays = [lag - each for each in lags if abs(lag - each) > 5e-4] if tolerance.shifts else []
    return bool(figures) and all(
        any(abs((y - x) * unit - each) <= 2e-3 for each in delays for unit in (1e-3, 1.0))
        or (not tolerance.shifts and tolerance.is_figure(x, y))
        for x, y in figures
    )


def _is_figure(text: str) -> bool:
    return text.replace(".", "", 1).lstrip("-").isdigit()


def _add(found: list[ActDifference], hunk: Sequence[Row]) -> None:
    a = [one for one, _ in hunk if one is not None]
    b = [other for _, other in hunk if other is not None]
    if a or b:
        is_order = len(a) > 1 and sorted(map(str, a)) == sorted(map(str, b))
        found.append(ActDifference(a, b, None, is_order))


def _ends(
    a: PlayedWay,
    b: PlayedWay,
    tolerance: Tolerance,
    drift: Mapping[int, float],
    undecided: Sequence[ComparedAct],
) -> Iterator[ActDifference]:
    if a.status != b.status:
        # A program that may still do what the other one has done may end as that did.
        if not undecided or "waits" not in (a.status, b.status):
            yield ActDifference((), (), (_end(a), _end(b)))
    elif a.status == "waits" and a.is_at_rest and b.is_at_rest:
        for axis in sorted(a.places.keys() & b.places.keys()):
            (counts, place), (other_counts, other) = a.places[axis], b.places[axis]
            allowed = max(drift.get(axis, 0.0), COUNT if tolerance is IN_WAYS else tolerance.size("position"))
            if abs(counts - other_counts) > max(allowed, tolerance.of("position", counts, other_counts)):
                yield ActDifference(
                    (), (), (f"axis {axis} rests at {place:.6g}", f"axis {axis} rests at {other:.6g}")
                )


def _later_end(
    a: PlayedWay, b: PlayedWay, pairs: Sequence[tuple[ComparedAct, ComparedAct]]
) -> Iterator[Later]:
    """Yield how much later the second program ends behind the last that both do."""
    if (a.status, b.status) == ("ended", "ended"):
        last = max(pairs, key=lambda pair: pair[0].end, default=None)
        lags = (
            [0.0]
            if last is None
            else [_shift((a, b), a.time), last[1].begin - last[0].begin, last[1].end - last[0].end]
        )
        wait = min((b.time - a.time - lag for lag in lags), key=abs)
        if abs(wait) > WITHIN:
            one, other = (ComparedAct(each.time, each.time, 0, "the end", "") for each in (a, b))
            yield Later(one, other, wait, False)


def _end(way: PlayedWay) -> str:
    if way.status in ("waits", "ended", "stopped"):
        return {"waits": "it goes on", "ended": "it ends", "stopped": "it stops"}[way.status]
    return f"it ends with the error {way.status}"
