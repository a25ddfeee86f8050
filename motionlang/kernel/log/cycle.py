"""The cycle of a run: the repetition of the task that moves most.

Problem. A machine repeats its work, and a run has nothing but a log. Which repetition is the cycle? Within it, others
repeat: the pecks of a hole, the holes of a plate. A real machine varies: a part is rejected now and then, a layer has
as many pieces as the data say, the first cycle differs, the end of the run cuts the last one off.

Idea. The events of a task are its moves, outputs and prints in the order of the log; all axes that start at the same
time are one event. What a statement does is a key. Each key could begin a cycle, and divides the log into blocks, from
one occurrence to the next. What occurs in more than `USUAL` of its blocks is typical of it. A cycle covers the time
that its typical keys take in the whole run, wherever they are; so blocks that differ need no rule of their own. What
occurs twice in a cycle is in half of its own blocks only, and does not cover the rest.

    log               A B C B C B C D   A B C B C B C D   A B C B C D
    blocks of A       A B C B C B C D   A B C B C B C D                     typical: A B C D, covers all
    blocks of B         B C, B C, B C D   A B C …                           typical: B C

The one that covers most is the cycle. A shorter one takes its place if it leaves out little: at most a tenth of the
time, and less than half of the axes, and of the keys or the moves. If the longer one is regular, it leaves out less
than a third of the keys or of the moves, and occurs more than three times as often. Then the rest is an interruption,
such as a rejected part or a full box, and not the work around some pecks.

A statement is one key for each way that calls lead to it: a sub that moves an axis is another act for each of its
callers. A move has its direction in its key, since a line may move an axis both ways, and a print its words. If these
depend on data, so that the repetition covers less with them, they do not count. The same holds for a sub that calls
itself.

A piece has what comes once in it. A shorter repetition with a print of its own is a piece, and what is longer holds
several, even if a refill takes as long as all its pieces. A print that comes once in up to eight repetitions makes
them one. Without prints, the repetitions are one whose targets come again, or advance by a constant: the moves of a
table on one line. Where the task that moves most rests between its repetitions, another one may order its steps: if
that prints once in a cycle, its cycle is the piece.

Invariants. Nothing depends on the order of a hash: keys are numbered in the order of the log. A cycle has a move that
is no homing. The times of its name are those that `cycle(…)` of a quantity has.

Cost. Each stream of the log is read once, from one end to the other. Keys that alternate have the same blocks, and one
of them is tried; `MAX_TRIED` at most. So the work is linear in the length of the log.
"""

from __future__ import annotations

import re
from array import array
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import fsum, isinf
from statistics import median
from typing import Any, NamedTuple

from motionlang.kernel.log.log import Log
from motionlang.kernel.log.move import CONTINUED

# A repetition occurs as often at least, so that two periods are known.
MIN_OCCURRENCES = 3
# The share of the blocks with what is typical of them; what occurs twice in a cycle may be in two of three.
USUAL = 0.67
# A shorter cycle covers as much of the time of a longer one, and has more of its axes unless it prints; it is more
# frequent than so many times, and has more of its keys or moves, if the longer one is regular or not.
MIN_TIME, MIN_AXES = 0.9, 0.5
REGULAR, IRREGULAR = (3, 0.67), (1, 0.5)
# If a regular one has a print that the shorter one lacks, that is more frequent than so many prints.
PRINTED = 8
# One that prints, and is more frequent than so many times, covers as much of the time; it is the piece.
PIECE_TIME = 0.5
# The repetitions that targets may make one, and the share of a target by which two of them are the same.
MAX_TURNS, SAME_TARGET = 12, 1e-6
# Targets of axes that start together are one number; this makes each axis count differently.
_WEIGHT = 0.618034
# The keys that are tried, those first that take the most time together with what alternates with them.
MAX_TRIED = 32
# The newest moves of a run in progress that are searched.
MAX_NEWEST = 4_000
_FIGURE = re.compile(r"[-+]?\d")
MOVE, OUTPUT, PRINT = "move", "output", "print"


