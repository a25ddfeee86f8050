"""The entries that no column has: keys, answers, numbers of a host, and inputs that were not recorded.

Problem. The exploration enters them as soon as the program waits for them. The machine had them at another time, and
perhaps with another number. Until they are right, the run is not that of the recording, and nothing can be compared.

Idea. The marks of the recording show when the program must have gone on. A run with changed entries is better if more
of its marks agree with the recording: the time since the mark before differs by little. Who answers the program takes
as long each time (`asked`), and the marks show how long. If not all of them agree then, four changes are tried:

    another time      the first mark that is too early or late is moved by the last entry before it
    another number    it is doubled or halved as long as more marks agree, and then found by halves
    once more         the run stops short of a mark, and goes on if the entry comes again
    one by one        an entry that the exploration repeats by itself comes only where a mark needs it

An entry has no time of its own in the recording. It is entered at the time of the mark, and then earlier by as much as
the run answers later. So a mark comes right, whatever the program does between the entry and the mark.

Cost: a run for each change that is tried, `MAX_RUNS` at most, each as long as the recording.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import NamedTuple

from motionlang.kernel import Run
from motionlang.kernel.lang import DRIVES
from motionlang_explore.exploration import TABLES, Entry
from motionlang_explore.init.recorded.outcome import OutcomeMark, matched, near
from motionlang_explore.init.recorded.recording import MeasuredRecording

# Runs that are tried, the marks to which an entry is moved without success, and those for which it comes once more.
MAX_RUNS, MAX_FAILED, MAX_MISSING = 80, 4, 4
# A person answers after this time, s, and nobody sooner than this. How often the time of one answer is corrected.
ANSWER, SOONEST, MAX_ANSWERS = 0.3, 0.001, 3
# The time since the mark before may differ by this share of it.
SHARE = 0.01
# The largest number that is tried.
MAX_NUMBER = 10_000
# The period of keys that came when they were asked for, s, before the recording says when they did.
EVERY = 2.0
# When an entry comes; the other keys say what it is.
TIMES = ("at", "every", "times", "output", "level", "delay", "for")

Tables = Mapping[str, Sequence[Entry]]
World = tuple[tuple[str, Entry], ...]


class FittedWorld(NamedTuple):
    """Entries that were not recorded, by table, the run with them, and the entries that the recording has changed.

    Of two, that with the higher `score` agrees better with the recording; `is_perfect` is True if all agrees.
    """

    tables: dict[str, list[Entry]]
    run: Run
    changed: list[tuple[str, Entry]]
    score: tuple[int, int]
    is_perfect: bool

    def corrected(self, clock: float) -> FittedWorld:
        """Return the entries with right seconds, if the recording counts `clock` seconds for one."""

        def scaled(entry: Entry) -> Entry:
            return {**entry, "at": round(_at(entry) / clock, 3)} if entry in moved else entry

        moved = [entry for _, entry in self.changed if _at(entry) > 0.0]
        tables = {table: [*map(scaled, each)] for table, each in self.tables.items()}
        return self._replace(tables=tables, changed=[(table, scaled(each)) for table, each in self.changed])


class _Attempt(NamedTuple):
    """A run with some entries: how many marks agree, the times of the pairs, and the recorded marks that it lacks.

    `late` has by how much later the differing marks come in the recording, s.
    Of runs in which equally many agree, the one with fewer other marks has the higher `score`.
    """

    world: World
    run: Run
    score: tuple[int, int]
    is_perfect: bool
    pairs: dict[OutcomeMark, float]
    differing: list[OutcomeMark]
    late: list[float]
    missing: list[OutcomeMark]


def fitted(guesses: Tables, recording: MeasuredRecording, play: Callable[[Tables], Run]) -> FittedWorld:
    """Return guessed entries as the marks of a recording need them; `play` runs the program with some."""
    before = tuple((table, entry) for table in TABLES for entry in guesses.get(table, ()))
    fit = _Fit(_asked(before), recording, play)
    fit.answer()
    if before and not fit.best.is_perfect:
        timed = _Fit(tuple((table, _timed(entry)) for table, entry in before), recording, play)
        timed.improve()
        fit = max(fit, timed, key=lambda each: each.best.score)
    changed = [each for each in fit.best.world if each not in before]
    best = fit.best
    return FittedWorld(_tables(best.world), best.run, changed, best.score, best.is_perfect)


def _asked(world: World) -> World:
    """Return each entry once, as the answer of somebody whom the program asks; inputs and levels stay as they are."""
    found: World = ()
    for table, entry in world:
        kind = {key: value for key, value in entry.items() if key not in TIMES}
        answers = "channel" in entry or "asked" in entry or table == "answer"
        made = table, entry if answers else {**kind, "asked": ANSWER}
        found += () if made in found else (made,)
    return found


def _timed(entry: Entry) -> Entry:
    """Return an entry with times in place of `asked`: the recording shows when it came, and how often."""
    if "asked" not in entry:
        return entry
    kept = {key: value for key, value in entry.items() if key != "asked"}
    return {**kept, "at": entry["asked"], **({"every": EVERY} if "text" in entry else {})}


def _tables(world: World) -> dict[str, list[Entry]]:
    found: dict[str, list[Entry]] = {}
    for table, entry in world:
        found.setdefault(table, []).append(entry)
    return found


class _Fit:
    """The best entries so far, which each change that is tried may replace."""

    def __init__(self, world: World, recording: MeasuredRecording, play: Callable[[Tables], Run]) -> None:
        self._recording, self._play, self._count = recording, play, 0
        self.best = self._attempt(world)

    def answer(self) -> None:
        """Let who answers the program take longer or shorter, by as much as the first mark that differs."""
        for k, (_, entry) in enumerate(self.best.world):
            for _ in range(MAX_ANSWERS if "asked" in entry else 0):
                if self.best.late:
                    late = self._attempt(_answering(self.best.world, k, self.best.late[0]))
                    if not self._keep(late):
                        break

    def improve(self) -> None:
        """Try all changes; with another number, the marks that follow may need another time."""
        self._move()
        before = self.best
        self._count_again()
        if self.best is not before:
            self._move()
        self._repeat(self.best.world)
        self._separate()

    @property
    def _is_open(self) -> bool:
        return not self.best.is_perfect and self._count < MAX_RUNS

    def _attempt(self, world: World) -> _Attempt:
        self._count += 1
        run = self._play(_tables(world))
        found = matched(run, self._recording)
        agreeing, differing, late = 0, [], []
        before = (0.0, 0.0)
        pairs: dict[OutcomeMark, float] = {}
        for a, b in found.pairs:
            mine, theirs = found.mine[a].time, found.theirs[b].time
            step = mine - before[0]
            by = theirs - before[1] - step
            if abs(by) <= near(self._recording) + SHARE * abs(step):
                agreeing += 1
            else:
                differing.append(found.theirs[b])
                late.append(by)
            pairs[found.theirs[b]] = mine
            before = mine, theirs
        missing = [each for each in found.theirs if each not in pairs]
        extra = sum(each.time <= self._recording.end for each in found.mine) - len(found.pairs)
        is_perfect = not (differing or missing or extra > 0)
        return _Attempt(world, run, (agreeing, -max(extra, 0)), is_perfect, pairs, differing, late, missing)

    def _keep(self, attempt: _Attempt | None) -> bool:
        """Make an attempt the best one if it is better."""
        is_better = attempt is not None and attempt.score > self.best.score
        if attempt is not None and is_better:
            self.best = attempt
        return is_better

    def _placed(self, mark: OutcomeMark, world_at: Callable[[float], World]) -> _Attempt | None:
        """Return the run in which a mark has the recorded time, by the time of an entry; None if it lacks the mark."""
        found = self._attempt(world_at(mark.time))
        if mark not in found.pairs:
            return None
        return self._attempt(world_at(max(2.0 * mark.time - found.pairs[mark], 0.0)))

    def _move(self) -> None:
        """Move entries, and those after them, to where the first marks that differ need them."""
        tried: set[OutcomeMark] = set()
        failed: Counter[int] = Counter()
        while self._is_open:
            mark = next((each for each in self.best.differing if each not in tried), None)
            if mark is None:
                return
            tried.add(mark)
            times = [_at(entry) for _, entry in self.best.world]
            latest = self.best.pairs[mark] + near(self._recording)
            due = {each for each in times if 0.0 <= each <= latest}
            for time in sorted(due, reverse=True):
                first = times.index(time)
                if failed[first] < MAX_FAILED:
                    if self._keep(self._placed(mark, partial(_moved, self.best.world, time))):
                        break
                    failed[first] += 1

    def _count_again(self) -> None:
        """Give entries the numbers with which most marks agree."""
        for k, (table, entry) in enumerate(self.best.world):
            value = _number(entry) if table != "key" else None
            if value is not None and self._is_open:
                self._halve(k, value)

    def _halve(self, k: int, value: int) -> None:
        """Find the number of an entry; marks are fewer below the right one, and no more above."""
        before = self.best
        tried = {value: before}

        def score(number: int) -> tuple[int, int]:
            if number not in tried:
                tried[number] = self._attempt(_numbered(before.world, k, number))
                self._keep(tried[number])
            return tried[number].score

        high = value
        while high < MAX_NUMBER and score(2 * high) > score(high):
            high *= 2
        if high == value:
            while high > 1 and score(high // 2) >= score(max(tried)):
                high //= 2
        low, enough = high // 2, score(max(tried))
        while high - low > 1 and self._is_open:
            middle = (low + high) // 2
            low, high = (low, middle) if score(middle) >= enough else (middle, high)
        while self._is_open and score(high + 1) > score(high):
            high += 1
        if self.best is not before and score(high) == self.best.score:
            self.best = tried[high]

    def _repeat(self, world: World) -> None:
        """Enter the entries of a world once more where the run stops short of a mark."""
        kinds: World = ()
        for table, entry in reversed(world):
            kind = table, {key: value for key, value in entry.items() if key not in TIMES}
            kinds += () if kind in kinds else (kind,)
        while self._is_open:
            for mark in self.best.missing[:MAX_MISSING]:
                if any(
                    self._keep(self._placed(mark, partial(_with, self.best.world, kind))) for kind in kinds
                ):
                    break
            else:
                return

    def _separate(self) -> None:
        """Enter what comes again by itself one by one instead, where that is better."""
        for k, (table, entry) in enumerate(self.best.world):
            if table != "input" and self._is_open and ("every" in entry or "output" in entry):
                before = self.best
                self.best = self._attempt((*before.world[:k], *before.world[k + 1 :]))
                self._repeat((before.world[k],))
                if not self.best.score > before.score:
                    self.best = before


def _at(entry: Entry) -> float:
    """Return the time of an entry, s; -1 if it has none."""
    at = entry.get("at", -1.0)
    return float(at) if isinstance(at, (int, float)) else -1.0


def _moved(world: World, since: float, time: float) -> World:
    """Return a world whose entries from a time on are later, so that the first one comes at another time."""
    by = time - since
    return tuple(
        (table, {**entry, "at": round(_at(entry) + by, 3)} if _at(entry) >= since else entry)
        for table, entry in world
    )


def _answering(world: World, k: int, by: float) -> World:
    """Return a world in which one entry takes longer to answer the program."""
    table, entry = world[k]
    asked = max(round(float(str(entry["asked"])) + by, 3), SOONEST)
    return (*world[:k], (table, {**entry, "asked": asked}), *world[k + 1 :])


def _with(world: World, kind: tuple[str, Entry], time: float) -> World:
    """Return a world with one entry more at a time; answers come when they are asked for."""
    table, entry = kind
    return (*world, (table, entry if table == "answer" else {**entry, "at": round(time, 3)}))


def _number(entry: Entry) -> int | None:
    """Return the number of an entry, if it is a whole one that can be doubled."""
    value = entry.get("value", entry.get("text"))
    try:
        number = float(str(value))
    except ValueError:
        return None
    is_number = "channel" not in entry and number >= 1.0 and number.is_integer()
    return int(number) if is_number else None


def _numbered(world: World, k: int, number: int) -> World:
    table, entry = world[k]
    changed = {"value": float(number)} if "value" in entry else {"text": str(number)}
    return (*world[:k], (table, {**entry, **changed}), *world[k + 1 :])


def subject(table: str, entry: Entry) -> str:
    """Return the name of what an entry changes, such as "comms element 1"."""
    name, key = DRIVES[table]
    if table == "answer":
        return f"the answer to {entry['prompt']!r}" if "prompt" in entry else "an answer"
    return f"{name} {entry[key]}" if key else f"a {name}"


def in_words(found: FittedWorld) -> Iterator[str]:
    """Yield which entries the recording has changed."""
    for table, entry in found.changed:
        value = entry.get("value", entry.get("text", ""))
        shown = f"{value:.10g}" if isinstance(value, float) else value
        at = f" at {_at(entry):.4g} s" if _at(entry) > 0.0 else ""
        at = f" {entry['asked']:.4g} s after it is asked for" if "asked" in entry else at
        yield f"{subject(table, entry)}: {shown}{at} agrees best with the recording"
