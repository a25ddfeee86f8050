"""The numbers that a process needs as they are: a homing, the glue, the feed of a drill.

No text says which speeds these are, but what the program does with them. The speed of a homing finds a switch; that of
a motion that the program stops decides where it stops. A speed that is lower than others of its axis, while the task
has switched an output on, is that of a tool. The other reason is a comment: it names the number, or the process.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import accumulate, chain, pairwise
from math import fsum, hypot, inf
from typing import NamedTuple

from motionlang.commands.certify.extremes import extremes
from motionlang.commands.channels import channels_of
from motionlang.kernel import Run
from motionlang.kernel.lang import Literal, comments_of, names_in_comments
from motionlang.kernel.log import LoggedMove
from motionlang.kernel.planners import Profile
from motionlang_explore.improve.acts import CYCLES, LATE
from motionlang_explore.improve.tasks import Tasks

# The words of a comment that name a process, in English and in German.
WORDS = """
bead brush careful carefully cut cutting dispense dose drill drilling feed gentle gently glue glueing gluing grind
grinding ink mark marking mill milling paint painting polish print printing saw sawing seal sealing slow slowly solder
soldering spray tap tapping weld welding
bohren dosieren drucken fräsen gewinde kleben kleber lackieren langsam leim löten markieren polieren sägen schleifen
schneiden schweißen schweissen siegeln sprühen tinte vorschub vorsichtig
"""
_WORD = re.compile(rf"\b(?:{'|'.join(WORDS.split())})\b", re.IGNORECASE)
_HOLD = re.compile(r"\bimprove:\s*hold\b", re.IGNORECASE)
# A number, but no date and no version.
_NUMBER = re.compile(r"(?<![\w.,/:-])\d+(?:\.\d+)?(?![\d/:]|[.,-]\d)")
# The reason of what the user holds.
AS_SAID = "as you said"
# So many lines above its own may have the comment of a number.
ABOVE = 2
# An output that is on for less than this during a move only follows or precedes it, s.
SHORT = 1e-3
# What differs by less than this share is the same.
SAME_SHARE = 1e-6


# The quantities that limits bound, in the order in which they are named.
QUANTITIES = SPEED, ACCELERATION, JERK = "speed", "acceleration", "jerk"
# Positions and distances that differ by less are the same, user units.
SAME_PLACE = 1e-6


class MoveChange(NamedTuple):
    """A move of which a quantity follows a number: its values in user units in both runs, 0 and its sign for a jerk.

    `rate` is 1 for a deceleration.
    """

    move: LoggedMove
    quantity: str
    value: float
    other: float
    rate: int = 0

    @property
    def power(self) -> int:
        """The power of k by which its number is scaled if the move takes 1/k of the time; -1 for the time of a ramp."""
        return QUANTITIES.index(self.quantity) + 1 if self.other < self.value else -1

    def is_proportional(self, ratio: float) -> bool:
        """True if the other value is a share of the value, rounded to counts as a controller does."""
        return abs(self.other - ratio * self.value) <= self.move.size_to_user(0.5) < self.value


class _On(NamedTuple):
    """An output that the work switches, by its name and its task, and when it is on.

    It is steady if it is switched on equally often in every cycle, unlike a lamp that blinks.
    """

    name: str
    task: str
    spans: Sequence[tuple[float, float]]
    is_steady: bool


class Process:
    """The process of a run, whose cycles begin at `starts`."""

    def __init__(self, run: Run, tasks: Tasks, starts: Sequence[float]) -> None:
        self._run, self._tasks, self._starts = run, tasks, starts
        self._homes = run.dialect.table().homes
        self._outputs = sorted(
            _switched(run, tasks, starts), key=lambda each: fsum(end - begin for begin, end in each.spans)
        )
        self._speeds: dict[tuple[float, int, str], float] = {}
        self._highest: dict[int, float] = {}
        for move in run.machine.log.moves:
            if move.profile is not None:
                key = move.start_time, move.line, move.command
                self._speeds[key] = hypot(self._speeds.get(key, 0.0), _own_speed(move))
        for move in run.machine.log.moves:
            if move.profile is not None and not self._homes(move.command) and not move.ended:
                self._highest[move.axis] = max(self._highest.get(move.axis, 0.0), self._speed(move))
        self._shots = [(on, k) for on in self._outputs for k in self._shots_of(on)]
        self._own, self._alone = _comments(run)
        axes = run.controller.axes
        self._jumps = {
            n: extremes(axes[n], run.time).jerk.value == inf for n in {m.axis for m in run.machine.log.moves}
        }

    def changes(self, other: Run) -> list[MoveChange]:
        """Return how the moves follow a number that another run has changed, none if they go elsewhere then."""
        found: list[MoveChange] = []
        mine, others = _planned(self._run), _planned(other)
        for axis, moves in mine.items():
            for move, now in zip(moves, others.get(axis, ()), strict=False):
                if (move.line, move.command) != (now.line, now.command):
                    break
                is_whole = not (move.ended or now.ended or move.follows or self._homes(move.command))
                if is_whole and _goes_elsewhere(move, now):
                    return []
                found += _changes(move, now, is_whole, self._jumps[axis])
        return found

    def also_sets(self, other: Run, ratio: float) -> str:
        """Return what else than motion a number sets, by a run in which it is `ratio` times as large; "" if nothing.

        A time that the program waits for gets longer or shorter by the ratio while no axis moves. An output that is on
        while an axis moves, and off when that stops, is on for the time of a move.
        """
        for was, now in zip(
            self._run.machine.log.analogue_outputs, other.machine.log.analogue_outputs, strict=False
        ):
            if was.channel == now.channel and abs(was.value - now.value) > SAME_SHARE:
                return f"line {self._line(was.at)} sets analogue output {was.channel} by it"
        mine, others = _times(self._run), _times(other)
        is_still = _standstill(self._run)
        for (what, at), spans in mine.items():
            pairs = [
                (end - begin, until - since, begin, end)
                for (begin, end), (since, until) in zip(spans, others.get((what, at), ()), strict=False)
            ]
            if pairs and all(
                abs(was - now) > 2.0 * LATE
                and (what == "time" or min(abs(now - ratio * was), abs(now - was / ratio)) < LATE)
                and (what in ("time", "pulse") or is_still(begin, end))
                for was, now, begin, end in pairs
            ):
                seconds = f"{pairs[0][0]:.4g} s"
                if what in ("output", "pulse"):
                    return f"output {at} is on for {seconds} by it"
                return f"line {self._line(at)} waits {seconds} by it"
        switched = {(on.name, on.task): on.spans for on in _switched(other, self._tasks, self._starts)}
        for on, k in self._shots:
            begin, end = on.spans[k]
            since, until = dict(enumerate(switched.get((on.name, on.task), ()))).get(k, (begin, end))
            if until < other.time and abs(until - since - (end - begin)) > 2.0 * LATE:
                return f"{on.name} is on for {end - begin:.4g} s by it"
        return ""

    def _shots_of(self, on: _On) -> Iterator[int]:
        """Yield the numbers of the times that an output is on while an axis moves, and off when that stops.

        The same goes for axes that start together; one that still moves then does not count. An output that is on
        during all moves of an axis follows it.
        """
        first, last = (self._starts[0], self._starts[: CYCLES + 1][-1]) if self._starts else (-inf, inf)
        work = [
            move
            for move in chain.from_iterable(_planned(self._run).values())
            if not self._homes(move.command) and _end(move) < inf and first <= move.start_time < last
        ]
        work.sort(key=lambda move: move.start_time)
        without = {move.axis for move in work if not any(_is_during(move, *span) for span in on.spans)}
        for k, (begin, end) in enumerate(on.spans):
            during = [
                m for m in work if _is_during(m, begin, end) and self._is_bound(on, self._tasks.at(m.line))
            ]
            goes_on = {move.axis for move in during if _end(move) >= end + SHORT}
            during = [move for move in during if move.axis not in goes_on]
            axes = {move.axis for move in during}
            begins = {tuple(move.start_time for move in during if move.axis == axis) for axis in axes}
            is_one = all(after.start_time < _end(before) + LATE for before, after in pairwise(during))
            if first <= begin and end <= last and len(begins) == 1 and is_one and axes & without:
                stop = _end(during[-1])
                if end - stop < stop - max(begin, during[0].start_time) and stop < end + SHORT:
                    yield k

    def _line(self, at: int) -> int:
        return self._run.dialect.locate(self._run.source, at)[0]

    def reason(self, moves: Sequence[LoggedMove], value: float) -> str:
        """Return why the speed of some moves, set by a value, is that of a process; "" if it need not be."""
        if any(self._homes(move.command) for move in moves):
            return "the speed of a homing"
        lines = {move.line: 0 for move in moves}
        for move in moves:
            lines[move.line] += 1 if move.ended in ("stop", "cancel") else -1
        stopped = next((move for move in moves if lines[move.line] > 0), None)
        if stopped is not None:
            return f"the program stops the {stopped.command} of line {stopped.line}"
        for move in moves:
            highest, on = self._highest.get(move.axis, 0.0), self.outputs([move])
            speed = f"{self._speed(move):.6g}"
            if on and float(speed) < highest * (1.0 - SAME_SHARE):
                own = "" if speed == f"{abs(value):.6g}" else f"{speed} uu/s in line {move.line} is "
                return f"{own}lower than {highest:.6g} while {on[0]} is on"
        return ""

    def outputs(self, moves: Iterable[LoggedMove]) -> list[str]:
        """Return the names of the outputs that are on during some moves, those first that are on for the least time.

        They are switched by the task of the move, or by one that reads what that one sets.
        """
        work = [move for move in moves if move.profile is not None and not self._homes(move.command)]
        return [
            output.name
            for output in self._outputs
            if any(
                self._is_bound(output, self._tasks.at(move.line)) and _is_during(move, *span)
                for move in work
                for span in output.spans
            )
        ]

    def _is_bound(self, output: _On, task: str) -> bool:
        return output.task == task or (output.is_steady and self._tasks.reads(output.task, task))

    def _speed(self, move: LoggedMove) -> float:
        if move.commanded_speed is not None:
            return _own_speed(move)
        return self._speeds[move.start_time, move.line, move.command]

    def comment(self, literal: Literal, speeds: Sequence[Literal]) -> str:
        """Return what a comment says about a number; "" if nothing. `speeds` are the speeds of the program."""
        line = literal.line
        above = [each for each in range(line - ABOVE, line) if each in self._alone]
        for each in (line, *reversed(above)):
            text = self._own.get(line, "") if each == line else self._alone[each]
            if each == line and _HOLD.search(text):
                return AS_SAID
            if abs(literal.value) in map(float, _NUMBER.findall(text)):
                return f"the comment of line {each} names it"
            word = _WORD.search(text)
            first = min((speed.line for speed in speeds if each <= speed.line), default=0)
            lowest = min((abs(speed.value) for speed in speeds if speed.line == line), default=0.0)
            if word is not None and literal in speeds and first == line and abs(literal.value) == lowest:
                return f"the comment of line {each} says {word[0].lower()}"
        return ""


def _times(run: Run) -> dict[tuple[str, int], list[tuple[float, float]]]:
    """Return when the waits of each statement and the spans of each output that is on begin and end."""
    found: dict[tuple[str, int], list[tuple[float, float]]] = {}
    for wait in run.machine.log.waits:
        if wait.until < run.time:
            cause = "time" if wait.cause == "time" else "condition"
            found.setdefault((cause, wait.at), []).append((wait.since, wait.until))
    assert run.program is not None
    statements = run.program.structure.statements
    begun: dict[int, tuple[float, str]] = {}
    for each in run.machine.log.outputs:
        if each.value:
            uses = statements[each.at].uses if each.at in statements else ()
            is_pulse = any(use.row is not None and use.row.unit == "ms" for use in uses)
            begun.setdefault(each.channel, (each.time, "pulse" if is_pulse else "output"))
        elif each.channel in begun:
            time, what = begun.pop(each.channel)
            found.setdefault((what, each.channel), []).append((time, each.time))
    return found


def _standstill(run: Run) -> Callable[[float, float], bool]:
    """Return a function that is true if no axis moves between two times."""
    moves = sorted(
        (m.start_time, m.start_time + m.profile.duration) for m in run.machine.log.moves if m.profile
    )
    ends = list(accumulate((end for _, end in moves), max))
    starts = [begin for begin, _ in moves]

    def is_still(begin: float, end: float) -> bool:
        before = bisect_right(starts, end - SHORT)
        return not before or ends[before - 1] < begin + SHORT

    return is_still


def _planned(run: Run) -> dict[int, list[LoggedMove]]:
    """Return the moves of each axis that have a profile."""
    found: dict[int, list[LoggedMove]] = {}
    for move in run.machine.log.moves:
        if move.profile is not None:
            found.setdefault(move.axis, []).append(move)
    return found


def _profile(move: LoggedMove) -> Profile:
    assert move.profile is not None
    return move.profile


def _is_during(move: LoggedMove, begin: float, end: float) -> bool:
    return min(_end(move), end) - max(move.start_time, begin) > SHORT


def _end(move: LoggedMove) -> float:
    return move.start_time + _profile(move).duration


def _goes_elsewhere(move: LoggedMove, other: LoggedMove) -> bool:
    """True if a move has another end, and another distance to it."""
    ends = (
        (each.to_user(_profile(each).end), each.size_to_user(_profile(each).distance))
        for each in (move, other)
    )
    return all(abs(one - two) > SAME_PLACE for one, two in zip(*ends, strict=True))


def _changes(move: LoggedMove, other: LoggedMove, is_whole: bool, jumps: bool) -> Iterator[MoveChange]:
    """Yield the speed of a move if it differs, or its rates, or its jerk if it takes another time.

    Of a homing, and of a move that is cut off, only what was commanded counts. If the acceleration of its axis `jumps`,
    no number sets its jerk: a lower rate of a path may be hidden by the other one, which is higher.
    """
    one, two = _own_speed(move), _own_speed(other)
    if (is_whole or move.commanded_speed is not None) and abs(one - two) > SAME_SHARE * one:
        yield MoveChange(move, SPEED, one, two)
        return
    rates = enumerate(zip(_rates(move), _rates(other), strict=True))
    differ = [(n, a, b) for n, (a, b) in rates if abs(a - b) > SAME_SHARE * a]
    if is_whole or move.rates_in_force is not None:
        yield from (MoveChange(move, ACCELERATION, a, b, n) for n, a, b in differ)
    was, now = _profile(move), _profile(other)
    is_same_way = abs(was.distance - now.distance) <= SAME_SHARE * abs(was.distance)
    is_same_way = is_same_way and is_whole and was.peak_speed > 0.0
    if not differ and is_same_way and abs(was.duration - now.duration) > SAME_SHARE * was.duration:
        first, other_first = was.phases[0].duration, now.phases[0].duration
        rate = int(abs(first - other_first) <= SAME_SHARE * first)
        sign = was.duration - now.duration
        yield MoveChange(move, ACCELERATION if jumps else JERK, 0.0, sign, rate)


def _rates(move: LoggedMove) -> tuple[float, ...]:
    """Return the rates by which a move was planned; the highest acceleration if it has none, in user units."""
    rates = move.rates_in_force
    return tuple(map(move.size_to_user, (_profile(move).peak_acceleration,) if rates is None else rates))


def _own_speed(move: LoggedMove) -> float:
    """Return the commanded speed of a move; the one that it reaches if it is part of a path, in user units."""
    assert move.profile is not None
    speed = move.profile.peak_speed if move.commanded_speed is None else move.commanded_speed
    return move.size_to_user(speed)


def _switched(run: Run, tasks: Tasks, starts: Sequence[float]) -> Iterable[_On]:
    """Yield the outputs that a task switches on and off repeatedly, or once in a run that repeats nothing."""
    assert run.program is not None
    names = {(each.kind, each.number): each.name for each in channels_of(run.program, run.dialect)}
    log = run.machine.log
    changes: dict[tuple[str, int], list[tuple[float, float, int]]] = {}
    kinds = (("output", log.outputs), ("analogue output", log.analogue_outputs))
    for kind, each in chain.from_iterable(((kind, each) for each in stream) for kind, stream in kinds):
        changes.setdefault((kind, each.channel), []).append((each.time, each.value, each.at))
    first, last = (starts[0], starts[-1]) if len(starts) > 1 else (-inf, inf)
    for (kind, channel), switched in sorted(changes.items()):
        ends = [time for time, _, _ in switched[1:]] + [run.time]
        spans: dict[str, list[tuple[float, float]]] = {}
        for (time, value, at), end in zip(switched, ends, strict=True):
            if value:
                task = tasks.at(run.dialect.locate(run.source, at)[0] if at >= 0 else 0)
                spans.setdefault(task, []).append((time, end))
        title = f"{kind} {channel}"
        name = names.get((kind, str(channel)), "")
        for task, on in spans.items():
            # Twice is enough: the coolant of a plate is on for all of its holes, which are the cycle.
            if len(on) >= min(max(len(starts) - 1, 1), 2) and any(not value for _, value, _ in switched[1:]):
                cycles = Counter(bisect_right(starts, begin) for begin, _ in on if first <= begin < last)
                yield _On(f"{name} ({title})" if name else title, task, on, len(set(cycles.values())) == 1)


def _comments(run: Run) -> tuple[Mapping[int, str], Mapping[int, str]]:
    """Return the comments behind statements, and those with a line of their own, by line.

    A list of channels names what is at the machine, and not what a line does.
    """
    lists = {each.line for each in names_in_comments(run.source, run.dialect)}
    alone, behind = comments_of(run.source, run.dialect)
    return (
        {line: text for line, text in behind.items() if line not in lists},
        {line: text for line, text in alone if line not in lists},
    )