@dataclass(frozen=True, slots=True)
class Cycle:
    """The cycle of a run.

    `period` is the median time from one to the next, s, `count` the number of whole ones. `lines` are those of its
    moves, outputs and prints. `name` is a quantity such as "cycle(48)" or "cycle(print PART)", "" if nothing that has
    such a name happens once in it. `times` are those at which one begins, s.
    """

    name: str
    period: float
    count: int
    lines: tuple[int, ...]
    times: tuple[float, ...]

    @property
    def span(self) -> tuple[float, float]:
        """Begin and end of the last one of usual length, s."""
        usual = median(_gaps(self.times))
        return min(reversed(list(pairwise(self.times))), key=lambda each: abs(each[1] - each[0] - usual))

    @property
    def where(self) -> str:
        """Its lines, in words."""
        first, last = self.lines[0], self.lines[-1]
        return f"line {first}" if first == last else f"lines {first} to {last}"

    def as_dict(self) -> dict[str, object]:
        return {"name": self.name, "period": self.period, "count": self.count, "lines": list(self.lines)}

    def __str__(self) -> str:
        count = f"{self.count:,}".replace(",", " ")
        return f"{self.period:.5g} s, {count} times ({self.where})" + (f", {self.name}" if self.name else "")


class _Key(NamedTuple):
    """The acts of a statement.

    `what` are the command, axis and line of each of its moves, or kind, number and value of an output. `axes` are those
    that it moves without homing them. `detail` are the calls that lead to it, and the directions of its moves or the
    words of its print.
    """

    kind: str
    what: tuple[Any, ...]
    lines: tuple[int, ...]
    axes: tuple[int, ...] = ()
    detail: tuple[Any, ...] = ()


class _Events:
    """Events in the order of time: the numbers of their keys, and the targets of moves."""

    __slots__ = ("numbers", "targets", "times")

    def __init__(self) -> None:
        self.times, self.numbers, self.targets = array("d"), array("q"), array("d")

    def add(self, time: float, number: int, target: float = 0.0) -> None:
        """Append an event."""
        self.times.append(time)
        self.numbers.append(number)
        self.targets.append(target)

    def merged(self, other: _Events) -> _Events:
        """Return these events and others; of simultaneous ones these are first."""
        times, numbers = self.times + other.times, self.numbers + other.numbers
        order = sorted(range(len(times)), key=times.__getitem__)  # linear, since both are in order
        made = _Events()
        made.times = array("d", map(times.__getitem__, order))
        made.numbers = array("q", map(numbers.__getitem__, order))
        made.targets = array("d", map((self.targets + other.targets).__getitem__, order))
        return made


@dataclass(slots=True)
class _Repetition:
    """The repetition that a key begins.

    `blocks` is the number of its blocks, `times` are those of the key. `typical` keys are in most blocks, `once` those
    that are once in each; `covered` is the time that the typical ones take in the run. Most blocks of one that
    `is_regular` have the same number of events. The key occurs `turns` times in each.
    """

    key: int
    blocks: int
    times: array[float]
    typical: frozenset[int]
    once: frozenset[int]
    covered: float
    is_regular: bool
    turns: int = 1

    @property
    def is_interrupted(self) -> bool:
        """True if it rests for more than a tenth of the time, as steps do that are made for another task."""
        return self.blocks * median(_gaps(self.times)) < MIN_TIME * (self.times[-1] - self.times[0])


def cycle(
    log: Log,
    end: float,
    has_ended: bool,
    line_of: Callable[[int], int],
    owner: Callable[[int], str | None],
    homes: Callable[[str], bool],
) -> Cycle | None:
    """Return the cycle of a run that ended at `end`, or was cut off there; None if it has none.

    `line_of` returns the line of a source offset, `owner` the task that a line belongs to, None for a handler, and
    `homes` is true for the commands that home an axis.
    """
    seen = _Seen(owner, line_of, homes)
    moves, outputs, prints = seen.moves(log), seen.outputs(log), seen.prints(log)
    found = list[tuple[_Sequence, _Repetition]]()
    for task in sorted(moves, key=lambda each: seen.work(moves[each]), reverse=True):
        if seen.work(moves[task]) >= MIN_OCCURRENCES:
            events = moves[task].merged(outputs[task]).merged(prints[task])
            found += _repeated(_Sequence(events, seen.keys, end))
    if not found:
        return None
    others = (each for each in found if found[0][1].is_interrupted and each[0].prints(each[1]))
    sequence, best = next(others, found[0])
    return sequence.described(best, seen, has_ended)


def _repeated(sequence: _Sequence) -> Iterator[tuple[_Sequence, _Repetition]]:
    """Yield the cycle of a sequence, or of the one without details, which may cover more."""
    found = sequence.cycle()
    if found is None or sequence.share(found) < MIN_TIME:
        coarse = sequence.without_details()
        other = coarse.cycle()
        if other is not None and (found is None or sequence.share(found) < MIN_TIME * coarse.share(other)):
            sequence, found = coarse, other
    if found is not None:
        yield sequence, found


def cycle_so_far(
    log: Log, now: float, owner: Callable[[int], str | None], homes: Callable[[str], bool]
) -> Cycle | None:
    """Return the cycle of the newest moves of a run in progress, which another thread may go on with.

    Without outputs and prints, which that thread may be writing, it can be a longer one than in the end.
    """
    newest = Log()
    newest.callers = log.callers
    for move in log.moves[-MAX_NEWEST:]:
        newest.moves.add(move)
    return cycle(newest, now, False, lambda at: 0, owner, homes)


class _Seen:
    """The keys of a log by number, and how often lines, outputs and texts occur in all tasks."""

    def __init__(
        self, owner: Callable[[int], str | None], line_of: Callable[[int], int], homes: Callable[[str], bool]
    ) -> None:
        self._owner, self._line_of, self._homes = owner, line_of, homes
        self.keys: list[_Key] = []
        self._numbers: dict[_Key, int] = {}
        self._pairs: dict[tuple[int, int], int] = {}
        self.lines: Counter[int] = Counter()
        self.channels: Counter[int] = Counter()
        self.texts: Counter[str] = Counter()

    def _number(self, key: _Key) -> int:
        found = self._numbers.setdefault(key, len(self.keys))
        if found == len(self.keys):
            self.keys.append(key)
        return found

    def _task(self, line: int, callers: tuple[int, ...]) -> str | None:
        """Return the task that executes a line: for a sub that several call, the one that the calls began in."""
        outer = self._owner(self._line_of(callers[0])) if callers else None
        return outer or self._owner(line)

    def moves(self, log: Log) -> dict[str, _Events]:
        """Return the moves of each task."""
        made: dict[str, _Events] = {}
        targets: dict[int, float] = {}
        zeros = [(time, axis) for time, axis, _ in reversed(log.zeros)]
        continued: set[int] = set()
        last: dict[int, float] = {}  # the time of the last move of each line
        owners: dict[tuple[int, int], str | None] = {}
        parts: dict[tuple[object, ...], int] = {}
        for row in log.moves:
            axis, command, line, time = row.axis, row.command, row.line, row.start_time
            goes_on = axis in continued
            if row.ended == CONTINUED:
                continued.add(axis)
            elif goes_on:
                continued.discard(axis)
            while zeros and zeros[-1][0] <= time:
                targets[zeros.pop()[1]] = 0.0  # an axis is at its new zero, or near it
            before, target = targets.get(axis, 0.0), row.target
            targets[axis] = target
            if goes_on:
                continue
            if last.get(line) != time:
                last[line] = time
                self.lines[line] += 1
            place = line, row.chain
            if place not in owners:
                owners[place] = self._task(line, log.callers[row.chain])
            task = owners[place]
            if task is None:
                continue
            # An endless motion has no target but a direction.
            origin = target if isinf(before) else 0.0 if isinf(target) else before
            direction = (target > origin) - (target < origin)
            fields = command, axis, line, direction, row.chain
            part = parts.get(fields)
            if part is None:
                # A homing goes to and fro.
                moved, direction = ((), 0) if self._homes(command) else ((axis,), direction)
                what = command, axis, line
                key = _Key(MOVE, (what,), (line,), moved, ((what, direction, log.callers[row.chain]),))
                part = parts[fields] = self._number(key)
            events = made.get(task)
            if events is None:
                events = made[task] = _Events()
            weighted = 0.0 if isinf(target) else target * (1.0 + axis * _WEIGHT)
            if events.times and events.times[-1] == time:
                events.numbers[-1] = self._joined(events.numbers[-1], part)
                events.targets[-1] += weighted
            else:
                events.add(time, part, weighted)
        return made

    def work(self, moves: _Events) -> int:
        """Return how many moves are no homing."""
        return sum(bool(self.keys[number].axes) for number in moves.numbers)

    def _joined(self, number: int, part: int) -> int:
        """Return the key of moves and another one that start at one time."""
        found = self._pairs.get((number, part))
        if found is None:
            keys = self.keys[number], self.keys[part]
            found = self._pairs[number, part] = self._number(
                _Key(
                    MOVE,
                    tuple(sorted(each for key in keys for each in key.what)),
                    tuple(sorted({line for key in keys for line in key.lines})),
                    tuple(sorted({axis for key in keys for axis in key.axes})),
                    tuple(sorted(each for key in keys for each in key.detail)),
                )
            )
        return found

    def outputs(self, log: Log) -> Mapping[str, _Events]:
        """Return the outputs that each task switches."""
        digital, analogue = defaultdict[str, _Events](_Events), defaultdict[str, _Events](_Events)
        known: dict[tuple[object, ...], tuple[str, int] | None] = {}
        for stream, made in ((log.outputs, digital), (log.analogue_outputs, analogue)):
            is_digital = made is digital
            for time, channel, value, at, chain in stream:
                if is_digital and value:
                    self.channels[channel] += 1
                fields = is_digital, channel, value if is_digital else None, at, chain
                if fields not in known:
                    line = self._line_of(at) if at >= 0 else 0
                    task = self._task(line, log.callers[chain]) if at >= 0 else None
                    key = _Key(OUTPUT, fields[:3], (line,), (), (log.callers[chain],))
                    known[fields] = None if task is None else (task, self._number(key))
                if (found := known[fields]) is not None:
                    made[found[0]].add(time, found[1])
        for task, events in analogue.items():
            digital[task] = digital[task].merged(events)
        return digital

    def prints(self, log: Log) -> Mapping[str, _Events]:
        """Return the lines that each task prints."""
        made = defaultdict[str, _Events](_Events)
        lines: dict[tuple[int, int], tuple[str | None, int]] = {}
        known: dict[tuple[int, int, str], int] = {}
        for time, text, at, chain in log.prints:
            self.texts[_FIGURE.sub("\0", text)] += 1
            place = at, chain
            if place not in lines:
                line = self._line_of(at) if at >= 0 else 0
                lines[place] = (self._task(line, log.callers[chain]) if at >= 0 else None), line
            task, line = lines[place]
            if task is not None and line:
                words = at, chain, _FIGURE.split(text, maxsplit=1)[0].strip()
                if words not in known:
                    detail = words[2], log.callers[chain]
                    known[words] = self._number(_Key(PRINT, (), (line,), (), detail))
                made[task].add(time, known[words])
        return made

    def name(self, key: _Key, count: int) -> str:
        """Return the name of what occurs `count` times in a task; "" if it has none, or also occurs elsewhere."""
        if key.kind == MOVE:
            line = key.lines[0]
            return f"cycle({line})" if len(key.lines) == 1 and line and self.lines[line] == count else ""
        if key.kind == OUTPUT:
            is_digital, channel, value = key.what
            is_named = is_digital and value and self.channels[channel] == count
            return f"cycle(output {channel})" if is_named else ""
        words = str(key.detail[0]) if key.detail else ""
        is_typed = len(words) > 1 and words.isprintable() and not set("(),") & set(words)
        times = sum(each for text, each in self.texts.items() if words in text) if is_typed else 0
        return f"cycle(print {words})" if times == count else ""


class _Sequence:
    """The events of a task in the order of the log: times and keys."""

    def __init__(self, events: _Events, keys: Sequence[_Key], end: float) -> None:
        self.times, self.numbers, self.keys, self.end = events.times, events.numbers, keys, end
        self.targets = events.targets
        self.counts = Counter(self.numbers)
        # The usual time from an event to the next, times the number of such events: a long wait does not count.
        spans = {number: array("d") for number in self.counts}
        following = self.times[1:]
        following.append(end)
        for number, before, after in zip(self.numbers, self.times, following, strict=True):
            spans[number].append(after - before)
        self.spans = {number: len(each) * median(each) for number, each in spans.items()}
        self.total = fsum(self.spans.values())

    def without_details(self) -> _Sequence:
        """Return the sequence without the directions and words that vary."""
        variants: dict[_Key, list[int]] = {}
        for k in self.spans:
            variants.setdefault(self.keys[k]._replace(detail=()), []).append(k)
        keys = [plain if len(same) > 1 else self.keys[same[0]] for plain, same in variants.items()]
        of = {k: number for number, same in enumerate(variants.values()) for k in same}
        events = _Events()
        events.times, events.numbers = self.times, array("q", [of[k] for k in self.numbers])
        events.targets = self.targets
        return _Sequence(events, keys, self.end)

    def share(self, found: _Repetition) -> float:
        """Return the share of the time of all events that a repetition covers."""
        return found.covered / self.total if self.total else 1.0

    def cycle(self) -> _Repetition | None:
        """Return the repetition that covers most, or a shorter one in its place."""
        found: dict[frozenset[int], _Repetition] = {}
        for key in self._tried():
            made = self._repetition(key)
            if any(self.keys[k].axes for k in made.typical):
                found.setdefault(made.typical, made)
        if not found:
            return None
        best = max(found.values(), key=lambda each: (each.covered, len(each.typical)))
        shorter = [each for each in found.values() if self._replaces(each, best)]
        return self._whole_turns(max(shorter, key=lambda each: each.blocks, default=best))

    def _replaces(self, short: _Repetition, long: _Repetition) -> bool:
        """True if what a shorter repetition leaves out is no more than an interruption."""
        rare, keys = REGULAR if long.is_regular else IRREGULAR
        least = rare * long.blocks
        if self.prints(short):
            least = long.blocks
        elif long.is_regular:
            left = [self.counts[k] for k in long.typical - short.typical if self.keys[k].kind == PRINT]
            least = PRINTED * max(left) if left else least
        one, all_ = ([len(each.typical), self._moves(each)] for each in (short, long))
        axes, all_axes = self._axes(short.typical), self._axes(long.typical)
        share = MIN_TIME
        if self.prints(short) and short.blocks > PRINTED * long.blocks:
            share, keys = PIECE_TIME, IRREGULAR[1]
        return (
            short.covered >= share * long.covered
            and short.blocks > least
            and any(a > keys * b for a, b in zip(one, all_, strict=True))
            and (self.prints(short) or len(axes) > MIN_AXES * len(all_axes))
        )

    def _has_fixed_targets(self, found: _Repetition) -> bool:
        """True if each key of a repetition always has the same target."""
        first: dict[int, float] = {}
        typical = found.typical
        return all(
            number not in typical or first.setdefault(number, target) == target
            for number, target in zip(self.numbers, self.targets, strict=True)
        )

    def _moves(self, found: _Repetition) -> int:
        return sum(bool(self.keys[k].axes) for k in found.typical)

    def prints(self, found: _Repetition) -> bool:
        """True if a repetition prints something once, which makes it a piece."""
        return any(self.keys[k].kind == PRINT for k in found.once)

    def _whole_turns(self, found: _Repetition) -> _Repetition:
        """Return a repetition, or as many as have the same targets again, or targets that advance by a constant."""
        if self.prints(found) or self._has_fixed_targets(found):
            return found
        blocks: list[dict[int, list[float]]] = []
        for number, target in zip(self.numbers, self.targets, strict=True):
            if number == found.key:
                blocks.append({})
            if blocks and number in found.typical and self.keys[number].axes:
                blocks[-1].setdefault(number, []).append(target)
        blocks.pop()
        most = min(MAX_TURNS, len(blocks) // MIN_OCCURRENCES)
        turns = next((count for count in range(1, most + 1) if _is_exact(blocks, count)), 1)
        if turns == 1:
            return found
        times = found.times[::turns]
        return replace(found, blocks=len(times) - 1, times=times, once=frozenset(), turns=turns)

    def _axes(self, typical: Iterable[int]) -> set[object]:
        return {axis for k in typical for axis in self.keys[k].axes}

    def _tried(self) -> list[int]:
        """Return the first of each set of keys that alternate, in the order of the log."""
        first: dict[int, int] = {}
        second: dict[int, int] = {}
        last: dict[int, int] = {}
        for place, number in enumerate(self.numbers):
            if number not in first:
                first[number] = place
            elif number not in second:
                second[number] = place
            last[number] = place
        heads: dict[int, list[int]] = {}  # those with the same number of occurrences
        spans: dict[int, float] = {}
        for number, place in first.items():
            count = self.counts[number]
            if count < MIN_OCCURRENCES:
                continue
            # A later key is in no first block of what has already occurred twice.
            same = heads[count] = [k for k in heads.get(count, ()) if place < second[k]]
            head = next((k for k in same if last[number] > last[k]), None)
            if head is None:
                head = number
                same.append(number)
            spans[head] = spans.get(head, 0.0) + self.spans[number]
        chosen = sorted(spans, key=lambda k: -spans[k])[:MAX_TRIED]
        return sorted(chosen, key=lambda k: first[k])

    def _repetition(self, key: int) -> _Repetition:
        block, times, starts = 0, array("d"), array("q")
        seen, inside = [0] * len(self.keys), [0] * len(self.keys)
        for place, number in enumerate(self.numbers):
            if number == key:
                block += 1
                times.append(self.times[place])
                starts.append(place)
            if seen[number] != block:
                seen[number] = block
                inside[number] += 1
        # The last block is cut off, by the end of the run or of what is repeated.
        blocks = block - 1
        inside = [count - (at == block) for count, at in zip(inside, seen, strict=True)]
        typical = frozenset(k for k, count in enumerate(inside) if count > USUAL * blocks)
        once = frozenset(k for k in typical if inside[k] == blocks and self.counts[k] <= blocks + 2)
        covered = fsum(self.spans[k] for k in typical)
        usual = Counter(_gaps(starts)).most_common(1)[0][1]
        return _Repetition(key, blocks, times, typical, once, covered, usual > USUAL * blocks)

    def described(self, found: _Repetition, seen: _Seen, has_ended: bool) -> Cycle:
        """Return a repetition as a cycle, with the name of what happens once in it."""
        kinds = (PRINT, MOVE, OUTPUT)
        name, times = "", list(found.times)
        own = [found.key] if found.turns == 1 else []
        for k in sorted([*own, *sorted(found.once)], key=lambda k: kinds.index(self.keys[k].kind)):
            name = seen.name(self.keys[k], self.counts[k])
            if name:
                times = [time for time, number in zip(self.times, self.numbers, strict=True) if number == k]
                break
        lines = sorted({line for k in found.typical for line in self.keys[k].lines})
        ends = self._is_first_whole(found, has_ended) + self._is_last_whole(found, has_ended)
        count = found.blocks + (ends or self._are_ends_one(found, has_ended))
        return Cycle(name, median(_gaps(times)), count, tuple(lines), tuple(found.times))

    def _is_first_whole(self, found: _Repetition, has_ended: bool) -> bool:
        """True if all of a cycle precedes its key, which ends it then, and the last one is not a move under way."""
        others = found.typical - {found.key}
        is_over = has_ended or self.keys[found.key].kind != MOVE or self.numbers[-1] != found.key
        return is_over and bool(others) and others <= set(self.numbers[: self.numbers.index(found.key)])

    def _is_last_whole(self, found: _Repetition, has_ended: bool) -> bool:
        before = Counter(one for one, two in pairwise(self.numbers) if two == found.key)
        final = max(before, key=lambda k: (before[k], -k))
        start = len(self.numbers) - 1 - self.numbers[::-1].index(found.key)
        rest = self.numbers[start:]
        if final not in rest:
            return False
        is_done = has_ended or (self.keys[final].kind != MOVE and final in found.once)
        is_followed = any(k not in found.typical for k in rest[rest.index(final) :])
        return is_done or is_followed or self.end - self.times[start] >= min(_gaps(found.times))

    def _are_ends_one(self, found: _Repetition, has_ended: bool) -> bool:
        """True if the run begins a cycle before its key, and does as much of one after the last key as is left."""
        begin = next(place for place, number in enumerate(self.numbers) if number in found.typical)
        before, after = found.times[0] - self.times[begin], self.end - found.times[-1]
        return before > 0.0 and (has_ended or before + after >= median(_gaps(found.times)))


def _is_exact(blocks: Sequence[dict[int, list[float]]], turns: int) -> bool:
    """True if most blocks have the targets of the one so many before them, or targets that advance by a constant."""
    steps: list[dict[int, float] | None] = []
    for before, after in zip(blocks, blocks[turns:], strict=False):
        shifts = {k: [b - a for a, b in zip(before[k], after[k], strict=False)] for k in before if k in after}
        is_alike = before.keys() == after.keys() and all(len(before[k]) == len(after[k]) for k in before)
        is_even = all(_is_same(each, one[0]) for one in shifts.values() for each in one)
        steps.append({k: each[0] for k, each in shifts.items()} if is_alike and is_even else None)
    same = sum(one is not None and not any(map(_differs, one.values())) for one in steps)
    advancing = sum(
        one is not None and two is not None and all(_is_same(two[k], one[k]) for k in one if k in two)
        for one, two in zip(steps, steps[turns:], strict=False)
    )
    pairs = len(steps) - turns
    return same > USUAL * len(steps) or (pairs > 1 and advancing > USUAL * pairs)


def _differs(shift: float) -> bool:
    return abs(shift) > SAME_TARGET


def _is_same(one: float, other: float) -> bool:
    return abs(one - other) <= SAME_TARGET * max(1.0, abs(one), abs(other))


def _gaps(times: Iterable[float]) -> Iterator[float]:
    return (after - before for before, after in pairwise(times))
